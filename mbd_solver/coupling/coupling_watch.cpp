#include "mbd_solver/coupling/coupling_watch.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

constexpr int kChatterWindows = 16;    // full swings in a row that no impact shows
constexpr double kLargeOverlap = 0.3;  // of the radius: Hertz' law and the volume of the grains hold for small ones
constexpr double kSurplus = 0.01;      // of the impulse given by the grains
constexpr int kSurplusWindows = 10;    // bodies times windows
constexpr double kWarnGain = 0.2;      // of the gain that ends the run
constexpr double kChatterForceShare = 0.2;  // of the largest force of the run: smaller ones may swing

std::string number(double x) { return number_text(x, 3); }

// What to do against windows that are too long.
std::string smaller_windows(int n) {
  return n > 1 ? "use smaller windows (every " + std::to_string(n / 2) + ")"
               : "use a smaller timestep in the script: windows are single substeps already";
}

}  // namespace

CouplingWatch::CouplingWatch(std::vector<std::string> names, std::vector<double> masses, const CouplingSpec& limits)
    : names_(std::move(names)),
      masses_(std::move(masses)),
      limits_(limits),
      omega_h_(names_.size(), 0.0),
      largest_omega_h_(names_.size(), 0.0),
      warn_omega_h_(names_.size(), limits.warn_omega_h),
      warned_(names_.size(), false),
      surplus_(names_.size(), Eigen::Vector3d::Zero()),
      given_(names_.size(), 0.0),
      force_(names_.size(), Eigen::Vector3d::Zero()),
      change_(names_.size(), Eigen::Vector3d::Zero()),
      alternations_(names_.size(), 0) {}

void CouplingWatch::visit(Archive& archive) {
  archive("sum", sum_);
  archive("residual", residual_);
  archive("largest_residual", largest_residual_);
  archive("warned_of_gain", warned_of_gain_);
  archive("warned_of_overlap", warned_of_overlap_);
  archive("largest_overlap", largest_overlap_);
  archive("largest_force", largest_force_);
  archive("omega_h", omega_h_);
  archive("largest_omega_h", largest_omega_h_);
  archive("warn_omega_h", warn_omega_h_);
  archive("warned", warned_);
  archive("surplus", surplus_);
  archive("given", given_);
  archive("warned_of_surplus", warned_of_surplus_);
  archive("largest_impulse", largest_impulse_);
  archive("surplus_windows", surplus_windows_);
  archive("force", force_);
  archive("change", change_);
  archive("alternations", alternations_);
  archive("warnings", warnings_);
}

void CouplingWatch::window(double time, double H, int n, const Load& load, const std::vector<double>& work_received,
                           double reference_energy, double pending) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const BodyLoad& body = load.bodies[i];
    sum_ += body.mean.work - work_received[i];
    largest_overlap_ = std::max(largest_overlap_, body.max_overlap_over_radius);
    largest_force_ = std::max(largest_force_, body.mean.F_W.norm());
    // A body on contacts of stiffness K: omega = sqrt(K / m).
    omega_h_[i] = std::sqrt(std::max(0.0, body.contact_stiffness) / masses_[i]) * H;
    largest_omega_h_[i] = std::max(largest_omega_h_[i], omega_h_[i]);
    if (!warned_[i] && omega_h_[i] > warn_omega_h_[i]) {
      warned_[i] = true;
      const int safe = std::max(1, static_cast<int>(std::floor(n * warn_omega_h_[i] / omega_h_[i])));
      warnings_.push_back("t = " + number(time) + " s: body " + names_[i] + " has omega H = " + number(omega_h_[i]) +
                          " above " + number(warn_omega_h_[i]) + ": its contacts are stiff for windows of " +
                          std::to_string(n) + " substeps; use `every " + std::to_string(safe) + "` or less");
    }
    watch_chatter(i, body.mean.F_W, time, n);
  }
  watch_overlap(time);
  residual_ = sum_ + pending;
  largest_residual_ = std::max(largest_residual_, std::abs(residual_));
  if (!warned_of_gain_ && -residual_ > kWarnGain * limits_.max_energy_residual * reference_energy) {
    warned_of_gain_ = true;
    warnings_.push_back("t = " + number(time) + " s: the coupling has made " + number(-residual_) + " J, " +
                        number(-residual_ / reference_energy * 100.0) +
                        " % of the reference energy: " + smaller_windows(n));
  }
  // The bodies have received more than the grains have given: energy from nowhere.
  if (limits_.stop_on_energy_gain && -residual_ > limits_.max_energy_residual * reference_energy)
    throw NumericalError("t = " + number(time) + " s: the coupling has pumped " + number(-residual_) +
                         " J into the mechanism, " + number(-residual_ / reference_energy * 100.0) +
                         " % of the reference energy: " + smaller_windows(n) +
                         ", or set coupling.stop_on_energy_gain = false");
}

void CouplingWatch::count_surplus(std::size_t i, double time, const Eigen::Vector3d& surplus, double given) {
  surplus_[i] += surplus;
  given_[i] += given;
  largest_impulse_ = std::max(largest_impulse_, given_[i]);
  // The beginning of a contact is not judged: one window of a landing says nothing about its sum.
  if (warned_of_surplus_ || ++surplus_windows_ < kSurplusWindows || surplus_[i].norm() <= kSurplus * largest_impulse_)
    return;
  warned_of_surplus_ = true;
  warnings_.push_back(
      "t = " + number(time) + " s: scheme tangent has given body " + names_[i] + " an impulse of " +
      number(surplus_[i].norm()) + " N s that the grains did not give, " +
      number(100.0 * surplus_[i].norm() / largest_impulse_) +
      " % of theirs: these grains give way; use coupling.scheme = \"css-trapezoid\" with smaller windows");
}

void CouplingWatch::watch_overlap(double time) {
  if (warned_of_overlap_ || largest_overlap_ < kLargeOverlap) return;
  warned_of_overlap_ = true;
  warnings_.push_back(
      "t = " + number(time) + " s: a grain is pressed in by " + number(100.0 * largest_overlap_) +
      " % of its radius: its contact law holds for small overlaps; use stiffer grains, or slower impacts");
}

void CouplingWatch::watch_chatter(std::size_t i, const Eigen::Vector3d& force, double time, int n) {
  const Eigen::Vector3d change = force - force_[i];
  const double larger = std::max(force.norm(), force_[i].norm());
  const bool swings =
      change.dot(change_[i]) < 0.0 && change.norm() > 0.5 * larger && larger > kChatterForceShare * largest_force_;
  alternations_[i] = swings ? alternations_[i] + 1 : 0;
  change_[i] = change;
  force_[i] = force;
  if (limits_.stop_on_chatter && alternations_[i] >= kChatterWindows)
    throw NumericalError("t = " + number(time) + " s: the mean force on body " + names_[i] +
                         " has swung by more than half of itself in " + std::to_string(kChatterWindows) +
                         " windows in a row: the coupling is unstable; " + smaller_windows(n) +
                         ", or set coupling.stop_on_chatter = false");
}

}  // namespace footfall

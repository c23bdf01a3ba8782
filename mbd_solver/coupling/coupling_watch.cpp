#include "mbd_solver/coupling/coupling_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

constexpr int kChatterWindows = 16;     // full swings in a row that no impact shows
constexpr double kLargeOverlap = 0.05;  // of the radius: Hertz' law and the volume of the grains hold for small ones
constexpr double kInside = 0.3;         // of the radius, in the first window: no impact presses so far at once
constexpr const char* kSoftGrains =
    " % of its radius: its contact law holds for small overlaps, and soft grains soften the impact (ten times stiffer "
    "ones "
    "doubled the peak force on a dropped sphere, docs/dropped_sphere.md); raise their modulus, and lower the time step "
    "by "
    "its root";
constexpr double kSurplus = 0.01;    // of the impulse given by the grains
constexpr int kSurplusWindows = 10;  // bodies times windows
constexpr double kUnresolved = 0.1;  // of the impulse on a body
constexpr double kWindowsPerTouch = 10.0;
constexpr double kFloor = 1e-3;             // of what a window's impulse can do
constexpr double kWarnGain = 0.2;           // of the gain that ends the run
constexpr double kChatterForceShare = 0.2;  // of the largest force of the run: smaller ones may swing

std::string number(double x) { return number_text(x, 3); }

// What to do against windows that are too long.
std::string smaller_windows(int n) {
  return n > 1 ? "use smaller windows (every " + std::to_string(n / 2) + ")"
               : "use a smaller timestep in the script: windows are single substeps already";
}

}  // namespace

CouplingWatch::CouplingWatch(std::vector<std::string> names, const CouplingSpec& limits)
    : names_(std::move(names)),
      limits_(limits),
      work_(names_.size()),
      omega_h_(names_.size(), 0.0),
      largest_omega_h_(names_.size(), 0.0),
      warn_omega_h_(names_.size(), limits.warn_omega_h),
      warned_(names_.size(), false),
      touch_(names_.size()),
      touches_(names_.size(), false),
      impulse_(names_.size(), 0.0),
      unresolved_(names_.size(), 0.0),
      shortest_(names_.size(), std::numeric_limits<double>::infinity()),
      surplus_(names_.size(), Eigen::Vector3d::Zero()),
      given_(names_.size(), 0.0),
      force_(names_.size(), Eigen::Vector3d::Zero()),
      change_(names_.size(), Eigen::Vector3d::Zero()),
      alternations_(names_.size(), 0) {}

void CouplingWatch::visit(Archive& archive) {
  archive("sum", sum_);
  archive("residual", residual_);
  archive("largest_residual", largest_residual_);
  archive("work", work_);
  archive("largest_kick", largest_kick_);
  archive("warned_of_gain", warned_of_gain_);
  archive("warned_of_loss", warned_of_loss_);
  archive("began", began_);
  archive("warned_of_overlap", warned_of_overlap_);
  archive("warned_of_facets", warned_of_facets_);
  archive("largest_overlap", largest_overlap_);
  archive("largest_patch", largest_patch_);
  archive("largest_force", largest_force_);
  archive("omega_h", omega_h_);
  archive("largest_omega_h", largest_omega_h_);
  archive("warn_omega_h", warn_omega_h_);
  archive("warned", warned_);
  archive("touch", touch_);
  archive("touches", touches_);
  archive("impulse", impulse_);
  archive("unresolved", unresolved_);
  archive("shortest", shortest_);
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

void CouplingWatch::window(const Window& window, const Load& load, const std::vector<Body>& bodies) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const BodyLoad& body = load.bodies[i];
    largest_overlap_ = std::max(largest_overlap_, body.max_overlap_over_radius);
    largest_patch_ = std::max(largest_patch_, body.max_patch_over_facet);
    largest_force_ = std::max(largest_force_, body.mean.F_W.norm());
    watch_omega_h(i, window, body.contact_stiffness, bodies[i].mass);
    if (std::isinf(bodies[i].mass)) continue;
    watch_chatter(i, body.mean.F_W, window.time, window.n);
    watch_touch(i, window, body);
  }
  watch_grains(window.time);
  watch_energy(window, load, bodies);
}

// A body on contacts of stiffness K: omega = sqrt(K / m).
void CouplingWatch::watch_omega_h(std::size_t i, const Window& window, double stiffness, double mass) {
  omega_h_[i] = std::sqrt(std::max(0.0, stiffness) / mass) * window.H;
  largest_omega_h_[i] = std::max(largest_omega_h_[i], omega_h_[i]);
  if (warned_[i] || omega_h_[i] <= warn_omega_h_[i]) return;
  warned_[i] = true;
  const int safe = std::max(1, static_cast<int>(std::floor(window.n * warn_omega_h_[i] / omega_h_[i])));
  warnings_.push_back("t = " + number(window.time) + " s: body " + names_[i] + " has omega H = " + number(omega_h_[i]) +
                      " above " + number(warn_omega_h_[i]) + ": its contacts are stiff for windows of " +
                      std::to_string(window.n) + " substeps; use `every " + std::to_string(safe) + "` or less");
}

void CouplingWatch::watch_energy(const Window& window, const Load& load, const std::vector<Body>& bodies) {
  double pending = 0.0, surplus = 0.0, moved = 0.0, kick = 0.0;
  residual_ = 0.0;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const MeanLoad& mean = load.bodies[i].mean;
    sum_ += mean.work - bodies[i].work_received;
    residual_ += bodies[i].pending;
    Work& work = work_[i];
    if (!std::isinf(bodies[i].mass)) {
      work.sum += bodies[i].work_received + bodies[i].gravity;
      work.kinetic = std::max(work.kinetic, bodies[i].kinetic);
      work.largest = std::max(work.largest, work.sum);
      work.smallest = std::min(work.smallest, work.sum);
      work.surplus += mean.work - bodies[i].work_received;
      pending += bodies[i].pending;
      const double J = mean.F_W.norm() * window.H;
      kick += J * J / (2.0 * bodies[i].mass);
    }
    surplus += work.surplus;
    moved += std::max(work.largest - work.smallest, work.kinetic);
  }
  residual_ += sum_;
  largest_residual_ = std::max(largest_residual_, std::abs(residual_));
  largest_kick_ = std::max(largest_kick_, kick);
  const double scale = moved + kFloor * largest_kick_;
  const double gain = -(surplus + pending);
  const auto percent = [&](double energy) {
    return number(energy) + " J, " + number(energy / scale * 100.0) + " % of the energy that the contacts have moved";
  };
  const std::string at = "t = " + number(window.time) + " s: ";
  if (!warned_of_gain_ && gain > kWarnGain * limits_.max_energy_residual * scale) {
    warned_of_gain_ = true;
    warnings_.push_back(at + "the coupling has made " + percent(gain) + ": " + smaller_windows(window.n));
  }
  if (!warned_of_loss_ && -gain > limits_.max_energy_residual * scale) {
    warned_of_loss_ = true;
    warnings_.push_back(at + "the coupling has lost " + percent(-gain) + ": " + smaller_windows(window.n));
  }
  if (!limits_.stop_on_energy_gain) return;
  const std::string advice = smaller_windows(window.n) + ", or set coupling.stop_on_energy_gain = false";
  // The bodies have received more than the grains have given: energy from nowhere.
  if (gain > limits_.max_energy_residual * scale)
    throw NumericalError(at + "the coupling has pumped " + percent(gain) + " into the mechanism: " + advice);
  // At the end nobody gives what is pending. A window of omega H that ends in full contact leaves (omega H)^2 of it.
  const double allowed = limits_.max_energy_residual + limits_.warn_omega_h * limits_.warn_omega_h;
  if (window.last && -surplus > allowed * scale)
    throw NumericalError(at + "in the last window the mechanism has received " + percent(-surplus) +
                         ", that the grains never gave: " + advice);
}

// A touch that begins and ends within a window gives a mean force of the right impulse, at no place that the body has
// been to: the grains saw a body that did not give way.
void CouplingWatch::watch_touch(std::size_t i, const Window& window, const BodyLoad& load) {
  Touch& touch = touch_[i];
  const double impulse = load.mean.F_W.norm() * window.H;
  impulse_[i] += impulse;
  touch.contact_time += load.mean_contacts * window.H;
  touch.most_contacts = std::max(touch.most_contacts, static_cast<double>(load.contacts));
  touch.longest_H = std::max(touch.longest_H, window.H);
  touch.impulse += impulse;
  const double duration = touch.contact_time / touch.most_contacts;
  if (load.contacts == 0) {
    if (duration > 0.0 && (duration < touch.longest_H || !touches_[i])) {
      unresolved_[i] += touch.impulse;
      shortest_[i] = std::min({shortest_[i], duration, touch.longest_H});
    }
    touch = {};
  }
  touches_[i] = load.contacts > 0;
  if (!window.last || unresolved_[i] <= kUnresolved * impulse_[i]) return;
  const int safe = std::max(1, static_cast<int>(shortest_[i] / kWindowsPerTouch * window.n / window.H));
  warnings_.push_back("body " + names_[i] + ": " + number(100.0 * unresolved_[i] / impulse_[i]) +
                      " % of its impulse came from contacts that began and ended within a window (the shortest took " +
                      number(shortest_[i]) + " s): its rebound is not resolved; use `every " + std::to_string(safe) +
                      "` or less");
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

void CouplingWatch::watch_grains(double time) {
  const bool first_window = !began_;
  began_ = true;
  const std::string at = "t = " + number(time) + " s: ";
  if (!warned_of_overlap_ && largest_overlap_ > kLargeOverlap) {
    warned_of_overlap_ = true;
    warnings_.push_back(at + "a grain is pressed in by " + number(100.0 * largest_overlap_) +
                        (first_window && largest_overlap_ > kInside
                             ? " % of its radius in the first window: a body starts inside the bed; start it higher "
                               "(initial.clearance, positions of bodies, [initial.joints])"
                             : kSoftGrains));
  }
  if (!warned_of_facets_ && largest_patch_ > 1.0) {
    warned_of_facets_ = true;
    warnings_.push_back(
        at + "a grain's contact patch has a radius of " + number(largest_patch_) +
        " times the width of the facet that it presses on, and the script asks for `surface facets`: they "
        "add up. The force is about " +
        number(0.9 + 0.4 * largest_patch_) +
        " times that of one contact where the surface is curved "
        "one way, " +
        number(1.4 + largest_patch_ * largest_patch_ / 3.0) +
        " times where it is curved both ways; leave out `surface facets`");
  }
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

// Every window adds to the records of the bodies and of the interface; each kind of trouble is reported once, with what
// to change. Ends the run where the coupling creates energy or chatters, unless the scene allows it.

#include "mbd_solver/coupling/coupling_watch.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/coupling/codes.h"

namespace footfall {
namespace {

constexpr int kChatterWindows = 16;     // alternations in a row that no impact shows
constexpr double kLargeOverlap = 0.05;  // of the radius: Hertz' law and the volume of the grains hold for small ones
constexpr double kInside = 0.3;         // of the radius, in the first window: no impact reaches this overlap at once
constexpr double kSurplus = 0.01;       // of the impulse given by the grains
constexpr int kSurplusWindows = 10;     // bodies times windows
constexpr double kUnresolved = 0.1;     // of the impulse on a body
constexpr double kWindowsPerTouch = 10.0;
constexpr double kFloor = 1e-3;           // of the energy that a window's impulse can give
constexpr double kDamped = 1.8;           // 2 zeta of a restitution of 0.2, over 0.5
constexpr double kUsualDensity = 2500.0;  // of a grain whose mass alone is known [kg/m3]
constexpr double kMuchLarger = 1.25;      // than what has been reported
constexpr double kForceError = 0.05;      // of the largest force on a body
// Of the DEM steps with kOfPeak of a peak: a window that shows it. Of a parabola with w such steps a mean over w / 2 leaves out
// at most 3.3 %, wherever the window ends.
constexpr double kOfPeakSteps = 0.5;
constexpr double kOfPeaks = 0.2;            // of the window that hides a peak, by its neighbours: shows it
constexpr double kForceThatMatters = 0.1;   // of the largest force on any body
constexpr double kEventShare = 0.05;        // of the largest velocity: 1 % of peaks
constexpr double kWarnGain = 0.2;           // of the gain that ends the run
constexpr double kChatterForceShare = 0.2;  // of the largest force of the run: smaller ones may alternate

std::string number(double x) { return number_text(x, 3); }
std::string percent(double x) { return number(100.0 * x) + " %"; }
std::string at(double time) { return "t = " + number(time) + " s: "; }

std::string steps(int n) { return std::to_string(n) + (n == 1 ? " DEM step" : " DEM steps"); }

}  // namespace

CouplingWatch::CouplingWatch(const std::vector<std::string>& names, const CouplingSpec& limits, const Scheme& scheme,
                             Setting setting)
    : limits_(limits), omega_h_limit_(scheme, limits.warn_omega_h), setting_(setting), records_(names.size()) {
  for (std::size_t i = 0; i < names.size(); ++i) records_[i].name = names[i];
}

std::string CouplingWatch::window_text(int n) const {
  const std::string number = std::to_string(n);
  switch (setting_) {
    case Setting::kScript: return "`every " + number + "`";
    case Setting::kBox: return "particles.box.exchange_steps = " + number;
    case Setting::kScriptAuto:
    case Setting::kBoxAuto: return "coupling.max_substeps = " + number;
  }
  return {};
}

std::string CouplingWatch::shorter(double share, const Window& window) {
  const bool box = of_box();
  const double n = share * n_longest_;
  if (n_longest_ > 1) {
    advised_ = std::min(advised_, std::max(1, static_cast<int>(n)));
    const std::string text = "use " + window_text(advised_);
    if (n >= 1.0) return advised_ > 1 ? text + " or less" : text;
    return text + (box ? ", and a smaller particles.box.time_step" : ", and a smaller timestep in the script");
  }
  return std::string(box ? "use a smaller particles.box.time_step" : "use a smaller timestep in the script") + " (" +
         number_text(share * window.H / window.n, 2) +
         " s or less): the coupling interval is a single DEM step already";
}

void CouplingWatch::Touch::visit(Archive& archive) {
  archive("contact_time", contact_time);
  archive("most_contacts", most_contacts);
  archive("longest_H", longest_H);
  archive("impulse", impulse);
}

void CouplingWatch::Work::visit(Archive& archive) {
  archive("sum", sum);
  archive("largest", largest);
  archive("smallest", smallest);
  archive("kinetic", kinetic);
  archive("surplus", surplus);
  archive("grain", grain);
}

void CouplingWatch::Peak::visit(Archive& archive) {
  archive("force", force);
  archive("time", time);
  archive("steps", steps);
  archive("n", n);
}

void CouplingWatch::Record::visit(Archive& archive) {
  archive("omega_h", omega_h);
  archive("largest_omega_h", largest_omega_h);
  archive("most_excess", most_excess);
  archive("worst_omega_h", worst_omega_h);
  archive("worst_n", worst_n);
  archive("worst_damping", worst_damping);
  archive("warned_of_omega_h", warned_of_omega_h);
  archive("work", work);
  archive("touch", touch);
  archive("touches", touches);
  archive("impulse", impulse);
  archive("unresolved", unresolved);
  archive("shortest", shortest);
  archive("surplus", surplus);
  archive("given", given);
  archive("force", force);
  archive("change", change);
  archive("sizes", sizes);
  archive("largest_force", largest_force);
  archive("peak", peak);
  archive("inner_peak", inner_peak);
  archive("smoothed", smoothed);
  archive("smoothed_n", smoothed_n);
  archive("error", error);
  archive("error_before", error_before);
  archive("error_n", error_n);
  archive("alternations", alternations);
}

void CouplingWatch::visit(Archive& archive) {
  archive("bodies", records_);
  archive("sum", sum_);
  archive("residual", residual_);
  archive("largest_residual", largest_residual_);
  archive("largest_kick", largest_kick_);
  archive("began", began_);
  archive("warned_of_gain", warned_of_gain_);
  archive("warned_of_loss", warned_of_loss_);
  archive("warned_of_overlap", warned_of_overlap_);
  archive("warned_of_facets", warned_of_facets_);
  archive("warned_of_surplus", warned_of_surplus_);
  archive("warned_of_event", warned_of_event_);
  archive("gain_before", gain_before_);
  archive("deepest_time", deepest_time_);
  archive("told_overlap", told_overlap_);
  archive("deepest", deepest_);
  archive("n_before", n_before_);
  archive("n_longest", n_longest_);
  archive("lengths", lengths_);
  archive("advised", advised_);
  archive("largest_overlap", largest_overlap_);
  archive("largest_patch", largest_patch_);
  archive("largest_force", largest_force_);
  archive("largest_impulse", largest_impulse_);
  archive("surplus_windows", surplus_windows_);
  archive("warnings", warnings_);
}

std::vector<double> CouplingWatch::omega_h() const {
  std::vector<double> values;
  for (const Record& record : records_) values.push_back(record.omega_h);
  return values;
}

CouplingWatch::Peak CouplingWatch::peak() const {
  Peak most;
  for (const Record& record : records_)
    if (record.peak.force > most.force) most = record.peak;
  return most;
}

void CouplingWatch::observe(const Window& window, const Load& load, const std::vector<Body>& bodies) {
  n_longest_ = std::max(window.n, n_before_);
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const BodyLoad& body = load.bodies[i];
    records_[i].largest_force = std::max(records_[i].largest_force, body.mean.F_W.norm());
    largest_force_ = std::max(largest_force_, records_[i].largest_force);
    watch_omega_h(records_[i], window, body, bodies[i].mass);
    watch_chatter(records_[i], body.mean.F_W, window, !std::isinf(bodies[i].mass));
    if (!std::isinf(bodies[i].mass)) watch_touch(records_[i], window, body);
  }
  for (std::size_t i = 0; i < records_.size(); ++i) watch_peaks(records_[i], window, load.bodies[i], bodies[i]);
  watch_grains(window, load, bodies);
  watch_energy(window, load, bodies);
  n_before_ = window.n;
  lengths_ = Eigen::Vector3d(window.H, lengths_[0], lengths_[1]);
}

// A body on contacts of stiffness K: omega = sqrt(K / m). Reported when it first exceeds its limit, and at the end if it
// became much larger. The damping of N contacts follows the masses m_g of the grains and acts on the body, which may be
// lighter; at a restitution of 0.2 (zeta = 0.45) c H / m is 0.9 sqrt(N m_g / m) omega H, and a mean misses half of that of the
// force that decays. Advice keeps omega H below the limit, and c H / m below half of it.
void CouplingWatch::watch_omega_h(Record& record, const Window& window, const BodyLoad& load, double mass) {
  record.omega_h = std::sqrt(std::max(0.0, load.contact_stiffness) / mass) * window.H;
  const double excess = record.omega_h / omega_h_limit_.at(window.n);
  record.largest_omega_h = std::max(record.largest_omega_h, record.omega_h);
  const bool much_larger = record.warned_of_omega_h && window.last && record.most_excess > kMuchLarger;
  if (excess > record.most_excess) {
    record.most_excess = excess;
    record.worst_omega_h = record.omega_h;
    record.worst_n = window.n;
    const double contacts = std::max(static_cast<double>(load.contacts), load.mean_contacts);
    record.worst_damping = std::min(1.0, 1.0 / (kDamped * std::sqrt(contacts * load.grain_mass / mass)));
  }
  if (!much_larger && (record.warned_of_omega_h || excess <= 1.0)) return;
  record.warned_of_omega_h = true;
  warn(with_code(code::kIntervalTooLong, (much_larger ? "t = 0 to " + number(window.time) + " s: " : at(window.time)) +
                                             "body " + record.name + " has omega H = " + number(record.worst_omega_h) +
                                             (much_larger ? " at most" : "") + ", above " +
                                             number(omega_h_limit_.at(record.worst_n)) + ": a coupling interval of " +
                                             steps(record.worst_n) + " is too long for this contact stiffness; " +
                                             shorter(record.worst_damping / record.most_excess, window)));
}

void CouplingWatch::watch_energy(const Window& window, const Load& load, const std::vector<Body>& bodies) {
  double pending = 0.0, surplus = 0.0, moved = 0.0, kick = 0.0;
  residual_ = 0.0;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const MeanLoad& mean = load.bodies[i].mean;
    sum_ += mean.work - bodies[i].work_received;
    residual_ += bodies[i].pending;
    Work& work = records_[i].work;
    if (!std::isinf(bodies[i].mass)) {
      const BodyLoad& grains = load.bodies[i];
      work.grain = std::max(work.grain, grains.grain_energy * bodies[i].mass / (bodies[i].mass + grains.grain_mass));
      work.sum += bodies[i].work_received + bodies[i].gravity;
      work.kinetic = std::max(work.kinetic, bodies[i].kinetic);
      work.largest = std::max(work.largest, work.sum);
      work.smallest = std::min(work.smallest, work.sum);
      work.surplus += mean.work - bodies[i].work_received;
      pending += bodies[i].pending + bodies[i].pending_modes;
      const double J = mean.F_W.norm() * window.H;
      kick += J * J / (2.0 * bodies[i].mass);
    }
    surplus += work.surplus;
    moved += std::max(work.largest - work.smallest, work.kinetic) + work.grain;
  }
  residual_ += sum_;
  largest_residual_ = std::max(largest_residual_, std::abs(residual_));
  largest_kick_ = std::max(largest_kick_, kick);
  const double scale = moved + kFloor * largest_kick_;
  const double now = -(surplus + pending);
  // What stands for two windows: of both the value nearer to zero.
  const double gain = now * gain_before_ <= 0.0 ? 0.0 : std::abs(now) < std::abs(gain_before_) ? now : gain_before_;
  gain_before_ = now;
  // Errors of energy are of second order or more in H; the advice aims at half of what is warned of.
  const double share = std::clamp(
      std::sqrt(0.5 * kWarnGain * limits_.max_energy_residual * scale / std::max(std::abs(gain), 1e-300)), 0.1, 0.5);
  const auto energy = [&](double E) {
    return number(E) + " J of spurious energy, " + percent(E / scale) + " of the energy exchanged in contacts";
  };
  if (!warned_of_gain_ && gain > kWarnGain * limits_.max_energy_residual * scale) {
    warned_of_gain_ = true;
    warn(with_code(code::kCouplingCreates,
                   at(window.time) + "the coupling added " + energy(gain) + ": " + shorter(share, window)));
  }
  if (!warned_of_loss_ && -gain > limits_.max_energy_residual * scale) {
    warned_of_loss_ = true;
    warn(with_code(code::kCouplingDissipates, at(window.time) + "the coupling dissipated " + number(-gain) + " J, " +
                                                  percent(-gain / scale) +
                                                  " of the energy exchanged in contacts: " + shorter(share, window)));
  }
  if (!limits_.stop_on_energy_gain) return;
  const auto advice = [&] { return shorter(share, window) + ", or set coupling.stop_on_energy_gain = false"; };
  // The bodies have received more than the grains have given: spurious energy.
  if (gain > limits_.max_energy_residual * scale)
    throw NumericalError(code::kEnergyCreated, at(window.time) + "the coupling added " + energy(gain) + " (limit " +
                                                   percent(limits_.max_energy_residual) + "): " + advice());
  // After the last window pending work is never done. A window of omega H that ends in full contact leaves (omega H)^2
  // of it.
  const double allowed = limits_.max_energy_residual + limits_.warn_omega_h * limits_.warn_omega_h;
  if (window.last && -surplus > allowed * scale)
    throw NumericalError(code::kEnergyUnbalanced,
                         at(window.time) + "in the last coupling interval the mechanism received " + energy(-surplus) +
                             ", work that the grains have not done: " + advice());
}

// A touch that begins and ends within a window gives a mean force of the right impulse, but the grains met a body that
// did not react to it.
void CouplingWatch::watch_touch(Record& record, const Window& window, const BodyLoad& load) {
  Touch& touch = record.touch;
  const double impulse = load.mean.F_W.norm() * window.H;
  record.impulse += impulse;
  touch.contact_time += load.mean_contacts * window.H;
  touch.most_contacts = std::max(touch.most_contacts, static_cast<double>(load.contacts));
  touch.longest_H = std::max(touch.longest_H, window.H);
  touch.impulse += impulse;
  const double duration = touch.contact_time / touch.most_contacts;
  if (load.contacts == 0) {
    if (duration > 0.0 && (duration < touch.longest_H || !record.touches)) {
      record.unresolved += touch.impulse;
      record.shortest = std::min({record.shortest, duration, touch.longest_H});
    }
    touch = {};
  }
  record.touches = load.contacts > 0;
  if (!window.last || record.unresolved <= kUnresolved * record.impulse) return;
  warn(with_code(code::kContactNotResolved,
                 "body " + record.name + ": " + percent(record.unresolved / record.impulse) +
                     " of its contact impulse came from contacts that began and ended within one coupling interval "
                     "(the shortest lasted " +
                     number(record.shortest) + " s): its rebound is not resolved; " +
                     shorter(record.shortest / (kWindowsPerTouch * window.H) * window.n / n_longest_, window)));
}

void CouplingWatch::add_surplus_impulse(std::size_t i, double time, const Eigen::Vector3d& surplus, double given) {
  Record& record = records_[i];
  record.surplus += surplus;
  record.given += given;
  largest_impulse_ = std::max(largest_impulse_, record.given);
  // The beginning of a contact is not judged: one window of a landing says nothing about its sum.
  if (warned_of_surplus_ || ++surplus_windows_ < kSurplusWindows ||
      record.surplus.norm() <= kSurplus * largest_impulse_)
    return;
  warned_of_surplus_ = true;
  warn(with_code(code::kTangentImpulse,
                 at(time) + "scheme tangent gave body " + record.name + " an impulse of " +
                     number(record.surplus.norm()) + " N s beyond that of the grains, " +
                     percent(record.surplus.norm() / largest_impulse_) +
                     " of theirs: these grains yield; use coupling.scheme = \"css-trapezoid\" with a shorter coupling "
                     "interval"));
}

void CouplingWatch::tell_of_event(const std::string& event, const Window& window, double share, bool late) {
  // Longer windows are never advised: there the event may not be foreseen.
  if (share > 0.0)
    advised_ = std::min(advised_, std::max(1, static_cast<int>(std::min(1e6, kEventShare / share * window.n))));
  if (!late || warned_of_event_ || window.n <= 1 || share <= kEventShare) return;
  warned_of_event_ = true;
  n_longest_ = std::max(window.n, n_before_);
  warn(with_code(
      code::kEventLate,
      at(window.time) + "event \"" + event + "\" was triggered by loads of the grains, which are known as means over " +
          steps(window.n) + ": it acts up to " + number(window.H) + " s late, which changes velocities by up to " +
          percent(share) + " of the largest; " + shorter(kEventShare / share * window.n / n_longest_, window)));
}

// The first overlap above the limit, and at the end the largest, where it is much larger.
void CouplingWatch::watch_grains(const Window& window, const Load& load, const std::vector<Body>& bodies) {
  const bool first_window = !began_;
  began_ = true;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    largest_patch_ = std::max(largest_patch_, load.bodies[i].max_patch_over_facet);
    if (load.bodies[i].max_overlap_over_radius <= largest_overlap_) continue;
    largest_overlap_ = load.bodies[i].max_overlap_over_radius;
    deepest_time_ = window.time;
    deepest_ = static_cast<int>(i);
  }
  const bool larger = warned_of_overlap_ && window.last && largest_overlap_ > kMuchLarger * told_overlap_;
  if (larger || (!warned_of_overlap_ && largest_overlap_ > kLargeOverlap)) {
    warned_of_overlap_ = true;
    told_overlap_ = largest_overlap_;
    const std::string overlap = at(deepest_time_) + (larger ? "largest grain overlap of the run " : "grain overlap ") +
                                percent(largest_overlap_) + " of radius, on body " + records_[deepest_].name;
    // A fast body may have come so far within the window.
    const std::size_t deepest = static_cast<std::size_t>(deepest_);
    const double radius = std::cbrt(0.75 * load.bodies[deepest].grain_mass / (kPi * kUsualDensity));  // [m]
    const bool comes = bodies[deepest].speed * window.H > 0.5 * largest_overlap_ * radius && radius > 0.0;
    if (first_window && largest_overlap_ > kInside && !comes) {
      warn(with_code(code::kStartsInBed, overlap +
                                             ", in the first coupling interval: a body overlaps the bed at the start; "
                                             "raise it (initial.clearance, positions of bodies, [initial.joints])"));
    } else {
      warn(with_code(
          code::kLargeOverlap,
          overlap + " (limit " + percent(kLargeOverlap) +
              "): the grains are too soft, so the first peak is underestimated; increase " +
              (of_box() ? "particles.box.material.young by a factor f (10 is usual); the time step follows, "
                          "unless particles.box.time_step is given"
                        : "Young's modulus by a factor f (10 is usual) and reduce the time step by sqrt(f)")));
    }
  }
  if (!warned_of_facets_ && largest_patch_ > 1.0) {
    warned_of_facets_ = true;
    warn(with_code(code::kFacetsTooSmall,
                   at(window.time) + "the contact patch of a grain has " + number(largest_patch_) +
                       " times the width of its facet, and with `surface facets` its contacts with several facets add "
                       "up: the force is about " +
                       number(0.9 + 0.4 * largest_patch_) +
                       " times that of one contact where the surface is curved in one direction, " +
                       number(1.4 + largest_patch_ * largest_patch_ / 3.0) +
                       " times where it is curved in both; remove `surface facets` from the script"));
  }
}

// What means over windows leave out of a peak of the force: of a parabola of curvature c, whose slope is s in the middle of
// the window of the largest mean,
//   c H^2 / 24 + s^2 / 2c,   |s| <= c H / 2
// c is the smaller one of two estimates that overlap, so that a jump to a plateau is no peak: of the falls to both sides of
// one window, or of the bends at two neighbours. sizes: of the last three windows, newest first; then one of `size`, H long.
double CouplingWatch::left_out_of_peak(const Eigen::Vector3d& sizes, double size, double H) const {
  const Eigen::Vector3d before = (lengths_.array() > 0.0).select(lengths_, H);
  const double fall = (sizes[0] - size) / (0.5 * (H + before[0]));               // [N/s]
  const double rise = (sizes[0] - sizes[1]) / (0.5 * (before[0] + before[1]));   // before the newest of the three
  const double start = (sizes[1] - sizes[2]) / (0.5 * (before[1] + before[2]));  // before the middle one
  if (!(lengths_[0] > 0.0 && fall > 0.0)) return 0.0;
  const double one = 2.0 * std::min(rise, fall) / before[0];  // curvature [N/s2]
  double most = rise > 0.0 ? one * before[0] * before[0] / 24.0 : 0.0;
  const double between = 0.5 * (before[0] + before[1]);
  const double c = std::min((fall + rise) / (0.5 * (0.5 * (H + before[0]) + between)),
                            (start - rise) / (0.5 * (between + 0.5 * (before[1] + before[2]))));
  if (c > 0.0 && start > 0.0) {
    const bool newer = rise > 0.0;
    const double length = newer ? before[0] : before[1];
    const double s = std::abs(rise + (newer ? -0.5 : 0.5) * c * between);
    most = std::max(most, c * length * length / 24.0 + std::min(s * s / (2.0 * c), c * length * length / 8.0));
  }
  return most;
}

// free: nothing holds the body, so that its contacts can chatter.
void CouplingWatch::watch_chatter(Record& record, const Eigen::Vector3d& force, const Window& window, bool free) {
  const Eigen::Vector3d change = force - record.force;
  const double larger = std::max(force.norm(), record.force.norm());
  const bool alternates = free && change.dot(record.change) < 0.0 && change.norm() > 0.5 * larger &&
                          larger > kChatterForceShare * largest_force_;
  const double left_out = left_out_of_peak(record.sizes, force.norm(), window.H);
  if (left_out > record.smoothed) {
    record.smoothed = left_out;
    record.smoothed_n = n_before_;
  }
  record.sizes = Eigen::Vector3d(force.norm(), record.sizes[0], record.sizes[1]);
  record.alternations = alternates ? record.alternations + 1 : 0;
  record.change = change;
  record.force = force;
  if (limits_.stop_on_chatter && record.alternations >= kChatterWindows)
    throw NumericalError(code::kChatter, at(window.time) + "the mean force on body " + record.name +
                                             " alternated by more than half of its magnitude in " +
                                             std::to_string(kChatterWindows) +
                                             " coupling intervals in a row: the coupling is unstable; " +
                                             shorter(0.5, window) + ", or set coupling.stop_on_chatter = false");
}

// At the end, when the largest force is known: the share of it that means leave out, or that predictions miss. The path of a body
// that is led is known, and so are its forces; on the predicted path of another they leave their mean towards the ends of a window,
// where only its neighbours tell of a peak.
void CouplingWatch::watch_peaks(Record& record, const Window& window, const BodyLoad& load, const Body& body) {
  const bool led = std::isinf(body.mass);
  const double H_after = window.H * (1.0 - static_cast<double>(load.peak.step) / window.n);
  const Peak peak = {load.peak.force, window.time - H_after, static_cast<int>(load.peak.steps), window.n};
  const bool inner = load.peak.step > 1 && load.peak.step < window.n;
  if (peak.force > record.peak.force) record.peak = peak;
  if ((led || inner) && peak.force > record.inner_peak.force) record.inner_peak = peak;
  const double error = std::min(body.force_error, record.error_before);  // that stands for two windows
  record.error_before = body.force_error;
  if (error > record.error) {
    record.error = error;
    record.error_n = n_longest_;
  }
  if (!window.last || record.largest_force <= kForceThatMatters * largest_force_) return;
  const double missed = record.error / record.largest_force,
               shown = record.inner_peak.force / record.largest_force - 1.0,
               smoothed = led ? 0.0 : record.smoothed / record.largest_force;
  const double largest = std::max({missed, shown, smoothed});
  if (largest <= kForceError) return;
  const int n = largest == shown ? record.inner_peak.n : largest == smoothed ? record.smoothed_n : record.error_n;
  if (n == 1) return;  // the time step of the grains decides
  const std::string name = "body " + record.name + ": its contact force ";
  const auto use = [&](double dem_steps) { return shorter(dem_steps / n_longest_, window); };
  if (largest == shown) {
    warn(with_code(
        code::kForceNotResolved,
        name + "was " + number(record.inner_peak.force) + " N in a DEM step at t = " + number(record.inner_peak.time) +
            " s, " + percent(shown) + " above the largest mean over a coupling interval, " +
            number(record.largest_force) + " N, and only means are recorded: within an interval of " + steps(n) +
            " the force rises and falls; " + use(std::max(1.0, std::floor(kOfPeakSteps * record.inner_peak.steps)))));
    return;
  }
  // A peak shorter than a window is estimated too low.
  const bool by_means = largest == smoothed;
  warn(with_code(code::kForceNotResolved,
                 name + "has errors of about " + percent(largest) +
                     " of the largest, because within a coupling interval of " + steps(n) +
                     (by_means ? " the force rises and falls, and only its mean is recorded; "
                               : " the mechanism moves otherwise than predicted (contacts, springs, motors); ") +
                     use((by_means ? kOfPeaks : std::sqrt(0.5 * kForceError / missed)) * n)));
}

}  // namespace footfall

// Every window adds to the records of the bodies and of the interface. Events that end or spoil a run are reported at
// once; findings on the whole run are reported once for all bodies, with a remedy. Ends the run where the coupling
// creates energy or chatters, unless the scene allows it.

#include "mbd_solver/coupling/coupling_watch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <utility>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/coupling/codes.h"
#include "mbd_solver/scene/particle_script.h"

namespace footfall {
namespace {

// A variable of the script with a plain number.
struct ScriptNumber {
  std::string name;  // empty: none
  double value = 0.0;
};

// The number in the first command whose text matches; the pattern's first group is the name.
ScriptNumber number_of(const ScriptText& script, const std::string& pattern) {
  const std::regex line(pattern);
  std::smatch match;
  for (const ScriptCommand& command : script.commands()) {
    if (!std::regex_search(command.text, match, line)) continue;
    const std::string name = match[1];
    if (const std::optional<double> value = as_number(script.value(name))) return {name, *value};
  }
  return {};
}

std::string set(const std::string& key, const std::string& value) { return "--set " + key + "=" + value; }
std::string set(const ScriptNumber& number, double factor) {
  return set("particles.variables." + number.name, number_text(factor * number.value, 2));
}
std::string as_typed(const std::string& words) { return "`" + words + "`"; }

std::string interval_of_script(const ParticlesSpec& particles, int n) {
  const ScriptText script(particles.script, particles.variables);
  const ScriptNumber every = number_of(script, R"(couple/mbd\s.*\bevery\s+\$\{?(\w+))");
  const std::string steps = std::to_string(n);
  return as_typed(every.name.empty() ? "every " + steps : set("particles.variables." + every.name, steps));
}

std::string stiffer_script(const ParticlesSpec& particles, double f) {
  const ScriptText script(particles.script, particles.variables);
  const ScriptNumber modulus = number_of(script, R"(youngsModulus\s+peratomtype\s.*?\$\{?(\w+))"),
                     step = number_of(script, R"(^\s*timestep\s+\$\{?(\w+))");
  const std::string times = number_text(f, 2);
  if (modulus.name.empty() || step.name.empty())
    return "multiply Young's modulus of the grains by " + times + " and divide the time step by " +
           number_text(std::sqrt(f), 2);
  return as_typed(set(modulus, f) + " " + set(step, 1.0 / std::sqrt(f))) + " (Young's modulus times " + times + ")";
}

std::string stiffer_box(const BoxSpec& box, double f) {
  std::string words = set("particles.box.material.young", number_text(f * box.material.young, 2));
  if (box.time_step) words += " " + set("particles.box.time_step", number_text(*box.time_step / std::sqrt(f), 2));
  return as_typed(words) + " (Young's modulus times " + number_text(f, 2) + ")";
}

}  // namespace

// Keys of a box, or variables of the user's script that set the interval, the modulus and the time step.
CouplingAdvice coupling_advice(const Scene& scene, bool chooses_windows) {
  const ParticlesSpec& particles = *scene.particles;
  CouplingAdvice advice;
  if (chooses_windows) {
    advice.interval = [](int n) { return as_typed(set("coupling.max_substeps", std::to_string(n))); };
  } else if (particles.box) {
    advice.interval = [](int n) { return as_typed(set("particles.box.exchange_steps", std::to_string(n))); };
  } else {
    advice.interval = [&particles](int n) { return interval_of_script(particles, n); };
  }
  if (particles.box) {
    advice.shorter_step = "a smaller particles.box.time_step";
    advice.stiffer = [&particles](double f) { return stiffer_box(*particles.box, f); };
  } else {
    advice.shorter_step = "a smaller timestep in the script";
    advice.stiffer = [&particles](double f) { return stiffer_script(particles, f); };
  }
  return advice;
}

namespace {

constexpr int kChatterWindows = 16;     // alternations in a row that no impact shows
constexpr double kLargeOverlap = 0.05;  // of the radius: Hertz' law and the volume of the grains hold for small ones
constexpr double kInside = 0.3;         // of the radius, in the first window: no impact reaches this overlap at once
constexpr double kSurplus = 0.01;       // of the impulse given by the grains
constexpr int kSurplusWindows = 10;     // bodies times windows
constexpr double kUnresolved = 0.1;     // of the impulse on a body
constexpr double kWindowsPerTouch = 10.0;
constexpr double kFloor = 1e-3;           // of the energy that a window's impulse can give
constexpr double kUsualDensity = 2500.0;  // of a grain whose mass alone is known [kg/m3]
constexpr double kFarAbove = 1.5;         // times the limit of omega H: reported whatever the errors are
constexpr double kSeen = 0.01;            // error of energy or force that shows an interval as too long
constexpr double kForceError = 0.05;      // of the largest force on a body
// Share of the DEM steps with kOfPeak of a peak in a window that shows the peak. For a parabola with w such steps a
// mean over w / 2 omits at most 3.3 %, wherever the window ends.
constexpr double kOfPeakSteps = 0.5;
constexpr double kOfPeaks = 0.2;            // of the window that hides a peak, by its neighbours: shows it
constexpr double kForceThatMatters = 0.1;   // of the largest force on any body
constexpr double kEventShare = 0.05;        // of the largest velocity: 1 % of peaks
constexpr double kWarnGain = 0.2;           // of the gain that ends the run
constexpr double kChatterForceShare = 0.2;  // of the largest force of the run: smaller ones may alternate

std::string number(double x) { return number_text(x, 3); }
std::string percent(double x) { return number(100.0 * x) + " %"; }
std::string at(double time) { return "t = " + number(time) + " s: "; }

std::string shortened(std::vector<std::string> names) {
  constexpr std::size_t kMost = 6;
  const std::size_t more = names.size() > kMost ? names.size() - kMost : 0;
  names.resize(names.size() - more);
  return joined(names) + (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

std::string steps(int n) { return std::to_string(n) + (n == 1 ? " DEM step" : " DEM steps"); }

}  // namespace

CouplingWatch::CouplingWatch(const std::vector<std::string>& names, const CouplingSpec& limits, const Scheme& scheme,
                             CouplingAdvice advice)
    : limits_(limits), omega_h_limit_(scheme, limits.warn_omega_h), advice_(std::move(advice)), records_(names.size()) {
  for (std::size_t i = 0; i < names.size(); ++i) records_[i].name = names[i];
}

std::string CouplingWatch::shorter(double n, int& advised) const {
  if (n_longest_ > 1) {
    advised = std::min(advised, std::max(1, static_cast<int>(n)));
    const std::string text = "use " + advice_.interval(advised);
    if (n >= 1.0) return advised > 1 ? text + " or less" : text;
    return text + ", and " + advice_.shorter_step;
  }
  return "use " + advice_.shorter_step + " (" + number_text(n * dt_, 2) +
         " s or less): the coupling interval is a single DEM step already";
}

void CouplingWatch::Touch::visit(Archive& archive) {
  archive.members<&Touch::contact_time, &Touch::most_contacts, &Touch::longest_H, &Touch::impulse>(*this);
}

void CouplingWatch::Work::visit(Archive& archive) {
  archive.members<&Work::sum, &Work::largest, &Work::smallest, &Work::kinetic, &Work::surplus, &Work::grain>(*this);
}

void CouplingWatch::Peak::visit(Archive& archive) {
  archive.members<&Peak::force, &Peak::time, &Peak::steps, &Peak::n>(*this);
}

void CouplingWatch::Record::visit(Archive& archive) {
  archive.members<&Record::omega_h, &Record::largest_omega_h, &Record::most_excess, &Record::worst_omega_h,
                  &Record::worst_n, &Record::led, &Record::work, &Record::touch, &Record::touches, &Record::impulse,
                  &Record::unresolved, &Record::shortest, &Record::surplus, &Record::given, &Record::force,
                  &Record::change, &Record::sizes, &Record::largest_force, &Record::peak, &Record::inner_peak,
                  &Record::smoothed, &Record::smoothed_n, &Record::error, &Record::error_before, &Record::error_n,
                  &Record::alternations>(*this);
}

void CouplingWatch::visit(Archive& archive) {
  archive("bodies", records_);
  archive("sum", energy_.sum);
  archive("residual", energy_.residual);
  archive("largest_residual", energy_.largest_residual);
  archive("largest_kick", energy_.largest_kick);
  archive("began", began_);
  archive("warned_of_gain", warned_of_.gain);
  archive("warned_of_loss", warned_of_.loss);
  archive("warned_of_facets", warned_of_.facets);
  archive("warned_of_surplus", warned_of_.surplus);
  archive("warned_of_event", warned_of_.event);
  archive("gain_before", energy_.gain_before);
  archive("energy_error", energy_.error);
  archive("deepest_time", deepest_.time);
  archive("deepest", deepest_.body);
  archive("starts_in_bed", deepest_.starts_in_bed);
  archive.members<&CouplingWatch::dt_, &CouplingWatch::n_before_, &CouplingWatch::n_longest_, &CouplingWatch::lengths_,
                  &CouplingWatch::advised_>(*this);
  archive("largest_overlap", deepest_.overlap);
  archive("largest_patch", deepest_.patch);
  archive.members<&CouplingWatch::largest_force_, &CouplingWatch::largest_impulse_, &CouplingWatch::surplus_windows_,
                  &CouplingWatch::warnings_>(*this);
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
  dt_ = window.H / window.n;
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

// A body on contacts of stiffness K: omega = sqrt(K / m).
void CouplingWatch::watch_omega_h(Record& record, const Window& window, const BodyLoad& load, double mass) {
  record.omega_h = std::sqrt(std::max(0.0, load.contact_stiffness) / mass) * window.H;
  const double excess = record.omega_h / omega_h_limit_.at(window.n);
  record.largest_omega_h = std::max(record.largest_omega_h, record.omega_h);
  if (excess <= record.most_excess) return;
  record.most_excess = excess;
  record.worst_omega_h = record.omega_h;
  record.worst_n = window.n;
}

void CouplingWatch::watch_energy(const Window& window, const Load& load, const std::vector<Body>& bodies) {
  double pending = 0.0, surplus = 0.0, moved = 0.0, kick = 0.0;
  energy_.residual = 0.0;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const MeanLoad& mean = load.bodies[i].mean;
    energy_.sum += mean.work - bodies[i].work_received;
    energy_.residual += bodies[i].pending;
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
  energy_.residual += energy_.sum;
  energy_.largest_residual = std::max(energy_.largest_residual, std::abs(energy_.residual));
  energy_.largest_kick = std::max(energy_.largest_kick, kick);
  const double scale = moved + kFloor * energy_.largest_kick;
  const double now = -(surplus + pending);
  // The part that persists over two windows: of both the value nearer to zero.
  const double gain = now * energy_.gain_before <= 0.0                ? 0.0
                      : std::abs(now) < std::abs(energy_.gain_before) ? now
                                                                      : energy_.gain_before;
  energy_.gain_before = now;
  if (scale > 0.0) energy_.error = std::max(energy_.error, std::abs(gain) / scale);
  // Errors of energy are of second order or more in H; the advice aims at half of the limit of the warning.
  const double share = std::clamp(
      std::sqrt(0.5 * kWarnGain * limits_.max_energy_residual * scale / std::max(std::abs(gain), 1e-300)), 0.1, 0.5);
  const auto energy = [&](double E) {
    return number(E) + " J of spurious energy, " + percent(E / scale) + " of the energy exchanged in contacts";
  };
  if (!warned_of_.gain && gain > kWarnGain * limits_.max_energy_residual * scale) {
    warned_of_.gain = true;
    warn(with_code(code::kCouplingCreates,
                   at(window.time) + "the coupling added " + energy(gain) + ": " + shorter_than_now(share)));
  }
  if (!warned_of_.loss && -gain > limits_.max_energy_residual * scale) {
    warned_of_.loss = true;
    warn(with_code(code::kCouplingDissipates, at(window.time) + "the coupling dissipated " + number(-gain) + " J, " +
                                                  percent(-gain / scale) +
                                                  " of the energy exchanged in contacts: " + shorter_than_now(share)));
  }
  if (!limits_.stop_on_energy_gain) return;
  const auto advice = [&] { return shorter_than_now(share) + ", or set coupling.stop_on_energy_gain = false"; };
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
}

void CouplingWatch::add_surplus_impulse(std::size_t i, double time, const Eigen::Vector3d& surplus, double given) {
  Record& record = records_[i];
  record.surplus += surplus;
  record.given += given;
  largest_impulse_ = std::max(largest_impulse_, record.given);
  // The beginning of a contact is not judged: one window of a landing does not determine its sum.
  if (warned_of_.surplus || ++surplus_windows_ < kSurplusWindows ||
      record.surplus.norm() <= kSurplus * largest_impulse_)
    return;
  warned_of_.surplus = true;
  warn(with_code(
      code::kTangentImpulse,
      at(time) + "scheme tangent gave body " + record.name + " an impulse of " + number(record.surplus.norm()) +
          " N s in addition to the impulse of the grains, " + percent(record.surplus.norm() / largest_impulse_) +
          " of the latter: these grains yield; use coupling.scheme = \"css-trapezoid\" with a shorter coupling "
          "interval"));
}

void CouplingWatch::tell_of_event(const std::string& event, const Window& window, double share, bool late) {
  // Longer windows are never advised: there the event may not be foreseen.
  if (share > 0.0)
    advised_ = std::min(advised_, std::max(1, static_cast<int>(std::min(1e6, kEventShare / share * window.n))));
  if (!late || warned_of_.event || window.n <= 1 || share <= kEventShare) return;
  warned_of_.event = true;
  n_longest_ = std::max(window.n, n_before_);
  warn(with_code(code::kEventLate, at(window.time) + "event \"" + event +
                                       "\" was triggered by loads of the grains, which are known as means over " +
                                       steps(window.n) + ": it acts up to " + number(window.H) +
                                       " s late, which changes velocities by up to " + percent(share) +
                                       " of the largest; " + shorter(kEventShare / share * window.n, advised_)));
}

void CouplingWatch::watch_grains(const Window& window, const Load& load, const std::vector<Body>& bodies) {
  const bool first_window = !std::exchange(began_, true);
  bed_ = {load.changes, static_cast<double>(load.particles)};
  for (std::size_t i = 0; i < records_.size(); ++i) {
    deepest_.patch = std::max(deepest_.patch, load.bodies[i].max_patch_over_facet);
    if (load.bodies[i].max_overlap_over_radius <= deepest_.overlap) continue;
    deepest_.overlap = load.bodies[i].max_overlap_over_radius;
    deepest_.time = window.time;
    deepest_.body = static_cast<int>(i);
  }
  if (first_window && deepest_.overlap > kInside) {
    // A fast body may have come so far within the window.
    const std::size_t deepest = deepest_.body;
    const double radius = std::cbrt(0.75 * load.bodies[deepest].grain_mass / (kPi * kUsualDensity));  // [m]
    const bool comes = bodies[deepest].speed * window.H > 0.5 * deepest_.overlap * radius && radius > 0.0;
    deepest_.starts_in_bed = !comes;
    if (deepest_.starts_in_bed)
      warn(with_code(code::kStartsInBed, at(deepest_.time) + "grain overlap " + percent(deepest_.overlap) +
                                             " of radius, on body " + records_[deepest].name +
                                             ", in the first coupling interval: a body overlaps the bed at the start; "
                                             "raise it (initial.clearance, positions of bodies, [initial.joints])"));
  }
  if (!warned_of_.facets && deepest_.patch > 1.0) {
    warned_of_.facets = true;
    warn(with_code(code::kFacetsTooSmall,
                   at(window.time) + "the contact patch of a grain has " + number(deepest_.patch) +
                       " times the width of its facet, and with `surface facets` its contacts with several facets add "
                       "up: the force is about " +
                       number(0.9 + 0.4 * deepest_.patch) +
                       " times the force of one contact where the surface is curved in one direction, " +
                       number(1.4 + deepest_.patch * deepest_.patch / 3.0) +
                       " times where it is curved in both; remove `surface facets` from the script"));
  }
}

// The part of a peak of the force that means over windows omit: of a parabola of curvature c, whose slope is s in the
// middle of the window of the largest mean,
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
                                             shorter_than_now(0.5) + ", or set coupling.stop_on_chatter = false");
}

void CouplingWatch::watch_peaks(Record& record, const Window& window, const BodyLoad& load, const Body& body) {
  record.led = std::isinf(body.mass);
  const double H_after = window.H * (1.0 - static_cast<double>(load.peak.step) / window.n);
  const Peak peak = {load.peak.force, window.time - H_after, static_cast<int>(load.peak.steps), window.n};
  const bool inner = load.peak.step > 1 && load.peak.step < window.n;
  if (peak.force > record.peak.force) record.peak = peak;
  if ((record.led || inner) && peak.force > record.inner_peak.force) record.inner_peak = peak;
  const double error = std::min(body.force_error, record.error_before);  // the part that persists over two windows
  record.error_before = body.force_error;
  if (error > record.error) {
    record.error = error;
    record.error_n = n_longest_;
  }
}

// Reported if errors of energy or force confirm it, and far above the limit in any case: a moderate omega H on
// contacts that are damped, as grains are, costs nothing.
std::vector<CouplingWatch::Finding> CouplingWatch::long_intervals() const {
  OmegaHLimit limit = omega_h_limit_;
  std::vector<Finding> findings;
  for (const Record& record : records_) {
    if (record.most_excess <= 1.0) continue;
    const double force_error = largest_force_ > 0.0 ? record.error / largest_force_ : 0.0;
    if (record.most_excess < kFarAbove && std::max(energy_.error, force_error) < kSeen) continue;
    const double omega_dt = record.worst_omega_h / record.worst_n;
    const int n = limit.substeps(omega_dt, record.worst_n);
    const double most = omega_dt > limit.at(1) ? limit.at(1) / omega_dt : n;  // below 1: of a DEM step
    findings.push_back({record.most_excess, record.name,
                        "has omega H = " + number(record.worst_omega_h) + " at most, above " +
                            number(limit.at(record.worst_n)) + ": a coupling interval of " + steps(record.worst_n) +
                            " is too long for this contact stiffness",
                        most});
  }
  return findings;
}

std::vector<CouplingWatch::Finding> CouplingWatch::unresolved_touches() const {
  std::vector<Finding> findings;
  for (const Record& record : records_)
    if (record.unresolved > kUnresolved * record.impulse)
      findings.push_back({record.unresolved / record.impulse, record.name,
                          "had " + percent(record.unresolved / record.impulse) +
                              " of its contact impulse from contacts that began and ended within one coupling interval "
                              "(the shortest lasted " +
                              number(record.shortest) + " s), so its rebound is not resolved",
                          record.shortest / (kWindowsPerTouch * dt_)});
  return findings;
}

// The share of the largest force that means omit, or that predictions miss. The path of a body that is led is known,
// and so are its forces. On the predicted path of another body forces leave their mean towards the ends of a window,
// where only neighbouring windows reveal a peak.
std::vector<CouplingWatch::Finding> CouplingWatch::unresolved_forces() const {
  std::vector<Finding> findings;
  for (const Record& record : records_) {
    if (record.largest_force <= kForceThatMatters * largest_force_) continue;
    const double missed = record.error / record.largest_force,
                 shown = record.inner_peak.force / record.largest_force - 1.0,
                 smoothed = record.led ? 0.0 : record.smoothed / record.largest_force;
    const double largest = std::max({missed, shown, smoothed});
    const bool by_means = largest == smoothed;
    const int n = largest == shown ? record.inner_peak.n : by_means ? record.smoothed_n : record.error_n;
    if (largest <= kForceError || n == 1) continue;  // n = 1: the time step of the grains decides
    if (largest == shown) {
      findings.push_back({largest, record.name,
                          "had a contact force of " + number(record.inner_peak.force) +
                              " N in a DEM step at t = " + number(record.inner_peak.time) + " s, " + percent(shown) +
                              " above the largest mean over a coupling interval, " + number(record.largest_force) +
                              " N, and only means are recorded: within an interval of " + steps(n) +
                              " the force rises and falls",
                          std::max(1.0, std::floor(kOfPeakSteps * record.inner_peak.steps))});
      continue;
    }
    findings.push_back({largest, record.name,
                        "has errors of its contact force of about " + percent(largest) +
                            " of the largest, because within a coupling interval of " + steps(n) +
                            (by_means ? " the force rises and falls, and only its mean is recorded"
                                      : " the mechanism moves otherwise than predicted (contacts, springs, motors)"),
                        (by_means ? kOfPeaks : std::sqrt(0.5 * kForceError / missed)) * n});
  }
  return findings;
}

// By Hertz an impact of given energy overlaps by E^(-2/5).
std::string CouplingWatch::soft_grains() const {
  if (deepest_.starts_in_bed || deepest_.overlap <= kLargeOverlap) return {};
  return at(deepest_.time) + "largest grain overlap " + percent(deepest_.overlap) + " of radius, on body " +
         records_[deepest_.body].name + " (limit " + percent(kLargeOverlap) +
         "): the grains are too soft, so the first peak is underestimated; use " +
         advice_.stiffer(std::pow(deepest_.overlap / kLargeOverlap, 2.5));
}

// Grains removed behind are those that came in front, but for those that bodies push along, throw ahead or leave behind.
std::string CouplingWatch::bed_mass() const {
  constexpr double kGrains = 2.0;  // of mean mass, that may be missing
  const GrainChanges& c = bed_.changes;
  const double more = c.added_mass - c.removed_mass;
  const double grain = c.added > 0.0 ? c.added_mass / c.added : 0.0;
  if (std::abs(more) <= kGrains * grain) return {};
  const double start = bed_.grains - c.added + c.removed;  // grains at the start
  return "the bed that follows a body holds " + number(std::abs(more)) + " kg (" +
         percent(std::abs(more) / (grain * start)) + ") " + (more > 0.0 ? "more" : "less") +
         " than at the start: " + number_text(c.added) + " grains were added in front, " + number_text(c.removed) +
         " removed behind. A body carries the difference along (a heap in front of it), has thrown it to the other "
         "end, or "
         "stood in the way where it would have been removed; judge by a longer bed (particles.box.size) or a slower "
         "body "
         "whether that matters";
}

std::string CouplingWatch::told(std::vector<Finding> findings, int& advised) const {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.degree > b.degree; });
  double least = findings[0].steps;
  std::vector<std::string> others;
  for (std::size_t k = 1; k < findings.size(); ++k) {
    least = std::min(least, findings[k].steps);
    others.push_back(findings[k].body);
  }
  const std::string also = others.empty() ? "" : " (to a lesser degree also " + shortened(others) + ")";
  return "body " + findings[0].body + " " + findings[0].text + also + "; " + shorter(least, advised);
}

std::vector<std::string> CouplingWatch::conclusions() const {
  std::vector<std::string> texts;
  int advised = advised_;
  for (const auto& [code, findings] :
       {std::pair{code::kIntervalTooLong, long_intervals()}, std::pair{code::kContactNotResolved, unresolved_touches()},
        std::pair{code::kForceNotResolved, unresolved_forces()}})
    if (!findings.empty()) texts.push_back(with_code(code, told(findings, advised)));
  if (const std::string text = soft_grains(); !text.empty()) texts.push_back(with_code(code::kLargeOverlap, text));
  if (const std::string text = bed_mass(); !text.empty()) texts.push_back(with_code(code::kBedMass, text));
  return texts;
}

}  // namespace footfall

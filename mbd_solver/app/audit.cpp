// Sums momentum and energy window by window on both sides of the interface, and compares the sums with bounds from
// round-off.
#include "mbd_solver/app/audit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/check_command.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/particle_script.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {
namespace {

constexpr const char* kExpected = "a table of a run with --audit";

Eigen::Vector3d vector(const CsvReader& csv, std::size_t at) {
  return {csv.number(at), csv.number(at + 1), csv.number(at + 2)};
}

}  // namespace

const AuditSource& AuditWindow::find(const std::string& kind, const std::string& name) const {
  for (const AuditSource& source : sources)
    if (source.kind == kind && source.name == name) return source;
  throw InputError(code::kAuditDamaged,
                   "the audit has no " + kind + " of \"" + name + "\" in window " + std::to_string(number));
}

GrainsAudit read_grains_audit(const std::string& path) {
  constexpr std::size_t kColumns = 11;
  GrainsAudit audit;
  CsvReader csv(path, kExpected);
  csv.next();  // names
  while (csv.next()) {
    csv.require_width(kColumns);
    const long window = std::lround(csv.number(0));
    const AuditSource one{csv.text(1), csv.text(2), vector(csv, 3), vector(csv, 6), csv.number(9), csv.number(10)};
    if (one.kind == "clock") {
      AuditWindow& next = audit.windows.emplace_back();
      next.number = window;
      next.end = one.linear.x();
      next.length = one.linear.y();
      next.substeps = one.angular.x();
      next.periodic = static_cast<int>(one.angular.z());
    } else if (window < 0) {
      if (one.kind == "state") audit.start = one;
      if (one.kind == "energy") audit.start_energy = one.linear, audit.start_tags = one.angular.x();
    } else if (audit.windows.empty() || audit.windows.back().number != window) {
      csv.fail(code::kAuditDamaged, "window " + std::to_string(window) + " has no row \"clock\" before it");
    } else if (one.kind == "state") {
      audit.windows.back().state = one;
    } else if (one.kind == "energy") {
      audit.windows.back().energy = one.linear;
      audit.windows.back().tags = one.angular.x();
    } else {
      audit.windows.back().sources.push_back(one);
    }
  }
  return audit;
}

MechanismAudit read_mechanism_audit(const std::string& path) {
  constexpr std::size_t kOwn = 11, kPerBody = 7;  // columns
  MechanismAudit audit;
  CsvReader csv(path, kExpected);
  std::vector<std::string> names;
  if (csv.next())
    for (const std::string_view& name : csv.cells()) names.emplace_back(name);
  if (names.size() < kOwn) csv.fail(code::kAuditDamaged, "expected the names of the columns");
  while (csv.next()) {
    csv.require_width(names.size());
    MechanismRow& row = audit.rows.emplace_back();
    row.time = csv.number(0);
    row.momentum = vector(csv, 1);
    row.size = csv.number(4);
    row.mass = csv.number(5);
    row.gravity = vector(csv, 6);
    audit.free = csv.number(9) == 1.0;
    audit.reacts = csv.number(10) == 1.0;
    for (std::size_t at = kOwn; at + kPerBody <= names.size(); at += kPerBody) {
      const std::string body = names[at].substr(0, names[at].rfind('.'));
      row.loads[body] = {vector(csv, at), vector(csv, at + 3), csv.number(at + 6)};
    }
  }
  return audit;
}

namespace {

using Eigen::Vector3d;

constexpr double kEps = std::numeric_limits<double>::epsilon();
// Round-off: every half step rounds the velocity of each grain, and every contact its force.
constexpr double kRoundingsPerStep = 4.0, kRoundingsOfForce = 100.0;
// Lengths of windows are sums of many time steps; equal ones differ by less [-].
constexpr double kSameLength = 1e-9;

// Linear, or angular about the origin.
struct Impulse {
  Vector3d value = Vector3d::Zero();
  double size = 0.0;  // integral of the magnitude
};

// Collects one line over the windows.
class LineMaker {
 public:
  LineMaker(std::string quantity, std::string unit) {
    line_.quantity = std::move(quantity);
    line_.unit = std::move(unit);
  }
  // `flowed`: the exchanged amount to which the bound is relative.
  void take(long window, double defect, double flowed, double relative_bound, double round_off) {
    if (flowed <= 0.0 && defect <= round_off) return;  // nothing was exchanged
    const double bound = relative_bound * flowed + round_off;
    const double excess = bound > 0.0 ? defect / bound : std::numeric_limits<double>::infinity();
    if (line_.verdict != AuditVerdict::kNotExercised && excess <= excess_) return;
    excess_ = excess;
    line_.defect = defect;
    line_.flowed = flowed;
    line_.relative = flowed > 0.0 ? defect / flowed : 0.0;
    line_.bound = bound;
    line_.window = window;
    line_.verdict = excess <= 1.0 ? AuditVerdict::kHolds : AuditVerdict::kWrong;
  }
  void leave_out(const std::string& why) {
    line_.verdict = AuditVerdict::kNotChecked;
    line_.note = why;
  }
  AuditLine line() const { return line_; }

 private:
  AuditLine line_;
  double excess_ = -1.0;
};

// The components of angular momentum that periodic directions do not affect: a grain, or a force, that crosses to the
// other side changes the others by the arm of a period.
Vector3d whole_components(int periodic) {
  switch (periodic) {
    case 0: return Vector3d::Ones();
    case 1: return Vector3d::UnitX();
    case 2: return Vector3d::UnitY();
    case 4: return Vector3d::UnitZ();
    default: return Vector3d::Zero();
  }
}

// Sum over all sources of one kind in a window.
Impulse sum_of(const AuditWindow& window, const std::string& kind, bool angular) {
  Impulse sum;
  for (const AuditSource& source : window.sources) {
    if (source.kind != kind) continue;
    sum.value += angular ? source.angular : source.linear;
    sum.size += angular ? source.moment : source.force;
  }
  return sum;
}

// Exchanged amount and round-off of a window.
struct Scales {
  double flowed, round_off;
};
Scales scales_of(const AuditWindow& window, bool angular) {
  Scales scales{sum_of(window, "body_wall", angular).size, 0.0};
  double all = 0.0;
  for (const char* kind : {"pairs", "gravity", "wall", "body_wall", "fix", "held", "body"})
    all += sum_of(window, kind, angular).size;
  const double size = angular ? window.state.moment : window.state.force;
  scales.round_off = kEps * (kRoundingsPerStep * (window.substeps + 2.0) * size + kRoundingsOfForce * all);
  return scales;
}

void balance_of_grains(const GrainsAudit& grains, bool angular, std::vector<AuditLine>& lines) {
  const std::string what = angular ? "angular" : "linear", unit = angular ? "N m s" : "N s";
  LineMaker balance("grains: " + what + " momentum", unit), walls("walls of bodies: " + what + " impulse", unit),
      pairs("grains on each other: " + what, unit), gravity("gravity: " + what + " impulse", unit);
  const AuditSource* before = &grains.start;
  double tags = grains.start_tags;
  std::string insertion;
  for (const AuditWindow& window : grains.windows) {
    const Vector3d mask = angular ? whole_components(window.periodic) : Vector3d(Vector3d::Ones());
    const auto size = [&mask](const Vector3d& v) { return mask.cwiseProduct(v).norm(); };
    const auto sum = [&](const char* kind) { return sum_of(window, kind, angular); };
    const Scales scales = scales_of(window, angular);
    const Impulse of_pairs = sum("pairs"), of_gravity = sum("gravity"), weight = sum("weight"), body = sum("body");
    const Vector3d got =
        of_pairs.value + of_gravity.value + sum("wall").value + sum("fix").value + sum("held").value - body.value;
    const Vector3d change =
        angular ? Vector3d(window.state.angular - before->angular) : Vector3d(window.state.linear - before->linear);
    if (tags == window.tags) {
      balance.take(window.number, size(change - got), scales.flowed, kAuditBound, scales.round_off);
    } else {
      insertion = "windows in which grains came or went are left out";
    }
    walls.take(window.number, size(sum("body_wall").value + body.value), scales.flowed, kAuditBound, scales.round_off);
    // Grains on both sides of a period share one contact with two arms.
    if (!angular || window.periodic == 0)
      pairs.take(window.number, of_pairs.value.norm(), of_pairs.size, kAuditBound, 0.0);
    gravity.take(window.number, (of_gravity.value - weight.value).norm(), of_gravity.size, kAuditBound, 0.0);
    before = &window.state;
    tags = window.tags;
  }
  const int periodic = grains.windows.empty() ? 0 : grains.windows.front().periodic;
  if (angular && whole_components(periodic).isZero(0.0)) {
    for (LineMaker* line : {&balance, &walls}) line->leave_out("two directions are periodic");
  }
  if (angular && periodic != 0) pairs.leave_out("a direction is periodic");
  for (const LineMaker* maker : {&balance, &walls, &pairs, &gravity}) lines.push_back(maker->line());
  if (!insertion.empty()) lines[lines.size() - 4].note = insertion;
}

// The load on each body, from the contacts to the integrator.
void paths_of_loads(const GrainsAudit& grains, const MechanismAudit& mechanism, std::vector<AuditLine>& lines) {
  LineMaker impulse("load: impulse, summed and sent", "N s"), force("load: mean force, summed and sent", "N s"),
      moment("load: mean moment, summed and sent", "N m s"), felt("load: sent and received", "N s");
  for (std::size_t k = 0; k < grains.windows.size(); ++k) {
    const AuditWindow& window = grains.windows[k];
    const double linear = kEps * kRoundingsOfForce * sum_of(window, "body_wall", false).size,
                 angular = kEps * kRoundingsOfForce * sum_of(window, "body_wall", true).size;
    for (const AuditSource& body : window.sources) {
      if (body.kind != "body") continue;
      const AuditSource &mean = window.find("mean", body.name), &load = window.find("load", body.name),
                        &sent = window.find("impulse", body.name);
      impulse.take(window.number, (sent.linear - body.linear).norm(), body.force, kAuditBound, linear);
      force.take(window.number, (load.linear - mean.linear).norm(), body.force, kAuditBound, linear);
      moment.take(window.number, (load.angular - mean.angular).norm(), mean.moment, kAuditBound, angular);
      if (k + 1 >= mechanism.rows.size()) continue;
      const MechanismLoad& got = mechanism.rows[k + 1].loads.at(body.name);
      const double H = window.length;
      felt.take(window.number, (H * got.F_W - load.linear).norm() + (H * got.T_B - load.angular).norm(),
                load.linear.norm() + load.angular.norm(), kAuditBound, 0.0);
    }
  }
  for (const LineMaker* maker : {&impulse, &force, &moment, &felt}) lines.push_back(maker->line());
}

void balance_of_mechanism(const GrainsAudit& grains, const MechanismAudit& mechanism, std::vector<AuditLine>& lines) {
  LineMaker momentum("mechanism: linear momentum", "N s");
  for (std::size_t k = 1; k < mechanism.rows.size() && k <= grains.windows.size(); ++k) {
    const MechanismRow &from = mechanism.rows[k - 1], &to = mechanism.rows[k];
    // The scene may end within a DEM step: the last window of the grains ends at the nearest whole step.
    const double whole = grains.windows[k - 1].length, moved = to.time - from.time;
    const bool cut = k + 1 == mechanism.rows.size() && std::abs(moved - whole) > kSameLength * whole;
    const double H = cut ? moved : whole;
    Vector3d got = H * to.mass * to.gravity;
    double flowed = got.norm();
    for (const auto& [name, load] : to.loads) {
      got += H * load.F_W;
      flowed += H * load.F_W.norm();
    }
    momentum.take(grains.windows[k - 1].number, (to.momentum - from.momentum - got).norm(), flowed, kMechanismBound,
                  kEps * kRoundingsOfForce * to.size);
  }
  if (!mechanism.free) momentum.leave_out("joints to the ground, drives or applied forces act on it");
  if (mechanism.reacts) momentum.leave_out("with scheme tangent the load depends on the motion within the window");
  lines.push_back(momentum.line());
}

// Work of the bodies on the grains. LIGGGHTS does not know the elastic energy of contacts: it is part of the energy that
// seems dissipated, which may therefore decrease.
void energies(const GrainsAudit& grains, const MechanismAudit& mechanism, std::vector<AuditLine>& lines) {
  AuditLine lost, gap;
  lost.quantity = "grains: energy returned by contacts";
  lost.note = "elastic energy of contacts, stored before or created";
  gap.quantity = "interface: work sent and received";
  gap.note = "an error of the scheme; see coupling_energy_error_relative in summary.json";
  double sum = 0.0, most = 0.0, flow = 0.0, given = 0.0, work_flow = 0.0;
  const Vector3d* before = &grains.start_energy;
  double tags = grains.start_tags;
  for (const AuditWindow& window : grains.windows) {
    double work = 0.0;
    for (const AuditSource& source : window.sources)
      if (source.kind == "impulse") work += source.angular.x();
    const double change = window.energy.x() - before->x() - (window.energy.y() - before->y());
    if (window.tags == tags) {
      sum += -work - change;
      flow += std::abs(work) + std::abs(window.energy.x() - before->x());
    }
    given += work;
    work_flow += std::abs(work);
    most = std::max(most, sum);
    if (most - sum > lost.defect) lost.defect = most - sum, lost.window = window.number;
    before = &window.energy;
    tags = window.tags;
  }
  double received = 0.0;
  if (!mechanism.rows.empty())
    for (const auto& [name, load] : mechanism.rows.back().loads) received += load.received;
  gap.defect = std::abs(given - received);
  const std::array<std::pair<AuditLine*, double>, 2> both{{{&lost, flow}, {&gap, work_flow}}};
  for (const auto& [line, flowed] : both) {
    line->unit = "J";
    line->flowed = flowed;
    line->relative = flowed > 0.0 ? line->defect / flowed : 0.0;
    line->verdict = flowed > 0.0 ? AuditVerdict::kReported : AuditVerdict::kNotExercised;
    lines.push_back(*line);
  }
}

// Length of a window [s] from the script; 0 if only LIGGGHTS can compute it.
double window_length(const Scene& scene) {
  const ParticlesSpec& particles = *scene.particles;
  const ScriptText script(particles.script, particles.variables);
  double dt = 0.0, n = 0.0;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] == "timestep" && w.size() > 1) dt = read_number(w[1].c_str(), nullptr);
    if (w[0] != "fix" || w.size() < 6 || w[3] != "couple/mbd") continue;
    n = w[5] == "auto" ? scene.coupling.max_substeps : read_number(w[5].c_str(), nullptr);
  }
  return dt * n;
}

}  // namespace

std::vector<AuditLine> audit_lines(const GrainsAudit& grains, const MechanismAudit& mechanism) {
  std::vector<AuditLine> lines;
  balance_of_grains(grains, false, lines);
  balance_of_grains(grains, true, lines);
  paths_of_loads(grains, mechanism, lines);
  balance_of_mechanism(grains, mechanism, lines);
  energies(grains, mechanism, lines);
  return lines;
}

std::string audit_table(const std::vector<AuditLine>& lines) {
  std::vector<std::vector<std::string>> rows = {
      {"quantity", "unit", "largest error", "of exchange", "window", "bound", "verdict"}};
  std::vector<std::string> notes;
  int holds = 0, wrong = 0;
  for (const AuditLine& line : lines) {
    const bool measured = line.verdict == AuditVerdict::kHolds || line.verdict == AuditVerdict::kWrong;
    const bool reported = line.verdict == AuditVerdict::kReported;
    rows.push_back({line.quantity, line.unit, measured || reported ? number_text(line.defect, 2) : "-",
                    measured || reported ? number_text(line.relative, 2) : "-",
                    line.window >= 0 && (measured || reported) ? std::to_string(line.window) : "-",
                    measured ? number_text(line.bound, 2) : "-", std::string(name_of(line.verdict))});
    if (!line.note.empty()) notes.push_back(line.quantity + ": " + line.note);
    holds += line.verdict == AuditVerdict::kHolds ? 1 : 0;
    wrong += line.verdict == AuditVerdict::kWrong ? 1 : 0;
  }
  std::vector<std::size_t> width(rows[0].size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  std::string text;
  for (const auto& row : rows) {
    std::string one;
    for (std::size_t c = 0; c < row.size(); ++c) one += row[c] + std::string(width[c] + 2 - row[c].size(), ' ');
    text += one.substr(0, one.find_last_not_of(' ') + 1) + "\n";
  }
  for (const std::string& note : notes) text += "note: " + note + "\n";
  return text + "audit: " + std::to_string(holds) + " quantities hold, " + std::to_string(wrong) + " are wrong\n";
}

bool audit_holds(const std::vector<AuditLine>& lines) {
  return std::none_of(lines.begin(), lines.end(),
                      [](const AuditLine& line) { return line.verdict == AuditVerdict::kWrong; });
}

int audit_command(const RunArguments& arguments, int windows) {
  RunArguments run = arguments;
  std::vector<std::string> settings = run.settings;
  if (!run.scheme.empty()) settings.push_back("coupling.scheme=\"" + run.scheme + "\"");
  const Scene scene = checked_scene(run.scene, settings);
  if (!scene.touches_particles())
    throw InputError(code::kNotCoupled, scene.file + ": ground.kind is not \"particles\"; --audit requires grains");
  if (run.until <= 0.0) {
    const double H = window_length(scene);
    if (H <= 0.0)
      throw InputError(code::kWrongOption, scene.particles->script +
                                               ": only LIGGGHTS can compute the length of its windows; add --until "
                                               "SECONDS");
    run.until = std::min(windows * H, scene.end_time);
  }
  run.audit = true;
  run.quiet = true;
  run.settings.emplace_back("output.plots=false");
  if (run.out.empty()) run.out = new_run_folder("audit");
  std::printf("audit: %s to t = %g s, in %s\n", short_path(scene.file).c_str(), run.until, run.out.c_str());
  std::fflush(stdout);
  if (const int code = run_command(run); code != kExitDone && code != kExitRequirements) return code;
  const std::filesystem::path out = run.out;
  const std::vector<AuditLine> lines = audit_lines(read_grains_audit((out / "audit/grains.csv").string()),
                                                   read_mechanism_audit((out / "audit/mechanism.csv").string()));
  const std::string table = audit_table(lines);
  write_whole_file((out / "audit.txt").string(), table);
  std::printf("%s", table.c_str());
  return audit_holds(lines) ? kExitDone : kExitFailed;
}

}  // namespace footfall

// The audit's table: one number that is wrong is seen, in its line and window (mbd_solver/app/audit.cpp).

#include <gtest/gtest.h>

#include <functional>

#include "mbd_solver/app/audit.h"

namespace footfall {
namespace {

// One body that pushes with (1, 0, 2) N for 1 ms per window at (0, 0.5, 0); nothing else.
struct AuditedRun {
  GrainsAudit grains;
  MechanismAudit mechanism;
};

AuditSource source(const std::string& kind, const std::string& name, const Eigen::Vector3d& linear,
                   const Eigen::Vector3d& angular, double force, double moment) {
  AuditSource one;
  one.kind = kind;
  one.name = name;
  one.linear = linear;
  one.angular = angular;
  one.force = force;
  one.moment = moment;
  return one;
}

AuditedRun exact_run() {
  AuditedRun run;
  const double H = 1e-3;
  const Eigen::Vector3d F(1.0, 0.0, 2.0), M = Eigen::Vector3d(0.0, 0.5, 0.0).cross(F), none = Eigen::Vector3d::Zero();
  run.grains.start_tags = 6.0;
  run.grains.start_energy = {0.0, 0.0, 3.0};
  run.mechanism.free = true;
  MechanismRow row;
  row.mass = 2.0;
  row.loads["pad"] = {};
  run.mechanism.rows.push_back(row);
  for (int k = 0; k < 3; ++k) {
    AuditWindow& window = run.grains.windows.emplace_back();
    window.number = k;
    window.length = H;
    window.substeps = 10.0;
    window.tags = 6.0;
    window.energy = {0.0, 0.0, 3.0};
    const double t = H * (k + 1);
    window.state = source("state", "-", -t * F, -t * M, t * F.norm(), t * M.norm());
    const double f = H * F.norm(), m = H * M.norm();
    window.sources = {source("pairs", "-", none, none, 0.0, 0.0),    source("body_wall", "w", -H * F, -H * M, f, m),
                      source("body", "pad", H * F, H * M, f, m),     source("mean", "pad", H * F, H * M, f, m),
                      source("load", "pad", H * F, H * M, 0.0, 0.0), source("impulse", "pad", H * F, none, 0.0, 0.0)};
    row.time = t;
    row.momentum = t * F;
    row.size = t * F.norm();
    row.loads["pad"] = {F, M, 0.0};
    run.mechanism.rows.push_back(row);
  }
  return run;
}

AuditLine line(const AuditedRun& run, const std::string& quantity) {
  for (const AuditLine& one : audit_lines(run.grains, run.mechanism))
    if (one.quantity == quantity) return one;
  ADD_FAILURE() << "no line " << quantity;
  return {};
}

TEST(AuditTable, HoldsWhereAllIsExact) {
  const AuditedRun run = exact_run();
  const std::vector<AuditLine> lines = audit_lines(run.grains, run.mechanism);
  EXPECT_TRUE(audit_holds(lines)) << audit_table(lines);
  EXPECT_EQ(line(run, "grains: angular momentum").verdict, AuditVerdict::kHolds);
  EXPECT_EQ(line(run, "mechanism: linear momentum").verdict, AuditVerdict::kHolds);
  EXPECT_EQ(line(run, "gravity: linear impulse").verdict, AuditVerdict::kNotExercised);
}

struct Fault {
  const char* name;
  const char* quantity;
  std::function<void(AuditedRun&)> make;
};
class OneNumber : public testing::TestWithParam<Fault> {};
constexpr double kWrong = 1.0 + 1e-8;
const std::vector<Fault> kFaults = {
    {"body", "walls of bodies: linear impulse", [](AuditedRun& r) { r.grains.windows[1].sources[2].linear *= kWrong; }},
    {"moment_on_body", "grains: angular momentum",
     [](AuditedRun& r) { r.grains.windows[1].sources[2].angular *= kWrong; }},
    {"state", "grains: linear momentum", [](AuditedRun& r) { r.grains.windows[1].state.linear *= kWrong; }},
    {"spin", "grains: angular momentum", [](AuditedRun& r) { r.grains.windows[1].state.angular *= kWrong; }},
    {"impulse", "load: impulse, summed and sent",
     [](AuditedRun& r) { r.grains.windows[1].sources[5].linear *= kWrong; }},
    {"load", "load: mean force, summed and sent",
     [](AuditedRun& r) { r.grains.windows[1].sources[4].linear *= kWrong; }},
    {"moment", "load: mean moment, summed and sent",
     [](AuditedRun& r) { r.grains.windows[1].sources[4].angular *= kWrong; }},
    {"felt", "load: sent and received", [](AuditedRun& r) { r.mechanism.rows[2].loads["pad"].F_W *= kWrong; }},
    {"mechanism", "mechanism: linear momentum", [](AuditedRun& r) { r.mechanism.rows[2].momentum *= 1.0 + 1e-5; }},
};
INSTANTIATE_TEST_SUITE_P(Faults, OneNumber, testing::ValuesIn(kFaults),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(OneNumber, ThatIsWrongIsSeenInItsLineAndWindow) {
  AuditedRun run = exact_run();
  GetParam().make(run);
  const AuditLine found = line(run, GetParam().quantity);
  EXPECT_EQ(found.verdict, AuditVerdict::kWrong) << audit_table(audit_lines(run.grains, run.mechanism));
  EXPECT_GE(found.window, 1);
  EXPECT_FALSE(audit_holds(audit_lines(run.grains, run.mechanism)));
}

// The scene ends within a step of the grains: the mechanism feels the last window's mean force for a part of it.
TEST(AuditTable, TakesALastWindowThatTheEndOfTheSceneCuts) {
  AuditedRun run = exact_run();
  const MechanismRow before = run.mechanism.rows[run.mechanism.rows.size() - 2];
  MechanismRow& last = run.mechanism.rows.back();
  last.time = before.time + 0.6 * (last.time - before.time);
  last.momentum = before.momentum + 0.6 * (last.momentum - before.momentum);
  EXPECT_EQ(line(run, "mechanism: linear momentum").verdict, AuditVerdict::kHolds);
  last.momentum *= 1.0 + 1e-5;
  EXPECT_EQ(line(run, "mechanism: linear momentum").verdict, AuditVerdict::kWrong);
  // No other window may be cut.
  AuditedRun other = exact_run();
  other.mechanism.rows[1].time *= 0.6;
  other.mechanism.rows[1].momentum *= 0.6;
  EXPECT_EQ(line(other, "mechanism: linear momentum").verdict, AuditVerdict::kWrong);
}

TEST(AuditTable, LeavesOutWindowsInWhichGrainsCome) {
  AuditedRun run = exact_run();
  run.grains.windows[2].tags = 9.0;
  run.grains.windows[2].state.linear *= 2.0;
  EXPECT_EQ(line(run, "grains: linear momentum").verdict, AuditVerdict::kHolds);
  EXPECT_NE(line(run, "grains: linear momentum").note, "");
}

TEST(AuditTable, ChecksTheAngularMomentumThatAPeriodLeavesAlone) {
  for (const int periodic : {1, 3}) {
    AuditedRun run = exact_run();
    for (AuditWindow& window : run.grains.windows) window.periodic = periodic;
    run.grains.windows[1].state.angular.y() += 1.0;  // an arm of a period along x
    run.grains.windows[1].state.angular.z() += 1.0;
    EXPECT_EQ(line(run, "grains: angular momentum").verdict,
              periodic == 1 ? AuditVerdict::kHolds : AuditVerdict::kNotChecked);
    run.grains.windows[1].state.angular.x() += 1.0;
    EXPECT_EQ(line(run, "grains: angular momentum").verdict,
              periodic == 1 ? AuditVerdict::kWrong : AuditVerdict::kNotChecked);
  }
}

}  // namespace
}  // namespace footfall

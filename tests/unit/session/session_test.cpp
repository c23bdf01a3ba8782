// A mechanism inside another program: the same digits as a run, signals that the host sets, states in memory, errors as parts.
#include "mbd_solver/session/session.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>
#include <utility>

#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/error_report.h"
#include "mbd_solver/session/simulation.h"
#include "tests/support/foreign_locale.h"
#include "tests/unit/scene/scene_text.h"
#include "tests/unit/session/never.h"
#include "tests/unit/session/small_machine.h"

namespace footfall {
namespace {

// A mass of 2 kg on which a host pushes.
const std::string kPushed = R"(end_time = 1.0
[[bodies]]
name = "b"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 0]
[[forces]]
name = "push"
body = "b"
direction = "x"
force = { signal = "thrust" }
[[signals]]
name = "thrust"
kind = "host"
initial = 4.0
)";

struct Case {
  std::string name, toml;
  std::vector<std::string> settings;
};
std::vector<Case> cases() {
  return {{"pendulum", kPendulum, {"initial.joints.hinge=0.5"}},
          {"pendulum_by_ida", kPendulum, {"solver.integrator=ida", "initial.joints.hinge=0.5"}},
          {"rare_rows", kPendulum, {"output.interval=0.1", "initial.joints.hinge=0.5"}},
          {"machine", test::kSmallMachine, {}},
          {"pushed", kPushed, {}}};
}

// The state after a run from the command line, and how many steps it took.
std::pair<State, long> after_run(const Scene& scene) {
  Simulation simulation(scene, scene.end_time, nullptr);
  simulation.run([](const Sample&) {}, test::kNever);
  return {simulation.state(), simulation.integrator().statistics().steps};
}

class EveryScene : public testing::TestWithParam<Case> {
 protected:
  Scene scene() const { return SceneText().read(GetParam().toml, GetParam().settings); }
};

// Bit for bit where steps end at rows or rows influence nothing: states are read on the way, and no step is cut.
TEST_P(EveryScene, IsIntegratedInTheSameDigitsAsByARun) {
  Session led(scene());
  for (int k = 1; !led.finished(); ++k) led.step_to(2e-3 * k);
  const State end = after_run(scene()).first;
  EXPECT_EQ(led.q(), end.q);
  EXPECT_EQ(led.v(), end.v);
  EXPECT_EQ(led.z(), end.z);
  EXPECT_EQ(led.time(), end.time);
}

TEST_P(EveryScene, GoesOnFromASavedStateInTheSameDigits) {
  Session led(scene()), other(scene());
  led.step_to(0.03);
  const std::string state = led.save();
  other.step_to(0.01);
  other.restore(state);
  EXPECT_EQ(other.row(), led.row());
  const auto goes_on = [](Session& simulation) {
    for (int k = 1; k < 20; ++k) simulation.step_to(0.03 + 0.003 * k);
    return simulation.row();
  };
  const std::vector<double> end = goes_on(led);
  EXPECT_EQ(goes_on(other), end);
  led.restore(state);  // once more, in an object that has been further
  EXPECT_EQ(goes_on(led), end);
  EXPECT_EQ(led.save(), other.save());
}

std::string name_of_case(const testing::TestParamInfo<Case>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Of, EveryScene, testing::ValuesIn(cases()), name_of_case);

TEST(Session, GoesOnFromPositionsAndVelocitiesThatWereSet) {
  const SceneText folder;
  Session led(folder.read(kPendulum, {"initial.joints.hinge=0.5"}));
  Session other(folder.read(kPendulum, {"initial.joints.hinge=1.0"}));
  led.step_to(0.02);
  led.place(other.q(), other.v());
  EXPECT_LT((led.q() - other.q()).norm(), 1e-9);
  led.step_to(0.06);
  other.step_to(0.04);
  EXPECT_LT((led.q() - other.q()).norm(), 1e-6);
  EXPECT_LT((led.v() - other.v()).norm(), 1e-5);
  EXPECT_LT(led.energy_balance(), 1e-5);
  const Eigen::VectorXd q = led.q(), v = led.v();
  EXPECT_THROW(led.place(q.head(3), v), InputError);
  EXPECT_THROW(led.place(Eigen::VectorXd::Zero(q.size()), v), InputError);
  EXPECT_THROW(led.place(q, v * std::numeric_limits<double>::infinity()), InputError);
  EXPECT_EQ(led.q(), q);
  led.step_to(0.07);
}

// Whole steps of 30 ms are not cut into thirty.
TEST(Session, TakesNoMoreStepsThanARun) {
  const SceneText folder;
  const Scene scene = folder.read(kPendulum, {"initial.joints.hinge=0.5", "output.interval=0.1"});
  Session led(scene, {false, true});
  for (int k = 1; !led.finished(); ++k) led.step_to(1e-3 * k);
  const std::string summary = led.summary();
  EXPECT_NE(summary.find("\"steps\": " + std::to_string(after_run(scene).second)), std::string::npos) << summary;
}

// x = F t^2 / 2 m in pieces; forces that are constant in a step are integrated exactly.
TEST(Session, ASignalOfTheHostActsFromTheTimeAtWhichItIsSet) {
  Session led(SceneText().read(kPushed));
  double x = 0.0, v = 0.0, force = 4.0;
  for (int k = 0; k < 50; ++k) {
    const double h = 0.011;
    if (k % 5 == 3) led.set("thrust", force = 10.0 * std::sin(k));
    led.step_to(h * (k + 1));
    x += v * h + force / 4.0 * h * h;
    v += force / 2.0 * h;
    ASSERT_NEAR(led.value("b.x"), x, 1e-12) << k;
    ASSERT_NEAR(led.value("b.vx"), v, 1e-12) << k;
    ASSERT_NEAR(led.value("b.ax"), force / 2.0, 1e-12) << k;
    ASSERT_EQ(led.value("signal.thrust"), force) << k;
  }
  EXPECT_EQ(led.signals(), std::vector<std::string>{"thrust"});
  EXPECT_EQ(led.signal("thrust"), force);
}

// A sampled signal reads the new value at once, an event takes place at the instant.
TEST(Session, SampledSignalsAndEventsSeeWhatTheHostSets) {
  const std::string more = R"([[signals]]
name = "twice"
kind = "expression"
input = "2 * signal.thrust"
period_ms = 10
[[states]]
name = "waits"
[[states]]
name = "goes"
[[events]]
name = "start"
when = "signal.thrust > 5"
to = "goes"
)";
  Session led(SceneText().read(kPushed + more));
  led.step_to(0.05);
  led.set("thrust", 6.0);
  led.step_to(0.055);
  EXPECT_EQ(led.value("signal.twice"), 12.0);
  EXPECT_EQ(led.value("state.goes"), 1.0);
}

TEST(Session, AValueThatHasNotActedYetIsPartOfASavedState) {
  Session led(SceneText().read(kPushed)), other(SceneText().read(kPushed));
  led.step_to(0.1);
  led.set("thrust", -3.0);
  other.restore(led.save());
  EXPECT_EQ(other.signal("thrust"), -3.0);
  led.step_to(0.2);
  other.step_to(0.2);
  EXPECT_EQ(other.row(), led.row());
  EXPECT_NEAR(led.value("b.vx"), 0.1 * (4.0 - 3.0) / 2.0, 1e-12);
}

TEST(Session, TwoInOneProcessDoNotMeet) {
  Session alone(SceneText().read(kPendulum)), first(SceneText().read(kPendulum)), second(SceneText().read(kPushed));
  for (int k = 1; k <= 40; ++k) {
    first.step_to(0.01 * k);
    second.step_to(0.02 * k);
    if (k == 20) second = Session(SceneText().read(test::kSmallMachine));
    if (k > 20) break;
  }
  for (int k = 1; k <= 21; ++k) alone.step_to(0.01 * k);
  EXPECT_EQ(first.row(), alone.row());
}

// The state remains that before the step, and another one can be restored.
TEST(Session, AFailureLeavesTheStateBeforeTheStep) {
  const std::string blows_up = R"TOML(
[[signals]]
name = "root"
kind = "expression"
input = "sqrt(0.5 - time)"
period_ms = 10
)TOML";
  Session led(SceneText().read(kPushed + blows_up));
  led.step_to(0.4);
  const std::string state = led.save();
  const std::vector<double> row = led.row();
  EXPECT_THROW(led.step_to(0.6), NumericalError);
  EXPECT_EQ(led.row(), row);
  EXPECT_EQ(led.time(), 0.4);
  EXPECT_NE(test::refusal([&] { led.step_to(0.45); }).find(code::kCannotGoOn.number), std::string::npos);
  led.restore(state);
  led.step_to(0.45);
  EXPECT_NEAR(led.time(), 0.45, 1e-12);
}

TEST(Session, RefusesWhatItCannotDo) {
  Session led(SceneText().read(kPushed));
  const auto refused = [&](const auto& what, const MessageCode& code) {
    const std::string message = test::refusal(what);
    EXPECT_NE(message.find(code.number), std::string::npos) << message;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  led.step_to(0.1);
  refused([&] { led.step_to(0.05); }, code::kStepBackwards);
  refused([&] { led.step_to(nan); }, code::kStepBackwards);
  refused([&] { led.set("thrust", nan); }, code::kGivenNotFinite);
  refused([&] { led.set("trust", 1.0); }, code::kNoHostSignal);
  refused([&] { led.value("b.q"); }, code::kNoSuchColumn);
  refused([&] { led.summary(); }, code::kNotRecorded);
  refused([&] { led.restore("nonsense"); }, code::kStateOfAnother);
  refused([&] { led.restore(Session(SceneText().read(kPendulum)).save()); }, code::kStateOfAnother);
  led.step_to(5.0);  // the end of the scene is earlier
  EXPECT_TRUE(led.finished());
  EXPECT_EQ(led.time(), 1.0);
  refused([&] { led.step_to(6.0); }, code::kCannotGoOn);
}

TEST(Session, AHostMayEndAStepEarly) {
  Session led(SceneText().read(kPendulum, {"end_time=1e3", "output.interval=1e-3"}));
  led.step_to(1e3, [] { return true; });
  EXPECT_GT(led.time(), 0.0);
  EXPECT_LT(led.time(), 1e3);
  const double reached = led.time();
  led.step_to(reached + 0.01);
  EXPECT_NEAR(led.time(), reached + 0.01, 1e-12);
}

// The question within a step is the time at which other threads, and the thread itself, find the simulation under way.
TEST(Session, RefusesCallsWhileItIsBeingStepped) {
  Session led(SceneText().read(kPushed, {"end_time=1e3", "output.interval=1e-3", "solver.max_step=1e-3"}),
              {false, true});
  const std::string state = led.save();
  const auto refused = [&](const auto& what) {
    const std::string message = test::refusal(what);
    EXPECT_NE(message.find(code::kInUse.number), std::string::npos) << message;
  };
  const auto change = [&] {
    refused([&] { led.step_to(1e3); });
    refused([&] { led.save(); });
    refused([&] { led.restore(state); });
    refused([&] { led.set("thrust", 1.0); });
  };
  int questions = 0;
  led.step_to(1e3, [&] {
    ++questions;
    std::thread([&] {
      change();
      refused([&] { led.time(); });
      refused([&] { led.finished(); });
      refused([&] { led.row(); });
      refused([&] { led.q(); });
      refused([&] { led.value("b.x"); });
      refused([&] { led.signal("thrust"); });
      refused([&] { led.warnings(); });
      refused([&] { led.summary(); });
      EXPECT_EQ(led.end_time(), 1e3) << "constants can be read";
    }).join();
    change();
    EXPECT_EQ(led.time(), 0.0) << "the thread that steps may read what was before the step";
    return true;
  });
  ASSERT_EQ(questions, 1);
  const double reached = led.time();
  EXPECT_GT(reached, 0.0);
  std::thread([&] { led.step_to(reached + 0.01); }).join();
  EXPECT_NEAR(led.value("b.x"), 4.0 / 2.0 * led.time() * led.time() / 2.0, 1e-9 * led.time() * led.time());
}

// Of a host that writes 1.234,5: the scene, its expressions, states and messages are read and written as elsewhere.
TEST(Session, GivesTheSameInEveryLocale) {
  const std::string signal = "[[signals]]\nname = \"s\"\nkind = \"expression\"\ninput = \"1.5 * time + 0.25\"\n";
  const auto result = [&] {
    Session led(read_scene_text(kPushed + signal, "."), {false, true});
    led.step_to(0.0125);
    const std::string state = led.save();
    led.step_to(0.02);
    led.restore(state);
    led.step_to(0.03);
    return std::pair(led.row(), state);
  };
  const auto here = result();
  const std::string refusal = test::refusal([&] { read_scene_text(kPushed, ".", {"solver.rtol=-1.5e3"}); });
  const test::ForeignLocale german;
  const auto there = result();
  EXPECT_EQ(there.first, here.first);
  EXPECT_EQ(there.second, here.second);
  EXPECT_EQ(test::refusal([&] { read_scene_text(kPushed, ".", {"solver.rtol=-1.5e3"}); }), refusal);
}

TEST(Session, ReadsAScenesText) {
  const SceneText folder;
  const Scene scene = read_scene_text(kPushed, ".", {"bodies.b.mass=4"});
  EXPECT_EQ(scene.bodies[0].mass, 4.0);
  try {
    read_scene_text(kPushed + "[solver]\nrtoll = 1\n[[joints]]\nname = \"j\"\n", "folder");
    FAIL();
  } catch (const InputError& error) {
    const std::vector<ErrorReport> reports = reports_of(error);
    ASSERT_GE(reports.size(), 2u);
    EXPECT_EQ(reports[0].kind, ErrorReport::Kind::kInput);
    EXPECT_EQ(reports[0].code, "E0103");
    EXPECT_EQ(reports[0].name, "unknown-key");
    EXPECT_EQ(reports[0].file, "folder/scene_text");
    EXPECT_EQ(reports[0].line, 17);
    EXPECT_EQ(reports[0].key, "solver.rtoll");
    EXPECT_EQ(reports[0].text.find("unknown key"), 0u) << reports[0].text;
  }
}

TEST(ErrorReport, NamesWhatASettingIsWrongIn) {
  try {
    read_scene_text(kPushed, ".", {"bodies.c.mass=4"});
    FAIL();
  } catch (const InputError& error) {
    const ErrorReport report = reports_of(error).front();
    EXPECT_EQ(report.line, -1);
    EXPECT_EQ(report.key, "bodies.c.mass");
  }
}

}  // namespace
}  // namespace footfall

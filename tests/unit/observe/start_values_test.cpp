#include "mbd_solver/observe/start_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupler/base/errors.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;

const std::string kBall = R"(end_time = 1
[[bodies]]
name = "ball"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 3]
)";
const std::string kStates = "[[states]]\nname = \"up\"\n[[states]]\nname = \"down\"\n";

std::string sampled(const std::string& input, const std::string& more = "") {
  return "[[signals]]\nname = \"s\"\nkind = \"expression\"\nperiod_ms = 10\ninput = \"" + input + "\"\n" + more;
}
std::string event(const std::string& name, const std::string& when, const std::string& more = "") {
  return "[[events]]\nname = \"" + name + "\"\nto = \"down\"\nwhen = \"" + when + "\"\n" + more;
}

std::string complaint_at_start(const std::string& toml, bool is_placed = true) {
  const SceneText text;
  const Scene scene = text.read(toml);
  Mechanism mechanism = build_mechanism(scene);
  try {
    demand_values_at_start(scene, is_placed, mechanism);
  } catch (const InputError& error) {
    return error.what();
  }
  return "good";
}

TEST(StartValues, OfPlacesAccelerationsAndForcesAreThoseOfTheRun) {
  EXPECT_EQ(complaint_at_start(kBall + sampled("sqrt(-9 - ball.az)")), "good");  // it falls
  EXPECT_THAT(complaint_at_start(kBall + sampled("sqrt(-10 - ball.az)")),
              HasSubstr("signals.s.input: \"sqrt(-10 - ball.az)\" has no value where ball.az = -9.81"));
  EXPECT_THAT(complaint_at_start(kBall + kStates + event("e", "1 / work.contact")),
              HasSubstr("events.e.when: \"1 / work.contact\" has no value where work.contact = 0"));
}

TEST(StartValues, NamesThatNothingHasAreToldTogether) {
  const std::string told =
      complaint_at_start(kBall + kStates + sampled("ball.q + bal.z") + event("e", "ball.q > 1"), false);
  EXPECT_THAT(told, HasSubstr("signals.s.input: nothing is called \"ball.q\""));
  EXPECT_THAT(told, HasSubstr("signals.s.input: nothing is called \"bal.z\""));
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << told;
}

TEST(StartValues, AreLeftToTheRunWhereItAloneKnowsThem) {
  const std::string root = sampled("sqrt(ball.z - 4)");
  EXPECT_THAT(complaint_at_start(kBall + root), HasSubstr("has no value"));
  EXPECT_EQ(complaint_at_start(kBall + root, false), "good");
  EXPECT_THAT(complaint_at_start(kBall + sampled("sqrt(time - 4)"), false), HasSubstr("has no value"));
}

// What the first state does not look at, or ends at once, is no mistake.
TEST(StartValues, CountInTheStateOfTheStart) {
  const std::string root = "sqrt(ball.z - 4)";
  EXPECT_EQ(complaint_at_start(kBall + kStates + sampled(root, "states = [\"down\"]\n") + event("e", "time > 1")),
            "good");
  const std::string up = sampled(root, "states = [\"up\"]\n");
  EXPECT_THAT(complaint_at_start(kBall + kStates + up + event("e", "time > 1")), HasSubstr("signals.s.input"));
  EXPECT_EQ(complaint_at_start(kBall + kStates + up + event("e", "ball.z > 1")), "good");
  EXPECT_EQ(complaint_at_start(kBall + kStates + event("a", "ball.z > 1") + event("b", root)), "good");
  EXPECT_THAT(complaint_at_start(kBall + kStates + event("b", root) + event("a", "ball.z > 1")),
              HasSubstr("events.b.when: \"sqrt(ball.z - 4)\" has no value where ball.z = 3"));
}

}  // namespace
}  // namespace footfall

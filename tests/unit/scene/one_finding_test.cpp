// One mistake is one finding: what was refused when it was read is not complained of again: mbd_solver/scene/findings.h.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mbd_solver/scene/findings.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

auto Only(const std::string& what) { return AllOf(HasSubstr(what), Not(HasSubstr("\n"))); }

std::string with_signal(const std::string& keys) { return kPendulum + "[[signals]]\nname = \"a\"\n" + keys + "\n"; }

std::string with_body(const std::string& keys) { return kPendulum + "[[bodies]]\nname = \"b\"\n" + keys + "\n"; }

TEST(OneFinding, OfASignal) {
  const SceneText text;
  const std::string lowpass = "kind = \"lowpass\"\ninput = \"hinge.angle\"\n";
  EXPECT_THAT(text.findings(with_signal(lowpass + "frequency = -5")), Only("signals.a.frequency: is -5 Hz"));
  EXPECT_THAT(text.findings(with_signal(lowpass + "frequency = \"5 Hz\"")), Only("signals.a.frequency: is text"));
  EXPECT_THAT(text.findings(with_signal(lowpass + "frequency = 0")), Only("signals.a.frequency: is 0; a filter"));
  EXPECT_THAT(text.findings(with_signal(lowpass)), Only("signals.a.frequency: is missing"));
  EXPECT_THAT(text.findings(with_signal("kind = \"expression\"\ninput = 5")), Only("signals.a.input: is the number 5"));
  EXPECT_THAT(text.findings(with_signal("kind = \"lowpas\"\ninput = \"1\"\nfrequency = 2")),
              Only("signals.a.kind: is"));
}

TEST(OneFinding, OfAShape) {
  const SceneText text;
  EXPECT_THAT(
      text.findings(with_body("mass = 1\nshape = { kind = \"cone\", centre = [0, 0, 0], axis = \"z\", radius = 0.1, "
                              "length = 0.2 }")),
      Only("bodies.b.shape.kind: is text \"cone\""));
  EXPECT_THAT(
      text.findings(with_body("mass = 1\nshape = { kind = \"cylinder\", centre = [0, 0, 0], axis = \"z\", radius = "
                              "0, length = 0.2 }")),
      Only("bodies.b.shape.radius: is 0 m, expected more than 0"));
}

TEST(OneFinding, OfAJoint) {
  const SceneText text;
  std::string toml = kPendulum;
  toml.replace(toml.find("revolute"), 8, "revolut");
  EXPECT_THAT(text.findings(toml), Only("joints.hinge.type: is text \"revolut\""));
}

TEST(OneFinding, OfStopsNamesTheKeyThatSetGave) {
  const SceneText text;
  const std::string stops = kPendulum + "[joints.angle]\nstops = { min_deg = -10, max_deg = 10, stiffness = 500 }\n";
  EXPECT_THAT(text.findings(stops, {"joints.hinge.angle.stops.min_deg=20"}),
              Only("--set joints.hinge.angle.stops.min: is 20 degrees, not below max, 10 degrees; give a smaller min"));
  EXPECT_THAT(
      text.findings(stops, {"joints.hinge.angle.stops.max_deg=-20"}),
      Only("--set joints.hinge.angle.stops.max: is -20 degrees, not above min, -10 degrees; give a smaller min"));
}

TEST(OneFinding, SaysWhereItStands) {
  Source source{"signals.s", 40, {{"input", Source::kFromSet}, {"rate", 41}}, {}};
  EXPECT_EQ(place_of("s.toml", source, "input"), "--set signals.s.input: ");
  EXPECT_EQ(place_of("s.toml", source, "rate"), "s.toml:41: signals.s.rate: ");
  EXPECT_EQ(place_of("s.toml", source), "s.toml:40: signals.s: ");
  EXPECT_TRUE(names_a_place("s.toml", "s.toml:40: signals.s: what"));
  EXPECT_TRUE(names_a_place("s.toml", "--set signals.s: what"));
  EXPECT_FALSE(names_a_place("s.toml", "what"));
}

TEST(Limits, OfDensityToleranceAndSteps) {
  const SceneText text;
  const std::vector<std::string> warnings = text.read(kPendulum + "[materials.al]\ndensity = 2.7\n").warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("materials.al.density: is 2.7 kg/m3"));
  EXPECT_THAT(warnings[0], HasSubstr("density_g_cm3 = 2.7"));
  EXPECT_TRUE(text.read(kPendulum + "[materials.al]\ndensity_g_cm3 = 2.7\n").warnings.empty());
  EXPECT_THAT(text.findings(kPendulum + "[solver]\nrtol = 2\n"), Only("solver.rtol: is 2, expected less than 0.1"));
  EXPECT_THAT(text.findings(kPendulum + "[solver]\nmax_step = 1e-12\n"),
              Only("solver.max_step: is 1e-12 s: 1e+12 steps until end_time, expected at most 1e+09"));
}

}  // namespace
}  // namespace footfall

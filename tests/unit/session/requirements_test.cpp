// Requirements of a scene: met, missed, and without a value.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/observe/requirements.h"
#include "mbd_solver/session/observe/start_values.h"
#include "mbd_solver/session/output/checkpoint_folder.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/session/run_scene.h"
#include "tests/support/refused.h"
#include "tests/unit/session/recorded.h"
#include "tests/unit/session/small_machine.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

// Thrown upwards at 2 m/s under 10 m/s2: highest after 0.2 s, by 0.2 m.
const std::string kThrown = R"(end_time = 0.3
gravity = [0, 0, -10]
[[bodies]]
name = "ball"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 3]
[initial]
velocity = [1, 0, 2]
[output]
interval = 0.07
vtk = false
)";

std::string requirement(const std::string& name, const std::string& value, const std::string& more) {
  return "[[requirements]]\nname = \"" + name + "\"\nvalue = \"" + value + "\"\n" + more;
}

Json judged(const std::string& entries, int code = kExitDone) {
  const SceneText folder;
  return read_summary(test::run_into_folder(folder.read(kThrown + entries), nullptr, code) + "/summary.json");
}

// Ends of steps and their middles are nearer than 1 ms to the top, which is 10 / 2 (1e-3)^2 = 5e-6 m higher.
TEST(Requirements, TellResultMarginAndVerdict) {
  const Json summary = judged(requirement("height", "ball.z.max - 3", "unit = \"m\"\nmost = 0.25\n") +
                              requirement("low", "ball.z.max - 3", "least = 0.1\nmost = 0.15\n") +
                              requirement("speed", "sqrt(ball.vx^2 + ball.vz^2)", "reduce = \"min\"\nleast = 0.5\n") +
                              requirement("load", "peak_acceleration_g * g0", "least = 9\nunit = \"m/s2\"\n") +
                              requirement("end", "ball.x.final / deg", "most = 20\n"));
  const Json& list = summary.at("requirements");
  ASSERT_EQ(list.size(), 5u);
  EXPECT_NEAR(list[0]["value"], 0.2, 5e-6);
  EXPECT_NEAR(list[0]["margin"], 0.05, 5e-6);
  EXPECT_EQ(list[0]["verdict"], "met");
  EXPECT_EQ(list[0]["unit"], "m");
  EXPECT_NEAR(list[1]["margin"], -0.05, 5e-6);  // of the bound that is nearest
  EXPECT_EQ(list[1]["verdict"], "missed");
  EXPECT_NEAR(list[2]["value"], 1.0, 1e-4);  // at the top, vz = 10 * 1e-3 at most
  EXPECT_EQ(list[2]["verdict"], "met");
  EXPECT_NEAR(list[3]["value"], 10.0, 1e-9);
  EXPECT_EQ(list[3]["verdict"], "met");
  EXPECT_NEAR(list[4]["value"], 0.3 * 180.0 / kPi, 1e-6);
  EXPECT_EQ(summary["requirements_missed"], 1);
}

TEST(Requirements, WithoutAValueAreNotMet) {
  const Json summary = judged(requirement("root", "sqrt(2.9 - ball.z.max)", "most = 1\n") +
                              requirement("now_and_then", "sqrt(ball.vz)", "reduce = \"max\"\nmost = 9\n") +
                              requirement("grains", "max_overlap_over_radius", "most = 0.01\n"));
  for (const Json& r : summary.at("requirements")) {
    EXPECT_EQ(r["verdict"], "not computed") << r;
    EXPECT_FALSE(r.contains("value")) << r;
    EXPECT_GT(r["why"].get<std::string>().size(), 5u);
  }
  EXPECT_EQ(summary["requirements_missed"], 3);
}

TEST(Requirements, OfASceneWithoutAnyAreNotTold) { EXPECT_FALSE(judged("").contains("requirements")); }

TEST(Requirements, MistakesAreToldBeforeTheRun) {
  const SceneText text;
  const auto told = [&](const std::string& entries) {
    return test::refusal([&] {
      const Scene scene = text.read(kThrown + entries);
      Mechanism mechanism = build_mechanism(scene);
      require_values_at_start(scene, true, mechanism);
    });
  };
  EXPECT_TRUE(test::names(told(requirement("a", "ball.q.max", "most = 1\n")), {"requirements", "ball.q", "E0672"}));
  EXPECT_TRUE(test::names(told(requirement("a", "ball.z", "most = 1\n")), {"ball.z", "reduce", "E0672"}));
  EXPECT_TRUE(test::names(told(requirement("a", "ball.z.max", "reduce = \"max\"\nmost = 1\n")), {"E0672"}));
  EXPECT_TRUE(test::names(told(requirement("a", "max_descend_m", "most = 1\n")), {"max_descent_m", "E0672"}));
  EXPECT_TRUE(test::names(told(requirement("a", "ball.z.max", "")), {"requirements", "most", "E0106"}));
  EXPECT_NE(told(requirement("a", "ball.z.max +", "most = 1\n")), "");
  EXPECT_NE(told(requirement("a", "ball.z.max", "least = 2\nmost = 1\n")), "");
  EXPECT_NE(told(requirement("a", "1", "most = 1\n") + requirement("a", "1", "most = 1\n")), "");
}

// Every number at the top of a summary can be required.
TEST(Requirements, KnowTheFiguresOfASummary) {
  const std::vector<std::string>& known = summary_figures();
  const Json summary = judged("");
  for (const auto& [key, value] : summary.items()) {
    if (!value.is_number()) continue;
    EXPECT_NE(std::find(known.begin(), known.end(), key), known.end()) << key;
  }
}

// One number in another unit than is stated is told; expressions are the user's.
TEST(Requirements, TellOfUnitsThatTheirNumberDoesNotHave) {
  const auto warnings = [](const std::string& value, const std::string& unit) {
    const SceneText folder;
    const Scene scene = folder.read(kThrown + requirement("r", value, "unit = \"" + unit + "\"\nmost = 1\n"));
    return requirement_unit_warnings(scene, {"time", "ball.z", "ball.roll", "ball.vx"}, {"s", "m", "rad", "m/s"});
  };
  const std::pair<const char*, const char*> told[] = {{"ball.roll.max", "deg"},
                                                      {"ball.z.final", "mm"},
                                                      {"ball.z.max", "N"},
                                                      {"max_descent_m", "cm"},
                                                      {"peak_acceleration_g", "m/s2"}};
  for (const auto& [value, unit] : told) {
    ASSERT_EQ(warnings(value, unit).size(), 1u) << value;
    EXPECT_TRUE(test::names(warnings(value, unit)[0], {"W1669", unit}));
  }
  const std::pair<const char*, const char*> fine[] = {{"ball.roll.max", "rad"},
                                                      {"ball.roll.max / deg", "deg"},
                                                      {"ball.z.final", "metres"},
                                                      {"max_descent_m", "m"},
                                                      {"steps", "N"}};
  for (const auto& [value, unit] : fine) EXPECT_TRUE(warnings(value, unit).empty()) << value;
}

// The top is at 0.2 s; the run that is resumed at 0.25 s sees it no more.
TEST(Requirements, RememberWhatWasBeforeACheckpoint) {
  const SceneText folder;
  const Scene scene = folder.read(kThrown + requirement("height", "ball.z.max - 3", "unit = \"m\"\nmost = 0.25\n"),
                                  {"output.checkpoint_interval=0.25"});
  RunOptions options;
  options.out = (std::filesystem::path(scene.file).parent_path() / "out").string();
  options.quiet = true;
  ASSERT_EQ(run_scene(scene, options, nullptr, test::kNever), kExitDone);
  options.checkpoint = newest_checkpoint(options.out);
  ASSERT_EQ(run_scene(scene, options, nullptr, test::kNever), kExitDone);
  EXPECT_NEAR(read_summary(options.out + "/summary.json").at("requirements")[0]["value"], 0.2, 5e-6);
}

}  // namespace
}  // namespace footfall

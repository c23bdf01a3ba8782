// Scenes with signals of kind "fmu", run by footfall: values against closed forms, resumed runs, failures, and what check says.

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "tests/app/programs.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using app::Folder;
using testing::HasSubstr;

const std::string kFmuFiles = TEST_FMUS "/";

// A mass on a slider, pushed by the signal "push", in 0.1 s.
std::string scene_with(const std::string& signals, const std::string& force = "signal = \"push\"") {
  return R"(end_time = 0.1
gravity = [0, 0, 0]
[[bodies]]
name = "block"
mass = 2.0
inertia = [0.1, 0.1, 0.2]
position = [0, 0, 0]
[[joints]]
name = "slider"
kind = "prismatic"
bodies = ["ground", "block"]
point = [0, 0, 0]
axis = "x"
[[forces]]
name = "push"
body = "block"
direction = [1, 0, 0]
force = { )" +
         force + R"( }
[output]
interval = 0.001
plots = false
vtk = false
)" + signals;
}

std::string fmu_signal(const std::string& name, const std::string& fmu, const std::string& keys) {
  return "[[signals]]\nname = \"" + name + "\"\nkind = \"fmu\"\nfile = \"" + kFmuFiles + fmu +
         ".fmu\"\nperiod = 0.001\n" + keys + "\n";
}

std::map<std::string, std::vector<double>> columns(const Folder& folder, const std::string& run) {
  std::map<std::string, std::vector<double>> all;
  std::istringstream lines(folder.read(run + "/history.csv"));
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (names.empty()) {
      for (std::string& name : row) names.push_back(name.substr(0, name.find(' ')));
      continue;
    }
    for (std::size_t i = 0; i < row.size(); ++i)
      if (char* end = nullptr; std::strtod(row[i].c_str(), &end), *end == '\0')
        all[names[i]].push_back(std::stod(row[i]));
  }
  return all;
}

// A row precedes the sample at its time, as for every sampled signal: it has x of the FMU at t - T.
TEST(FmuScene, OscillatorIsAColumnOfTheHistory) {
  for (const char* fmu : {"oscillator_3", "oscillator_2"}) {
    const Folder folder(std::string("fmu_") + fmu);
    folder.write("scene.toml",
                 scene_with(fmu_signal("osc", fmu, "outputs = [\"x\", \"v\"]\ninputs = { F = \"0\" }") +
                            "[[signals]]\nname = \"push\"\nkind = \"expression\"\ninput = \"1000 * signal.osc.x\"\n"));
    folder.done("run scene.toml --out run --quiet --trust-script");
    auto history = columns(folder, "run");
    const double w = std::sqrt(1e4 - 0.25);
    ASSERT_EQ(history["time"].size(), 101u);
    for (std::size_t k = 1; k < 101; ++k) {
      const double t = history["time"][k] - 1e-3;
      const double x = 0.01 * std::exp(-0.5 * t) * (std::cos(w * t) + 0.5 / w * std::sin(w * t));
      EXPECT_NEAR(history["signal.osc.x"][k], x, 1e-9) << t;  // digits of the file
      EXPECT_EQ(history["signal.osc"][k], history["signal.osc.x"][k]);
      EXPECT_NEAR(history["signal.push"][k], 1000 * x, 1e-6);
    }
  }
}

// Plant and controller, both FMUs, closed by the scene: a recurrence of their closed forms.
TEST(FmuScene, PlantAndControllerAreClosedThroughTheScene) {
  const Folder folder("fmu_loop");
  folder.write(
      "scene.toml",
      scene_with(
          fmu_signal("plant", "oscillator_3", "outputs = [\"x\"]\ninputs = { F = \"signal.pi\" }") +
              fmu_signal(
                  "pi", "controller_3",
                  "outputs = { u = \"u\" }\ninputs = { e = \"0.02 - signal.plant\" }\nstart = { kp = 3e3, ki = 2e5 }"),
          "signal = \"plant\""));
  folder.done("run scene.toml --out run --quiet --trust-script");
  auto history = columns(folder, "run");
  const double h = 1e-3, w = std::sqrt(1e4 - 0.25), c = std::cos(w * h), s = std::sin(w * h),
               decay = std::exp(-0.5 * h);
  double x = 0.01, v = 0.0, integral = 0.0, u = history["signal.pi"][1];
  for (std::size_t k = 1; k <= 100; ++k) {
    EXPECT_NEAR(history["signal.plant"][k], x, 1e-9);
    EXPECT_NEAR(history["signal.pi"][k], u, 1e-6);
    const double e = 0.02 - x, rest = u / 1e4, a = x - rest, b = (v + 0.5 * a) / w;
    integral += h * e;
    u = 3e3 * e + 2e5 * integral;
    x = rest + decay * (a * c + b * s);
    v = decay * ((b * w - 0.5 * a) * c - (a * w + 0.5 * b) * s);
  }
}

// A spring of kp in an FMU on 2 kg, by its controller u = kp e of e = -x: omega H = 1 ms sqrt(kp / 2 kg). Silent: below 0.1, for a slow
// approach to a velocity, and where the motion oscillates on a stiff spring of the scene while the FMU damps it little.
TEST(FmuScene, SpringsInFmusAreToldWhenTheirPeriodIsTooLong) {
  struct Case {
    double kp;
    std::string input, more;
    bool told;
  };
  const std::string stiff =
      "[[signals]]\nname = \"s\"\nkind = \"expression\"\ninput = \"-2e5 * block.x\"\n"
      "[[forces]]\nname = \"s\"\nbody = \"block\"\ndirection = [1, 0, 0]\nforce = { signal = \"s\" }\n";
  for (const Case& c : {Case{8e4, "-block.x", "", true}, Case{5e3, "-block.x", "", false},
                        Case{50.0, "1 - block.vx", "", false}, Case{1.0, "-block.vx", stiff, false}}) {
    const Folder folder("fmu_omega_h");
    std::ostringstream kp;
    kp << c.kp;
    folder.write("scene.toml", scene_with(fmu_signal("push", "controller_3",
                                                     "outputs = [\"u\"]\ninputs = { e = \"" + c.input +
                                                         "\" }\nstart = { kp = " + kp.str() + " }") +
                                          "[initial.joints]\nslider = 0.01\n" + c.more));
    const test::Outcome run = folder.done("run scene.toml --out run --quiet --trust-script");
    EXPECT_EQ(app::count(run.text, "W0668"), c.told ? 1 : 0) << run.text;
    if (c.told) {
      EXPECT_THAT(run.text, HasSubstr("on 2 (SI): omega H = 0.2 ")) << run.text;
    }
  }
}

TEST(FmuScene, ResumedRunHasTheSameBytes) {
  const Folder folder("fmu_resumed");
  folder.write("scene.toml", scene_with(fmu_signal("plant", "oscillator_3",
                                                   "outputs = [\"x\", \"v\"]\ninputs = { F = \"300 * block.x\" }") +
                                        fmu_signal("push", "controller_2",
                                                   "outputs = [\"u\"]\ninputs = { e = \"signal.plant - block.x\" }\n"
                                                   "start = { ki = 2e3 }")));
  folder.done("run scene.toml --out run --quiet --trust-script --set output.checkpoint_interval=0.0403");
  fs::copy(folder.file("run"), folder.file("straight"), fs::copy_options::recursive);
  std::map<long, fs::path> sets;
  for (const auto& entry : fs::directory_iterator(folder.file("run/checkpoint")))
    sets[std::stol(entry.path().filename())] = entry;
  ASSERT_EQ(sets.size(), 2u);
  fs::remove_all(sets.rbegin()->second);
  folder.refused("run --resume run --quiet", "E0279");
  folder.done("run --resume run --quiet --trust-script");
  EXPECT_TRUE(folder.read("run/history.csv") == folder.read("straight/history.csv"));
  EXPECT_EQ(app::lines_of(folder.read("run/history.csv")), app::lines_of(folder.read("straight/history.csv")));
}

TEST(FmuScene, IsNotRunWithoutTrust) {
  const Folder folder("fmu_trust");
  folder.write("scene.toml", scene_with(fmu_signal("push", "controller_3", "outputs = [\"u\"]")));
  folder.refused("run scene.toml --out run --quiet", "E0279");
  EXPECT_FALSE(folder.has("run"));
  const test::Outcome solver = folder.command(test::RunFolder::program("mbd_solver") + " scene.toml --out run", 60);
  EXPECT_EQ(solver.exit_code, 2);
  EXPECT_THAT(solver.text, HasSubstr("[E0279 "));
  folder.done("check scene.toml");
}

TEST(FmuScene, FailuresEndTheRun) {
  const Folder folder("fmu_failures");
  for (const int fault : {1, 2, 3, 4, 5, 6, 7, 9}) {
    const std::string run = "run_" + std::to_string(fault);
    folder.write("scene.toml",
                 scene_with(fmu_signal("push", "broken_3",
                                       "outputs = [\"y\"]\ntime_limit = 0.5\nstart = { when = 0.05, fault = " +
                                           std::to_string(fault) + " }")));
    const test::Outcome outcome = folder.footfall("run scene.toml --quiet --trust-script --out " + run);
    EXPECT_EQ(outcome.exit_code, 1) << fault << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("[E0350 ")) << fault;
    EXPECT_THAT(outcome.text, HasSubstr("signal \"push\"")) << fault;
    EXPECT_EQ(folder.summary(run)["status"], "failed");
    EXPECT_FALSE(app::holds(folder.read(run + "/history.csv"), "nan"));
  }
}

TEST(FmuScene, WithoutStateHasNoCheckpoints) {
  const Folder folder("fmu_stateless");
  folder.write("scene.toml", scene_with(fmu_signal("push", "broken_3", "outputs = [\"y\"]")));
  folder.refused("run scene.toml --out run --quiet --trust-script --set output.checkpoint_interval=0.04", "E0280");
  EXPECT_THAT(folder.done("run scene.toml --out run --quiet --trust-script").text, HasSubstr("[W1280 "));
}

TEST(FmuScene, CheckNamesEveryMistake) {
  const Folder folder("fmu_check");
  folder.write("empty.fmu", "no archive");
  const auto refused = [&](const std::string& signals, const std::string& code) {
    folder.write("scene.toml", scene_with(signals));
    folder.refused("check scene.toml", code);
  };
  const auto signal = [&](const std::string& keys) { return fmu_signal("push", "types_3", keys); };
  refused(signal("outputs = [\"Float64_ot\"]"), "E0274");
  refused(signal("outputs = [\"Float64_in\"]"), "E0275");
  refused(signal("outputs = [\"Float64_out\"]\ninputs = { Float64_out = \"1\" }"), "E0275");
  refused(signal("outputs = [\"array_out\"]"), "E0276");
  refused(signal("outputs = [\"array_out[4]\"]"), "E0276");
  refused(signal("outputs = [\"Float64_out[1]\"]"), "E0276");
  refused(signal("outputs = [\"Float64_out\"]\ninputs = { text = \"1\" }"), "E0275");
  refused(signal("outputs = [\"Float64_out\"]\nstart = { nothing = 1 }"), "E0274");
  refused(signal("outputs = [\"Float64_out\"]\nstart = { Int8_in = \"many\" }"), "E0104");
  refused(signal("outputs = [\"Float64_out\"]\ninputs = { Float64_in = \"1 +\" }"), "E0313");
  refused(signal("outputs = [\"Float64_out\"]\ninputs = { Float64_in = \"signal.none\" }"), "E0126");
  refused(signal("outputs = [\"array_out[1]\", \"array_out[1]\"]"), "E0120");
  refused(signal("inputs = {}"), "E0106");
  refused("[[signals]]\nname = \"push\"\nkind = \"fmu\"\nfile = \"empty.fmu\"\nperiod = 1\noutputs = [\"y\"]\n",
          "E0270");
  refused("[[signals]]\nname = \"push\"\nkind = \"fmu\"\nfile = \"none.fmu\"\nperiod = 1\noutputs = [\"y\"]\n",
          "E0108");
  EXPECT_EQ(app::count(folder.footfall("check scene.toml").text, "\\[E"), 1) << "one message";
  refused("[[signals]]\nname = \"push\"\nkind = \"fmu\"\nfile = \"empty.fmu\"\noutputs = [\"y\"]\n", "E0106");
  folder.write(
      "scene.toml",
      scene_with(signal("outputs = [\"array_out[2]\"]\ninputs = { \"array_in[2]\" = \"time\", Int8_in = 3 }")));
  folder.done("check scene.toml");
}

}  // namespace
}  // namespace footfall

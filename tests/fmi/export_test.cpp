// Scenes as FMUs: the rules of modelDescription.xml, runs by a small master (the host of FMUs), states, errors and early returns.

#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <thread>
#include <type_traits>

#include "mbd_solver/fmi/export/fmu_command.h"
#include "mbd_solver/fmi/fmi3_interface.h"
#include "mbd_solver/fmi/fmu_file.h"
#include "tests/app/programs.h"
#include "tests/fmi/asked_fmu.h"
#include "tests/fmi/led_fmu.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using app::Folder;
using test::exported;
using test::Interface;
using testing::HasSubstr;

// A mass of 1 kg on a slider, pushed by the importing program.
const std::string kMass = R"(title = "A mass & its <slider>"
end_time = 1.0
gravity = [0, 0, 0]
[[bodies]]
name = "block"
mass = 1.0
inertia = [0.1, 0.1, 0.2]
position = [0, 0, 0]
[[joints]]
name = "slider"
kind = "prismatic"
bodies = ["ground", "block"]
point = [0, 0, 0]
axis = "x"
[initial.joints]
slider = 0.01
[[signals]]
name = "F"
kind = "host"
initial = -100
[[forces]]
name = "push"
body = "block"
direction = [1, 0, 0]
force = { signal = "F" }
[solver]
rtol = 1e-9
)";
// k = 1e4 N/m and d = 1 N s/m, as a signal; a scene needs a body.
const std::string kSpring = R"(end_time = 1.0
gravity = [0, 0, 0]
[[bodies]]
name = "frame"
mass = 1.0
inertia = [0.1, 0.1, 0.2]
position = [0, 0, 0]
[[signals]]
name = "x"
kind = "host"
initial = 0.01
[[signals]]
name = "v"
kind = "host"
[[signals]]
name = "F"
kind = "expression"
input = "-1e4 * signal.x - 1 * signal.v"
)";

// An FMU in its host, as a small master uses it.
struct Slave : test::AskedFmu {
  Slave(const std::string& file, const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
        const std::vector<std::string>& more = {})
      : AskedFmu(file, words(inputs, outputs, more), 120.0) {}
  static std::vector<std::string> words(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                                        const std::vector<std::string>& more) {
    std::vector<std::string> all;
    for (const std::string& name : inputs) all.insert(all.end(), {"input", name});
    for (const std::string& name : outputs) all.insert(all.end(), {"output", name});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

// Error of x at 0.1 s of the pair in steps of h [s].
double error_of_pair(const std::string& mass, const std::string& spring, double h) {
  Slave a(mass, {"F"}, {"block.x", "block.vx"}), b(spring, {"x", "v"}, {"signal.F"});
  std::vector<double> motion = a.ask('I', {0.0, -100.0}), force = b.ask('I', {0.0, 0.01, 0.0});
  const long steps = std::lround(0.1 / h);
  for (long k = 0; k < steps; ++k) {
    const double t = h * static_cast<double>(k), next = h * static_cast<double>(k + 1);
    force = b.ask('S', {t, next, motion[0], motion[1]});  // of the motion at t, held
    motion = a.ask('S', {t, next, force[0]});
  }
  const double w = std::sqrt(1e4 - 0.25);
  return motion[0] - 0.01 * std::exp(-0.05) * (std::cos(w * 0.1) + 0.5 / w * std::sin(w * 0.1));
}

// An explicit exchange of first order: x = 10 mm exp(-0.5 t) cos(100 t) to the order of the step.
TEST(ExportedFmu, PairOfMassAndSpringIsExactToTheOrderOfTheStep) {
  const Folder folder("fmu_pair");
  const std::string mass = exported(folder, "mass", kMass), spring = exported(folder, "spring", kSpring);
  const double coarse = error_of_pair(mass, spring, 2e-4), fine = error_of_pair(mass, spring, 1e-4);
  EXPECT_LT(std::abs(fine), 1e-3) << "omega H = 0.01: the exchange feeds the motion by exp(omega^2 H t / 4)";
  EXPECT_NEAR(coarse / fine, 2.0, 0.3) << "first order, and a little of the second";
}

// ---- the C interface ----

// The same mass led by its interface, with the spring in the test: omega H = 0.2 is told, omega H = 0.02 is not.
TEST(ExportedFmu, TellsOfStepsThatAreTooLongForTheExchange) {
  const Folder folder("fmu_omega");
  const std::string file = exported(folder, "mass", kMass);
  for (const double h : {2e-3, 2e-4}) {
    Interface fmu(file, folder.file(h > 1e-3 ? "long" : "short"), false);
    ASSERT_EQ(fmu.begin(), fmi3OK) << fmu.log.text;
    for (int k = 0; k < 40; ++k) {
      fmu.set("F", -1e4 * fmu.get("block.x") - fmu.get("block.vx"));
      ASSERT_EQ(fmu.step(h * k, h), fmi3OK) << fmu.log.text;
    }
    EXPECT_EQ(app::holds(fmu.log.text, "[W1740 "), h > 1e-3) << fmu.log.text;
  }
}

// A mass alone under a constant force: x = x0 + F t^2 / (2 m), within the tolerance of the integrator.
TEST(ExportedFmu, MovesByItsClosedFormWithParametersAndStates) {
  const Folder folder("fmu_mass");
  const std::string file = exported(folder, "mass", kMass);
  const std::vector<std::string> outputs = {"block.x", "balance.energy", "time"};
  Slave slave(file, {"F"}, outputs, {"start", "bodies.block.mass", "4", "start", "end_time", "3"});
  EXPECT_NEAR(slave.ask('I', {0.0, 8.0})[0], 0.01, 1e-12);
  slave.ask('S', {0.0, 0.5, 8.0});
  const std::string state = slave.raw('G', {});
  ASSERT_EQ(state[0], 'B');
  const std::vector<double> end = slave.ask('S', {0.5, 2.0, 8.0});
  EXPECT_NEAR(end[0], 0.01 + 8.0 / 4.0 * 2.0 * 2.0 / 2.0, 1e-7);
  EXPECT_LT(std::abs(end[1]), 1e-6);
  EXPECT_EQ(end[2], 2.0);
  Slave other(file, {"F"}, outputs, {"start", "bodies.block.mass", "4", "start", "end_time", "3"});
  other.ask('R', {0.5, 8.0}, state.substr(1));
  EXPECT_NEAR(other.ask('S', {0.5, 2.0, 8.0})[0], end[0], 1e-9);
}

// The rules that a validator of FMI 3.0 holds a description against.
TEST(ExportedFmu, DescriptionKeepsTheRulesOfTheStandard) {
  const Folder folder("fmu_rules");
  const std::string file = exported(folder, "mass", kMass, "--set output.interval=5");  // longer than the scene
  fs::create_directory(folder.file("unpacked"));
  unpack_fmu(file, folder.file("unpacked"));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file(folder.file("unpacked/modelDescription.xml").c_str()));
  const pugi::xml_node root = document.child("fmiModelDescription");
  for (const char* required : {"fmiVersion", "modelName", "instantiationToken"})
    EXPECT_NE(root.attribute(required).as_string()[0], 0) << required;
  EXPECT_EQ(std::string(root.attribute("fmiVersion").value()), "3.0");
  const std::string identifier = root.child("CoSimulation").attribute("modelIdentifier").value();
  EXPECT_THAT(identifier, testing::MatchesRegex("[A-Za-z_][A-Za-z0-9_]*")) << "the name of a C function begins with it";
  const pugi::xml_node experiment = root.child("DefaultExperiment");
  const double start = experiment.attribute("startTime").as_double(),
               stop = experiment.attribute("stopTime").as_double();
  EXPECT_LT(start, stop);
  EXPECT_GT(experiment.attribute("stepSize").as_double(), 0.0);
  EXPECT_LT(experiment.attribute("stepSize").as_double(), stop - start);
  std::set<std::string> categories;
  for (const pugi::xml_node& category : root.child("LogCategories"))
    EXPECT_TRUE(categories.insert(category.attribute("name").value()).second);
  EXPECT_EQ(categories.count("logStatusError"), 1u);
  EXPECT_EQ(std::string(root.attribute("description").value()), "A mass & its <slider>");
  EXPECT_TRUE(
      fs::exists(folder.file("unpacked/binaries/x86_64-linux/" +
                             std::string(root.child("CoSimulation").attribute("modelIdentifier").value()) + ".so")));
  std::set<std::string> units, names, references, listed;
  for (const pugi::xml_node& unit : root.child("UnitDefinitions")) {
    EXPECT_TRUE(units.insert(unit.attribute("name").value()).second);
    EXPECT_TRUE(unit.child("BaseUnit")) << unit.attribute("name").value();
  }
  std::map<std::string, std::string> causality_of;
  int independents = 0;
  for (const pugi::xml_node& v : root.child("ModelVariables")) {
    const std::string name = v.attribute("name").value(), causality = v.attribute("causality").value();
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(references.insert(v.attribute("valueReference").value()).second) << name;
    if (v.attribute("unit")) {
      EXPECT_EQ(units.count(v.attribute("unit").value()), 1u) << name;
    }
    const bool starts = causality == "input" || causality == "parameter";
    EXPECT_EQ(!v.attribute("start").empty(), starts) << name;
    std::istringstream values(v.attribute("start").value());
    const auto count = std::distance(std::istream_iterator<std::string>(values), std::istream_iterator<std::string>());
    if (starts) {
      EXPECT_EQ(count, v.child("Dimension") ? v.child("Dimension").attribute("start").as_int() : 1) << name;
    }
    const std::string initial = v.attribute("initial").value(), variability = v.attribute("variability").value();
    EXPECT_EQ(initial, causality == "output" ? "calculated" : causality == "parameter" ? "exact" : "") << name;
    if (causality != "parameter") {
      EXPECT_EQ(variability, "continuous") << name;
    }
    if (causality == "parameter") {
      EXPECT_EQ(std::string(v.attribute("variability").value()), "fixed") << name;
    }
    independents += causality == "independent" ? 1 : 0;
    causality_of[v.attribute("valueReference").value()] = causality;
  }
  EXPECT_EQ(independents, 1);
  for (const char* name : {"F", "block.x", "bodies.block.mass", "balance.energy"})
    EXPECT_EQ(names.count(name), 1u) << name;
  for (const char* element : {"Output", "InitialUnknown"}) {
    listed.clear();
    for (const pugi::xml_node& node : root.child("ModelStructure").children(element))
      listed.insert(node.attribute("valueReference").value());
    for (const auto& [reference, causality] : causality_of)
      EXPECT_EQ(listed.count(reference), causality == "output" ? 1u : 0u) << element << " " << reference;
  }
}

TEST(ExportedFmu, UnitsHaveTheirBaseUnits) {
  using Map = std::map<std::string, int>;
  EXPECT_EQ(base_units("m/s2"), (Map{{"m", 1}, {"s", -2}}));
  EXPECT_EQ(base_units("N m s/rad"), (Map{{"kg", 1}, {"m", 2}, {"s", -1}, {"rad", -1}}));
  EXPECT_EQ(base_units("kg m2"), (Map{{"kg", 1}, {"m", 2}}));
  EXPECT_EQ(base_units("1/s"), (Map{{"s", -1}}));
  EXPECT_EQ(base_units("furlong"), Map{});
}

TEST(ExportedFmu, RefusesBadCallsAndKeepsItsState) {
  const Folder folder("fmu_calls");
  Interface fmu(exported(folder, "mass", kMass), folder.file("unpacked"), false);
  ASSERT_NE(fmu.instance, nullptr) << fmu.log.text;
  EXPECT_EQ(fmu.step(0.0, 0.1), fmi3Error) << "not initialized";
  EXPECT_EQ(fmu.set("bodies.block.mass", -1.0), fmi3OK) << "the scene is checked when it is made";
  EXPECT_EQ(fmu.begin(), fmi3Error);
  EXPECT_THAT(fmu.log.text, HasSubstr("bodies.block.mass"));
  ASSERT_EQ(fmu.mode("fmi3Reset"), fmi3OK);
  ASSERT_EQ(fmu.begin(), fmi3OK) << fmu.log.text;
  ASSERT_EQ(fmu.step(0.0, 0.1), fmi3OK) << fmu.log.text;
  const double x = fmu.get("block.x");
  EXPECT_NEAR(x, 0.01 - 100.0 * 0.01 / 2.0, 1e-8);
  EXPECT_EQ(fmu.set("F", std::nan("")), fmi3Error);
  EXPECT_EQ(fmu.set("F", std::numeric_limits<double>::infinity()), fmi3Error);
  EXPECT_EQ(fmu.get("F"), -100.0);
  EXPECT_EQ(fmu.set("block.x", 1.0), fmi3Error);
  EXPECT_EQ(fmu.set("bodies.block.mass", 2.0), fmi3Error);
  EXPECT_EQ(fmu.step(0.3, 0.1), fmi3Error) << "the model is at 0.1 s";
  EXPECT_EQ(fmu.step(0.1, -0.1), fmi3Error);
  EXPECT_EQ(fmu.get("block.x"), x);
  // States that are none, or hold nothing, and times that are none.
  const auto call = [&](const char* name, auto* type, auto... values) {
    return fmu.library().function<std::remove_pointer_t<decltype(type)>>(name)(fmu.instance, values...);
  };
  constexpr fmi3SetFMUStateTYPE* kSet = nullptr;
  constexpr fmi3GetFMUStateTYPE* kGet = nullptr;
  constexpr fmi3DeserializeFMUStateTYPE* kRead = nullptr;
  EXPECT_EQ(call("fmi3SetFMUState", kSet, nullptr), fmi3Error);
  EXPECT_EQ(call("fmi3GetFMUState", kGet, nullptr), fmi3Error);
  const std::array<fmi3Byte, 4 * sizeof(double)> nothing{};
  fmi3FMUState state = nullptr;
  EXPECT_EQ(call("fmi3DeserializeFMUState", kRead, nothing.data(), std::size_t{7}, &state), fmi3Error);
  ASSERT_EQ(call("fmi3DeserializeFMUState", kRead, nothing.data(), nothing.size(), &state), fmi3OK);
  EXPECT_EQ(call("fmi3SetFMUState", kSet, state), fmi3Error);
  EXPECT_EQ(call("fmi3FreeFMUState", kGet, &state), fmi3OK);
  EXPECT_EQ(fmu.get("block.x"), x);
  EXPECT_EQ(fmu.step(0.1, 0.1), fmi3OK) << fmu.log.text;
  EXPECT_EQ(fmu.mode("fmi3Terminate"), fmi3OK);
  ASSERT_EQ(fmu.mode("fmi3Reset"), fmi3OK);
  constexpr fmi3EnterInitializationModeTYPE* kEnter = nullptr;
  for (const double start : {std::nan(""), std::numeric_limits<double>::infinity(), 2.0})
    EXPECT_EQ(call("fmi3EnterInitializationMode", kEnter, false, 0.0, start, true, 1.0), fmi3Error) << start;
}

// The program of the model, which this test process has started.
pid_t program_of_model() {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    std::ifstream file(entry.path() / "stat");
    std::string id, program, state;
    pid_t parent = 0;
    if (std::isdigit(static_cast<unsigned char>(name[0])) == 0 || !(file >> id >> program >> state >> parent)) continue;
    if (parent == getpid() && program == "(footfall_fmu_mo)" && state != "Z") return std::stoi(id);
  }
  return 0;
}

TEST(ExportedFmu, StartsItsProgramAgainAfterAReset) {
  const Folder folder("fmu_died");
  Interface fmu(exported(folder, "mass", kMass), folder.file("unpacked"), false);
  const auto kill_program = [] {
    const pid_t program = program_of_model();
    ASSERT_GT(program, 0);
    kill(program, SIGKILL);
  };
  const double x = 0.01 - 100.0 * 0.01 / 2.0;  // at 0.1 s
  for (const bool steps : {true, false}) {     // it dies in use, and between a step and the reset
    ASSERT_EQ(fmu.begin(), fmi3OK) << fmu.log.text;
    ASSERT_EQ(fmu.step(0.0, 0.1), fmi3OK) << fmu.log.text;
    kill_program();
    if (steps) {
      EXPECT_EQ(fmu.step(0.1, 0.1), fmi3Error);
      EXPECT_THAT(fmu.log.text, HasSubstr("signal 9"));
      EXPECT_EQ(fmu.step(0.1, 0.1), fmi3Error) << "there is no program";
    }
    ASSERT_EQ(fmu.mode("fmi3Reset"), fmi3OK);
  }
  ASSERT_EQ(fmu.begin(), fmi3OK) << fmu.log.text;
  ASSERT_EQ(fmu.step(0.0, 0.1), fmi3OK) << fmu.log.text;
  EXPECT_NEAR(fmu.get("block.x"), x, 1e-8);

  // A saved state brings the simulation back as well.
  fmi3FMUState state = nullptr;
  ASSERT_EQ(fmu.library().function<fmi3GetFMUStateTYPE>("fmi3GetFMUState")(fmu.instance, &state), fmi3OK);
  kill_program();
  EXPECT_EQ(fmu.step(0.1, 0.1), fmi3Error);
  ASSERT_EQ(fmu.library().function<fmi3SetFMUStateTYPE>("fmi3SetFMUState")(fmu.instance, state), fmi3OK)
      << fmu.log.text;
  EXPECT_NEAR(fmu.get("block.x"), x, 1e-8);
  EXPECT_EQ(fmu.step(0.1, 0.1), fmi3OK) << fmu.log.text;
  EXPECT_EQ(fmu.library().function<fmi3GetFMUStateTYPE>("fmi3FreeFMUState")(fmu.instance, &state), fmi3OK);

  // Without its program a new one cannot be started.
  ASSERT_EQ(fmu.mode("fmi3Reset"), fmi3OK);
  fs::remove(folder.file("unpacked/resources/bin/footfall_fmu_model"));
  EXPECT_EQ(fmu.begin(), fmi3Error);
}

// Free fall to z = -0.5 m switches the state at t = sqrt(2 0.5 / 9.81).
TEST(ExportedFmu, ReturnsEarlyAtEvents) {
  const Folder folder("fmu_events");
  const std::string scene =
      "end_time = 1\n[[bodies]]\nname = \"ball\"\nmass = 1\ninertia = [1, 1, 1]\nposition = [0, 0, 0]\n"
      "[[states]]\nname = \"flight\"\n[[states]]\nname = \"low\"\n"
      "[[events]]\nname = \"pass\"\nwhen = \"ball.z < -0.5\"\nto = \"low\"\n";
  const std::string file = exported(folder, "fall", scene);
  const double instant = std::sqrt(1.0 / 9.81);
  Interface fmu(file, folder.file("early"), true);
  ASSERT_EQ(fmu.begin(), fmi3OK) << fmu.log.text;
  ASSERT_EQ(fmu.step(0.0, 0.5), fmi3OK) << fmu.log.text;
  EXPECT_TRUE(fmu.early);
  EXPECT_NEAR(fmu.last, instant, 1e-6);
  EXPECT_EQ(fmu.get("state.low"), 1.0);
  ASSERT_EQ(fmu.step(fmu.last, 0.5 - fmu.last), fmi3OK) << fmu.log.text;
  EXPECT_FALSE(fmu.early);
  EXPECT_NEAR(fmu.get("ball.z"), -9.81 * 0.125, 1e-6);
  Interface whole(file, folder.file("whole"), false);
  ASSERT_EQ(whole.begin(), fmi3OK);
  ASSERT_EQ(whole.step(0.0, 0.5), fmi3OK);
  EXPECT_FALSE(whole.early);
  EXPECT_NEAR(whole.get("ball.z"), -9.81 * 0.125, 1e-6);
}

TEST(ExportedFmu, CommandRefusesWhatItCannotDo) {
  const Folder folder("fmu_refused");
  folder.write("mass.toml", kMass);
  folder.refused("fmu mass.toml --out nowhere/mass.fmu", "E0743");
}

// Importing programs make instances in threads that end.
TEST(ExportedFmu, OutlivesTheThreadThatMadeIt) {
  const Folder folder("fmu_threads");
  const std::string file = exported(folder, "fall", R"(end_time = 1
[[bodies]]
name = "ball"
mass = 1
inertia = [1, 1, 1]
position = [0, 0, 0]
)");
  std::unique_ptr<Interface> fmu;
  std::thread([&] { fmu = std::make_unique<Interface>(file, folder.file("unpacked"), false); }).join();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ASSERT_EQ(fmu->begin(), fmi3OK) << fmu->log.text;
  ASSERT_EQ(fmu->step(0.0, 0.1), fmi3OK) << fmu->log.text;
  EXPECT_NEAR(fmu->get("ball.z"), -0.5 * 9.81 * 0.01, 1e-6);
}

// F = 2 t at samples of 0.1 s, by a Python file next to the scene.
TEST(ExportedFmu, CarriesProgramsOfTheSceneWhereTheyAreTrusted) {
  const Folder folder("fmu_trusted");
  folder.write("ramp.py", "def ramp(time):\n    return 2 * time\n");
  const std::string scene = R"(end_time = 1
[[bodies]]
name = "ball"
mass = 1
inertia = [1, 1, 1]
position = [0, 0, 0]
[[signals]]
name = "F"
kind = "python"
file = "ramp.py"
function = "ramp"
stateless = true
period_ms = 100
)";
  folder.write("ball.toml", scene);
  folder.refused("fmu ball.toml --out ball.fmu", "E0279");
  Interface fmu(exported(folder, "ball", scene, "--trust-script"), folder.file("unpacked"), false);
  fs::remove(folder.file("ramp.py"));
  ASSERT_EQ(fmu.begin(), fmi3OK) << fmu.log.text;
  ASSERT_EQ(fmu.step(0.0, 0.55), fmi3OK) << fmu.log.text;
  EXPECT_NEAR(fmu.get("signal.F"), 1.0, 1e-12);
}

// A mechanism alone becomes an FMU; grains are led from Python.
TEST(ExportedFmu, IsRefusedForASceneOnGrains) {
  const Folder folder("fmu_grains");
  folder.write("plate.toml", "base = \"" + app::kPlate + "/scene.toml\"\n");
  folder.refused("fmu plate.toml --out plate.fmu", "E0720");
}

}  // namespace
}  // namespace footfall

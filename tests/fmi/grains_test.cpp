// Scenes on grains as FMUs: the coupled pair is led through the C interface, and is gone afterwards, however that ends.

#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/fmi/asked_fmu.h"
#include "tests/fmi/led_fmu.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using app::Folder;
using test::exported;
using test::Interface;
using testing::HasSubstr;

// The plate of 1 kg above four grains, at -1 m/s, pushed by the importing program along z.
const std::string kPushedPlate = "base = \"" + app::kPlate + R"(/scene.toml"
[[signals]]
name = "F"
kind = "host"
[[forces]]
name = "push"
body = "plate"
direction = [0, 0, 1]
force = { signal = "F" }
)";

// Processes whose program is below this folder.
std::vector<pid_t> programs_below(const std::string& folder, const std::string& name = "") {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string id = entry.path().filename().string();
    if (id.find_first_not_of("0123456789") != std::string::npos) continue;
    std::error_code none;
    const fs::path program = fs::read_symlink(entry.path() / "exe", none);
    if (none || program.string().rfind(folder, 0) != 0 || (!name.empty() && program.filename() != name)) continue;
    found.push_back(std::stoi(id));
  }
  return found;
}

// Temporary files of the runs go below the folder of the test.
struct Temporary {
  explicit Temporary(const Folder& folder) : path(folder.file("tmp")) {
    fs::create_directory(path);
    setenv("TMPDIR", path.c_str(), 1);
  }
  ~Temporary() { unsetenv("TMPDIR"); }
  bool empty() const {
    for (const auto& entry : fs::directory_iterator(path))
      if (entry.path().filename().string().rfind("footfall-", 0) == 0) return false;
    return true;
  }
  std::string path;
};

template <class Condition>
bool comes_true(Condition condition, int seconds) {
  for (int k = 0; k < 10 * seconds; ++k) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return condition();
}

// Above the grains a force F moves the plate by v = v0 + (F/m - g) t. Values stand at the end of a coupling interval of 5 steps of
// 1e-4 s, which may be beyond the communication point, so v may differ by 0.5 ms * |a| = 0.015 m/s.
TEST(FmuOnGrains, IsLedByInputsAndLeavesNothing) {
  const Folder folder("fmu_grains");
  const Temporary temporary(folder);
  const std::string file = exported(folder, "plate", kPushedPlate);
  Interface fmu(file, folder.file("un packed"), false);
  ASSERT_NE(fmu.instance, nullptr) << fmu.log.text;
  EXPECT_EQ(fmu.set("particles.ranks", 2.0), fmi3OK);
  EXPECT_EQ(fmu.set("initial.velocity", -0.5), fmi3Error) << "three numbers are expected";
  ASSERT_EQ(fmu.begin(), fmi3OK) << fmu.log.text;
  EXPECT_EQ(programs_below(folder.file("un packed"), "liggghts_mbd").size(), 2u);
  EXPECT_EQ(fmu.get("plate.vz"), -1.0);
  fmu.set("F", -20.0);
  for (int k = 0; k < 4; ++k) ASSERT_EQ(fmu.step(1e-3 * k, 1e-3), fmi3OK) << fmu.log.text;
  EXPECT_EQ(fmu.last, 4e-3);
  EXPECT_EQ(fmu.get("time"), 4e-3);
  EXPECT_NEAR(fmu.get("plate.vz"), -1.0 - (9.81 + 20.0) * 4e-3, 0.016);
  fmi3FMUState state = nullptr;
  EXPECT_EQ(fmu.library().function<fmi3GetFMUStateTYPE>("fmi3GetFMUState")(fmu.instance, &state), fmi3Error);
  EXPECT_THAT(fmu.log.text, HasSubstr("[E0747 "));
  ASSERT_EQ(fmu.step(4e-3, 0.026), fmi3OK) << fmu.log.text;
  EXPECT_GT(std::abs(fmu.get("work.contact")), 0.0) << "it has touched the grains";
  EXPECT_LT(std::abs(fmu.get("balance.energy")), 1e-2);
  ASSERT_EQ(fmu.step(0.03, 1.0), fmi3OK) << fmu.log.text;
  EXPECT_TRUE(fmu.ends) << "the scene ends at 0.05 s";
  EXPECT_NEAR(fmu.last, 0.05, 1e-9);
  EXPECT_EQ(fmu.mode("fmi3Terminate"), fmi3OK);
  EXPECT_EQ(programs_below(folder.file("un packed"), "mbd_solver").size(), 0u);
  EXPECT_EQ(programs_below(folder.file("un packed"), "liggghts_mbd").size(), 0u);
  EXPECT_TRUE(temporary.empty());
}

// The state changes at the first contact; a coupling interval is 0.5 ms.
TEST(FmuOnGrains, ReturnsEarlyAtEvents) {
  const Folder folder("fmu_grains_events");
  const Temporary temporary(folder);
  const std::string file = exported(folder, "plate", kPushedPlate + R"(
[[states]]
name = "flight"
[[states]]
name = "stands"
[[events]]
name = "touch"
when = "plate.contact.fz > 1"
to = "stands"
)");
  Interface fmu(file, folder.file("unpacked"), true);
  ASSERT_EQ(fmu.begin(), fmi3OK) << fmu.log.text;
  ASSERT_EQ(fmu.step(0.0, 0.04), fmi3OK) << fmu.log.text;
  EXPECT_TRUE(fmu.early);
  EXPECT_LT(fmu.last, 0.04);
  EXPECT_EQ(fmu.get("state.stands"), 1.0);
  EXPECT_LE(fmu.get("state.since"), 1.01e-3) << "at most the intervals of the event and of its observation";
  ASSERT_EQ(fmu.step(fmu.last, 0.04 - fmu.last), fmi3OK) << fmu.log.text;
  EXPECT_FALSE(fmu.early);
  EXPECT_EQ(fmu.last, 0.04);
}

TEST(FmuOnGrains, FailsWithAMessageWhenAProgramIsKilled) {
  const Folder folder("fmu_grains_killed");
  const Temporary temporary(folder);
  const std::string file = exported(folder, "plate", kPushedPlate);
  {
    Interface fmu(file, folder.file("unpacked"), false);
    ASSERT_EQ(fmu.begin(), fmi3OK) << fmu.log.text;
    ASSERT_EQ(fmu.step(0.0, 1e-3), fmi3OK) << fmu.log.text;
    const double z = fmu.get("plate.z");
    const std::vector<pid_t> grains = programs_below(folder.file("unpacked"), "liggghts_mbd");
    ASSERT_EQ(grains.size(), 1u);
    kill(grains[0], SIGKILL);
    EXPECT_EQ(fmu.step(1e-3, 0.03), fmi3Error);
    EXPECT_THAT(fmu.log.text, HasSubstr("[E"));
    EXPECT_EQ(fmu.get("plate.z"), z);
    EXPECT_EQ(fmu.get("time"), 1e-3);
  }
  EXPECT_EQ(programs_below(folder.file("unpacked")).size(), 0u);
  EXPECT_TRUE(temporary.empty());
}

// The importing program is the host of FMUs here.
TEST(FmuOnGrains, ProgramsEndWithTheImportingProgram) {
  const Folder folder("fmu_grains_importer");
  const Temporary temporary(folder);
  const std::string file = exported(folder, "plate", kPushedPlate);
  pid_t importer = 0;
  try {
    test::AskedFmu fmu(file, {"input", "F", "output", "plate.z"}, 120.0);
    fmu.ask('I', {0.0, 0.0});
    fmu.ask('S', {0.0, 1e-3, 0.0});
    for (const pid_t pid : programs_below(fs::path(FMU_HOST).string())) {
      std::ifstream line("/proc/" + std::to_string(pid) + "/environ");  // TMPDIR is a folder of this test
      const std::string words{std::istreambuf_iterator<char>(line), {}};
      if (words.find(folder.file("")) != std::string::npos) importer = pid;
    }
    ASSERT_GT(importer, 0);
    EXPECT_FALSE(temporary.empty());
    kill(importer, SIGKILL);
    fmu.ask('S', {1e-3, 2e-3, 0.0});
    FAIL() << "an answer of a killed program";
  } catch (const std::exception&) {
  }
  EXPECT_TRUE(comes_true([&] { return temporary.empty(); }, 60)) << "the pair removes its folder at its end";
}

// Importing programs make instances in threads that end.
TEST(FmuOnGrains, OutlivesTheThreadThatMadeIt) {
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

// F = 2 t at samples of 0.1 s, by a Python file beside the scene.
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

}  // namespace
}  // namespace footfall

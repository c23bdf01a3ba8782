// Every way to fail ends both programs soon, with a message that says what is wrong, and leaves no process
// behind.

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "coupler/messages.h"
#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

constexpr int kLimit = 30;      // hanging is failing [s]
constexpr double kSoon = 10.0;  // [s]

struct Case {
  std::string name;
  int exit_code;                  // of both programs; 0: any other
  std::vector<std::string> says;  // all of these appear
  std::string script;             // after the bed and the mesh; empty: couple and run
  std::string partner = "until 0.01";
  std::string mesh = "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n";
  std::string body = " body plate plate.stl 0 0 0.24 prescribed 0 0 -1.0 0 0 0";
};

const std::string kCouple = "fix mbd all couple/mbd every 5 mesh m plate\n";

// How gtest shows a case.
void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&all](Case one) { all.push_back(std::move(one)); };
  // The partner misbehaves.
  add({"ForeignProtocol",
       2,
       {"liggghts_mbd: ERROR: message Geometry: the partner speaks protocol version " +
            std::to_string(kProtocolVersion + 998) + ", this program version " + std::to_string(kProtocolVersion),
        "scripted_partner: ERROR: liggghts_mbd stopped: message Geometry"},
       "",
       "until 0.01 misbehave version"});
  add({"PartnerFails",
       1,
       {"scripted_partner: ERROR: the spring of the test broke",
        "liggghts_mbd: ERROR: mbd_solver stopped: the spring of the test broke"},
       "",
       "until 0.01 misbehave fail 7"});
  add({"PartnerIsKilled", 0, {}, "", "until 0.01 misbehave die 7"});
  add({"PartnerLeavesWithoutAWord", 0, {}, "", "until 0.01 misbehave lose 7"});
  add({"PartnerSendsAnotherWindow",
       2,
       {"window 7: mbd_solver sent a Motion for window 14"},
       "",
       "until 0.01 misbehave wrong-window 7"});
  add({"PartnerSendsNotANumber",
       1,
       {"the motion of body \"plate\" at t = 0.00175 s is not finite"},
       "",
       "until 0.01 misbehave not-a-number 7"});
  add({"PartnerHangs",
       1,
       {"liggghts_mbd: ERROR: mbd_solver has said nothing for 1"},
       "fix mbd all couple/mbd every 5 patience 1.0 mesh m plate\nrun 200\n",
       "until 0.01 misbehave hang 7"});
  add({"PartnerIsInterrupted",
       3,
       {"liggghts_mbd: ERROR: mbd_solver was interrupted: stopped by hand"},
       "",
       "until 0.01 misbehave interrupt 7"});
  // The script is wrong.
  add({"UnknownBody",
       2,
       {"the scene has no body \"plato\"", "Known bodies: plate.", "Did you mean \"plate\"?"},
       "fix mbd all couple/mbd every 5 mesh m plato\nrun 200\n"});
  add({"UnknownMesh",
       2,
       {"mesh mm: no fix mesh/surface of this id"},
       "fix mbd all couple/mbd every 5 mesh mm plate\nrun 200\n"});
  add({"BadNumberOfSteps",
       2,
       {"`every` needs a number of steps", "not \"5x\""},
       "fix mbd all couple/mbd every 5x mesh m plate\nrun 200\n"});
  add({"WrongKeyword",
       2,
       {"at \"mash\" (did you mean \"mesh\"?) expected: fix ID all couple/mbd"},
       "fix mbd all couple/mbd every 5 mash m plate\nrun 200\n"});
  add({"MeshCoupledTwice",
       2,
       {"mesh m: it belongs to body \"plate\" already"},
       "fix mbd all couple/mbd every 5 mesh m plate mesh m plate\nrun 200\n"});
  add({"TwoMeshesOfTheSameTriangles",
       2,
       {"meshes m and n hold the same triangle of body \"plate\""},
       "fix n all mesh/surface file plate.stl type 2 move 0 0 0.24\n"
       "fix mbd all couple/mbd every 5 mesh m plate mesh n plate\nrun 200\n"});
  add({"NothingCoupled", 2, {"no body to couple"}, "fix mbd all couple/mbd every 5\nrun 200\n"});
  add({"MeshMovedByAnother",
       2,
       {"mesh m: another fix or a servo moves it already"},
       "fix c all move/mesh mesh m linear 0 0 1\n" + kCouple + "run 200\n"});
  add({"SurfaceVelocityThatVaries",
       2,
       {"its surface velocity is a variable"},
       kCouple + "run 200\n",
       "until 0.01",
       "variable belt equal 1+step\nfix m all mesh/surface file plate.stl type 2 move 0 0 0.24 surface_vel v_belt 0 "
       "0\n"});
  add({"MeshOfAnotherPlace",
       2,
       {"is no node of body \"plate\" at its initial pose"},
       "",
       "until 0.01",
       "fix m all mesh/surface file plate.stl type 2 move 0 0 0.25\n"});
  add({"MeshOfAnotherBody",
       2,
       {"joins nodes of body \"plate\" that form no triangle there"},
       "",
       "until 0.01",
       "fix m all mesh/surface file coarse.stl type 2 move 0 0 0.24\n"});
  add({"MeshOfHalfABody",
       2,
       {"mesh m has 54 triangles, body \"plate\" of the scene has 108"},
       "",
       "until 0.01",
       "fix m all mesh/surface file half.stl type 2 move 0 0 0.24\n"});
  add({"BodyInMillimetres",
       2,
       {"leaves the simulation box", "The body measures 300 x 300 x 20 m: that looks like millimetres"},
       kCouple + "run 200\n",
       "until 0.01",
       "fix geo all couple/mbd/geometry body plate\nfix m all mesh/surface fix geo type 2\n",
       " body plate millimetres.stl 0 0 0.24 prescribed 0 0 -1.0 0 0 0"});
  add({"CouplingTakenAway",
       2,
       {"unfix mbd: takes the coupling away at t = 0.005 s", "end script"},
       kCouple + "run 100\nunfix mbd\nrun 100\n"});
  add({"MeshReplaced",
       2,
       {"mesh m was removed by `unfix`"},
       kCouple + "run 100\nunfix wm\nunfix m\nfix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n" +
           mesh_wall() + "run 100\n"});
  add({"MeshRemovedAndThenTheCoupling",
       2,
       {"unfix mbd: takes the coupling away"},
       kCouple + "run 10\nunfix wm\nunfix m\nunfix mbd\nrun 10\n"});
  add({"GravityChanges",
       2,
       {"the gravity of the grains changed from (0, 0, -9.81) to (0, 0, 9.81) m/s2"},
       kCouple + "run 100\nunfix grav\nfix grav all gravity 9.81 vector 0 0 1\nrun 100\n"});
  add({"AllGrainsLost",
       1,
       {"grains have left the box", "allows a share of 0.05"},
       "velocity all set 0 0 100\nthermo_modify lost ignore\n" + kCouple + "run 2000\n",
       "until 0.1",
       "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n",
       " body plate plate.stl 0 0 0.24 prescribed 0 0 0 0 0 0"});
  add({"BodyGoesThroughTheFloor",
       1,
       {"body \"plate\" goes through the wall of fix floor", "this one is the floor under the body"},
       "region all block INF INF INF INF INF INF units box\ndelete_atoms region all\n"
       "create_atoms 1 single 0.25 0.25 0.1\nset group all diameter 0.04 density 2600\n" +
           kCouple + "run 2000\n",
       "until 0.1",
       "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n",
       " body plate plate.stl 0 0 0.24 prescribed 0 0 -4.0 0 0 0"});
  add({"BadPatience",
       2,
       {"`patience` needs a positive number of seconds, not \"-1\""},
       "fix mbd all couple/mbd every 5 patience -1 mesh m plate\nrun 200\n"});
  add({"MeshLeavesTheBox",
       1,
       {"mesh m (body \"plate\"), at step 351, leaves the simulation box: node at",
        "Make the region of create_box larger"},
       kCouple + "run 20000\n",
       "until 1.0",
       "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n",
       " body plate plate.stl 0 0 0.24 prescribed 0 0 20.0 0 0 0"});
  add({"TimeStepChanges",
       2,
       {"the time step changed from 5e-05 to 4e-05 s"},
       kCouple + "run 100\ntimestep 4e-5\nrun 100\n"});
  add({"VerboseTiming", 2, {"modify_timing verbose"}, "modify_timing verbose\n" + kCouple + "run 200\n"});
  add({"SecondCoupling",
       2,
       {"there is one already"},
       kCouple + "fix mbd2 all couple/mbd every 5 mesh m plate\nrun 200\n"});
  add({"MeshRemoved", 2, {"mesh m was removed by `unfix`"}, kCouple + "run 100\nunfix wm\nunfix m\nrun 100\n"});
  add({"ScriptEndsTooEarly",
       2,
       {"the LIGGGHTS script ended at t = 0.005 s, before the end of the scene at t = 0.01 s",
        "`run` at least 200 steps in all", "scripted_partner: ERROR: liggghts_mbd stopped"},
       kCouple + "run 100\n"});
  add({"ScriptGoesOnTooLong",
       2,
       {"the scene ended at t = 0.01 s, and the script wants to go on"},
       kCouple + "run 200\nrun 10\n"});
  add({"ScriptNeverCouples", 2, {"ended without running `fix couple/mbd`"}, "run 10\n"});
  add({"ScriptNamesButNeverRuns", 2, {"ended without running `fix couple/mbd`"}, kCouple});
  add({"ScriptErrorBeforeTheHandshake",
       1,
       {"ERROR: Unknown command: no_such_command", "LIGGGHTS ended with an error of its own"},
       "no_such_command\n"});
  add({"ScriptErrorInTheMiddle",
       1,
       {"ERROR: Unknown command: no_such_command", "LIGGGHTS ended with an error of its own"},
       kCouple + "run 100\nno_such_command\n"});
  add({"LiggghtsAborts", 1, {"random seed"}, kCouple + "run 100\ndisplace_atoms all random 0 0 0 12345 units box\n"});
  return all;
}

class Failure : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Of, Failure, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& one) { return one.param.name; });

// Processes whose working folder is this one.
int processes_in(const std::filesystem::path& folder) {
  int found = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::error_code ignored;
    if (std::filesystem::read_symlink(entry.path() / "cwd", ignored) == folder) ++found;
  }
  return found;
}

// The same once mpirun is gone: the system may take a moment to bury the processes that it has killed.
int processes_left_in(const std::filesystem::path& folder) {
  constexpr auto kMoment = std::chrono::milliseconds(20);
  for (int moments = 250; moments > 0 && processes_in(folder) > 0; --moments) std::this_thread::sleep_for(kMoment);
  return processes_in(folder);
}

TEST_P(Failure, IsToldByBothSidesAndEndsThem) {
  const Case& one = GetParam();
  const RunFolder folder("failures_" + one.name);
  write_stl((folder.path() / "plate.stl").string(), box({0.3, 0.3, 0.02}, 3));
  write_stl((folder.path() / "coarse.stl").string(), box({0.3, 0.3, 0.02}, 1));
  write_stl((folder.path() / "millimetres.stl").string(), box({300, 300, 20}, 1));
  Surface half = read_stl((folder.path() / "plate.stl").string());
  half.triangles.resize(half.triangles.size() / 2);
  write_stl((folder.path() / "half.stl").string(), half);
  folder.write("in", small_bed() + one.mesh + mesh_wall() + (one.script.empty() ? kCouple + "run 200\n" : one.script));
  const Outcome outcome = folder.coupled(2, "-in in", one.partner + one.body, kLimit);
  EXPECT_NE(outcome.exit_code, 0) << outcome.text;
  EXPECT_NE(outcome.exit_code, 124) << "hangs:\n" << outcome.text;
  if (one.exit_code != 0) {
    EXPECT_EQ(outcome.exit_code, one.exit_code) << outcome.text;
  }
  EXPECT_LT(outcome.seconds, kSoon);
  for (const std::string& part : one.says)
    EXPECT_NE(outcome.text.find(part), std::string::npos) << "missing: " << part << "\nin:\n" << outcome.text;
  EXPECT_LE(count(outcome.text, "liggghts_mbd: ERROR:"), 1U) << outcome.text;
  EXPECT_LE(count(outcome.text, "scripted_partner: ERROR:"), 1U) << outcome.text;
  EXPECT_EQ(processes_left_in(folder.path()), 0);
}

TEST(Failure, ASignalToLiggghtsIsTheEndOfBothButNoFailure) {
  const RunFolder folder("failures_signal");
  write_stl((folder.path() / "plate.stl").string(), box({0.3, 0.3, 0.02}, 3));
  // LIGGGHTS is an ancestor of what its `shell` command runs.
  folder.write("stop.sh",
               "p=$PPID\nwhile [ \"$(cat /proc/$p/comm)\" != liggghts_mbd ]; do p=$(cut -d' ' -f4 "
               "/proc/$p/stat); done\n"
               "kill -TERM $p\n");
  folder.write("in", small_bed() + "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n" + mesh_wall() +
                         kCouple + "run 103\nshell sh stop.sh\nrun 97\n");
  const Outcome outcome =
      folder.coupled(1, "-in in", "until 0.01 body plate plate.stl 0 0 0.24 prescribed 0 0 -1 0 0 0", kLimit);
  EXPECT_EQ(outcome.exit_code, 3) << outcome.text;
  EXPECT_NE(outcome.text.find("the grains' side was asked to end by a signal"), std::string::npos) << outcome.text;
}

TEST(Failure, CouplingWithoutAPartnerIsRefused) {
  const RunFolder folder("failures_alone");
  write_stl((folder.path() / "plate.stl").string(), box({0.3, 0.3, 0.02}, 3));
  folder.write("in", small_bed() + "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n" + mesh_wall() +
                         kCouple + "run 10\n");
  const Outcome outcome = folder.alone(RunFolder::program("liggghts_mbd"), 2, "-in in", kLimit);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
  EXPECT_NE(outcome.text.find("runs without a multibody partner. Start both programs together: mpirun"),
            std::string::npos);
  EXPECT_EQ(count(outcome.text, "ERROR"), 1U) << outcome.text;
}

TEST(Failure, OtherUnitsAreRefused) {
  const RunFolder folder("failures_units");
  write_stl((folder.path() / "plate.stl").string(), box({30, 30, 2}, 1));
  folder.write("in",
               "atom_style granular\natom_modify map array\nunits cgs\nregion reg block -50 50 -50 50 -50 50 "
               "units box\ncreate_box 1 reg\n"
               "fix geo all couple/mbd/geometry body plate\n");
  const Outcome outcome =
      folder.coupled(1, "-in in", "until 0.01 body plate plate.stl 0 0 0 prescribed 0 0 0 0 0 0", kLimit);
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.text.find("the script has \"units cgs\"; footfall couples in \"units si\" only"), std::string::npos)
      << outcome.text;
}

}  // namespace
}  // namespace footfall::test

// What goes wrong ends both programs with the right exit code.
#include <gtest/gtest.h>

#include <chrono>
#include <ostream>
#include <thread>

#include "coupler/messages.h"
#include "tests/coupled/coupled_run.h"
#include "tests/support/refused.h"
#include "tests/support/run_folder.h"

namespace footfall::test {
namespace failures {

// Every way to fail ends both programs soon, with a message that says what is wrong, and leaves no process
// behind.

constexpr int kLimit = 30;  // hanging is failing [s]

// What a user reads, besides the place of a mistake, is in docs/reference/messages.md alone.
struct Case {
  std::string name;
  int exit_code;       // of both programs; 0: any other
  std::string names;   // a word of the message: who, which, what number
  std::string script;  // after the bed and the mesh; empty: couple and run
  std::string partner = "until 0.01";
  std::string mesh = "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n";
  std::string body = " body plate plate.stl 0 0 0.24 prescribed 0 0 -1.0 0 0 0";
};

const std::string kCouple = "fix mbd all couple/mbd every 5 mesh m plate\n";
const std::string kMesh = "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n";
std::string with(const std::string& words) { return "fix mbd all couple/mbd every " + words + "\nrun 200\n"; }
std::string moving(const std::string& velocity) {
  return " body plate plate.stl 0 0 0.24 prescribed 0 0 " + velocity + " 0 0 0";
}

// How gtest shows a case.
void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

// clang-format off
const Case kCases[] = {
    // The partner misbehaves in window 7.
    {"ForeignProtocol", 2, std::to_string(kProtocolVersion + 998), "", "until 0.01 misbehave version"},
    {"PartnerFails", 1, "the spring of the test broke", "", "until 0.01 misbehave fail 7"},
    {"PartnerIsKilled", 0, "", "", "until 0.01 misbehave die 7"},
    {"PartnerLeavesWithoutAWord", 0, "", "", "until 0.01 misbehave lose 7"},
    {"PartnerSendsAnotherWindow", 2, "14", "", "until 0.01 misbehave wrong-window 7"},
    {"PartnerSendsNotANumber", 1, "\"plate\" at t = 0.00175 s", "", "until 0.01 misbehave not-a-number 7"},
    {"PartnerHangs", 1, "mbd_solver", with("5 patience 1.0 mesh m plate"), "until 0.01 misbehave hang 7"},
    {"PartnerIsInterrupted", 3, "stopped by hand", "", "until 0.01 misbehave interrupt 7"},
    // The script is wrong.
    {"UnknownBody", 2, "\"plato\"", with("5 mesh m plato")},
    {"UnknownMesh", 2, "mesh mm", with("5 mesh mm plate")},
    {"WrongKeyword", 2, "\"mash\"", with("5 mash m plate")},
    {"TwoMeshesOfTheSameTriangles", 2, "meshes m and n",
     "fix n all mesh/surface file plate.stl type 2 move 0 0 0.24\n" + with("5 mesh m plate mesh n plate")},
    {"NothingCoupled", 2, "", with("5")},
    {"MeshMovedByAnother", 2, "mesh m", "fix c all move/mesh mesh m linear 0 0 1\n" + kCouple + "run 200\n"},
    {"SurfaceVelocityThatVaries", 2, "mesh m", kCouple + "run 200\n", "until 0.01",
     "variable belt equal 1+step\nfix m all mesh/surface file plate.stl type 2 move 0 0 0.24 surface_vel v_belt 0 0\n"},
    {"MeshOfAnotherPlace", 2, "\"plate\"", "", "until 0.01",
     "fix m all mesh/surface file plate.stl type 2 move 0 0 0.25\n"},
    {"MeshOfAnotherBody", 2, "\"plate\"", "", "until 0.01",
     "fix m all mesh/surface file coarse.stl type 2 move 0 0 0.24\n"},
    {"MeshOfHalfABody", 2, "108", "", "until 0.01", "fix m all mesh/surface file half.stl type 2 move 0 0 0.24\n"},
    {"BodyInMillimetres", 2, "300 x 300 x 20 m", kCouple + "run 200\n", "until 0.01",
     "fix geo all couple/mbd/geometry body plate\nfix m all mesh/surface fix geo type 2\n",
     " body plate millimetres.stl 0 0 0.24 prescribed 0 0 -1.0 0 0 0"},
    {"CouplingTakenAway", 2, "t = 0.005 s", kCouple + "run 100\nunfix mbd\nrun 100\n"},
    {"MeshReplaced", 2, "mesh m", kCouple + "run 100\nunfix wm\nunfix m\n" + kMesh + mesh_wall() + "run 100\n"},
    {"MeshRemovedAndThenTheCoupling", 2, "unfix mbd", kCouple + "run 10\nunfix wm\nunfix m\nunfix mbd\nrun 10\n"},
    {"GravityChanges", 2, "(0, 0, 9.81) m/s2",
     kCouple + "run 100\nunfix grav\nfix grav all gravity 9.81 vector 0 0 1\nrun 100\n"},
    {"AllGrainsLost", 1, "0.05", "velocity all set 0 0 100\nthermo_modify lost ignore\n" + kCouple + "run 2000\n",
     "until 0.1", kMesh, moving("0")},
    {"BodyGoesThroughTheFloor", 1, "fix floor",
     "region all block INF INF INF INF INF INF units box\ndelete_atoms region all\n"
     "create_atoms 1 single 0.25 0.25 0.1\nset group all diameter 0.04 density 2600\n" + kCouple + "run 2000\n",
     "until 0.1", kMesh, moving("-4.0")},
    {"MeshLeavesTheBox", 1, "at step 351", kCouple + "run 20000\n", "until 1.0", kMesh, moving("20.0")},
    {"TimeStepChanges", 2, "4e-05 s", kCouple + "run 100\ntimestep 4e-5\nrun 100\n"},
    {"VerboseTiming", 2, "modify_timing verbose", "modify_timing verbose\n" + kCouple + "run 200\n"},
    {"SecondCoupling", 2, "mbd2", kCouple + "fix mbd2 all couple/mbd every 5 mesh m plate\nrun 200\n"},
    {"MeshRemoved", 2, "mesh m", kCouple + "run 100\nunfix wm\nunfix m\nrun 100\n"},
    {"ScriptEndsTooEarly", 2, "200", kCouple + "run 100\n"},
    {"ScriptGoesOnTooLong", 2, "t = 0.01 s", kCouple + "run 200\nrun 10\n"},
    {"ScriptNeverCouples", 2, "fix couple/mbd", "run 10\n"},
    {"ScriptNamesButNeverRuns", 2, "fix couple/mbd", kCouple},
    {"ScriptErrorBeforeTheHandshake", 1, "no_such_command", "no_such_command\n"},
    {"ScriptErrorInTheMiddle", 1, "no_such_command", kCouple + "run 100\nno_such_command\n"},
    {"LiggghtsAborts", 1, "random seed", kCouple + "run 100\ndisplace_atoms all random 0 0 0 12345 units box\n"},
};
// clang-format on

class Failure : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Of, Failure, testing::ValuesIn(kCases),
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
  for (int moments = 500; moments > 0 && processes_in(folder) > 0; --moments) std::this_thread::sleep_for(kMoment);
  return processes_in(folder);
}

TEST_P(Failure, IsReportedByBothSidesAndEndsThem) {
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
  EXPECT_TRUE(names(outcome.text, {one.names}));
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
  folder.write("in", small_bed() + kMesh + mesh_wall() + kCouple + "run 103\nshell sh stop.sh\nrun 97\n");
  EXPECT_EQ(folder.coupled(1, "-in in", "until 0.01" + moving("-1"), kLimit).exit_code, 3);
}

TEST(Failure, CouplingWithoutAPartnerIsRefused) {
  const RunFolder folder("failures_alone");
  write_stl((folder.path() / "plate.stl").string(), box({0.3, 0.3, 0.02}, 3));
  folder.write("in", small_bed() + kMesh + mesh_wall() + kCouple + "run 10\n");
  const Outcome outcome = folder.alone(RunFolder::program("liggghts_mbd"), 2, "-in in", kLimit);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
  EXPECT_EQ(count(outcome.text, "ERROR"), 1U) << outcome.text;
}

TEST(Failure, OtherUnitsAreRefused) {
  const RunFolder folder("failures_units");
  write_stl((folder.path() / "plate.stl").string(), box({30, 30, 2}, 1));
  folder.write("in",
               "atom_style granular\natom_modify map array\nunits cgs\nregion reg block -50 50 -50 50 -50 50 "
               "units box\ncreate_box 1 reg\nfix geo all couple/mbd/geometry body plate\n");
  const Outcome outcome =
      folder.coupled(1, "-in in", "until 0.01 body plate plate.stl 0 0 0 prescribed 0 0 0 0 0 0", kLimit);
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(names(outcome.text, {"units cgs"}));
}

// Mistakes of a user with beams.
struct Mistake {
  std::string name;
  std::string wall;   // after `model ...`
  std::string names;  // in the message
  std::string motion = {};
  int ranks = 1;
  std::string couple = "fix mbd all couple/mbd every 5\n";
};

void PrintTo(const Mistake& one, std::ostream* out) { *out << one.name; }

const std::string kOne = "end 0.001\nbody tine_1\n";
const Mistake kMistakes[] = {
    {"unknown_body", "type 2 body tine_2", "\"tine_1\""},
    {"body_without_beams", "type 2 body plate", "\"plate\""},
    {"no_such_beam", "type 2 body fork chain 1", "0, 3"},
    {"chain_without_body", "type 2 chain 1 body tine_1", "\"chain 1\""},
    {"chain_not_a_number", "type 2 body fork chain first", "\"chain first\""},
    {"type_without_material", "type 3 body tine_1", "type 3"},
    {"no_type", "body tine_1", "\"type\""},
    {"no_body", "type 2", "\"body\""},
    {"two_types", "type 2 body tine_1 type 1", "\"type\""},
    {"beam_twice", "type 2 body fork chain 3 body tine_1 body fork", "\"fork\""},
    {"forces_of_two_beams", "type 2 body fork store_force_contact yes", "store_force_contact"},
    {"value_missing", "type 2 body", "\"body\""},
    {"mesh_keyword", "mesh n_meshes 1 meshes x type 2 body tine_1", "\"mesh\""},
    {"nothing_moves_it", "type 2 body tine_1", "couple/mbd", {}, 1, ""},
    {"zero_radius", "type 2 body tine_1", "segment 0", kOne + chain({"-0.2 0 0", "0.2 0 0"}, 0.0)},
    {"zero_length", "type 2 body tine_1", "segment 1", kOne + chain({"-0.2 0 0", "0.1 0 0", "0.1 0 0"}, 0.02)},
    {"longer_than_the_box", "type 2 body tine_1", "subdomain", kOne + chain({"-400 0 0", "400 0 0"}, 20.0)},
    {"longer_than_a_subdomain", "type 2 body tine_1", "0.400000 m", kOne + chain({"-0.2 0 0", "0.2 0 0"}, 0.02), 2},
};

class BeamMistake : public testing::TestWithParam<Mistake> {};
INSTANTIATE_TEST_SUITE_P(Each, BeamMistake, testing::ValuesIn(kMistakes),
                         [](const auto& mistake) { return mistake.param.name; });

TEST_P(BeamMistake, IsReportedAndEndsTheRun) {
  const Mistake& m = GetParam();
  const BeamRun folder("mistake_" + m.name);
  const std::string tines = "end 0.001\nbody tine_1\n" + chain({"-0.2 0 0", "0 0 0", "0.2 0 0"}, 0.02) +
                            "body plate\nnode 0 0 0\nbody fork\n" + chain({"-0.2 0.1 0", "0.2 0.1 0"}, 0.02) +
                            chain({"-0.2 0.2 0", "0.2 0.2 0"}, 0.02, 2, 3);
  const Outcome outcome =
      folder.coupled(preamble("-0.3 0.3 -0.3 0.3 -0.3 0.3") +
                         "timestep 2e-5\npair_style gran model hertz tangential history\npair_coeff * *\n"
                         "create_atoms 1 single 0 0 0.1\nset group all diameter 0.04 density 2600\n"
                         "fix w all wall/gran/beam model hertz tangential history " +
                         m.wall + "\n" + m.couple + "run 50\n",
                     m.motion.empty() ? tines : m.motion, m.ranks);
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(names(outcome.text, {m.names}));
}

Outcome run_pair(const std::string& scenario, int grains, bool body_first = false, int limit = 60) {
  const RunFolder folder("mpi_" + scenario + "_" + std::to_string(grains) + (body_first ? "_body_first" : ""));
  const std::string program = RunFolder::program("two_programs");
  const std::string a = "-np " + std::to_string(grains) + " " + program + " grains " + scenario;
  const std::string b = "-np 1 " + program + " body " + scenario;
  return folder.mpirun(body_first ? b + " : " + a : a + " : " + b, limit);
}

TEST(TwoPrograms, FindEachOtherInEitherOrder) {
  const Outcome grains_first = run_pair("who", 2);
  EXPECT_EQ(grains_first.exit_code, 0) << grains_first.text;
  // Open MPI 5 may give the body a place between the grains.
  const auto partner = [&](const std::string& whose) {
    const std::size_t at = grains_first.text.find(whose + " partner ");
    return at == std::string::npos ? '-' : grains_first.text[at + whose.size() + 9];
  };
  EXPECT_TRUE(partner("grains rank 0 of 2") == '1' || partner("grains rank 0 of 2") == '2') << grains_first.text;
  EXPECT_EQ(partner("grains rank 0 of 2"), partner("grains rank 1 of 2"));
  EXPECT_EQ(partner("body rank 0 of 1"), '0');
  const Outcome body_first = run_pair("who", 2, true);
  EXPECT_NE(body_first.text.find("grains rank 1 of 2 partner 0"), std::string::npos) << body_first.text;
  EXPECT_NE(body_first.text.find("body rank 0 of 1 partner 1"), std::string::npos);
}

TEST(TwoPrograms, OneAloneHasNoPartner) {
  const RunFolder folder("mpi_alone");
  const Outcome outcome = folder.mpirun("-np 2 " + RunFolder::program("two_programs") + " grains who", 60);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.text.find("grains rank 1 of 2 partner -1"), std::string::npos) << outcome.text;
  const Outcome without_mpirun = folder.command(RunFolder::program("two_programs") + " grains who", 60);
  EXPECT_EQ(without_mpirun.exit_code, 0);
  EXPECT_NE(without_mpirun.text.find("grains rank 0 of 1 partner -1"), std::string::npos) << without_mpirun.text;
}

TEST(TwoPrograms, ThreeAreRefused) {
  const RunFolder folder("mpi_three");
  const std::string program = RunFolder::program("two_programs");
  const Outcome outcome =
      folder.mpirun("-np 1 " + program + " a who : -np 1 " + program + " b who : -np 1 " + program + " c who", 60);
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(names(outcome.text, {"3 programs"}));
}

class ProgramsOnRanks : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Ranks, ProgramsOnRanks, testing::Values(1, 2, 4), testing::PrintToStringParamName());

TEST_P(ProgramsOnRanks, EveryRankGetsEveryMotion) {
  const Outcome outcome = run_pair("exchange", GetParam());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
}

// Open MPI's mpirun itself crashes (139) or hangs after all its processes are gone (124) in a few of a hundred such
// ends on a busy machine, with MPI_Abort as with a plain exit: then the claim about our programs is tried again.
Outcome run_pair_until_mpirun_holds(const std::string& scenario, int grains) {
  Outcome outcome;
  for (int attempt = 0; attempt < 4; ++attempt) {
    outcome = run_pair(scenario, grains, false, 12);
    if (outcome.exit_code != 124 && outcome.exit_code != 137 && outcome.exit_code != 139) break;
  }
  return outcome;
}

TEST_P(ProgramsOnRanks, AVanishingProgramTakesTheOtherWithIt) {
  const Outcome outcome = run_pair_until_mpirun_holds("vanish", GetParam());
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.exit_code, 124) << "hangs";
}

TEST_P(ProgramsOnRanks, LastWordsReachThePartner) {
  const Outcome outcome = run_pair("last-words", GetParam());
  EXPECT_EQ(outcome.exit_code, 1) << outcome.text;
  EXPECT_TRUE(names(outcome.text, {"the script is wrong"}));
  EXPECT_EQ(outcome.text.find("MPI_ABORT"), std::string::npos) << outcome.text;
}

TEST(TwoPrograms, MessagesMayBeLarge) {
  const Outcome outcome = run_pair("large", 2);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
}

TEST(TwoPrograms, WaitingCostsNoProcessorTime) {
  const Outcome outcome = run_pair("wait", 2);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  std::istringstream lines(outcome.text);
  int ranks = 0;
  for (std::string line; std::getline(lines, line);) {
    double seconds = 0.0;
    int rank = 0;
    if (std::sscanf(line.c_str(), "grains rank %d used %lf s", &rank, &seconds) != 2) continue;
    ++ranks;
    EXPECT_LT(seconds, 1.0) << line;  // of processor time in two seconds; a blocking receive would use all of them
  }
  EXPECT_EQ(ranks, 2) << outcome.text;
}

}  // namespace failures
}  // namespace footfall::test

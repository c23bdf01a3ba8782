// What scripts may do with the coupling.
#include <gtest/gtest.h>

#include <algorithm>

#include "liggghts_fix/link/codes.h"
#include "tests/coupled/coupled_run.h"
#include "tests/support/refused.h"

namespace footfall::test {
namespace scripts {

// What a LIGGGHTS script may do with a coupled run.

const std::string kThermo =
    "thermo_style custom step atoms f_m[1] f_m[2] f_m[3] f_m[4] f_m[5] f_m[6]\nthermo 50\nthermo_modify norm "
    "no format float %.17g\n";
const std::string kMeshFromFile = "fix m all mesh/surface/stress file plate.stl type 2 move 0 0 0.24\n";
const std::string kFalling = " body plate plate.stl 0 0 0.24 prescribed 0.1 -0.05 -1.0 0 0 0";

RunFolder plate_folder(const std::string& name) {
  RunFolder folder("scripts_" + name);
  write_stl((folder.path() / "plate.stl").string(), box({0.3, 0.3, 0.02}, 3));
  return folder;
}

std::string couple(int every) { return "fix mbd all couple/mbd every " + std::to_string(every) + " mesh m plate\n"; }

TEST(Script, SeveralRunsThatEndInMidWindowGiveTheBitsOfMoveMesh) {
  const RunFolder folder = plate_folder("several_runs");
  const std::string runs = "run 500\nrun 33\nrun 67\nrun 50 pre no\nrun 100 every 30 NULL\n";  // windows of 7 steps
  const auto script = [&](const std::string& name, const std::string& mover) {
    return small_bed() + kMeshFromFile + mesh_wall() + mover + kThermo + dump_every(125, name) + runs;
  };
  folder.write("in.stock", script("stock", "fix c all move/mesh mesh m linear 0.1 -0.05 -1.0\n"));
  folder.write("in.ours", script("ours", couple(7)));
  const Outcome stock = folder.alone(kStock, 1, "-in in.stock -log log.stock");
  const Outcome ours = folder.coupled(1, "-in in.ours -log log.ours", "until 0.0375" + kFalling);
  ASSERT_EQ(stock.exit_code, 0) << stock.text;
  ASSERT_EQ(ours.exit_code, 0) << ours.text;
  for (const char* step : {"500", "625", "750"})
    EXPECT_TRUE(folder.read(std::string("stock.") + step) == folder.read(std::string("ours.") + step))
        << "step " << step;
  EXPECT_EQ(thermo_lines(folder.read("log.stock")), thermo_lines(folder.read("log.ours")));
  EXPECT_NE(ours.text.find("windows 108 "), std::string::npos) << ours.text;  // 107 of 7 steps and one of 1
}

TEST(Script, TrianglesFromTheSceneAndFromAFileGiveTheSameBits) {
  const RunFolder folder = plate_folder("geometry");
  const auto script = [&](const std::string& name, const std::string& mesh) {
    return small_bed() + mesh + mesh_wall() + couple(5) + dump_every(500, name) + "run 500\n";
  };
  folder.write("in.file", script("file", kMeshFromFile));
  folder.write("in.scene",
               script("scene", "fix geo all couple/mbd/geometry body plate\nfix m all mesh/surface fix geo type 2\n"));
  ASSERT_EQ(folder.coupled(1, "-in in.file", "until 0.025 out file.csv" + kFalling).exit_code, 0);
  ASSERT_EQ(folder.coupled(1, "-in in.scene", "until 0.025 out scene.csv" + kFalling).exit_code, 0);
  EXPECT_TRUE(folder.read("file.500") == folder.read("scene.500"));
  // mesh/surface/stress turns the force round before we hear of it, mesh/surface does not: the load is the
  // same.
  EXPECT_EQ(folder.read("file.csv"), folder.read("scene.csv"));
  const std::vector<double> fz = Table(folder.path() / "file.csv")["fz"];
  EXPECT_GT(*std::max_element(fz.begin(), fz.end()), 100.0);
}

TEST(Script, AMeshFileMayHaveAnyOrderOfTrianglesAndVertices) {
  const RunFolder folder = plate_folder("order");
  Surface shuffled = read_stl((folder.path() / "plate.stl").string());
  std::reverse(shuffled.triangles.begin(), shuffled.triangles.end());
  for (Eigen::Vector3i& t : shuffled.triangles) t = Eigen::Vector3i(t[1], t[2], t[0]);
  write_stl((folder.path() / "shuffled.stl").string(), shuffled);
  const std::string turning = " body plate plate.stl 0 0 0.24 prescribed 0.1 -0.05 -1.0 0.5 0.5 0.5";
  const auto last_force = [&](const std::string& file) {
    folder.write("in", small_bed() + "fix m all mesh/surface file " + file + " type 2 move 0 0 0.24\n" + mesh_wall() +
                           couple(5) + "run 400\n");
    const Outcome outcome = folder.coupled(1, "-in in", "until 0.02 out table.csv" + turning);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    const Table table(folder.path() / "table.csv");
    return table.vector(table.rows() - 1, "fx", "fy", "fz");
  };
  const Eigen::Vector3d a = last_force("plate.stl"), b = last_force("shuffled.stl");
  EXPECT_GT(a.norm(), 100.0);
  // other order of sums, 400 steps of a bed that multiplies round-off
  EXPECT_LT((a - b).norm(), 1e-7 * a.norm());
}

TEST(Script, TheEndOfTheSceneEndsARunThatWantsMoreAndTheScriptGoesOn) {
  const RunFolder folder = plate_folder("long");
  folder.write("in", small_bed() + kMeshFromFile + mesh_wall() + couple(5) + kThermo +
                         "run 1000000\nprint \"went on\"\nunfix mbd\nrun 20\n");
  const Outcome outcome = folder.coupled(2, "-in in -log log", "until 0.0103" + kFalling);  // 206 steps
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  const auto lines = thermo_lines(folder.read("log"));
  EXPECT_EQ(lines[lines.size() - 3][0], "206");  // then the first and the last step of the run that is not coupled
  EXPECT_EQ(lines.back()[0], "226");
  EXPECT_NE(outcome.text.find("went on"), std::string::npos);
}

TEST(Script, GoesOnAfterARunThatEndsWithTheScene) {
  const RunFolder folder = plate_folder("exact");
  folder.write("in", small_bed() + kMeshFromFile + mesh_wall() + couple(5) +
                         "run 200\nprint \"went on\"\nwrite_restart end.restart\n");
  const Outcome outcome = folder.coupled(1, "-in in", "until 0.01" + kFalling);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("went on"), std::string::npos);
  EXPECT_TRUE(folder.has("end.restart"));
}

// A loop does not know when the scene ends: its further runs are left out. The last one waits for a step that never comes.
TEST(Script, LoopsMayGoOnBeyondTheScene) {
  const RunFolder folder = plate_folder("loops");
  for (const char* loop :
       {"run 1000 every 50 \"print again\"\nprint \"went on\"\n", "run 1000 every 33 NULL\nprint \"went on\"\n",
        "variable k loop 20\nlabel again\nrun 50\nnext k\njump in again\nprint \"went on\"\n",
        "variable k loop 20\nlabel again\nrun 30\nnext k\njump in again\nprint \"went on\"\n",
        "variable s equal step\nlabel again\nrun 50\nprint \"went on\"\nif \"${s} < 1000\" then \"jump in again\"\n"}) {
    folder.write("in", small_bed() + kMeshFromFile + mesh_wall() + couple(5) + loop);
    const Outcome outcome = folder.coupled(2, "-in in", "until 0.01 out table.csv" + kFalling);
    EXPECT_EQ(outcome.exit_code, 0) << loop << outcome.text;
    EXPECT_NE(outcome.text.find("went on"), std::string::npos) << loop;
    EXPECT_EQ(Table(folder.path() / "table.csv").rows(), 40U) << loop;
  }
}

TEST(Script, MaySettleItsBedFirst) {
  const RunFolder folder = plate_folder("settle");
  folder.write("in", small_bed() + "run 100\n" + kMeshFromFile + mesh_wall() + "run 100\n" + couple(5) + "run 200\n");
  const Outcome outcome = folder.coupled(2, "-in in", "until 0.01 out table.csv" + kFalling);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_EQ(Table(folder.path() / "table.csv").rows(), 40U);
}

TEST(Script, MayLeaveTheWindowToThePartner) {
  const RunFolder folder = plate_folder("auto");
  folder.write("in",
               small_bed() + kMeshFromFile + mesh_wall() + "fix mbd all couple/mbd every auto mesh m plate\nrun 200\n");
  const Outcome outcome = folder.coupled(1, "-in in", "until 0.01 n 8 out table.csv" + kFalling);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_EQ(Table(folder.path() / "table.csv").rows(), 25U);
}

// A fix that is called before the forces and is not known to look away from meshes makes them wait.
TEST(Script, GrainsThatGoAheadOrWaitGiveTheSameBits) {
  const RunFolder folder = plate_folder("ahead");
  const auto run = [&](const std::string& name, const std::string& more, std::size_t obstacles) {
    folder.write("in", small_bed() + kMeshFromFile + mesh_wall() + more + couple(5) + kThermo + dump_every(400, name) +
                           "run 400\n");
    const Outcome outcome =
        folder.coupled(2, "-in in -log log." + name,
                       "until 0.02 out " + name + ".csv body plate plate.stl 0 0 0.24 free 3 0 0.1 -0.05 -1.0 0 0 0");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    EXPECT_EQ(count(folder.read("log." + name), "because of fix mark (property/atom/tracer)"), obstacles);
  };
  run("ahead", "", 0);
  run("waits",
      "region here block -0.1 0.1 -0.1 0.1 0 0.6 units box\n"
      "fix mark all property/atom/tracer region_mark here mark_step 10\n",
      1);
  EXPECT_TRUE(folder.read("ahead.400") == folder.read("waits.400"));
  EXPECT_EQ(folder.read("ahead.csv"), folder.read("waits.csv"));
  EXPECT_EQ(thermo_lines(folder.read("log.ahead")), thermo_lines(folder.read("log.waits")));
}

TEST(Script, TellsOfSpheresThatNoClumpMoves) {
  const RunFolder folder = plate_folder("still");
  std::string bed = small_bed();
  const std::string moved = "fix integr all nve/sphere\n";
  bed.erase(bed.find(moved), moved.size());
  const std::string rest = kMeshFromFile + mesh_wall() + couple(5), clumps = "fix integr all multisphere\n";
  folder.write("in.still", bed + rest + clumps + "run 20\n");
  folder.write("in.moved", bed + rest + clumps + "fix others all nve/sphere\nrun 20\n");
  const std::string said = "W1454";
  const Outcome still = folder.coupled(2, "-in in.still", "until 0.001" + kFalling);
  EXPECT_EQ(still.exit_code, 0) << still.text;
  EXPECT_NE(still.text.find(said), std::string::npos) << still.text;
  const Outcome moving = folder.coupled(2, "-in in.moved", "until 0.001" + kFalling);
  EXPECT_EQ(moving.exit_code, 0) << moving.text;
  EXPECT_EQ(moving.text.find(said), std::string::npos);
}

TEST(Script, ThermoShowsWhatThePartnerGets) {
  const RunFolder folder = plate_folder("thermo");
  folder.write("in", small_bed() + kMeshFromFile + mesh_wall() + couple(50) +
                         "thermo_style custom step atoms f_mbd[1] f_mbd[2] f_mbd[3] f_mbd[4] f_mbd[5] "
                         "f_mbd[1][1] f_mbd[1][2] f_mbd[1][3] "
                         "f_mbd[1][4] f_mbd[1][5] f_mbd[1][6]\nthermo 50\nthermo_modify norm no format float "
                         "%.17g\nrun 500\n");
  const Outcome outcome = folder.coupled(2, "-in in -log log", "until 0.025 out table.csv" + kFalling);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const Table table(folder.path() / "table.csv");
  const auto lines = thermo_lines(folder.read("log"));
  ASSERT_EQ(lines.size(), 11U);
  double work = 0.0, overlap = 0.0;
  for (std::size_t k = 0; k < 10; ++k) {
    const auto number = [&](std::size_t column) { return std::stod(lines[k + 1][column]); };
    work += table["work"][k];
    overlap = std::max(overlap, table["overlap"][k]);
    EXPECT_EQ(number(2), static_cast<double>(k + 1));
    EXPECT_NEAR(number(4), work, 1e-12 * std::abs(work));
    EXPECT_EQ(number(5), overlap);
    EXPECT_EQ(number(6), table["contacts"][k]);
    EXPECT_EQ(number(7), table["fx"][k]);
    EXPECT_EQ(number(9), table["fz"][k]);
    EXPECT_EQ(number(10), table["mx"][k]);  // the plate does not turn: B and W agree
  }
  // A prescribed body goes exactly where the prediction says: no work is lost on the way (beyond round-off).
  EXPECT_NEAR(std::stod(lines.back()[3]), 0.0, 1e-10 * std::abs(work));
}

TEST(Script, PeriodicBoxesKeepImagesOfAMeshWhereTheyAre) {
  // A plate that slides out of the box at x = 0.3 and in again at x = -0.3 presses on a periodic carpet as
  // a path that stays inside: the same force, and the same slopes for scheme tangent.
  const auto force = [](const std::string& name, double place) {
    const RunFolder folder("scripts_periodic_" + name);
    write_stl((folder.path() / "plate.stl").string(), box({0.1, 0.3, 0.02}, 3));
    std::string head = script_head("-0.3 0.3 -0.3 0.3 -0.1 0.2", "2 1 1");
    head.replace(head.find("boundary f f f"), 14, "boundary p f f");
    std::ostringstream grains;
    for (int i = -6; i < 6; ++i)
      for (int j = -4; j <= 4; ++j)
        grains << "create_atoms 1 single " << 0.05 * i + 0.0125 << " " << 0.05 * j << " 0 units box\n";
    folder.write("in", head + grains.str() +
                           "set group all diameter 0.04 density 2600\nfix hold all spring/self 4000\nfix integr "
                           "all nve/sphere\n"
                           "fix geo all couple/mbd/geometry body plate\nfix m all mesh/surface fix geo type 2\n" +
                           mesh_wall() + "fix mbd all couple/mbd every 10 mesh m plate\nrun 400\n");
    std::ostringstream partner;
    partner << "scheme tangent until 0.02 out table.csv body plate plate.stl " << place
            << " 0 0.031 prescribed 5 0 -0.1 0 0.3 0";
    const Outcome outcome = folder.coupled(2, "-in in", partner.str());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    const Table table(folder.path() / "table.csv");
    return std::pair(table.vector(table.rows() - 1, "fx", "fy", "fz"), table["turn_slope"]);
  };
  const auto [inside, slopes] = force("inside", -0.06);
  const auto [across, slopes_across] = force("across", 0.24);
  EXPECT_GT(inside.norm(), 10.0);
  EXPECT_LT((inside - across).norm(), 1e-9 * inside.norm());
  // Only their round-off differs: a place in W is rounded at 0.3 m in place of 0.06 m.
  ASSERT_EQ(slopes.size(), slopes_across.size());
  for (std::size_t k = 0; k < slopes.size(); ++k) EXPECT_NEAR(slopes[k], slopes_across[k], 1e-9 * slopes.back());
  EXPECT_GT(slopes.back(), 1.0);
}

// What scripts do that were written for LIGGGHTS alone: all of it is right, and none of it may be refused or forgotten.

const std::string kMesh = "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n";
const std::string kGeometry = "fix geo all couple/mbd/geometry body plate\nfix m all mesh/surface fix geo type 2\n";
const std::string kCouple = "fix mbd all couple/mbd every 5 mesh m plate\n";
const std::string kRun = "until 0.01 out table.csv body plate plate.stl 0 0 0.24 prescribed 0.1 -0.05 -1.0 0 0 0";

// The script in place of the plain one gives the same loads, every bit.
void expect_the_same_loads(const RunFolder& folder, const std::string& script, int ranks = 1) {
  folder.write("in.plain", small_bed() + kMesh + mesh_wall() + kCouple + "run 200\n");
  folder.write("in", script);
  const Outcome plain = folder.coupled(ranks, "-in in.plain", kRun);
  ASSERT_EQ(plain.exit_code, 0) << plain.text;
  const std::string expected = folder.read("table.csv");
  const Outcome outcome = folder.coupled(ranks, "-in in", kRun);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_EQ(folder.read("table.csv"), expected);
}

TEST(UsersScript, MayClearEverythingAndBeginAnew) {
  const RunFolder folder = plate_folder("clear");
  expect_the_same_loads(folder, small_bed() + kGeometry + mesh_wall() +
                                    "fix mbd all couple/mbd every 3 mesh m plate\n" + "clear\n" + small_bed() + kMesh +
                                    mesh_wall() + kCouple + "run 200\n");
}

TEST(UsersScript, MayTakeAMeshThatAFixHasMoved) {
  const RunFolder folder = plate_folder("moved");
  folder.write("in",
               small_bed() + kMesh + mesh_wall() +
                   "fix mover all move/mesh mesh m wiggle amplitude 0. 0. 0.01 period 0.005\nrun 100\nunfix mover\n" +
                   kCouple + "run 200\n");
  const Outcome outcome = folder.coupled(2, "-in in", kRun);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_EQ(Table(folder.path() / "table.csv").rows(), 40U);
}

TEST(UsersScript, MayReadARestartFileThatKnowsTheMesh) {
  const RunFolder folder = plate_folder("restart");
  folder.write("in.first", small_bed() + kGeometry + mesh_wall() + kCouple + "run 200\nwrite_restart saved.restart\n");
  std::string again = small_bed();
  again = again.substr(again.find("fix m1 "));
  again.replace(again.find("lattice"), again.find("fix integr") - again.find("lattice"), "");
  folder.write("in.second",
               "atom_modify map array\nnewton off\ncommunicate single vel yes\nunits si\nhard_particles yes\n"
               "read_restart saved.restart\nneighbor 0.01 bin\nneigh_modify delay 0\n" +
                   again + kGeometry + mesh_wall() + kCouple + "run 200\n");
  for (const int ranks : {1, 2}) {
    const Outcome first = folder.coupled(ranks, "-in in.first", kRun);
    ASSERT_EQ(first.exit_code, 0) << first.text;
    const Outcome second = folder.coupled(ranks, "-in in.second", kRun);
    ASSERT_EQ(second.exit_code, 0) << second.text;
    EXPECT_NE(second.text.find("mesh m containing 108 triangle(s)"), std::string::npos) << second.text;
  }
}

TEST(UsersScript, MayDeleteGrainsBeforeTheFirstRun) {
  const RunFolder folder = plate_folder("delete");
  folder.write("in", small_bed() + kMesh + mesh_wall() + kCouple +
                         "region top block -0.3 0.3 -0.3 0.3 0.18 0.6 units box\ndelete_atoms region top\nrun 200\n");
  const Outcome outcome = folder.coupled(2, "-in in", kRun);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
}

// Nothing that the script deletes or inserts is lost: the limit would stop the run at the first lost grain.
TEST(UsersScript, MayDeleteAndInsertGrainsInTheRun) {
  const RunFolder folder = plate_folder("insert");
  Surface sheet;
  sheet.nodes.resize(3, 4);
  sheet.nodes << -0.25, 0.25, 0.25, -0.25, -0.25, -0.25, 0.25, 0.25, 0.29, 0.29, 0.29, 0.29;
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  write_stl((folder.path() / "outlet.stl").string(), sheet);
  folder.write("in", small_bed() + kMesh + mesh_wall() +
                         "fix grain all particletemplate/sphere 15485867 atom_type 1 density constant 2600 radius "
                         "constant 0.01\n"
                         "fix grains all particledistribution/discrete 32452867 1 grain 1.0\n"
                         "region high block -0.2 0.2 -0.2 0.2 0.32 0.45 units box\n"
                         "fix rain all insert/rate/region seed 86028157 distributiontemplate grains nparticles 200 "
                         "particlerate 20000 insert_every 40 overlapcheck yes vel constant 0 0 -10 region high\n"
                         "fix outlet all mesh/surface/planar file outlet.stl type 2\n"
                         "fix drain all massflow/mesh mesh outlet vec_side 0. 0. -1. count once delete_atoms yes\n"
                         "fix mbd all couple/mbd every 5 lost 1e-6 mesh m plate\n"
                         "thermo_style custom step atoms f_drain[2]\nrun 200\n");
  const Outcome outcome = folder.coupled(2, "-in in", kRun);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const std::vector<double> particles = Table(folder.path() / "table.csv")["particles"];
  const double most = *std::max_element(particles.begin(), particles.end());
  EXPECT_GT(most, 845.0);                                            // inserted
  EXPECT_TRUE(!std::is_sorted(particles.begin(), particles.end()));  // deleted
}

TEST(UsersScript, GrainsThatLeaveTheBoxAreCounted) {
  const RunFolder folder = plate_folder("lost");
  folder.write("in", small_bed() +
                         "region corner block 0.15 0.3 0.15 0.3 0.15 0.3 units box\ngroup corner region corner\n"
                         "velocity corner set 20 0 0\n" +
                         kMesh + mesh_wall() +
                         "thermo 10\nthermo_modify lost warn\nfix mbd all couple/mbd every 5 lost 0.1 mesh m "
                         "plate\nvariable corner equal count(corner)\nrun 0\nprint \"corner ${corner}\"\nrun 200\n");
  for (const int ranks : {1, 2}) {
    const Outcome outcome = folder.coupled(ranks, "-in in", kRun);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    const std::vector<double> particles = Table(folder.path() / "table.csv")["particles"];
    const std::vector<double> lost = Table(folder.path() / "table.csv")["lost"];
    EXPECT_GT(lost.back(), 5.0);
    for (std::size_t k = 0; k < lost.size(); ++k) EXPECT_EQ(particles[k] + lost[k], particles[0] + lost[0]);
  }
}

// m (v^2 + 2/5 r^2 w^2) / 2: the energy that leaves with a grain has its rotation.
TEST(UsersScript, AGrainThatLeavesTakesItsEnergyAlong) {
  const RunFolder folder = plate_folder("spinning");
  folder.write("in", script_head("-0.3 0.3 -0.3 0.3 -0.05 0.6") +
                         "fix integr all nve/sphere\ncreate_atoms 1 single 0.29 0 0.5 units box\n"
                         "create_atoms 1 single 0 0 0.5 units box\nset group all diameter 0.02 density 2600\n"
                         "region corner block 0.2 0.3 INF INF INF INF units box\ngroup corner region corner\n"
                         "velocity corner set 20 0 0\nset group corner omegaz 1000\n" +
                         kMesh + mesh_wall() +
                         "thermo 10\nthermo_modify lost ignore\nfix mbd all couple/mbd every 5 lost 1 mesh m plate\n"
                         "variable left equal f_mbd[7]\nrun 200\nprint \"left: ${left}\"\n");
  const Outcome outcome = folder.coupled(1, "-in in", kRun);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const std::size_t at = outcome.text.rfind("left: ");
  ASSERT_NE(at, std::string::npos) << outcome.text;
  const double m = 2600.0 * 4.0 / 3.0 * M_PI * 1e-6;
  EXPECT_NEAR(std::abs(std::stod(outcome.text.substr(at + 6))), 0.5 * m * (400.0 + 0.4 * 1e-4 * 1e6), 1e-4);
}

// A wall beside the body may end where the user's container ends: to LIGGGHTS it has no end. So this is told, no more.
TEST(UsersScript, ABodyThatGoesThroughASideWallIsToldOnce) {
  const RunFolder folder = plate_folder("side_wall");
  folder.write("in", small_bed() + kMesh + mesh_wall() +
                         "fix side all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 "
                         "xplane 0.1505\n" +
                         "fix slot all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 "
                         "yplane 0.0\n" +
                         kCouple + "run 200\n");
  const Outcome outcome = folder.coupled(2, "-in in", kRun);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_EQ(count(outcome.text, code::kBodyLeavesBed.number), 1U) << outcome.text;
  EXPECT_TRUE(names(outcome.text, {"\"plate\"", "fix side"}));  // it stands in the slot from the start
  EXPECT_EQ(count(outcome.text, "W1459"), 0U) << outcome.text;
}

// On a slope gravity has a part towards the side wall, which is no floor for that; once the body is beside the bed, the
// plane of the floor is not below it either. Only a body on the bed goes through its floor.
TEST(UsersScript, OnASlopeASideIsASideAndTheFloorTheFloor) {
  const RunFolder folder = plate_folder("slope");
  const std::string walls =
      "fix side all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 xplane 0.1505\n"
      "fix low all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 zplane 0.226\n";
  std::string bed = small_bed();
  bed.replace(bed.find("9.81 vector 0 0 -1"), 18, "9.81 vector 0.45 0 -0.89");
  folder.write("in", bed + kMesh + mesh_wall() + walls + kCouple + "run 200\n");
  const std::string run = "until 0.01 body plate plate.stl 0 0 0.24 prescribed ";
  const Outcome beside = folder.coupled(2, "-in in", run + "1 0 -1 0 0 0");
  EXPECT_EQ(beside.exit_code, 0) << beside.text;
  EXPECT_EQ(count(beside.text, "W1460"), 1U) << beside.text;
  EXPECT_EQ(count(beside.text, "W1459"), 1U) << "the floor, beside the bed: " << beside.text;
  const Outcome below = folder.coupled(2, "-in in", run + "0 0 -1 0 0 0");
  EXPECT_EQ(below.exit_code, 1) << below.text;
  EXPECT_NE(below.text.find("E0487"), std::string::npos) << below.text;
}

// A grain at 300 m/s would jump over the plate of 2 mm; two that are pressed together would change sides of it. Between,
// a grain bounces as it should.
TEST(UsersScript, AGrainThatABodyCannotStopEndsTheRun) {
  const RunFolder folder("foreign_tunnel");
  write_stl((folder.path() / "plate.stl").string(), box({0.3, 0.3, 0.002}, 1));
  const auto script = [](const std::string& grain, const std::string& more) {
    return script_head("-0.3 0.3 -0.3 0.3 -0.3 0.3", "* * *", 1e-5) + "fix integr all nve/sphere\n" + grain +
           "set group all diameter 0.004 density 2600\n" + more + kGeometry + mesh_wall() + kCouple + "run 100000\n";
  };
  const std::string still = "body plate plate.stl 0 0 0 prescribed 0 0 0 0 0 0";
  const auto expect = [&](const std::string& run, const std::string& code) {
    for (const int ranks : {1, 2}) {
      const Outcome outcome = folder.coupled(ranks, "-in in", run);
      EXPECT_EQ(outcome.exit_code, 1) << outcome.text;
      EXPECT_NE(outcome.text.find(code), std::string::npos) << outcome.text;
    }
  };
  const std::string above = "create_atoms 1 single 0.01 0.02 0.1 units box\n";
  folder.write("in", script(above, "velocity all set 0 0 -300\n"));
  expect("until 0.001 " + still, "E0489");
  folder.write("in", script("create_atoms 1 single 0.01 0.02 0 units box\n", ""));
  expect("until 0.001 body plate plate.stl 0 0 0.1 prescribed 0 0 -300 0 0 0", "E0489");  // the plate is fast
  folder.write("in",
               script("create_atoms 1 single 0.01 0.02 0.0028 units box\ncreate_atoms 1 single 0.01 0.02 -0.0028 "
                      "units box\nregion above block INF INF INF INF 0 INF units box\ngroup above region "
                      "above\ngroup below subtract all above\n",
                      "variable push equal 1e6*step*dt\nvariable pull equal -1e6*step*dt\nfix a above addforce 0 0 "
                      "v_pull\nfix b below addforce 0 0 v_push\n"));
  expect("until 0.1 " + still, "E0498");
  folder.write("in", script("create_atoms 1 single 0.01 0.02 0.0002 units box\n", ""));  // it starts within the plate
  EXPECT_EQ(folder.coupled(1, "-in in", "until 0.01 " + still).exit_code, 0);
  folder.write("in", script(above, "velocity all set 0 0 -20\n"));  // a tenth of its radius in a time step
  const Outcome bounces = folder.coupled(1, "-in in", "until 0.01 out table.csv " + still);
  EXPECT_EQ(bounces.exit_code, 0) << bounces.text;
  const std::vector<double> fz = Table(folder.path() / "table.csv")["fz"];
  EXPECT_LT(*std::min_element(fz.begin(), fz.end()), 0.0) << "it never touched";
}

// The mesh lies in the side z = 0 of the box and turns: round-off must not take it out of the box. -0.1 is no binary number.
TEST(UsersScript, AMeshMayTurnInASideOfTheBox) {
  const RunFolder folder("foreign_turning_side");
  for (const char* z : {"0", "-0.1"}) {
    Surface plate;
    plate.nodes.resize(3, 4);
    plate.nodes << -0.05, 0.05, 0.05, -0.05, -0.05, -0.05, 0.05, 0.05, -0.01, -0.01, -0.01, -0.01;
    plate.triangles = {{0, 1, 2}, {0, 2, 3}};
    write_stl((folder.path() / "plate.stl").string(), plate);
    folder.write("in", script_head(std::string("-0.2 0.2 -0.2 0.2 ") + z + " 0.5", "* * *", 2e-5) +
                           "fix grav all gravity 9.81 vector 0 0 -1\nfix integr all nve/sphere\ncreate_atoms 1 single "
                           "0.02 0.01 0.2 units box\nset group all diameter 0.02 density 2600\n" +
                           kGeometry + mesh_wall() + kCouple + "run 100 every 10 NULL\nrun 300\n");
    const std::string place = z == std::string("0") ? "0.01" : "-0.09";
    for (const int ranks : {1, 2}) {
      const Outcome outcome =
          folder.coupled(ranks, "-in in", "until 0.008 body plate plate.stl 0 0 " + place + " prescribed 0 0 0 0 0 10");
      EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    }
  }
}

TEST(UsersScript, AMeshMayLieOnTheSideOfTheBox) {
  const RunFolder folder("foreign_side");
  write_stl((folder.path() / "plate.stl").string(), box({0.2, 0.2, 0.02}, 1));
  folder.write("in", small_bed() + kGeometry + mesh_wall() + kCouple + "run 200\n");
  // 0.2 + 0.1 is 0.30000000000000004; and what round-off may make of it
  for (const char* x : {"0.2", "0.200000005"})
    for (const int ranks : {1, 2}) {
      const Outcome outcome = folder.coupled(
          ranks, "-in in", std::string("until 0.01 body plate plate.stl ") + x + " 0 0.59 prescribed 0 0 -1 0 0 0");
      EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    }
}

TEST(UsersScript, MayEndBeforeTheSceneWhenItSaysSo) {
  const RunFolder folder = plate_folder("ends");
  const std::string until = "until 1.0 body plate plate.stl 0 0 0.24 prescribed 0 0 -1 0 0 0";
  folder.write("in", small_bed() + kMesh + mesh_wall() +
                         "fix mbd all couple/mbd every 7 end script mesh m plate\nrun 100\nunfix mbd\nrun 50\nprint "
                         "\"went on alone\"\n");
  const Outcome outcome = folder.coupled(2, "-in in", until);
  EXPECT_NE(outcome.text.find("went on alone"), std::string::npos) << outcome.text;
  EXPECT_EQ(count(outcome.text, "liggghts_mbd: ERROR"), 0U) << outcome.text;
  EXPECT_NE(outcome.text.find("scripted_partner: the script has ended in window 14"), std::string::npos)
      << outcome.text;  // 100 = 14 * 7 + 2
  EXPECT_EQ(outcome.exit_code, 0);
}

// A belt that runs round a plate at rest, and one on a plate that moves: LIGGGHTS' own bits in the first case.
TEST(UsersScript, AConveyorAtRestGivesTheBitsOfStock) {
  const RunFolder folder = plate_folder("belt");
  const std::string belt = "fix m all mesh/surface file plate.stl type 2 move 0 0 0.215 surface_vel 1. 0. 0.\n";
  const auto script = [&](const std::string& name, const std::string& mover) {
    return small_bed() + belt + mesh_wall() + mover + dump_every(400, name) + "run 400\n";
  };
  folder.write("in.stock", script("stock", ""));
  folder.write("in.ours", script("ours", kCouple));
  const Outcome stock = folder.alone(kStock, 1, "-in in.stock");
  const Outcome ours = folder.coupled(1, "-in in.ours",
                                      "until 0.02 out table.csv body plate plate.stl 0 0 0.215 prescribed 0 0 0 0 0 0");
  ASSERT_EQ(stock.exit_code, 0) << stock.text;
  ASSERT_EQ(ours.exit_code, 0) << ours.text;
  EXPECT_TRUE(folder.read("stock.400") == folder.read("ours.400"));
  const std::vector<double> fx = Table(folder.path() / "table.csv")["fx"];
  EXPECT_LT(*std::min_element(fx.begin(), fx.end()), -1.0);  // the grains hold the belt back
}

// What the grains feel is the sum of both velocities: a belt that runs back as fast as its plate goes forward stands.
TEST(UsersScript, ABeltRunsOnTheBody) {
  const RunFolder folder("foreign_belt_moves");
  write_stl((folder.path() / "plate.stl").string(), box({0.56, 0.56, 0.02}, 3));  // no grain at its edges
  const std::string height = "0.21";
  const auto pull = [&](const std::string& belt, const std::string& motion) {
    folder.write("in", small_bed() + "fix m all mesh/surface file plate.stl type 2 move 0 0 " + height + " " + belt +
                           "\n" + mesh_wall() + kCouple + "run 40\n");
    const Outcome outcome = folder.coupled(
        1, "-in in", "until 0.002 out table.csv body plate plate.stl 0 0 " + height + " prescribed " + motion);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    const Table table(folder.path() / "table.csv");
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < table.rows(); ++k) mean += table.vector(k, "fx", "fy", "fz") / 8.0;
    return mean;
  };
  const double rests = pull("", "0 0 0 0 0 0")[0];
  const double moves = pull("", "1 0 0 0 0 0")[0];
  const double back = pull("surface_vel -1. 0. 0.", "1 0 0 0 0 0")[0];
  EXPECT_LT(moves, rests - 10.0);
  EXPECT_LT(std::abs(back - rests), 0.1 * std::abs(moves - rests)) << "of " << moves - rests;  // 2 mm of way alone
}

// A round plate turns by 90 degrees in 2 ms below a grain on its axis, which its belt drags: the belt's direction turns with it.
TEST(UsersScript, ABeltTurnsWithItsBody) {
  const RunFolder folder("foreign_belt_turns");
  constexpr int kSides = 24;
  Surface disc;
  disc.nodes.resize(3, 2 * kSides + 2);
  for (int i = 0; i < kSides; ++i) {
    const double a = 2.0 * M_PI * i / kSides;
    disc.nodes.col(i) = Eigen::Vector3d(0.1 * std::cos(a), 0.1 * std::sin(a), 0.01);
    disc.nodes.col(kSides + i) = disc.nodes.col(i) - Eigen::Vector3d(0.0, 0.0, 0.02);
  }
  const int top = 2 * kSides, bottom = top + 1;
  disc.nodes.col(top) = Eigen::Vector3d(0.0, 0.0, 0.01);
  disc.nodes.col(bottom) = Eigen::Vector3d(0.0, 0.0, -0.01);
  for (int i = 0; i < kSides; ++i) {
    const int j = (i + 1) % kSides;
    for (const Eigen::Vector3i& t : {Eigen::Vector3i(top, i, j), Eigen::Vector3i(bottom, kSides + j, kSides + i),
                                     Eigen::Vector3i(kSides + i, kSides + j, j), Eigen::Vector3i(kSides + i, j, i)})
      disc.triangles.push_back(t);
  }
  write_stl((folder.path() / "disc.stl").string(), disc);
  folder.write("in", script_head("-0.3 0.3 -0.3 0.3 -0.1 0.3") +
                         "create_atoms 1 single 0 0 0.02995 units box\nset group all diameter 0.04 density 2600\n"
                         "fix hold all spring/self 1e6\nfix integr all nve/sphere\n"
                         "fix m all mesh/surface file disc.stl type 2 surface_vel 100. 0. 0.\n" +
                         mesh_wall() + "fix mbd all couple/mbd every 5 mesh m disc\nrun 40\n");
  const double spin = 785.398;  // [rad/s]
  const Outcome outcome =
      folder.coupled(1, "-in in", "until 0.002 out table.csv body disc disc.stl 0 0 0 prescribed 0 0 0 0 0 785.398");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const Table table(folder.path() / "table.csv");
  ASSERT_EQ(table.rows(), 8U);
  for (std::size_t k = 1; k < table.rows(); ++k) {  // the first contact has the damping of its impact
    const Eigen::Vector3d F = table.vector(k, "fx", "fy", "fz");
    const double middle = spin * 2.5e-4 * (static_cast<double>(k) + 0.5);
    // Coulomb's friction against the belt; a window's mean is half a time step, 0.02 rad, late.
    EXPECT_NEAR(F.head<2>().norm(), 0.3 * std::abs(F.z()), 0.02 * std::abs(F.z())) << k;
    EXPECT_NEAR(std::atan2(-F.y(), -F.x()), middle, 0.06) << k;
  }
}

TEST(UsersScript, SeveralMeshesMayMakeUpABody) {
  const RunFolder folder = plate_folder("parts");
  const Surface whole = read_stl((folder.path() / "plate.stl").string());
  const auto part = [&](const std::string& name, bool upper) {
    Surface some = whole;
    some.triangles.clear();
    for (const Eigen::Vector3i& t : whole.triangles) {
      const bool on_top = whole.nodes(2, t[0]) > 0 && whole.nodes(2, t[1]) > 0 && whole.nodes(2, t[2]) > 0;
      if (on_top == upper) some.triangles.push_back(t);
    }
    write_stl((folder.path() / name).string(), some);
  };
  part("top.stl", true);
  part("rest.stl", false);
  const std::string wall = "fix w all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes ";
  const auto loads = [&](const std::string& meshes, const std::string& pairs) {
    folder.write("in", small_bed() + meshes + "fix mbd all couple/mbd every 5 " + pairs + "\n" +
                           "thermo_style custom step atoms f_mbd[1][3]\nrun 200\n");
    const Outcome outcome = folder.coupled(2, "-in in", kRun);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    const Table table(folder.path() / "table.csv");
    return table.vector(table.rows() - 1, "fx", "fy", "fz");
  };
  const Eigen::Vector3d one = loads(kMesh + wall + "1 meshes m\n", "mesh m plate");
  const Eigen::Vector3d two = loads(
      "fix t all mesh/surface file top.stl type 1 move 0 0 0.24\n"
      "fix r all mesh/surface file rest.stl type 2 move 0 0 0.24\n" +
          wall + "2 meshes t r\n",
      "mesh t plate mesh r plate");
  EXPECT_GT(one.norm(), 100.0);
  // grains touch the lower face only; the order of sums differs
  EXPECT_LT((one - two).norm(), 1e-7 * one.norm());
}

// A rotor: a hub and ten blades, each a mesh of its own, by turns of one material and the other. As one body it feels what
// eleven bodies feel that move alike.
TEST(UsersScript, ARotorOfElevenMeshesOfTwoMaterialsIsTheSumOfThem) {
  const RunFolder folder("foreign_rotor");
  constexpr int kParts = 11;
  Surface rotor;
  std::vector<Eigen::Vector3d> nodes;
  std::string parts, single_meshes, single_geometry, pairs, single_pairs, bodies, wall = "11 meshes";
  const std::string motion = " 0 0 0.05 prescribed 0 0 -0.3 0 15 0";
  for (int k = 0; k < kParts; ++k) {
    Surface part = box(k == 0 ? Eigen::Vector3d(0.05, 0.2, 0.05) : Eigen::Vector3d(0.05, 0.03, 0.01), 1);
    if (k > 0) {
      part.nodes.row(0).array() += 0.06;
      const Eigen::Vector3d along(0.0, -0.09 + 0.018 * k, 0.0);
      part.nodes =
          (Eigen::AngleAxisd(0.5 * M_PI - 0.08 * k, Eigen::Vector3d::UnitY()).toRotationMatrix() * part.nodes).eval();
      part.nodes.colwise() += along;
    }
    const std::string id = std::to_string(k);
    write_stl((folder.path() / ("part_" + id + ".stl")).string(), part);
    const int first = static_cast<int>(nodes.size());
    for (const auto& node : part.nodes.colwise()) nodes.push_back(node);
    for (const Eigen::Vector3i& t : part.triangles) rotor.triangles.push_back(t.array() + first);
    parts += "fix s" + id + " all mesh/surface file part_" + id + ".stl type " + std::to_string(1 + k % 2) +
             " move 0 0 0.05\n";
    pairs += " mesh s" + id + " rotor";
    single_pairs += " mesh s" + id + " part_" + id;
    bodies += " body part_" + id + " part_" + id + ".stl" + motion;
    wall += " s" + id;
  }
  rotor.nodes.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t j = 0; j < nodes.size(); ++j) rotor.nodes.col(static_cast<Eigen::Index>(j)) = nodes[j];
  write_stl((folder.path() / "rotor.stl").string(), rotor);
  // Grains that do not touch each other, each on a spring of its own: small differences stay small.
  const std::string head =
      script_head("-0.3 0.3 -0.3 0.3 -0.3 0.3") +
      "lattice sc 0.05\nregion grains block -0.2 0.2 -0.2 0.2 -0.07 -0.03 units box\n"
      "create_atoms 1 region grains\nset group all diameter 0.04 density 2600\n"
      "fix hold all spring/self 4000\nfix integr all nve/sphere\n" +
      parts + "fix w all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes " + wall + "\n";
  const auto loads = [&](const std::string& mesh_of_body, const std::string& of_bodies) {
    folder.write("in", head + "fix mbd all couple/mbd every 20" + mesh_of_body + "\nthermo 500\nrun 2000\n");
    const Outcome outcome = folder.coupled(2, "-in in", "until 0.06 out table.csv" + of_bodies);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    return Table(folder.path() / "table.csv");
  };
  const Table one = loads(pairs, " body rotor rotor.stl" + motion), eleven = loads(single_pairs, bodies);
  ASSERT_EQ(eleven.rows(), kParts * one.rows());
  double largest = 0.0;
  std::size_t touched = 0;
  for (const char* name : {"fx", "fy", "fz", "mx", "my", "mz", "contacts"}) {
    double scale = 0.0;
    for (const double value : one[name]) scale = std::max(scale, std::abs(value));
    EXPECT_GT(scale, 0.0) << name;
    for (std::size_t i = 0; i < one.rows(); ++i) {
      double sum = 0.0;
      for (int k = 0; k < kParts; ++k) sum += eleven[name][kParts * i + static_cast<std::size_t>(k)];
      EXPECT_NEAR(one[name][i], sum, 1e-9 * scale) << name << " row " << i;  // the order of sums differs
      largest = std::max(largest, std::abs(one[name][i] - sum) / scale);
    }
  }
  for (int k = 0; k < kParts; ++k) {
    double contacts = 0.0;
    for (std::size_t i = 0; i < one.rows(); ++i)
      contacts += eleven["contacts"][kParts * i + static_cast<std::size_t>(k)];
    touched += contacts > 0.0;
  }
  std::printf("%zu of %d meshes touched; largest difference %.2g\n", touched, kParts, largest);
  EXPECT_GE(touched, 8U);
}

}  // namespace scripts
}  // namespace footfall::test

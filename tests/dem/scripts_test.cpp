// What a LIGGGHTS script may do with a coupled run.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

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
  const auto run = [&](const std::string& name, const std::string& more, const std::string& said) {
    folder.write("in", small_bed() + kMeshFromFile + mesh_wall() + more + couple(5) + kThermo + dump_every(400, name) +
                           "run 400\n");
    const Outcome outcome =
        folder.coupled(2, "-in in -log log." + name,
                       "until 0.02 out " + name + ".csv body plate plate.stl 0 0 0.24 free 3 0 0.1 -0.05 -1.0 0 0 0");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    EXPECT_NE(folder.read("log." + name).find("fix mbd (couple/mbd): grains " + said), std::string::npos)
        << folder.read("log." + name);
  };
  run("ahead", "", "go ahead while the mechanism moves");
  run("waits",
      "region here block -0.1 0.1 -0.1 0.1 0 0.6 units box\n"
      "fix mark all property/atom/tracer region_mark here mark_step 10\n",
      "wait for the mechanism at the start of each window, because of fix mark (property/atom/tracer)");
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
  const std::string said = " spheres belong to none and stand still";
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
  // one that stays inside: the same force, and the same slopes for scheme tangent.
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

}  // namespace
}  // namespace footfall::test

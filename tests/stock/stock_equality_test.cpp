// liggghts_mbd is LIGGGHTS, and a plate moved by the coupling is a plate moved by `fix move/mesh`.

#include <gtest/gtest.h>

#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

const Eigen::Vector3d kPlate(0.3, 0.3, 0.02);  // [m], starts above the bed and touches it

std::string thermo(const std::string& columns = "f_m[1] f_m[2] f_m[3] f_m[4] f_m[5] f_m[6]") {
  return "thermo_style custom step atoms " + columns + "\nthermo 50\nthermo_modify norm no format float %.17g\n";
}

void expect_same_dumps(const RunFolder& folder, const std::string& a, const std::string& b,
                       const std::vector<int>& steps) {
  for (const int step : steps)
    EXPECT_TRUE(folder.read(a + "." + std::to_string(step)) == folder.read(b + "." + std::to_string(step)))
        << "dumps differ at step " << step;
}

// The script that `script` writes for a name of its dumps ends well in both programs, with the same dumps and lines of thermo.
template <class Script>
void expect_same_run(const RunFolder& folder, int ranks, const Script& script, const std::vector<int>& dumps) {
  folder.write("in.stock", script("stock"));
  folder.write("in.ours", script("ours"));
  const Outcome stock = folder.alone(kStock, ranks, "-in in.stock -log log.stock");
  const Outcome ours = folder.alone(RunFolder::program("liggghts_mbd"), ranks, "-in in.ours -log log.ours");
  ASSERT_EQ(stock.exit_code, 0) << stock.text;
  ASSERT_EQ(ours.exit_code, 0) << ours.text;
  expect_same_dumps(folder, "stock", "ours", dumps);
  EXPECT_EQ(thermo_lines(folder.read("log.stock")), thermo_lines(folder.read("log.ours")));
}

class OnRanks : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Ranks, OnRanks, testing::Values(1, 2), testing::PrintToStringParamName());

TEST_P(OnRanks, AScriptWithoutOurFixesGivesTheSameBits) {
  const int ranks = GetParam();
  const RunFolder folder("stock_plain_" + std::to_string(ranks));
  write_stl((folder.path() / "plate.stl").string(), box(kPlate, 3));
  const auto script = [&](const std::string& name) {
    return small_bed(ranks == 1 ? "1 1 1" : "2 1 1") +
           "fix m all mesh/surface/stress file plate.stl type 2 move 0 0 0.24\n" + mesh_wall() +
           "fix c all move/mesh mesh m linear 0 0 -1.0\n" + thermo() + dump_every(150, name) + "run 450\n";
  };
  expect_same_run(folder, ranks, script, {0, 150, 300, 450});
}

// What the end of each run tells of its last neighbour list.
std::vector<std::string> neighbours_told(const std::string& log) {
  std::istringstream lines(log);
  std::vector<std::string> told;
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("Total # of neighbors", 0) == 0) told.push_back(line);
  return told;
}

// Neighbour lists are made by a member of ours: grains of six sizes from 4 to 60 mm in a box that goes on at its sides, small
// ones between large ones, some pairs left out, and grains that come in later.
TEST_P(OnRanks, GrainsOfManySizesGiveTheSameBitsAndLists) {
  const int ranks = GetParam();
  const RunFolder folder("stock_sizes_" + std::to_string(ranks));
  const auto script = [&](const std::string& name) {
    std::ostringstream text;
    std::string head = script_head("-0.2 0.2 -0.2 0.2 0 0.6", ranks == 1 ? "1 1 1" : "2 1 1", 1e-5);
    text << head.replace(head.find("boundary f f f"), 14, "boundary p p f")
         << "fix grav all gravity 100 vector 0 0 -1\n"
            "fix floor all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 zplane 0.0\n";
    const int seeds[] = {15485863, 15485867, 32452843, 32452867, 49979687, 49979693};
    const double radii[] = {0.002, 0.004, 0.007, 0.011, 0.018, 0.03}, shares[] = {0.002, 0.008, 0.05, 0.14, 0.3, 0.5};
    std::ostringstream mixture;
    for (int k = 0; k < 6; ++k) {
      text << "fix t" << k << " all particletemplate/sphere " << seeds[k] << " atom_type " << 1 + k % 2
           << " density constant 2600 radius constant " << radii[k] << "\n";
      mixture << " t" << k << " " << shares[k];
    }
    text << "fix mix all particledistribution/discrete 67867967 6" << mixture.str()
         << "\nregion fill block -0.2 0.2 -0.2 0.2 0.0 0.5 units box\n"
            "fix fill all insert/pack seed 67867979 distributiontemplate mix insert_every 1000 overlapcheck yes "
            "all_in yes vel constant 0 0 -3 volumefraction_region 0.3 region fill\n"
            "fix integr all nve/sphere\nneighbor 0.003 bin\nneigh_modify delay 0 exclude type 1 2\n"
            "thermo_style custom step atoms ke\nthermo 50\nthermo_modify norm no format float %.17g\n"
         << dump_every(1000, name);
    for (int run = 0; run < 10; ++run) text << "run 200\n";  // each tells the neighbours of its last list
    return text.str();
  };
  expect_same_run(folder, ranks, script, {0, 1000, 2000});
  const std::vector<std::string> told = neighbours_told(folder.read("log.stock"));
  EXPECT_EQ(told.size(), 10u);
  EXPECT_EQ(told, neighbours_told(folder.read("log.ours")));
}

// Bins are 32 mm wide, as large grains ask for, and small ones on a lattice of 32.47 mm are neighbours up to 32.5 mm: some of
// them with an empty bin between.
TEST_P(OnRanks, NeighboursWithAnEmptyBinBetweenStandInTheList) {
  const int ranks = GetParam();
  const RunFolder folder("stock_bins_" + std::to_string(ranks));
  const auto script = [&](const std::string&) {
    return script_head("-0.32 0.32 -0.32 0.32 -0.32 0.32", ranks == 1 ? "1 1 1" : "1 1 2") +
           "lattice sc 0.03247\nregion small block -0.3 0.3 -0.3 0.3 -0.3 0.2 units box\n"
           "create_atoms 1 region small\nset type 1 diameter 0.0295 density 2600\n"
           "create_atoms 2 single 0 0 0.27 units box\nset type 2 diameter 0.06 density 2600\n"
           "neighbor 0.003 bin\nfix integr all nve/sphere\nrun 0\n";
  };
  expect_same_run(folder, ranks, script, {});
  const std::vector<std::string> told = neighbours_told(folder.read("log.stock"));
  EXPECT_EQ(told.size(), 1u);
  EXPECT_EQ(told, neighbours_told(folder.read("log.ours")));
}

// A plate goes down at (0.1, -0.05, speed) m/s until `end` [s], moved by fix move/mesh in stock LIGGGHTS and through the
// coupling: the same dumps and lines of thermo. `script` takes a name for its dumps and the mover. Gives the force on the
// plate at the end [N].
template <class Script>
double force_of_plate_as_in_stock(const RunFolder& folder, int ranks, const Script& script, const std::string& speed,
                                  const std::string& end, const std::vector<int>& dumps) {
  write_stl((folder.path() / "plate.stl").string(), box(kPlate, 3));
  folder.write("in.stock", script("stock", "fix c all move/mesh mesh m linear 0.1 -0.05 " + speed + "\n"));
  folder.write("in.ours", script("ours", "fix mbd all couple/mbd every 5 mesh m plate\n"));
  const Outcome stock = folder.alone(kStock, ranks, "-in in.stock -log log.stock");
  const Outcome ours =
      folder.coupled(ranks, "-in in.ours -log log.ours",
                     "until " + end + " body plate plate.stl 0 0 0.24 prescribed 0.1 -0.05 " + speed + " 0 0 0");
  EXPECT_EQ(stock.exit_code, 0) << stock.text;
  EXPECT_EQ(ours.exit_code, 0) << ours.text;
  if (stock.exit_code != 0 || ours.exit_code != 0) return 0.0;
  expect_same_dumps(folder, "stock", "ours", dumps);
  const auto lines = thermo_lines(folder.read("log.ours"));
  EXPECT_EQ(thermo_lines(folder.read("log.stock")), lines);
  return std::stod(lines.back()[4]);
}

TEST_P(OnRanks, APlateInTranslationGivesTheBitsOfMoveMesh) {
  const int ranks = GetParam();
  const RunFolder folder("stock_translation_" + std::to_string(ranks));
  const auto script = [&](const std::string& name, const std::string& mover) {
    return small_bed(ranks == 1 ? "1 1 1" : "2 1 1") +
           "fix m all mesh/surface/stress file plate.stl type 2 move 0 0 0.24\n" + mesh_wall() + mover + thermo() +
           dump_every(200, name) + "run 1000\n";
  };
  EXPECT_GT(force_of_plate_as_in_stock(folder, ranks, script, "-1.0", "0.05", {0, 200, 400, 600, 800, 1000}),
            1000.0);  // the plate is well inside the bed [N]
}

// Clumps of two spheres (fix multisphere, below all walls) that fall on a floor under a plate that comes down.
TEST_P(OnRanks, ClumpsUnderAPlateInTranslationAreThoseOfStock) {
  const int ranks = GetParam();
  const RunFolder folder("stock_clumps_" + std::to_string(ranks));
  const auto script = [&](const std::string& name, const std::string& mover) {
    return script_head("-0.3 0.3 -0.3 0.3 -0.05 0.6", ranks == 1 ? "1 1 1" : "2 1 1") +
           "fix grav all gravity 9.81 vector 0 0 -1\nfix floor all wall/gran model hertz tangential history "
           "rolling_friction cdt primitive type 1 zplane 0.0\n"
           "fix pts all particletemplate/multisphere 15485863 atom_type 1 density constant 2600 nspheres 2 ntry 100000 "
           "spheres -0.017 0 0 0.02 0.017 0 0 0.02 type 1\nfix pdd all particledistribution/discrete 15485867 1 pts "
           "1.0\n"
           "region ins block -0.15 0.15 -0.15 0.15 0.0 0.22 units box\nfix ins all insert/pack seed 32452843 "
           "distributiontemplate pdd vel constant 0 0 -1.0 insert_every once overlapcheck yes all_in yes orientation "
           "random particles_in_region 60 region ins\n"
           "fix m all mesh/surface/stress file plate.stl type 2 move 0 0 0.24\n" +
           mesh_wall() + "fix integr all multisphere\n" + mover + thermo() + dump_every(200, name) + "run 600\n";
  };
  EXPECT_GT(force_of_plate_as_in_stock(folder, ranks, script, "-2.0", "0.03", {200, 400, 600}),
            10.0);  // the plate is on the clumps [N]
}

TEST_P(OnRanks, APlateInRotationGivesMoveMeshToRoundOff) {
  // Both turn the same plate, in other arithmetic: a chaotic bed multiplies round-off, so the run is short.
  const int ranks = GetParam();
  const RunFolder folder("stock_rotation_" + std::to_string(ranks));
  write_stl((folder.path() / "plate.stl").string(), box(kPlate, 3));
  const auto script = [&](const std::string& name, const std::string& mover) {
    return small_bed(ranks == 1 ? "1 1 1" : "2 1 1") +
           "fix m all mesh/surface/stress file plate.stl type 2 move 0 0 0.2365\n" + mesh_wall() + mover + thermo() +
           dump_every(100, name) + "run 200\n";
  };
  constexpr double kPeriod = 3.0;  // [s]
  folder.write("in.stock",
               script("stock", "fix c all move/mesh mesh m rotate origin 0 0 0.2365 axis 0 1 0 period 3.0\n"));
  folder.write("in.ours", script("ours", "fix mbd all couple/mbd every 5 mesh m plate\n"));
  const Outcome stock = folder.alone(kStock, ranks, "-in in.stock -log log.stock");
  std::ostringstream partner;
  partner.precision(17);
  partner << "until 0.01 body plate plate.stl 0 0 0.2365 prescribed 0 0 0 0 " << 2.0 * M_PI / kPeriod << " 0";
  const Outcome ours = folder.coupled(ranks, "-in in.ours -log log.ours", partner.str());
  ASSERT_EQ(stock.exit_code, 0) << stock.text;
  ASSERT_EQ(ours.exit_code, 0) << ours.text;
  const auto a = read_dump(folder.read("stock.200")), b = read_dump(folder.read("ours.200"));
  ASSERT_EQ(a.size(), b.size());
  double position = 0.0, velocity = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t c = 1; c < 7; ++c)
      (c < 4 ? position : velocity) = std::max(c < 4 ? position : velocity, std::abs(a[i][c] - b[i][c]));
  std::printf("largest difference after 200 steps: %.2g m, %.2g m/s\n", position, velocity);
  EXPECT_LT(position, 1e-13);  // 200 steps of round-off (1e-17 m each at 0.2 m) through contacts of 1e6 N/m
  EXPECT_LT(velocity, 1e-10);
  const auto stock_lines = thermo_lines(folder.read("log.stock")), lines = thermo_lines(folder.read("log.ours"));
  ASSERT_EQ(stock_lines.size(), lines.size());
  for (std::size_t i = 1; i < lines.size(); ++i)
    for (std::size_t c = 2; c < 8; ++c)
      EXPECT_NEAR(std::stod(lines[i][c]), std::stod(stock_lines[i][c]), 1e-6) << "column " << c << " line " << i;
  EXPECT_GT(std::stod(lines.back()[4]), 10.0);  // it does press on grains [N]
}

TEST(Launcher, ScreenNoneWorksWithAMesh) {
  const RunFolder folder("stock_screen_none");
  write_stl((folder.path() / "plate.stl").string(), box(kPlate, 3));
  folder.write("in",
               small_bed() + "fix m all mesh/surface file plate.stl type 2 move 0 0 0.24\n" + mesh_wall() + "run 1\n");
  const Outcome ours = folder.alone(RunFolder::program("liggghts_mbd"), 1, "-in in -screen none -log log");
  EXPECT_EQ(ours.exit_code, 0) << ours.text;
  EXPECT_EQ(ours.text, "");
}

TEST(Launcher, AScriptErrorEndsWithTheExitCodeAndWordsOfStock) {
  const RunFolder folder("stock_script_error");
  folder.write("in", "units si\nno_such_command\n");
  const Outcome stock = folder.alone(kStock, 1, "-in in");
  const Outcome ours = folder.alone(RunFolder::program("liggghts_mbd"), 1, "-in in");
  EXPECT_EQ(ours.exit_code, stock.exit_code);
  EXPECT_NE(ours.exit_code, 0);
  EXPECT_EQ(count(ours.text, "ERROR: Unknown command: no_such_command"),
            count(stock.text, "ERROR: Unknown command: no_such_command"));
}

}  // namespace
}  // namespace footfall::test

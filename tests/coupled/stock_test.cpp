// The same bits as stock LIGGGHTS.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <map>
#include <regex>
#include <sstream>

#include "tests/coupled/coupled_run.h"

namespace footfall::test {
namespace stock {

// liggghts_mbd is LIGGGHTS, and a plate moved by the coupling is a plate moved by `fix move/mesh`.

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

// Neighbour lists are made by a member of ours: grains of six sizes from 4 to 60 mm in a box that is periodic at its sides, small
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

// Pair forces are computed by a member of ours, of two types of grains, for each setting of the models that it knows; it leaves those it does not know
// (the last three) to LIGGGHTS.
TEST_P(OnRanks, PairForcesOfEveryModelAreThoseOfStock) {
  const int ranks = GetParam();
  const std::string history = "model hertz tangential history";
  int number = 0;
  for (const std::string& model :
       {history, history + " tangential_damping off limitForce on", history + " rolling_friction cdt limitForce on",
        history + " rolling_friction cdt torsionTorque on",
        history + " rolling_friction cdt tangential_damping off torsionTorque on limitForce on",
        history + " rolling_friction epsd2", history + " rolling_friction cdt computeElasticPotential on",
        std::string("model hooke/stiffness tangential history")}) {
    SCOPED_TRACE(model);
    const RunFolder folder("stock_forces_" + std::to_string(ranks) + "_" + std::to_string(number++));
    const auto script = [&](const std::string& name) {
      std::string bed = small_bed(ranks == 1 ? "1 1 1" : "2 1 1");
      const std::string usual = "pair_style gran " + history + " rolling_friction cdt";
      bed.replace(bed.find(usual), usual.size(), "pair_style gran " + model);
      return bed +
             "fix s1 all property/global kn peratomtypepair 2 1e5 1e5 1e5 1e5\nfix s2 all property/global kt "
             "peratomtypepair 2 3e4 3e4 3e4 3e4\n"
             "fix s3 all property/global gamman peratomtypepair 2 80 80 80 80\nfix s4 all property/global gammat "
             "peratomtypepair 2 40 40 40 40\n"
             "region right block 0 1 -1 1 -1 1 units box\nset region right type 2\nvelocity all set 0.3 0 -2\n" +
             thermo("ke") + dump_every(200, name) + "run 100\nrun 300\n";
    };
    expect_same_run(folder, ranks, script, {0, 200, 400});
  }
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

// Some 6000 bins a grain: a swarm of small grains that fly into one another in a roomy box.
// Formulas of what is computed here, of what is not, and of both.
TEST_P(OnRanks, FormulasForEveryGrainGiveTheSameBits) {
  const int ranks = GetParam();
  const RunFolder folder("stock_formulas_" + std::to_string(ranks));
  const auto script = [&](const std::string& name) {
    return script_head("-0.03 0.03 -0.03 0.03 -0.03 0.03", ranks == 1 ? "1 1 1" : "2 1 1") +
           "lattice sc 0.0062\nregion some block -0.02 0.02 -0.012 0.012 -0.01 0.01 units box\n"
           "create_atoms 1 region some\nset type 1 diameter 0.006 density 2600\nneighbor 0.001 bin\n"
           "velocity all ramp vx 3 -3 x -0.02 0.02 units box\nfix integr all nve/sphere\n"
           "variable drag_x atom -mass*vx*9.81/(0.3+0.1)+1e-3*(x-y)/(2+z)\n"
           "variable drag_y atom -0.02/1e-4*mass*vy+(x<0)*1e-4*sin(40*z)\n"
           "variable drag_z atom -(mass*vz-1e-5)*sqrt(1+vx^2)-mass*v_drag_x/0.01\n"
           "fix drag all addforce v_drag_x v_drag_y v_drag_z\n" +
           thermo("ke") + dump_every(100, name) + "run 300\n";
  };
  expect_same_run(folder, ranks, script, {0, 100, 200, 300});
}

TEST_P(OnRanks, GrainsInARoomyBoxGiveTheSameBits) {
  const int ranks = GetParam();
  const RunFolder folder("stock_roomy_" + std::to_string(ranks));
  const auto script = [&](const std::string& name) {
    return script_head("-0.3 0.3 -0.3 0.3 -0.3 0.3", ranks == 1 ? "1 1 1" : "2 1 1") +
           "lattice sc 0.0062\nregion some block -0.01 0.015 -0.012 0.012 -0.01 0.01 units box\n"
           "create_atoms 1 region some\nset type 1 diameter 0.006 density 2600\nneighbor 0.001 bin\n"
           "velocity all ramp vx 3 -3 x -0.01 0.015 units box\nfix integr all nve/sphere\n" +
           thermo("ke") + dump_every(100, name) + "run 300\n";
  };
  expect_same_run(folder, ranks, script, {0, 100, 200, 300});
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

// LIGGGHTS' cdt, on grains of radius r that overlap by d: mu_r F r*, F = 4/3 E* sqrt(r*) d^1.5, without the damping of the normal force.
// r* = r_i r_j / (r_i + r_j) is r/2 between equal grains, half of [Lin25 23], and r at a wall.
TEST(RollingResistance, IsHalfOfThePublishedTorqueBetweenEqualGrainsAndTheWholeAtWalls) {
  const RunFolder folder("stock_rolling");
  std::string script =
      script_head("-0.3 0.3 -0.3 0.3 -0.05 0.6") +
      "fix floor all wall/gran model hertz tangential history rolling_friction cdt primitive type 2 zplane 0.0\n"
      "create_atoms 1 single 0 0 0.2 units box\ncreate_atoms 1 single 0.0399 0 0.2 units box\n"
      "create_atoms 1 single 0.2 0 0.0199 units box\n"
      "set group all diameter 0.04 density 2600\nset atom 1 omegay 1.0 vx 0.05\nset atom 3 omegay 1.0\n"
      "fix integr all nve/sphere\ndump d all custom 1 dump id tqx tqy tqz fx fz\n"
      "dump_modify d sort id format \"%d %.17g %.17g %.17g %.17g %.17g\"\nrun 0\n";
  const std::string tangential = "tangential history";  // its force would turn the grains too
  for (std::size_t at = 0; (at = script.find(tangential, at)) != std::string::npos;)
    script.replace(at, tangential.size(), "tangential off");
  folder.write("in", script);
  const Outcome outcome = folder.alone(kStock, 1, "-in in");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const Rows grains = read_dump(folder.read("dump"));
  ASSERT_EQ(grains.size(), 3u);
  const double r = 0.02, overlap = 1e-4;
  const double soil = 35e6 / (1.0 - 0.25 * 0.25), steel = 207e9 / (1.0 - 0.1 * 0.1);
  const double on_grain = 4.0 / 3.0 * soil / 2.0 * std::sqrt(r / 2.0) * std::pow(overlap, 1.5);
  const double on_wall = 4.0 / 3.0 / (1.0 / soil + 1.0 / steel) * std::sqrt(r) * std::pow(overlap, 1.5);
  EXPECT_GT(std::abs(grains[0][4]), 1.05 * on_grain) << "the normal force is damped";
  const double round_off = 1e-9;  // of the overlap, a difference of places of 0.2 m
  EXPECT_NEAR(grains[0][2], -0.2 * on_grain * r / 2.0, round_off * on_grain * r);
  EXPECT_NEAR(grains[1][2], 0.2 * on_grain * r / 2.0, round_off * on_grain * r);
  EXPECT_NEAR(grains[2][2], -0.1 * on_wall * r, round_off * on_wall * r);
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

// Stock LIGGGHTS prints that line past its screen; without `-screen none` it stays.
TEST(Launcher, ScreenNoneHidesTheVersionOfARestartFile) {
  const RunFolder folder("stock_restart_version");
  folder.write("in.first", small_bed() + "run 1\nwrite_restart grains.restart\n");
  folder.write("in.second", "atom_style granular\nread_restart grains.restart\n");
  ASSERT_EQ(folder.alone(kStock, 1, "-in in.first -log log.first").exit_code, 0);
  const std::string program = RunFolder::program("liggghts_mbd");
  EXPECT_EQ(count(folder.alone(kStock, 1, "-in in.second -screen none -log log.stock").text, "version 3 8\n"), 1U);
  EXPECT_EQ(count(folder.alone(program, 1, "-in in.second -log log.shown").text, "version 3 8\n"), 1U);
  const Outcome hidden = folder.alone(program, 1, "-in in.second -screen none -log log.hidden");
  EXPECT_EQ(hidden.exit_code, 0) << hidden.text;
  EXPECT_EQ(hidden.text, "");
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

// The examples of LIGGGHTS that Debian packages (liggghts-doc): the same bits from liggghts and from liggghts_mbd; and
// with one of their meshes on a body of ours, loads that are LIGGGHTS' own wall forces.

namespace fs = std::filesystem;

const fs::path kExamples = "/usr/share/doc/liggghts/examples/LIGGGHTS/Tutorials_public";

using Words = std::vector<std::string>;

Words words_of(const std::string& line) {
  std::istringstream in(line.substr(0, line.find('#')));
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// The lines of a script; an & at the end of a line continues it in the next.
std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(std::regex_replace(text, std::regex("&[ \t\r]*\n"), " "));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!words_of(line).empty()) lines.push_back(line);
  return lines;
}

bool writes_files(const std::string& command) {
  for (const char* const one : {"dump", "dump_modify", "undump", "restart", "write_restart"})
    if (command == one) return true;
  return false;
}

// A copy of the example, as a folder of its own.
RunFolder copy_of(const std::string& example, const std::string& name) {
  RunFolder folder("debian_" + name);
  fs::copy(kExamples / example, folder.path(), fs::copy_options::recursive);
  fs::create_directories(folder.path() / "post");
  return folder;
}

// ---- without a coupling ----

struct Example {
  const char* folder;
  const char* script;
  int steps;                     // of each of its runs, at most
  const char* before = nullptr;  // script that writes the restart file it continues from
};

class DebianExample : public testing::TestWithParam<Example> {};
INSTANTIATE_TEST_SUITE_P(
    Scripts, DebianExample,
    testing::Values(Example{"chute_wear", "in.chute_wear", 300}, Example{"cohesion", "in.cohesion", 300},
                    Example{"cohesion", "in.noCohesion", 300}, Example{"contactModels", "in.newModels", 300},
                    Example{"contactModels", "in.oldModels", 300}, Example{"conveyor", "in.conveyor", 2000},
                    Example{"heatTransfer_1", "in.heatGran", 300}, Example{"heatTransfer_2", "in.heatGran", 300},
                    Example{"hydrogel_multicontact", "in.hydrogel_default", 200},
                    Example{"hydrogel_multicontact", "in.hydrogel_multicontact", 200},
                    Example{"hysteresis", "in.hysteresis", 300}, Example{"hysteresis", "in.noHysteresis", 300},
                    Example{"insert_stream", "in.insert_stream", 300}, Example{"mesh_tet", "in.mesh_tet", 300},
                    Example{"insert_stream", "in.insert_stream_reset_timestep", 300, "in.insert_stream"},
                    Example{"meshGran", "in.meshGran", 500}, Example{"movingMeshGran", "in.movingMeshGran", 300},
                    Example{"multisphere_stone_restitution", "in.multisphere", 300},
                    Example{"packing", "in.packing", 200}, Example{"sph_1", "in.sph_1", 100},
                    Example{"sph_2", "in.sph_2", 100}, Example{"superquadric", "in.particle_particle", 100}),
    [](const auto& one) {
      const std::string name = std::string(one.param.folder) + "_" + (one.param.script + 3);
      return std::regex_replace(name, std::regex("[^A-Za-z0-9]"), "_");
    });

// Its runs cut short, no files but a restart file at the end, and all state.
std::string shortened(const std::string& text, int steps) {
  std::string s;
  for (const std::string& line : lines_of(text)) {
    const Words w = words_of(line);
    if (writes_files(w[0]) && w[0] != "write_restart") continue;
    s += w[0] == "run" && w.size() > 1 && w[1] != "0" && w[1] != "1" ? "run " + std::to_string(steps) : line;
    s += "\n";
  }
  return s +
         "dump last all custom 1 ${name}.last id type x y z vx vy vz fx fy fz\ndump_modify last sort id format "
         "\"%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\nrun 0\n";
}

// Of grains that fix insert/stream has read from a restart file, LIGGGHTS 3.8 writes velocities from memory that nobody
// has set: numbers of 1e-310, others in every run of the same program. They count as zero.
std::string last_state(const RunFolder& folder, const std::string& name) {
  return std::regex_replace(folder.read(name + ".last"), std::regex("-?[0-9.]+e-3[012][0-9]"), "0");
}

TEST_P(DebianExample, GivesTheSameBitsOnBothPrograms) {
  if (!fs::exists(kExamples)) GTEST_SKIP() << kExamples << " is missing: the package liggghts-doc is not installed";
  const Example example = GetParam();
  const RunFolder folder = copy_of(example.folder, std::string(example.folder) + example.script);
  const auto run = [&](const std::string& program, const std::string& name) {
    return folder.alone(program, 1, "-in in.short -var name " + name + " -log log." + name, 60);
  };
  if (example.before != nullptr) {
    folder.write("in.short", shortened(folder.read(example.before), example.steps));
    ASSERT_EQ(run(kStock, "before").exit_code, 0);
  }
  folder.write("in.short", shortened(folder.read(example.script), example.steps));
  const Outcome stock = run(kStock, "stock"), ours = run(RunFolder::program("liggghts_mbd"), "ours");
  EXPECT_EQ(stock.exit_code, ours.exit_code) << ours.text;
  if (stock.exit_code != 0) {
    // What Debian does not compile in ends both with the same words. (Of what a rank prints before it aborts, mpirun may
    // pass on nothing.)
    const auto errors = [&](const std::string& name) { return count(folder.read("log." + name), "ERROR"); };
    EXPECT_GT(errors("stock"), 0u);
    EXPECT_EQ(errors("stock"), errors("ours"));
    std::printf("not run by Debian's LIGGGHTS: %s\n", example.script);
    return;
  }
  const std::string last = last_state(folder, "stock");
  EXPECT_TRUE(last == last_state(folder, "ours")) << "the grains differ";
  std::printf("%zu lines of grains\n", count(last, "\n"));
}

// ---- with a coupling ----

struct Mounted {
  const char* folder;
  const char* script;
  const char* mesh;      // id of its fix mesh/surface
  const char* velocity;  // of the body [m/s]
  int steps;
  int ranks;
};

class DebianMesh : public testing::TestWithParam<Mounted> {};
INSTANTIATE_TEST_SUITE_P(Bodies, DebianMesh,
                         testing::Values(Mounted{"movingMeshGran", "in.movingMeshGran", "cad1", "-0.5 0 -0.3", 300, 1},
                                         Mounted{"movingMeshGran", "in.movingMeshGran", "cad1", "0 0 0", 300, 2},
                                         Mounted{"conveyor", "in.conveyor", "cv", "0 0 0", 3600, 1},
                                         Mounted{"chute_wear", "in.chute_wear", "cad", "0 0 0", 2300, 1},
                                         Mounted{"meshGran", "in.meshGran", "cad", "0 0 0", 2500, 1},
                                         Mounted{"hydrogel_multicontact", "in.hydrogel_default", "piston_m",
                                                 "0 0 -0.05", 3000, 1}),
                         [](const auto& one) { return std::string(one.param.mesh) + "_" + std::to_string(one.index); });

// Moves, scales and turns a surface as the words behind `file FILE` do, in their order.
void place(const Words& w, Surface& surface) {
  for (std::size_t i = 0; i + 1 < w.size(); ++i) {
    const auto number = [&](std::size_t k) { return std::stod(w.at(i + k)); };
    if (w[i] == "move") surface.nodes.colwise() += Eigen::Vector3d(number(1), number(2), number(3));
    if (w[i] == "scale") surface.nodes *= number(1);
    if (w[i] == "rotate") {
      const Eigen::Vector3d axis(number(2), number(3), number(4));
      const Eigen::Matrix3d R = Eigen::AngleAxisd(number(6) * M_PI / 180.0, axis.normalized()).toRotationMatrix();
      surface.nodes = (R * surface.nodes).eval();
    }
  }
}

// The example up to its first long run, with grains that are thrown down faster, and with its mesh on a body.
std::string with_body(const RunFolder& folder, const Mounted& mounted, double& dt) {
  std::string s;
  std::map<std::string, std::string> numbers;  // `variable NAME equal NUMBER`
  for (std::string one : lines_of(folder.read(mounted.script))) {
    for (const auto& [name, value] : numbers) {
      const std::string use = "${" + name + "}";
      for (std::size_t at = one.find(use); at != std::string::npos; at = one.find(use))
        one.replace(at, use.size(), value);
    }
    if (const Words v = words_of(one); v.size() == 4 && v[0] == "variable" && v[2] == "equal") numbers[v[1]] = v[3];
    std::string line =
        std::regex_replace(one, std::regex("vel constant 0\\.?0? 0\\.?0? -1\\.?0?"), "vel constant 0 0 -8");
    Words w = words_of(line);
    const std::string style = w[0] == "fix" && w.size() > 3 ? w[3] : "";
    if (writes_files(w[0]) || w[0] == "thermo_style" || w[0] == "thermo" || w[0] == "unfix" || style == "move/mesh")
      continue;
    if (w[0] == "run") continue;
    if (w[0] == "timestep") dt = std::stod(w.at(1));
    if (style.rfind("mesh/surface", 0) == 0 && w[1] == mounted.mesh) {
      w[3] = "mesh/surface/stress";
      const auto file = std::find(w.begin(), w.end(), "file");
      Surface surface = read_stl((folder.path() / *(file + 1)).string());
      place(w, surface);
      write_stl((folder.path() / "body.stl").string(), surface);
      *(file + 1) = "body.stl";
      line.clear();
      for (std::size_t i = 0; i < w.size(); ++i) {
        const std::size_t taken = w[i] == "move" ? 4 : w[i] == "scale" ? 2 : w[i] == "rotate" ? 7 : 0;
        i += taken > 0 ? taken - 1 : 0;
        if (taken == 0) line += w[i] + " ";
      }
    }
    s += line + "\n";
  }
  const std::string mesh = mounted.mesh;
  return s + "fix mbd all couple/mbd every 1 gravity script mesh " + mesh + " body\nthermo_style custom step f_" +
         mesh + "[1] f_" + mesh + "[2] f_" + mesh +
         "[3]\nthermo 1\nthermo_modify norm no lost ignore format float %.17g\nrun " + std::to_string(mounted.steps) +
         "\n";
}

TEST_P(DebianMesh, OnABodyHasTheLoadsOfLiggghts) {
  if (!fs::exists(kExamples)) GTEST_SKIP() << kExamples << " is missing: the package liggghts-doc is not installed";
  const Mounted mounted = GetParam();
  const RunFolder folder = copy_of(mounted.folder, std::string("mesh_") + mounted.mesh + std::to_string(mounted.ranks) +
                                                       (mounted.velocity[0] == '-' ? "m" : ""));
  double dt = 0.0;
  folder.write("in.body", with_body(folder, mounted, dt));
  std::ostringstream partner;
  partner.precision(17);
  partner << "until " << mounted.steps * dt << " out table.csv body body body.stl 0 0 0 prescribed " << mounted.velocity
          << " 0 0 0";
  const Outcome outcome = folder.coupled(mounted.ranks, "-in in.body -log log", partner.str(), 120);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const Table table(folder.path() / "table.csv");
  std::vector<Eigen::Vector3d> wall;  // force on the mesh at every step [N]
  for (const auto& row : thermo_lines(folder.read("log")))
    if (row.size() == 4) wall.emplace_back(std::stod(row[1]), std::stod(row[2]), std::stod(row[3]));
  ASSERT_EQ(table.rows(), static_cast<std::size_t>(mounted.steps));
  ASSERT_GE(wall.size(), table.rows() + 1);
  double largest = 0.0, worst = 0.0;
  for (std::size_t k = 1; k < table.rows(); ++k) {  // at the set-up of a run LIGGGHTS prints no force of a mesh
    const Eigen::Vector3d expected = 0.5 * (wall[k] + wall[k + 1]);
    largest = std::max(largest, expected.norm());
    worst = std::max(worst, (table.vector(k, "fx", "fy", "fz") - expected).norm());
  }
  std::printf("largest force %.3g N, largest difference %.2g N\n", largest, worst);
  EXPECT_GT(largest, 0.0);
  EXPECT_LT(worst, 1e-12 * largest);  // sums of the same contact forces, in another order
}

}  // namespace stock
}  // namespace footfall::test

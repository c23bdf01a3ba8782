// The same loads on any ranks of LIGGGHTS.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

#include "tests/coupled/coupled_run.h"

namespace footfall::test {
namespace ranks {

// The same result on any number of ranks, with ranks that own no triangle or no grain, and with pads that
// cross subdomains.

constexpr double kDt = 5e-5;

// A carpet of grains, each on a spring of its own: it forgets disturbances, so that round-off stays
// round-off. It ends at x = 0.1: on four ranks in a row the last one owns no grain.
std::string carpet(const std::string& processors) {
  return script_head("-0.4 0.4 -0.3 0.3 -0.2 0.2", processors, kDt) +
         "lattice sc 0.05\nregion grains block -0.36 0.1 -0.26 0.26 -0.001 0.001 units box\ncreate_atoms 1 "
         "region grains\n"
         "set group all diameter 0.04 density 2600\nfix hold all spring/self 4000\nfix integr all "
         "nve/sphere\n";
}

constexpr const char* kPadPlaces[] = {"-0.28 -0.12 0.0298", "-0.28 0.12 0.0296", "-0.1 -0.12 0.0297",
                                      "-0.1 0.12 0.0295"};

std::string pads_script(const std::string& processors) {
  std::string s = carpet(processors), names, pairs;
  for (int p = 1; p <= 4; ++p) {
    const std::string id = std::to_string(p);
    s += "fix geo" + id + " all couple/mbd/geometry body pad_" + id + "\nfix pad" + id + " all mesh/surface fix geo" +
         id + " type 2\n";
    names += " pad" + id;
    pairs += " mesh pad" + id + " pad_" + id;
  }
  return s + "fix wm all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes 4 meshes" + names +
         "\nfix mbd all couple/mbd every 20" + pairs +
         "\nthermo_style custom step atoms f_mbd[1] f_mbd[2] f_mbd[3] f_mbd[5] f_mbd[1][3] "
         "f_mbd[4][5]\nthermo 400\n"
         "thermo_modify norm no format float %.15g\nrun 2000\n"
         "dump mesh all mesh/stl 1 mesh*.stl pad1 pad2 pad3 pad4\nrun 0\n";
}

std::string pads_partner(const std::string& motion) {
  std::string s = "until 0.1 out table.csv";
  for (int p = 0; p < 4; ++p) s += " body pad_" + std::to_string(p + 1) + " pad.stl " + kPadPlaces[p] + " " + motion;
  return s;
}

Table run_pads(const RunFolder& folder, int ranks, const std::string& processors, const std::string& motion,
               const Surface& pad = box({0.12, 0.12, 0.02}, 2)) {
  write_stl((folder.path() / "pad.stl").string(), pad);
  std::string script = pads_script(processors);
  script.erase(script.find("dump mesh"));  // the scene is over then
  folder.write("in", script);
  const Outcome outcome = folder.coupled(ranks, "-in in -log log", pads_partner(motion));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  return Table(folder.path() / "table.csv");
}

void expect_same_loads(const Table& a, const Table& b) {
  ASSERT_EQ(a.rows(), b.rows());
  double worst = 0.0;
  for (const char* name : {"fx", "fy", "fz", "mx", "my", "mz", "q", "work", "ix", "iy", "iz", "stiffness", "overlap"}) {
    double scale = 1e-300;
    for (const double value : a[name]) scale = std::max(scale, std::abs(value));
    for (std::size_t i = 0; i < a.rows(); ++i) {
      worst = std::max(worst, std::abs(a[name][i] - b[name][i]) / scale);
      ASSERT_NEAR(a[name][i], b[name][i], 1e-9 * scale)
          << name << " row " << i;  // round-off of 2000 steps, damped by the springs
    }
  }
  for (std::size_t i = 0; i < a.rows(); ++i) ASSERT_EQ(a["contacts"][i], b["contacts"][i]) << "row " << i;
  std::printf("largest relative difference of any load: %.2g\n", worst);
}

const char* const kSliding = "prescribed 2.0 0.1 0.0 0.0 0.0 1.5";  // across the carpet, turning about z

// Ranks of LIGGGHTS and their grid: cuts through pads, ranks without grains; more ranks than there are cores.
class PadsOn : public testing::TestWithParam<std::pair<int, std::string>> {};
std::string grid_of(const testing::TestParamInfo<std::pair<int, std::string>>& info) {
  std::string grid = info.param.second;
  std::replace(grid.begin(), grid.end(), ' ', 'x');
  return grid;
}
INSTANTIATE_TEST_SUITE_P(Ranks, PadsOn,
                         testing::Values(std::pair(2, "2 1 1"), std::pair(2, "1 2 1"), std::pair(3, "3 1 1"),
                                         std::pair(4, "4 1 1"), std::pair(4, "2 2 1"), std::pair(2, "1 1 2"),
                                         std::pair(8, "4 2 1")),
                         grid_of);
// Half a minute on two cores: tests/bench/ranks.sh.
INSTANTIATE_TEST_SUITE_P(DISABLED_ManyRanks, PadsOn, testing::Values(std::pair(16, "4 4 1"), std::pair(16, "8 2 1")),
                         grid_of);

const Table& on_one_rank() {
  // Each test is a process of its own and may run at the same time as others.
  static const Table table = run_pads(RunFolder("ranks_1_" + std::to_string(getpid())), 1, "1 1 1", kSliding);
  return table;
}

TEST_P(PadsOn, GivesTheLoadsOfOneRank) {
  const auto [ranks, processors] = GetParam();
  std::string name = "ranks_" + std::to_string(ranks) + "_" + processors;
  std::replace(name.begin(), name.end(), ' ', 'x');
  expect_same_loads(on_one_rank(), run_pads(RunFolder(name), ranks, processors, kSliding));
}

TEST(Pads, TouchTheCarpetAllTheWayAndAcrossReneighbouring) {
  const Table& table = on_one_rank();
  double contacts = 0.0;
  for (std::size_t i = 0; i < table.rows(); ++i) contacts += table["contacts"][i] > 0.0 ? 1.0 : 0.0;
  EXPECT_GT(contacts, 0.7 * static_cast<double>(table.rows()));
  const RunFolder folder("ranks_reneighbouring");
  run_pads(folder, 2, "2 1 1", kSliding);
  const std::string log = folder.read("log");
  const std::size_t at = log.find("Neighbor list builds = ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_GT(std::stoi(log.substr(at + 23)), 20);
}

// f_ID[i][7] is the mean modal force that the partner receives; bodies without a second mode have 0 there.
TEST(Pads, ShowTheirMeanModalForces) {
  const RunFolder folder("ranks_modal_forces");
  write_stl((folder.path() / "pad.stl").string(), box({0.12, 0.12, 0.02}, 2));
  std::string script = pads_script("1 1 1");
  script.replace(script.find("thermo_style"), 0,
                 "variable q equal f_mbd[1][7]\nfix q all print 20 \"${q}\" file q.txt screen no title none\n");
  script.erase(script.find("dump mesh"));
  folder.write("in", script);
  const Outcome outcome = folder.coupled(1, "-in in -log log", pads_partner("modal 0.5 0 0 bowl -0.6"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const Table table(folder.path() / "table.csv");
  std::istringstream printed(folder.read("q.txt"));
  std::vector<double> q;
  for (double value = 0.0; printed >> value;) q.push_back(value);
  ASSERT_EQ(q.size(), 100u);
  double largest = 0.0;
  for (std::size_t window = 0; window < q.size(); ++window) {
    const double received = table["q"][4 * window];
    largest = std::max(largest, std::abs(received));
    EXPECT_NEAR(q[window], received, 1e-12 * std::abs(received)) << window;  // digits of the text
  }
  EXPECT_GT(largest, 1e-6);
}

class MeshPlace : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Processors, MeshPlace, testing::Values("1 1 1", "2 1 1", "4 1 1"));

TEST_P(MeshPlace, IsThatOfTheBodyAfterRigidMotion) {
  const std::string processors = GetParam();
  const int ranks = processors[0] - '0';
  const RunFolder folder("ranks_place_" + std::to_string(ranks));
  const Surface pad = box({0.12, 0.12, 0.02}, 2);
  write_stl((folder.path() / "pad.stl").string(), pad);
  std::string script = pads_script(processors);
  script.replace(script.find("run 2000\n"), 9, "");
  script.replace(script.find("run 0\n"), 6, "run 2000\n");
  script.replace(script.find("mesh/stl 1 "), 11, "mesh/stl 2000 ");
  folder.write("in", script);
  const Outcome outcome = folder.coupled(ranks, "-in in -log log", pads_partner("prescribed 2.0 0.1 0.0 1.0 -2.0 1.5"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  // Where the nodes of pad 3 must be after 0.1 s.
  const Eigen::Vector3d w(1.0, -2.0, 1.5);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.1 * w.norm(), w.normalized()).toRotationMatrix();
  std::vector<Eigen::Vector3d> expected;
  for (const char* place : kPadPlaces) {
    Eigen::Vector3d r;
    std::istringstream(place) >> r[0] >> r[1] >> r[2];
    for (Eigen::Index j = 0; j < pad.nodes.cols(); ++j)
      expected.push_back(r + 0.1 * Eigen::Vector3d(2.0, 0.1, 0.0) + turn * pad.nodes.col(j));
  }
  const Surface found = read_stl((folder.path() / "mesh2000.stl").string());
  EXPECT_EQ(found.triangles.size(), 4 * pad.triangles.size());
  for (Eigen::Index j = 0; j < found.nodes.cols(); ++j) {
    double nearest = 1.0;
    for (const Eigen::Vector3d& x : expected) nearest = std::min(nearest, (x - found.nodes.col(j)).norm());
    EXPECT_LT(nearest, 2e-6);  // the dump has six decimals
  }
}

class Modal : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Processors, Modal, testing::Values("1 1 1", "2 1 1"));

TEST_P(Modal, AModeThatShiftsAllNodesIsATranslation) {
  const std::string processors = GetParam();
  const int ranks = processors[0] - '0';
  const Table rigid = run_pads(RunFolder("ranks_shift_rigid_" + std::to_string(ranks)), ranks, processors,
                               "prescribed 0.5 0 -0.05 0 0 0");
  const Table modal =
      run_pads(RunFolder("ranks_shift_modal_" + std::to_string(ranks)), ranks, processors, "modal 0.5 0 0 shift -0.05");
  ASSERT_EQ(rigid.rows(), modal.rows());
  double scale = 1e-300;
  for (const double f : rigid["fz"]) scale = std::max(scale, std::abs(f));
  for (std::size_t i = 0; i < rigid.rows(); ++i) {
    ASSERT_NEAR(rigid["fz"][i], modal["fz"][i], 1e-9 * scale) << "row " << i;
    ASSERT_NEAR(modal["q"][i], modal["fz"][i], 1e-9 * scale) << "row " << i;  // Phi = e_z: the modal force is the force
    ASSERT_NEAR(rigid["work"][i], modal["work"][i], 1e-9 * scale * 1e-3) << "row " << i;  // way of a window: 0.5 mm
  }
  EXPECT_GT(scale, 10.0);
}

TEST(Modal, ADeformingBodyGivesTheSameLoadsOnTwoRanks) {
  const char* const bowl = "modal 0.5 0 0 bowl -0.6";  // the rim goes down by 0.4 mm
  expect_same_loads(run_pads(RunFolder("ranks_bowl_1"), 1, "1 1 1", bowl),
                    run_pads(RunFolder("ranks_bowl_2"), 2, "2 1 1", bowl));
}

// A plate that bends into a hollow over the grains: where its facets lay in one plane a crease opens, and LIGGGHTS'
// own contacts then depend on the order of the facets, which is each rank's own. Several ways over the carpet.
class Crease : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, Crease, testing::Range(1, 5));

TEST_P(Crease, GivesTheSameLoadsOnAnyRanks) {
  std::srand(static_cast<unsigned>(GetParam()));
  const auto random = [](double least, double most) { return least + (most - least) * std::rand() / RAND_MAX; };
  std::ostringstream motion;  // the rim goes down by 2 to 4 mm
  motion << "modal " << random(0.3, 1.5) << " " << random(-0.3, 0.3) << " " << random(0.0, 0.02) << " bowl "
         << random(-6.0, -3.0);
  const std::string name = "ranks_crease_" + std::to_string(GetParam()) + "_";
  const Table one = run_pads(RunFolder(name + "1"), 1, "1 1 1", motion.str());
  expect_same_loads(one, run_pads(RunFolder(name + "2"), 2, "2 1 1", motion.str()));
  expect_same_loads(one, run_pads(RunFolder(name + "4"), 4, "2 2 1", motion.str()));
}

// Longitudes and latitudes, closed at the poles.
Surface ball(double radius, int parts) {
  Surface surface;
  surface.nodes.resize(3, 2 + (parts - 1) * 2 * parts);
  surface.nodes.col(0) = Eigen::Vector3d(0, 0, radius);
  surface.nodes.col(1) = Eigen::Vector3d(0, 0, -radius);
  const auto node = [parts](int i, int j) {
    return i == 0 ? 0 : i == parts ? 1 : 2 + (i - 1) * 2 * parts + j % (2 * parts);
  };
  for (int i = 1; i < parts; ++i)
    for (int j = 0; j < 2 * parts; ++j) {
      const double u = M_PI * i / parts, v = M_PI * j / parts;
      surface.nodes.col(node(i, j)) =
          radius * Eigen::Vector3d(std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u));
    }
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < 2 * parts; ++j) {
      if (i > 0) surface.triangles.emplace_back(node(i, j), node(i + 1, j), node(i, j + 1));
      if (i + 1 < parts) surface.triangles.emplace_back(node(i, j + 1), node(i + 1, j), node(i + 1, j + 1));
    }
  return surface;
}

TEST(Balls, GiveTheSameLoadsOnAnyRanks) {
  const std::string rolling = "prescribed 1.0 0.1 0.0 3.0 20.0 5.0";
  const Surface pad = ball(0.0105, 16);  // its lowest point is as deep as the plates'
  const Table one = run_pads(RunFolder("ranks_balls_1"), 1, "1 1 1", rolling, pad);
  expect_same_loads(one, run_pads(RunFolder("ranks_balls_2"), 2, "2 1 1", rolling, pad));
  expect_same_loads(one, run_pads(RunFolder("ranks_balls_4"), 4, "2 2 1", rolling, pad));
}

}  // namespace ranks
}  // namespace footfall::test

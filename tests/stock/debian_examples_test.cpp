// The examples of LIGGGHTS that Debian packages (liggghts-doc): the same bits from liggghts and from liggghts_mbd; and
// with one of their meshes on a body of ours, loads that are LIGGGHTS' own wall forces.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <regex>
#include <sstream>

#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

namespace fs = std::filesystem;

const fs::path kExamples = "/usr/share/doc/liggghts/examples/LIGGGHTS/Tutorials_public";

using Words = std::vector<std::string>;

Words words_of(const std::string& line) {
  std::istringstream in(line.substr(0, line.find('#')));
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// The lines of a script; one that ends with & goes on in the next.
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
  const char* before = nullptr;  // script that writes the restart file it goes on from
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

}  // namespace
}  // namespace footfall::test

// Flexible bodies as a scene gives them: warnings where linear modes end, no modes as no flexibility, models of other
// codes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "mbd_solver/fe/modal_body_file.h"
#include "mbd_solver/run/output/history.h"
#include "mbd_solver/run/output/summary.h"
#include "mbd_solver/run/run_scene.h"
#include "mbd_solver/scene/scene_reader.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class FlexibleScene : public ::testing::Test, protected TemporaryFolder {
 protected:
  std::string path(const std::string& file) const { return (folder_ / file).string(); }

  // Runs scene.toml with these settings; the summary.
  nlohmann::ordered_json run(const std::vector<std::string>& settings, const std::string& out = "out") const {
    const Scene scene = read_scene(path("scene.toml"), settings);
    RunOptions options;
    options.out = path(out);
    options.quiet = true;
    const volatile std::sig_atomic_t never = 0;
    EXPECT_EQ(run_scene(scene, options, nullptr, never), 0);
    return read_summary(path(out) + "/summary.json");
  }
  static int count(const nlohmann::ordered_json& summary, const std::string& part) {
    int found = 0;
    for (const auto& warning : summary["warnings"])
      found += warning.get<std::string>().find(part) != std::string::npos ? 1 : 0;
    return found;
  }
};

// A rod of 1 m on its own; its lowest frequency is 22.37 sqrt(EI / (m L^4)) = 287 rad/s.
const char* const kRod = R"(
end_time = 0.02
gravity = [0, 0, 0]
[materials.steel]
density = 7850
young = 207e9
yield_stress_MPa = 350
[[bodies]]
name = "rod"
material = "steel"
shape = { kind = "rod", from = [0, 0, 0], to = [1, 0, 0], diameter = 0.01 }
flexible = { modes = 6 }
[output]
interval = 1e-3
plots = false
)";

TEST_F(FlexibleScene, ThatSpinsTooFastForLinearModesIsWarnedOfOnce) {
  write("scene.toml", kRod);
  const auto fast = run({"initial.angular_velocity=[0,0,20]"});
  EXPECT_EQ(count(fast, "body rod spins at 0.0696 of its lowest elastic frequency (287 rad/s)"), 1)
      << fast["warnings"].dump(1);
  EXPECT_EQ(count(fast, "body rod"), 1);
  EXPECT_NEAR(fast["flexible_bodies"]["rod"]["max_spin_over_lowest_frequency"], 20.0 / 287.1, 1e-3);
  EXPECT_EQ(count(run({"initial.angular_velocity=[0,0,10]"}), "body rod"), 0);
}

const char* const kClamp = R"([[joints]]
name = "clamp"
type = "fixed"
bodies = ["ground", "rod"]
point = [0, 0, 0]
)";

TEST_F(FlexibleScene, ThatBendsTooFarOrYieldsIsWarnedOfOnceForEach) {
  write("scene.toml", std::string(kRod) + kClamp);
  const auto bent = run({"gravity=[0,0,-150]", "end_time=0.2"});
  EXPECT_EQ(count(bent, "body rod bends by "), 1) << bent["warnings"].dump(1);
  EXPECT_EQ(count(bent, "body rod has a von Mises stress of "), 1);
  EXPECT_EQ(count(bent, "body rod"), 2);
  EXPECT_EQ(count(run({"gravity=[0,0,-1.6]", "end_time=0.2"}), "body rod"), 0);
  EXPECT_EQ(count(run({"gravity=[0,0,-150]", "end_time=0.2", "materials.steel.yield_stress_MPa=0"}), "von Mises"), 0)
      << "not known";
}

TEST_F(FlexibleScene, WithoutModesIsTheRigidOneToTheBit) {
  write("scene.toml", kRod);
  const std::vector<std::string> tumbling = {"initial.angular_velocity=[5,3,2]", "initial.velocity=[1,2,3]",
                                             "gravity=[0,0,-9.81]"};
  const auto with = [&](const std::string& setting) {
    std::vector<std::string> settings = tumbling;
    settings.push_back(setting);
    return settings;
  };
  run(with("flexible=false"), "rigid");
  run(with("bodies.rod.flexible.modes=0"), "none");
  const History rigid = read_history(path("rigid/history.csv")), none = read_history(path("none/history.csv"));
  EXPECT_EQ(rigid.names, none.names);
  EXPECT_EQ(rigid.columns, none.columns);
  EXPECT_LT(none.find("rod.strain_energy"), 0);
}

void write_matrix(const std::string& path, const Eigen::SparseMatrix<double>& matrix) {
  std::ofstream file(path);
  file.precision(17);
  file << "%%MatrixMarket matrix coordinate real general\n"
       << matrix.rows() << ' ' << matrix.cols() << ' ' << matrix.nonZeros() << '\n';
  for (int j = 0; j < matrix.cols(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
      file << it.row() + 1 << ' ' << j + 1 << ' ' << it.value() << '\n';
}

// The same rod once as a shape and once as the matrices of its finite-element model, and as the reduced model of a
// file.
TEST_F(FlexibleScene, FromMatricesOrFromAFileMovesAsTheOneFromItsShape) {
  const FeModel model = straight_beam({0, 0, 0}, {1, 0, 0}, 8, rod_section(0.01), Material{7850.0, 207e9, 0.3});
  write_matrix(path("K.mtx"), model.stiffness);
  write_matrix(path("M.mtx"), lumped_mass_matrix(model));
  {
    std::ofstream nodes(path("rod.nodes"));
    nodes.precision(17);
    for (int j = 0; j < model.node_count(); ++j) nodes << model.nodes.col(j).transpose() << '\n';
  }
  BasisOptions options;
  options.mode_count = 8;
  options.interface_nodes = {0};
  const ReducedBody reduced = reduce(model, options, "rod");
  write_modal_body(path("rod.modal"), reduced.body, reduced.p_DBo);

  const std::vector<std::string> swinging = {"end_time=0.1", "gravity=[0,1,-9.81]"};
  const auto with = [&](const std::string& flexible) {
    std::string text = std::string(kRod) + kClamp;
    const std::string line = "flexible = { modes = 6 }";
    text.replace(text.find(line), line.size(), "flexible = { " + flexible + " }");
    write("scene.toml", text);
  };
  with("modes = 8, elements = 8");
  run(swinging, "shape");
  with("modes = 8, stiffness_matrix = \"K.mtx\", mass_matrix = \"M.mtx\", node_file = \"rod.nodes\"");
  run(swinging, "matrices");
  with("file = \"rod.modal\"");
  run(swinging, "file");
  const History shape = read_history(path("shape/history.csv"));
  const double tolerance = 1e-6;  // of the largest: the integrator's, met by modes that differ in round-off
  for (const char* other : {"matrices", "file"}) {
    const History found = read_history(path(std::string(other) + "/history.csv"));
    for (const char* name : {"rod.z", "rod.y", "rod.pitch", "rod.strain_energy", "rod.deflection"}) {
      double largest = 0.0;
      for (const double x : shape.column(name)) largest = std::max(largest, std::abs(x));
      EXPECT_GT(largest, 0.0);
      ASSERT_EQ(found.column(name).size(), shape.column(name).size());
      for (std::size_t row = 0; row < shape.column(name).size(); ++row)
        EXPECT_NEAR(found.column(name)[row], shape.column(name)[row], tolerance * largest) << other << " " << name;
    }
  }
}

TEST_F(FlexibleScene, KeepsModesByNumberOrByFrequencyInEitherBasis) {
  write("scene.toml", std::string(kRod) + kClamp);
  const auto modes = [&](const std::vector<std::string>& settings) {
    std::vector<std::string> all = settings;
    all.push_back("end_time=0.001");
    return run(all)["flexible_bodies"]["rod"]["modes"].get<int>();
  };
  EXPECT_EQ(modes({"bodies.rod.flexible.modes=3"}), 3);
  // Free: pairs of bending modes at 45.7, 126 and 247 Hz.
  EXPECT_EQ(modes({"bodies.rod.flexible={ basis=\"free_free\", max_frequency=100 }"}), 2);
  EXPECT_EQ(modes({"bodies.rod.flexible={ basis=\"free_free\", max_frequency=200 }"}), 4);
  EXPECT_EQ(modes({"bodies.rod.flexible={ basis=\"free_free\", max_frequency=200, modes=3 }"}), 3);
  // Clamped: 7.2, 45.2 and 126 Hz.
  EXPECT_EQ(modes({"bodies.rod.flexible={ max_frequency=200 }"}), 6);
  EXPECT_EQ(modes({"bodies.rod.flexible=true"}), 10);
}

}  // namespace
}  // namespace footfall

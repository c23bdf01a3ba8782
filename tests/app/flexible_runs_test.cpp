// Runs with flexible bodies: history.csv, summary.json and VTU files agree with each other; warnings where linear modes end; no modes are no
// flexibility; models of other codes move as their shapes do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/fe/modal_body_file.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/peaks.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/session/run_scene.h"
#include "tests/support/fe_reference.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

constexpr double kPrinted = 1e-7;  // of the digits in the files

// A picture of bodies.pvd.
class Drawing {
 public:
  explicit Drawing(const std::string& path) {
    EXPECT_TRUE(file_.load_file(path.c_str())) << path;
    piece_ = file_.child("VTKFile").child("UnstructuredGrid").child("Piece");
  }
  std::vector<double> array(const char* part, const char* name) const {
    std::istringstream text(piece_.child(part).find_child_by_attribute("DataArray", "Name", name).text().get());
    std::vector<double> values;
    for (double x = 0.0; text >> x;) values.push_back(x);
    return values;
  }
  std::size_t count(const char* of) const { return piece_.attribute(of).as_uint(); }

 private:
  pugi::xml_document file_;
  pugi::xml_node piece_;
};

double largest(const std::vector<double>& x) { return *std::max_element(x.begin(), x.end()); }

// Runs the scene; its summary.
nlohmann::ordered_json summary_of_run(const Scene& scene, const std::string& out, double until = 0.0) {
  RunOptions options;
  options.out = out;
  options.until = until;
  options.quiet = true;
  const volatile std::sig_atomic_t never = 0;
  EXPECT_EQ(run_scene(scene, options, nullptr, never), 0);
  return read_summary(out + "/summary.json");
}

class FlexibleOutput : public ::testing::Test {
 protected:
  // The flexible lander on the rigid plane, past first touch, every body recorded, pictures every 5 ms.
  static void SetUpTestSuite() {
    place.emplace();
    folder = place->folder_.string();
    scene = read_scene(FOOTFALL_SOURCE_DIR "/inputs/rigid_plane",
                       {"output.vtk=true", "output.vtk_interval=5e-3", "output.interval=5e-3", "output.bodies=[]"});
    summary = summary_of_run(scene, folder, 0.01);
    history = read_history(folder + "/history.csv");
  }
  static void TearDownTestSuite() { place.reset(); }

  static std::optional<TemporaryFolder> place;
  static std::string folder;
  static Scene scene;
  static History history;
  static nlohmann::ordered_json summary;
};
std::optional<TemporaryFolder> FlexibleOutput::place;
std::string FlexibleOutput::folder;
Scene FlexibleOutput::scene;
History FlexibleOutput::history;
nlohmann::ordered_json FlexibleOutput::summary;

// Rigid bodies on gas springs, dampers and an elastic plane: nothing that is stiff turns, and steps take the fifth order.
TEST(Steps, OfARigidLanderAreFew) {
  const TemporaryFolder place;
  const Scene scene = read_scene(FOOTFALL_SOURCE_DIR "/tests/bench/simbody/scene.toml", {"solver.rtol=1e-6"});
  EXPECT_LT(summary_of_run(scene, place.folder_.string()).at("steps").get<int>(), 250);  // 355 of the third order
}

TEST_F(FlexibleOutput, StrainEnergiesOfTheBodiesAddUpToThatOfTheScene) {
  const std::vector<double>& total = history.column("energy.strain");
  std::vector<double> sum(total.size(), 0.0);
  int bodies = 0;
  for (std::size_t i = 0; i < history.names.size(); ++i) {
    const std::string& name = history.names[i];
    if (name.size() < 14 || name.substr(name.size() - 14) != ".strain_energy") continue;
    ++bodies;
    for (std::size_t row = 0; row < sum.size(); ++row) sum[row] += history.columns[i][row];
  }
  EXPECT_EQ(bodies, 28);  // all but the cabin
  EXPECT_GT(largest(total), 1.0);
  // The rest is in the springs that centre the pads and in the honeycomb before it crushes.
  for (std::size_t row = 0; row < sum.size(); ++row) EXPECT_LE(sum[row], total[row] * (1.0 + kPrinted));
}

// Rows of 5 ms miss peaks between them; peaks.csv and the summary have the peaks of all steps.
TEST_F(FlexibleOutput, SummaryHoldsThePeaksOfAllSteps) {
  const std::vector<ColumnPeaks> peaks = read_peaks(folder + "/peaks.csv");
  const auto peak = [&](const std::string& column) {
    const auto found =
        std::find_if(peaks.begin(), peaks.end(), [&](const ColumnPeaks& entry) { return entry.name == column; });
    EXPECT_NE(found, peaks.end()) << column;
    EXPECT_GE(found->largest, largest(history.column(column)) * (1.0 - kPrinted)) << column;
    return found->largest;
  };
  for (const char* body : {"footpad_1", "leg_3_rod"}) {
    const nlohmann::ordered_json& figures = summary["flexible_bodies"][body];
    EXPECT_NEAR(figures["max_deflection_m"], peak(std::string(body) + ".deflection"), kPrinted);
    const double stress = peak(std::string(body) + ".von_mises");
    EXPECT_NEAR(figures["max_von_mises_Pa"], stress, kPrinted * stress);
    EXPECT_GT(stress, 1e6);
    EXPECT_GT(figures["lowest_frequency_Hz"], 10.0);
  }
  EXPECT_FALSE(summary["flexible_bodies"].contains("cabin"));
}

TEST_F(FlexibleOutput, PicturesHoldTheDeflectionAndStressOfTheHistory) {
  pugi::xml_document series;
  ASSERT_TRUE(series.load_file((folder + "/bodies.pvd").c_str()));
  std::size_t row = 0;
  for (const pugi::xml_node& entry : series.child("VTKFile").child("Collection").children("DataSet")) {
    EXPECT_NEAR(entry.attribute("timestep").as_double(), history.column("time")[row], 1e-12);
    const Drawing drawing(folder + "/" + entry.attribute("file").value());
    const std::vector<double> points = drawing.array("Points", "Points"),
                              displacement = drawing.array("PointData", "displacement"),
                              stress = drawing.array("CellData", "von_mises_Pa"),
                              body = drawing.array("CellData", "body");
    ASSERT_EQ(points.size(), 3 * drawing.count("NumberOfPoints"));
    ASSERT_EQ(displacement.size(), points.size());
    ASSERT_EQ(stress.size(), drawing.count("NumberOfCells"));
    double farthest = 0.0, deflection = 0.0;
    for (std::size_t j = 0; j < displacement.size(); j += 3)
      farthest = std::max(farthest, std::hypot(displacement[j], displacement[j + 1], displacement[j + 2]));
    std::vector<double> of_body(scene.bodies.size(), 0.0);
    for (std::size_t c = 0; c < stress.size(); ++c) {
      double& most = of_body[static_cast<std::size_t>(body[c])];
      most = std::max(most, stress[c]);
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const std::string& name = scene.bodies[i].name;
      if (history.find(name + ".deflection") < 0) continue;
      deflection = std::max(deflection, history.column(name + ".deflection")[row]);
      const double expected = history.column(name + ".von_mises")[row];
      EXPECT_NEAR(of_body[i], expected, kPrinted * std::max(expected, 1.0)) << name;
    }
    EXPECT_NEAR(farthest, deflection, kPrinted * std::max(deflection, 1e-6));
    ++row;
  }
  EXPECT_EQ(row, history.column("time").size());
}

TEST_F(FlexibleOutput, PointsOfThePicturesAreTheNodesOfTheBodies) {
  const Mechanism mechanism = build_mechanism(scene);
  pugi::xml_document series;
  ASSERT_TRUE(series.load_file((folder + "/bodies.pvd").c_str()));
  std::size_t row = 0;
  double bent = 0.0;
  for (const pugi::xml_node& entry : series.child("VTKFile").child("Collection").children("DataSet")) {
    const Drawing drawing(folder + "/" + entry.attribute("file").value());
    const std::vector<double> points = drawing.array("Points", "Points"),
                              displacement = drawing.array("PointData", "displacement"),
                              body = drawing.array("CellData", "body"),
                              corners = drawing.array("Cells", "connectivity"),
                              ends = drawing.array("Cells", "offsets");
    for (int i = 0; i < mechanism.model.body_count(); ++i) {
      if (mechanism.model.body(i).mode_count() == 0) continue;
      std::set<std::size_t> own;  // in ascending order they are the nodes 0, 1, ...
      for (std::size_t c = 0; c < body.size(); ++c)
        if (static_cast<int>(body[c]) == i)
          for (auto k = static_cast<std::size_t>(c == 0 ? 0.0 : ends[c - 1]); k < static_cast<std::size_t>(ends[c]);
               ++k)
            own.insert(static_cast<std::size_t>(corners[k]));
      const ModalBody& modal = *mechanism.model.body(i).modal();
      ASSERT_EQ(own.size(), static_cast<std::size_t>(modal.node_count()));
      const auto value = [&](const char* name) { return history.column(mechanism.model.body(i).name() + name)[row]; };
      const Eigen::Vector3d r(value(".x"), value(".y"), value(".z"));
      const Eigen::Matrix3d A = (Eigen::AngleAxisd(value(".yaw"), Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(value(".pitch"), Eigen::Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(value(".roll"), Eigen::Vector3d::UnitX()))
                                    .toRotationMatrix();
      int j = 0;
      for (const std::size_t point : own) {
        const Eigen::Vector3d x = Eigen::Map<const Eigen::Vector3d>(&points[3 * point]),
                              u = Eigen::Map<const Eigen::Vector3d>(&displacement[3 * point]);
        EXPECT_LT((x - u - r - A * modal.rho0.col(j)).norm(), 1e-7) << mechanism.model.body(i).name() << " node " << j;
        ++j;
        bent = std::max(bent, u.norm());
      }
    }
    ++row;
  }
  EXPECT_GT(bent, 1e-5);
}

class FlexibleScene : public ::testing::Test, protected TemporaryFolder {
 protected:
  // Runs scene.toml with these settings; the summary.
  nlohmann::ordered_json run(const std::vector<std::string>& settings, const std::string& out = "out") const {
    return summary_of_run(read_scene(file("scene.toml"), settings), file(out));
  }
  // Warnings that name the rod.
  static int warnings(const nlohmann::ordered_json& summary) {
    int found = 0;
    for (const auto& warning : summary["warnings"])
      found += warning.get<std::string>().find("rod") != std::string::npos;
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
  EXPECT_EQ(warnings(fast), 1) << fast["warnings"].dump(1);
  EXPECT_NEAR(fast["flexible_bodies"]["rod"]["max_spin_over_lowest_frequency"], 20.0 / 287.1, 1e-3);
  EXPECT_EQ(warnings(run({"initial.angular_velocity=[0,0,10]"})), 0);
}

const char* const kClamp = R"([[joints]]
name = "clamp"
kind = "fixed"
bodies = ["ground", "rod"]
point = [0, 0, 0]
)";

TEST_F(FlexibleScene, ThatBendsTooFarOrYieldsIsWarnedOfOnceForEach) {
  write("scene.toml", std::string(kRod) + kClamp);
  const auto bent = run({"gravity=[0,0,-150]", "end_time=0.2"});
  EXPECT_EQ(warnings(bent), 2) << bent["warnings"].dump(1);
  EXPECT_EQ(warnings(run({"gravity=[0,0,-1.6]", "end_time=0.2"})), 0);
  EXPECT_EQ(warnings(run({"gravity=[0,0,-150]", "end_time=0.2", "materials.steel.yield_stress_MPa=0"})), 1)
      << "without a yield stress";
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
  const History rigid = read_history(file("rigid/history.csv")), none = read_history(file("none/history.csv"));
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
  const FeModel model = test::straight_beam({0, 0, 0}, {1, 0, 0}, 8, rod_section(0.01), Material{7850.0, 207e9, 0.3});
  write_matrix(file("K.mtx"), model.stiffness);
  write_matrix(file("M.mtx"), mass_matrix(model));
  {
    std::ofstream nodes(file("rod.nodes"));
    nodes.precision(17);
    for (int j = 0; j < model.node_count(); ++j) nodes << model.nodes.col(j).transpose() << '\n';
  }
  BasisOptions options;
  options.mode_count = 8;
  options.interface_nodes = {0};
  const ReducedBody reduced = reduce(model, options, "rod");
  write_modal_body(file("rod.modal"), reduced.body, reduced.p_DBo);

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
  const History shape = read_history(file("shape/history.csv"));
  const double tolerance = 1e-6;  // of the largest: the integrator's, met by modes that differ in round-off
  for (const char* other : {"matrices", "file"}) {
    const History found = read_history(file(std::string(other) + "/history.csv"));
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

// What a run writes of its flexible bodies: history.csv, summary.json and the VTU files agree with each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/run/output/history.h"
#include "mbd_solver/run/output/summary.h"
#include "mbd_solver/run/run_scene.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {
namespace {

constexpr double kPrinted = 1e-7;  // of the digits in the files

std::vector<double> numbers(const pugi::xml_node& data) {
  std::istringstream text(data.text().get());
  std::vector<double> values;
  for (double x = 0.0; text >> x;) values.push_back(x);
  return values;
}

double largest(const std::vector<double>& x) { return *std::max_element(x.begin(), x.end()); }

class FlexibleOutput : public ::testing::Test {
 protected:
  // The flexible lander on the rigid plane, past first touch, every body recorded, pictures every 5 ms.
  static void SetUpTestSuite() {
    std::string pattern = (std::filesystem::temp_directory_path() / "footfall_flexible_XXXXXX").string();
    folder = ::mkdtemp(pattern.data());
    scene = read_scene(FOOTFALL_SOURCE_DIR "/inputs/rigid_plane",
                       {"output.vtk=true", "output.vtk_interval=5e-3", "output.interval=5e-3", "output.bodies=[]"});
    RunOptions options;
    options.out = folder;
    options.until = 0.01;
    options.quiet = true;
    const volatile std::sig_atomic_t never = 0;
    ASSERT_EQ(run_scene(scene, options, nullptr, never), 0);
    history = read_history(folder + "/history.csv");
    summary = read_summary(folder + "/summary.json");
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder); }

  static std::string folder;
  static Scene scene;
  static History history;
  static nlohmann::ordered_json summary;
};
std::string FlexibleOutput::folder;
Scene FlexibleOutput::scene;
History FlexibleOutput::history;
nlohmann::ordered_json FlexibleOutput::summary;

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

TEST_F(FlexibleOutput, SummaryHoldsThePeaksOfTheHistory) {
  for (const char* body : {"footpad_1", "leg_3_rod"}) {
    const nlohmann::ordered_json& figures = summary["flexible_bodies"][body];
    EXPECT_NEAR(figures["max_deflection_m"], largest(history.column(std::string(body) + ".deflection")), kPrinted);
    const double stress = largest(history.column(std::string(body) + ".von_mises"));
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
    pugi::xml_document file;
    ASSERT_TRUE(file.load_file((folder + "/" + entry.attribute("file").value()).c_str()));
    const pugi::xml_node piece = file.child("VTKFile").child("UnstructuredGrid").child("Piece");
    const auto array = [&](const char* part, const char* name) {
      return numbers(piece.child(part).find_child_by_attribute("DataArray", "Name", name));
    };
    const std::vector<double> points = array("Points", "Points"), displacement = array("PointData", "displacement"),
                              stress = array("CellData", "von_mises_Pa"), body = array("CellData", "body");
    ASSERT_EQ(points.size(), 3 * piece.attribute("NumberOfPoints").as_uint());
    ASSERT_EQ(displacement.size(), points.size());
    ASSERT_EQ(stress.size(), piece.attribute("NumberOfCells").as_uint());
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
    pugi::xml_document file;
    ASSERT_TRUE(file.load_file((folder + "/" + entry.attribute("file").value()).c_str()));
    const pugi::xml_node piece = file.child("VTKFile").child("UnstructuredGrid").child("Piece");
    const auto array = [&](const char* part, const char* name) {
      return numbers(piece.child(part).find_child_by_attribute("DataArray", "Name", name));
    };
    const std::vector<double> points = array("Points", "Points"), displacement = array("PointData", "displacement"),
                              body = array("CellData", "body"), corners = array("Cells", "connectivity"),
                              ends = array("Cells", "offsets");
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

}  // namespace
}  // namespace footfall

// mbd_solver/scene/mesh_reader.h and boundary_surface.h: mesh files and generated surfaces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/pi.h"
#include "mbd_solver/fe/mesh_check.h"
#include "mbd_solver/scene/boundary_surface.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kSinglePrecision = 1e-6;  // coordinates of mesh files are read as 32-bit numbers

// A square of side 2 in two triangles.
const std::string kStl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 2 2 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 2 0\nvertex 0 2 0\nendloop\nendfacet\nendsolid s\n";
const std::string kObj = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n3 0 1 2\n3 0 2 3\n";

Eigen::Vector3d area_vector(const TriangleMesh& mesh) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[static_cast<std::size_t>(t[0])],
                          &b = mesh.vertices[static_cast<std::size_t>(t[1])],
                          &c = mesh.vertices[static_cast<std::size_t>(t[2])];
    area += 0.5 * (b - a).cross(c - a);
  }
  return area;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles)
    sum += mesh.vertices[static_cast<std::size_t>(t[0])].dot(
               mesh.vertices[static_cast<std::size_t>(t[1])].cross(mesh.vertices[static_cast<std::size_t>(t[2])])) /
           6.0;
  return sum;
}

TEST(MeshReader, ReadsTheSameSquareFromStlObjAndPly) {
  const SceneText text;
  for (const std::string& file : {text.write("a.stl", kStl), text.write("a.obj", kObj), text.write("a.ply", kPly)}) {
    const TriangleMesh mesh = read_mesh(file, 0.5);
    EXPECT_EQ(mesh.vertices.size(), 4u) << file;
    EXPECT_EQ(mesh.triangles.size(), 2u) << file;
    EXPECT_NEAR((area_vector(mesh) - Eigen::Vector3d(0, 0, 1)).norm(), 0.0, kSinglePrecision) << file;
  }
}

TEST(MeshReader, RefusesASurfaceWithoutExtent) {
  const SceneText text;
  const std::string file = text.write("point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n");
  EXPECT_THAT([&] { read_mesh(file, 1.0); }, ThrowsMessage<InputError>(HasSubstr("expected a surface with an extent")));
}

TEST(MeshReader, RefusesMoreElementsThanTheFileHasBytes) {
  const SceneText text;
  std::string ply = kPly;
  ply.replace(ply.find("vertex 4"), 8, "vertex 400000000");
  const std::string file = text.write("promises.ply", ply);
  EXPECT_THAT([&] { read_mesh(file, 1.0); },
              ThrowsMessage<InputError>(HasSubstr("promises.ply:3: promises 400000000 elements")));
}

TEST(MeshReader, TakesAHeadWithAnEndOnly) {
  const SceneText text;
  const std::string ply = kPly;
  const std::size_t end = ply.find("end_header\n");
  const std::string file = text.write("endless.ply", ply.substr(0, end) + "0ment\n" + ply.substr(end + 11));
  EXPECT_THAT(
      [&] { read_mesh(file, 1.0); },
      ThrowsMessage<InputError>(HasSubstr("endless.ply: cannot be read as a mesh: none of its first 1000 lines")));
  std::string lines = ply;
  for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 2) lines.replace(at, 1, "\r\n");
  EXPECT_EQ(read_mesh(text.write("crlf.ply", lines), 1.0).triangles.size(), 2u);
}

TEST(MeshReader, TakesANameInAHeadForNoNumber) {
  const SceneText text;
  std::string ply = kPly;
  ply.replace(ply.find("float z"), 7, "float z\ncomment of 20260101\nproperty float infrared");
  for (const char* line : {"0 0 0\n", "2 0 0\n", "2 2 0\n", "0 2 0\n"})
    ply.replace(ply.find(line, ply.find("end_header")), 6, std::string(line, 5) + " 1\n");
  EXPECT_EQ(read_mesh(text.write("infrared.ply", ply), 1.0).triangles.size(), 2u);
}

TEST(MeshReader, ReadsBinaryStl) {
  std::string data(80, ' ');
  const auto append = [&](const auto& value) { data.append(reinterpret_cast<const char*>(&value), sizeof value); };
  append(std::uint32_t{1});
  for (float number : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.f, 0.f, 2.f, 2.f, 0.f}) append(number);
  append(std::uint16_t{0});
  const SceneText text;
  EXPECT_NEAR(area_vector(read_mesh(text.write("b.stl", data))).z(), 2.0, kSinglePrecision);
}

TEST(MeshReader, NamesTheFileAndWhatIsWrongWithIt) {
  const SceneText text;
  EXPECT_THAT([&] { read_mesh("nowhere.stl"); },
              ThrowsMessage<InputError>(HasSubstr("nowhere.stl: there is no such mesh file")));
  EXPECT_THAT([&] { read_mesh(text.write("a.step", "x")); },
              ThrowsMessage<InputError>(HasSubstr("ends in .stl, .obj or .ply")));
  EXPECT_THAT([&] { read_mesh(text.write("a.ply", "nothing of the kind")); },
              ThrowsMessage<InputError>(HasSubstr("a.ply: cannot be read as a mesh")));
}

TEST(GeneratedSurface, CylinderIsClosedAndFillsItsVolume) {
  const TriangleMesh mesh = cylinder_mesh({1, 2, 3}, {2, 2, 4}, 0.2, 0.01);
  EXPECT_EQ(mesh_findings(mesh, {true, true, true}), std::vector<std::string>());
  constexpr double kFacets = 2e-3;  // a polygon of 63 sides: (2 pi / 63)^2 / 6
  EXPECT_NEAR(volume(mesh) / (kPi * 0.01 * std::sqrt(2.0)), 1.0, kFacets);
}

TEST(GeneratedSurface, SphereIsClosedAndItsVolumeConvergesQuadratically) {
  const auto defect = [](double edge) { return 1.0 - volume(sphere_mesh(0.5, edge)) / (kPi / 6.0); };
  EXPECT_EQ(mesh_findings(sphere_mesh(0.5, 0.1), {true, true, true}), std::vector<std::string>());
  const double order = std::log2(defect(0.1) / defect(0.05));
  EXPECT_NEAR(order, 2.0, 0.05);
}

TEST(BoundarySurface, RefusesAMeshThatIsOpenWhereItMustBeClosed) {
  const SceneText text;
  text.write("a.stl", kStl);
  const std::string toml =
      kPendulum + "[[boundaries]]\nbody = \"bob\"\nsurface = { file = \"a.stl\", closed = true }\n";
  const Scene scene = text.read(toml);
  EXPECT_THAT([&] { boundary_surface(scene, scene.boundaries[0]); }, ThrowsMessage<InputError>(HasSubstr("a.stl")));
  const Scene open =
      text.read(toml, {"boundaries.bob.surface.closed=false", "boundaries.bob.surface.position=[0, 0, 7]"});
  EXPECT_NEAR(boundary_surface(open, open.boundaries[0]).vertices[0].z(), 7.0, kSinglePrecision);
}

}  // namespace
}  // namespace footfall

// Masses, meshes and clumps of a scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/resolve.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

// mbd_solver/scene/resolve.h: mass, centre and inertia of bodies given by shapes.

using ::testing::HasSubstr;

constexpr double kRoundOff = 1e-12;  // relative

BodySpec body_of(const std::string& entry) {
  const SceneText text;
  return text.read("end_time = 1\n[materials.steel]\ndensity = 7850\n[[bodies]]\nname = \"b\"\n" + entry).bodies[0];
}

TEST(SceneMasses, TubeOfAMaterialWeighsItsVolume) {
  const BodySpec b = body_of(
      "material = \"steel\"\nshape = { kind = \"tube\", from = [1, 0, 1], to = [1, 0, 3], diameter = 0.1, wall = 0.01 "
      "}\n");
  const double area = kPi / 4 * (0.1 * 0.1 - 0.08 * 0.08);
  EXPECT_NEAR(b.mass, 7850 * area * 2, kRoundOff * b.mass);
  EXPECT_NEAR((b.position - Eigen::Vector3d(1, 0, 2)).norm(), 0.0, kRoundOff);
  const double r2 = 0.05 * 0.05 + 0.04 * 0.04;
  EXPECT_NEAR(b.inertia(2, 2), b.mass * r2 / 2, kRoundOff * b.mass);
  EXPECT_NEAR(b.inertia(0, 0), b.mass * (r2 / 4 + 4.0 / 12), kRoundOff * b.mass);
}

TEST(SceneMasses, BoxTurnsWithItsBodyAndKeepsItsInertiaThere) {
  const BodySpec b = body_of(
      "mass = 12\nshape = { kind = \"box\", size = [1, 2, 3], centre = [0, 0, 5] }\norientation = { rpy_deg = [90, 0, "
      "0] }\n");
  EXPECT_NEAR((b.inertia - Eigen::Matrix3d(Eigen::Vector3d(13, 10, 5).asDiagonal())).norm(), 0.0, 1e-10);
  EXPECT_NEAR((b.orientation * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 0.0, kRoundOff);
}

TEST(SceneMasses, CylinderLiesAlongItsAxis) {
  const BodySpec b = body_of(
      "material = \"steel\"\nshape = { kind = \"cylinder\", centre = [1, 2, 3], axis = \"y\", radius = 0.1, length = "
      "0.3 }\n");
  EXPECT_NEAR(b.mass, 7850 * kPi * 0.01 * 0.3, kRoundOff * b.mass);
  EXPECT_NEAR((b.position - Eigen::Vector3d(1, 2, 3)).norm(), 0.0, kRoundOff);
  EXPECT_NEAR(b.inertia(1, 1), b.mass * 0.01 / 2, kRoundOff * b.mass);
  EXPECT_NEAR(b.inertia(0, 0), b.mass * (0.01 / 4 + 0.09 / 12), kRoundOff * b.mass);
}

// m_c = rho pi r^2 L, m_b = rho 4/3 pi r^3, h = L/2: across m_c (r^2/4 + L^2/12) + m_b (2/5 r^2 + h^2 + 3/4 h r).
TEST(SceneMasses, CapsuleIsACylinderAndABall) {
  const BodySpec b = body_of(
      "material = \"steel\"\nshape = { kind = \"capsule\", from = [0, 0, 1], to = [0.4, 0, 1], diameter = 0.2 }\n");
  const double r = 0.1, L = 0.4, h = 0.2, m_c = 7850 * kPi * r * r * L, m_b = 7850 * 4.0 / 3.0 * kPi * r * r * r;
  EXPECT_NEAR(b.mass, m_c + m_b, kRoundOff * b.mass);
  EXPECT_NEAR((b.position - Eigen::Vector3d(0.2, 0, 1)).norm(), 0.0, kRoundOff);
  EXPECT_NEAR(b.inertia(0, 0), m_c * r * r / 2 + m_b * 0.4 * r * r, kRoundOff * b.mass);
  EXPECT_NEAR(b.inertia(2, 2), m_c * (r * r / 4 + L * L / 12) + m_b * (0.4 * r * r + h * h + 0.75 * h * r),
              kRoundOff * b.mass);
}

// The file is scaled, then turned about its origin, then moved; the body's own axes are another matter. The box of
// rock.stl is 100 x 60 x 40 mm from its origin on.
TEST(SceneMasses, SolidOfAFileIsScaledTurnedAndMoved) {
  const std::string file = FOOTFALL_SOURCE_DIR "/inputs/reference/rock.stl";
  const BodySpec b =
      body_of("material = \"steel\"\nshape = { kind = \"mesh\", file = \"" + file +
              "\", scale = 0.001, orientation = { axis = \"z\", angle_deg = 90 }, position = [1, 0, 0] }\n"
              "orientation = { rpy_deg = [0, 0, 90] }\n");
  EXPECT_NEAR(b.mass, 7850 * 0.1 * 0.06 * 0.04, kRoundOff * b.mass);
  EXPECT_NEAR((b.position - Eigen::Vector3d(1 - 0.03, 0.05, 0.02)).norm(), 0.0, kRoundOff);
  // Body axes along the file's.
  EXPECT_NEAR(b.inertia(0, 0), b.mass / 12 * (0.06 * 0.06 + 0.04 * 0.04), kRoundOff * b.mass);
  EXPECT_NEAR(b.inertia(1, 1), b.mass / 12 * (0.1 * 0.1 + 0.04 * 0.04), kRoundOff * b.mass);
}

// The closed form of the thin cap against the same surface cut into triangles: second order in their size.
TEST(SceneMasses, DishAgreesWithItsOwnSurface) {
  const std::string entry =
      "mass = 3\nshape = { kind = \"dish\", centre = [0, 0, 1], radius = 0.3, depth = 0.2, thickness = 0.01 }\n";
  const BodySpec b = body_of(entry);
  const SceneText text;
  Scene scene = text.read("end_time = 1\n[[bodies]]\nname = \"b\"\n" + entry +
                          "[[boundaries]]\nbody = \"b\"\nsurface = { element_size = 0.01 }\n");
  const TriangleMesh mesh = boundary_surface(scene, scene.boundaries[0]);
  double area = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T, exact for each triangle by its edge middles
  for (const Eigen::Vector3i& t : mesh.triangles) {
    Eigen::Vector3d p[3];
    for (int i = 0; i < 3; ++i) p[i] = mesh.vertices[t[i]];
    const double a = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
    area += a;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d middle = 0.5 * (p[i] + p[(i + 1) % 3]);
      moment += a / 3 * middle;
      second += a / 3 * middle * middle.transpose();
    }
  }
  const Eigen::Vector3d centre = moment / area;
  second = second / area - centre * centre.transpose();
  const Eigen::Matrix3d inertia = b.mass * (second.trace() * Eigen::Matrix3d::Identity() - second);
  constexpr double kFacets = 1e-3;  // triangles of 0.01 m on a sphere of 0.325 m radius: (0.01 / 0.325)^2
  EXPECT_NEAR((b.position - centre).norm(), 0.0, kFacets * 0.3);
  EXPECT_NEAR((b.inertia - inertia).norm(), 0.0, kFacets * b.inertia.norm());
}

TEST(SceneMasses, RemainderTakesWhatTheOthersLeave) {
  const SceneText text;
  const std::string toml = R"(end_time = 1
total_mass = 10
[[bodies]]
name = "cabin"
mass = "remainder"
shape = { kind = "box", size = [1, 1, 1] }
[[bodies]]
name = "pad"
mass = 4
shape = { kind = "sphere", radius = 0.5, centre = [0, 0, 5] }
)";
  const Scene scene = text.read(toml);
  EXPECT_NEAR(scene.bodies[0].mass, 6.0, kRoundOff);
  EXPECT_NEAR(scene.bodies[0].inertia(0, 0), 1.0, kRoundOff);  // 6 (1 + 1) / 12
  EXPECT_NEAR(mass_centre(scene).z(), 2.0, kRoundOff);
  EXPECT_THAT(text.findings(toml, {"bodies.pad.mass=11"}), HasSubstr("11"));
  EXPECT_THAT(text.findings(toml, {"bodies.cabin.mass=5"}), HasSubstr("10"));
}

TEST(SceneMasses, AShapeSaysWhatItNeedsAndWhatMeansNothing) {
  const SceneText text;
  const std::string toml =
      "end_time = 1\n[[bodies]]\nname = \"b\"\nmass = 1\nshape = { kind = \"rod\", from = [0, 0, 0], to = [0, 0, 1], "
      "radius = 0.1 }\n";
  EXPECT_THAT(text.findings(toml), HasSubstr("bodies.b.shape.diameter"));
  EXPECT_THAT(text.findings(toml), HasSubstr("bodies.b.shape.radius"));
}

// mbd_solver/scene/mesh_reader.h and boundary_surface.h: mesh files and generated surfaces.

using ::testing::ThrowsMessage;

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
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    area += 0.5 * (b - a).cross(c - a);
  }
  return area;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles)
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  return sum;
}

TEST(MeshReader, ReadsTheSameSquareFromStlObjAndPly) {
  const SceneText text;
  for (const std::string& file : {text.write("a.stl", kStl), text.write("a.obj", kObj), text.write("a.ply", kPly)}) {
    const TriangleMesh mesh = read_mesh(file, 0.5);
    EXPECT_EQ(mesh.vertices.size(), 4u) << file;
    EXPECT_EQ(mesh.triangles.size(), 2u) << file;
    EXPECT_NEAR((area_vector(mesh) - Eigen::Vector3d(0, 0, 1)).norm(), 0.0, kRoundOff) << file;
  }
}

TEST(MeshReader, RefusesMoreElementsThanTheFileHasBytes) {
  const SceneText text;
  std::string ply = kPly;
  ply.replace(ply.find("vertex 4"), 8, "vertex 400000000");
  const std::string file = text.write("promises.ply", ply);
  EXPECT_THAT([&] { read_mesh(file, 1.0); }, ThrowsMessage<InputError>(HasSubstr("promises.ply")));
}

TEST(MeshReader, TakesAHeadWithAnEndOnly) {
  const SceneText text;
  const std::string ply = kPly;
  const std::size_t end = ply.find("end_header\n");
  const std::string file = text.write("endless.ply", ply.substr(0, end) + "0ment\n" + ply.substr(end + 11));
  EXPECT_THAT([&] { read_mesh(file, 1.0); }, ThrowsMessage<InputError>(HasSubstr("endless.ply")));
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

// A box from `from` to `from` + `size` as triangles, outward.
TriangleMesh box_of(const Eigen::Vector3d& from, const Eigen::Vector3d& size) {
  return moved(box_mesh(size, size.maxCoeff()), Eigen::Matrix3d::Identity(), from + 0.5 * size);
}

std::string text_stl(const TriangleMesh& mesh, int digits = 17) {
  std::ostringstream out;
  out.precision(digits);
  out << "solid of a name\n";
  for (const Eigen::Vector3i& t : mesh.triangles) {
    out << " facet normal 0 0 0\n  outer loop\n";
    for (const int n : t) out << "   vertex " << mesh.vertices[n].transpose() << "\n";
    out << "  endloop\n endfacet\n";
  }
  out << "endsolid of a name\n";
  return out.str();
}

template <class Number>
void append(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string binary_stl(const TriangleMesh& mesh, const std::string& comment = "", int announced = -1) {
  std::string bytes = comment;
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(announced < 0 ? static_cast<int>(mesh.triangles.size()) : announced));
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.f);
    for (const int n : t)
      for (const double x : mesh.vertices[n]) append(bytes, static_cast<float>(x));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string obj_of(const TriangleMesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  for (const Eigen::Vector3d& x : mesh.vertices) out << "v " << x.transpose() << "\n";
  for (const Eigen::Vector3i& t : mesh.triangles) out << "f " << (t.array() + 1).matrix().transpose() << "\n";
  return out.str();
}

std::string ply_of(const TriangleMesh& mesh, const std::string& format) {
  std::ostringstream out;
  out.precision(17);
  out << "ply\nformat " << format << " 1.0\nelement vertex " << mesh.vertices.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nelement face "
      << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  std::string bytes = out.str();
  const auto put = [&](auto value) {  // this machine is little-endian
    std::string number;
    append(number, value);
    if (format == "binary_big_endian") std::reverse(number.begin(), number.end());
    bytes += number;
  };
  if (format != "ascii") {
    for (const Eigen::Vector3d& x : mesh.vertices) {
      for (const double coordinate : x) put(coordinate);
      put(std::uint8_t{7});
    }
    for (const Eigen::Vector3i& t : mesh.triangles) {
      put(std::uint8_t{3});
      for (const int n : t) put(std::int32_t{n});
    }
    return bytes;
  }
  for (const Eigen::Vector3d& x : mesh.vertices) out << x.transpose() << " 7\n";
  for (const Eigen::Vector3i& t : mesh.triangles) out << "3 " << t.transpose() << "\n";
  return out.str();
}

std::string refusal_of(const std::string& file) {
  try {
    read_mesh(file);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

// A box of a site plan, 5000 km from the origin of its coordinates: 1e-9 m is their last digit.
TEST(MeshReader, KeepsAllDigitsOfTextAndOfDoubles) {
  const SceneText text;
  const Eigen::Vector3d from(448251.37, 5411932.91, 1234.5), size(0.3, 0.2, 0.05);
  const TriangleMesh box = box_of(from, size);
  for (const std::string& file :
       {text.write("far.stl", text_stl(box)), text.write("far.obj", obj_of(box)),
        text.write("far.ply", ply_of(box, "ascii")), text.write("little.ply", ply_of(box, "binary_little_endian")),
        text.write("big.ply", ply_of(box, "binary_big_endian"))}) {
    const TriangleMesh mesh = read_mesh(file);
    ASSERT_EQ(mesh.vertices.size(), 8u) << file;
    EXPECT_TRUE(mesh.notes.empty()) << file;
    const MassProperties p = polyhedron_properties(mesh, 1000.0, file);
    EXPECT_NEAR(p.mass, 3.0, 1e-6) << file;
    EXPECT_LT((p.centre - from - 0.5 * size).norm(), 4e-9) << file;
  }
  const TriangleMesh third = box_of({1.0 / 3.0, 0, 0}, {1, 1, 1});
  double nearest = 1.0;
  for (const Eigen::Vector3d& x : read_mesh(text.write("third.stl", text_stl(third))).vertices)
    nearest = std::min(nearest, std::abs(x.x() - 1.0 / 3.0));
  EXPECT_LT(nearest, 1e-16);
}

// 448251.37 in single precision is a multiple of 1/32 m: no box of 0.3 m is left of it. At 50 m it has 4e-6 m, which is told.
TEST(MeshReader, TellsWhatFewDigitsLeave) {
  const SceneText text;
  const Eigen::Vector3d size(0.3, 0.2, 0.1);
  EXPECT_THAT(refusal_of(text.write("lost.stl", binary_stl(box_of({448251.37, 0, 0}, size)))), HasSubstr("E0224"));
  EXPECT_EQ(read_mesh(text.write("few.stl", binary_stl(box_of({50.37, 0, 0}, size)))).notes.size(), 1u);
  EXPECT_TRUE(read_mesh(text.write("enough.stl", binary_stl(box_of({0.37, 0, 0}, size)))).notes.empty());
  EXPECT_EQ(read_mesh(text.write("seven.stl", text_stl(box_of({448251.4, 0, 0}, size), 7))).notes.size(), 1u);
  EXPECT_TRUE(read_mesh(text.write("three.stl", text_stl(box_of({1, 2, 3}, size), 3))).notes.empty());
  // The scene warns once.
  const std::string body =
      "end_time = 1\n[materials.m]\ndensity = 1000\n[[bodies]]\nname = \"b\"\nmaterial = \"m\"\n"
      "shape = { kind = \"mesh\", file = \"few.stl\" }\n";
  const Scene scene = text.read(body);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_THAT(scene.warnings[0], HasSubstr("W1220"));
}

TEST(MeshReader, ReadsStlAsItIsWritten) {
  const SceneText text;
  const TriangleMesh box = box_of({0, 0, 0}, {1, 2, 4});
  const auto weighs_eight = [&](const char* name, const std::string& bytes) {
    EXPECT_NEAR(volume(read_mesh(text.write(name, bytes))), 8.0, kRoundOff) << name;
  };
  const std::string plain = text_stl(box), binary = binary_stl(box);
  weighs_eight("text.stl", plain);
  std::string upper = plain;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](char c) { return static_cast<char>(std::toupper(c)); });
  weighs_eight("upper.STL", upper);
  std::string returns = plain;
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  weighs_eight("returns.stl", returns);
  weighs_eight("marked.stl", "\xEF\xBB\xBF\n" + plain);
  weighs_eight("binary.stl", binary);
  weighs_eight("solid.stl", binary_stl(box, "solid facet normal"));
  weighs_eight("tail.stl", binary + "\r\n");
  weighs_eight("solid_tail.stl", binary_stl(box, "solid of a program") + std::string(2, '\0'));
  // Two solids in one file.
  const TriangleMesh far = box_of({5, 0, 0}, {1, 1, 1});
  EXPECT_NEAR(volume(read_mesh(text.write("two.stl", plain + text_stl(far)))), 9.0, kRoundOff);
}

struct BadMesh {
  const char* name;
  std::string bytes;
  const char* expected;  // in the message
};

TEST(MeshReader, RefusesAPartOfAMeshWithItsPlace) {
  const SceneText text;
  const TriangleMesh box = box_of({0, 0, 0}, {1, 2, 4});
  const std::string plain = text_stl(box), binary = binary_stl(box), obj = obj_of(box), ply = ply_of(box, "ascii");
  const auto with = [](std::string bytes, const std::string& from, const std::string& to) {
    const std::size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? bytes : bytes.replace(at, from.size(), to);
  };
  const BadMesh cases[] = {
      {"comma.stl", with(plain, "vertex 0", "vertex 0,0"), "comma.stl:4: "},
      {"comma.obj", with(obj, "v 0", "v 0,0"), "comma.obj:1: "},
      {"comma.ply", with(ply, "end_header\n0", "end_header\n0,0"), "comma.ply:11: "},
      {"cut.stl", plain.substr(0, plain.rfind("endsolid")), "E0221"},
      {"cut_facet.stl", plain.substr(0, plain.rfind("vertex")), "E0221"},
      {"four.stl", with(plain, "  endloop", "   vertex 0 0 0\n  endloop"), "four.stl:7: "},
      {"nan.stl", with(plain, "vertex 0", "vertex nan"), "nan.stl:4: "},
      {"short.stl", binary.substr(0, binary.size() - 1), "E0221"},
      {"fewer.stl", binary_stl(box, "", 11), "E0221"},
      {"more.stl", binary_stl(box, "", 13), "E0221"},
      {"none.stl", binary_stl(box, "", 0), "E0221"},
      {"word.stl", "no mesh", "E0221"},
      {"corner.obj", obj + "f 1 2 9\n", "E0221"},
      {"zero.obj", obj + "f 0 1 2\n", "E0221"},
      {"curved.obj", obj + "surf 0 1 0 1 1 2 3\n", "E0221"},
      {"two.obj", obj + "f 1 2\n", "E0221"},
      {"corner.ply", with(ply, "3 0", "3 8"), "E0221"},
      {"cut.ply", ply.substr(0, ply.size() - 3), "E0221"},
      {"more.ply", ply + "3 0 1 2\n", "E0221"},
      {"cut_binary.ply", ply_of(box, "binary_little_endian").substr(0, 400), "E0221"},
      {"strips.ply", with(ply, "element face", "element tristrips"), "E0221"},
  };
  for (const BadMesh& bad : cases) {
    const std::string message = refusal_of(text.write(bad.name, bad.bytes));
    EXPECT_THAT(message, HasSubstr(bad.expected)) << bad.name;
    EXPECT_THAT(message, HasSubstr("E022")) << bad.name;
  }
}

// A concave polygon: the square of side 2 without a notch of 1.
TEST(MeshReader, CutsPolygonsIntoTriangles) {
  const SceneText text;
  const std::string notched = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1/1/1 2/2 3//3 \\\n 4 -1\n";
  const TriangleMesh mesh = read_mesh(text.write("notch.obj", notched));
  EXPECT_EQ(mesh.triangles.size(), 3u);
  double area = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    TriangleMesh one = mesh;
    one.triangles = {t};
    EXPECT_GT(area_vector(one).z(), 0.0);
    area += area_vector(one).z();
  }
  EXPECT_NEAR(area, 4.0 - 1.5, kRoundOff);  // less the triangle over the notch, 2 wide and 1.5 deep
  EXPECT_THAT(refusal_of(text.write("bow.obj", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n")), HasSubstr("E0221"));
}

TEST(MeshReader, ReadsBinaryStl) {
  TriangleMesh one;
  one.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}};
  one.triangles = {{0, 1, 2}};
  const SceneText text;
  EXPECT_NEAR(area_vector(read_mesh(text.write("b.stl", binary_stl(one)))).z(), 2.0, kRoundOff);
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

// mbd_solver/scene/box_bed.h: clumps of spheres.

constexpr double kRadius = 0.008;  // [m]

// Where a line along z through (x, y) is within spheres of the clump: pairs of its beginning and end.
std::vector<std::pair<double, double>> within(const Clump& clump, double x, double y) {
  std::vector<std::pair<double, double>> pieces;
  for (Eigen::Index i = 0; i < clump.centres.cols(); ++i) {
    const Eigen::Vector3d c = clump.centres.col(i);
    const double half = clump.radius * clump.radius - std::pow(x - c.x(), 2) - std::pow(y - c.y(), 2);
    if (half > 0.0) pieces.emplace_back(c.z() - std::sqrt(half), c.z() + std::sqrt(half));
  }
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

// Two spheres of radius s whose centres are sqrt(3) s apart: 8/3 pi s^3 less pi / 12 (4 s + d) (2 s - d)^2.
TEST(ClumpShape, PairHasTheVolumeOfTwoSpheresLessTheirLens) {
  const Clump pair = clump_of(ClumpShape::kPair, kRadius);
  const double s = pair.radius, d = std::sqrt(3.0) * s;
  EXPECT_NEAR(pair.volume, 8.0 / 3.0 * kPi * s * s * s - kPi / 12.0 * (4.0 * s + d) * std::pow(2.0 * s - d, 2),
              1e-14 * pair.volume);
}

// Volume, mass centre and inertia of what any sphere holds, by lines along z on a grid of midpoints: exact along each line,
// with an error of O(width^(3/2)) across them, where chords begin as square roots; below 3e-4 at this width.
TEST(ClumpShape, VolumeCentreAndInertiaAreThoseOfTheUnion) {
  constexpr double kGrid = 1e-3;
  for (const ClumpShape shape : every<ClumpShape>()) {
    SCOPED_TRACE(std::string(name_of(shape)));
    const Clump clump = clump_of(shape, kRadius);
    EXPECT_NEAR(clump.volume, 4.0 / 3.0 * kPi * std::pow(kRadius, 3), 1e-14 * clump.volume);
    EXPECT_LT(clump.centres.rowwise().mean().norm(), 1e-15 * kRadius + 1e-17);
    const Eigen::Vector3d reach = (clump.centres.cwiseAbs().rowwise().maxCoeff().array() + clump.radius).matrix();
    constexpr int n = 150;
    const double dx = 2.0 * reach.x() / n, dy = 2.0 * reach.y() / n;
    double volume = 0.0, thrice = 0.0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (int k = 0; k < n * n; ++k) {
      const double x = (k % n + 0.5) * dx - reach.x(), y = (k / n + 0.5) * dy - reach.y();
      double end = -reach.z(), end_of_two = -reach.z();  // of what one sphere holds, and two of them
      for (const auto& [from, to] : within(clump, x, y)) {
        thrice = std::max(thrice, std::min(end_of_two, to) - from);
        end_of_two = std::max(end_of_two, std::min(end, to));
        const double a = std::max(from, end), b = std::max(to, end), length = b - a;
        end = b;
        const double z1 = (b * b - a * a) / 2.0, z2 = (b * b * b - a * a * a) / 3.0;
        const double area = dx * dy;
        volume += area * length;
        first += area * Eigen::Vector3d(x * length, y * length, z1);
        Eigen::Matrix3d moments;
        moments << x * x * length, x * y * length, x * z1, y * x * length, y * y * length, y * z1, x * z1, y * z1, z2;
        second += area * moments;
      }
    }
    EXPECT_LT(thrice, 1e-9 * kRadius) << "three spheres share a point: the closed form does not hold";
    EXPECT_NEAR(volume, clump.volume, kGrid * clump.volume);
    EXPECT_LT((first / volume).norm(), kGrid * kRadius);
    const Eigen::Matrix3d inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
    EXPECT_LT((inertia - clump.inertia).norm(), kGrid * clump.inertia.norm());
  }
}

// The files by which inputs/regolith/in.bed makes clumps, for a radius of 1.
TEST(ClumpShape, ScriptOfTheLandingHasTheSameNumbers) {
  for (const ClumpShape shape : every<ClumpShape>()) {
    const std::string file = FOOTFALL_SOURCE_DIR "/inputs/regolith/clumps/" + std::string(name_of(shape));
    SCOPED_TRACE(file);
    const Clump clump = clump_of(shape, 1.0);
    std::ifstream places(file + ".txt"), script(file + ".lammps");
    for (Eigen::Index i = 0; i < clump.centres.cols(); ++i) {
      Eigen::Vector4d sphere;
      for (double& number : sphere) ASSERT_TRUE(places >> number);
      EXPECT_LT((sphere.head<3>() - clump.centres.col(i)).norm(), 1e-14);
      EXPECT_NEAR(sphere[3], clump.radius, 1e-14);
    }
    std::map<std::string, double> variables;
    for (std::string line, word, name; std::getline(script, line);) {
      std::istringstream words(line);
      if (words >> word >> name && word == "variable") words >> word >> variables[name];
    }
    EXPECT_EQ(variables["spheres"], static_cast<double>(clump.centres.cols()));
    EXPECT_LT((clump.inertia - Eigen::Vector3d(variables["inertia_x"], variables["inertia_y"], variables["inertia_z"])
                                   .asDiagonal()
                                   .toDenseMatrix())
                  .norm(),
              1e-13);
  }
}

TEST(ClumpShape, HasTwoToSixSpheresAndItsName) {
  std::vector<Eigen::Index> spheres;
  for (const ClumpShape shape : every<ClumpShape>()) {
    spheres.push_back(clump_of(shape, kRadius).centres.cols());
    EXPECT_EQ(clump_shape(std::string(name_of(shape))), shape);
  }
  EXPECT_EQ(spheres, (std::vector<Eigen::Index>{2, 3, 3, 4, 5, 6}));
  EXPECT_THROW(clump_shape("tetraedron"), InputError);
}

// Over a period, six of the longest waves, whatever waves coincide.
TEST(Roughness, HasItsHeightForEverySeed) {
  TerrainSpec terrain;
  terrain.roughness.emplace();
  terrain.roughness->height = 0.05;
  terrain.roughness->shortest = 0.25;
  terrain.roughness->longest = 1.0;
  constexpr int kSamples = 120;
  for (int seed = 1; seed <= 12; ++seed) {
    terrain.roughness->seed = seed;
    Terrain ground = *terrain_of(terrain);
    double square = 0.0, mean = 0.0;
    for (int i = 0; i < kSamples; ++i)
      for (int j = 0; j < kSamples; ++j) {
        const double h = ground.at(6.0 * i / kSamples, 6.0 * j / kSamples).h / (kSamples * kSamples);
        mean += h;
        square += h * h * kSamples * kSamples;
      }
    EXPECT_NEAR(std::sqrt(square), 0.05, 1e-4) << seed;
    EXPECT_NEAR(mean, 0.0, 1e-4) << seed;
  }
}

}  // namespace
}  // namespace footfall

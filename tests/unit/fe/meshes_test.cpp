// Meshes, solids that they enclose, and models made of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "tests/support/fe_reference.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

// mbd_solver/fe/mesh_generator.h and mesh_check.h.

using namespace test;

using Eigen::Vector3d;

Vector3d area_vector(const TriangleMesh& mesh, const Eigen::Vector3i& t) {
  const Vector3d& p = mesh.vertices[static_cast<std::size_t>(t(0))];
  return 0.5 *
         (mesh.vertices[static_cast<std::size_t>(t(1))] - p).cross(mesh.vertices[static_cast<std::size_t>(t(2))] - p);
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) sum += area_vector(mesh, t).norm();
  return sum;
}

MeshDemands demands(bool closed, bool connected, bool oriented) {
  MeshDemands result;
  result.closed = closed;
  result.connected = connected;
  result.oriented = oriented;
  return result;
}

// The one finding of a damaged mesh.
std::string finding(const TriangleMesh& mesh, const MeshDemands& wanted) {
  const std::vector<std::string> findings = mesh_findings(mesh, wanted);
  EXPECT_EQ(findings.size(), 1u);
  return findings.empty() ? "" : findings[0];
}

TEST(DiscMesh, HasSymmetricRingsOfNearUniformTriangles) {
  const double R = 0.2;
  const int n = 7;
  const TriangleMesh mesh = disc_mesh(R, R / n);
  EXPECT_EQ(mesh.vertices.size(), 1u + 3 * n * (n + 1));
  EXPECT_EQ(mesh.triangles.size(), 6u * n * n);
  EXPECT_TRUE(mesh_findings(mesh, demands(false, true, true)).empty());
  EXPECT_EQ(mesh.vertices[0], Vector3d::Zero());
  double shortest = R, longest = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    EXPECT_GT(area_vector(mesh, t).z(), 0.0) << "normals along z";
    for (int i = 0; i < 3; ++i) {
      const double edge =
          (mesh.vertices[static_cast<std::size_t>(t(i))] - mesh.vertices[static_cast<std::size_t>(t((i + 1) % 3))])
              .norm();
      shortest = std::min(shortest, edge);
      longest = std::max(longest, edge);
    }
  }
  EXPECT_GT(shortest, 0.99 * R / n);
  EXPECT_LT(longest, 1.45 * R / n) << "a diagonal from a spoke: sqrt(1 + (pi/3)^2)";
  // Area of the inscribed polygon of 6 n sides.
  EXPECT_NEAR(area(mesh), 3.0 * n * R * R * std::sin(2.0 * kPi / (6 * n)), kFeRoundOff);
  // Turned by 60 degrees the vertices fall on themselves.
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(kPi / 3.0, Vector3d::UnitZ()).toRotationMatrix();
  for (const Vector3d& p : mesh.vertices) {
    double nearest = R;
    for (const Vector3d& q : mesh.vertices) nearest = std::min(nearest, (turn * p - q).norm());
    EXPECT_LT(nearest, kFeRoundOff);
  }
}

TEST(DishMesh, LiesOnItsSphereAndOpensUpwards) {
  const double a = 0.2, d = 0.05;
  const TriangleMesh mesh = dish_mesh(a, d, 0.02);
  const double sphere = (a * a + d * d) / (2.0 * d);
  double highest = 0.0;
  for (const Vector3d& p : mesh.vertices) {
    EXPECT_NEAR((p - Vector3d(0, 0, sphere)).norm(), sphere, kFeRoundOff);
    highest = std::max(highest, p.z());
  }
  EXPECT_NEAR(highest, d, kFeRoundOff);
  EXPECT_NEAR(mesh.vertices.back().head<2>().norm(), a, kFeRoundOff) << "the last ring is the rim";
  for (const Eigen::Vector3i& t : mesh.triangles) EXPECT_GT(area_vector(mesh, t).z(), 0.0);
  EXPECT_TRUE(mesh_findings(mesh, demands(false, true, true)).empty());
  EXPECT_NEAR(area(mesh), kPi * (a * a + d * d), 0.01 * kPi * a * a) << "cap area pi (a^2 + d^2), less the facets'";
  EXPECT_NEAR(dish_mesh(a, a, 0.02).vertices.back().z(), a, kFeRoundOff) << "a half sphere";
}

// The volume within the polygon of its rim, 6 n corners of n rings.
TEST(ThickDiscMesh, IsClosedAndHoldsItsVolume) {
  for (const double thickness : {0.004, 0.1}) {  // thinner and thicker than the edges
    const TriangleMesh mesh = thick_disc_mesh(0.2, thickness, 0.05);
    EXPECT_TRUE(mesh_findings(mesh, demands(true, true, true)).empty());
    double volume = 0.0;
    for (const Eigen::Vector3i& t : mesh.triangles)
      volume += area_vector(mesh, t).dot(mesh.vertices[static_cast<std::size_t>(t(0))]) / 3.0;
    const double corners = 24.0;
    EXPECT_NEAR(volume, thickness * 0.5 * corners * 0.04 * std::sin(2.0 * kPi / corners), kFeRoundOff)
        << "positive: normals outward";
  }
}

TEST(BoxMesh, IsClosedAndFacesOutward) {
  const Vector3d size(0.3, 0.2, 0.5);
  const TriangleMesh mesh = box_mesh(size, 0.06);
  EXPECT_TRUE(mesh_findings(mesh, demands(true, true, true)).empty());
  double volume = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles)
    volume += area_vector(mesh, t).dot(mesh.vertices[static_cast<std::size_t>(t(0))]) / 3.0;
  EXPECT_NEAR(volume, size.prod(), kFeRoundOff) << "positive: normals outward";
  EXPECT_NEAR(area(mesh), 2.0 * (0.06 + 0.1 + 0.15), kFeRoundOff);
}

TEST(MeshGenerators, RefuseWhatIsNoShape) {
  EXPECT_THROW(disc_mesh(0.0, 0.1), InputError);
  EXPECT_THROW(disc_mesh(1.0, -0.1), InputError);
  EXPECT_THROW(disc_mesh(200.0, 0.02), InputError) << "millions of triangles: millimetres taken for metres";
  EXPECT_THROW(dish_mesh(0.1, 0.2, 0.01), InputError);
  EXPECT_THROW(box_mesh(Vector3d(1, 0, 1), 0.1), InputError);
}

TEST(WeldedMesh, JoinsTheLooseTrianglesOfAnStlFile) {
  const TriangleMesh box = box_mesh(Vector3d(1, 1, 1), 0.25);
  TriangleMesh loose;  // three vertices of its own per triangle, with noise
  for (const Eigen::Vector3i& t : box.triangles) {
    const int first = static_cast<int>(loose.vertices.size());
    for (int i = 0; i < 3; ++i)
      loose.vertices.push_back(box.vertices[static_cast<std::size_t>(t(i))] + 1e-8 * Vector3d::Random());
    loose.triangles.emplace_back(first, first + 1, first + 2);
  }
  EXPECT_FALSE(mesh_findings(loose, demands(true, true, true)).empty());
  const TriangleMesh mesh = welded(loose, 1e-6);
  EXPECT_EQ(mesh.vertices.size(), box.vertices.size());
  EXPECT_TRUE(mesh_findings(mesh, demands(true, true, true)).empty());
}

TEST(MovedMesh, KeepsItsShape) {
  const TriangleMesh disc = disc_mesh(1.0, 0.5);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const TriangleMesh mesh = moved(disc, R, Vector3d(1, 2, 3));
  EXPECT_NEAR(area(mesh), area(disc), kFeRoundOff);
  EXPECT_LT((mesh.vertices[0] - Vector3d(1, 2, 3)).norm(), kFeRoundOff);
}

TEST(MeshCheck, NamesTheTrianglesOfEveryDefect) {
  const TriangleMesh good = box_mesh(Vector3d(1, 1, 1), 1.0);  // 12 triangles

  TriangleMesh mesh = good;
  mesh.triangles.erase(mesh.triangles.begin() + 5);
  std::string text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(names(text, {"triangles "}));
  EXPECT_TRUE(mesh_findings(mesh, demands(false, true, true)).empty()) << "not closed matters only where asked";

  mesh = good;
  mesh.triangles.push_back(Eigen::Vector3i(mesh.triangles[3](1), mesh.triangles[3](0), mesh.triangles[3](2)));
  text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(names(text, {"triangle 12:"}));

  mesh = good;
  mesh.triangles.emplace_back(0, 0, 1);
  text = finding(mesh, demands(false, true, false));
  EXPECT_TRUE(names(text, {"triangle 12:"}));

  mesh = good;
  mesh.vertices.push_back(0.5 * (mesh.vertices[0] + mesh.vertices[1]));
  mesh.triangles.emplace_back(0, 1, static_cast<int>(mesh.vertices.size()) - 1);
  text = finding(mesh, demands(false, true, false));
  EXPECT_TRUE(names(text, {"triangle 12:"}));

  mesh = good;
  std::swap(mesh.triangles[4](0), mesh.triangles[4](1));
  text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(names(text, {"4"}));

  mesh = good;
  const int offset = static_cast<int>(good.vertices.size());
  for (const Vector3d& p : good.vertices) mesh.vertices.push_back(p + Vector3d(3, 0, 0));
  for (const Eigen::Vector3i& t : good.triangles) mesh.triangles.push_back(t.array() + offset);
  text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(names(text, {"12, 13"}));
  EXPECT_TRUE(mesh_findings(mesh, demands(true, false, true)).empty());

  mesh = good;
  mesh.triangles[2](0) = 99;
  text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(names(text, {"triangle 2:"}));

  mesh = good;  // a fin on an edge
  mesh.vertices.push_back(Vector3d(2, 2, 2));
  mesh.triangles.emplace_back(mesh.triangles[0](0), mesh.triangles[0](1), static_cast<int>(mesh.vertices.size()) - 1);
  EXPECT_GE(mesh_findings(mesh, demands(true, false, false)).size(), 1u);
  EXPECT_TRUE(mesh_findings(mesh, demands(false, true, false)).empty());

  EXPECT_FALSE(mesh_findings(TriangleMesh{}, demands(false, false, false)).empty());
}

TEST(MeshCheck, ThrowsWithTheNameOfTheFile) {
  TriangleMesh mesh = disc_mesh(1.0, 0.5);
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.triangles.emplace_back(1, 1, 2);
  EXPECT_TRUE(names(error_of([&] { check_mesh(mesh, demands(false, true, false), "pad.stl"); }),
                    {"pad.stl: triangle 24:", "pad.stl: triangle 25:"}));
}

// mbd_solver/fe/triangle_mesh.h, and the capsule of mbd_solver/fe/mesh_generator.h.

using Eigen::Matrix3d;

constexpr double kDensity = 2500.0;

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const int first = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Eigen::Vector3i& t : b.triangles) a.triangles.emplace_back(t.array() + first);
  return a;
}

TriangleMesh sphere_of(double radius) { return capsule_mesh(radius, 1e-3, 0.5 * radius); }

TriangleMesh inside_out(TriangleMesh mesh) {
  for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

std::string refusal_of(const TriangleMesh& mesh) {
  return refusal([&] { polyhedron_properties(mesh, kDensity, "rock.stl"); });
}

void expect_same(const MassProperties& a, const MassProperties& b, double relative) {
  EXPECT_NEAR(a.mass, b.mass, relative * b.mass);
  EXPECT_LT((a.centre - b.centre).norm(), relative);
  EXPECT_LT((a.inertia - b.inertia).norm(), relative * b.inertia.norm());
}

// A box anywhere, at any attitude, however fine its triangles are.
TEST(Polyhedron, BoxHasTheMassAndInertiaOfABox) {
  const Vector3d size(0.3, 0.2, 0.1), p(5.0, -3.0, 2.0);
  const Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  MassProperties box = box_properties(size, kDensity);
  box.centre = p;
  box.inertia = R * box.inertia * R.transpose();
  for (const double edge : {1.0, 0.03}) {
    expect_same(polyhedron_properties(moved(box_mesh(size, edge), R, p), kDensity, "box"), box, 1e-11);  // p/size times
  }
}

// The corner of a cube of side a: V = a^3/6, centre a/4, about it Ixx = 2 (a^2/10 - a^2/16) V, Ixy = -(a^2/20 - a^2/16) V.
TEST(Polyhedron, TetrahedronIsThatOfTheTextbook) {
  const double a = 0.6;
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {a, 0, 0}, {0, a, 0}, {0, 0, a}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const MassProperties p = polyhedron_properties(mesh, 1.0, "tetrahedron");
  const double V = a * a * a / 6.0;
  EXPECT_NEAR(p.mass, V, kFeRoundOff);
  EXPECT_LT((p.centre - Vector3d::Constant(a / 4.0)).norm(), kFeRoundOff);
  EXPECT_NEAR(p.inertia(0, 0), 2.0 * (a * a / 10.0 - a * a / 16.0) * V, kFeRoundOff);
  EXPECT_NEAR(p.inertia(0, 1), -(a * a / 20.0 - a * a / 16.0) * V, kFeRoundOff);
}

// The polyhedron in a capsule comes to the closed form with the square of its edges.
TEST(Polyhedron, CapsuleComesToItsClosedFormWithSecondOrder) {
  const MassProperties exact = capsule_properties({0, 0, -0.15}, {0, 0, 0.15}, 0.2, kDensity);
  double before = 0.0;
  for (const int rings : {4, 8, 16}) {  // on each half ball
    const TriangleMesh mesh = capsule_mesh(0.1, 0.3, 0.5 * kPi * 0.1 / rings);
    MeshDemands demands;
    demands.closed = demands.connected = demands.oriented = true;
    EXPECT_TRUE(mesh_findings(mesh, demands).empty());
    const MassProperties p = polyhedron_properties(mesh, kDensity, "capsule");
    EXPECT_LT(p.centre.norm(), kFeRoundOff);
    const double error = (p.inertia - exact.inertia).norm() / exact.inertia.norm();
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(before / error), 2.0, 0.05);  // terms of fourth order: (pi / 12 / 4)^2 of it
    }
    before = error;
  }
  EXPECT_LT(before, 0.01);
}

// What a formula alone gives: half a ball at each end (2/5 m r^2 about its flat side), a cylinder between.
TEST(Polyhedron, CapsuleWithoutLengthIsABall) {
  const MassProperties ball = sphere_properties(0.1, kDensity);
  const MassProperties p = capsule_properties({0, 0, -1e-9}, {0, 0, 1e-9}, 0.2, kDensity);
  EXPECT_NEAR(p.mass, ball.mass, 1e-7 * ball.mass);
  EXPECT_LT((p.inertia - ball.inertia).norm(), 1e-7 * ball.inertia.norm());
}

TEST(Polyhedron, CavityIsTakenAway) {
  const Vector3d outer(0.4, 0.4, 0.4), inner(0.2, 0.2, 0.2);
  const MassProperties hollow =
      polyhedron_properties(joined(box_mesh(outer, 1.0), inside_out(box_mesh(inner, 1.0))), kDensity, "hollow");
  const MassProperties a = box_properties(outer, kDensity), b = box_properties(inner, kDensity);
  EXPECT_NEAR(hollow.mass, a.mass - b.mass, kFeRoundOff * a.mass);
  EXPECT_LT((hollow.inertia - (a.inertia - b.inertia)).norm(), kFeRoundOff * a.inertia.norm());
}

TEST(Polyhedron, OfSeveralPiecesIsTheirSum) {
  const TriangleMesh box = box_mesh({0.2, 0.2, 0.2}, 1.0);
  const TriangleMesh other = moved(box, Matrix3d::Identity(), {1.0, 0.0, 0.0});
  const MassProperties p = polyhedron_properties(joined(box, other), kDensity, "two");
  MassProperties one = box_properties({0.2, 0.2, 0.2}, kDensity), two = one;
  two.centre.x() = 1.0;
  expect_same(p, one + two, 1e-11);
  // One of them turned inside out is no cavity.
  EXPECT_NE(refusal_of(joined(box, inside_out(other))), "");
}

// A ball in a ball: a cavity if it faces inward, counted twice if it faces outward, which is refused with its triangles.
TEST(Polyhedron, ShellWithinAShellIsACavityOrRefused) {
  const TriangleMesh outer = sphere_of(0.5), inner = sphere_of(0.3), core = sphere_of(0.1);
  const double V = polyhedron_properties(outer, 1.0, "").mass, v = polyhedron_properties(inner, 1.0, "").mass,
               c = polyhedron_properties(core, 1.0, "").mass;
  EXPECT_NEAR(polyhedron_properties(joined(outer, inside_out(inner)), 1.0, "").mass, V - v, kFeRoundOff);
  // A solid within the cavity.
  EXPECT_NEAR(polyhedron_properties(joined(joined(outer, inside_out(inner)), core), 1.0, "").mass, V - v + c,
              kFeRoundOff);
  const int first = static_cast<int>(outer.triangles.size());
  EXPECT_TRUE(names(refusal_of(joined(outer, inner)), {"E0320", std::to_string(first), std::to_string(first + 1)}));
  EXPECT_TRUE(names(refusal_of(joined(joined(outer, inside_out(inner)), inside_out(core))), {"E0320"}));
  // Within the box around a dented solid, but not within the solid.
  TriangleMesh dented = box_mesh({2.0, 2.0, 2.0}, 1.0);
  for (Vector3d& x : dented.vertices)
    if ((x - Vector3d(0, 0, 1)).norm() < 1e-9) x.z() = -0.8;
  EXPECT_TRUE(
      names(refusal_of(joined(dented, moved(inside_out(core), Matrix3d::Identity(), {0.0, 0.0, 0.6}))), {"E0320"}));
}

// Boxes that overlap by a corner, by a slab between coplanar faces, entirely, or by equal halves; and those that only touch.
TEST(Polyhedron, OverlappingShellsAreRefusedAndTouchingOnesAdded) {
  const TriangleMesh box = box_mesh({1.0, 1.0, 1.0}, 2.0);
  const auto with = [&](const Vector3d& shift, const Vector3d& size = Vector3d::Ones(), double angle = 0.0) {
    const Matrix3d R = Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    return joined(box, moved(box_mesh(size, 2.0), R, shift));
  };
  for (const Vector3d& shift : {Vector3d(0.9, 0.9, 0.9), Vector3d(0.9, 0.0, 0.0), Vector3d(0.9, 0.9, 0.0),
                                Vector3d(0.5, 0.5, 0.0), Vector3d(0.3, -0.2, 0.1)}) {
    const std::string text = refusal_of(with(shift));
    EXPECT_TRUE(names(text, {"E0320", "triangles "})) << shift.transpose();
    EXPECT_NE(refusal_of(with(shift, Vector3d::Ones(), 0.3)), "") << shift.transpose();
  }
  EXPECT_NE(refusal_of(with({0.0, 0.0, 0.0}, Vector3d(1.5, 0.2, 0.2))), "") << "a bar through a box";
  EXPECT_NE(refusal_of(with({0.0, 0.0, 0.0}, Vector3d(1.0, 0.2, 0.2))), "") << "a bar with its ends in the faces";
  EXPECT_NE(refusal_of(with({0.0, 0.0, 0.0}, Vector3d::Ones())), "") << "the same box twice";
  for (const Vector3d& shift : {Vector3d(1.0, 0.3, 0.2), Vector3d(1.0, 0.0, 0.2), Vector3d(1.0, 1.0, 0.3)}) {
    EXPECT_EQ(refusal_of(with(shift)), "") << shift.transpose();
    EXPECT_NEAR(polyhedron_properties(with(shift), 1.0, "").mass, 2.0, kFeRoundOff) << shift.transpose();
  }
}

// The same with common vertices, as a welded file has them: an edge of four triangles, two each way.
TEST(Polyhedron, ShellsThatShareAnEdgeAreAdded) {
  const TriangleMesh box = box_mesh({1.0, 1.0, 1.0}, 2.0);
  const TriangleMesh both = welded(joined(box, moved(box, Matrix3d::Identity(), {1.0, 1.0, 0.0})), 1e-9);
  EXPECT_EQ(both.vertices.size(), 2 * box.vertices.size() - 2) << "the edge from bottom to top";
  EXPECT_EQ(refusal_of(both), "");
  EXPECT_NEAR(polyhedron_properties(both, 1.0, "").mass, 2.0, kFeRoundOff);
}

// A box whose top is pushed in, then through its bottom.
TEST(Polyhedron, ShellThatCrossesItselfIsRefused) {
  TriangleMesh mesh = box_mesh({1.0, 1.0, 1.0}, 0.5);
  std::size_t top = 0;  // in the middle of the face z = 0.5
  while ((mesh.vertices[top] - Vector3d(0, 0, 0.5)).norm() > 1e-9) ++top;
  EXPECT_EQ(refusal_of(mesh), "");
  mesh.vertices[top].z() = -0.4;
  EXPECT_EQ(refusal_of(mesh), "") << "a deep dent";
  mesh.vertices[top] = {0.1, 0.15, -0.8};
  EXPECT_TRUE(names(refusal_of(mesh), {"E0320", "triangles "}));
}

// Coordinates of a site: 1e6 m from the origin, where double precision has 1e-10 m.
TEST(Polyhedron, FarFromTheOriginKeepsItsDigits) {
  const Vector3d size(0.3, 0.3, 0.05), p(448251.37, 5411932.91, 1234.5);
  const MassProperties far = polyhedron_properties(moved(box_mesh(size, 0.1), Matrix3d::Identity(), p), 1000.0, "far");
  const MassProperties near = box_properties(size, 1000.0);
  const double digits = 4.0 * 1e-9 / 0.05;  // of the coordinates, over the thickness
  EXPECT_NEAR(far.mass, 4.5, digits * 4.5);
  EXPECT_LT((far.centre - p).norm(), 1e-8);
  EXPECT_LT((far.inertia - near.inertia).norm(), digits * near.inertia.norm());
}

TEST(Polyhedron, RefusesWhatEnclosesNothing) {
  TriangleMesh box = box_mesh({0.2, 0.2, 0.2}, 1.0);
  EXPECT_NE(refusal_of(inside_out(box)), "");
  TriangleMesh turned = box;
  std::swap(turned.triangles[0][1], turned.triangles[0][2]);
  EXPECT_NE(refusal_of(turned), "");
  box.triangles.pop_back();
  EXPECT_NE(refusal_of(box), "");
}

using Eigen::VectorXd;

TEST(StraightBeam, HasTheExactMassPropertiesOfACylinder) {
  const double d = 0.05, L = 0.8;
  const Vector3d from(0.1, 0.2, 0.3), axis = Vector3d(1, -2, 0.5).normalized();
  for (int n : {1, 2, 5}) {
    const MassProperties body = mass_properties(test::straight_beam(from, from + L * axis, n, rod_section(d), kSteel));
    const double m = kSteel.density * kPi / 4.0 * d * d * L;
    const double along = m * d * d / 8.0, across = m * (d * d / 16.0 + L * L / 12.0);
    const Matrix3d J = across * Matrix3d::Identity() + (along - across) * axis * axis.transpose();
    EXPECT_NEAR(body.mass, m, kFeRoundOff * m);
    EXPECT_LT((body.centre - (from + 0.5 * L * axis)).norm(), kFeRoundOff);
    EXPECT_LT((body.inertia - J).norm(), kFeRoundOff * J.norm()) << n << " elements";
  }
}

TEST(PlateModel, WeighsAreaTimesThicknessAndWithMassWhatIsWanted) {
  const double R = 0.2, t = 0.008;
  const int n = 10;
  const FeModel model = plate_model(disc_mesh(R, R / n), t, kSteel);
  const double polygon = 3.0 * n * R * R * std::sin(kPi / (3.0 * n));
  const MassProperties body = mass_properties(model);
  EXPECT_NEAR(body.mass, kSteel.density * t * polygon, kFeRoundOff * body.mass);
  EXPECT_LT(body.centre.norm(), kFeRoundOff);
  const double disc = 0.5 * body.mass * R * R;  // about the axis
  EXPECT_NEAR(body.inertia(2, 2), disc, 0.01 * disc) << "lumping at corners adds (edge/radius)^2, the polygon takes";
  const MassProperties heavier = mass_properties(with_mass(model, 20.0));
  EXPECT_NEAR(heavier.mass, 20.0, kFeRoundOff * 20.0);
  EXPECT_LT((heavier.inertia - 20.0 / body.mass * body.inertia).norm(), kFeRoundOff * heavier.inertia.norm());
}

TEST(Frame, OfTwoMembersAtARightAngleDeflectsAsWorkedOutByHand) {
  // Column of height h clamped at its foot, arm of length b with a load P down at its end: the column bends
  // under the constant moment P b and is compressed, the arm under the load. Deflection down: P b^2 h/(EI) +
  // P b^3/(3 EI) + P h/(EA).
  const double h = 0.6, b = 0.4, P = 50.0;
  const BeamSection section = tube_section(0.04, 0.003);
  const FeModel model = beam_model({{0, 0, 0}, {0, 0, h}, {b, 0, h}}, {member(0, 1), member(1, 2)}, {section}, kSteel);
  VectorXd load = VectorXd::Zero(6 * model.node_count());
  load(6 * 2 + 2) = -P;
  const VectorXd u = static_solution(model, test::node_dofs(0), load);
  const double EI = kSteel.young * section.bending_y;
  const double exact = P * b * b * h / EI + P * b * b * b / (3.0 * EI) + P * h / (kSteel.young * section.area);
  EXPECT_NEAR(-u(6 * 2 + 2), exact, 1e-9 * exact);
  EXPECT_NEAR(u(6 * 1 + 0), P * b * h * h / (2.0 * EI), 1e-9 * exact);
}

TEST(BeamModel, RefusesFramesThatAreNoBody) {
  const std::vector<BeamSection> sections = {rod_section(0.01)};
  const std::vector<Vector3d> nodes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const auto with = [&](const std::vector<BeamMember>& members) {
    return refusal([&] { beam_model(nodes, members, sections, kSteel); });
  };
  EXPECT_NE(with({member(0, 1), member(2, 3)}), "");
  EXPECT_NE(with({member(0, 1), member(1, 2)}), "");
  EXPECT_NE(with({member(0, 4)}), "");
  EXPECT_NE(with({member(0, 1, 1)}), "");
  EXPECT_NE(with({member(2, 2)}), "");
  EXPECT_NE(with({}), "");
  BeamMember turned = member(0, 1);
  turned.up = Vector3d(0, 0, std::nan(""));
  EXPECT_NE(with({turned}), "");
  EXPECT_THROW(test::straight_beam(nodes[0], nodes[1], 0, sections[0], kSteel), InputError);
}

TEST(PlateModel, RefusesBadMeshesAndThickness) {
  TriangleMesh mesh = disc_mesh(1.0, 0.5);
  EXPECT_THROW(plate_model(mesh, 0.0, kSteel, "pad"), InputError);
  mesh.vertices.push_back(Vector3d(5, 5, 5));
  EXPECT_THROW(plate_model(mesh, 0.01, kSteel, "pad"), InputError);
  const TriangleMesh far = moved(disc_mesh(1.0, 0.5), Matrix3d::Identity(), Vector3d(5, 0, 0));
  mesh = disc_mesh(1.0, 0.5);
  const int offset = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), far.vertices.begin(), far.vertices.end());
  for (const Eigen::Vector3i& t : far.triangles) mesh.triangles.push_back(t.array() + offset);
  EXPECT_THROW(plate_model(mesh, 0.01, kSteel, "pad"), InputError);
}

TEST(StaticSolution, RefusesABodyThatIsNotHeld) {
  const FeModel model = test::straight_beam({0, 0, 0}, {1, 0, 0}, 2, rod_section(0.01), kSteel);
  const VectorXd load = VectorXd::Ones(6 * model.node_count());
  EXPECT_THROW(static_solution(model, test::node_dofs(0, {0, 1, 2}), load), InputError);
  EXPECT_NO_THROW(static_solution(model, test::node_dofs(0), load));
}

TEST(NodeLookup, FindsTheNearestNodeAndRefusesJointsAwayFromAny) {
  FeModel model = test::straight_beam({0, 0, 0}, {1, 0, 0}, 4, rod_section(0.01), kSteel);
  EXPECT_EQ(nearest_node(model, Vector3d(0.26, 0.1, 0)), 1);
  EXPECT_EQ(nearest_node(model, Vector3d(0.38, 0, 0)), 6) << "the middle of the second element";
  EXPECT_EQ(joint_node(model, Vector3d(1.0, 0, 1e-4), 1e-3, true), 4);
  EXPECT_TRUE(names(error_of([&] { joint_node(model, Vector3d(1.2, 0, 0), 1e-3, false); }), {"4", "0.2 m"}));
  for (Eigen::Index i = 0; i < 6 * model.node_count(); ++i)
    if (i % 6 >= 3) model.stiffness.coeffRef(i, i) = 0.0;  // as of a solid
  EXPECT_EQ(joint_node(model, Vector3d(1.0, 0, 0), 1e-3, false), 4);
  EXPECT_THROW(joint_node(model, Vector3d(1.0, 0, 0), 1e-3, true), InputError);
}

}  // namespace
}  // namespace footfall

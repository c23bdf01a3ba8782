// mbd_solver/fe/polyhedron.h, and the capsule of mbd_solver/fe/mesh_generator.h.
#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/fe/mesh_check.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/polyhedron.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kDensity = 2500.0;

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const int first = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Eigen::Vector3i& t : b.triangles) a.triangles.emplace_back(t.array() + first);
  return a;
}

TriangleMesh inside_out(TriangleMesh mesh) {
  for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

std::string refusal(const TriangleMesh& mesh) {
  try {
    polyhedron_properties(mesh, kDensity, "rock.stl");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
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
  EXPECT_NE(refusal(joined(box, inside_out(other))).find("faces inward"), std::string::npos);
}

TEST(Polyhedron, RefusesWhatEnclosesNothing) {
  TriangleMesh box = box_mesh({0.2, 0.2, 0.2}, 1.0);
  EXPECT_NE(refusal(inside_out(box)).find("rock.stl: the surface faces inward"), std::string::npos);
  TriangleMesh turned = box;
  std::swap(turned.triangles[0][1], turned.triangles[0][2]);
  EXPECT_NE(refusal(turned).find("neighbours disagree on which side is outside"), std::string::npos);
  box.triangles.pop_back();
  EXPECT_NE(refusal(box).find("rock.stl: the surface is not closed"), std::string::npos);
}

}  // namespace
}  // namespace footfall

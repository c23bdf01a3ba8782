#include "mbd_solver/fe/fe_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/node_lookup.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

TEST(StraightBeam, HasTheExactMassPropertiesOfACylinder) {
  const double d = 0.05, L = 0.8;
  const Vector3d from(0.1, 0.2, 0.3), axis = Vector3d(1, -2, 0.5).normalized();
  for (int n : {1, 2, 5}) {
    const MassProperties body = mass_properties(straight_beam(from, from + L * axis, n, rod_section(d), kSteel));
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
  const VectorXd u = static_solution(model, node_dofs(0), load);
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
  EXPECT_TRUE(has(with({member(0, 1), member(2, 3)}), "disconnected pieces"));
  EXPECT_TRUE(has(with({member(0, 1), member(1, 2)}), "node 3 belongs to no member, so no joint can attach"));
  EXPECT_TRUE(has(with({member(0, 4)}), "unknown node 4"));
  EXPECT_TRUE(has(with({member(0, 1, 1)}), "unknown section 1"));
  EXPECT_TRUE(has(with({member(2, 2)}), "at the same place"));
  EXPECT_TRUE(has(with({}), "no members"));
  BeamMember turned = member(0, 1);
  turned.up = Vector3d(0, 0, std::nan(""));
  EXPECT_TRUE(has(with({turned}), "not finite"));
  EXPECT_TRUE(has(refusal([&] { straight_beam(nodes[0], nodes[1], 0, sections[0], kSteel); }), "0 elements"));
}

TEST(PlateModel, RefusesBadMeshesAndThickness) {
  TriangleMesh mesh = disc_mesh(1.0, 0.5);
  EXPECT_TRUE(has(refusal([&] { plate_model(mesh, 0.0, kSteel, "pad"); }), "pad: thickness"));
  mesh.vertices.push_back(Vector3d(5, 5, 5));
  EXPECT_TRUE(has(refusal([&] { plate_model(mesh, 0.01, kSteel, "pad"); }), "no joint can attach"));
  const TriangleMesh far = moved(disc_mesh(1.0, 0.5), Matrix3d::Identity(), Vector3d(5, 0, 0));
  mesh = disc_mesh(1.0, 0.5);
  const int offset = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), far.vertices.begin(), far.vertices.end());
  for (const Eigen::Vector3i& t : far.triangles) mesh.triangles.push_back(t.array() + offset);
  EXPECT_TRUE(has(refusal([&] { plate_model(mesh, 0.01, kSteel, "pad"); }), "disconnected"));
}

TEST(StaticSolution, RefusesABodyThatIsNotHeld) {
  const FeModel model = straight_beam({0, 0, 0}, {1, 0, 0}, 2, rod_section(0.01), kSteel);
  const VectorXd load = VectorXd::Ones(6 * model.node_count());
  EXPECT_THROW(static_solution(model, node_dofs(0, {0, 1, 2}), load), InputError);
  EXPECT_NO_THROW(static_solution(model, node_dofs(0), load));
}

TEST(NodeLookup, FindsTheNearestNodeAndRefusesJointsAwayFromAny) {
  FeModel model = straight_beam({0, 0, 0}, {1, 0, 0}, 4, rod_section(0.01), kSteel);
  EXPECT_EQ(nearest_node(model, Vector3d(0.26, 0.1, 0)), 1);
  EXPECT_EQ(nearest_node(model, Vector3d(0.38, 0, 0)), 6) << "the middle of the second element";
  EXPECT_EQ(joint_node(model, Vector3d(1.0, 0, 1e-4), 1e-3, true), 4);
  const std::string text = refusal([&] { joint_node(model, Vector3d(1.2, 0, 0), 1e-3, false); });
  EXPECT_TRUE(has(text, "no joint can attach") && has(text, "node, 4") && has(text, "0.2 m away")) << text;
  model.rotations = false;
  EXPECT_EQ(joint_node(model, Vector3d(1.0, 0, 0), 1e-3, false), 4);
  EXPECT_TRUE(has(refusal([&] { joint_node(model, Vector3d(1.0, 0, 0), 1e-3, true); }), "spherical"));
}

}  // namespace
}  // namespace footfall

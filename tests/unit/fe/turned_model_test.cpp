#include "mbd_solver/fe/turned_model.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "mbd_solver/fe/mesh_generator.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

const Matrix3d kTurn = Eigen::AngleAxisd(1.1, Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
const Vector3d kShift(0.3, -2.0, 0.7);

// A dish and a bent frame, as drawn and moved by x -> R x + p.
FeModel dish(const Matrix3d& R = Matrix3d::Identity(), const Vector3d& p = Vector3d::Zero(), double young = 207e9) {
  return plate_model(moved(dish_mesh(0.2, 0.04, 0.05), R, p), 0.004, {7850.0, young, 0.3});
}

FeModel frame(const Matrix3d& R = Matrix3d::Identity(), const Vector3d& p = Vector3d::Zero(), double wall = 0.008) {
  std::vector<Vector3d> nodes = {{0.2, 0.1, 0.0}, {0.7, 0.4, 1.0}, {0.9, 0.4, 1.1}};
  for (Vector3d& node : nodes) node = R * node + p;
  BeamMember first = member(0, 1), second = member(1, 2);
  first.up = second.up = R * Vector3d::UnitY();
  return beam_model(nodes, {first, second}, {tube_section(0.05, wall)}, kSteel);
}

BasisOptions held(int modes, std::vector<int> nodes) {
  BasisOptions options;
  options.mode_count = modes;
  options.interface_nodes = std::move(nodes);
  return options;
}

// What forces at all nodes do, whatever the modes are: Phi K^-1 Phi^T, Psi K^-1 Phi^T, and the stresses.
MatrixXd compliance(const MatrixXd& rows, const ModalBody& body) {
  return rows * body.stiffness.cwiseInverse().asDiagonal() * body.Phi.transpose();
}

// Forces and answers in vectors of three, turned.
MatrixXd turned_blocks(const MatrixXd& matrix, const Matrix3d& rows, const Matrix3d& columns) {
  MatrixXd out(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < matrix.rows(); i += 3)
    for (Eigen::Index j = 0; j < matrix.cols(); j += 3)
      out.block<3, 3>(i, j) = rows * matrix.block<3, 3>(i, j) * columns.transpose();
  return out;
}

void expect_same(const MatrixXd& a, const MatrixXd& b, const char* what) {
  ASSERT_EQ(a.rows(), b.rows()) << what;
  ASSERT_EQ(a.cols(), b.cols()) << what;
  EXPECT_LT((a - b).norm(), 1e-7 * b.norm()) << what;
}

void expect_copy_like_its_own(const FeModel& model, const FeModel& copy, const BasisOptions& options) {
  const std::optional<Vector3d> p = place_of_copy(model, copy, kTurn);
  ASSERT_TRUE(p.has_value());
  EXPECT_LT((*p - kShift).norm(), 1e-12);
  const ReducedBody made = turned(reduce(model, options, "first"), kTurn, *p, "second");
  const ReducedBody own = reduce(copy, options, "second");
  EXPECT_EQ(made.body.name, "second");
  EXPECT_LT((made.p_DBo - own.p_DBo).norm(), 1e-12);
  expect_same(made.body.rho0, own.body.rho0, "nodes");
  for (std::size_t j = 0; j < own.body.node_inertia.size(); ++j)
    EXPECT_LT((made.body.node_inertia[j] - own.body.node_inertia[j]).norm(), 1e-12) << "inertia";
  expect_same(frequencies(made.body), frequencies(own.body), "frequencies");
  expect_same(compliance(made.body.Phi, made.body), compliance(own.body.Phi, own.body), "deflection");
  expect_same(compliance(made.body.Psi, made.body), compliance(own.body.Psi, own.body), "rotation");
  expect_same(compliance(made.body.stress_modes, made.body), compliance(own.body.stress_modes, own.body), "stress");
  // and it is the first one's, turned
  const ModalBody first = reduce(model, options, "first").body;
  expect_same(turned_blocks(compliance(first.Phi, first), kTurn, kTurn), compliance(own.body.Phi, own.body), "turned");
}

TEST(TurnedModel, IsReducedLikeAModelOfItsOwn) {
  expect_copy_like_its_own(dish(), dish(kTurn, kShift), held(6, {}));
  expect_copy_like_its_own(frame(), frame(kTurn, kShift), held(4, {0, 2}));
}

TEST(TurnedModel, IsNoOtherModel) {
  EXPECT_FALSE(place_of_copy(dish(), dish(kTurn, kShift), Matrix3d::Identity())) << "another turn";
  EXPECT_FALSE(place_of_copy(dish(), dish(kTurn, kShift, 207e9 * (1.0 + 1e-8)), kTurn)) << "a little stiffer";
  EXPECT_FALSE(place_of_copy(frame(), frame(kTurn, kShift, 0.008 * (1.0 + 1e-8)), kTurn)) << "a thicker wall";
  EXPECT_FALSE(place_of_copy(frame(), dish(kTurn, kShift), kTurn));
  FeModel heavier = frame(kTurn, kShift);
  heavier.node_mass[1] *= 1.0 + 1e-8;
  EXPECT_FALSE(place_of_copy(frame(), heavier, kTurn));
  FeModel inert = frame(kTurn, kShift);
  inert.node_inertia[1] *= 1.0 + 1e-8;
  EXPECT_FALSE(place_of_copy(frame(), inert, kTurn));
  FeModel bent = frame(kTurn, kShift);
  bent.nodes(0, 2) += 1e-8;
  EXPECT_FALSE(place_of_copy(frame(), bent, kTurn));
  FeModel otherwise_stressed = frame(kTurn, kShift);
  otherwise_stressed.stress *= 1.0 + 1e-8;
  EXPECT_FALSE(place_of_copy(frame(), otherwise_stressed, kTurn));
  FeModel softer = frame(kTurn, kShift);  // one entry of stiffness alone
  softer.stiffness.coeffRef(3, 3) *= 1.0 + 1e-8;
  EXPECT_FALSE(place_of_copy(frame(), softer, kTurn));
  FeModel otherwise_joined = frame(kTurn, kShift);
  std::swap(otherwise_joined.segments[0], otherwise_joined.segments[1]);
  EXPECT_FALSE(place_of_copy(frame(), otherwise_joined, kTurn));
}

}  // namespace
}  // namespace footfall

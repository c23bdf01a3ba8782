// Equations of motion: assembly, derivatives, factors.
#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <cmath>
#include <random>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/dynamics/assembly.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/dynamics/sparse_lu.h"
#include "tests/support/refused.h"
#include "tests/unit/dynamics/jacobian_check.h"
#include "tests/unit/dynamics/random_model.h"

namespace footfall {
namespace {

// From a model to a consistent start.

std::string refusal(const Model& model) {
  return test::refusal([&] { assemble(model); });
}

// Two bodies one metre apart, the second moved by `gap`.
Model pair_with_gap(const Eigen::Vector3d& gap) {
  Model model;
  BodyState second;
  second.r = Eigen::Vector3d(1.0, 0.0, 0.0) + gap;
  model.add_body(Body("a", 1.0, Eigen::Matrix3d::Identity()), {});
  model.add_body(Body("b", 2.0, Eigen::Matrix3d::Identity()), second);
  return model;
}

Marker at(const Model& model, int body, const Eigen::Vector3d& p_B,
          const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity()) {
  return body_marker(body, model.body(body), p_B, axes);
}

TEST(Assembly, ClosesSmallGapsToRoundOff) {
  Model model = pair_with_gap({2e-4, -3e-4, 1e-4});
  model.add_joint(
      fixed_joint("weld", at(model, 0, {0.5, 0.0, 0.0}),
                  at(model, 1, {-0.5, 0.0, 0.0}, rotation_matrix(quaternion_about({1.0, 1.0, 0.0}, 4e-4)))));
  const Assembly assembly = assemble(model);
  EXPECT_NEAR(assembly.largest_gap, std::sqrt(14.0) * 1e-4, 1e-12);
  Equations equations(model, assembly);
  EXPECT_LT(equations.saddle().drift(assembly.state).position, 1e-14);
  // The smallest change in the mass metric leaves the common mass centre where it was.
  const Eigen::Vector3d before = model.initial(0).r + 2.0 * model.initial(1).r;
  EXPECT_LT((assembly.state.q.segment<3>(0) + 2.0 * assembly.state.q.segment<3>(7) - before).norm(), 1e-12);
}

TEST(Assembly, RefusesWhatIsFarFromClosedAndNamesAllOfIt) {
  Model model = pair_with_gap({0.012, 0.0, 0.0});
  model.add_joint(spherical_joint("hinge_3", at(model, 0, {0.5, 0.0, 0.0}), at(model, 1, {-0.5, 0.0, 0.0})));
  model.add_joint(
      revolute_joint("tilted", ground_marker({0.0, 0.0, 0.0}, rotation_matrix(quaternion_about({1.0, 0.0, 0.0}, 0.1))),
                     at(model, 0, {0.0, 0.0, 0.0})));
  const std::string said = refusal(model);
  EXPECT_TRUE(test::names(said, {"hinge_3", "0.012"}));
  EXPECT_TRUE(test::names(said, {"tilted", "5.73"}));
}

TEST(Assembly, SeesAHalfTurn) {
  // All sines of a prismatic joint vanish when body 2 is turned by 180 degrees about its axis.
  Model model = pair_with_gap(Eigen::Vector3d::Zero());
  model.add_joint(
      prismatic_joint("slide", at(model, 0, {0.0, 0.0, 0.0}, axes_with_z({1.0, 0.0, 0.0})),
                      at(model, 1, {0.0, 0.0, 0.0},
                         rotation_matrix(quaternion_about({1.0, 0.0, 0.0}, kPi)) * axes_with_z({1.0, 0.0, 0.0}))));
  EXPECT_TRUE(test::names(refusal(model), {"180"}));
}

TEST(Assembly, MakesVelocitiesConsistent) {
  test::Random random(2);
  Model model;
  BodyState state;
  state.r = {1.0, 0.0, 0.0};
  state.dr = {3.0, 1.0, 0.0};
  const int body = model.add_body(Body("arm", 1.0, Eigen::Vector3d(0.1, 1.0, 1.0).asDiagonal()), state);
  model.add_joint(revolute_joint("pivot", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                 model.marker_at(body, Eigen::Vector3d::Zero())));
  const Assembly assembly = assemble(model);
  Equations equations(model, assembly);
  EXPECT_LT(equations.saddle().drift(assembly.state).velocity, 1e-14);
  // Projection in the mass metric keeps the moment of momentum about the pivot: m r v = (J + m r^2) w.
  EXPECT_NEAR(assembly.state.v[5], 1.0 / 2.0, 1e-14);
  EXPECT_NEAR(assembly.state.v[1], 0.5, 1e-14);
  EXPECT_NEAR(assembly.largest_speed_change, 3.0, 1e-14);
}

TEST(Assembly, FindsRedundantConditionsAndSaysWhichFollowFromWhich) {
  // A door on two hinges: the second one repeats five conditions.
  Model model;
  const int door = model.add_body(Body("door", 20.0, Eigen::Vector3d(2.0, 1.0, 1.0).asDiagonal()), {});
  model.add_joint(
      revolute_joint("upper", model.marker_at(kGround, {-0.5, 0.0, 0.7}), model.marker_at(door, {-0.5, 0.0, 0.7})));
  model.add_joint(
      revolute_joint("lower", model.marker_at(kGround, {-0.5, 0.0, -0.7}), model.marker_at(door, {-0.5, 0.0, -0.7})));
  const Assembly assembly = assemble(model);
  EXPECT_EQ(assembly.rank, 5);
  ASSERT_FALSE(assembly.notes.empty());
  std::string all;
  for (const std::string& note : assembly.notes) all += note;
  EXPECT_TRUE(test::names(all, {"upper"}));
  EXPECT_TRUE(test::names(all, {"lower"}));
  EXPECT_TRUE(test::names(all, {"redundant"}));
}

TEST(Assembly, RefusesJointsThatContradictEachOther) {
  // Hinges of the door 0.4 mm out of line: parallel axes that can never meet, each within the gap that is
  // closed silently.
  Model model;
  const int door = model.add_body(Body("door", 20.0, Eigen::Vector3d(2.0, 1.0, 1.0).asDiagonal()), {});
  model.add_joint(revolute_joint("upper", ground_marker({0.0, 0.0, 0.7}), at(model, door, {0.0, 0.0, 0.7})));
  model.add_joint(prismatic_joint("lower", ground_marker({4e-4, 0.0, -0.7}), at(model, door, {0.0, 0.0, -0.7})));
  const std::string said = refusal(model);
  EXPECT_TRUE(test::names(said, {"contradict"}));
  EXPECT_TRUE(test::names(said, {"lower"}));
}

TEST(Assembly, RefusesDrivesThatContradictEachOther) {
  Model model;
  const int body = model.add_body(Body("cart", 1.0, Eigen::Matrix3d::Identity()), {});
  for (int i = 0; i < 2; ++i) {
    PrescribedMotion motion;
    motion.translation[0] = polynomial({0.0, 1.0 + i});
    model.add_joint(prescribed_joint(i == 0 ? "slow" : "fast", ground_marker(Eigen::Vector3d::Zero()),
                                     at(model, body, {0.0, 0.0, 0.0}), motion));
  }
  const std::string said = refusal(model);
  EXPECT_TRUE(test::names(said, {"slow", "fast"}));
}

TEST(Assembly, TellsWhatItChangedOfTheGivenVelocities) {
  Model model;
  BodyState state;
  state.r = {1.0, 0.0, 0.0};
  state.dr = {3.0, 1.0, 0.0};
  const int body = model.add_body(Body("arm", 1.0, Eigen::Vector3d(0.1, 1.0, 1.0).asDiagonal()), state);
  model.add_joint(revolute_joint("pivot", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                 model.marker_at(body, Eigen::Vector3d::Zero())));
  const Assembly changed = assemble(model);
  ASSERT_EQ(changed.notes.size(), 1u);
  EXPECT_TRUE(test::names(changed.notes[0], {"pivot"}));
  EXPECT_TRUE(test::names(changed.notes[0], {"arm", "3.04", "0.5"}));
  AssemblyOptions lenient;
  lenient.speed_tolerance = 3.1;
  EXPECT_TRUE(assemble(model, lenient).notes.empty());
}

TEST(Assembly, TellsVelocitiesThatContradictEachOtherByATenThousandth) {
  Model model;
  BodyState state;
  state.r = {1.0, 0.0, 0.0};
  state.dr = {0.0, 1.0, 0.0};
  state.w = {0.0, 0.0, 1.0001};
  const int body = model.add_body(Body("arm", 1.0, Eigen::Matrix3d::Identity()), state);
  model.add_joint(revolute_joint("pivot", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                 model.marker_at(body, Eigen::Vector3d::Zero())));
  const Assembly changed = assemble(model);
  ASSERT_EQ(changed.notes.size(), 1u);
  EXPECT_TRUE(test::names(changed.notes[0], {"0.0001"}));
}

TEST(Assembly, ChainsOfManyBodiesAreSparse) {
  // With dense matrices 1000 hinges would take minutes and 1 GB; the time limit of a unit test sees it.
  Model model;
  const int n = 1000;
  for (int i = 0; i < n; ++i) {
    BodyState state;
    state.r = {i + 0.5, 1e-4 * std::sin(0.1 * i), 0.0};
    model.add_body(Body("link_" + std::to_string(i), 1.0, Eigen::Matrix3d::Identity()), state);
    const Marker last = i == 0 ? ground_marker(Eigen::Vector3d::Zero()) : at(model, i - 1, {0.5, 0.0, 0.0});
    model.add_joint(revolute_joint("hinge_" + std::to_string(i), last, at(model, i, {-0.5, 0.0, 0.0})));
  }
  const Assembly assembly = assemble(model);
  EXPECT_EQ(assembly.rank, 5 * n);
  EXPECT_TRUE(assembly.redundant.empty());
  Equations equations(model, assembly);
  EXPECT_LT(equations.saddle().drift(assembly.state).position, 1e-12);  // round-off of 1000 m
}

// A crank whose pin is 1 m from its bearing and 2 m from a peg in line with both: `tie` tells nothing new in this
// position, and holds the crank in all others.
Model toggle() {
  Model model;
  BodyState rod;
  rod.r = {1.0, 0.0, 0.0};
  model.add_body(Body("crank", 1.0, Eigen::Matrix3d::Identity()), {});
  model.add_body(Body("rod", 1.0, Eigen::Matrix3d::Identity()), rod);
  model.add_joint(revolute_joint("bearing", ground_marker(Eigen::Vector3d::Zero()), at(model, 0, {0.0, 0.0, 0.0})));
  model.add_joint(revolute_joint("pin", at(model, 0, {1.0, 0.0, 0.0}), at(model, 1, {0.0, 0.0, 0.0})));
  // always redundant
  model.add_joint(distance_joint("stay", ground_marker({0.0, 0.0, 0.0}), at(model, 1, {0.0, 0.0, 0.0}), 1.0));
  // only here
  model.add_joint(distance_joint("tie", ground_marker({-1.0, 0.0, 0.0}), at(model, 1, {0.0, 0.0, 0.0}), 2.0));
  return model;
}

TEST(Equations, ClosesWhatWasRedundantAtTheStartOnly) {
  const Model model = toggle();
  const Assembly assembly = assemble(model);
  EXPECT_EQ(assembly.rank, 10);
  Equations equations(model, assembly);
  State state = assembly.state;
  Eigen::VectorXd dx = Eigen::VectorXd::Zero(12);
  dx[5] = 0.01;
  dx.segment<3>(6) = Eigen::Vector3d(std::cos(0.01) - 1.0, std::sin(0.01), 0.0);
  add_increment(equations.layout(), dx, state.q);
  EXPECT_GT(equations.saddle().drift(state).position, 1e-6);
  // Near a double root the way back is halved by each step of Newton's: some calls, as in the steps of a run.
  double left = 1.0;
  for (int i = 0; i < 10 && left > 1e-9; ++i) {
    try {
      left = equations.saddle().project(state).position_left;
    } catch (const NumericalError&) {
      left = equations.saddle().drift(state).position;
    }
  }
  EXPECT_LT(left, 1e-9);
}

TEST(Equations, NamesTheJointThatStaysOpen) {
  const Model model = toggle();
  Equations equations(model, assemble(model));
  State state = assemble(model).state;
  state.q.segment<3>(7) += Eigen::Vector3d(0.0, 0.0, 50.0);  // far from any closed position of the rod
  state.q[0] = 40.0;
  EXPECT_THROW(equations.saddle().project(state), NumericalError);
}

TEST(Model, RefusesBodiesThatCannotExist) {
  EXPECT_THROW(Body("b", -1.0, Eigen::Matrix3d::Identity()), InputError);
  EXPECT_THROW(Body("b", std::nan(""), Eigen::Matrix3d::Identity()), InputError);
  EXPECT_THROW(Body("b", 1.0, Eigen::Matrix3d::Zero()), InputError);
  // triangle inequality
  EXPECT_THROW(Body("b", 1.0, Eigen::Vector3d(1.0, 1.0, 3.0).asDiagonal()), InputError);
  Eigen::Matrix3d skewed = Eigen::Matrix3d::Identity();
  skewed(0, 1) = 0.2;
  EXPECT_THROW(Body("b", 1.0, skewed), InputError);
}

TEST(Model, RefusesNamesTwiceAndBodiesUnknown) {
  Model model = pair_with_gap(Eigen::Vector3d::Zero());
  EXPECT_THROW(model.add_body(Body("a", 1.0, Eigen::Matrix3d::Identity()), {}), InputError);
  const Joint joint = spherical_joint("j", at(model, 0, {0.5, 0.0, 0.0}), at(model, 1, {-0.5, 0.0, 0.0}));
  model.add_joint(joint);
  EXPECT_THROW(model.add_joint(joint), InputError);
  EXPECT_THROW(spherical_joint("k", at(model, 0, {0.5, 0.0, 0.0}), at(model, 0, {-0.5, 0.0, 0.0})), InputError);
  EXPECT_THROW(model.body_index("c"), InputError);
}

TEST(Model, FlexibleBodyMustKeepItsMassCentre) {
  // A basis that is not in mean axes would make gravity wrong without a word.
  test::Random random(8);
  std::shared_ptr<ModalBody> modal = test::hand_made_body(random, 4, 2);
  for (int j = 0; j < 4; ++j) modal->Phi(3 * j, 1) += 0.2;
  EXPECT_THROW(Body("b", modal), InputError);
}

// mbd_solver/dynamics/equations.cpp: the analytic Jacobian of the whole system against differences of its residual.

class JacobianOfRandomModel : public ::testing::TestWithParam<unsigned> {};

TEST_P(JacobianOfRandomModel, EqualsDifferencesOfTheResidual) {
  test::Random random(GetParam());
  const Model model = test::everything(random);
  for (const Baumgarte& baumgarte : {Baumgarte{}, Baumgarte{3.0, 4.0}}) {
    Equations equations(model, test::as_given(model), baumgarte);
    const Layout& layout = equations.layout();
    const Inputs inputs = test::random_inputs(random, model);
    Eigen::VectorXd y(layout.size());
    equations.layout().pack(test::as_given(model).state, random.vector_x(layout.row_count, 5.0), y);
    // Quaternions off unit length too: derivatives along L must vanish there as well.
    for (int q : layout.body_q) y.segment<4>(q + 3) *= random.number(0.8, 1.2);
    const Eigen::VectorXd ydot = random.vector_x(layout.size(), 3.0);
    std::string where;
    EXPECT_LT(test::jacobian_error(equations, y, ydot, 7.0, inputs, &where), 2e-9) << where;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, JacobianOfRandomModel, ::testing::Values(1u, 2u, 3u));

TEST(Jacobian, KeepsItsPatternAndItsPlace) {
  test::Random random(4);
  const Model model = test::everything(random);
  Equations equations(model, test::as_given(model));
  Eigen::VectorXd y(equations.layout().size());
  equations.layout().pack(test::as_given(model).state, Eigen::VectorXd::Zero(equations.layout().row_count), y);
  const Inputs inputs = test::random_inputs(random, model);
  const double* values = equations.jacobian().matrix().valuePtr();
  const Eigen::Index entries = equations.jacobian().matrix().nonZeros();
  equations.jacobian().evaluate(0.0, y, Eigen::VectorXd::Zero(y.size()), 10.0, inputs);
  EXPECT_EQ(equations.jacobian().matrix().valuePtr(), values);
  EXPECT_EQ(equations.jacobian().matrix().nonZeros(), entries);
}

TEST(Jacobian, MassTimesVectorIsItsDerivativeByRates) {
  test::Random random(5);
  const Model model = test::everything(random);
  Equations equations(model, test::as_given(model));
  const int n = equations.layout().size();
  const Inputs inputs = test::random_inputs(random, model);
  Eigen::VectorXd y(n), F0(n), F1(n), product(n);
  equations.layout().pack(test::as_given(model).state, random.vector_x(equations.layout().row_count), y);
  Eigen::VectorXd x = random.vector_x(n), ydot = random.vector_x(n);
  x.tail(equations.layout().row_count).setZero();
  equations.residual(0.3, y, ydot, inputs, F0);
  equations.residual(0.3, y, ydot + x, inputs, F1);  // the residual is linear in ydot
  equations.apply_mass(y, x, 0.3, product);
  EXPECT_LT((F1 - F0 - product).norm(), 1e-11 * F1.norm());  // round-off of the difference
}

// LU factors without the entries that hardly matter: dynamics/thin_lu.h.

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Every entry stored, zeros too.
Eigen::SparseMatrix<double> dense_pattern(const MatrixXd& A) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < A.cols(); ++j)
    for (int i = 0; i < A.rows(); ++i) entries.emplace_back(i, j, A(i, j));
  Eigen::SparseMatrix<double> out(static_cast<int>(A.rows()), static_cast<int>(A.cols()));
  out.setFromTriplets(entries.begin(), entries.end());
  out.makeCompressed();
  return out;
}

void set(Eigen::SparseMatrix<double>& matrix, int i, int j, double value) { matrix.coeffRef(i, j) = value; }

// [D, B^T; B, -eps]: n velocities, two rows of conditions.
MatrixXd saddle(int n) {
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> from(-1.0, 1.0);
  MatrixXd A = MatrixXd::Zero(n + 2, n + 2);
  for (int i = 0; i < n; ++i) A(i, i) = 1.0 + i;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 2; ++k) A(i, n + k) = A(n + k, i) = from(draw);
  A(n, n) = A(n + 1, n + 1) = -1e-12;
  return A;
}

constexpr double kNewton = 3e-3;

VectorXd solved(const ThinLu& lu, VectorXd x) {
  lu.solve(x);
  return x;
}

TEST(ThinLu, ZerosOfADenseBlockTakeNoPart) {
  const int n = 8;
  const MatrixXd A = saddle(n);
  const auto matrix = dense_pattern(A);
  const VectorXd own = A.diagonal().head(n), b = VectorXd::LinSpaced(n + 2, 1.0, 2.0);
  ThinLu lu(matrix, VectorXd::Constant(n, ThinLu::kRoundOff));
  ASSERT_TRUE(lu.factor(own));
  EXPECT_EQ(lu.entries(), n + 2 * 2 * n + 4);
  EXPECT_LT((A * solved(lu, b) - b).norm(), 1e-12 * b.norm());
}

TEST(ThinLu, LeavesOutWhatHardlyMattersAndTakesItBackWhenItDoes) {
  const int n = 8;
  MatrixXd A = saddle(n);
  A(2, 5) = A(5, 2) = 1e-3 * std::sqrt(A(2, 2) * A(5, 5));
  auto matrix = dense_pattern(A);
  const VectorXd own = A.diagonal().head(n), b = VectorXd::LinSpaced(n + 2, 1.0, 2.0);
  ThinLu lu(matrix, VectorXd::Constant(n, kNewton));
  ASSERT_TRUE(lu.factor(own));
  const auto few = lu.entries();
  const double off = (A * solved(lu, b) - b).norm() / b.norm();
  EXPECT_GT(off, 1e-5);
  EXPECT_LT(off, 1e-2);

  for (const double share : {5e-3, 2e-2, 1e-3}) {  // below what matters; beyond; and small again
    A(2, 5) = A(5, 2) = share * std::sqrt(A(2, 2) * A(5, 5));
    set(matrix, 2, 5, A(2, 5));
    set(matrix, 5, 2, A(5, 2));
    ASSERT_TRUE(lu.factor(own));
    EXPECT_EQ(lu.entries(), share == 5e-3 ? few : few + 2) << share;
    if (share != 5e-3) {
      EXPECT_LT((A * solved(lu, b) - b).norm(), 1e-12 * b.norm()) << share;
    }
  }
  lu.forget();
  ASSERT_TRUE(lu.factor(own));
  EXPECT_EQ(lu.entries(), few);
}

TEST(ThinLu, RowsWithoutAShareStayWhole) {
  const int n = 8;
  const MatrixXd A = saddle(n);
  const auto matrix = dense_pattern(A);
  VectorXd share = VectorXd::Constant(n, kNewton);
  share.head(3).setZero();
  ThinLu lu(matrix, share);
  ASSERT_TRUE(lu.factor(A.diagonal().head(n)));
  EXPECT_EQ(lu.entries(), 3 * n + (n - 3) + 2 * 2 * n + 4);
}

// A spring of stiffness k between two bodies in a direction that leans a little: k n n^T has entries of 3e-4 k, small against k
// and not against the mass, which alone resists when both move together.
TEST(ThinLu, WhatIsSmallBesideASpringIsNotSmall) {
  const double k = 1e6;
  const Eigen::Vector2d n = Eigen::Vector2d(1.0, 3e-4).normalized();
  const Eigen::Matrix2d spring = k * n * n.transpose();
  MatrixXd A = MatrixXd::Identity(4, 4);
  A.topLeftCorner<2, 2>() += spring;
  A.bottomRightCorner<2, 2>() += spring;
  A.topRightCorner<2, 2>() -= spring;
  A.bottomLeftCorner<2, 2>() -= spring;
  const auto matrix = dense_pattern(A);
  ThinLu lu(matrix, VectorXd::Constant(4, kNewton));
  ASSERT_TRUE(lu.factor(VectorXd::Ones(4)));
  const Eigen::Vector4d b(1.0, 2.0, 1.0, -1.0);
  EXPECT_LT((solved(lu, b) - A.partialPivLu().solve(b)).norm(), 0.1 * b.norm());
}

TEST(ThinLu, SaysWhenItIsSingular) {
  MatrixXd A = MatrixXd::Identity(3, 3);
  A(1, 1) = 0.0;
  const auto matrix = dense_pattern(A);
  ThinLu lu(matrix, VectorXd::Constant(3, kNewton));
  EXPECT_FALSE(lu.factor(VectorXd::Ones(3)));
  auto broken = dense_pattern(MatrixXd::Identity(3, 3));
  set(broken, 0, 2, std::nan(""));
  ThinLu not_finite(broken, VectorXd::Constant(3, kNewton));
  EXPECT_FALSE(not_finite.factor(VectorXd::Ones(3)));
}

}  // namespace
}  // namespace footfall

// Inertia of a body with modes, and the pieces that it and its surface are made of.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/model/column_groups.h"
#include "mbd_solver/model/elements/surface_model.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/modal_inertia.h"
#include "mbd_solver/model/rotation.h"
#include "tests/support/heap_requests.h"

namespace footfall {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSumRoundOff = 1e-13;  // relative; sums of some 100 terms of either sign

Matrix3d skew(const Vector3d& x) {
  Matrix3d m;
  m << 0, -x.z(), x.y(), x.z(), 0, -x.x(), -x.y(), x.x(), 0;
  return m;
}

// Any shapes, not even mean axes or orthonormal: the shape integrals must not rely on either.
ModalBody random_body(int nodes, int modes, unsigned seed) {
  std::srand(seed);
  ModalBody body;
  body.name = "random";
  body.rho0 = Eigen::Matrix3Xd::Random(3, nodes);
  body.node_mass = VectorXd::Random(nodes).cwiseAbs();
  for (int j = 0; j < nodes; ++j) {
    const Matrix3d r = Matrix3d::Random();
    body.node_inertia.push_back(0.1 * r * r.transpose());
  }
  body.Phi = 0.3 * MatrixXd::Random(3 * nodes, modes);
  body.Psi = 0.3 * MatrixXd::Random(3 * nodes, modes);
  body.stiffness = 40.0 * VectorXd::Random(modes).cwiseAbs();
  body.damping = VectorXd::Random(modes).cwiseAbs();
  return body;
}

// Modes that move along one axis and turn about another, as in a straight rod: most sums over two of them are zero.
ModalBody rod_like_body(int nodes, int modes, unsigned seed) {
  ModalBody body = random_body(nodes, modes, seed);
  for (Matrix3d& J : body.node_inertia) J = Matrix3d(J.diagonal().asDiagonal());
  for (int j = 0; j < nodes; ++j)
    for (int k = 0; k < modes; ++k)
      for (int i = 0; i < 3; ++i) {
        if (i != k % 3) body.Phi(3 * j + i, k) = 0.0;
        if (i != (k + 1) % 3) body.Psi(3 * j + i, k) = 0.0;
      }
  return body;
}

struct RandomState {
  VectorXd a, v, dv;
  explicit RandomState(int s) : a(VectorXd::Random(s)), v(VectorXd::Random(6 + s)), dv(VectorXd::Random(6 + s)) {}
};

// Rotary inertia of a node that turned by t, to second order.
Matrix3d turned(const Matrix3d& J, const Vector3d& t) {
  const Matrix3d T = skew(t);
  return J + T * J - J * T + 0.5 * (T * T * J + J * T * T) - T * J * T;
}

// M and h as the theory writes them: sums over nodes of B_j^T (...) with B_j = [I, -rho_j~, Phi_j].
void direct_sums(const ModalBody& body, const VectorXd& a, const VectorXd& v, MatrixXd& M, VectorXd& h) {
  const int s = body.mode_count();
  M.setZero(6 + s, 6 + s);
  h.setZero(6 + s);
  const Vector3d w = v.segment<3>(3);
  for (int j = 0; j < body.node_count(); ++j) {
    const MatrixXd Phi = body.Phi.middleRows(3 * j, 3);
    const Vector3d rho = body.rho0.col(j) + Phi * a;
    const Vector3d u = Phi * v.tail(s);
    MatrixXd B(3, 6 + s);
    B << Matrix3d::Identity(), -skew(rho), Phi;
    M += body.node_mass(j) * B.transpose() * B;
    h += body.node_mass(j) * B.transpose() * (2.0 * w.cross(u) + w.cross(w.cross(rho)));
    // Rotary: 1/2 w . J(t) w + w . (J dt + t x J dt - 1/2 J (t x dt)) + 1/2 dt . J dt, t = Psi a, dt = Psi da.
    const MatrixXd Psi = body.Psi.middleRows(3 * j, 3);
    const Matrix3d& J = body.node_inertia[static_cast<std::size_t>(j)];
    const Vector3d t = Psi * a, dt = Psi * v.tail(s), Jdt = J * dt;
    const Matrix3d J_t = turned(J, t);
    const auto slope = [&](const Vector3d& x) { return Matrix3d(0.5 * (turned(J, t + x) - turned(J, t - x))); };
    const MatrixXd C = (Matrix3d::Identity() + skew(t)) * J * Psi - 0.5 * J * skew(t) * Psi;
    M.block(3, 3, 3, 3) += J_t;
    M.block(3, 6, 3, s) += C;
    M.block(6, 3, s, 3) += C.transpose();
    M.bottomRightCorner(s, s) += Psi.transpose() * J * Psi;
    h.segment<3>(3) += slope(dt) * w + w.cross(J_t * w + C * v.tail(s)) + dt.cross(Jdt);
    for (int k = 0; k < s; ++k) {
      const Vector3d t_k = Psi.col(k);
      h(6 + k) += -0.5 * w.dot(slope(t_k) * w) + w.dot(dt.cross(J * t_k) - t_k.cross(Jdt) - J * dt.cross(t_k));
    }
  }
  h.tail(s) += body.damping.cwiseProduct(v.tail(s)) + body.stiffness.cwiseProduct(a);
}

VectorXd residual(const ModalInertia& inertia, const VectorXd& a, const VectorXd& v, const VectorXd& dv) {
  VectorXd g(v.size());
  ModalInertia::Scratch scratch(inertia.mode_count());
  inertia.inertia_force(a, v, dv, scratch, g);
  return g;
}
// h(a, v)
VectorXd velocity_and_elastic_force(const ModalInertia& inertia, const VectorXd& a, const VectorXd& v) {
  return residual(inertia, a, v, VectorXd::Zero(v.size()));
}

TEST(ModalInertia, EqualsTheSumsOverNodesAtRandomStates) {
  for (int s : {0, 1, 2, 7, -7, -30}) {
    const bool rod = s < 0;
    s = std::abs(s);
    const ModalBody body = (rod ? rod_like_body : random_body)(12, s, 7u + static_cast<unsigned>(s));
    const ModalInertia inertia(body);
    for (int i = 0; i < 20; ++i) {
      const RandomState x(s);
      MatrixXd M(6 + s, 6 + s), M_direct;
      VectorXd h_direct;
      inertia.mass_matrix(x.a, M);
      const VectorXd h = velocity_and_elastic_force(inertia, x.a, x.v);
      direct_sums(body, x.a, x.v, M_direct, h_direct);
      EXPECT_LT((M - M_direct).norm(), kSumRoundOff * M_direct.norm());
      ModalInertia::Scratch scratch(s);
      VectorXd product(6 + s);
      inertia.mass_product(x.a, x.v, scratch, product);
      EXPECT_LT((product - M_direct * x.v).norm(), kSumRoundOff * M_direct.norm() * x.v.norm());
      EXPECT_LT((h - h_direct).norm(), kSumRoundOff * h_direct.norm() + kSumRoundOff);
      EXPECT_EQ((M - M.transpose()).norm(), 0.0);
      EXPECT_EQ(M.llt().info(), Eigen::Success);
      EXPECT_NEAR(inertia.kinetic_energy(x.a, x.v), 0.5 * x.v.dot(M_direct * x.v), kSumRoundOff * M_direct.norm());
      const Vector3d c = M_direct.block<3, 3>(3, 0)(2, 1) * Vector3d::UnitX() +
                         M_direct.block<3, 3>(3, 0)(0, 2) * Vector3d::UnitY() +
                         M_direct.block<3, 3>(3, 0)(1, 0) * Vector3d::UnitZ();
      EXPECT_LT((inertia.centre_of_mass(x.a) * inertia.mass() - c).norm(), kSumRoundOff * M_direct.norm());
    }
  }
}

// 6N x 6N of lumped masses and inertias.
Eigen::SparseMatrix<double> mass_matrix_of(const ModalBody& body) {
  MatrixXd M = MatrixXd::Zero(6 * body.node_count(), 6 * body.node_count());
  for (int j = 0; j < body.node_count(); ++j) {
    M.block<3, 3>(6 * j, 6 * j) = body.node_mass(j) * Matrix3d::Identity();
    M.block<3, 3>(6 * j + 3, 6 * j + 3) = body.node_inertia[static_cast<std::size_t>(j)];
  }
  return M.sparseView();
}

TEST(ModalInertia, OfAMassMatrixIsThatOfTheLumpedMassesInIt) {
  for (const int s : {0, 1, 7}) {
    const ModalBody lumped = random_body(9, s, 40u + static_cast<unsigned>(s));
    ModalBody matrix = lumped;
    matrix.mass = mass_matrix_of(lumped);
    matrix.node_mass.setConstant(1.0);  // not used
    const ModalInertia a(lumped), b(matrix);
    EXPECT_NEAR(a.mass(), b.mass(), kSumRoundOff * a.mass());
    for (int i = 0; i < 5; ++i) {
      const RandomState x(s);
      MatrixXd Ma(6 + s, 6 + s), Mb(6 + s, 6 + s);
      a.mass_matrix(x.a, Ma);
      b.mass_matrix(x.a, Mb);
      EXPECT_LT((Ma - Mb).norm(), kSumRoundOff * Ma.norm());
      const VectorXd ga = residual(a, x.a, x.v, x.dv), gb = residual(b, x.a, x.v, x.dv);
      EXPECT_LT((ga - gb).norm(), kSumRoundOff * ga.norm());
    }
  }
}

// Masses that couple nodes, as solid elements do, m_ij 1: T = 1/2 sum_ij m_ij u_i . u_j, u_j = dr + w x rho_j + Phi_j da.
TEST(ModalInertia, OfCoupledMassesHasTheirKineticEnergyInEveryDeflection) {
  const int s = 5, n = 7;
  ModalBody body = random_body(n, s, 51);
  body.Psi.setZero();
  MatrixXd m = MatrixXd::Random(n, n);
  m = (m * m.transpose()).eval();
  MatrixXd M = MatrixXd::Zero(6 * n, 6 * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) M.block<3, 3>(6 * i, 6 * j) = m(i, j) * Matrix3d::Identity();
  body.mass = M.sparseView();
  const ModalInertia inertia(body);
  for (int sample = 0; sample < 10; ++sample) {
    const RandomState x(s);
    Eigen::Matrix3Xd u(3, n);
    for (int j = 0; j < n; ++j) {
      const auto Phi = body.Phi.middleRows(3 * j, 3);
      u.col(j) =
          x.v.head<3>() + Vector3d(x.v.segment<3>(3)).cross(Vector3d(body.rho0.col(j) + Phi * x.a)) + Phi * x.v.tail(s);
    }
    const double exact = 0.5 * (u.transpose() * u).cwiseProduct(m).sum();
    EXPECT_NEAR(inertia.kinetic_energy(x.a, x.v), exact, kSumRoundOff * 100.0 * exact);
  }
}

// Kinetic energy of nodes that turn by the rotation vector t = Psi a, in full, less the energy by the shape integrals: third
// order in a at given v.
TEST(ModalInertia, RotaryInertiaTurnsWithItsNodeToSecondOrder) {
  const int s = 4;
  ModalBody body = random_body(6, s, 17);
  const ModalInertia inertia(body);
  const RandomState x(s);
  const Vector3d dr = x.v.head<3>(), w = x.v.segment<3>(3);
  const auto error = [&](double size) {
    const VectorXd a = size * x.a, da = size * x.v.tail(s);  // rates are small as the deflections are
    double exact = 0.0;
    for (int j = 0; j < body.node_count(); ++j) {
      const MatrixXd Phi = body.Phi.middleRows(3 * j, 3), Psi = body.Psi.middleRows(3 * j, 3);
      exact += 0.5 * body.node_mass(j) * (dr + w.cross(Vector3d(body.rho0.col(j) + Phi * a)) + Phi * da).squaredNorm();
      const auto attitude = [&](double dt) {
        const Vector3d t = Psi * (a + dt * da);
        return Eigen::AngleAxisd(t.norm(), t.normalized()).toRotationMatrix();
      };
      const double step = 1e-4;  // of time, central: error 1e-8, times size
      const Matrix3d R = attitude(0.0), spin = (attitude(step) - attitude(-step)) / (2.0 * step) * R.transpose();
      const Vector3d own = R.transpose() * (w + Vector3d(spin(2, 1), spin(0, 2), spin(1, 0)));
      exact += 0.5 * own.dot(body.node_inertia[static_cast<std::size_t>(j)] * own);
    }
    VectorXd v = x.v;
    v.tail(s) = da;
    return std::abs(inertia.kinetic_energy(a, v) - exact);
  };
  const double order = std::log2(error(0.1) / error(0.05));
  EXPECT_NEAR(order, 3.0, 0.2);  // and terms of fourth order
}

// Power balance: v . (M dv + h) = dT/dt + d(strain)/dt + damping power. Components of dr in B turn with B, so
// the rate of those components is ddr - w x dr.
TEST(ModalInertia, PowerOfTheResidualIsTheRateOfEnergy) {
  const int s = 6;
  const ModalInertia inertia(random_body(12, s, 3));
  const double step = 1e-5;  // central difference: error step^2, round-off 1e-16 / step
  const double tolerance = 1e-8;
  for (int i = 0; i < 20; ++i) {
    const RandomState x(s);
    VectorXd rate = x.dv;
    rate.head<3>() -= Vector3d(x.v.segment<3>(3)).cross(Vector3d(x.v.head<3>()));
    const VectorXd da = x.v.tail(s);
    const auto energy = [&](double t) {
      return inertia.kinetic_energy(x.a + t * da, x.v + t * rate) + inertia.strain_energy(x.a + t * da);
    };
    const double rate_of_energy = (energy(step) - energy(-step)) / (2.0 * step);
    EXPECT_NEAR(x.v.dot(residual(inertia, x.a, x.v, x.dv)), rate_of_energy + inertia.damping_power(da),
                tolerance * 100.0);
  }
}

// With elastic forces taken away, the force and moment rows are the rates of momentum and of angular momentum
// about Bo.
TEST(ModalInertia, FirstSixRowsAreTheRatesOfMomentum) {
  const int s = 5;
  const ModalInertia inertia(random_body(10, s, 11));
  const double step = 1e-5, tolerance = 1e-8;
  for (int i = 0; i < 20; ++i) {
    const RandomState x(s);
    const Vector3d w = x.v.segment<3>(3), dr = x.v.head<3>();
    VectorXd rate = x.dv;
    rate.head<3>() -= w.cross(dr);
    const auto momentum = [&](double t) {
      MatrixXd M(6 + s, 6 + s);
      inertia.mass_matrix(x.a + t * x.v.tail(s), M);
      return VectorXd(M * (x.v + t * rate));
    };
    const VectorXd p = momentum(0.0);
    const VectorXd dp = (momentum(step) - momentum(-step)) / (2.0 * step);
    const Vector3d force = dp.head<3>() + w.cross(Vector3d(p.head<3>()));
    const Vector3d moment = dp.segment<3>(3) + w.cross(Vector3d(p.segment<3>(3))) + dr.cross(Vector3d(p.head<3>()));
    const VectorXd g = residual(inertia, x.a, x.v, x.dv);
    EXPECT_LT((g.head<3>() - force).norm(), tolerance * 100.0);
    EXPECT_LT((g.segment<3>(3) - moment).norm(), tolerance * 100.0);
  }
}

TEST(ModalInertia, DerivativesAgreeWithCentralDifferences) {
  for (int s : {0, 1, 6}) {
    const ModalInertia inertia(random_body(12, s, 21u + static_cast<unsigned>(s)));
    // g is a quadratic in a and in v, so central differences are exact but for round-off 1e-16 / step.
    const double step = 1e-3, tolerance = 1e-11;
    for (int i = 0; i < 10; ++i) {
      const RandomState x(s);
      MatrixXd dg_da(6 + s, s), dg_dv(6 + s, 6 + s);
      inertia.derivatives(x.a, x.v, x.dv, dg_da, dg_dv);
      for (int k = 0; k < s; ++k) {
        const VectorXd d = step * VectorXd::Unit(s, k);
        const VectorXd difference =
            (residual(inertia, x.a + d, x.v, x.dv) - residual(inertia, x.a - d, x.v, x.dv)) / (2.0 * step);
        EXPECT_LT((difference - dg_da.col(k)).norm(), tolerance * (1.0 + difference.norm()));
      }
      for (int k = 0; k < 6 + s; ++k) {
        const VectorXd d = step * VectorXd::Unit(6 + s, k);
        const VectorXd difference =
            (residual(inertia, x.a, x.v + d, x.dv) - residual(inertia, x.a, x.v - d, x.dv)) / (2.0 * step);
        EXPECT_LT((difference - dg_dv.col(k)).norm(), tolerance * (1.0 + difference.norm()));
      }
    }
  }
}

TEST(ModalInertia, ForceAtOnceIsMassTimesAccelerationAndTheRest) {
  for (int s : {1, 4, 9, 40, -9, -40}) {
    const bool rod = s < 0;
    s = std::abs(s);
    const ModalInertia inertia((rod ? rod_like_body : random_body)(7, s, 31u + static_cast<unsigned>(s)));
    const RandomState at(s);
    MatrixXd M(6 + s, 6 + s);
    inertia.mass_matrix(at.a, M);
    VectorXd h = velocity_and_elastic_force(inertia, at.a, at.v);
    const double size = (M.cwiseAbs() * at.dv.cwiseAbs() + h.cwiseAbs()).maxCoeff();
    h.noalias() += M * at.dv;
    const VectorXd g = residual(inertia, at.a, at.v, at.dv);
    EXPECT_LT((g - h).lpNorm<Eigen::Infinity>(), 1e-14 * s * size) << s;
  }
}

TEST(ModalInertia, WithoutModesIsTheRigidBody) {
  ModalBody body = random_body(8, 0, 5);
  const Vector3d com = body.rho0 * body.node_mass / body.node_mass.sum();
  body.rho0.colwise() -= com;
  Matrix3d J = Matrix3d::Zero();
  for (int j = 0; j < body.node_count(); ++j)
    J += body.node_inertia[static_cast<std::size_t>(j)] -
         body.node_mass(j) * skew(body.rho0.col(j)) * skew(body.rho0.col(j));
  const ModalInertia flexible(body), rigid(body.node_mass.sum(), J);
  ASSERT_EQ(rigid.mode_count(), 0);
  const RandomState x(0);
  const Vector3d w = x.v.segment<3>(3);
  const VectorXd g = residual(rigid, x.a, x.v, x.dv);
  VectorXd euler(6);
  euler << body.node_mass.sum() * x.dv.head<3>(), J * x.dv.tail<3>() + w.cross(J * w);
  EXPECT_LT((g - euler).norm(), kSumRoundOff);
  EXPECT_LT((residual(flexible, x.a, x.v, x.dv) - euler).norm(), kSumRoundOff * 10.0);
}

TEST(ModalInertia, EvaluatesWithoutTheHeap) {
  SKIP_WHERE_MEMORY_IS_NOT_COUNTED();
  const int s = 30;
  const ModalInertia inertia(rod_like_body(12, s, 2));
  const RandomState x(s);
  MatrixXd M(6 + s, 6 + s), dg_da(6 + s, s), dg_dv(6 + s, 6 + s);
  VectorXd g(6 + s);
  ModalInertia::Scratch scratch(s);
  const VectorXd da = x.v.tail(s);
  const long at_start = test::heap_requests;
  inertia.mass_matrix(x.a, M);
  inertia.inertia_force(x.a, x.v, x.dv, scratch, g);
  inertia.derivatives(x.a, x.v, x.dv, dg_da, dg_dv);
  const double energy = inertia.kinetic_energy(x.a, x.v) + inertia.strain_energy(x.a) + inertia.damping_power(da);
  const Vector3d c = inertia.centre_of_mass(x.a);
  const long at_end = test::heap_requests;
  EXPECT_EQ(at_end, at_start);
  EXPECT_GT(energy, 0.0);
  EXPECT_TRUE(c.allFinite());
  const VectorXd allocated = VectorXd::Zero(10000);
  EXPECT_GT(test::heap_requests, at_end) << "the counter itself must count";
  EXPECT_EQ(allocated.sum(), 0.0);
}

TEST(ModalInertia, RefusesABodyWithoutInertia) {
  EXPECT_THROW(ModalInertia(0.0, Matrix3d::Identity()), InputError);
  EXPECT_THROW(ModalInertia(1.0, Matrix3d(Vector3d(1.0, 1.0, 0.0).asDiagonal())), InputError);
  ModalBody body = random_body(4, 1, 1);
  body.node_mass.setZero();
  EXPECT_THROW(ModalInertia{body}, InputError);
}

VectorXd product(const ColumnGroups& A, const VectorXd& x, Eigen::Index rows) {
  VectorXd y = VectorXd::Zero(rows), scratch(rows + x.size());
  A.add_product(x, y, scratch);
  return y;
}

// Columns of three kinds by turns, each with its own third of the rows.
MatrixXd three_kinds(int rows, int columns) {
  MatrixXd A = MatrixXd::Zero(rows, columns);
  for (int l = 0; l < columns; ++l)
    for (int r = l % 3; r < rows; r += 3) A(r, l) = 1.0 + 0.01 * r + 0.1 * l;
  return A;
}

TEST(ColumnGroups, GiveTheProductOfTheWholeMatrix) {
  for (const int columns : {0, 1, 2, 7, 30}) {
    const int rows = 9 * columns;
    MatrixXd some = MatrixXd::Random(rows, columns);
    some = (some.array().abs() < 0.8).select(0.0, some);
    for (const MatrixXd& A : {MatrixXd(MatrixXd::Random(rows, columns)), three_kinds(rows, columns), some,
                              MatrixXd(MatrixXd::Zero(rows, columns))}) {
      const VectorXd x = VectorXd::Random(columns), wanted = A * x;
      EXPECT_LT((product(ColumnGroups(A), x, rows) - wanted).norm(), 1e-14 * (1.0 + A.norm())) << columns;
    }
  }
}

TEST(ColumnGroups, KeepNoZeros) {
  EXPECT_EQ(ColumnGroups(three_kinds(90, 30)).entries(), 30 * 30);
  EXPECT_EQ(ColumnGroups(MatrixXd(MatrixXd::Zero(90, 30))).entries(), 0);
  EXPECT_EQ(ColumnGroups(MatrixXd(MatrixXd::Ones(90, 30))).entries(), 90 * 30);
  const MatrixXd round_off = three_kinds(90, 30) + 1e-16 * MatrixXd::Random(90, 30);
  EXPECT_EQ(ColumnGroups(round_off).entries(), 30 * 30);
}

TEST(ColumnGroups, KeepSmallMatricesWhole) {
  EXPECT_EQ(ColumnGroups(three_kinds(9, 3)).entries(), 9 * 3) << "a product more costs more than a few zeros";
}

constexpr double kAxesRoundOff = 1e-13;

Matrix3d turn(double angle, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}
Matrix3d turned(const Vector3d& moments, const Matrix3d& R) { return R * moments.asDiagonal() * R.transpose(); }

void expect_principal(const Matrix3d& inertia, const Matrix3d& axes) {
  EXPECT_LT((axes.transpose() * axes - Matrix3d::Identity()).norm(), kAxesRoundOff);
  EXPECT_NEAR(axes.determinant(), 1.0, kAxesRoundOff) << "right-handed";
  Matrix3d rest = axes.transpose() * inertia * axes;
  rest.diagonal().setZero();
  EXPECT_LT(rest.norm(), kAxesRoundOff * inertia.norm());
}

TEST(PrincipalAxes, MakeTheInertiaDiagonalAndLieNearestToTheFrame) {
  for (const Vector3d& axis : {Vector3d(1, 2, 3), Vector3d(-1, 0.2, 0.1), Vector3d(0, 0, 1), Vector3d(3, -2, 0.5)})
    for (double angle : {0.01, 0.3, -0.6, 2.0, 3.1}) {
      const Matrix3d inertia = turned({1.0, 2.5, 3.0}, turn(angle, axis)), axes = principal_axes(inertia);
      expect_principal(inertia, axes);
      EXPECT_NEAR(axes.diagonal().maxCoeff(), axes.cwiseAbs().maxCoeff(), kAxesRoundOff)
          << "the nearest column, same side";
      if (std::abs(angle) < 0.61) {
        EXPECT_LT((axes - turn(angle, axis)).norm(), 1e-10) << "the nearest of 24";
      }
    }
}

TEST(PrincipalAxes, OfARodTurnTheFrameOnTheShortestWay) {
  for (const Vector3d& along : {Vector3d(0.6, 0.48, 0.64), Vector3d(0.1, 0.2, -1), Vector3d(-3, 1, 1)}) {
    const Vector3d e = along.normalized();
    const Matrix3d inertia = 2.0 * Matrix3d::Identity() - 1.9 * e * e.transpose(), axes = principal_axes(inertia);
    expect_principal(inertia, axes);
    Eigen::Index nearest = 0;
    e.cwiseAbs().maxCoeff(&nearest);
    EXPECT_LT(axes.col(nearest).cross(e).norm(), 1e-12);
    const Eigen::AngleAxisd way(axes);
    EXPECT_NEAR(way.axis().dot(e), 0.0, 1e-12) << "no turn about the rod";
    EXPECT_LT(way.angle(), 1.0);
  }
}

TEST(PrincipalAxes, OfWhatLiesAlongTheFrameAreTheFrameToTheBit) {
  for (const Vector3d& moments : {Vector3d(1, 1, 1), Vector3d(1, 2, 3), Vector3d(3, 1, 2), Vector3d(0.01, 2, 2),
                                  Vector3d(2, 0.01, 2), Vector3d(2, 2, 3), Vector3d(1, 1 + 1e-9, 1)}) {
    const Matrix3d inertia = moments.asDiagonal();
    EXPECT_TRUE(principal_axes(inertia) == Matrix3d::Identity()) << moments.transpose();
    Matrix3d nearly = inertia;
    nearly(0, 1) = nearly(1, 0) = 1e-16;
    EXPECT_TRUE(principal_axes(nearly) == Matrix3d::Identity()) << moments.transpose();
  }
}

// Distances of surfaces: boxes, lines and balls whose distance is known.

constexpr double kSurfaceRoundOff = 1e-12;

// The unit cube about the origin.
SurfaceModel cube() {
  Eigen::Matrix3Xd v(3, 8);
  for (int i = 0; i < 8; ++i) v.col(i) << (i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5;
  return SurfaceModel(v, {{0, 2, 3},
                          {0, 3, 1},
                          {4, 5, 7},
                          {4, 7, 6},
                          {0, 1, 5},
                          {0, 5, 4},
                          {2, 6, 7},
                          {2, 7, 3},
                          {0, 4, 6},
                          {0, 6, 2},
                          {1, 3, 7},
                          {1, 7, 5}});
}

SurfaceModel line(double radius) {
  Eigen::Matrix3Xd v(3, 2);
  v << -1.0, 1.0, 0.0, 0.0, 0.0, 0.0;
  return SurfaceModel(v, {{0, 0, 1}}, radius);
}

TEST(SurfaceModel, DistanceOfTwoCubesIsThatOfFaceEdgeAndCorner) {
  SurfaceModel a = cube(), b = cube();
  EXPECT_NEAR(gap_between(a, b, {Eigen::Matrix3d::Identity(), {1.3, 0.2, 0.1}}).distance, 0.3, kSurfaceRoundOff);
  EXPECT_NEAR(gap_between(a, b, {Eigen::Matrix3d::Identity(), {1.3, 1.4, 0.1}}).distance, 0.5, kSurfaceRoundOff);
  EXPECT_NEAR(gap_between(a, b, {Eigen::Matrix3d::Identity(), {1.2, 1.2, 1.1}}).distance, 0.3, kSurfaceRoundOff);
  const double half = 0.5 * std::sqrt(2.0);  // turned about z by 45 degrees its edge comes first
  const FramePose turned{rotation_matrix(quaternion_about(Eigen::Vector3d::UnitZ(), std::atan(1.0))), {2.0, 0.0, 0.3}};
  const SurfaceGap gap = gap_between(a, b, turned);
  EXPECT_NEAR(gap.distance, 1.5 - half, kSurfaceRoundOff);
  EXPECT_NEAR(gap.place.x(), 0.5 * (0.5 + 2.0 - half), kSurfaceRoundOff);
}

TEST(SurfaceModel, SurfacesThatCrossHaveNoDistanceAndAPlaceInBoth) {
  SurfaceModel a = cube(), b = cube();
  const SurfaceGap gap = gap_between(a, b, {Eigen::Matrix3d::Identity(), {0.9, 0.8, 0.7}});
  EXPECT_LE(gap.distance, 0.0);
  EXPECT_LT((gap.place - Eigen::Vector3d(0.45, 0.4, 0.35)).cwiseAbs().maxCoeff(), 0.2);
  // One within the other does not cross it.
  Eigen::Matrix3Xd small(3, 3);
  small << 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0;
  SurfaceModel within(small, {{0, 1, 2}});
  EXPECT_NEAR(gap_between(a, within, {}).distance, 0.4, kSurfaceRoundOff);
}

TEST(SurfaceModel, ABeamIsAsThickAsItIs) {
  SurfaceModel a = line(0.1), b = line(0.05), c = cube();
  const Eigen::Matrix3d across = rotation_matrix(quaternion_about(Eigen::Vector3d::UnitZ(), 2.0 * std::atan(1.0)));
  EXPECT_NEAR(gap_between(a, b, {across, {0.3, 0.4, 0.5}}).distance, 0.35, 1e-6);  // a line is a sliver
  EXPECT_LE(gap_between(a, b, {across, {0.3, 0.4, 0.14}}).distance, 0.0);
  EXPECT_NEAR(gap_between(c, a, {across, {0.9, 0.2, 0.0}}).distance, 0.3, 1e-6);
}

TEST(SurfaceModel, MovedVerticesAreWhereTheyWereMoved) {
  SurfaceModel a = cube();
  SurfaceModel b = line(0.1);
  Eigen::Matrix3Xd v(3, 2);
  v << -1.0, 1.0, 0.0, 0.0, 1.5, 1.5;
  b.move(v);
  EXPECT_NEAR(gap_between(a, b, {}).distance, 0.9, 1e-6);
}

}  // namespace
}  // namespace footfall

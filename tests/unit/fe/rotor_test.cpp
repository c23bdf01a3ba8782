// mbd_solver/fe/modal_basis.h and mbd_solver/model/modal_inertia.h together: shafts with discs that spin. Whirl
// frequencies from the shape integrals of the reduced body, in its own frame, against those of the finite-element model
// with its gyroscopic matrix, in the frame that rests.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>

#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/model/modal_inertia.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kLength = 0.6, kDiameter = 0.02;  // [m]
constexpr double kMass = 8.0;                      // of the disc [kg]
constexpr double kPolar = 0.09, kAcross = 0.047;   // its inertias [kg m2]: a plain disc of r = 0.15 m
constexpr int kElements = 4, kEnd = kElements;     // nodes 0 and kEnd are in the bearings

// Shaft along x with a disc at a node. density: of the shaft; a light one makes the closed form of a disc alone exact.
FeModel rotor(int disc, double density) {
  FeModel model =
      straight_beam({0, 0, 0}, {kLength, 0, 0}, kElements, rod_section(kDiameter), Material{density, 207e9, 0.3});
  model.node_mass(disc) += kMass;
  model.node_inertia[static_cast<std::size_t>(disc)] += Vector3d(kPolar, kAcross, kAcross).asDiagonal();
  return model;
}

// Positive frequencies [rad/s] of M q'' + D q' + K q = 0, ascending.
VectorXd frequencies_of(const MatrixXd& M, const MatrixXd& D, const MatrixXd& K) {
  const Index n = M.rows();
  MatrixXd A = MatrixXd::Zero(2 * n, 2 * n);
  const MatrixXd stiff = M.ldlt().solve(K);
  const double scale = std::sqrt(stiff.norm());  // [q; q' / scale]: blocks of one size keep the low frequencies exact
  A.topRightCorner(n, n) = scale * MatrixXd::Identity(n, n);
  A.bottomRows(n) << -stiff / scale, -M.ldlt().solve(D);
  const Eigen::EigenSolver<MatrixXd> eigen(A, false);
  std::vector<double> omega;
  for (const std::complex<double>& lambda : eigen.eigenvalues())
    if (lambda.imag() > 0.0) omega.push_back(lambda.imag());
  std::sort(omega.begin(), omega.end());
  return Eigen::Map<VectorXd>(omega.data(), static_cast<Index>(omega.size()));
}

// y with A y = 0.
MatrixXd null_space(const MatrixXd& A) {
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeFullV);
  const Index rank = (svd.singularValues().array() > 1e-9 * svd.singularValues()(0)).count();
  return svd.matrixV().rightCols(A.cols() - rank);
}

// What the bearings hold: y and z of both ends, x and the turning about x of the first.
const std::vector<std::pair<int, int>> kHeld = {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {kEnd, 1}, {kEnd, 2}};

// In the frame that turns with the rotor at W. Small motions: Bo at p, the body turned by f, modes a, all in that frame:
// w = W + f' + W x f, ddr = p'' + 2 W x p' + W x W x p, dw = f'' + W x f'.
VectorXd whirl_in_the_body(const ModalBody& body, double speed) {
  const int s = body.mode_count(), n = 6 + s;
  const ModalInertia inertia(body);
  const VectorXd a = VectorXd::Zero(s);
  VectorXd v = VectorXd::Zero(n);
  v(3) = speed;
  MatrixXd M(n, n), g_a(n, s), g_v(n, n);
  inertia.mass_matrix(a, M);
  inertia.derivatives(a, v, VectorXd::Zero(n), g_a, g_v);
  Matrix3d W = Matrix3d::Zero();
  W(1, 2) = -speed;
  W(2, 1) = speed;
  MatrixXd v_rate = MatrixXd::Identity(n, n), v_place = MatrixXd::Zero(n, n), dv_rate = v_place, dv_place = v_place;
  v_place.block<3, 3>(3, 3) = W;
  dv_rate.block<3, 3>(0, 0) = 2.0 * W;
  dv_rate.block<3, 3>(3, 3) = W;
  dv_place.block<3, 3>(0, 0) = W * W;
  MatrixXd D = M * dv_rate + g_v * v_rate, K = M * dv_place + g_v * v_place;
  K.rightCols(s) += g_a;
  MatrixXd held(kHeld.size(), n);
  for (std::size_t i = 0; i < kHeld.size(); ++i) {
    const auto [node, component] = kHeld[i];
    MatrixXd motion(6, n);
    const Vector3d rho = body.rho0.col(node);
    Matrix3d arm;
    arm << 0, -rho.z(), rho.y(), rho.z(), 0, -rho.x(), -rho.y(), rho.x(), 0;
    motion << Matrix3d::Identity(), -arm, body.Phi.middleRows(3 * node, 3), Matrix3d::Zero(), Matrix3d::Identity(),
        body.Psi.middleRows(3 * node, 3);
    held.row(static_cast<Index>(i)) = motion.row(component);
  }
  const MatrixXd N = null_space(held);
  return frequencies_of(N.transpose() * M * N, N.transpose() * D * N, N.transpose() * K * N);
}

// In the frame that rests: M q'' + W G q' + K q = 0, where a node with the polar inertia J_p has the moments
// [0, J_p; -J_p, 0] W on its tilts about y and z.
VectorXd whirl_of_the_model(const FeModel& model, double speed) {
  const Index n = 6 * model.node_count();
  MatrixXd M = lumped_mass_matrix(model), K = model.stiffness, G = MatrixXd::Zero(n, n);
  for (int j = 0; j < model.node_count(); ++j) {
    const double polar = model.node_inertia[static_cast<std::size_t>(j)](0, 0);
    G(6 * j + 4, 6 * j + 5) = speed * polar;
    G(6 * j + 5, 6 * j + 4) = -speed * polar;
  }
  MatrixXd held = MatrixXd::Zero(static_cast<Index>(kHeld.size()), n);
  for (std::size_t i = 0; i < kHeld.size(); ++i)
    held(static_cast<Index>(i), 6 * kHeld[i].first + kHeld[i].second) = 1.0;
  const MatrixXd N = null_space(held);
  return frequencies_of(N.transpose() * M * N, N.transpose() * G * N, N.transpose() * K * N);
}

// The nearest of the frequencies seen from the frame that turns: a whirl at +f (forward) or -f (backward) has |f - W|,
// |f + W| there; stretch and torsion keep theirs.
double nearest(const VectorXd& turning, double f, double speed) {
  double best = 1e300;
  for (const double shown : {std::abs(f - speed), f + speed, f})
    best = std::min(best, (turning.array() - shown).abs().minCoeff());
  return best;
}

ModalBody reduced_with_all_modes(const FeModel& model) {
  BasisOptions options;
  options.kind = BasisKind::kFreeFree;
  options.mode_count = 6 * model.node_count() - 6;
  options.damping_ratio = {0.0};
  return reduce(model, options, "rotor").body;
}

TEST(FlexibleRotor, WhirlsAsTheModelWithItsGyroscopicMatrix) {
  const FeModel model = rotor(1, 7850.0);  // between a bearing and the middle: the disc tilts
  const ModalBody body = reduced_with_all_modes(model);
  const double round_off = 1e-5;  // of the frequency: stiffness of short elements, eigenvalues not symmetric
  for (const double speed : {0.0, 100.0, 400.0, 1200.0}) {
    const VectorXd exact = whirl_of_the_model(model, speed), found = whirl_in_the_body(body, speed);
    ASSERT_EQ(exact.size(), found.size());
    for (Index k = 0; k < 8; ++k)
      EXPECT_LT(nearest(found, exact(k), speed), round_off * (exact(k) + speed)) << speed << " rad/s, " << exact(k);
  }
}

// A disc in the middle of a light shaft, Jeffcott's rotor: k = 48 EI / L^3 whatever the speed. It tilts against
// 12 EI / L: J_d f^2 - J_p W f - k_t = 0, forward and backward.
TEST(FlexibleRotor, TiltsForwardAndBackwardAsJeffcottsRotorWithADisc) {
  const ModalBody body = reduced_with_all_modes(rotor(kElements / 2, 7.85));
  const double EI = 207e9 * 3.14159265358979 * std::pow(kDiameter, 4) / 64.0;
  const double lateral = std::sqrt(48.0 * EI / std::pow(kLength, 3) / kMass), k_t = 12.0 * EI / kLength;
  const double light = 2e-4;  // mass of the shaft over that of the disc, and round-off
  for (const double speed : {0.0, 150.0, 600.0}) {
    const VectorXd found = whirl_in_the_body(body, speed);
    const double half = 0.5 * kPolar * speed / kAcross, root = std::sqrt(half * half + k_t / kAcross);
    std::printf("  %5.0f rad/s: lateral %.2f, forward %.2f, backward %.2f rad/s\n", speed, lateral, root + half,
                root - half);
    const auto seen = [&](double f) { return (found.array() - std::abs(f)).abs().minCoeff(); };
    for (const double f : {lateral - speed, -lateral - speed, root + half - speed, half - root - speed})
      EXPECT_LT(seen(f), light * (std::abs(f) + speed)) << speed << " rad/s: " << f;
  }
}

}  // namespace
}  // namespace footfall

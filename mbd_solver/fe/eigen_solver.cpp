// Both methods solve M x = mu (K + shift M) x, whose matrix on the right is positive definite even if M is not.

#include "mbd_solver/fe/eigen_solver.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr Index kDenseSize = 300;  // above, subspace iteration is faster
constexpr int kMaxIterations = 300;
constexpr double kConverged = 1e-11;  // largest relative change of a lambda + shift in one iteration
constexpr double kRoundOff = 1e-5;    // slender bodies: below this, kStalled iterations without progress suffice
constexpr int kStalled = 6;
constexpr std::size_t kDenseBlock = 200;  // rows of a mass matrix; the rank of larger blocks follows from sparse pivots
constexpr double kRank = 1e-12;           // singular below this fraction of a block's largest eigenvalue
constexpr double kMassless = 1e-14;       // no mass in a direction with mu below this fraction of the largest

// With A = K + shift M the problem is M x = mu A x, mu = 1 / (lambda + shift) >= 0; the lowest modes have the largest mu.
struct Reduced {
  VectorXd mu;  // descending
  MatrixXd y;   // y^T A y = 1
};

Reduced solve_reduced(const MatrixXd& M, const MatrixXd& A) {
  const VectorXd scale = A.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd scaled_A = scale.asDiagonal() * A * scale.asDiagonal();
  const Eigen::LLT<MatrixXd> cholesky(scaled_A);
  if (cholesky.info() != Eigen::Success || !scale.allFinite())
    throw InputError(code::kStiffness,
                     "stiffness is not positive definite: the strain energy of some motion is not positive.");
  MatrixXd C = scale.asDiagonal() * M * scale.asDiagonal();
  cholesky.matrixL().solveInPlace(C);
  C = cholesky.matrixL().solve(C.transpose()).eval();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(0.5 * (C + C.transpose()));
  Reduced result;
  result.mu = eigen.eigenvalues().reverse();
  result.y = scale.asDiagonal() * cholesky.matrixU().solve(eigen.eigenvectors().rowwise().reverse());
  return result;
}

Modes modes_from(const VectorXd& mu, const MatrixXd& x, double shift) {
  Modes modes;
  modes.lambda = mu.cwiseInverse().array() - shift;
  modes.shapes = x * mu.cwiseSqrt().cwiseInverse().asDiagonal();  // x^T A x = 1 means x^T M x = mu
  return modes;
}

[[noreturn]] void refuse_massless(int count) {
  throw InputError(code::kTooManyModes,
                   "mass matrix is not positive: fewer than " + std::to_string(count) +
                       " independent motions have mass. Request fewer modes, or give every node a mass.");
}

Modes dense_modes(const Sparse& K, const Sparse& M, int count, double shift) {
  const Reduced reduced = solve_reduced(MatrixXd(M), MatrixXd(K) + shift * MatrixXd(M));
  return modes_from(reduced.mu.head(count), reduced.y.leftCols(count), shift);
}

// Bathe's subspace iteration: X <- A^-1 M X, then the eigenproblem within X.
Modes subspace_modes(const Sparse& K, const Sparse& M, int count, double shift) {
  const Sparse A = K + shift * M;
  const Eigen::SimplicialLDLT<Sparse> factor(A);
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0.0))
    throw InputError(code::kStiffness,
                     "stiffness is not positive definite: the strain energy of some motion is not positive.");
  const Index n = A.rows();
  const Index width = std::min<Index>(mass_rank(M), std::max<Index>(2 * count, count + 8));
  std::mt19937 random(1);  // fixed seed: reproducible results
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  MatrixXd X(n, width);
  for (Index j = 0; j < width; ++j)
    for (Index i = 0; i < n; ++i) X(i, j) = uniform(random);
  MatrixXd Y = M * X;
  VectorXd last = VectorXd::Zero(count);
  double best = std::numeric_limits<double>::infinity();
  int stalled = 0;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    X = factor.solve(Y);
    const MatrixXd MX = M * X;
    const MatrixXd A_reduced = X.transpose() * Y;  // X^T A X without the cancellation of stiff parts
    const Reduced reduced = solve_reduced(X.transpose() * MX, 0.5 * (A_reduced + A_reduced.transpose()));
    Y = MX * reduced.y;
    const VectorXd mu = reduced.mu.head(count);
    const double change = ((mu - last).array() / mu.array()).abs().maxCoeff();
    stalled = change < 0.9 * best ? 0 : stalled + 1;
    best = std::min(best, change);
    if (best <= kConverged || (best <= kRoundOff && stalled >= kStalled))
      return modes_from(mu, X * reduced.y.leftCols(count), shift);
    last = mu;
  }
  throw NumericalError(code::kModesNotConverged, "modes: subspace iteration for " + std::to_string(count) +
                                                     " modes did not converge in " + std::to_string(kMaxIterations) +
                                                     " iterations.");
}

// Pivots of the block with unit diagonal, of which massless motions have none but round-off.
int rank_of_block(const Sparse& M, const std::vector<int>& block) {
  std::vector<int> place(static_cast<std::size_t>(M.rows()), -1);
  for (std::size_t i = 0; i < block.size(); ++i) place[block[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (const int j : block)
    for (Sparse::InnerIterator it(M, j); it; ++it)
      entries.emplace_back(
          place[it.row()], place[j],
          it.value() / std::sqrt(M.coeff(it.row(), it.row()) * M.coeff(j, j)) + (it.row() == j ? 10.0 * kRank : 0.0));
  const auto n = static_cast<Index>(block.size());
  Sparse unit(n, n);
  unit.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Sparse> factor(unit);
  if (factor.info() != Eigen::Success) return 0;
  return static_cast<int>((factor.vectorD().array() > 100.0 * kRank).count());
}

}  // namespace

// Finds the blocks by following couplings.
int mass_rank(const Sparse& M) {
  int rank = 0;
  std::vector<bool> done(static_cast<std::size_t>(M.cols()), false);
  for (Index j = 0; j < M.cols(); ++j) {
    if (done[j]) continue;
    std::vector<int> block = {static_cast<int>(j)};
    done[j] = true;
    for (std::size_t next = 0; next < block.size(); ++next)
      for (Sparse::InnerIterator it(M, block[next]); it; ++it) {
        if (done[it.row()]) continue;
        done[it.row()] = true;
        block.push_back(static_cast<int>(it.row()));
      }
    if (block.size() > kDenseBlock) {
      rank += rank_of_block(M, block);
      continue;
    }
    MatrixXd dense(block.size(), block.size());
    for (std::size_t a = 0; a < block.size(); ++a)
      for (std::size_t b = 0; b < block.size(); ++b)
        dense(static_cast<Index>(a), static_cast<Index>(b)) = M.coeff(block[a], block[b]);
    const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(dense, Eigen::EigenvaluesOnly).eigenvalues();
    rank += static_cast<int>((values.array() > kRank * values.maxCoeff()).count());
  }
  return rank;
}

Modes lowest_modes(const Sparse& K, const Sparse& M, int count, double shift, EigenMethod method) {
  FOOTFALL_DEMAND(count >= 0 && K.rows() == M.rows());
  if (count > K.rows())
    throw InputError(code::kTooManyModes, std::to_string(count) + " modes required, but there are only " +
                                              std::to_string(K.rows()) + " degrees of freedom.");
  if (count > mass_rank(M)) refuse_massless(count);
  if (count == 0) return {VectorXd(0), MatrixXd(K.rows(), 0)};
  const bool dense = method == EigenMethod::kDense ||
                     (method == EigenMethod::kAutomatic && (K.rows() <= kDenseSize || count > K.rows() / 8));
  return dense ? dense_modes(K, M, count, shift) : subspace_modes(K, M, count, shift);
}

Modes all_modes(const MatrixXd& K, const MatrixXd& M, double shift) {
  const Reduced reduced = solve_reduced(M, K + shift * M);
  const Index count = (reduced.mu.array() > kMassless * reduced.mu(0)).count();
  return modes_from(reduced.mu.head(count), reduced.y.leftCols(count), shift);
}

}  // namespace footfall

// Loads at the interface and weight, each balanced, are solved with the full model and within the basis.

#include "mbd_solver/fe/static_error.h"

#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <numeric>

#include "coupler/base/errors.h"
#include "mbd_solver/fe/eigen_solver.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kShift = 1e-4;          // of the elastic scale; see balanced_solution
constexpr int kPasses = 5;               // error 1e-4 to the sixth power, with a scale 100 times too high 1e-12
constexpr double kSameDirection = 1e-9;  // smaller singular values relative to the largest are round-off
constexpr double kOnlyRigid = 1e-6;      // a smaller rest of a balanced unit load counts as zero

// Rows and columns of one size, so that metres and radians can be compared.
MatrixXd scaled(MatrixXd x) {
  for (Index j = 0; j < x.cols(); ++j)
    if (const double size = x.col(j).norm(); size > 0.0) x.col(j) /= size;
  return x;
}

// y with A y = 0, orthonormal columns.
MatrixXd null_space(const MatrixXd& A) {
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeFullV);
  const VectorXd& sigma = svd.singularValues();
  const Index rank = (sigma.array() > kSameDirection * sigma(0)).count();
  return svd.matrixV().rightCols(A.cols() - rank);
}

// Columns: the unit loads at the interface, each balanced by others there: (I - Q Q^T) e_i, Q an orthonormal basis of
// the rigid-body motions of the interface.
MatrixXd interface_loads(const HeldBody& body) {
  const MatrixXd R_b = gathered(body.rigid, body.held);
  const Eigen::JacobiSVD<MatrixXd> svd(scaled(R_b), Eigen::ComputeThinU);
  const VectorXd& sigma = svd.singularValues();
  const MatrixXd Q = svd.matrixU().leftCols((sigma.array() > kSameDirection * sigma(0)).count());
  const Index n = R_b.rows();
  const MatrixXd balanced = MatrixXd::Identity(n, n) - Q * Q.transpose();
  std::vector<int> some;
  for (Index i = 0; i < n; ++i)
    if (balanced.col(i).norm() > kOnlyRigid) some.push_back(static_cast<int>(i));
  return scattered(gathered(balanced, some).transpose(), body.held, body.K.rows());
}

// The same for weight, with the interface held: f = M r for translations r, without the part that swings the body about an
// interface that does not hold it.
double weight_error(const HeldBody& body, const MatrixXd& shapes) {
  std::vector<int> all(static_cast<std::size_t>(body.K.rows()));
  std::iota(all.begin(), all.end(), 0);
  const std::vector<int> inside = other_dofs(all, body.held);
  if (inside.empty()) return 0.0;
  const Sparse K = selected(body.K, inside, inside), M = selected(body.M, inside, inside);
  const MatrixXd rigid = scaled(body.rigid), R = gathered(rigid, inside);
  const MatrixXd swing = R * null_space(gathered(rigid, body.held));
  MatrixXd f = M * R.leftCols<3>();
  if (swing.cols() > 0) {
    const MatrixXd M_swing = M * swing;
    f -= M_swing * (swing.transpose() * M_swing).ldlt().solve(swing.transpose() * f);
  }
  const VectorXd exact = f.cwiseProduct(balanced_solution(K, M, f, body.scale)).colwise().sum();

  // Motions of frame and shapes with the interface at rest.
  MatrixXd V(body.rigid.rows(), 6 + shapes.cols());
  V << body.rigid, shapes;
  V = scaled(V);
  const MatrixXd W = gathered(V, inside) * null_space(gathered(V, body.held));
  VectorXd found = VectorXd::Zero(3);
  if (W.cols() > 0) {
    const Modes modes = all_modes(W.transpose() * (K * W), W.transpose() * (M * W), body.scale);
    for (Index k = 0; k < modes.lambda.size(); ++k)
      if (modes.lambda(k) > kNoStiffness * body.scale)
        found += (f.transpose() * (W * modes.shapes.col(k))).cwiseAbs2() / modes.lambda(k);
  }
  return exact.maxCoeff() > 0.0 ? (exact - found).maxCoeff() / exact.maxCoeff() : 0.0;
}

}  // namespace

// K is singular, but the load does no work on motions without strain, so that a solution exists. A slightly shifted matrix
// and refinement find it: each pass reduces the error by the factor shift / (first elastic lambda + shift).
MatrixXd balanced_solution(const Sparse& K, const Sparse& M, const MatrixXd& load, double scale) {
  const Eigen::SimplicialLDLT<Sparse> factor(Sparse(K + kShift * scale * M));
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0.0))
    throw InputError(code::kStiffness, "stiffness is not positive definite with the interface held.");
  MatrixXd x = factor.solve(load);
  for (int pass = 0; pass < kPasses; ++pass) x += factor.solve(load - K * x);
  return x;
}

int held_motions(const HeldBody& body) {
  return 6 - static_cast<int>(null_space(gathered(scaled(body.rigid), body.held)).cols());
}

// max_i 1 - c_i' / c_i with c = f . K^+ f of the model and c' = (Phi^T f) . (Phi^T K Phi)^-1 (Phi^T f) of the shapes.
double interface_error(const HeldBody& body, const MatrixXd& shapes) {
  const MatrixXd f = interface_loads(body);
  if (f.cols() == 0) return 0.0;
  const VectorXd exact = f.cwiseProduct(balanced_solution(body.K, body.M, f, body.scale)).colwise().sum();
  const MatrixXd unit = scaled(shapes), Q = unit.transpose() * f;
  const MatrixXd K = unit.transpose() * (body.K * unit);
  const VectorXd found = Q.cwiseProduct(K.ldlt().solve(Q)).colwise().sum();
  return (1.0 - found.array() / exact.array()).maxCoeff();
}

double static_error(const HeldBody& body, const MatrixXd& shapes) {
  FOOTFALL_DEMAND(!body.held.empty() && shapes.cols() > 0 && shapes.rows() == body.K.rows());
  return std::max({0.0, interface_error(body, shapes), weight_error(body, shapes)});
}

}  // namespace footfall

#pragma once
// LU factors of sparse matrices of constant pattern by KLU of SuiteSparse, also without small entries.

#include <Eigen/Sparse>
#include <memory>
#include <vector>

namespace footfall {

// Ordered once, factored whenever values change.
class SparseLu {
 public:
  // Orders the pattern of `matrix` (column-major, compressed, square). The matrix must outlive this object.
  explicit SparseLu(const Eigen::SparseMatrix<double>& matrix);
  ~SparseLu();
  SparseLu(const SparseLu&) = delete;
  SparseLu& operator=(const SparseLu&) = delete;

  // Factors the current values. Pivots of the last factorization are reused while they are good enough. False if the matrix is
  // singular or not finite.
  bool factor();
  // X = A^-1 X in place, all columns in one pass through the factors; after a successful factor().
  void solve(Eigen::Ref<Eigen::MatrixXd> X) const;
  double log_determinant() const;  // ln |det A|; after a successful factor()
  // The next factor() chooses its pivots from the values alone.
  void forget();

 private:
  struct Klu;
  std::unique_ptr<Klu> klu_;
};

// LU factors of a matrix over [v; ...] without negligible entries of v by v.
//   neglected: a_ij, i != j, with |a_ij| < share_i sqrt(d_i d_j)
//   d_i        contribution of the body itself to the diagonal: M_ii, or c M_ii + (modal damping and stiffness)
// Newton's method converges to the same solution with a slightly changed matrix, and hardly slower. d excludes springs and
// contacts: two bodies on a stiff spring move together with their inertia alone, and entries small relative to the spring are
// not small relative to that.
// Dense blocks of the pattern are mostly empty: modes of a body are orthogonal, points without contact have no stiffness, and
// the forces of a joint couple few coordinates of its bodies.
class ThinLu {
 public:
  static constexpr double kRoundOff = 1e-14;  // a share that neglects round-off only

  // `share`: per row of v; 0 neglects nothing. The matrix must outlive this object.
  ThinLu(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& share);

  // Factors the current values. Entries are selected at the first call, and again when a neglected one exceeds three times its
  // limit. `own`: d. False if the matrix is singular or not finite.
  bool factor(const Eigen::VectorXd& own);
  // X = A^-1 X in place, all columns in one pass through the factors; after a successful factor().
  void solve(Eigen::Ref<Eigen::MatrixXd> X) const { lu_->solve(X); }
  double log_determinant() const { return lu_->log_determinant(); }  // ln |det A|; after a successful factor()
  // The next factor() selects entries and pivots from the values alone.
  void forget() { lu_.reset(); }
  Eigen::Index entries() const { return thin_.nonZeros(); }

 private:
  bool neglects_too_much() const;
  void select();

  const Eigen::SparseMatrix<double>& matrix_;
  const Eigen::VectorXd share_;
  Eigen::VectorXd row_, column_;      // share_i sqrt(d_i), sqrt(d_j)
  Eigen::SparseMatrix<double> thin_;  // selected entries
  std::vector<int> from_;             // their places in the values of matrix_, rising
  std::unique_ptr<SparseLu> lu_;      // of thin_; null: not selected yet
};

}  // namespace footfall

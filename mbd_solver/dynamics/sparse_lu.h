#pragma once
// LU factors of a sparse matrix of fixed pattern (KLU of SuiteSparse): ordered once, factored as often as
// values change.

#include <Eigen/Sparse>
#include <memory>
#include <vector>

namespace footfall {

class SparseLu {
 public:
  // Orders the pattern of `matrix` (column-major, compressed, square). The matrix must outlive this object.
  explicit SparseLu(const Eigen::SparseMatrix<double>& matrix);
  ~SparseLu();
  SparseLu(const SparseLu&) = delete;
  SparseLu& operator=(const SparseLu&) = delete;

  // Factors the present values. Pivots of the last factorization are kept while they stay good, else they are
  // chosen anew. False when the matrix is singular or not finite.
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

// LU factors of a matrix over [v; ...] without the entries of v by v that hardly matter.
//   left out: a_ij, i != j, with |a_ij| < share_i sqrt(d_i d_j)
//   d_i       what the body itself gives the diagonal: M_ii, or c M_ii + (modal damping and stiffness)
// Newton's method converges to the same solution with a matrix that is a little off, and hardly slower. Springs and contacts
// do not count in d: two bodies on a stiff spring move together with their inertia alone, and what is small beside the
// spring is not small beside that.
// A dense block of the pattern is mostly empty: modes of a body are orthogonal, places that touch nothing have no
// stiffness, and the forces of a joint couple few coordinates of its bodies.

class ThinLu {
 public:
  static constexpr double kRoundOff = 1e-14;  // a share that leaves out what is zero but for round-off

  // `share`: per row of v; 0 leaves nothing out. The matrix must outlive this object.
  ThinLu(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& share);

  // Factors the present values. Which entries take part is chosen by the first of them, and anew when one that was left
  // out has grown to three times what may be left out. `own`: d. False when the matrix is singular or not finite.
  bool factor(const Eigen::VectorXd& own);
  // X = A^-1 X in place, all columns in one pass through the factors; after a successful factor().
  void solve(Eigen::Ref<Eigen::MatrixXd> X) const { lu_->solve(X); }
  double log_determinant() const { return lu_->log_determinant(); }  // ln |det A|; after a successful factor()
  // The next factor() chooses entries and pivots from the values alone.
  void forget() { lu_.reset(); }
  Eigen::Index entries() const { return thin_.nonZeros(); }  // that take part

 private:
  bool misses() const;  // an entry that matters is left out
  void choose();

  const Eigen::SparseMatrix<double>& matrix_;
  const Eigen::VectorXd share_;
  Eigen::VectorXd row_, column_;      // share_i sqrt(d_i), sqrt(d_j)
  Eigen::SparseMatrix<double> thin_;  // entries that take part
  std::vector<int> from_;             // their places in the values of matrix_, rising
  std::unique_ptr<SparseLu> lu_;      // of thin_; none: not chosen yet
};

}  // namespace footfall

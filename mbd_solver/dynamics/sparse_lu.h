#pragma once
// LU factors of a sparse matrix of fixed pattern (KLU of SuiteSparse): ordered once, factored as often as
// values change.

#include <Eigen/Sparse>
#include <memory>

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

}  // namespace footfall

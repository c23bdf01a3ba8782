#pragma once
// A matrix without unknowns that act on each other within small blocks only, such as friction springs of contact points:
//   [A B; C D] [x; z] = [f; g],   D = diag(D_1, D_2, ...)
//   (A - sum_k B_k D_k^-1 C_k) x = f - sum_k B_k D_k^-1 g_k,   z_k = D_k^-1 (g_k - C_k x)
// Points off the ground have B_k = C_k = 0 and cost no factorization. Without such blocks it is the matrix itself.

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <functional>
#include <vector>

namespace footfall {

// Unknowns `first` to `first` + `count` - 1, in blocks of `size`, at most CondensedMatrix::kLargestBlock.
struct LocalUnknowns {
  int first = 0, count = 0, size = 1;
};

class CondensedMatrix {
 public:
  static constexpr int kLargestBlock = 3;

  // `whole` must outlive this object; its pattern remains unchanged.
  CondensedMatrix(const Eigen::SparseMatrix<double>& whole, const std::vector<LocalUnknowns>& local);
  CondensedMatrix(const CondensedMatrix&) = delete;
  CondensedMatrix& operator=(const CondensedMatrix&) = delete;

  // A - sum_k B_k D_k^-1 C_k of the last update(), of constant pattern; valid as long as this object.
  const Eigen::SparseMatrix<double>& matrix() const { return blocks_.empty() ? whole_ : condensed_; }
  // Takes the current values. False if a D_k is singular.
  bool update();
  // The solution of the whole system in place: `inner` solves with matrix() in place.
  void solve(Eigen::Ref<Eigen::VectorXd> x, const std::function<void(Eigen::Ref<Eigen::VectorXd>)>& inner);

 private:
  struct Entry {
    int other = 0;  // row of an entry of B, or column of one of C, among the unknowns that stay
    int local = 0;  // unknown within its block
    int place = 0;  // in the values of the whole matrix
    double value = 0.0;
  };
  struct Block {
    int first = 0, size = 1;  // of its unknowns
    std::vector<Entry> B, C;
    std::vector<int> D;  // places in the values of the whole matrix, row by row
    std::vector<int>
        change;  // places in the values of the condensed matrix, of B.size() x C.size() products, row by row
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();  // D_k^-1; of smaller blocks its first entries
    bool acts = false, feels = false;                       // B_k, C_k are not 0
  };

  const Eigen::SparseMatrix<double>& whole_;
  std::vector<int> stays_;  // places in the whole of the unknowns that stay
  std::vector<Block> blocks_;
  Eigen::SparseMatrix<double> condensed_;
  std::vector<int> from_, to_;  // values of the whole matrix that stay, and their places in the condensed one
  Eigen::VectorXd small_;
};

}  // namespace footfall

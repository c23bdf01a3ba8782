#pragma once
// LU factors of the reduced Jacobian with the inner states of contacts eliminated first. A contact has as many states as
// places (a disc 122), each place acts on its body alone and most touch nothing: a general LU carries all of them through
// its fill, here they cost what those that touch cost.
//   [A, H; G, D] [x; z] = [f; g],  D of blocks up to 3 x 3:   (A - H D^-1 G) x = f - H D^-1 g,   z = D^-1 (g - G x)
// Without such states it is SparseLu of the matrix itself, to the last bit.

#include <Eigen/Sparse>
#include <memory>
#include <vector>

#include "mbd_solver/dynamics/sparse_lu.h"

namespace footfall {

// States first, first + 1, ... first + count - 1 of the matrix in blocks of `block` neighbours that act on each other. All
// blocks have the same rows and columns of the rest.
struct InnerStates {
  int first = 0, count = 0;
  int block = 1;  // 1 to 3
};

class CondensedLu {
 public:
  // `matrix` (column-major, compressed, square) must outlive this object. Its pattern must hold what the elimination
  // fills: the rows of the rest that a state acts on by the columns that act on it.
  CondensedLu(const Eigen::SparseMatrix<double>& matrix, const std::vector<InnerStates>& inner);

  // As SparseLu.
  bool factor();
  void solve(Eigen::Ref<Eigen::VectorXd> x);
  void forget() { lu_->forget(); }
  int condensed_size() const {
    return inner_.empty() ? static_cast<int>(matrix_.rows()) : static_cast<int>(rest_.rows());
  }

 private:
  using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;

  // The blocks of one element.
  struct Element {
    InnerStates states;
    std::vector<int> rows, cols;  // of the rest, in the full matrix: H and G
    std::vector<int> fill;        // value of `rest_` at (rows[i], cols[j]): fill[j rows + i]
    std::vector<int> G;           // per block and column: place of its first row in the values of the matrix
    std::vector<int> H;           // per block, state and row: its place
    std::vector<int> D;           // per block and column: place of its first row
    std::vector<Block> inverse;   // D^-1
    std::vector<char> acts;       // per block: G and H are not zero
    Eigen::MatrixXd DG;           // scratch, D^-1 G of a block
  };
  void locate(const InnerStates& states);
  Column gathered(const Element& e, int block, const Eigen::Ref<const Eigen::VectorXd>& x) const;

  const Eigen::SparseMatrix<double>& matrix_;
  std::vector<Element> inner_;
  std::vector<int> kept_;             // rows of the rest in the matrix
  Eigen::SparseMatrix<double> rest_;  // A - H D^-1 G
  std::vector<int> source_;           // of each value of rest_: its place in the values of the matrix
  Eigen::VectorXd x_;                 // of the rest
  std::unique_ptr<SparseLu> lu_;
};

}  // namespace footfall

#pragma once
// A sparse matrix of dense blocks with a constant pattern: blocks are announced, the matrix is built, and each block is then
// written through its own list of places, without a search.

#include <Eigen/Sparse>
#include <vector>

namespace footfall {

// The place of an entry of the pattern in the value array.
int place_of(const Eigen::SparseMatrix<double>& matrix, int row, int col);

// First places of the columns of one dense block in the value array. Rows of a block are contiguous in every column.
class SparseBlock {
 public:
  SparseBlock() = default;
  SparseBlock(const Eigen::SparseMatrix<double>& matrix, int row0, int rows, int col0, int cols);

  int rows() const { return rows_; }
  int cols() const { return static_cast<int>(start_.size()); }
  // values[column] += x (rows), where `values` is the value array of the matrix.
  template <typename Vector>
  void add_column(double* values, int column, const Vector& x) const {
    double* place = values + start_[column];
    for (int i = 0; i < rows_; ++i) place[i] += x[i];
  }
  void add(double* values, int row, int column, double x) const { values[start_[column] + row] += x; }

 private:
  int rows_ = 0;
  std::vector<int> start_;
};

class SparsePattern {
 public:
  explicit SparsePattern(int size) : size_(size) {}
  void add_block(int row0, int rows, int col0, int cols);
  void add_diagonal(int row0, int col0, int count);  // entries (row0 + i, col0 + i)
  Eigen::SparseMatrix<double> build() const;         // square, compressed, zeros stored

 private:
  int size_;
  std::vector<Eigen::Triplet<double>> entries_;
};

// Places of (row0 + i, col0 + i).
std::vector<int> diagonal_places(const Eigen::SparseMatrix<double>& matrix, int row0, int col0, int count);

}  // namespace footfall

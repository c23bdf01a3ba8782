// Places are found once, by binary search in the compressed columns.

#include "mbd_solver/dynamics/sparse_blocks.h"

#include <algorithm>

#include "coupler/base/errors.h"

namespace footfall {

int place_of(const Eigen::SparseMatrix<double>& matrix, int row, int col) {
  const int* first = matrix.innerIndexPtr() + matrix.outerIndexPtr()[col];
  const int* last = matrix.innerIndexPtr() + matrix.outerIndexPtr()[col + 1];
  const int* found = std::lower_bound(first, last, row);
  FOOTFALL_DEMAND(found != last && *found == row);
  return static_cast<int>(found - matrix.innerIndexPtr());
}

SparseBlock::SparseBlock(const Eigen::SparseMatrix<double>& matrix, int row0, int rows, int col0, int cols)
    : rows_(rows) {
  if (rows == 0) return;
  for (int j = 0; j < cols; ++j) {
    start_.push_back(place_of(matrix, row0, col0 + j));
    FOOTFALL_DEMAND(place_of(matrix, row0 + rows - 1, col0 + j) == start_.back() + rows - 1);
  }
}

void SparsePattern::add_block(int row0, int rows, int col0, int cols) {
  for (int j = 0; j < cols; ++j) {
    for (int i = 0; i < rows; ++i) entries_.emplace_back(row0 + i, col0 + j, 0.0);
  }
}

void SparsePattern::add_diagonal(int row0, int col0, int count) {
  for (int i = 0; i < count; ++i) entries_.emplace_back(row0 + i, col0 + i, 0.0);
}

Eigen::SparseMatrix<double> SparsePattern::build() const {
  Eigen::SparseMatrix<double> matrix(size_, size_);
  matrix.setFromTriplets(entries_.begin(), entries_.end());
  matrix.makeCompressed();
  return matrix;
}

std::vector<int> diagonal_places(const Eigen::SparseMatrix<double>& matrix, int row0, int col0, int count) {
  std::vector<int> places;
  for (int i = 0; i < count; ++i) places.push_back(place_of(matrix, row0 + i, col0 + i));
  return places;
}

}  // namespace footfall

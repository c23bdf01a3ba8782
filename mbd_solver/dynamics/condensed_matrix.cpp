// The pattern is found once: each block adds the entries of its row by column products. Values follow without a search.
#include "mbd_solver/dynamics/condensed_matrix.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/sparse_blocks.h"

namespace footfall {

CondensedMatrix::CondensedMatrix(const Eigen::SparseMatrix<double>& whole, const std::vector<LocalUnknowns>& local)
    : whole_(whole) {
  if (local.empty()) return;
  FOOTFALL_DEMAND(whole.isCompressed() && whole.rows() == whole.cols());
  const int n = static_cast<int>(whole.cols());
  std::vector<int> block_of(static_cast<std::size_t>(n), -1), now(static_cast<std::size_t>(n), -1);
  for (const LocalUnknowns& part : local) {
    FOOTFALL_DEMAND(part.size >= 1 && part.size <= kLargestBlock && part.count % part.size == 0);
    for (int first = part.first; first < part.first + part.count; first += part.size) {
      Block block;
      block.first = first;
      block.size = part.size;
      for (int i = 0; i < part.size; ++i) {
        block_of[first + i] = static_cast<int>(blocks_.size());
        for (int j = 0; j < part.size; ++j) block.D.push_back(place_of(whole, first + i, first + j));
      }
      blocks_.push_back(std::move(block));
    }
  }
  for (int j = 0; j < n; ++j) {
    if (block_of[j] >= 0) continue;
    now[j] = static_cast<int>(stays_.size());
    stays_.push_back(j);
  }

  std::vector<Eigen::Triplet<double>> pattern;
  for (int j = 0; j < n; ++j) {
    const int of_column = block_of[j];
    for (int k = whole.outerIndexPtr()[j]; k < whole.outerIndexPtr()[j + 1]; ++k) {
      const int i = whole.innerIndexPtr()[k], of_row = block_of[i];
      if (of_row < 0 && of_column < 0) {
        pattern.emplace_back(now[i], now[j], 0.0);
      } else if (of_row < 0) {
        Block& block = blocks_[of_column];
        block.B.push_back({now[i], j - block.first, k, 0.0});
      } else if (of_column < 0) {
        Block& block = blocks_[of_row];
        block.C.push_back({now[j], i - block.first, k, 0.0});
      } else {
        FOOTFALL_DEMAND(of_row == of_column);
      }
    }
  }
  for (const Block& block : blocks_)
    for (const Entry& b : block.B)
      for (const Entry& c : block.C) pattern.emplace_back(b.other, c.other, 0.0);
  const Eigen::Index size = static_cast<Eigen::Index>(stays_.size());
  condensed_.resize(size, size);
  condensed_.setFromTriplets(pattern.begin(), pattern.end());
  condensed_.makeCompressed();
  small_.resize(size);

  for (int j = 0; j < n; ++j) {
    if (block_of[j] >= 0) continue;
    for (int k = whole.outerIndexPtr()[j]; k < whole.outerIndexPtr()[j + 1]; ++k) {
      const int i = whole.innerIndexPtr()[k];
      if (block_of[i] >= 0) continue;
      from_.push_back(k);
      to_.push_back(place_of(condensed_, now[i], now[j]));
    }
  }
  for (Block& block : blocks_)
    for (const Entry& b : block.B)
      for (const Entry& c : block.C) block.change.push_back(place_of(condensed_, b.other, c.other));
}

bool CondensedMatrix::update() {
  if (blocks_.empty()) return true;
  const double* const values = whole_.valuePtr();
  double* const out = condensed_.valuePtr();
  std::fill(out, out + condensed_.nonZeros(), 0.0);
  for (std::size_t k = 0; k < from_.size(); ++k) out[to_[k]] = values[from_[k]];
  for (Block& block : blocks_) {
    const auto entry = [&](std::size_t k) { return values[block.D[k]]; };
    double determinant = 0.0;
    if (block.size == 3) {
      Eigen::Matrix3d D;
      D << entry(0), entry(1), entry(2), entry(3), entry(4), entry(5), entry(6), entry(7), entry(8);
      determinant = D.determinant();
      block.inverse = D.inverse();
    } else {
      Eigen::Matrix2d D = Eigen::Matrix2d::Identity();
      if (block.size == 1)
        D(0, 0) = entry(0);
      else
        D << entry(0), entry(1), entry(2), entry(3);
      determinant = D.determinant();
      block.inverse.topLeftCorner<2, 2>() = D.inverse();
    }
    if (!std::isfinite(determinant) || determinant == 0.0) return false;
    block.acts = block.feels = false;
    for (Entry& b : block.B) block.acts = (b.value = values[b.place]) != 0.0 || block.acts;
    for (Entry& c : block.C) block.feels = (c.value = values[c.place]) != 0.0 || block.feels;
    if (!block.acts || !block.feels) continue;
    std::size_t at = 0;
    for (const Entry& b : block.B)
      for (const Entry& c : block.C) out[block.change[at++]] -= b.value * block.inverse(b.local, c.local) * c.value;
  }
  return true;
}

void CondensedMatrix::solve(Eigen::Ref<Eigen::VectorXd> x,
                            const std::function<void(Eigen::Ref<Eigen::VectorXd>)>& inner) {
  if (blocks_.empty()) {
    inner(x);
    return;
  }
  for (std::size_t k = 0; k < stays_.size(); ++k) small_[static_cast<Eigen::Index>(k)] = x[stays_[k]];
  for (const Block& block : blocks_) {
    double* const z = x.data() + block.first;
    const Eigen::Vector3d g(z[0], block.size > 1 ? z[1] : 0.0, block.size > 2 ? z[2] : 0.0);
    for (int i = 0; i < block.size; ++i) {  // D^-1 g
      z[i] = block.inverse(i, 0) * g[0];
      for (int j = 1; j < block.size; ++j) z[i] += block.inverse(i, j) * g[j];
    }
    if (!block.acts) continue;
    for (const Entry& b : block.B) small_[b.other] -= b.value * z[b.local];
  }
  inner(small_);
  for (std::size_t k = 0; k < stays_.size(); ++k) x[stays_[k]] = small_[static_cast<Eigen::Index>(k)];
  for (const Block& block : blocks_) {
    if (!block.feels) continue;
    double* const z = x.data() + block.first;
    for (const Entry& c : block.C) {
      const double value = c.value * small_[c.other];
      for (int i = 0; i < block.size; ++i) z[i] -= block.inverse(i, c.local) * value;
    }
  }
}

}  // namespace footfall

#include "mbd_solver/dynamics/condensed_lu.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

constexpr int kLargestBlock = 3;

// Place of (row, col) among the values; -1: not stored.
int stored_place(const Eigen::SparseMatrix<double>& matrix, int row, int col) {
  const int* first = matrix.innerIndexPtr() + matrix.outerIndexPtr()[col];
  const int* last = matrix.innerIndexPtr() + matrix.outerIndexPtr()[col + 1];
  const int* found = std::lower_bound(first, last, row);
  return found != last && *found == row ? static_cast<int>(found - matrix.innerIndexPtr()) : -1;
}

}  // namespace

CondensedLu::CondensedLu(const Eigen::SparseMatrix<double>& matrix, const std::vector<InnerStates>& inner)
    : matrix_(matrix) {
  FOOTFALL_DEMAND(matrix.isCompressed() && matrix.rows() == matrix.cols());
  if (inner.empty()) {
    lu_ = std::make_unique<SparseLu>(matrix);
    return;
  }
  const int n = static_cast<int>(matrix.rows());
  std::vector<int> at(static_cast<std::size_t>(n), 0);  // row of the rest; -1: eliminated
  for (const InnerStates& states : inner) {
    FOOTFALL_DEMAND(states.block >= 1 && states.block <= kLargestBlock && states.count % states.block == 0);
    for (int i = 0; i < states.count; ++i) at[static_cast<std::size_t>(states.first + i)] = -1;
  }
  for (int i = 0; i < n; ++i) {
    if (at[static_cast<std::size_t>(i)] < 0) continue;
    at[static_cast<std::size_t>(i)] = static_cast<int>(kept_.size());
    kept_.push_back(i);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const int col : kept_) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, col); entry; ++entry) {
      const int row = at[static_cast<std::size_t>(entry.row())];
      if (row >= 0) entries.emplace_back(row, at[static_cast<std::size_t>(col)], 0.0);
    }
  }
  const int size = static_cast<int>(kept_.size());
  rest_.resize(size, size);
  rest_.setFromTriplets(entries.begin(), entries.end());
  rest_.makeCompressed();
  for (int col = 0; col < size; ++col) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(rest_, col); entry; ++entry)
      source_.push_back(
          stored_place(matrix, kept_[static_cast<std::size_t>(entry.row())], kept_[static_cast<std::size_t>(col)]));
  }
  x_ = Eigen::VectorXd::Zero(size);
  for (const InnerStates& states : inner) locate(states);
  for (Element& e : inner_) {
    for (const int col : e.cols) {
      for (const int row : e.rows) {
        const int place = stored_place(rest_, at[static_cast<std::size_t>(row)], at[static_cast<std::size_t>(col)]);
        FOOTFALL_DEMAND(place >= 0);
        e.fill.push_back(place);
      }
    }
  }
  lu_ = std::make_unique<SparseLu>(rest_);
}

// Rows and columns of the rest are read off the first block; the others must have the same.
void CondensedLu::locate(const InnerStates& states) {
  Element e;
  e.states = states;
  const int b = states.block, blocks = states.count / b;
  const auto kept = [&](int i) { return std::binary_search(kept_.begin(), kept_.end(), i); };
  for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix_, states.first); entry; ++entry)
    if (kept(static_cast<int>(entry.row()))) e.rows.push_back(static_cast<int>(entry.row()));
  for (const int col : kept_)
    if (stored_place(matrix_, states.first, col) >= 0) e.cols.push_back(col);
  for (int k = 0; k < blocks; ++k) {
    const int z = states.first + k * b;
    for (const int col : e.cols) {
      e.G.push_back(stored_place(matrix_, z, col));
      FOOTFALL_DEMAND(e.G.back() >= 0 && stored_place(matrix_, z + b - 1, col) == e.G.back() + b - 1);
    }
    for (int q = 0; q < b; ++q) {
      FOOTFALL_DEMAND(matrix_.outerIndexPtr()[z + q + 1] - matrix_.outerIndexPtr()[z + q] ==
                      b + static_cast<int>(e.rows.size()));  // acts on nothing else
      e.D.push_back(stored_place(matrix_, z, z + q));
      FOOTFALL_DEMAND(e.D.back() >= 0);
      for (const int row : e.rows) {
        e.H.push_back(stored_place(matrix_, row, z + q));
        FOOTFALL_DEMAND(e.H.back() >= 0);
      }
    }
  }
  e.inverse.assign(static_cast<std::size_t>(blocks), Block::Identity(b, b));
  e.acts.assign(static_cast<std::size_t>(blocks), 0);
  e.DG = Eigen::MatrixXd::Zero(b, static_cast<Eigen::Index>(e.cols.size()));
  inner_.push_back(std::move(e));
}

bool CondensedLu::factor() {
  if (inner_.empty()) return lu_->factor();
  const double* from = matrix_.valuePtr();
  double* to = rest_.valuePtr();
  for (std::size_t k = 0; k < source_.size(); ++k) to[k] = from[source_[k]];
  for (Element& e : inner_) {
    const int b = e.states.block, nr = static_cast<int>(e.rows.size()), nc = static_cast<int>(e.cols.size());
    for (std::size_t k = 0; k < e.inverse.size(); ++k) {
      const int* D = &e.D[k * static_cast<std::size_t>(b)];
      const int* G = &e.G[k * static_cast<std::size_t>(nc)];
      const int* H = &e.H[k * static_cast<std::size_t>(b * nr)];
      Block block(b, b);
      for (int q = 0; q < b; ++q)
        for (int p = 0; p < b; ++p) block(p, q) = from[D[q] + p];
      const double det = block.determinant();
      if (!(std::abs(det) > 0.0) || !std::isfinite(det)) return false;
      e.inverse[k] = block.inverse();
      bool acts = false;
      for (int i = 0; i < b * nr && !acts; ++i) acts = from[H[i]] != 0.0;
      for (int j = 0; j < nc && !acts; ++j)
        for (int p = 0; p < b; ++p) acts = acts || from[G[j] + p] != 0.0;
      e.acts[k] = acts;
      if (!acts) continue;
      for (int j = 0; j < nc; ++j) {
        for (int p = 0; p < b; ++p) {
          double sum = 0.0;
          for (int q = 0; q < b; ++q) sum += e.inverse[k](p, q) * from[G[j] + q];
          e.DG(p, j) = sum;
        }
        const int* fill = &e.fill[static_cast<std::size_t>(j * nr)];
        for (int q = 0; q < b; ++q) {
          const double g = e.DG(q, j);
          if (g == 0.0) continue;
          for (int i = 0; i < nr; ++i) to[fill[i]] -= from[H[q * nr + i]] * g;
        }
      }
    }
  }
  return lu_->factor();
}

// D^-1 of what stands in the rows of a block.
CondensedLu::Column CondensedLu::gathered(const Element& e, int block,
                                          const Eigen::Ref<const Eigen::VectorXd>& x) const {
  const int b = e.states.block, z = e.states.first + block * b;
  Column out(b);
  for (int p = 0; p < b; ++p) {
    out[p] = 0.0;
    for (int q = 0; q < b; ++q) out[p] += e.inverse[static_cast<std::size_t>(block)](p, q) * x[z + q];
  }
  return out;
}

void CondensedLu::solve(Eigen::Ref<Eigen::VectorXd> x) {
  if (inner_.empty()) return lu_->solve(x);
  const double* values = matrix_.valuePtr();
  for (const Element& e : inner_) {
    const int b = e.states.block, nr = static_cast<int>(e.rows.size());
    for (std::size_t k = 0; k < e.inverse.size(); ++k) {
      if (!e.acts[k]) continue;
      const Column z = gathered(e, static_cast<int>(k), x);
      const int* H = &e.H[k * static_cast<std::size_t>(b * nr)];
      for (int q = 0; q < b; ++q)
        for (int i = 0; i < nr; ++i) x[e.rows[static_cast<std::size_t>(i)]] -= values[H[q * nr + i]] * z[q];
    }
  }
  for (std::size_t i = 0; i < kept_.size(); ++i) x_[static_cast<Eigen::Index>(i)] = x[kept_[i]];
  lu_->solve(x_);
  for (std::size_t i = 0; i < kept_.size(); ++i) x[kept_[i]] = x_[static_cast<Eigen::Index>(i)];
  for (const Element& e : inner_) {
    const int b = e.states.block, nc = static_cast<int>(e.cols.size());
    for (std::size_t k = 0; k < e.inverse.size(); ++k) {
      const int z = e.states.first + static_cast<int>(k) * b;
      const Block& inverse = e.inverse[k];
      if (!e.acts[k]) {  // most of them
        double g[kLargestBlock];
        for (int p = 0; p < b; ++p) g[p] = x[z + p];
        for (int p = 0; p < b; ++p) {
          x[z + p] = inverse(p, 0) * g[0];
          for (int q = 1; q < b; ++q) x[z + p] += inverse(p, q) * g[q];
        }
        continue;
      }
      const int* G = &e.G[k * static_cast<std::size_t>(nc)];
      for (int j = 0; j < nc; ++j) {
        const double v = x[e.cols[static_cast<std::size_t>(j)]];
        for (int p = 0; p < b; ++p) x[z + p] -= values[G[j] + p] * v;
      }
      const Column solved = gathered(e, static_cast<int>(k), x);
      for (int p = 0; p < b; ++p) x[z + p] = solved[p];
    }
  }
}

}  // namespace footfall

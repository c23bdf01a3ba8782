#include "mbd_solver/dynamics/thin_lu.h"

#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

constexpr double kMatters = 3.0;  // times what may be left out

}  // namespace

ThinLu::ThinLu(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& share)
    : matrix_(matrix), share_(share) {
  FOOTFALL_DEMAND(matrix.isCompressed() && share.size() <= matrix.cols());
}

bool ThinLu::factor(const Eigen::VectorXd& own) {
  FOOTFALL_DEMAND(own.size() == share_.size());
  column_ = own.cwiseSqrt();
  row_ = share_.cwiseProduct(column_);
  if (!lu_ || misses()) choose();
  const double* values = matrix_.valuePtr();
  double* thin = thin_.valuePtr();
  for (std::size_t k = 0; k < from_.size(); ++k) thin[k] = values[from_[k]];
  return lu_->factor();
}

bool ThinLu::misses() const {
  const int* outer = matrix_.outerIndexPtr();
  const int* inner = matrix_.innerIndexPtr();
  const double* values = matrix_.valuePtr();
  std::size_t next = 0;  // in from_
  for (int j = 0; j < share_.size(); ++j) {
    for (int k = outer[j]; k < outer[j + 1]; ++k) {
      if (next < from_.size() && from_[next] == k) {
        ++next;
      } else if (!(std::abs(values[k]) < kMatters * row_[inner[k]] * column_[j])) {
        return true;
      }
    }
  }
  return false;
}

void ThinLu::choose() {
  const int* outer = matrix_.outerIndexPtr();
  const int* inner = matrix_.innerIndexPtr();
  const double* values = matrix_.valuePtr();
  const int velocities = static_cast<int>(share_.size());
  lu_.reset();
  from_.clear();
  std::vector<Eigen::Triplet<double>> kept;
  for (int j = 0; j < matrix_.cols(); ++j) {
    for (int k = outer[j]; k < outer[j + 1]; ++k) {
      const int i = inner[k];
      const bool may_go = i < velocities && j < velocities && i != j;
      if (may_go && std::abs(values[k]) < row_[i] * column_[j]) continue;
      kept.emplace_back(i, j, 0.0);
      from_.push_back(k);
    }
  }
  thin_.resize(matrix_.rows(), matrix_.cols());
  thin_.setFromTriplets(kept.begin(), kept.end());
  thin_.makeCompressed();
  lu_ = std::make_unique<SparseLu>(thin_);
}

}  // namespace footfall

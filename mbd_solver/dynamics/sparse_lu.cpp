// KLU is refactored with old pivots while their condition estimate remains good; ThinLu copies the selected entries first.

#include "mbd_solver/dynamics/sparse_lu.h"

#include <klu.h>

#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

// Pivots of an earlier factorization are reused while their condition estimate remains within this factor.
constexpr double kPivotsAge = 1e-2;

}  // namespace

struct SparseLu::Klu {
  explicit Klu(const Eigen::SparseMatrix<double>& m) : matrix(m) {
    klu_defaults(&common);
    common.scale = 1;  // rows by their sums: rows of masses, conditions and 1 / h differ in size; a third of the fill
  }
  ~Klu() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  // KLU takes its input without const, but does not change it.
  int* outer() const { return const_cast<int*>(matrix.outerIndexPtr()); }
  int* inner() const { return const_cast<int*>(matrix.innerIndexPtr()); }
  double* values() const { return const_cast<double*>(matrix.valuePtr()); }

  // min |U_ii| / max |U_ii|, cheap; 0 when singular or not finite.
  double condition() {
    if (klu_rcond(symbolic, numeric, &common) == 0 || !std::isfinite(common.rcond)) return 0.0;
    return common.rcond;
  }

  const Eigen::SparseMatrix<double>& matrix;
  double first_condition = 0.0;  // when the pivots were chosen
  klu_common common;
  klu_symbolic* symbolic = nullptr;
  klu_numeric* numeric = nullptr;
};

SparseLu::SparseLu(const Eigen::SparseMatrix<double>& matrix) : klu_(std::make_unique<Klu>(matrix)) {
  FOOTFALL_DEMAND(matrix.isCompressed() && matrix.rows() == matrix.cols());
  if (matrix.rows() == 0) return;
  klu_->symbolic = klu_analyze(static_cast<int>(matrix.rows()), klu_->outer(), klu_->inner(), &klu_->common);
  FOOTFALL_DEMAND(klu_->symbolic != nullptr);
}

SparseLu::~SparseLu() = default;

bool SparseLu::factor() {
  Klu& k = *klu_;
  if (k.matrix.rows() == 0) return true;
  if (k.numeric != nullptr) {
    if (klu_refactor(k.outer(), k.inner(), k.values(), k.symbolic, k.numeric, &k.common) != 0 &&
        k.common.status == KLU_OK && k.condition() > kPivotsAge * k.first_condition)
      return true;
    forget();
  }
  k.numeric = klu_factor(k.outer(), k.inner(), k.values(), k.symbolic, &k.common);
  if (k.numeric == nullptr || k.common.status != KLU_OK) return false;
  k.first_condition = k.condition();
  return k.first_condition > 0.0;
}

void SparseLu::solve(Eigen::Ref<Eigen::MatrixXd> X) const {
  Klu& k = *klu_;
  if (k.matrix.rows() == 0) return;
  FOOTFALL_DEMAND(k.numeric != nullptr && X.rows() == k.matrix.rows() &&
                  (X.cols() == 1 || X.outerStride() == X.rows()));
  klu_solve(k.symbolic, k.numeric, static_cast<int>(X.rows()), static_cast<int>(X.cols()), X.data(), &k.common);
}

double SparseLu::log_determinant() const {
  const Klu& k = *klu_;
  double sum = 0.0;
  const double* pivots = k.matrix.rows() == 0 ? nullptr : static_cast<const double*>(k.numeric->Udiag);
  for (Eigen::Index i = 0; i < k.matrix.rows(); ++i) sum += std::log(std::abs(pivots[i]) * k.numeric->Rs[i]);
  return sum;
}

void SparseLu::forget() { klu_free_numeric(&klu_->numeric, &klu_->common); }

namespace {

constexpr double kMatters = 3.0;  // times the limit of neglected entries

}  // namespace

ThinLu::ThinLu(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& share)
    : matrix_(matrix), share_(share) {
  FOOTFALL_DEMAND(matrix.isCompressed() && share.size() <= matrix.cols());
}

bool ThinLu::factor(const Eigen::VectorXd& own) {
  FOOTFALL_DEMAND(own.size() == share_.size());
  column_ = own.cwiseSqrt();
  row_ = share_.cwiseProduct(column_);
  if (!lu_ || neglects_too_much()) select();
  const double* values = matrix_.valuePtr();
  double* thin = thin_.valuePtr();
  for (std::size_t k = 0; k < from_.size(); ++k) thin[k] = values[from_[k]];
  return lu_->factor();
}

bool ThinLu::neglects_too_much() const {
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

void ThinLu::select() {
  const int* outer = matrix_.outerIndexPtr();
  const int* inner = matrix_.innerIndexPtr();
  const double* values = matrix_.valuePtr();
  const int velocities = static_cast<int>(share_.size());
  lu_.reset();
  from_.clear();
  std::vector<Eigen::Triplet<double>> selected;
  for (int j = 0; j < matrix_.cols(); ++j) {
    for (int k = outer[j]; k < outer[j + 1]; ++k) {
      const int i = inner[k];
      const bool may_go = i < velocities && j < velocities && i != j;
      if (may_go && std::abs(values[k]) < row_[i] * column_[j]) continue;
      selected.emplace_back(i, j, 0.0);
      from_.push_back(k);
    }
  }
  thin_.resize(matrix_.rows(), matrix_.cols());
  thin_.setFromTriplets(selected.begin(), selected.end());
  thin_.makeCompressed();
  lu_ = std::make_unique<SparseLu>(thin_);
}

}  // namespace footfall

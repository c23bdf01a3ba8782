#include "mbd_solver/dynamics/sparse_lu.h"

#include <klu.h>

#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

// Pivots of an earlier factorization are good enough while the condition they show stays within this factor.
constexpr double kPivotsAge = 1e-2;

}  // namespace

struct SparseLu::Klu {
  explicit Klu(const Eigen::SparseMatrix<double>& m) : matrix(m) {
    klu_defaults(&common);
    common.scale = 1;  // rows by their sums: equations of motion mix masses, conditions and 1 / h; three
                       // times less fill here
  }
  ~Klu() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  // KLU's interface takes its input without const, and leaves it alone.
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

}  // namespace footfall

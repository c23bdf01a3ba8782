#include "mbd_solver/dynamics/sparse_lu.h"

#include <cmath>

#include <klu.h>

#include "coupler/errors.h"

namespace footfall {
namespace {

// Pivots of an earlier factorization are good enough while no element grew by more than this.
constexpr double kSmallestGrowth = 1e-4;  // reciprocal pivot growth, 1 = no growth

}  // namespace

struct SparseLu::Klu {
  explicit Klu(const Eigen::SparseMatrix<double>& m) : matrix(m) { klu_defaults(&common); }
  ~Klu() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  // KLU's interface takes its input without const, and leaves it alone.
  int* outer() const { return const_cast<int*>(matrix.outerIndexPtr()); }
  int* inner() const { return const_cast<int*>(matrix.innerIndexPtr()); }
  double* values() const { return const_cast<double*>(matrix.valuePtr()); }

  const Eigen::SparseMatrix<double>& matrix;
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
    const bool done = klu_refactor(k.outer(), k.inner(), k.values(), k.symbolic, k.numeric, &k.common) != 0;
    if (done && k.common.status == KLU_OK &&
        klu_rgrowth(k.outer(), k.inner(), k.values(), k.symbolic, k.numeric, &k.common) != 0 &&
        k.common.rgrowth > kSmallestGrowth)
      return true;
    forget();
  }
  k.numeric = klu_factor(k.outer(), k.inner(), k.values(), k.symbolic, &k.common);
  if (k.numeric == nullptr || k.common.status != KLU_OK) return false;
  return klu_rcond(k.symbolic, k.numeric, &k.common) != 0 && std::isfinite(k.common.rcond) && k.common.rcond > 0.0;
}

void SparseLu::solve(Eigen::Ref<Eigen::VectorXd> x) const {
  Klu& k = *klu_;
  if (k.matrix.rows() == 0) return;
  FOOTFALL_DEMAND(k.numeric != nullptr);
  klu_solve(k.symbolic, k.numeric, static_cast<int>(k.matrix.rows()), 1, x.data(), &k.common);
}

void SparseLu::forget() { klu_free_numeric(&klu_->numeric, &klu_->common); }

}  // namespace footfall

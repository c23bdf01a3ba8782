#pragma once
// Weighted root-mean-square norm of an error in y = [q; v; z; lambda]; multipliers carry no error of their
// own and do not count. The rate of a mode counts like its coordinate: an error atol of amplitude is an error
// omega atol of rate, and anything stricter would make the steps follow vibrations far below atol.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/integrator/integrator.h"

namespace footfall {

class ErrorNorm {
 public:
  ErrorNorm(const Equations& equations, const IntegratorOptions& options)
      : rtol_(options.rtol),
        atol_(Eigen::VectorXd::Constant(equations.layout().lambda0(), options.atol)),
        weight_(equations.layout().lambda0()) {
    const Layout& layout = equations.layout();
    atol_.segment(layout.v0(), layout.v_size).setConstant(options.atol_velocity);
    for (int i = 0; i < equations.model().body_count(); ++i) {
      const ModalBody* modal = equations.model().body(i).modal();
      const int first = layout.v0() + layout.body_v[static_cast<std::size_t>(i)] + 6;
      for (int k = 0; k < equations.model().body(i).mode_count(); ++k)  // modes of unit mass: stiffness omega^2
        atol_[first + k] = std::max(options.atol_velocity, options.atol * std::sqrt(modal->stiffness(k)));
    }
    weight_ = atol_.cwiseInverse();
  }
  // Weights 1 / (rtol |y| + atol).
  void set(const Eigen::Ref<const Eigen::VectorXd>& y) {
    weight_ = (rtol_ * y.head(weight_.size()).cwiseAbs() + atol_).cwiseInverse();
  }
  double operator()(const Eigen::Ref<const Eigen::VectorXd>& x) const {
    if (weight_.size() == 0) return 0.0;
    return std::sqrt(x.head(weight_.size()).cwiseProduct(weight_).squaredNorm() /
                     static_cast<double>(weight_.size()));
  }
  // The entry that counts most; not finite counts most of all.
  int worst(const Eigen::Ref<const Eigen::VectorXd>& x) const {
    int worst = 0;
    double largest = -1.0;
    for (Eigen::Index i = 0; i < weight_.size(); ++i) {
      const double size = std::abs(x[i]) * weight_[i];
      if (!std::isfinite(size)) return static_cast<int>(i);
      if (size > largest) {
        largest = size;
        worst = static_cast<int>(i);
      }
    }
    return worst;
  }
  const Eigen::VectorXd& absolute() const { return atol_; }

 private:
  double rtol_;
  Eigen::VectorXd atol_, weight_;
};

}  // namespace footfall

#pragma once
// Weighted root-mean-square norm of an error in y = [q; v; z; lambda]; multipliers are not counted.

#include <Eigen/Dense>
#include <cmath>

#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/integrator/integrator.h"

namespace footfall {

class ErrorNorm {
 public:
  ErrorNorm(const Layout& layout, const IntegratorOptions& options)
      : rtol_(options.rtol),
        atol_(Eigen::VectorXd::Constant(layout.lambda0(), options.atol)),
        weight_(layout.lambda0()) {
    atol_.segment(layout.v0(), layout.v_size).setConstant(options.atol_velocity);
    weight_ = atol_.cwiseInverse();
  }
  // Weights 1 / (rtol |y| + atol).
  void set(const Eigen::Ref<const Eigen::VectorXd>& y) {
    weight_ = (rtol_ * y.head(weight_.size()).cwiseAbs() + atol_).cwiseInverse();
  }
  double operator()(const Eigen::Ref<const Eigen::VectorXd>& x) const {
    if (weight_.size() == 0) return 0.0;
    return std::sqrt(x.head(weight_.size()).cwiseProduct(weight_).squaredNorm() / static_cast<double>(weight_.size()));
  }
  // A projection that moves y by x has met a singular position: there a small drift is far from consistent positions and
  // velocities, and removing it would remove energy. Usual drift, accumulated over many steps, is smaller.
  bool far(const Eigen::Ref<const Eigen::VectorXd>& x) const {
    constexpr double kTolerances = 1e3, kLeast = 1e-6;  // [-]; [m, rad, m/s, rad/s]
    return (*this)(x) > kTolerances && x.head(weight_.size()).lpNorm<Eigen::Infinity>() > kLeast;
  }
  // The entry with the largest weighted error; the first that is not finite.
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

#include "mbd_solver/coupling/fast_modes.h"

#include <cmath>

namespace footfall {

void slow_down_fast_modes(const BodyMotion& before, const Eigen::VectorXd& stiffness, double H, BodyMotion& motion) {
  for (Eigen::Index i = 0; i < motion.da.size(); ++i) {
    const double Omega = std::sqrt(stiffness[i]), theta = Omega * H;
    if (!(theta > 0.01)) continue;  // weight below 1e-8
    const double offset = before.dda[i] / stiffness[i];
    const double rate =
        2.0 / H * (offset * (1.0 - std::sin(theta) / theta) + before.da[i] * (1.0 - std::cos(theta)) / (Omega * theta));
    const double fourth = std::pow(theta, 4), weight = fourth / (1.0 + fourth);
    motion.da[i] += weight * (rate - motion.da[i]);
    motion.dda[i] *= 1.0 - weight;
  }
}

}  // namespace footfall

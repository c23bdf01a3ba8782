#include "coupler/schemes/constant_load.h"

#include "coupler/load_average.h"
#include "coupler/messages.h"

namespace footfall {

double ConstantLoadScheme::pending_work(const AnsweredLoads& loads, const PredictedPath& path,
                                        const BodyMotion& computed) const {
  const MeanLoad &mean = loads.load.mean, &before = loads.before;
  // Means stand for the windows' middles.
  const double share = loads.ratio / (1.0 + loads.ratio);
  Vector6d force;
  force << mean.F_W + share * (mean.F_W - before.F_W),
      computed.rotation() * (mean.T_B + share * (mean.T_B - before.T_B));
  return force.dot(path.gap(computed));
}

MapState ConstantLoadScheme::window_map(double omega_h, int n, const MapState& z) const {
  const double K = omega_h * omega_h, x = z[0], v = z[1], a = z[2], gap = z[3] - z[0];
  const double velocity = path_degree() >= 1 ? v : 0.0, acceleration = path_degree() >= 2 ? a : 0.0;
  // What the mean has more of the end than the trapezoid: mean f = trapezoid + end_step (f(1) - f(0)).
  const double end_step = 0.5 * (weights().closing - weights().opening) / n;
  const double mean_tau = 0.5 + end_step, mean_tau2 = 1.0 / 3.0 + 1.0 / (6.0 * n * n) + end_step,
               mean_g = 0.5 / (1.0 * n * n) - end_step;
  // A boundary that jumps does so after the force that opens the window.
  const double standing = continuous_path() ? mean_g : 0.5 / n;
  const double f = -K * (x + mean_tau * velocity + 0.5 * mean_tau2 * acceleration + standing * gap);
  MapState out;
  out << x + v + 0.5 * f, v + f, f, x + velocity + 0.5 * acceleration, velocity + acceleration + 2.0 * gap;
  return out;
}

}  // namespace footfall

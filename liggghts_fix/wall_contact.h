#pragma once
// How stiff and how damped a grain's contact with a stock mesh is: LIGGGHTS applies the law, and the multibody side
// asks for its slopes. No LIGGGHTS headers.

#include <Eigen/Dense>

#include "liggghts_fix/contact_slope.h"

namespace footfall {

struct ElasticConstants {
  double young = 0.0;    // E [Pa]
  double poisson = 0.0;  // nu [-]
};

// Constants of one grain type against the wall: of Hertz-Mindlin, or of a linear spring when the script has kn (model
// hooke/stiffness; for hertz/stiffness, kn is more than the stiffness at any overlap below 1 / radius). Hertz-Mindlin
// as in LIGGGHTS, with s = sqrt(radius overlap) and the grain's mass m:
//   k_n = 2 E* s,   k_t = 8 G* s,   c = damping sqrt(k m).
struct WallContact {
  double young = 0.0;                                       // E* [Pa]
  double shear = 0.0;                                       // G* [Pa]
  double damping = 0.0;                                     // -2 sqrt(5/6) beta [-]
  double friction = 0.0;                                    // [-]
  double linear = 0.0, linear_shear = 0.0;                  // kn, kt [N/m]; 0: Hertz-Mindlin
  double linear_damping = 0.0, linear_shear_damping = 0.0;  // gamma_n, gamma_t, per mass of the grain [1/s]

  // Along the normal, s in [m] [N/m].
  double stiffness(double s) const { return linear > 0.0 ? linear : 2.0 * young * s; }
  // Of the contact that presses with f_W [N] on a body whose normal there is normal_W; mass of the grain in [kg].
  ContactSlope slope(const Eigen::Vector3d& normal_W, const Eigen::Vector3d& f_W, double s, double mass) const;
};

// E* and G* of two materials:
//   1/E* = sum of (1 - nu^2) / E,   1/G* = sum of 2 (2 - nu) (1 + nu) / E.
WallContact hertz_mindlin(const ElasticConstants& grain, const ElasticConstants& wall);

// -2 sqrt(5/6) beta of the coefficient of restitution e, with beta = ln e / sqrt(ln^2 e + pi^2).
double damping_of_restitution(double e);

}  // namespace footfall

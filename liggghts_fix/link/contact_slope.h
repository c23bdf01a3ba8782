#pragma once
// Stiffness and damping of a grain's contact with a body. LIGGGHTS applies the contact law; linearly implicit schemes
// also need its slopes, projected on the body.

#include <Eigen/Dense>

#include "coupler/messages.h"

namespace footfall {

// Stiffness [N/m] and damping [N s/m] along the normal and across it (across: 0 while the contact slides).
struct ContactSlope {
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();
  double stiffness = 0.0, shear_stiffness = 0.0;
  double damping = 0.0, shear_damping = 0.0;
};

// Adds the slope of a contact at rho_W [m] from Bo to the tangent of the body.
void add_slope(const ContactSlope& slope, const Eigen::Vector3d& rho_W, ContactTangent& sum);

struct ElasticConstants {
  double young = 0.0;    // E [Pa]
  double poisson = 0.0;  // nu [-]
};

// Constants of one grain type against a wall: of Hertz-Mindlin, or of a linear spring when the script has kn (model
// hooke/stiffness; for hertz/stiffness, kn exceeds the stiffness at any overlap below 1 / radius). Hertz-Mindlin as in
// LIGGGHTS, with s = sqrt(radius overlap) and the grain's mass m:
//   k_n = 2 E* s,   k_t = 8 G* s,   c = damping sqrt(k m).
struct WallContact {
  double young = 0.0;                                       // E* [Pa]
  double shear = 0.0;                                       // G* [Pa]
  double damping = 0.0;                                     // -2 sqrt(5/6) beta [-]
  double friction = 0.0;                                    // [-]
  double linear = 0.0, linear_shear = 0.0;                  // kn, kt [N/m]; 0: Hertz-Mindlin
  double linear_damping = 0.0, linear_shear_damping = 0.0;  // gamma_n, gamma_t, per mass of the grain [1/s]

  // Along the normal [N/m]; s in [m].
  double stiffness(double s) const { return linear > 0.0 ? linear : 2.0 * young * s; }
  // The slope of a contact with force f_W [N] on a body, whose normal there is normal_W; mass of the grain in [kg].
  ContactSlope slope(const Eigen::Vector3d& normal_W, const Eigen::Vector3d& f_W, double s, double mass) const;
};

// E* and G* of two materials:
//   1/E* = sum of (1 - nu^2) / E,   1/G* = sum of 2 (2 - nu) (1 + nu) / E.
WallContact hertz_mindlin(const ElasticConstants& grain, const ElasticConstants& wall);

// -2 sqrt(5/6) beta of the coefficient of restitution e, with beta = ln e / sqrt(ln^2 e + pi^2).
double damping_of_restitution(double e);

}  // namespace footfall

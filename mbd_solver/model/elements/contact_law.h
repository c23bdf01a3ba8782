#pragma once
// The contact law of a point, the same for planes, meshes and bodies (theory 6.4): Hertz with Hunt-Crossley damping along
// the normal, Coulomb friction with a spring xi that prevents creep.
//   f_n = k delta^1.5 g(d delta'),  g(u) = 1 + u for u >= 0, exp(u) for u < 0
//   f_t = -mu f_n u / sqrt(u^2 + v_s^2),  u = v_t + xi / tau,  xi' = clip(u) - xi / tau

#include <Eigen/Dense>
#include <cmath>
#include <string>

namespace footfall {

// d [s/m] for restitution e in (0, 1] at impact speed [m/s] > 0. Throws InputError outside.
double contact_damping_for_restitution(double e, double impact_speed);

// Creep speed on a slope [rad] without springs [m/s]: mu v / sqrt(v^2 + v_s^2) = tan slope gives
// v = v_s tan slope / sqrt(mu^2 - tan^2 slope). Infinite if it slides, tan slope >= mu.
double creep_speed(double mu, double slip_speed, double slope);

struct ContactLaw {
  static constexpr double kStretch = 10.0;  // |clip(u)| / v_s at most: u there gives 99.5 % of mu f_n

  double stiffness = 0.0;    // k of each point [N/m^1.5] > 0
  double damping = 0.0;      // d [s/m] >= 0
  double friction = 0.3;     // mu >= 0
  double slip_speed = 1e-3;  // v_s [m/s] > 0: |u| at which friction is 71 % of mu f_n
  double stick_time = 0.01;  // tau [s] >= 0; 0: no springs

  // Throws InputError on values outside their range; the message begins with `where`.
  void check(const std::string& where) const;

  struct Clipped {
    Eigen::Vector3d value;
    Eigen::Matrix3d slope;
  };
  // clip(u) = u where |u| <= 10 v_s, else 10 v_s u / |u|, and its derivative.
  Clipped clip(const Eigen::Vector3d& u) const;
  // The value alone, of a vector in space or along two tangents.
  template <class Vector>
  Vector clipped(const Vector& u) const {
    const double size = u.norm(), most = kStretch * slip_speed;
    if (size <= most) return u;
    return most * (u / size);
  }

  struct Normal {
    double elastic = 0.0;     // k delta^1.5 [N]
    double force = 0.0;       // f_n [N]
    double by_overlap = 0.0;  // d f_n / d delta
    double by_closing = 0.0;  // d f_n / d delta'
  };
  Normal normal_force(double overlap, double closing) const;  // delta > 0 [m], delta' [m/s]
};

}  // namespace footfall

#pragma once
// Springs of struts: the one-sided spring inside end stops and honeycomb cartridges, the linear spring with damper, and
// end stops.

#include <cmath>
#include <optional>

#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

// A spring that only pushes, once continuously differentiable:
//   force(d) = 0                        d <= 0
//            = k d^2 / (2 toe)          0 < d < toe
//            = k (d - toe/2)            d >= toe
// The toe replaces the kink of k max(0, d), so that the stiffness does not jump when a gap closes. Beyond the toe the
// force equals the force of a spring which starts toe/2 later.
struct OneSidedSpring {
  double stiffness;  // k > 0 [N/m]
  double toe;        // > 0 [m]

  // Force at penetration d [N], >= 0.
  double force(double d) const {
    if (d <= 0.0) return 0.0;
    return d < toe ? 0.5 * stiffness * d * d / toe : stiffness * (d - 0.5 * toe);
  }
  // d(force)/dd [N/m], >= 0.
  double slope(double d) const {
    if (d <= 0.0) return 0.0;
    return d < toe ? stiffness * d / toe : stiffness;
  }
  // Integral of the force from 0 to d [J], >= 0.
  double energy(double d) const {
    if (d <= 0.0) return 0.0;
    if (d < toe) return stiffness * d * d * d / (6.0 * toe);
    const double past = d - toe;
    return stiffness * (toe * toe / 6.0 + 0.5 * toe * past + 0.5 * past * past);
  }
  // The penetration at a given force >= 0 [m]: the inverse of force().
  double penetration(double f) const {
    if (f <= 0.0) return 0.0;
    const double at_toe = 0.5 * stiffness * toe;
    return f < at_toe ? std::sqrt(2.0 * toe * f / stiffness) : f / stiffness + 0.5 * toe;
  }
};

// F = preload + k (x - free_stroke) + c v. Stored: k (x - free_stroke)^2 / 2 + preload (x - free_stroke).
// Dissipated: c v^2.
struct LinearSpringDamperParameters {
  double stiffness = 0.0;    // k >= 0 [N/m]
  double damping = 0.0;      // c >= 0 [N s/m]
  double free_stroke = 0.0;  // stroke at which the spring's force is the preload [m]
  double preload = 0.0;      // force at free_stroke, compression positive [N]
};

class LinearSpringDamper final : public StrutLaw {
 public:
  // Throws InputError for a value out of range, or if the law has neither spring, damper nor preload.
  explicit LinearSpringDamper(const LinearSpringDamperParameters& parameters);

  std::string_view kind() const override { return "linear_spring_damper"; }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override;
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kDamper >= 0

 private:
  LinearSpringDamperParameters parameters_;
};

// End stops: a stiff one-sided spring with damping past either limit of the stroke. At the upper limit, with
// d = x - largest_stroke and g of OneSidedSpring:
//
//   F = g(d) h(chi dd/dt),   h(s) = 1 + s for s >= 0, exp(s) for s < 0
//
// h is C1 and positive: the damping follows the contact force (Hunt and Crossley 1975) and never pulls. At the lower limit the same with d = smallest_stroke - x, and F
// counted negative (tension). Stored: the spring's energy. Dissipated: g(d) (h - 1) dd/dt >= 0.
struct EndStopParameters {
  // At least one of the two limits is required.
  std::optional<double> smallest_stroke;  // lower limit (extended end); default none [m]
  std::optional<double> largest_stroke;   // upper limit (compressed end); default none [m]
  double stiffness = 5.0e6;               // > 0 [N/m]
  double dissipation = 1.0;               // chi >= 0: at approach speed v the force is (1 + chi v) g [s/m]
  double toe = 5.0e-4;                    // smoothing penetration > 0 [m]
};

class EndStop final : public StrutLaw {
 public:
  explicit EndStop(const EndStopParameters& parameters);  // throws InputError for a value out of range

  std::string_view kind() const override { return "end_stop"; }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override;
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kStop >= 0

  // Deflection of the stop under a static force [m]: smallest_stroke = + penetration(F0) holds a gas preload F0 at
  // x = 0.
  double penetration(double force) const { return spring_.penetration(force); }
  const EndStopParameters& parameters() const { return parameters_; }

 private:
  EndStopParameters parameters_;
  OneSidedSpring spring_;
};

// The gas chamber of a strut [Lin25 13; sign of V: theory 9]:
//
//   F = A_p P0 (V0 / (V0 - A_p x))^n,   A_p = pi d_p^2 / 4
//
// Valid for x < V0 / A_p; the chamber expands for x < 0. The force at x = 0 is A_p P0: an end stop must hold the
// extended strut.
struct GasSpringParameters {
  double piston_diameter = 0.045;   // d_p > 0 [m] (assumed; not given in [Lin25])
  double initial_pressure = 1.0e6;  // P0 > 0, absolute, at x = 0 [Pa] [Lin25 Table 3]
  double initial_volume = 5.53e-4;  // V0 > 0, at x = 0 [m3] [Lin25 Table 3]
  double exponent = 1.1;            // n >= 1 (1 isothermal, 1.1 [Lin25 13], 1.4 adiabatic nitrogen) [-]
  // Largest stroke that the stops allow, checked against V0 / A_p [m]
  std::optional<double> largest_stroke;
};

class GasSpring final : public StrutLaw {
 public:
  // Throws InputError for a value out of range, or if largest_stroke uses up the gas volume.
  explicit GasSpring(const GasSpringParameters& parameters);

  std::string_view kind() const override { return "gas_spring"; }
  // Throws NumericalError if stroke >= stroke_limit().
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  // Work of the gas from x = 0 in closed form [J]: P0 V0 / (n - 1) ((V0 / V)^(n-1) - 1), or P0 V0 ln(V0 / V)
  // for n = 1. Negative for x < 0. Throws as evaluate does.
  double stored_energy(const StrutInput& in) const override;
  Stored stored_kind() const override { return Stored::kGas; }
  void dissipated_power(const StrutInput&, std::vector<StrutPower>&) const override {}  // none

  double piston_area() const { return area_; }                                // A_p [m2]
  double stroke_limit() const { return parameters_.initial_volume / area_; }  // V0 / A_p [m]
  const GasSpringParameters& parameters() const { return parameters_; }

 private:
  double volume(double stroke) const;  // V [m3]

  GasSpringParameters parameters_;
  double area_;  // [m2]
};

}  // namespace footfall

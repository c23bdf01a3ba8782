#pragma once
// The gas chamber of a strut [Lin25 13; sign of V: theory 9]:
//
//   F = A_p P0 (V0 / (V0 - A_p x))^n,   A_p = pi d_p^2 / 4
//
// Valid for x < V0 / A_p; the chamber expands for x < 0. The force at x = 0 is A_p P0: an end stop must hold the
// extended strut.

#include <optional>

#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

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

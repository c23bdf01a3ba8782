#pragma once
// End stops: a stiff one-sided spring with damping past either limit of the stroke. At the upper limit, with
// d = x - largest_stroke and g of one_sided_spring.h:
//
//   F = g(d) h(chi dd/dt),   h(s) = 1 + s for s >= 0, exp(s) for s < 0
//
// h is C1 and positive: the damping follows the contact force (Hunt and Crossley 1975) and never pulls,
// however fast the strut leaves the stop. At the lower limit the same with d = smallest_stroke - x, and F
// counted negative (tension). Stored: the spring's energy. Dissipated: g(d) (h - 1) dd/dt >= 0.

#include <optional>

#include "mbd_solver/model/laws/one_sided_spring.h"
#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

struct EndStopParameters {
  // At least one of the two limits is needed.
  std::optional<double> smallest_stroke;  // lower limit (extended end); not given: none [m]
  std::optional<double> largest_stroke;   // upper limit (compressed end); not given: none [m]
  double stiffness = 5.0e6;               // > 0 [N/m]
  double dissipation = 1.0;               // chi >= 0: approached at speed v, the force is 1 + chi v times g [s/m]
  double toe = 5.0e-4;                    // smoothing penetration > 0 [m]
};

class EndStop final : public StrutLaw {
 public:
  explicit EndStop(const EndStopParameters& parameters);  // throws InputError for a value out of its range

  std::string_view kind() const override { return "end_stop"; }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override;
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kStop >= 0

  // How far the stop yields under a static force [m]: a stop that shall hold the gas preload F0 exactly at x
  // = 0 sits at smallest_stroke = + penetration(F0).
  double penetration(double force) const { return spring_.penetration(force); }
  const EndStopParameters& parameters() const { return parameters_; }

 private:
  EndStopParameters parameters_;
  OneSidedSpring spring_;
};

}  // namespace footfall

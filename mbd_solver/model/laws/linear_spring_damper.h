#pragma once
// F = preload + k (x - free_stroke) + c v. Stored: k (x - free_stroke)^2 / 2 + preload (x - free_stroke).
// Dissipated: c v^2.

#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

struct LinearSpringDamperParameters {
  double stiffness = 0.0;    // k >= 0 [N/m]
  double damping = 0.0;      // c >= 0 [N s/m]
  double free_stroke = 0.0;  // stroke at which the spring's force is the preload [m]
  double preload = 0.0;      // force at free_stroke, compression positive [N]
};

class LinearSpringDamper final : public StrutLaw {
 public:
  // Throws InputError for a value out of its range, or if the law has neither spring, damper nor preload.
  explicit LinearSpringDamper(const LinearSpringDamperParameters& parameters);

  std::string_view kind() const override { return "linear_spring_damper"; }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override;
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kDamper >= 0

 private:
  LinearSpringDamperParameters parameters_;
};

}  // namespace footfall

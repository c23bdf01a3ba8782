#pragma once
// Linear elastic, isotropic material.

namespace footfall {

struct Material {
  double density = 0.0;  // [kg/m3] > 0
  double young = 0.0;    // [Pa] > 0
  double poisson = 0.3;  // [-] in (-1, 0.5)

  double shear_modulus() const { return young / (2.0 * (1.0 + poisson)); }  // [Pa]
};

// Throws InputError, naming the quantity and its valid range.
void check(const Material& material);

}  // namespace footfall

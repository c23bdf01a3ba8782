#pragma once
// Linear elastic, isotropic material, and cross sections of beams. Section axes y, z are the element's; the beam runs
// along x.

#include <Eigen/Dense>
#include <array>

namespace footfall {

struct Material {
  double density = 0.0;  // [kg/m3] > 0
  double young = 0.0;    // [Pa] > 0
  double poisson = 0.3;  // [-] in (-1, 0.5)

  double shear_modulus() const { return young / (2.0 * (1.0 + poisson)); }  // [Pa]
};

// Throws InputError, naming the quantity and its valid range.
void check(const Material& material);

struct BeamSection {
  double area = 0.0;             // [m2]
  double bending_y = 0.0;        // Iy: second moment of area about y, resists bending in the xz plane [m4]
  double bending_z = 0.0;        // Iz [m4]
  double torsion = 0.0;          // torsion constant; Iy + Iz for round sections only [m4]
  double torsion_modulus = 0.0;  // W: largest shear stress of torsion = torque / W [m3]
  // Points of bending stress: (y, z) of four points on the outer fibre [m].
  std::array<Eigen::Vector2d, 4> fibres{};
};

// All lengths in m; all throw InputError on values that are no section.
BeamSection tube_section(double outer_diameter, double wall);
BeamSection rod_section(double diameter);
// Any section: radius is the distance of the outer fibre from the axis, for stresses only; shear stress is
// torque radius / torsion.
BeamSection general_section(double area, double bending_y, double bending_z, double torsion, double radius);

}  // namespace footfall

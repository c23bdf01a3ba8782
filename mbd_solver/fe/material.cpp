// Section constants in closed form; torsion of rectangles by Saint-Venant's series.

#include "mbd_solver/fe/material.h"

#include <cmath>
#include <locale>
#include <sstream>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/pi.h"

namespace footfall {

void check(const Material& material) {
  std::ostringstream message;
  message.imbue(std::locale::classic());
  if (!(material.density > 0.0) || !std::isfinite(material.density))
    message << "material: density is " << material.density << " kg/m3, expected a positive number. ";
  if (!(material.young > 0.0) || !std::isfinite(material.young))
    message << "material: Young's modulus is " << material.young << " Pa, expected a positive number. ";
  if (!(material.poisson > -1.0 && material.poisson < 0.5))
    message << "material: Poisson's ratio is " << material.poisson << ", expected a number between -1 and 0.5. ";
  if (!message.str().empty()) throw InputError(code::kParameterOutOfRange, message.str());
}

namespace {

void require_positive_constant(double value, const char* what) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw InputError(code::kParameterOutOfRange, std::string("beam section: ") + what + " is " + plain_text(value) +
                                                     ", expected a positive number.");
}

std::array<Eigen::Vector2d, 4> round_fibres(double radius) {
  return {Eigen::Vector2d(radius, 0.0), Eigen::Vector2d(0.0, radius), Eigen::Vector2d(-radius, 0.0),
          Eigen::Vector2d(0.0, -radius)};
}

// Ring between the radii inner and outer.
BeamSection ring(double inner, double outer) {
  BeamSection section;
  section.area = kPi * (outer * outer - inner * inner);
  section.bending_y = section.bending_z = kPi / 4.0 * (std::pow(outer, 4) - std::pow(inner, 4));
  section.torsion = 2.0 * section.bending_y;
  section.torsion_modulus = section.torsion / outer;
  section.fibres = round_fibres(outer);
  return section;
}

}  // namespace

BeamSection tube_section(double outer_diameter, double wall) {
  require_positive_constant(outer_diameter, "outer diameter [m]");
  require_positive_constant(wall, "wall [m]");
  if (2.0 * wall >= outer_diameter)
    throw InputError(code::kParameterOutOfRange, "beam section: wall is " + plain_text(wall) +
                                                     " m, expected less than half the outer diameter of " +
                                                     plain_text(outer_diameter) + " m. For a solid section use a rod.");
  return ring(0.5 * outer_diameter - wall, 0.5 * outer_diameter);
}

BeamSection rod_section(double diameter) {
  require_positive_constant(diameter, "diameter [m]");
  return ring(0.0, 0.5 * diameter);
}

BeamSection general_section(double area, double bending_y, double bending_z, double torsion, double radius) {
  require_positive_constant(area, "area [m2]");
  require_positive_constant(bending_y, "second moment of area about y [m4]");
  require_positive_constant(bending_z, "second moment of area about z [m4]");
  require_positive_constant(torsion, "torsion constant [m4]");
  require_positive_constant(radius, "radius of the outer fibre [m]");
  BeamSection section;
  section.area = area;
  section.bending_y = bending_y;
  section.bending_z = bending_z;
  section.torsion = torsion;
  section.torsion_modulus = torsion / radius;
  section.fibres = round_fibres(radius);
  return section;
}

}  // namespace footfall

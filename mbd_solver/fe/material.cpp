// Section constants in closed form; torsion of rectangles by Saint-Venant's series.

#include "mbd_solver/fe/material.h"

#include <algorithm>
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

// Saint-Venant, long side a, short side b, twist rate g, sums over odd n:
//   torque / (G g) = a b^3/3 (1 - 192 b/(pi^5 a) sum tanh(n pi a/(2b)) / n^5)
//   tau_max / (G g) = b (1 - 8/pi^2 sum 1 / (n^2 cosh(n pi a/(2b))))   in the middle of the long side
BeamSection rectangle_section(double width, double height) {
  require_positive_constant(width, "width [m]");
  require_positive_constant(height, "height [m]");
  BeamSection section;
  section.area = width * height;
  section.bending_y = width * std::pow(height, 3) / 12.0;
  section.bending_z = height * std::pow(width, 3) / 12.0;
  const double a = std::max(width, height);
  const double b = std::min(width, height);
  double twist = 0.0;
  double shear = 0.0;
  for (int n = 1; n < 200; n += 2) {
    const double x = std::min(n * kPi * a / (2.0 * b), 700.0);  // cosh must not overflow
    twist += std::tanh(x) / std::pow(n, 5);
    shear += 1.0 / (n * n * std::cosh(x));
  }
  section.torsion = a * b * b * b / 3.0 * (1.0 - 192.0 * b / (std::pow(kPi, 5) * a) * twist);
  section.torsion_modulus = section.torsion / (b * (1.0 - 8.0 / (kPi * kPi) * shear));
  const double y = 0.5 * width;
  const double z = 0.5 * height;
  section.fibres = {Eigen::Vector2d(y, z), Eigen::Vector2d(-y, z), Eigen::Vector2d(-y, -z), Eigen::Vector2d(y, -z)};
  return section;
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

#include "mbd_solver/fe/material.h"

#include <cmath>
#include <sstream>

#include "coupler/base/errors.h"

namespace footfall {

void check(const Material& material) {
  std::ostringstream message;
  if (!(material.density > 0.0) || !std::isfinite(material.density))
    message << "material: density is " << material.density << " kg/m3, expected a positive number. ";
  if (!(material.young > 0.0) || !std::isfinite(material.young))
    message << "material: Young's modulus is " << material.young << " Pa, expected a positive number. ";
  if (!(material.poisson > -1.0 && material.poisson < 0.5))
    message << "material: Poisson's ratio is " << material.poisson << ", expected a number between -1 and 0.5. ";
  if (!message.str().empty()) throw InputError(message.str());
}

}  // namespace footfall

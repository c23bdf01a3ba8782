#include "liggghts_fix/beam_hertz.h"

#include <cmath>

namespace footfall {

double hertz_on_side(double r, double R) {
  const double ratio = 1.0 + r / R;  // of the principal radii
  const double F2 = 1.0 - std::pow(std::pow(ratio, 0.0684) - 1.0, 1.531);
  return std::pow(ratio, -0.25) * std::pow(F2, -1.5);
}

double hertz_on_end(double r, double R) { return std::sqrt(R / (r + R)); }

}  // namespace footfall

// Polytropic gas in closed form: force, slope and work from the volume that is left.

#include "mbd_solver/model/laws/gas_spring.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {

GasSpring::GasSpring(const GasSpringParameters& parameters)
    : parameters_(parameters), area_(0.25 * kPi * parameters.piston_diameter * parameters.piston_diameter) {
  require_positive(kind(), "piston_diameter", parameters.piston_diameter, "m");
  require_positive(kind(), "initial_pressure", parameters.initial_pressure, "Pa");
  require_positive(kind(), "initial_volume", parameters.initial_volume, "m3");
  require_within(kind(), "exponent", parameters.exponent, 1.0, 2.0, "");
  if (parameters.largest_stroke && !(*parameters.largest_stroke < stroke_limit()))
    throw InputError(code::kGasUsedUp,
                     "gas_spring: a stroke of " + number_text(*parameters.largest_stroke) +
                         " m uses up the gas volume (limit V0 / A_p = " + number_text(stroke_limit()) +
                         " m). Add an end stop before it, increase initial_volume, or reduce piston_diameter.");
}

double GasSpring::volume(double stroke) const {
  const double v = parameters_.initial_volume - area_ * stroke;
  if (!(v > 0.0))  // also catches a stroke that is not a number
    throw NumericalError(code::kGasUsedUp,
                         "gas_spring: stroke " + number_text(stroke) + " m uses up the gas volume (limit V0 / A_p = " +
                             number_text(stroke_limit()) + " m). Give the strut an earlier or stiffer end stop.");
  return v;
}

void GasSpring::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  const double v = volume(in.stroke);
  const double n = parameters_.exponent;
  out.force = area_ * parameters_.initial_pressure * std::pow(parameters_.initial_volume / v, n);
  out.dforce_dstroke = n * area_ * out.force / v;
}

double GasSpring::stored_energy(const StrutInput& in) const {
  const double log_ratio = std::log(parameters_.initial_volume / volume(in.stroke));
  const double work0 = parameters_.initial_pressure * parameters_.initial_volume;
  const double m = parameters_.exponent - 1.0;
  // expm1 keeps all digits for n close to 1, where the formula becomes the logarithm.
  return m > 0.0 ? work0 * std::expm1(m * log_ratio) / m : work0 * log_ratio;
}

}  // namespace footfall

// Closed forms of force, slope, energy and dissipation.

#include "mbd_solver/model/laws/springs.h"

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {

LinearSpringDamper::LinearSpringDamper(const LinearSpringDamperParameters& parameters) : parameters_(parameters) {
  require_not_negative(kind(), "stiffness", parameters.stiffness, "N/m");
  require_not_negative(kind(), "damping", parameters.damping, "N s/m");
  require_finite(kind(), "free_stroke", parameters.free_stroke, "m");
  require_finite(kind(), "preload", parameters.preload, "N");
  if (parameters.stiffness == 0.0 && parameters.damping == 0.0 && parameters.preload == 0.0)
    throw InputError(
        code::kParametersDisagree,
        "linear_spring_damper: stiffness, damping and preload are all 0; give at least one, or leave the law out.");
}

void LinearSpringDamper::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  const LinearSpringDamperParameters& p = parameters_;
  out.force = p.preload + p.stiffness * (in.stroke - p.free_stroke) + p.damping * in.rate;
  out.dforce_dstroke = p.stiffness;
  out.dforce_drate = p.damping;
}

double LinearSpringDamper::stored_energy(const StrutInput& in) const {
  const double d = in.stroke - parameters_.free_stroke;
  return (0.5 * parameters_.stiffness * d + parameters_.preload) * d;
}

void LinearSpringDamper::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  out.push_back({Dissipation::kDamper, parameters_.damping * in.rate * in.rate});
}

namespace {

// h(s) = 1 + s, exp(s) below 0: C1, positive, (h - 1) s >= 0.
double damping_factor(double s) { return s >= 0.0 ? 1.0 + s : std::exp(s); }
double damping_slope(double s) { return s >= 0.0 ? 1.0 : std::exp(s); }

}  // namespace

EndStop::EndStop(const EndStopParameters& parameters)
    : parameters_(parameters), spring_{parameters.stiffness, parameters.toe} {
  require_positive(kind(), "stiffness", parameters.stiffness, "N/m");
  require_not_negative(kind(), "dissipation", parameters.dissipation, "s/m");
  require_positive(kind(), "toe", parameters.toe, "m");
  if (!parameters.smallest_stroke && !parameters.largest_stroke)
    throw InputError(
        code::kParametersDisagree,
        "end_stop: neither smallest_stroke nor largest_stroke is given; give at least one, or leave the end stop out.");
  if (parameters.smallest_stroke) require_finite(kind(), "smallest_stroke", *parameters.smallest_stroke, "m");
  if (parameters.largest_stroke) require_finite(kind(), "largest_stroke", *parameters.largest_stroke, "m");
  if (parameters.smallest_stroke && parameters.largest_stroke &&
      !(*parameters.smallest_stroke < *parameters.largest_stroke))
    throw InputError(code::kParametersDisagree,
                     "end_stop: smallest_stroke " + number_text(*parameters.smallest_stroke) +
                         " m is not below largest_stroke " + number_text(*parameters.largest_stroke) +
                         " m; the strut could not move.");
}

void EndStop::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  const double chi = parameters_.dissipation;
  // The stop at one end: penetration d = sign (x - limit), force = sign g(d) h(chi sign v).
  const auto add = [&](double limit, double sign) {
    const double d = sign * (in.stroke - limit), s = chi * sign * in.rate;
    out.force += sign * spring_.force(d) * damping_factor(s);
    out.dforce_dstroke += spring_.slope(d) * damping_factor(s);
    out.dforce_drate += spring_.force(d) * chi * damping_slope(s);
  };
  if (parameters_.largest_stroke) add(*parameters_.largest_stroke, 1.0);
  if (parameters_.smallest_stroke) add(*parameters_.smallest_stroke, -1.0);
}

double EndStop::stored_energy(const StrutInput& in) const {
  double energy = 0.0;
  if (parameters_.largest_stroke) energy += spring_.energy(in.stroke - *parameters_.largest_stroke);
  if (parameters_.smallest_stroke) energy += spring_.energy(*parameters_.smallest_stroke - in.stroke);
  return energy;
}

void EndStop::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  double power = 0.0;
  const auto add = [&](double limit, double sign) {
    const double closing = sign * in.rate;
    power +=
        spring_.force(sign * (in.stroke - limit)) * (damping_factor(parameters_.dissipation * closing) - 1.0) * closing;
  };
  if (parameters_.largest_stroke) add(*parameters_.largest_stroke, 1.0);
  if (parameters_.smallest_stroke) add(*parameters_.smallest_stroke, -1.0);
  out.push_back({Dissipation::kStop, power});
}

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

#include "mbd_solver/model/laws/end_stop.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"
#include "coupler/base/text.h"

namespace footfall {
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
        "end_stop: neither smallest_stroke nor largest_stroke is given; expected at least one. Leave the end "
        "stop out if "
        "the strut has none.");
  if (parameters.smallest_stroke) require_finite(kind(), "smallest_stroke", *parameters.smallest_stroke, "m");
  if (parameters.largest_stroke) require_finite(kind(), "largest_stroke", *parameters.largest_stroke, "m");
  if (parameters.smallest_stroke && parameters.largest_stroke &&
      !(*parameters.smallest_stroke < *parameters.largest_stroke))
    throw InputError("end_stop: smallest_stroke " + number_text(*parameters.smallest_stroke) +
                     " m is not below largest_stroke " + number_text(*parameters.largest_stroke) +
                     " m; the strut could not move. Expected smallest_stroke < largest_stroke.");
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

}  // namespace footfall

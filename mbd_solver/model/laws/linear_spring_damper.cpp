#include "mbd_solver/model/laws/linear_spring_damper.h"

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"

namespace footfall {

LinearSpringDamper::LinearSpringDamper(const LinearSpringDamperParameters& parameters) : parameters_(parameters) {
  require_not_negative(kind(), "stiffness", parameters.stiffness, "N/m");
  require_not_negative(kind(), "damping", parameters.damping, "N s/m");
  require_finite(kind(), "free_stroke", parameters.free_stroke, "m");
  require_finite(kind(), "preload", parameters.preload, "N");
  if (parameters.stiffness == 0.0 && parameters.damping == 0.0 && parameters.preload == 0.0)
    throw InputError(
        "linear_spring_damper: stiffness, damping and preload are all 0; expected at least one of them. Give "
        "one, or leave "
        "the law out.");
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

}  // namespace footfall

#include "mbd_solver/integrator/integrator.h"

#include "coupler/errors.h"
#include "mbd_solver/integrator/ida.h"
#include "mbd_solver/integrator/one_step.h"

namespace footfall {

std::unique_ptr<Integrator> make_integrator(const std::string& kind, Equations& equations,
                                            const IntegratorOptions& options) {
  if (!(options.rtol > 0.0 && options.atol > 0.0 && options.atol_velocity > 0.0))
    throw InputError("the tolerances of the integrator must be positive.");
  if (kind == "one_step") return std::make_unique<OneStep>(equations, options);
  if (kind == "ida") return std::make_unique<Ida>(equations, options);
  throw InputError("unknown integrator \"" + kind + "\". Known integrators: one_step, ida.");
}

}  // namespace footfall

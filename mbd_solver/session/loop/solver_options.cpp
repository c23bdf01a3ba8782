// Orders of the one-step method follow from the length of windows, which are short with grains.

#include "mbd_solver/session/loop/solver_options.h"

#include "coupler/base/errors.h"

namespace footfall {
namespace {

// Without grains: third order for windows of one step, fifth order for longer ones, where it takes
// longer steps (window_order). With grains windows are short, and their own error is of second
// order.
int order_of(OneStepMethod method, bool with_grains) {
  switch (method) {
    case OneStepMethod::kAuto: return with_grains ? 2 : 3;
    case OneStepMethod::kTrBdf2: return 2;
    case OneStepMethod::kEsdirk3: return 3;
    case OneStepMethod::kEsdirk5: return 5;
  }
  FOOTFALL_DEMAND(false);
  return 0;
}

}  // namespace

Baumgarte baumgarte_of(const SolverSpec& spec) {
  if (spec.drift == DriftKind::kProjection) return {};
  return {spec.baumgarte_velocity, spec.baumgarte_position};
}

IntegratorOptions integrator_options(const SolverSpec& spec, bool with_grains) {
  IntegratorOptions options;
  options.order = order_of(spec.method, with_grains);
  if (spec.method == OneStepMethod::kAuto) {
    options.window_order = with_grains ? 3 : 5;
    if (!spec.error_control && !with_grains) options.order = 5;  // fixed steps: one order for all windows
  }
  options.rtol = spec.rtol;
  options.atol = spec.atol_position();
  options.atol_velocity = spec.atol_velocity();
  options.max_step = spec.max_step;
  options.error_control = spec.error_control;
  options.projection = spec.drift == DriftKind::kProjection;
  return options;
}

}  // namespace footfall

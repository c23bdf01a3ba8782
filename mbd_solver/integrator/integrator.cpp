// Statistics, work integrals, and the choice of an integrator by its name.

#include "mbd_solver/integrator/integrator.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/integrator/codes.h"
#include "mbd_solver/integrator/ida.h"
#include "mbd_solver/integrator/one_step.h"

namespace footfall {

void IntegratorStatistics::count(const Drift& drift) {
  drift_position = std::max(drift_position, drift.position_left);
  drift_velocity = std::max(drift_velocity, drift.velocity_left);
  removed_position = std::max(removed_position, drift.position);
  removed_velocity = std::max(removed_velocity, drift.velocity);
}

void IntegratorStatistics::add(const IntegratorStatistics& before, const IntegratorStatistics& now) {
  for (const auto part :
       {&IntegratorStatistics::steps, &IntegratorStatistics::rejected, &IntegratorStatistics::newton_failures,
        &IntegratorStatistics::residuals, &IntegratorStatistics::jacobians, &IntegratorStatistics::factorizations})
    this->*part += now.*part - before.*part;
  for (const auto part : {&IntegratorStatistics::drift_position, &IntegratorStatistics::drift_velocity,
                          &IntegratorStatistics::removed_position, &IntegratorStatistics::removed_velocity})
    this->*part = std::max(this->*part, now.*part);
  reported_error += now.reported_error - before.reported_error;
  summed_error += now.summed_error - before.summed_error;
}

namespace {

template <class Sums>  // State or WorkError
void add_powers(const EnergySample& at, double weight, Sums& sums) {
  for (std::size_t k = 0; k < sums.dissipated.by_kind.size(); ++k)
    sums.dissipated.by_kind[k] += weight * at.power.by_kind[k];
  sums.load_work += weight * at.load_power;
  for (std::size_t k = 0; k < sums.supplied.by_kind.size(); ++k)
    sums.supplied.by_kind[k] += weight * at.supplied.by_kind[k];
}

}  // namespace

void add_work(const EnergySample& at, double weight, State& state) { add_powers(at, weight, state); }
void add_work_error(const EnergySample& at, double weight, WorkError& error) { add_powers(at, weight, error); }

void add_step_error(const WorkError& step, WorkError& sum) {
  for (std::size_t k = 0; k < step.dissipated.by_kind.size(); ++k)
    sum.dissipated.by_kind[k] += std::abs(step.dissipated.by_kind[k]);
  for (std::size_t k = 0; k < step.supplied.by_kind.size(); ++k)
    sum.supplied.by_kind[k] += std::abs(step.supplied.by_kind[k]);
  sum.load_work += step.load_work.cwiseAbs();
  sum.scale += step.scale;
}

double size_of_powers(const EnergySample& at) {
  double sum = at.load_power.lpNorm<1>();
  for (const double power : at.power.by_kind) sum += std::abs(power);
  for (const double power : at.supplied.by_kind) sum += std::abs(power);
  return sum;
}

void Integrator::advance(State& state, double t_end, const Inputs& inputs, const Rows& rows) {
  begin(state, t_end, inputs, {rows.next ? &rows.next : nullptr, rows.on_step != nullptr});
  for (WindowStop stop = next(); stop.kind != WindowStop::kEnd; stop = next())
    if (!(stop.step ? rows.on_step(*stop.step) : rows.on_row(*stop.state, *stop.rates))) end_window();
}

std::unique_ptr<Integrator> make_integrator(const std::string& kind, Equations& equations,
                                            const IntegratorOptions& options) {
  if (!(options.rtol > 0.0 && options.atol > 0.0 && options.atol_velocity > 0.0))
    throw InputError(code::kTolerances, "the tolerances of the integrator must be positive.");
  if (kind == "one_step") return std::make_unique<OneStep>(equations, options);
  if (kind == "ida") return std::make_unique<Ida>(equations, options);
  throw InputError(code::kUnknownIntegrator, "unknown integrator \"" + kind + "\". Known integrators: one_step, ida.");
}

}  // namespace footfall

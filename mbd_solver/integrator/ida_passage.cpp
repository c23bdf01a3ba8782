// Singular positions in a run of IDA (singular_position.h, theory 2.4). Steps of a multistep method cannot leave a position
// out: they shrink in front of it, each with an error that the position makes larger, and the steps behind it remember them.
// So the one-step method goes over it, and IDA starts again as far behind it as it has stopped before.

#include <ida/ida.h>

#include <algorithm>
#include <cmath>

#include "mbd_solver/integrator/ida_sundials.h"

namespace footfall {
namespace {

constexpr int kEvery = 4;       // steps between two looks ahead
constexpr double kFaded = 3.0;  // ln of the determinant must have fallen by this: a fifth of a singular value is left
constexpr int kOrder = 5;

}  // namespace

// The determinant is one of positions alone: a look back may reach over windows.
void Ida::Sundials::look_ahead(const State& state) {
  if (equations.layout().row_count == 0 || !options.projection || ++steps_since_look < kEvery) return;
  steps_since_look = 0;
  if (looks > 0 && !(state.time > seen.back().time)) looks = 0;
  seen = {seen[1], seen[2], Nearness{state.time, equations.log_determinant(state)}};
  highest = std::max(highest, seen.back().log_determinant);
  if (++looks < static_cast<int>(seen.size()) || seen.back().log_determinant > highest - kFaded) return;
  const double there = singular_time(seen);
  if (!std::isfinite(there)) return;
  passage_end = there + (there - state.time);
  if (!one_step) {
    IntegratorOptions like = options;
    like.order = kOrder;
    one_step = std::make_unique<OneStep>(equations, like);
  }
  one_step->resume({});
}

bool Ida::Sundials::pass(double t_end, const Inputs& inputs, const Rows& rows, State& state,
                         IntegratorStatistics& statistics) {
  count(statistics);
  const IntegratorStatistics before = one_step->statistics();
  const double goal = std::min(t_end, passage_end);
  if (!(state.step > 0.0)) check(IDAGetLastStep(memory, &state.step), "IDAGetLastStep");
  one_step->advance(state, goal, inputs, rows);
  statistics.add(before, one_step->statistics());
  jacobians = statistics.jacobians;
  rates = one_step->end_rates();
  t = state.time;
  if (t < passage_end) return t == goal;
  passage_end = kNever;
  state.step = 0.0;
  looks = steps_since_look = 0;
  return t == goal;
}

void Ida::Sundials::forget_passage() {
  passage_end = kNever;
  highest = kNever;
  looks = steps_since_look = 0;
}

}  // namespace footfall

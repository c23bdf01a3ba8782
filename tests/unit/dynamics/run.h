#pragma once
// A mechanism on the move, for tests: model, assembly, equations, integrator and state in one place.

#include <memory>
#include <string>

#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/integrator/integrator.h"
#include "tests/support/last_bits.h"

namespace footfall::test {

// Tolerances of a run whose accuracy the test does not ask for.
inline IntegratorOptions usual() {
  IntegratorOptions options;
  options.rtol = 1e-5;
  options.atol = 1e-7;
  options.atol_velocity = 1e-5;
  return options;
}

class Run {
 public:
  explicit Run(const Model& model, const std::string& integrator_kind = "one_step",
               const IntegratorOptions& options = usual(), const Baumgarte& baumgarte = {})
      : assembly(assemble(model)),
        equations(model, assembly, baumgarte),
        integrator(make_integrator(integrator_kind, equations, options)),
        state(assembly.state) {
    disturb_last_bits(state.v);
    inputs.values = Eigen::VectorXd::Zero(4);
    start_ = energy().stored.total();
  }
  // In `windows` equal windows.
  void to(double t_end, int windows = 1) {
    const double t0 = state.time;
    for (int i = 1; i <= windows; ++i)
      integrator->advance(state, i < windows ? t0 + (t_end - t0) * i / windows : t_end, inputs);
  }
  EnergySample energy() {
    EnergySample sample;
    Eigen::VectorXd rates(equations.layout().size()), y(equations.layout().size());
    equations.saddle().accelerations(state, inputs, rates);
    equations.layout().pack(state, rates.tail(equations.layout().row_count), y);
    equations.energy(state.time, y, inputs, sample);
    return sample;
  }
  // What energy there is now minus what there should be [J].
  double imbalance() {
    return energy().stored.total() - start_ + state.dissipated.total() - state.load_work.sum() - state.supplied.total();
  }
  double start_energy() const { return start_; }
  BodyKinematics body(int index) {
    equations.load(state);
    return equations.motion(index);
  }

  Assembly assembly;
  Equations equations;
  std::unique_ptr<Integrator> integrator;
  State state;
  Inputs inputs;

 private:
  double start_ = 0.0;
};

// What a strut, cable or force on a joint reports now.
template <class T>
auto sample_of(Run& run, Handle<T> element) {
  run.equations.load(run.state);
  return element.of(run.equations.model()).sample(run.equations.element_input(element.index(), run.state, run.inputs));
}

// Tolerances of a reference: only round-off and the order of the method remain.
inline IntegratorOptions tight(double tolerance) {
  IntegratorOptions options;
  options.rtol = options.atol = options.atol_velocity = tolerance;
  return options;
}
// The same by the method of fifth order.
inline IntegratorOptions precise(double tolerance) {
  IntegratorOptions options = tight(tolerance);
  options.order = 5;
  return options;
}

}  // namespace footfall::test

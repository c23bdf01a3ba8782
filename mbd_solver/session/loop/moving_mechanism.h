#pragma once
// A mechanism in motion: its present state, the rates that follow from state and inputs, and the
// sample of both. The loops of a run (alone_loop.h, coupled_loop.h) advance it window by window;
// whoever changes state or inputs renews rates and sample.

#include <memory>
#include <string>

#include "coupler/archive.h"
#include "coupler/transport.h"
#include "mbd_solver/assemble/corners.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/coupling/coupled_run.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/session/observe/sampler.h"

namespace footfall {

// From the table [solver] of a scene to the options of integrators and equations.

Baumgarte baumgarte_of(const SolverSpec& spec);
IntegratorOptions integrator_options(const SolverSpec& spec, bool with_grains);

// Loads and inputs in an archive.
template <>
inline constexpr auto kFields<TangentLoad> =
    kFieldsOf<&TangentLoad::K, &TangentLoad::C, &TangentLoad::r_mean, &TangentLoad::L_mean, &TangentLoad::v_mean>;

template <>
inline constexpr auto kFields<ExternalLoad> =
    kFieldsOf<&ExternalLoad::F_W, &ExternalLoad::T_B, &ExternalLoad::Q_a, &ExternalLoad::tangent>;

template <>
inline constexpr auto kFields<Inputs> = kFieldsOf<&Inputs::loads, &Inputs::values>;

// Where the wall time of a run goes.
struct RunTimes {
  double total = 0.0;       // wall time of the loop [s]
  double mbd = 0.0;         // in the integrator [s]
  double overlapped = 0.0;  // in output and controllers while the grains move [s]
  double control = 0.0;     // in controllers [s]; with grains a part of the one above
  double checkpoint = 0.0;  // in checkpoints: waiting for the DEM side, writing files [s]
};

template <>
inline constexpr auto kFields<RunTimes> =
    kFieldsOf<&RunTimes::total, &RunTimes::mbd, &RunTimes::overlapped, &RunTimes::control, &RunTimes::checkpoint>;

class MovingMechanism {
 public:
  // In the state of the assembly. The scene must outlive this. Throws InputError.
  MovingMechanism(const Scene& scene, double t_end, bool with_grains);
  // Grains take part: performs the handshake. Throws ProtocolError, PartnerError.
  void couple(Transport& partner, const std::string& resume);

  const Scene& scene() { return scene_; }
  double t_end() { return t_end_; }            // [s]
  void end_at(double time) { t_end_ = time; }  // earlier than so far [s]
  Mechanism& mechanism() { return mechanism_; }
  Assembly& assembly() { return assembly_; }
  Equations& equations() { return equations_; }
  Corners& corners() { return corners_; }  // of what the scene gives as functions of time
  Integrator& integrator() { return *integrator_; }
  CoupledRun* coupled() { return coupled_.get(); }  // null without grains
  RunTimes& times() { return times_; }
  Subject subject() const;
  Kinematics kinematics() const;  // of the present state, accelerations zero

  State& state() { return state_; }
  Inputs& inputs() { return inputs_; }                        // of the window
  Eigen::VectorXd& rates() { return rates_; }                 // [dq; dv; dz; lambda] at state().time
  const Sample& sample() const { return sampler_.sample(); }  // of the last update_sample()
  bool finished() const;                                      // the end time has been reached, or the script has ended
  long window() const { return window_; }                     // windows completed
  void count_window(long more) { window_ += more; }

  void update_sample() { sampler_.update(window_, finished(), coupled_ ? &coupled_->sample() : nullptr); }
  void renew() {  // rates, then the sample
    equations_.saddle().accelerations(state_, inputs_, rates_);
    update_sample();
  }
  void show(const State& state, const Eigen::VectorXd& rates) {
    state_ = state;
    rates_ = rates;
    update_sample();
  }
  // From a state to this time [s]; sets state and rates, not the sample. Advance does so with
  // pauses. Throws NumericalError.
  void advance(const State& from, double time);
  void check_finite() const;  // throws NumericalError

  void visit(Archive& archive);                     // state, rates, inputs and windows
  void resume(const IntegratorStatistics& so_far);  // after visit()

 private:
  const Scene& scene_;
  double t_end_;  // [s]
  Mechanism mechanism_;
  Assembly assembly_;
  Equations equations_;
  Corners corners_;
  std::unique_ptr<Integrator> integrator_;
  State state_;
  Inputs inputs_;
  Eigen::VectorXd rates_;
  Sampler sampler_;
  std::unique_ptr<CoupledRun> coupled_;
  long window_ = 0;
  RunTimes times_;
};

}  // namespace footfall

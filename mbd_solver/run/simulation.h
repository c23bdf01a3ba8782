#pragma once
// The run of one scene, a window at a time. Data runs one way:
//   Scene -> Mechanism -> State -> window (with grains: motion out, load in) -> Sample -> whoever observes
// While it runs: controllers set inputs, the window's end is found, the mechanism moves to it, its state is checked,
// the sample is observed. With grains the sample is observed, and inputs are set, when the motion is out: the grains move
// meanwhile.

#include <csignal>
#include <functional>
#include <memory>

#include "coupler/archive.h"
#include "coupler/transport.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/coupling/coupled_run.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/run/checkpoint.h"
#include "mbd_solver/run/collision_watch.h"
#include "mbd_solver/run/control_loop.h"
#include "mbd_solver/run/observe/sampler.h"

namespace footfall {

struct RunTimes {
  double total = 0.0;    // wall time of the loop [s]
  double mbd = 0.0;      // in the integrator [s]
  double beside = 0.0;   // in rows and controllers while the grains move [s]
  double control = 0.0;  // in controllers [s]; with grains a part of the last one
  double keeping = 0.0;  // in checkpoints: the grains' side is waited for, and files are written [s]
};

// Who keeps a run so that it can be gone on with.
struct Keeper {
  // Makes the folder of the checkpoint after so many windows; both sides then write into it.
  std::function<std::string(long windows)> begin;
  std::function<void()> finish;  // writes this side's files, when those of the other are there
  std::function<void()> drop;    // the other side could not keep itself now
  // The run has gone on for long without being kept; empty: never. Then it is kept where it is without a trace in what
  // follows; a run that is resumed there agrees with this one within its tolerances alone.
  std::function<bool()> overdue;

  explicit operator bool() const { return begin != nullptr; }
};

class Simulation {
 public:
  // `partner_transport`: null when the scene touches no grains; then nothing of the coupling is made. resume: folder of
  // the checkpoint that the run goes on from, which visit() restores; empty: a new run. The scene must outlive this.
  // Throws InputError, ProtocolError.
  Simulation(const Scene& scene, double t_end, Transport* partner_transport, const std::string& resume = "");

  // Runs to the end, or until `interrupted` is set. Calls `observe` for the start and after every window, and
  // keeps the run every output.checkpoint_interval, and when it is interrupted: at the end of a window whose begin has
  // told the grains. There the integrator forgets what it knows of earlier windows, so that this run and the resumed one
  // go on alike.
  // Throws NumericalError, PartnerError.
  void run(const std::function<void(const Sample&)>& observe, const volatile std::sig_atomic_t& interrupted,
           const Keeper& keep = {});

  // The memory of the run, at such a place; one that restores makes this the run that was kept, which run() continues.
  void visit(Archive& archive);

  const Scene& scene() const { return scene_; }
  const Mechanism& mechanism() const { return mechanism_; }
  const Assembly& assembly() const { return assembly_; }
  const State& state() const { return state_; }
  long window() const { return window_; }  // windows done
  const Integrator& integrator() const { return *integrator_; }
  const RunTimes& times() const { return times_; }
  bool finished() const;  // the end time has been reached
  Subject subject() const;
  Kinematics kinematics() const;                                          // of the present state, accelerations zero
  const CollisionWatch* collisions() const { return collisions_.get(); }  // null where nothing can meet
  CoupledRun* coupled() { return coupled_.get(); }                        // null without grains
  const CoupledRun* coupled() const { return coupled_.get(); }

 private:
  void start_settled();
  double next_stop() const;  // the next row or sample, or the end [s]
  // A set of both sides at the present time; false when the grains' side could not.
  bool keep_now(const Keeper& keep, bool quietly, double started);
  void control();  // samples the controllers that are due
  // Events of the scene, in run/simulation_events.cpp:
  bool event_holds();        // at the sample
  void find_event();         // back to its instant, in (checked_, state_.time]; then it happens
  void let_events_happen();  // all that hold now
  void check_finite() const;
  void look_for_collisions();
  void take_sample() { sampler_.take(window_, finished(), coupled_ ? &coupled_->sample() : nullptr); }

  const Scene& scene_;
  double t_end_;  // [s]
  Mechanism mechanism_;
  Assembly assembly_;
  Equations equations_;
  std::unique_ptr<Integrator> integrator_;
  State state_;
  Inputs inputs_;          // of the window
  Eigen::VectorXd rates_;  // [dq; dv; dz; lambda] at state_.time
  long window_ = 0;        // windows done
  ControlLoop control_;
  bool inputs_change_ = true;  // the last sample has changed one
  bool event_ahead_ = false;   // a row has ended the window, as the condition of an event holds there
  State checked_;              // the last one where no condition held; only with events without a period
  Sampler sampler_;
  std::unique_ptr<CoupledRun> coupled_;
  std::unique_ptr<CollisionWatch> collisions_;  // null where nothing can meet
  std::vector<StaticWall> walls_;               // of the script, those that stand
  IntervalClock checkpoints_;
  bool resumed_ = false;  // the sample of the present state has been observed
  RunTimes times_;
};

}  // namespace footfall

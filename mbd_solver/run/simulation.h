#pragma once
// The run of one scene, window by window. Data flows one way:
//   Scene -> Mechanism -> State -> window (with grains: motion out, load in) -> Sample -> observer
// In every window: controllers set inputs, the end of the window is chosen, the mechanism is integrated to it, the state
// is checked, the sample is observed. With grains, observation and control take place after the motion has been sent,
// while the grains move.

#include <csignal>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "coupler/archive.h"
#include "coupler/transport.h"
#include "mbd_solver/assemble/corners.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/coupling/coupled_run.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/run/checkpoint.h"
#include "mbd_solver/run/collision_watch.h"
#include "mbd_solver/run/control_loop.h"
#include "mbd_solver/run/event_watch.h"
#include "mbd_solver/run/observe/sampler.h"
#include "mbd_solver/run/stiff_signals.h"

namespace footfall {

struct RunTimes {
  double total = 0.0;       // wall time of the loop [s]
  double mbd = 0.0;         // in the integrator [s]
  double overlapped = 0.0;  // in output and controllers while the grains move [s]
  double control = 0.0;     // in controllers [s]; with grains a part of the one above
  double checkpoint = 0.0;  // in checkpoints: waiting for the DEM side, writing files [s]
};

// Writes the checkpoints of a run.
struct CheckpointWriter {
  // Creates the folder of the checkpoint after so many windows and returns its path; both sides then write into it.
  std::function<std::string(long windows)> begin;
  std::function<void()> finish;  // writes the files of this side, when those of the DEM side are complete
  std::function<void()> cancel;  // the DEM side could not write its own
  // Whether the last checkpoint is too long ago on the wall clock; empty: never. A checkpoint written for this reason
  // does not change the run; a run resumed from it agrees with the original within its tolerances only.
  std::function<bool()> overdue;

  explicit operator bool() const { return begin != nullptr; }
};

class Simulation {
 public:
  // partner_transport: null when the scene touches no grains; the coupling is then not constructed. resume: folder of
  // the checkpoint to resume from, which visit() restores; empty: a new run. The scene must outlive this.
  // Throws InputError, ProtocolError.
  Simulation(const Scene& scene, double t_end, Transport* partner_transport, const std::string& resume = "");

  // Runs to the end, or until `interrupted` is set. Calls `observe` at the start and after every window. Writes a
  // checkpoint every output.checkpoint_interval and when interrupted; with grains at the end of a window whose motion
  // announced it. There the integrator forgets what it knows of earlier windows, so that this run and a resumed one
  // continue alike. Throws NumericalError, PartnerError.
  void run(const std::function<void(const Sample&)>& observe, const volatile std::sig_atomic_t& interrupted,
           const CheckpointWriter& checkpoints = {});

  // Of run(), besides its own observer: `steps` is called within steps and at their ends, for peaks that rows do not show;
  // `rows`, with grains, at output times within windows.
  void observe_within(std::function<void(const Sample&)> steps, std::function<void(const Sample&)> rows) {
    observe_step_ = std::move(steps);
    observe_row_ = std::move(rows);
  }

  // A run that another program leads, from within `observe`. What is set takes effect at the sample that is observed.
  // `observe` is also called at this time [s], or at a row so near to it that two rows would be one.
  void stop_at(double time) { stop_ = time; }
  // A signal of kind "host"; place: of the signal among the inputs (PlaceEntry).
  void set_input(int place, double value) { given_.push_back({place, value}); }
  // A checkpoint before the run goes on; with grains after the window that begins.
  void request_checkpoint() { checkpoint_requested_ = true; }
  double row_tolerance() const;  // two times of a row are one [s]

  // State of the run at a checkpoint. Restoring it makes this the run that was saved; run() then continues it.
  void visit(Archive& archive);

  const Scene& scene() const { return scene_; }
  const Mechanism& mechanism() const { return mechanism_; }
  const Assembly& assembly() const { return assembly_; }
  const State& state() const { return state_; }
  const Sample& sample() const { return sampler_.sample(); }  // the last one
  long window() const { return window_; }                     // windows completed
  const Integrator& integrator() const { return *integrator_; }
  const RunTimes& times() const { return times_; }
  void forget_times() { times_ = {}; }
  bool finished() const;  // the end time has been reached, or the script has ended
  Subject subject() const;
  Kinematics kinematics() const;                                          // of the present state, accelerations zero
  const CollisionWatch* collisions() const { return collisions_.get(); }  // null where surfaces cannot meet
  CoupledRun* coupled() { return coupled_.get(); }                        // null without grains
  const CoupledRun* coupled() const { return coupled_.get(); }
  // About functions of time, as far as the run has come.
  std::vector<std::string> time_warnings() const { return corners_.warnings(); }
  // About signals of other programs, likewise.
  std::vector<std::string> signal_warnings() const {
    return stiff_signals_ ? stiff_signals_->warnings() : std::vector<std::string>();
  }

 private:
  class StepMiddles;  // where a step may have a peak
  struct Loop;        // arguments of run() and what its two loops share

  void begin(Loop& loop);
  void run_alone(Loop& loop);
  [[noreturn]] void give_up_short_windows(double moved);  // [s], over all that were watched
  void run_coupled(Loop& loop);
  void observe_sample(Loop& loop);                     // unless it has been observed
  bool save_checkpoint(Loop& loop, bool undisturbed);  // false when the DEM side could not
  double next_row(double t) const;                     // after t [s]
  double next_stop(double t) const;                    // next output row or sample, stop_, or the end [s]
  bool is_stop(double t) const;                        // an output row, or stop_, is at this time [s]
  bool is_led() const { return !given_.empty() || checkpoint_requested_; }  // before the run may go on
  bool take_given();                                                        // what set_input() gave; false: nothing
  // With grains: the time of an event without a period in the window that comes, as far as it can be foreseen; infinity: none
  // until `before` [s].
  double foreseen_event(double before);
  bool foresees_events() const;
  void extrapolate_loads(double time);  // inputs_.loads, from the means over the last two windows [s]
  // With grains: an event without a period changes rates_ by this at the end of a window [as rates_].
  void tell_of_late_event(const std::string& event, const Eigen::VectorXd& change);
  void sample_at_start();
  void sample_before_window(Loop& loop);  // what is due now, and ended the last window for this reason
  // Steps end at corners of given functions.
  void advance(State from, double time, const Rows& rows = {});
  void cross_jump();     // from the last time before a jump of a given function to the first time after it
  void finish_window();  // sample, collisions, events
  void sample_controllers();
  // After a step of a window that ends at window_end [s]: observes it; false: an event ends the window.
  bool watch_step(StepView& step, double window_end);
  bool event_triggered();  // by the sample, or perhaps between it and without_event_
  void stand_without_event();
  bool find_between();
  std::optional<double> holds_between(double begin, double end, double precision,
                                      const std::function<bool(double)>& holds_at);
  void locate_event();  // returns to its instant, in (without_event_.time, state_.time], and applies it
  void apply_events();  // all whose condition holds now
  void check_finite() const;
  void check_collisions();
  void settle_start();
  void update_sample() { sampler_.update(window_, finished(), coupled_ ? &coupled_->sample() : nullptr); }

  const Scene& scene_;
  double t_end_;  // [s]
  Mechanism mechanism_;
  Assembly assembly_;
  Equations equations_;
  Corners corners_;  // of what the scene gives as functions of time
  std::unique_ptr<Integrator> integrator_;
  std::unique_ptr<Equations> foresight_equations_;  // null until an event must be foreseen
  std::unique_ptr<Integrator> foresight_;           // likewise
  State state_;
  Inputs inputs_;          // of the window
  Eigen::VectorXd rates_;  // [dq; dv; dz; lambda] at state_.time
  long window_ = 0;        // windows completed
  ControlLoop control_;
  std::unique_ptr<StiffSignals> stiff_signals_;  // null where no other program computes a signal from inputs
  bool inputs_change_ = true;                    // the last controller sample changed one
  struct GivenInput {
    int place;
    double value;
  };
  std::vector<GivenInput> given_;                          // since the last sample
  double stop_ = std::numeric_limits<double>::infinity();  // [s]
  bool checkpoint_requested_ = false;
  bool event_in_window_ = false;  // a row or step ended the window because the condition of an event holds there
  EventWatch event_watch_;
  double foreseen_ = std::numeric_limits<double>::infinity();  // foreseen_event() of this window [s]
  // With grains and events without a period: loads of the window before the last, and the lengths of both windows [s].
  std::vector<ExternalLoad> loads_before_;
  double last_length_ = 0.0, length_before_ = 0.0;
  double largest_kinetic_ = 0.0;  // likewise, since the start [J]
  bool event_between_ = false;    // ... or because it may have held before
  State without_event_;           // the last state in which no condition held; for events without a period
  Sampler sampler_;
  std::unique_ptr<CoupledRun> coupled_;
  std::unique_ptr<CollisionWatch> collisions_;  // null where surfaces cannot meet
  std::vector<StaticWall> walls_;               // of the script, without removed ones
  IntervalClock checkpoints_;
  bool resumed_ = false;  // the sample of the present state has been observed already
  RunTimes times_;
  std::function<void(const Sample&)> observe_step_, observe_row_;  // empty: nobody
};

}  // namespace footfall

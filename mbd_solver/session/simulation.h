#pragma once
// The run of one scene, window by window. Data flows one way:
//   Scene -> Mechanism -> State -> window (with grains: motion out, load in) -> Sample -> observer
// In every window: controllers set inputs, the end of the window is chosen, the mechanism is integrated to it, the state
// is checked, the sample is observed. With grains, observation and control take place after the motion has been sent,
// while the grains move.

#include <csignal>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "coupler/archive.h"
#include "coupler/transport.h"
#include "mbd_solver/session/loop/alone_loop.h"
#include "mbd_solver/session/loop/run_loop.h"

namespace footfall {

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

  // Without grains, a run in parts: the same as run(), which calls these.
  //   begin(...);  while (next() != Reached::kEnd) {...}
  void begin(const volatile std::sig_atomic_t& interrupted, const CheckpointWriter& checkpoints = {});
  Reached next() { return loop_->next(); }

  // Of run(), besides its own observer: `steps` is called within steps and at their ends, for peaks that rows do not show;
  // `rows`, with grains, at output times within windows.
  void observe_within(std::function<void(const Sample&)> steps, std::function<void(const Sample&)> rows) {
    parts_->observe_step = std::move(steps);
    parts_->observe_row = std::move(rows);
  }

  // Of a program that leads the run, from within `observe`.
  Instructions& instructions() { return parts_->instructions; }
  const Instructions& instructions() const { return parts_->instructions; }

  // Without grains, at a checkpoint: other positions and velocities (State::q, v), unit quaternions made so and both
  // closed by the smallest change; inner states, memory and integrals of power stay. begin() then continues from there.
  // Throws NumericalError if joints cannot be closed; the state is then as before.
  void place(const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  // State of the run at a checkpoint. Restoring it makes this the run that was saved; run() then continues it.
  void visit(Archive& archive);

  const Scene& scene() const { return moving().scene(); }
  const Mechanism& mechanism() const { return moving().mechanism(); }
  const Assembly& assembly() const { return moving().assembly(); }
  const State& state() const { return moving().state(); }
  const Sample& sample() const { return moving().sample(); }  // the last one
  long window() const { return moving().window(); }           // windows completed
  const Integrator& integrator() const { return moving().integrator(); }
  const RunTimes& times() const { return moving().times(); }
  void forget_times() { moving().times() = {}; }
  bool finished() const { return moving().finished(); }  // the end time has been reached, or the script has ended
  Subject subject() const { return moving().subject(); }
  Kinematics kinematics() const { return moving().kinematics(); }  // of the present state, accelerations zero
  // Null where surfaces cannot meet.
  const CollisionWatch* collisions() const { return parts_->surfaces.collisions(); }
  CoupledRun* coupled() { return moving().coupled(); }  // null without grains
  const CoupledRun* coupled() const { return moving().coupled(); }
  // About functions of time, as far as the run has come.
  std::vector<std::string> time_warnings() const { return moving().corners().warnings(); }
  // About signals of other programs, likewise.
  std::vector<std::string> signal_warnings() const { return parts_->inputs.warnings(); }

 private:
  MovingMechanism& moving() const { return parts_->moving; }

  std::unique_ptr<RunParts> parts_;
  std::unique_ptr<AloneLoop> loop_;  // since begin()
};

}  // namespace footfall

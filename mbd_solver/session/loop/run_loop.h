#pragma once
// What the two loops of a run share: its parts, who observes it, and the end of a window.

#include <csignal>
#include <functional>
#include <memory>
#include <vector>

#include "coupler/messages.h"
#include "mbd_solver/session/collision_watch.h"
#include "mbd_solver/session/loop/checkpointer.h"
#include "mbd_solver/session/loop/event_finder.h"
#include "mbd_solver/session/loop/event_foresight.h"
#include "mbd_solver/session/loop/instructions.h"
#include "mbd_solver/session/loop/moving_mechanism.h"
#include "mbd_solver/session/loop/sampled_inputs.h"

namespace footfall {

// Surfaces that must not meet during a run: of bodies, and the static walls of the script,
// without walls that it has removed.
class SurfaceWatch {
 public:
  explicit SurfaceWatch(MovingMechanism& moving) : moving_(moving) {}
  // reference: the mechanism as assembled. The walls of the script act on the mechanism from now
  // on. Adds its notes to the assembly's.
  void start(const Kinematics& reference);
  void begin();  // at the present sample, in which a run begins or resumes
  void check();  // the present sample; throws NumericalError
  const CollisionWatch* collisions() const { return collisions_.get(); }  // null where surfaces cannot meet

 private:
  MovingMechanism& moving_;
  std::vector<StaticWall> walls_;
  std::unique_ptr<CollisionWatch> collisions_;
};

struct RunParts {
  RunParts(const Scene& scene, double t_end, bool with_grains)
      : moving(scene, t_end, with_grains),
        inputs(moving),
        instructions(scene.output.interval),
        foresight(moving, inputs.signals()),
        events(moving, inputs.signals(), foresight),
        checkpoints(moving, instructions),
        surfaces(moving) {}

  MovingMechanism moving;
  SampledInputs inputs;
  Instructions instructions;
  EventForesight foresight;
  EventFinder events;
  Checkpointer checkpoints;
  SurfaceWatch surfaces;
  std::function<void(const Sample&)> observe_step, observe_row;  // Simulation::observe_within; empty: nobody
  bool resumed = false;  // the sample of the present state has been observed already
};

class RunLoop {
 public:
  // The loop ends when `interrupted` is set. Both must outlive this.
  RunLoop(RunParts& run, const volatile std::sig_atomic_t& interrupted)
      : run_(run), moving_(run.moving), interrupted_(interrupted) {}

 protected:
  ~RunLoop() = default;
  // At the start, or where the run resumes. True: the present sample is to be observed before
  // finish_start().
  bool begin();
  void finish_start() { run_.events.begin(); }
  bool interrupted() const { return interrupted_ != 0; }
  void count_time();            // of the run, before a sample is observed or saved
  bool save(bool undisturbed);  // a checkpoint, as Checkpointer::save
  void finish_window();         // sample, collisions, events
  // After a step of a window that ends at window_end [s]: observes it; false: an event ends the
  // window.
  bool watch_step(StepView& step, double window_end);

  RunParts& run_;
  MovingMechanism& moving_;

 private:
  const volatile std::sig_atomic_t& interrupted_;
  double begun_ = 0.0;  // wall clock at the start of the loop, minus the time of earlier parts of the run [s]
};

}  // namespace footfall

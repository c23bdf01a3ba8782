// Without grains a checkpoint is written at once; with grains both sides write theirs between two
// windows.

#include "mbd_solver/session/loop/checkpointer.h"

#include "coupler/base/clock.h"

namespace footfall {

Checkpointer::Checkpointer(MovingMechanism& moving, Instructions& instructions)
    : moving_(moving),
      instructions_(instructions),
      clock_(moving.scene().output.checkpoint_interval, moving.scene().output.checkpoint_interval) {}

CheckpointRequest Checkpointer::announce(bool due) const {
  if (!writes() || !(due || overdue())) return {};
  return {writer_.begin(moving_.window() + 1), !due};
}

bool Checkpointer::save(bool undisturbed) {
  if (!undisturbed) {
    clock_.take_turn(moving_.state().time);
    moving_.integrator().forget();
  }
  const double started = wall_clock();
  CoupledRun* const coupled = moving_.coupled();
  if (!coupled) writer_.begin(moving_.window());
  const bool complete = !coupled || coupled->wait_for_checkpoint();
  complete ? writer_.finish() : writer_.cancel();
  moving_.times().checkpoint += wall_clock() - started;
  return complete;
}

}  // namespace footfall

#pragma once
// A mechanism on its way through a window: it pauses at rows and steps. Steps of the integrator end
// at corners of what the scene gives as functions of time.

#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/session/loop/instructions.h"

namespace footfall {

class MovingMechanism;

class Advance {
 public:
  // The mechanism must outlive this.
  explicit Advance(MovingMechanism& moving) : moving_(moving) {}

  // From a state to this time [s]. instructions: where a corner is one of their stops it is a row,
  // too, and the way ends there only if they wait; null: corners are no rows.
  void begin(const State& from, double time, const WindowStops& stops = {}, const Instructions* instructions = nullptr);
  // kEnd: state and rates of the mechanism belong to the end, its sample does not. Throws
  // NumericalError.
  WindowStop next();
  void end_window();  // at the row or step that next() has returned

 private:
  enum class Phase { kAtCorner, kIntegrating, kBeforeJump, kBehindRow };
  WindowStop next_stop();

  MovingMechanism& moving_;
  Phase phase_ = Phase::kAtCorner;
  State state_;
  double time_ = 0.0;  // [s]
  WindowStops stops_;
  const Instructions* instructions_ = nullptr;
  Corner corner_;
  double corner_end_ = 0.0;  // where the integrator ends, before the corner or at time_ [s]
  bool ended_ = false;       // at a corner
};

}  // namespace footfall

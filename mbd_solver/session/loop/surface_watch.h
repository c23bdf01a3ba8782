#pragma once
// Surfaces that must not meet during a run: of bodies, and the static walls of the script,
// without walls that it has removed.

#include <memory>
#include <vector>

#include "coupler/messages.h"
#include "mbd_solver/session/collision_watch.h"
#include "mbd_solver/session/loop/moving_mechanism.h"

namespace footfall {

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

}  // namespace footfall

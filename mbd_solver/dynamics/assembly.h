#pragma once
// Coordinates of joints that a scene gives values at the start.

#include <string>
#include <vector>

#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/model/elements/joint_coordinate.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// A coordinate of a joint at the start; the others follow by the smallest motion of the bodies.
struct StartCoordinate {
  int joint = 0;
  Coordinate coordinate = Coordinate::kAngle;
  double value = 0.0;  // [rad or m]
};

// Moves the coordinates to their values in small steps, so that loops stay on their branch. The joints of `state` are
// closed, before and after. Throws InputError where they do not close on the way.
void move_to_start(const Model& model, const std::vector<StartCoordinate>& start, State& state);

// Flexible bodies are turned to where their joints close, and not bent: in the metric of masses a stiff body is bent as
// easily as it is turned, and the smallest motion alone would leave it with great forces.

// The bodies and joints of a model, and of its forces what counts turns alone.
Model without_forces(const Model& model);

// Closes the joints of a model without forces by moving its bodies as if none could bend.
class UnbentClosing {
 public:
  // layout: of the model. Both must outlive this.
  UnbentClosing(const Model& model, const Layout& layout);
  // Leaves the state as it is where that is not enough, and where no body can bend.
  void close(State& state);

 private:
  const Layout& layout_;
  Model model_;  // the same bodies and joints, and none of the bodies can bend
  Layout rigid_;
  ConstraintRows rows_;
  bool bends_ = false;
};

// The same for the places of a drawing that is open.
void close_unbent(const Model& model, State& state);

// Joints that a drawing leaves open are closed by the smallest motion of the bodies.

constexpr double kContradiction = 1e-8;  // [m or rad]: what remains above this cannot be closed

// Gauss-Newton with the smallest correction, until the gaps no longer fall; angles of gears go along. `rows` stand at
// `state`, before and after.
void close_joints(const Model& model, const Layout& layout, ConstraintRows& rows, State& state);

// Throws InputError that names the joints with the largest entries of `defect`, one per row, when these are above what
// round-off leaves of `scale`: the joints contradict each other, `what` by so many `unit`.
void check_contradiction(const Model& model, const Layout& layout, const Eigen::VectorXd& defect, double scale,
                         const std::string& what, const std::string& unit);

// Names of joints, quoted.
std::string joint_names(const Model& model, const std::vector<int>& joints);

// From a model to a consistent start: joints closed, velocities made consistent, redundant conditions found.

struct AssemblyOptions {
  double gap_tolerance = 1e-3;    // largest initial gap [m] or misalignment [rad] that is closed silently
  double speed_tolerance = 1e-6;  // largest change of a given velocity [m/s or rad/s] that is made silently
  double rank_tolerance = 1e-8;   // of the unit rows of Phi_v
  std::vector<StartCoordinate> start;
};

struct Assembly {
  State state;                            // closed to round-off, velocities consistent
  int rank = 0;                           // number of independent constraint rows
  std::vector<RedundantGroup> redundant;  // joints whose rows depend on each other
  // One per joint with redundant conditions, naming the joints they follow from; one on changed velocities.
  std::vector<std::string> notes;
  double largest_gap = 0.0;           // before closing [m or rad]
  double largest_speed_change = 0.0;  // largest change by the projection [m/s or rad/s]
};

// Throws InputError: `joint "hinge_3": gap of 0.012 m ...` when a joint is far from closed; when conditions
// contradict each other (naming the joints); when a state is not finite.
Assembly assemble(const Model& model, const AssemblyOptions& options = {});

}  // namespace footfall

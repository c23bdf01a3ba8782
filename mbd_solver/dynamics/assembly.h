#pragma once
// From a model to a consistent start: joints closed, velocities made consistent, redundant conditions found. Joints that are
// open in the reference configuration are closed by the smallest motion of the bodies.

#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/model/elements/joint_coordinate.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// A joint coordinate that a scene gives at the start; the others follow by the smallest motion of the bodies.
struct StartCoordinate {
  int joint = 0;
  Coordinate coordinate = Coordinate::kAngle;
  double value = 0.0;  // [rad or m]
};

// Moves the coordinates to their values in small steps, so that loops remain on their branch. The joints of `state` are
// closed before and after. Throws InputError if they cannot be closed.
void move_to_start(const Model& model, const std::vector<StartCoordinate>& start, State& state);

// The bodies and joints of a model, and of its forces the counters of turns.
Model without_forces(const Model& model);

// Closes the joints of a model without forces by moving its bodies without bending them: in the metric of masses a stiff body
// bends as easily as it turns, and the smallest motion alone would leave it with large forces.
class UnbentClosing {
 public:
  // layout: of the model. Both must outlive this object.
  UnbentClosing(const Model& model, const Layout& layout);
  // Does not change the state if this is not sufficient, or if no body can bend.
  void close(State& state);

 private:
  const Layout& layout_;
  Model model_;  // the same bodies and joints, and none of the bodies can bend
  Layout rigid_;
  ConstraintRows rows_;
  bool bends_ = false;
};

// The same for the initial positions of a model.
void close_unbent(const Model& model, State& state);

constexpr double kContradiction = 1e-8;  // larger remaining gaps cannot be closed [m or rad]

// Gauss-Newton with the smallest correction, until the gaps no longer fall; angles of gears follow. `rows` are evaluated at
// `state` before and after.
void close_joints(const Model& model, const Layout& layout, ConstraintRows& rows, State& state);

// Throws InputError naming the joints with the largest entries of `defect` (one per row) if these exceed round-off of `scale`:
// the joints contradict each other, `what` by a number of `unit`.
void check_contradiction(const Model& model, const Layout& layout, const Eigen::VectorXd& defect, double scale,
                         const std::string& what, const std::string& unit);

// Names of joints, quoted.
std::string joint_names(const Model& model, const std::vector<int>& joints);

struct AssemblyOptions {
  double gap_tolerance = 1e-3;    // largest initial gap [m] or misalignment [rad] that is closed without a message
  double speed_tolerance = 1e-6;  // largest change of a given velocity [m/s or rad/s] without a message
  double rank_tolerance = 1e-8;   // of the unit rows of Phi_v
  std::vector<StartCoordinate> start;
  // Sets positions, velocities and inner states of the start that the caller knows better than the model; empty: none.
  std::function<void(const Layout&, State&)> carry;
};

struct Assembly {
  State state;                            // closed to round-off, velocities consistent
  int rank = 0;                           // number of independent constraint rows
  std::vector<RedundantGroup> redundant;  // joints whose rows depend on each other
  // Warnings: one per joint with redundant conditions, naming the joints they follow from; one on changed velocities.
  std::vector<std::string> notes;
  double largest_gap = 0.0;           // before closing [m or rad]
  double largest_speed_change = 0.0;  // largest change by the projection [m/s or rad/s]
};

// Throws InputError: `joint "hinge_3": gap of 0.012 m ...` if a joint is far from closed; if conditions contradict each other
// (naming the joints); if a state is not finite.
Assembly assemble(const Model& model, const AssemblyOptions& options = {});

}  // namespace footfall

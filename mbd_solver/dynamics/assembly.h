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

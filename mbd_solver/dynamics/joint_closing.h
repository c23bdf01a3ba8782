#pragma once
// Joints that a drawing leaves open are closed by the smallest motion of the bodies.

#include <string>
#include <vector>

#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/state.h"

namespace footfall {

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

}  // namespace footfall

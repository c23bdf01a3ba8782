#pragma once
// What can be wrong with a finite-element model before it is reduced.

#include <string>
#include <vector>

#include "mbd_solver/fe/fe_model.h"

namespace footfall {

// Throws InputError led by `who`: sizes disagree, a mass or inertia is negative, the body has no mass or no
// inertia about some axis (the mass matrix is not positive), a node without stiffness, disconnected pieces,
// stiffness that resists rigid-body motion (a support).
void check_model(const FeModel& model, const std::string& who);

// Throws InputError led by `who` if the model has no such interface node.
void check_interface(const FeModel& model, const std::vector<int>& nodes, const std::string& who);

}  // namespace footfall

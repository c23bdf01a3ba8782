#pragma once
// One body in several places, as the legs of a lander or the wheels of a rover: reduced once, the others are turned copies.

#include <Eigen/Dense>
#include <optional>
#include <string>

#include "mbd_solver/fe/modal_basis.h"

namespace footfall {

// p [m] where `copy` is `model` moved by x -> R x + p, with all it has: nodes, masses, inertias, stiffness and stress, to
// kSameModel of their size. Nothing where it is another model. R: a rotation, in D.
std::optional<Eigen::Vector3d> place_of_copy(const FeModel& model, const FeModel& copy, const Eigen::Matrix3d& R);
inline constexpr double kSameModel = 1e-11;

// What reduce() gives for that copy, to round-off, from what it gave for the model. Stresses are along the axes of the
// elements, which turn with them.
ReducedBody turned(const ReducedBody& reduced, const Eigen::Matrix3d& R, const Eigen::Vector3d& p,
                   const std::string& name);

}  // namespace footfall

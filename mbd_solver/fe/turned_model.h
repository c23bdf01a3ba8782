#pragma once
// Copies of one body, such as the legs of a lander or the wheels of a rover: it is reduced once, and the result is rotated.

#include <Eigen/Dense>
#include <optional>
#include <string>

#include "mbd_solver/fe/modal_basis.h"

namespace footfall {

// p [m] if `copy` is `model` moved by x -> R x + p, with nodes, masses, inertias, stiffness and stress, to kSameModel of
// their size; empty if it is another model. R: a rotation, in D.
std::optional<Eigen::Vector3d> place_of_copy(const FeModel& model, const FeModel& copy, const Eigen::Matrix3d& R);
inline constexpr double kSameModel = 1e-11;

// The reduced copy, to round-off, from the reduced model. Stresses are along the axes of the elements, which rotate, too.
ReducedBody turned(const ReducedBody& reduced, const Eigen::Matrix3d& R, const Eigen::Vector3d& p,
                   const std::string& name);

}  // namespace footfall

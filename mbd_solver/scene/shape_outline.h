#pragma once
// Where the shape of a body ends.

#include <Eigen/Core>
#include <vector>

#include "mbd_solver/scene/body_spec.h"

namespace footfall {

// The outermost points of a shape in D, whose hull it fills but for round edges [m]; empty: no shape, or unknown.
std::vector<Eigen::Vector3d> shape_outline(const BodySpec& body);

}  // namespace footfall

#pragma once
// Which node of a body is meant by a point of the drawing.

#include <Eigen/Dense>

#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/model/modal_body.h"

namespace footfall {

// Index of the node nearest to the point: in D for a model, in B (relative to Bo) for a body. The lowest
// index wins a tie.
int nearest_node(const FeModel& model, const Eigen::Vector3d& p_D);
int nearest_node(const ModalBody& body, const Eigen::Vector3d& p_B);

// The node a joint at this point attaches to. Throws InputError, naming the nearest node and its distance,
// when none is within tolerance [m], or when the joint needs the rotation of the node and the node has none
// (solid models of other codes).
int joint_node(const FeModel& model, const Eigen::Vector3d& p_D, double tolerance, bool needs_rotation);
int joint_node(const ModalBody& body, const Eigen::Vector3d& p_B, double tolerance, bool needs_rotation);

}  // namespace footfall

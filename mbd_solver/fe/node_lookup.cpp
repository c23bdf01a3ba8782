#include "mbd_solver/fe/node_lookup.h"

#include <sstream>
#include <string>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

using Eigen::Vector3d;

int nearest(const Eigen::Matrix3Xd& nodes, const Vector3d& p) {
  FOOTFALL_DEMAND(nodes.cols() > 0);
  Eigen::Index best = 0;
  (nodes.colwise() - p).colwise().squaredNorm().minCoeff(&best);
  return static_cast<int>(best);
}

int joint_node(const Eigen::Matrix3Xd& nodes, bool rotations, const Vector3d& p, double tolerance,
               bool needs_rotation) {
  const int node = nearest(nodes, p);
  const double distance = (nodes.col(node) - p).norm();
  std::ostringstream message;
  if (!(distance <= tolerance)) {
    message << "no joint can attach at (" << p.transpose() << ") m: the nearest node, " << node << ", at ("
            << nodes.col(node).transpose() << ") m, is " << distance << " m away, expected at most " << tolerance
            << " m. Move the joint to a node, or put a node there.";
    throw InputError(message.str());
  }
  if (needs_rotation && !rotations) {
    message << "no joint that holds an orientation can attach to node " << node
            << ": the model has displacements only, no rotations. Use a spherical joint, or bring a model "
               "with rotations.";
    throw InputError(message.str());
  }
  return node;
}

}  // namespace

int nearest_node(const FeModel& model, const Vector3d& p_D) { return nearest(model.nodes, p_D); }

int nearest_node(const ModalBody& body, const Vector3d& p_B) { return nearest(body.rho0, p_B); }

int joint_node(const FeModel& model, const Vector3d& p_D, double tolerance, bool needs_rotation) {
  return joint_node(model.nodes, model.rotations, p_D, tolerance, needs_rotation);
}

int joint_node(const ModalBody& body, const Vector3d& p_B, double tolerance, bool needs_rotation) {
  const bool rotations = body.mode_count() == 0 || !body.Psi.isZero(0.0);
  return joint_node(body.rho0, rotations, p_B, tolerance, needs_rotation);
}

}  // namespace footfall

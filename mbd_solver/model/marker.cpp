// On a flexible body a marker moves with one node; the modes of that node become the marker's modes.

#include "mbd_solver/model/marker.h"

#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

Marker rigid_marker(int index, const Eigen::Vector3d& s0, const Eigen::Matrix3d& axes) {
  FOOTFALL_DEMAND((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm() < 1e-9);
  Marker marker;
  marker.body = index;
  marker.s0 = s0;
  marker.axes = axes;
  return marker;
}

}  // namespace

Marker ground_marker(const Eigen::Vector3d& p_W, const Eigen::Matrix3d& axes_W) {
  return rigid_marker(kGround, p_W, axes_W);
}

Marker body_marker(int index, const Body& body, const Eigen::Vector3d& p_B, const Eigen::Matrix3d& axes_B) {
  if (body.mode_count() == 0) return rigid_marker(index, p_B, axes_B);
  Eigen::Index nearest = 0;
  (body.modal()->rho0.colwise() - p_B).colwise().squaredNorm().minCoeff(&nearest);
  return node_marker(index, body, static_cast<int>(nearest), p_B - body.modal()->rho0.col(nearest), axes_B);
}

Marker node_marker(int index, const Body& body, int node, const Eigen::Vector3d& offset_B,
                   const Eigen::Matrix3d& axes_B) {
  const ModalBody* modal = body.modal();
  if (modal == nullptr || node < 0 || node >= modal->node_count())
    throw InputError(code::kNoSuchNode, "body \"" + body.name() + "\": there is no node " + std::to_string(node) +
                                            "; it has " + std::to_string(modal == nullptr ? 0 : modal->node_count()) +
                                            " nodes.");
  Marker marker = rigid_marker(index, modal->rho0.col(node) + offset_B, axes_B);
  if (body.mode_count() == 0) return marker;
  marker.Psi = modal->Psi.middleRows(3 * node, 3);
  marker.S = modal->Phi.middleRows(3 * node, 3) - skew(offset_B) * marker.Psi;
  for (int k = 0; k < 3; ++k) marker.U[k] = -skew(axes_B.col(k)) * marker.Psi;
  return marker;
}

}  // namespace footfall

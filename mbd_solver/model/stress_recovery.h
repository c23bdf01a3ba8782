#pragma once
// Stress and deflection of a flexible body in a given state. For output, not for the inner loop.

#include <Eigen/Dense>

#include "mbd_solver/model/modal_body.h"

namespace footfall {

// Von Mises stress [Pa] of each stress point; empty if the body has none.
Eigen::VectorXd von_mises_of_points(const ModalBody& body, const Eigen::VectorXd& a);
// Largest von Mises stress [Pa] of each triangle, then of each segment; empty when stress points do not
// belong to them.
Eigen::VectorXd von_mises_of_cells(const ModalBody& body, const Eigen::VectorXd& a);
// Largest von Mises stress [Pa]; 0 without stress points or modes.
double von_mises(const ModalBody& body, const Eigen::VectorXd& a);
// Largest |Phi_j a| over the nodes [m].
double largest_deflection(const ModalBody& body, const Eigen::VectorXd& a);

}  // namespace footfall

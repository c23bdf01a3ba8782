#pragma once
// From a finite-element model to a flexible body of a few modes, in the form modal_body.h asks for.
//
// Craig-Bampton: static shapes of the interface (one per degree of freedom of the interface nodes, the others
// held) and normal modes with the interface held; then the eigenproblem of that basis, so that the modes are
// mass-orthonormal and K is diagonal. Its six rigid-body motions are left out. All static shapes are always
// kept, so the response to slow joint forces is exact; number and frequency limit choose the fixed-interface
// modes on top of them. The interface need not hold the body: the fixed-interface modes then include its
// motions without strain, which do not count.
//
// Free-free: the lowest elastic normal modes of the unsupported body. Craig-Bampton without interface nodes
// is the same.
//
// Hold only what joints load: a moment on a node of a thin plate is a singular load, so a six-component
// interface node spends modes on local kinks that a pinned node does not have.

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/model/modal_body.h"

namespace footfall {

enum class BasisKind { kCraigBampton, kFreeFree };

constexpr int kDefaultModeCount = 10;      // when neither count nor frequency is given, or all there are
constexpr double kStaticTolerance = 0.01;  // of ModalBody::static_error: beyond it a warning [-]
constexpr double kNoStiffness = 1e-8;      // lambda over elastic scale: less is motion without strain [-]
constexpr double kDefaultDampingRatio = 0.01;

struct BasisOptions {
  BasisKind kind = BasisKind::kCraigBampton;
  // Modes: elastic ones of the free body, or fixed-interface ones on top of all static shapes. 0 gives a rigid body
  // with the model's mass properties.
  std::optional<int> mode_count;
  std::optional<double> max_frequency;  // of these modes, those above it are left out [Hz]
  // zeta: one for all modes, or one per mode (the modes beyond use the last) [-]
  std::vector<double> damping_ratio = {kDefaultDampingRatio};
  // Where joints and forces attach: the interface of Craig-Bampton, and where static_error is taken. A node in both
  // lists counts as the first.
  std::vector<int> interface_nodes;  // joints that can transmit moments: six static shapes each
  std::vector<int> pinned_nodes;     // spherical joints, struts, forces without moment: three static shapes each
};

struct ReducedBody {
  ModalBody body;
  Eigen::Vector3d p_DBo = Eigen::Vector3d::Zero();  // centre of mass in the drawing frame D [m]; B has D's axes
  std::vector<std::string> warnings;                // e.g. frequencies that suggest wrong units, or static_error
};

// Throws InputError, naming the body: more modes than degrees of freedom, an interface node that does not
// exist or belongs to no element, disconnected pieces or mechanisms, a supported (not free) stiffness matrix,
// a mass matrix that is not positive.
ReducedBody reduce(const FeModel& model, const BasisOptions& options, const std::string& name);

// Natural frequencies of the modes [Hz].
Eigen::VectorXd frequencies(const ModalBody& body);

// Given shapes (any rigid-body content, not orthonormal; relative to the origin of D) and their s x s
// stiffness: the body of modal_body.h with origin in the mass centre, after removing rigid motion, making
// them orthonormal and diagonalising. The shapes must be independent and none a rigid motion: InputError.
// Only count, frequency and damping of the options are used.
ReducedBody orthonormalised(ModalBody raw, const Eigen::MatrixXd& stiffness, const BasisOptions& options);

// Modes of one frequency, as the two bendings of a round rod: any combinations of them are modes as well, and round-off would
// choose. Those are taken that move along one principal axis of the body each, if there are such. Then a rod has the same modes
// in every direction, a count that takes one of a pair takes the same one, and most sums over two modes are zero
// (model/column_groups.h).

constexpr double kOneFrequency = 1e-9;  // relative: lambdas nearer than this are one

// sum_i i e_i e_i^T, i = 1, 2, 3: tells motions along the principal axes e_i apart.
Eigen::Matrix3d axis_weight(const Eigen::Matrix3d& principal_axes);

// W, 6N x 6N: the node's mass times axis_weight for its displacement, nothing for its rotation [kg].
Eigen::SparseMatrix<double> axis_weights(const FeModel& model);

// Y (s x s, orthogonal): shapes X Y move along one axis each, where modes of one frequency can. lambda: s, rising [1/s2];
// B = X^T W X, s x s. Within each group of one frequency Y holds eigenvectors of B, if its eigenvalues are apart; elsewhere Y
// is the identity.
Eigen::MatrixXd along_axes(const Eigen::VectorXd& lambda, const Eigen::MatrixXd& B);

}  // namespace footfall

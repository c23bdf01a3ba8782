#pragma once
// Reduction of a finite-element model to a flexible body with few modes (model/modal_body.h).
//
// Craig-Bampton: static shapes of the interface (one per degree of freedom of the interface nodes, the others held) and normal
// modes with the interface held; then the eigenproblem of that basis, so that the modes are mass-orthonormal and K is
// diagonal. Its six rigid-body motions are removed. The basis contains all static shapes, so that the response to slow joint
// forces is exact; number and frequency limit select the fixed-interface modes in addition. If the interface does not hold
// the body, the fixed-interface modes include its motions without strain, which are not counted.
//
// Free-free: the lowest elastic normal modes of the unsupported body; the same as Craig-Bampton without interface nodes.
//
// Declare moments only where joints transmit them: a moment on a node of a thin plate is a singular load, and a
// six-component interface node spends modes on local kinks that a pinned node does not have.
//
// Modes of equal frequency, such as the two bendings of a round rod: any combinations of them are modes as well, and round-off
// would choose. If there are modes that move along one principal axis of the body each, these are chosen. A rod then has the
// same modes in every direction, a count that splits a pair always takes the same mode, and most sums over two modes are
// zero (model/column_groups.h).

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/model/modal_body.h"

namespace footfall {

enum class BasisKind { kCraigBampton, kFreeFree };

constexpr int kDefaultModeCount = 10;      // if neither count nor frequency is given
constexpr double kStaticTolerance = 0.01;  // of ModalBody::static_error; a warning beyond it [-]
constexpr double kNoStiffness = 1e-8;      // lambda over elastic scale of motions without strain [-]
constexpr double kDefaultDampingRatio = 0.01;

struct BasisOptions {
  BasisKind kind = BasisKind::kCraigBampton;
  // Elastic modes of the free body, or fixed-interface modes in addition to all static shapes. 0 gives a rigid body with the
  // model's mass properties.
  std::optional<int> mode_count;
  std::optional<double> max_frequency;  // limit of these modes [Hz]
  // zeta: one for all modes, or one per mode (further modes use the last) [-]
  std::vector<double> damping_ratio = {kDefaultDampingRatio};
  // Attachments of joints and forces: the interface of Craig-Bampton, and the loads of static_error. A node in both lists
  // belongs to the first.
  std::vector<int> interface_nodes;  // joints that transmit moments: six static shapes each
  std::vector<int> pinned_nodes;     // spherical joints, struts, forces without moment: three static shapes each
};

struct ReducedBody {
  ModalBody body;
  Eigen::Vector3d p_DBo = Eigen::Vector3d::Zero();  // centre of mass in the reference frame D [m]; B has D's axes
  std::vector<std::string> warnings;                // e.g. frequencies that suggest wrong units, or static_error
};

// Throws InputError, naming the body: more modes than degrees of freedom, an interface node that does not exist or belongs to
// no element, disconnected pieces or mechanisms, a supported (not free) stiffness matrix, a mass matrix that is not positive.
ReducedBody reduce(const FeModel& model, const BasisOptions& options, const std::string& name);

// Natural frequencies of the modes [Hz].
Eigen::VectorXd frequencies(const ModalBody& body);

// From shapes with any rigid-body content, not orthonormal, relative to the origin of D, and their s x s stiffness: the body
// with origin in the mass centre, rigid motion removed, shapes orthonormal and stiffness diagonal. Throws InputError if shapes
// are dependent or one is a rigid motion. Only count, frequency and damping of the options are used. turning: nodes that
// have rotations; null: all or none.
ReducedBody orthonormalised(ModalBody raw, const Eigen::MatrixXd& stiffness, const BasisOptions& options,
                            const std::vector<bool>* turning = nullptr);

}  // namespace footfall

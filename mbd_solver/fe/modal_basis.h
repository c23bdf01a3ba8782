#pragma once
// From a finite-element model to a flexible body of a few modes, in the form modal_body.h asks for.
//
// Craig-Bampton: static shapes of the interface (one per degree of freedom of the interface nodes, the others
// held) and normal modes with the interface held; then the eigenproblem of that basis, so that the modes are
// mass-orthonormal and K is diagonal. Its six rigid-body motions are left out. While s >= n_c - 6 (n_c
// degrees of freedom of the interface) all static shapes are kept and the response to slow joint forces is
// exact; with fewer modes, or with a frequency limit, the lowest s of the basis are kept. The interface need
// not hold the body: the fixed-interface modes then include its motions without strain.
//
// Free-free: the lowest elastic normal modes of the unsupported body. Craig-Bampton without interface nodes
// is the same.
//
// Hold only what joints load: a moment on a node of a thin plate is a singular load, so a six-component
// interface node spends modes on local kinks that a pinned node does not have.

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/model/modal_body.h"

namespace footfall {

enum class BasisKind { kCraigBampton, kFreeFree };

constexpr int kDefaultModeCount = 10;  // when neither count nor frequency is given, or all there are
constexpr double kDefaultDampingRatio = 0.01;

struct BasisOptions {
  BasisKind kind = BasisKind::kCraigBampton;
  std::optional<int> mode_count;        // s; 0 gives a rigid body with the model's mass properties
  std::optional<double> max_frequency;  // modes above it are left out [Hz]
  // zeta: one for all modes, or one per mode (the modes beyond use the last) [-]
  std::vector<double> damping_ratio = {kDefaultDampingRatio};
  // Where joints and forces attach (Craig-Bampton only). A node in both lists counts as the first.
  std::vector<int> interface_nodes;  // joints that can transmit moments: six static shapes each
  std::vector<int> pinned_nodes;     // spherical joints, struts, forces without moment: three static shapes each
};

struct ReducedBody {
  ModalBody body;
  Eigen::Vector3d p_DBo = Eigen::Vector3d::Zero();  // centre of mass in the drawing frame D [m]; B has D's axes
  std::vector<std::string> warnings;                // e.g. frequencies that suggest wrong units
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

}  // namespace footfall

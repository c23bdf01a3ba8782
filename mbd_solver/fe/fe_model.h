#pragma once
// A finite-element model of one unsupported body: nodes with six degrees of freedom, sparse stiffness and mass. Frames and
// shells are made here, with lumped mass; models are checked, and nodes found, before a body is reduced.

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <string>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/fe/material.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/modal_body.h"

namespace footfall {

// A node that moves with a set of others. rigid: they move as one body with it. averaged: it moves as they do in the mean,
// and loads at it spread over them; they are free to deform.
enum class SpiderKind { kRigid, kAveraged };
constexpr std::string_view name_of(SpiderKind kind) { return name_in(kind, "rigid", "averaged"); }
struct Spider {
  int node = 0;
  std::vector<int> nodes;  // ascending
  SpiderKind kind = SpiderKind::kRigid;
};

// Degree of freedom 6 j + i: displacement i = 0..2 [m] or rotation i - 3 = 0..2 [rad] of node j, along the axes of the
// reference configuration D.
struct FeModel {
  Eigen::Matrix3Xd nodes;                     // 3 x N, in D [m]
  Eigen::SparseMatrix<double> stiffness;      // 6N x 6N (6N + extra), symmetric, both triangles stored
  Eigen::VectorXd node_mass;                  // N [kg]
  std::vector<Eigen::Matrix3d> node_inertia;  // N rotary inertias, in D [kg m2]
  Eigen::SparseMatrix<double> mass;           // 6N x 6N, if masses are not lumped; node_mass then only weighs the nodes
  Eigen::SparseMatrix<double> stress;         // 6P x 6N: stress (xx yy zz xy yz zx, element axes) of P points [Pa]
  std::vector<Eigen::Vector3i> triangles;     // points 2 t (top), 2 t + 1 (bottom) belong to triangle t
  std::vector<Eigen::Vector2i> segments;      // points 8 e ... 8 e + 7 belong to segment e
  bool rotations = true;                      // false: a solid model of another code, without rotations
  // For models of other codes:
  int extra = 0;  // coordinates of modes behind the 6N rows of K and M, which have no place
  std::vector<Spider> spiders;
  std::vector<bool> follows;       // rows that have no motion of their own (spider.h); empty: none
  Eigen::MatrixXd known_shapes;    // (6N + extra) x k: displacements whose stresses are known [m]
  Eigen::MatrixXd known_stresses;  // 6N x k: those at the nodes [Pa]
  std::string remark;              // for messages about rigid motion

  int node_count() const { return static_cast<int>(nodes.cols()); }
};

struct BeamMember {
  int first = 0, second = 0;                     // node indices
  int section = 0;                               // index into the sections
  Eigen::Vector3d up = Eigen::Vector3d::Zero();  // see beam_axes
};

// 3D frame. Every member gets a node in its middle: nodes 0..N-1 are the given ones, N + e is the middle of member e, and its
// two halves, one element each, are the segments 2 e and 2 e + 1. Mass and rotary inertia of cross sections are lumped by
// Simpson's rule (1/6, 4/6, 1/6), so that mass, centre and inertia of a straight member are exact and frequencies converge
// with h^4. Throws InputError: unknown node or section, member without length, node without member, disconnected frame.
FeModel beam_model(const std::vector<Eigen::Vector3d>& nodes, const std::vector<BeamMember>& members,
                   const std::vector<BeamSection>& sections, const Material& material);

// Thin shell on a connected triangle mesh (its mid-surface); a third of each triangle's mass at each corner, no rotary
// inertia.
FeModel plate_model(const TriangleMesh& mesh, double thickness, const Material& material,
                    const std::string& where = "plate");

MassProperties mass_properties(const FeModel& model);

// 6N x 6N: the mass matrix of the model, or its lumped masses and inertias (block-diagonal).
Eigen::SparseMatrix<double> mass_matrix(const FeModel& model);

// The model with masses scaled to the total `mass` [kg].
FeModel with_mass(FeModel model, double mass);

// --- Nodes at points of the reference configuration.

// Nodes with rotations, their own or from a rigid set.
std::vector<bool> turning_nodes(const FeModel& model);

// Index of the node nearest to the point: in D for a model, in B (relative to Bo) for a body. Of several nodes at one
// place the lowest: the node of a set (spider.h) precedes nodes of the mesh.
int nearest_node(const FeModel& model, const Eigen::Vector3d& p_D);
int nearest_node(const ModalBody& body, const Eigen::Vector3d& p_B);

// The node to which a joint at this point attaches; for a rigid set the node of the set. Throws InputError, with nearest node and
// distance, if none is within tolerance [m], or if the joint requires the rotation of a node that has none (solid models of other codes).
int joint_node(const FeModel& model, const Eigen::Vector3d& p_D, double tolerance, bool needs_rotation);
int joint_node(const ModalBody& body, const Eigen::Vector3d& p_B, double tolerance, bool needs_rotation);

// --- Checks before a model is reduced.

// Throws InputError beginning with `who`: sizes disagree, a mass or inertia is negative, the body has no mass or no inertia
// about some axis (the mass matrix is not positive), a node has no stiffness, pieces are disconnected, or the stiffness
// resists rigid-body motion (a support).
void check_model(const FeModel& model, const std::string& who);

// Throws InputError beginning with `who` if the model lacks an interface node.
void check_interface(const FeModel& model, const std::vector<int>& nodes, const std::string& who);

}  // namespace footfall

#pragma once
// Full and reduced models of other finite-element codes: stiffness and mass matrices with their nodes.
//
// Matrices, distinguished by their content; one or both triangles:
//   MatrixMarket        `%%MatrixMarket matrix coordinate real symmetric` (general, integer)
//   CalculiX            .sti and .mas of *FREQUENCY, SOLVER=MATRIXSTORAGE; their rows are in .dof: `node.direction`
//   Abaqus              .mtx of *MATRIX GENERATE (`node, dof, node, dof, value`, or `row column value`), and of
//                       *SUBSTRUCTURE GENERATE (`*USER ELEMENT`, `*MATRIX, TYPE=STIFFNESS`), as CalculiX writes it, too
//   Nastran             DMIG cards of a punch file: names that begin with K, and with M
// Rows without numbers of nodes go node by node in the order of the nodes' file, six or three per node.
// Rows of nodes that the nodes' file does not list are coordinates without a place: of fixed-interface modes
// (Craig-Bampton), or of modes within elements. They carry stiffness and mass, and do not move with the rigid body.
//
// Nothing is lumped here: mass, centre, inertia and modes follow from the matrices.

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/fe/fe_model.h"

namespace footfall {

// Units of lengths, masses and times in the files of a model.
enum class UnitSystem { kMetre, kMillimetreTonne, kMillimetreMillisecond, kInchPound };
constexpr std::string_view name_of(UnitSystem units) {
  return name_in(units, "m-kg-s", "mm-t-s", "mm-kg-ms", "in-lbf-s");
}

double mass_unit(UnitSystem units);    // [kg]
double length_unit(UnitSystem units);  // [m]

// A joint that acts on many nodes: an additional node, which moves with the set.
struct InterfaceSpec {
  std::string node_set;                  // its name in the file of nodes
  SpiderKind kind = SpiderKind::kRigid;  // see fe_model.h
  std::optional<Eigen::Vector3d> point;  // of the additional node, in D [m]; without: the mean of the set
};

struct MatrixFiles {
  std::string stiffness, mass, nodes;
  std::string rows = {};    // .dof; empty: the file next to a .sti
  std::string stress = {};  // .frd with modes and their stresses; may be empty
  UnitSystem units = UnitSystem::kMetre;
  std::vector<InterfaceSpec> interfaces = {};
};

// A free body in SI units. Throws InputError with path:line.
FeModel read_matrix_model(const MatrixFiles& files);

}  // namespace footfall

#pragma once
// Meshes of other finite-element codes: nodes with their numbers, elements, named sets, and the skin as triangles.
//
// gmsh .msh (2.2, 4.0 and 4.1, text and binary), Abaqus and CalculiX .inp, Nastran .bdf (.nas, .dat, .pch), CalculiX .frd.

#include <Eigen/Dense>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace footfall {

// Whose nodes on edges come in which order.
enum EdgeOrder { kAbaqus, kNastran, kGmsh };

// Corners, then nodes in the middle of edges.
struct MeshElement {
  int dimension = 0;       // 1 lines, 2 triangles and quadrangles, 3 solids
  int corners = 0;         // 2; 3, 4; 4, 5, 6, 8
  std::vector<int> nodes;  // indices of points
  EdgeOrder order = kAbaqus;
};

struct FeMesh {
  std::vector<long> ids;                         // numbers of the nodes in the file
  std::vector<Eigen::Vector3d> points;           // [units of the file]
  std::vector<MeshElement> elements;             // others, such as springs and masses, are left out
  std::map<std::string, std::vector<int>> sets;  // node sets, and the nodes of sets of elements; indices of points
  std::unordered_map<long, int> index;           // of a node's number
  std::string turned;                            // "line: ..." where displacements have axes of their own; else empty

  // Indices of a set, by its exact name, else whatever the case of its letters. Throws InputError with the known names.
  const std::vector<int>& set(const std::string& name, const std::string& file) const;
};

// Is this the end of the name of such a file?
bool is_fe_mesh_name(const std::string& file);

// `bytes`: the whole file. Throws InputError "file:line: ...".
FeMesh parse_fe_mesh(const std::string& bytes, const std::string& file);

// --- Results of a .frd file: modes with displacements and stresses of all nodes.

struct FrdModes {
  std::vector<Eigen::MatrixXd> displacements;  // 3 x N each, columns as points of the mesh
  std::vector<Eigen::MatrixXd> stresses;       // 6 x N each: xx yy zz xy yz zx
};
FrdModes parse_frd_modes(const std::string& bytes, const std::string& file, const FeMesh& mesh);

// The surface of a mesh of another finite-element code.

// The outer faces of solids, counter-clockwise seen from outside, else all faces of shells; elements with nodes on edges are
// cut there, so that all nodes of the surface are corners. Indices of points.
std::vector<Eigen::Vector3i> skin_of(const FeMesh& mesh);

}  // namespace footfall

#pragma once
// A surface of triangles, from generators and mesh files, for shells and boundaries: operations, checks, mass properties.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "mbd_solver/model/mass_properties.h"

namespace footfall {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;   // [m]
  std::vector<Eigen::Vector3i> triangles;  // indices into vertices, counter-clockwise seen from the normal's side
  std::vector<std::string> notes;          // remarks of the reader of its file
  std::string decimation;                  // how a decimated mesh differs from the given one; empty: not at all
};

// The mesh moved by x -> R x + p.
TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Matrix3d& R, const Eigen::Vector3d& p);

// Vertices closer to each other than tolerance [m] are merged, as STL files require, in the order of first occurrence;
// unused vertices are removed. Triangles remain even if they collapse: check_mesh finds those.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance);

// --- Defects, with triangle numbers from 0 in the order of the file.

struct MeshDemands {
  bool closed = false;     // every edge belongs to two triangles
  bool connected = false;  // one piece
  bool oriented = false;   // neighbours agree on which side is outside
};

// All defects, one sentence each; empty if there are none. Always checked: indices and coordinates are valid, no degenerate
// and no duplicate triangles (degenerate: height below 1e-6 of the longest edge).
std::vector<std::string> mesh_findings(const TriangleMesh& mesh, const MeshDemands& demands);

// Throws InputError with all defects, each beginning with `where` (a file or a body).
void check_mesh(const TriangleMesh& mesh, const MeshDemands& demands, const std::string& where);

// --- Mass, centre and inertia of a homogeneous solid with a closed surface: theory 1.1.

// Exact for the polyhedron that the triangles enclose: sums over the tetrahedra between each triangle (a, b, c) and a
// common point o, with positions relative to o and V_k = a . (b x c) / 6,
//   V = sum V_k,   V p = sum V_k (a + b + c) / 4,
//   integral of x x^T = sum V_k / 20 (a a^T + b b^T + c c^T + s s^T),   s = a + b + c
// density [kg/m3]. A shell within another shell is a cavity if it faces inward.
// Throws InputError beginning with `where`: defects of check_mesh, a surface that is not closed or not consistently
// oriented, and shells that bound no solid (require_solid).
MassProperties polyhedron_properties(const TriangleMesh& mesh, double density, const std::string& where);

}  // namespace footfall

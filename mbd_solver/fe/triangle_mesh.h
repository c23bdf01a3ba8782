#pragma once
// A surface of triangles: what generators and mesh files give, and plates and boundaries are made of.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "mbd_solver/model/mass_properties.h"

namespace footfall {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;   // [m]
  std::vector<Eigen::Vector3i> triangles;  // indices into vertices, counter-clockwise seen from the normal's side
};

// The mesh moved by x -> R x + p.
TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Matrix3d& R, const Eigen::Vector3d& p);

// Vertices nearer to each other than tolerance [m] made one, as STL files need; order of first occurrence is
// kept, vertices that no triangle uses are left out. Triangles are kept as they are, even if they collapse:
// check_mesh finds those.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance);

// What is wrong with a triangle mesh, told with triangle numbers (from 0, as in the file's order).

struct MeshDemands {
  bool closed = false;     // every edge belongs to two triangles
  bool connected = false;  // one piece
  bool oriented = false;   // neighbours agree on which side is outside
};

// All findings, one sentence each; empty: the mesh is good. Always checked: indices and coordinates are
// valid, no degenerate and no duplicate triangles (a triangle is degenerate when its height is less than 1e-6
// of its longest edge).
std::vector<std::string> mesh_findings(const TriangleMesh& mesh, const MeshDemands& demands);

// Throws InputError with all findings, each led by `where` (a file or a body).
void check_mesh(const TriangleMesh& mesh, const MeshDemands& demands, const std::string& where);

// Mass, centre and inertia of a solid of one density whose surface is a closed mesh: theory 1.1.

// Exact for the polyhedron that the triangles enclose: sums over the tetrahedra between each triangle (a, b, c) and a
// common point o, with positions relative to o and V_k = a . (b x c) / 6,
//   V = sum V_k,   V p = sum V_k (a + b + c) / 4,
//   integral of x x^T = sum V_k / 20 (a a^T + b b^T + c c^T + s s^T),   s = a + b + c
// density [kg/m3]. Pieces that lie within another one and face inward are cavities.
// Throws InputError, each message led by `where`: triangles that check_mesh refuses, a surface that is not closed or
// whose sides disagree, one that faces inward, one that encloses nothing.
MassProperties polyhedron_properties(const TriangleMesh& mesh, double density, const std::string& where);

}  // namespace footfall

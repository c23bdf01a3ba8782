#pragma once
// What is wrong with a triangle mesh, told with triangle numbers (from 0, as in the file's order).

#include <string>
#include <vector>

#include "mbd_solver/fe/triangle_mesh.h"

namespace footfall {

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

}  // namespace footfall

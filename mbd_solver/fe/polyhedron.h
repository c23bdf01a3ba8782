#pragma once
// Mass, centre and inertia of a solid of one density whose surface is a closed mesh: theory 1.1.

#include <string>

#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/model/mass_properties.h"

namespace footfall {

// Exact for the polyhedron that the triangles enclose: sums over the tetrahedra between each triangle (a, b, c) and a
// common point o, with positions relative to o and V_k = a . (b x c) / 6,
//   V = sum V_k,   V p = sum V_k (a + b + c) / 4,
//   integral of x x^T = sum V_k / 20 (a a^T + b b^T + c c^T + s s^T),   s = a + b + c
// density [kg/m3]. Pieces that lie within another one and face inward are cavities.
// Throws InputError, each message led by `where`: triangles that check_mesh refuses, a surface that is not closed or
// whose sides disagree, one that faces inward, one that encloses nothing.
MassProperties polyhedron_properties(const TriangleMesh& mesh, double density, const std::string& where);

}  // namespace footfall

#pragma once
// Meshes of simple shapes, with near-uniform triangles. All throw InputError on impossible lengths.

#include "mbd_solver/fe/triangle_mesh.h"

namespace footfall {

// Disc in the xy plane about the origin, normals along z. Vertex 0 is the centre, ring k has 6 k vertices; sixfold symmetric.
// The rim is a polygon on the circle: its area is the circle's times 1 - (pi / (3 n))^2 / 6 for n rings.
TriangleMesh disc_mesh(double radius, double edge);

// Closed disc of the given thickness about the origin, normals outward: two faces as above at z = +- thickness/2, and
// the rim between them. The vertices of the upper face come first.
TriangleMesh thick_disc_mesh(double radius, double thickness, double edge);

// Closed capsule about the origin, axis z, normals outward: a cylinder of the given length with half a ball at each
// end.
TriangleMesh capsule_mesh(double radius, double length, double edge);

// Spherical cap: lowest point (vertex 0) at the origin, rim of the given radius at height `depth`, opening along z; normals
// point to the inside (+z at the lowest point). depth <= rim radius.
TriangleMesh dish_mesh(double rim_radius, double depth, double edge);

// Closed surface of a box about the origin, edges along the axes, normals outward.
TriangleMesh box_mesh(const Eigen::Vector3d& size, double edge);

}  // namespace footfall

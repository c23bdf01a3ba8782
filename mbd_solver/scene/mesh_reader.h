#pragma once
// Triangle meshes from files: STL (ASCII and binary), OBJ, PLY.

#include <string>

#include "mbd_solver/fe/triangle_mesh.h"

namespace footfall {

// Coordinates times `scale` [m per unit of the file]; vertices that coincide are made one; polygons are cut into
// triangles.
// Throws InputError, naming the file: not there, not readable, another format, no triangles.
TriangleMesh read_mesh(const std::string& file, double scale = 1.0);

}  // namespace footfall

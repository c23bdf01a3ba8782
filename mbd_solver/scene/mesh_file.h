#pragma once
// Triangles of STL (text and binary), OBJ, PLY (text and binary) and OFF files, with all digits of their coordinates, and the
// skin of meshes of finite-element codes (fe/fe_mesh.h).

#include <string>

#include "mbd_solver/fe/triangle_mesh.h"

namespace footfall {

// For messages: the ends of the names of files that can be read.
inline constexpr const char* kMeshEnds =
    ".stl, .obj, .ply, .off, .msh (gmsh), .inp (Abaqus, CalculiX) or .bdf (Nastran)";
bool is_mesh_name(const std::string& file);

struct MeshFile {
  TriangleMesh mesh;     // in units of the file; of STL each triangle with corners of its own
  bool single = false;   // coordinates are stored in single precision
  double spacing = 0.0;  // of its numbers around the largest coordinate [units of the file]; 0: as in double precision
};

// `bytes`: the whole file; `file`: its name, whose ending gives the format, for messages "file:line: ...". Polygons are
// cut into triangles, points, lines and all but positions left out. Throws InputError: anything that is no mesh, is cut off,
// has other numbers of elements than it announces, decimal commas, or corners that do not exist.
MeshFile parse_mesh(const std::string& bytes, const std::string& file);

}  // namespace footfall

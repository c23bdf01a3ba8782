#pragma once
// Triangle meshes from files - STL (text and binary), OBJ, PLY (text and binary), OFF, and the skin of meshes of finite-element
// codes (fe/fe_mesh.h) -, and the surfaces of boundaries. Coordinates are in double precision from the file on.

#include <functional>
#include <string>

#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/scene/scene.h"

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

// Coordinates times `scale` [m per unit of the file]; vertices that coincide are made one; polygons are cut into
// triangles.
// Notes: coordinates with few digits for the mesh's distance from the origin of its file.
// Throws InputError, naming the file: not there, not readable, another format, damaged, no triangles, digits lost.
TriangleMesh read_mesh(const std::string& file, double scale = 1.0);

// A reader in a process of its own: a damaged file that crashes it ends that process only.
// The result of `read`, which runs in a copy of this process with bounded memory and processor time for a file of so many
// bytes. Throws InputError with the message of what `read` throws, or that names `file` when the reader crashes or exceeds
// its limits.
std::string read_apart(const std::string& file, std::size_t bytes, const std::function<std::string()>& read);

// The surface of a boundary in the drawing frame D, from a file or from the shape of its body.
// Triangles of the boundary's surface, from its file or the body's shape. Dishes, and discs with faces = "middle", give their
// mid-surface (one layer: meshes of LIGGGHTS act on both sides), other shapes a closed surface with outward normals.
// Checked: no degenerate or duplicate triangles, closed where required. Empty without a surface. Throws InputError.
TriangleMesh boundary_surface(const Scene& scene, const BoundarySpec& boundary);

// The surface of the body's shape in D. The edge is a tenth of its size unless the surface gives one. A mesh is read from
// its file. Empty for points. Throws InputError.
TriangleMesh shape_surface(const BodySpec& body, const SurfaceSpec& surface);
// The file of a shape of kind mesh, scaled, turned and moved into D. Throws InputError.
TriangleMesh mesh_of_shape(const ShapeSpec& shape);

// Surface of a tube or rod between two points (closed cylinder), and of a sphere about the origin; edge: longest edge [m].
TriangleMesh cylinder_mesh(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter, double edge);
TriangleMesh sphere_mesh(double radius, double edge);

// The nodes of a model in matrices come with elements (fe/fe_mesh.h), whose skin is the body's surface.
bool has_model_mesh(const BodySpec& body);

}  // namespace footfall

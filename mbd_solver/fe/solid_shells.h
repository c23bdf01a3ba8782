#pragma once
// Whether the closed shells of a mesh bound a solid: none crosses another or itself, and every point is within it once or not
// at all.

#include <string>

#include "mbd_solver/fe/triangle_mesh.h"

namespace footfall {

// mesh: closed and oriented (mesh_findings). A shell within another that faces inward is a cavity, one within a cavity a
// solid; shells may touch. Surfaces nearer than a millionth of the mesh's size count as touching.
// Throws InputError beginning with `where`, with numbers of triangles: a shell encloses nothing, faces inward, lies within
// another and faces outward as well, or triangles of shells that overlap.
void require_solid(const TriangleMesh& mesh, const std::string& where);

}  // namespace footfall

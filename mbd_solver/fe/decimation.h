#pragma once
// Fewer triangles for nearly the same surface: for meshes whose every node would cost time in every step.

#include <cstddef>

#include "mbd_solver/fe/triangle_mesh.h"

namespace footfall {

struct Decimation {
  TriangleMesh mesh;
  // Largest distance of a corner of the given mesh from the new surface, and of a new corner from the given surface [m].
  double distance = 0.0;
  double volume_change = 0.0;  // of the enclosed volume, relative to the given one; 0 for surfaces with a rim
};

// At most `most` triangles, or as few as can be had without changing how triangles are connected, turning one over or making
// a needle. A closed surface remains closed, a rim remains a rim; each collapse keeps the enclosed volume.
// The mesh is without the defects that check_mesh finds.
Decimation decimated(const TriangleMesh& mesh, std::size_t most);

}  // namespace footfall

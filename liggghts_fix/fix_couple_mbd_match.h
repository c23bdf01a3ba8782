#pragma once
// Which boundary nodes of a body stand at the corners of a stock LIGGGHTS mesh whose triangles are spread over the
// ranks.

#include <mpi.h>

#include <string>
#include <vector>

#include "coupler/messages.h"
#include "liggghts_fix/mesh_match.h"

namespace LAMMPS_NS {

class TriMesh;

// By element id, for all elements of the mesh, which may be a part of the body's surface. Every rank matches the triangles it owns (all of them before the first
// run), then the ranks share the result. Throws InputError, the same on all ranks, when mesh and body do not fit.
// Collective over `world`.
std::vector<footfall::CornerNodes> match_over_ranks(TriMesh* mesh, const std::string& mesh_id,
                                                    const footfall::CoupledBody& body, MPI_Comm world);

// By element id: the velocities that LIGGGHTS holds for the three corners of each triangle, in W [m/s]. Collective.
std::vector<Eigen::Matrix3d> velocities_over_ranks(TriMesh* mesh, double*** v, std::size_t elements, MPI_Comm world);

// What a mesh holds of a body's surface.
struct PartOfSurface {
  std::string mesh;
  const std::vector<footfall::CornerNodes>& corners;
};
// Throws InputError unless the parts together are the surface of the body, each triangle once.
void check_whole_surface(const footfall::ModalBoundary& boundary, const std::vector<PartOfSurface>& parts);

}  // namespace LAMMPS_NS

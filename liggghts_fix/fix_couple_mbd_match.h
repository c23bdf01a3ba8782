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

// By element id, for all elements of the mesh. Every rank matches the triangles it owns (all of them before the first
// run), then the ranks share the result. Throws InputError, the same on all ranks, when mesh and body do not fit.
// Collective over `world`.
std::vector<footfall::CornerNodes> match_over_ranks(TriMesh* mesh, const std::string& mesh_id,
                                                    const footfall::CoupledBody& body, MPI_Comm world);

}  // namespace LAMMPS_NS

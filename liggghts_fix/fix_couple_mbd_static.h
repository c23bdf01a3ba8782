#pragma once
// Walls of the script that stand still: what bodies of the scene must not go through, or are held by.

#include <mpi.h>

#include <string>
#include <vector>

#include "coupler/messages.h"

namespace LAMMPS_NS {

class Modify;

// Planes of fix wall/gran, and the meshes of fix wall/gran that neither a body of the scene nor the script moves; their
// triangles are gathered from all ranks. Meshes that the script moves are warned of. Collective.
std::vector<footfall::StaticWall> static_walls(Modify& modify, MPI_Comm world, std::vector<std::string>& warnings);

// Those of `walls` that no longer stand there.
std::vector<std::string> gone_walls(Modify& modify, const std::vector<footfall::StaticWall>& walls);

}  // namespace LAMMPS_NS

#pragma once
// LIGGGHTS and VTK sometimes say MPI_COMM_WORLD where they mean "all ranks of LIGGGHTS" (dump custom/vtk duplicates it,
// and would wait for ever for mbd_solver to do the same). Through MPI's profiling interface these calls get the ranks
// of this program instead.

#include <mpi.h>

namespace footfall {

// From now on MPI_Comm_dup, MPI_Comm_size, MPI_Comm_rank, MPI_Gather and MPI_Barrier of anybody in this process take
// MPI_COMM_WORLD as `program`. MPI_COMM_WORLD itself restores their meaning.
void let_world_mean(MPI_Comm program);

}  // namespace footfall

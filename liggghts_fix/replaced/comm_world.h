#pragma once
// LIGGGHTS and VTK use MPI_COMM_WORLD in places where they mean all ranks of LIGGGHTS: dump custom/vtk duplicates it and
// would wait for ever for mbd_solver to do the same. MPI_Barrier, MPI_Comm_dup, MPI_Comm_rank, MPI_Comm_size and
// MPI_Gather are therefore replaced through MPI's profiling interface.

#include <mpi.h>

namespace footfall {

inline MPI_Comm comm_world_target = MPI_COMM_WORLD;

// From now on these five functions take MPI_COMM_WORLD as `program`, whoever in this process calls them. MPI_COMM_WORLD
// itself restores their meaning.
inline void redirect_comm_world(MPI_Comm program) { comm_world_target = program; }

inline MPI_Comm redirected(MPI_Comm comm) { return comm == MPI_COMM_WORLD ? comm_world_target : comm; }

}  // namespace footfall

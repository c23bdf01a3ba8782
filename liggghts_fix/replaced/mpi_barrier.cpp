// MPI_Barrier, redirected to the ranks of this program (comm_world.h).

#include "liggghts_fix/replaced/comm_world.h"

extern "C" int MPI_Barrier(MPI_Comm comm) { return PMPI_Barrier(footfall::redirected(comm)); }

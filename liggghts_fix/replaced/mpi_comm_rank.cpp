// MPI_Comm_rank, redirected to the ranks of this program (comm_world.h).

#include "liggghts_fix/replaced/comm_world.h"

extern "C" int MPI_Comm_rank(MPI_Comm comm, int* rank) { return PMPI_Comm_rank(footfall::redirected(comm), rank); }

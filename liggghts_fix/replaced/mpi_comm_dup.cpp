// MPI_Comm_dup, redirected to the ranks of this program (comm_world.h).

#include "liggghts_fix/replaced/comm_world.h"

extern "C" int MPI_Comm_dup(MPI_Comm comm, MPI_Comm* copy) { return PMPI_Comm_dup(footfall::redirected(comm), copy); }

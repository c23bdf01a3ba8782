// MPI_Comm_size, redirected to the ranks of this program (comm_world.h).

#include "liggghts_fix/replaced/comm_world.h"

extern "C" int MPI_Comm_size(MPI_Comm comm, int* size) { return PMPI_Comm_size(footfall::redirected(comm), size); }

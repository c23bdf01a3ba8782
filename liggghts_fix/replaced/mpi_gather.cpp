// MPI_Gather, redirected to the ranks of this program (comm_world.h).

#include "liggghts_fix/replaced/comm_world.h"

extern "C" int MPI_Gather(const void* send, int send_count, MPI_Datatype send_type, void* receive, int receive_count,
                          MPI_Datatype receive_type, int root, MPI_Comm comm) {
  return PMPI_Gather(send, send_count, send_type, receive, receive_count, receive_type, root,
                     footfall::redirected(comm));
}

#include "liggghts_fix/program_world.h"

namespace {

MPI_Comm g_world = MPI_COMM_WORLD;

MPI_Comm meant(MPI_Comm comm) { return comm == MPI_COMM_WORLD ? g_world : comm; }

}  // namespace

void footfall::let_world_mean(MPI_Comm program) { g_world = program; }

// The profiling interface: every MPI_X may be defined by the program, and PMPI_X is the library's own. The launcher
// exports its symbols, so that the shared libraries below it find these first.
extern "C" {

int MPI_Comm_dup(MPI_Comm comm, MPI_Comm* copy) { return PMPI_Comm_dup(meant(comm), copy); }

int MPI_Comm_size(MPI_Comm comm, int* size) { return PMPI_Comm_size(meant(comm), size); }

int MPI_Comm_rank(MPI_Comm comm, int* rank) { return PMPI_Comm_rank(meant(comm), rank); }

int MPI_Barrier(MPI_Comm comm) { return PMPI_Barrier(meant(comm)); }

int MPI_Gather(const void* send, int send_count, MPI_Datatype send_type, void* receive, int receive_count,
               MPI_Datatype receive_type, int root, MPI_Comm comm) {
  return PMPI_Gather(send, send_count, send_type, receive, receive_count, receive_type, root, meant(comm));
}
}

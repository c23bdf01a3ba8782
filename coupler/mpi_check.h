#pragma once
// The one wrapper around MPI's return codes. It needs no mpi.h: a code is an int.

namespace footfall {

// Throws PartnerError with MPI's own text unless code is MPI_SUCCESS.
void check_mpi(int code, const char* call);

}  // namespace footfall

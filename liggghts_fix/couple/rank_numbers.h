#pragma once
#include <mpi.h>

#include <vector>

namespace footfall {

// The numbers of all ranks, in their order. Collective. Throws PartnerError.
std::vector<double> of_all_ranks(const std::vector<double>& mine, MPI_Comm world);

}  // namespace footfall

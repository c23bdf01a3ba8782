// The ranks may have different counts of numbers.

#include "liggghts_fix/couple/rank_numbers.h"

#include "coupler/communicator.h"

namespace footfall {

std::vector<double> of_all_ranks(const std::vector<double>& mine, MPI_Comm world) {
  int ranks = 1;
  MPI_Comm_size(world, &ranks);
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(ranks), starts(ranks);
  check_mpi(MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, world), "MPI_Allgather");
  int all = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    starts[rank] = all;
    all += counts[rank];
  }
  std::vector<double> numbers(all);
  check_mpi(
      MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, numbers.data(), counts.data(), starts.data(), MPI_DOUBLE, world),
      "MPI_Allgatherv");
  return numbers;
}

}  // namespace footfall

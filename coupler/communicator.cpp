// Every rank gathers the program numbers of all; where all run on one machine, each also opens a doorbell.

#include "coupler/communicator.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <set>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/codes.h"
#include "coupler/programs.h"

namespace footfall {
namespace {

// The same on all ranks and unique on this machine: process and time of rank 0. Collective.
std::string name_of_job() {
  char name[64] = {};
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  std::snprintf(name, sizeof name, "footfall.%d.%lld", static_cast<int>(getpid()), static_cast<long long>(now));
  check_mpi(MPI_Bcast(name, sizeof name, MPI_CHAR, 0, MPI_COMM_WORLD), "MPI_Bcast");
  return name;
}

// Collective.
bool all_on_one_machine(int world_size) {
  MPI_Comm machine = MPI_COMM_NULL;
  int here = 0, fewest = 0;
  check_mpi(MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine),
            "MPI_Comm_split_type");
  MPI_Comm_size(machine, &here);
  MPI_Comm_free(&machine);
  check_mpi(MPI_Allreduce(&here, &fewest, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD), "MPI_Allreduce");
  return fewest == world_size;
}

// On all ranks or on none, and open before any rank rings. Collective.
std::unique_ptr<Doorbell> open_doorbell(int world_rank, int world_size) {
  auto doorbell = std::make_unique<Doorbell>(name_of_job(), world_rank);
  const int mine = all_on_one_machine(world_size) && doorbell->works() ? 1 : 0;
  int all = 0;
  check_mpi(MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD), "MPI_Allreduce");
  if (!all) doorbell.reset();
  return doorbell;
}

}  // namespace

void check_mpi(int result, const char* call) {
  if (result == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(result, text, &length);
  throw PartnerError(code::kMpiCallFailed,
                     std::string(call) + ": " + std::string(text, static_cast<std::size_t>(length)));
}

Communicator::Communicator() {
  int world_rank = 0, world_size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &world_rank);
  MPI_Comm_size(MPI_COMM_WORLD, &world_size);
  int* app_number = nullptr;
  int known = 0;
  MPI_Comm_get_attr(MPI_COMM_WORLD, MPI_APPNUM, &app_number, &known);
  const int mine = known ? *app_number : 0;

  std::vector<int> apps(static_cast<std::size_t>(world_size));
  check_mpi(MPI_Allgather(&mine, 1, MPI_INT, apps.data(), 1, MPI_INT, MPI_COMM_WORLD), "MPI_Allgather");
  const std::size_t programs = std::set<int>(apps.begin(), apps.end()).size();
  if (programs > 2)
    throw InputError(code::kTooManyPrograms, "this mpirun started " + std::to_string(programs) +
                                                 " programs; footfall couples two: " + kStartBoth);

  check_mpi(MPI_Comm_split(MPI_COMM_WORLD, mine, world_rank, &own_), "MPI_Comm_split");
  check_mpi(MPI_Comm_dup(MPI_COMM_WORLD, &exchange_), "MPI_Comm_dup");
  check_mpi(MPI_Comm_set_errhandler(exchange_, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
  MPI_Comm_rank(own_, &rank_);
  MPI_Comm_size(own_, &size_);
  for (int rank = world_size - 1; rank >= 0; --rank)
    if (apps[rank] != mine) partner_root_ = rank;
  for (int rank = 0; rank < world_size; ++rank)
    if (apps[rank] == mine) own_ranks_.push_back(rank);
  if (has_partner()) doorbell_ = open_doorbell(world_rank, world_size);
}

Communicator::~Communicator() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized) return;
  MPI_Comm_free(&own_);
  MPI_Comm_free(&exchange_);
}

}  // namespace footfall

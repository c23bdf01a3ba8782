#include "coupler/communicator.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"

namespace footfall {

void check_mpi(int code, const char* call) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  throw PartnerError(std::string(call) + ": " + std::string(text, static_cast<std::size_t>(length)));
}

void wait_politely(MPI_Request& request, const Doorbell* doorbell) {
  PoliteWait wait(doorbell);
  for (;;) {
    int done = 0;
    check_mpi(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "MPI_Test");
    if (done) return;
    wait.nap();
  }
}

void PoliteWait::nap() {
  using Seconds = std::chrono::duration<double>;
  constexpr double kWorthSleeping = 10e-3, kPart = 0.75;  // [s]; share of the expected time slept in one go
  // of the time waited; [s]
  constexpr double kShare = 1.0 / 64.0, kShortest = 5e-6, kLongest = 500e-6, kLongestWithBell = 5e-3;
  double nap = kPart * expected_;
  if (expected_ > kWorthSleeping) {
    expected_ = 0.0;
  } else {
    const double waited = wall_clock() - start_;
    nap = std::clamp(kShare * waited, kShortest, doorbell_ ? kLongestWithBell : kLongest);
  }
  if (doorbell_)
    doorbell_->wait(nap);
  else
    std::this_thread::sleep_for(Seconds(nap));
}

namespace {

// A name that no other job on this machine has, the same on all ranks: process and time of rank 0. Collective.
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

// On all ranks or on none, and hung up before anybody rings. Collective.
std::unique_ptr<Doorbell> hang_up_doorbell(int world_rank, int world_size) {
  auto doorbell = std::make_unique<Doorbell>(name_of_job(), world_rank);
  const int mine = all_on_one_machine(world_size) && doorbell->works() ? 1 : 0;
  int all = 0;
  check_mpi(MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD), "MPI_Allreduce");
  if (!all) doorbell.reset();
  return doorbell;
}

}  // namespace

void abort_both_programs(int exit_code) {
  // Not MPI_Abort: when several ranks end at once, Open MPI's mpirun may crash or hang over its abort messages. A
  // process that ends without MPI_Finalize is enough for mpirun to end all others, and its exit code becomes the job's.
  std::fflush(nullptr);
  _exit(exit_code);
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
    throw InputError("this mpirun started " + std::to_string(programs) +
                     " programs; footfall couples two: mpirun -np N liggghts_mbd -in SCRIPT : -np 1 mbd_solver SCENE");

  check_mpi(MPI_Comm_split(MPI_COMM_WORLD, mine, world_rank, &own_), "MPI_Comm_split");
  check_mpi(MPI_Comm_dup(MPI_COMM_WORLD, &exchange_), "MPI_Comm_dup");
  check_mpi(MPI_Comm_set_errhandler(exchange_, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
  MPI_Comm_rank(own_, &rank_);
  MPI_Comm_size(own_, &size_);
  for (int rank = world_size - 1; rank >= 0; --rank)
    if (apps[static_cast<std::size_t>(rank)] != mine) partner_root_ = rank;
  for (int rank = 0; rank < world_size; ++rank)
    if (apps[static_cast<std::size_t>(rank)] == mine) own_seats_.push_back(rank);
  if (has_partner()) doorbell_ = hang_up_doorbell(world_rank, world_size);
}

Communicator::~Communicator() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized) return;
  MPI_Comm_free(&own_);
  MPI_Comm_free(&exchange_);
}

namespace {

// One per process, as MPI_COMM_SELF is.
struct Guard {
  bool released = false;
  std::function<bool()> last_words;
};

Guard& guard() {
  static Guard one;
  return one;
}

int on_finalize(MPI_Comm, int, void*, void*) {
  if (guard().released) return MPI_SUCCESS;
  guard().released = true;
  const bool heard = guard().last_words && guard().last_words();
  if (!heard) abort_both_programs(kExitFailed);
  return MPI_SUCCESS;
}

}  // namespace

void AbortGuard::install(const Communicator& communicator, std::function<bool()> last_words) {
  guard().released = !communicator.has_partner() || !communicator.is_root();
  guard().last_words = std::move(last_words);
  int key = MPI_KEYVAL_INVALID;
  check_mpi(MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, on_finalize, &key, nullptr), "MPI_Comm_create_keyval");
  check_mpi(MPI_Comm_set_attr(MPI_COMM_SELF, key, nullptr), "MPI_Comm_set_attr");
}

void AbortGuard::set_last_words(std::function<bool()> last_words) { guard().last_words = std::move(last_words); }

void AbortGuard::release() { guard().released = true; }

}  // namespace footfall

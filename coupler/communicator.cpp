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

#include "coupler/errors.h"

namespace footfall {

void check_mpi(int code, const char* call) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  throw PartnerError(std::string(call) + ": " + std::string(text, static_cast<std::size_t>(length)));
}

void wait_politely(MPI_Request& request) {
  PoliteWait wait;
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
  constexpr double kShare = 1.0 / 64.0, kShortest = 5e-6, kLongest = 500e-6;  // of the time waited; [s]
  if (expected_ > kWorthSleeping) {
    std::this_thread::sleep_for(Seconds(kPart * expected_));
    expected_ = 0.0;
    return;
  }
  const double waited = Seconds(std::chrono::steady_clock::now() - start_).count();
  std::this_thread::sleep_for(Seconds(std::clamp(kShare * waited, kShortest, kLongest)));
}

void abort_both_programs(int exit_code) {
  // Not MPI_Abort: when several ranks end at once, Open MPI's mpirun may crash or hang over its abort messages. A process that ends without
  // MPI_Finalize is enough for mpirun to end all others, and its exit code becomes the job's.
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
    throw InputError(
        "this mpirun started " + std::to_string(programs) +
        " programs; footfall couples two: mpirun -np N liggghts_mbd -in SCRIPT : -np 1 mbd_solver SCENE");

  check_mpi(MPI_Comm_split(MPI_COMM_WORLD, mine, world_rank, &own_), "MPI_Comm_split");
  check_mpi(MPI_Comm_dup(MPI_COMM_WORLD, &exchange_), "MPI_Comm_dup");
  check_mpi(MPI_Comm_set_errhandler(exchange_, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
  MPI_Comm_rank(own_, &rank_);
  MPI_Comm_size(own_, &size_);
  for (int rank = world_size - 1; rank >= 0; --rank)
    if (apps[static_cast<std::size_t>(rank)] != mine) partner_root_ = rank;
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
  check_mpi(MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, on_finalize, &key, nullptr),
            "MPI_Comm_create_keyval");
  check_mpi(MPI_Comm_set_attr(MPI_COMM_SELF, key, nullptr), "MPI_Comm_set_attr");
}

void AbortGuard::set_last_words(std::function<bool()> last_words) {
  guard().last_words = std::move(last_words);
}

void AbortGuard::release() {
  guard().released = true;
}

}  // namespace footfall

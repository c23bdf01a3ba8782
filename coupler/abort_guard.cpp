// A delete callback on an attribute of MPI_COMM_SELF: MPI_Finalize calls it before it takes MPI down.

#include "coupler/abort_guard.h"

#include <mpi.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/communicator.h"
#include "coupler/programs.h"

namespace footfall {
namespace {

// One per process, as MPI_COMM_SELF is.
struct Guard {
  bool released = false;
  std::function<bool()> final_message;
};

Guard& guard() {
  static Guard one;
  return one;
}

int on_finalize(MPI_Comm, int, void*, void*) {
  if (guard().released) return MPI_SUCCESS;
  guard().released = true;
  const bool received = guard().final_message && guard().final_message();
  if (!received) abort_both_programs(kExitFailed);
  return MPI_SUCCESS;
}

}  // namespace

void abort_both_programs(int exit_code) {
  // Not MPI_Abort: when several ranks end at once, Open MPI's mpirun may crash or hang over its abort messages. A
  // process that ends without MPI_Finalize makes mpirun end all others, and the job ends with its exit code.
  std::fflush(nullptr);
  if (exit_code == kExitFailed) note_failure();
  _exit(exit_code);
}

void AbortGuard::install(const Communicator& communicator, std::function<bool()> final_message) {
  guard().released = !communicator.has_partner() || !communicator.is_root();
  guard().final_message = std::move(final_message);
  int key = MPI_KEYVAL_INVALID;
  check_mpi(MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, on_finalize, &key, nullptr), "MPI_Comm_create_keyval");
  check_mpi(MPI_Comm_set_attr(MPI_COMM_SELF, key, nullptr), "MPI_Comm_set_attr");
}

void AbortGuard::set_final_message(std::function<bool()> final_message) {
  guard().final_message = std::move(final_message);
}

void AbortGuard::release() { guard().released = true; }

}  // namespace footfall

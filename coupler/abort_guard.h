#pragma once
// Neither program outlives the other, even when one ends without closing the coupling.

#include <functional>

namespace footfall {

class Communicator;

// Ends both programs at once with this exit code: the last resort, when the partner does not answer any more.
[[noreturn]] void abort_both_programs(int exit_code);

// Foreign code may end a program by MPI_Finalize and exit; the partner would then wait for ever. MPI_Finalize first
// frees the attributes of MPI_COMM_SELF, which calls the guard. Unless it was released, the guard calls `final_message`
// (which may still send a message, and returns whether the partner received it); without success it aborts both
// programs with status 1.
class AbortGuard {
 public:
  // Call once, after MPI_Init. The guard acts at the root of a program with a partner; elsewhere it is released.
  static void install(const Communicator& communicator, std::function<bool()> final_message = {});
  static void set_final_message(std::function<bool()> final_message);
  // From here on MPI_Finalize is a normal end.
  static void release();
};

}  // namespace footfall

#pragma once
// Neither program outlives the other: what happens when one of them ends without having said so.

#include <functional>

namespace footfall {

class Communicator;

// Ends both programs at once with this exit code: the last resort, when the partner does not answer any more.
[[noreturn]] void abort_both_programs(int exit_code);

// Some code ends a program with MPI_Finalize and exit, and the partner would wait for ever. MPI_Finalize first frees
// the attributes of MPI_COMM_SELF: there the guard looks whether the program was released. If not, it calls
// `last_words` (which may still send a message and says whether the partner has heard it); if that is not so, it aborts
// both programs with status 1.
class AbortGuard {
 public:
  // Call once, after MPI_Init. It watches the root of a program with a partner; elsewhere it is released from the
  // start.
  static void install(const Communicator& communicator, std::function<bool()> last_words = {});
  static void set_last_words(std::function<bool()> last_words);
  // From here on MPI_Finalize is a normal end.
  static void release();
};

}  // namespace footfall

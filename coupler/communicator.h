#pragma once
// Who runs with whom under one mpirun: splits MPI_COMM_WORLD into the two programs, and makes sure that
// neither outlives the other.

#include <mpi.h>

#include <functional>
#include <memory>
#include <vector>

#include "coupler/base/clock.h"
#include "coupler/doorbell.h"

namespace footfall {

// Splits the world by MPI_APPNUM, the number of the program on mpirun's command line
//   mpirun -np 2 liggghts_mbd ... : -np 1 mbd_solver ...
// With one program only there is no partner and world() is a duplicate of MPI_COMM_WORLD. Collective over
// MPI_COMM_WORLD: both programs construct one right after MPI_Init. Throws InputError when there are more
// than two programs.
class Communicator {
 public:
  Communicator();
  ~Communicator();
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  MPI_Comm world() const { return own_; }  // the ranks of this program
  int rank() const { return rank_; }       // within world()
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }
  bool has_partner() const { return partner_root_ >= 0; }
  MPI_Comm exchange() const { return exchange_; }     // both programs, for transport_mpi alone
  int partner_root() const { return partner_root_; }  // rank of the partner's rank 0 in exchange(); -1 without one

  // null unless the whole job runs on this machine; seats: ranks in exchange()
  const Doorbell* doorbell() const { return doorbell_.get(); }
  const std::vector<int>& own_seats() const { return own_seats_; }  // of the ranks of this program

 private:
  MPI_Comm own_ = MPI_COMM_NULL;
  MPI_Comm exchange_ = MPI_COMM_NULL;
  int rank_ = 0;
  int size_ = 1;
  int partner_root_ = -1;
  std::unique_ptr<Doorbell> doorbell_;
  std::vector<int> own_seats_;
};

// Throws PartnerError with MPI's own text unless code is MPI_SUCCESS.
void check_mpi(int code, const char* call);

// Waiting without keeping a core busy: Open MPI's own blocking calls spin. Three quarters of a wait that is expected
// to be long are slept through; then one looks again after 1/64 of the time waited so far, 5 to 500 microseconds: what
// is lost stays a small part of every wait, and who looks seldom does not push the other program off its core. A
// doorbell ends a nap when it rings, so that with one the naps may last up to 5 milliseconds.
class PoliteWait {
 public:
  explicit PoliteWait(const Doorbell* doorbell, double expected_seconds = 0.0)
      : doorbell_(doorbell), expected_(expected_seconds), start_(wall_clock()) {}
  void nap();

 private:
  const Doorbell* doorbell_;  // may be null
  double expected_;           // [s]
  double start_;              // [s]
};
void wait_politely(MPI_Request& request, const Doorbell* doorbell);

// Ends both programs at once with this exit code: the last resort, when the partner does not answer any more.
[[noreturn]] void abort_both_programs(int exit_code);

// Abort guard. Some code ends a program with MPI_Finalize and exit, and the partner would wait for ever.
// MPI_Finalize first frees the attributes of MPI_COMM_SELF: there the guard looks whether the program was
// released. If not, it calls `last_words` (which may still send a message and says whether the partner has
// heard it); if that is not so, it aborts both programs with status 1.
class AbortGuard {
 public:
  // Call once, after MPI_Init. It watches the root of a program with a partner; elsewhere it is released from
  // the start.
  static void install(const Communicator& communicator, std::function<bool()> last_words = {});
  static void set_last_words(std::function<bool()> last_words);
  // From here on MPI_Finalize is a normal end.
  static void release();
};

}  // namespace footfall

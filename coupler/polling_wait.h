#pragma once
// Waiting for messages without keeping a core busy, which the other program may need: Open MPI's blocking calls spin.
// PollingWait pauses between two polls; a Doorbell ends a pause early.

#include <mpi.h>

#include <chrono>
#include <string>

namespace footfall {

// Wakes a process of the same mpirun on the same machine.
//
// A pause may end half a millisecond after the message has come, twice in every window. A sender therefore also rings:
// it sends a datagram of one byte to the receiver's local socket, whose name every process of the job knows. The byte
// carries no data and may get lost: a process that is woken polls at once, any other process polls after its pause.
class Doorbell {
 public:
  // job: the same for all processes of a job and unique on this machine; rank: of this process.
  Doorbell(std::string job, int rank);
  ~Doorbell();
  Doorbell(const Doorbell&) = delete;
  Doorbell& operator=(const Doorbell&) = delete;

  // False where the machine offers no local sockets: pauses then last their full time.
  bool works() const { return socket_ >= 0; }
  bool ring(int rank) const;        // never blocks; false when no process of this rank exists (any more)
  void wait(double seconds) const;  // until rung, or that long; a ring since the last wait counts

 private:
  std::string job_;
  int socket_ = -1;
};

// The pauses of one wait. Where a long wait is expected, the first pause lasts three quarters of it. Then each lasts
// 1/64 of the time waited so far, between 5 and 500 microseconds (5 milliseconds with a doorbell): the delay stays a
// small part of every wait, and rare polls do not push the other program off its core.
class PollingWait {
 public:
  explicit PollingWait(const Doorbell* doorbell, double expected_seconds = 0.0)
      : doorbell_(doorbell), expected_(expected_seconds), start_(std::chrono::steady_clock::now()) {}
  void pause();
  // Time [s] in which this program itself was stopped (a suspended job); the partner was not silent then.
  double stopped() const;

 private:
  const Doorbell* doorbell_;                                     // may be null
  double expected_;                                              // [s]
  std::chrono::steady_clock::time_point start_, last_ = start_;  // last_: end of the last pause
  double stopped_ = 0.0;                                         // [s]
};

// Returns when the request is complete.
void wait_polling(MPI_Request& request, const Doorbell* doorbell);

}  // namespace footfall

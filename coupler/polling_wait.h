#pragma once
// X

#include <mpi.h>

#include <chrono>
#include <string>

namespace footfall {

class Doorbell {
 public:
  // `job`: the same for all processes of one job and no others on this machine; `seat`: of this process, from 0.
  Doorbell(std::string job, int seat);
  ~Doorbell();
  Doorbell(const Doorbell&) = delete;
  Doorbell& operator=(const Doorbell&) = delete;

  // False where the machine gives no local socket: waits last their whole time.
  bool works() const { return socket_ >= 0; }
  bool ring(int seat) const;        // never blocks; false when nobody sits there (any more)
  void wait(double seconds) const;  // until rung, or so long; a ring since the last wait counts

 private:
  std::string job_;
  int socket_ = -1;
};

// The naps between two looks. Three quarters of a wait that is expected to be long are slept through; then one looks
// again after 1/64 of the time waited so far, 5 to 500 microseconds: what is lost stays a small part of every wait, and
// who looks seldom does not push the other program off its core. A doorbell ends a nap when it rings, so that with one
// the naps may last up to 5 milliseconds.
class PoliteWait {
 public:
  explicit PoliteWait(const Doorbell* doorbell, double expected_seconds = 0.0)
      : doorbell_(doorbell), expected_(expected_seconds), start_(std::chrono::steady_clock::now()) {}
  void nap();
  // Overslept in naps or lost between two, as this program was stopped (a suspended job): no time in which the partner
  // was silent [s].
  double stopped() const;

 private:
  const Doorbell* doorbell_;                                     // may be null
  double expected_;                                              // [s]
  std::chrono::steady_clock::time_point start_, last_ = start_;  // the end of the last nap
  double stopped_ = 0.0;
};

// Returns when the request is complete.
void wait_politely(MPI_Request& request, const Doorbell* doorbell);

}  // namespace footfall

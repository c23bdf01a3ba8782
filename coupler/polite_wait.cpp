#include "coupler/polite_wait.h"

#include <algorithm>
#include <thread>

#include "coupler/interrupt.h"
#include "coupler/mpi_check.h"

namespace footfall {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kWorthSleeping = 10e-3;       // an expected wait from which on it is slept through [s]
constexpr double kPart = 0.75;                 // of the expected wait, slept in one go [-]
constexpr double kShare = 1.0 / 64.0;          // nap over time waited [-]
constexpr double kShortest = 5e-6;             // nap [s]
constexpr double kLongest = 500e-6;            // nap without a doorbell [s]
constexpr double kLongestWithDoorbell = 5e-3;  // [s]
constexpr double kLate = 0.3;                  // what a busy machine may take for anything [s]

}  // namespace

void PoliteWait::nap() {
  double nap = kPart * expected_;
  if (expected_ > kWorthSleeping) {
    expected_ = 0.0;
  } else {
    const double waited = Seconds(std::chrono::steady_clock::now() - start_).count();
    nap = std::clamp(kShare * waited, kShortest, doorbell_ ? kLongestWithDoorbell : kLongest);
  }
  const double overdue = 4.0 * nap + kLate;
  alive_for(overdue);
  stopped_ = stopped();
  const auto asleep = std::chrono::steady_clock::now();
  if (doorbell_)
    doorbell_->wait(nap);
  else
    std::this_thread::sleep_for(Seconds(nap));
  last_ = std::chrono::steady_clock::now();
  if (const double slept = Seconds(last_ - asleep).count(); slept > overdue) stopped_ += slept;
}

double PoliteWait::stopped() const {
  const double awake = Seconds(std::chrono::steady_clock::now() - last_).count();
  return stopped_ + (awake > kLate ? awake : 0.0);
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

}  // namespace footfall

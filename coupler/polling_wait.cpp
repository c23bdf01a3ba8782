// Doorbell: local datagram sockets in the abstract namespace. PollingWait: pauses that grow with the time waited.

#include "coupler/polling_wait.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <thread>
#include <utility>

#include "coupler/base/interrupt.h"
#include "coupler/communicator.h"

namespace footfall {
namespace {

struct Address {
  sockaddr_un address{};
  socklen_t size = 0;

  // A name that begins with a zero byte is abstract: no file, it disappears with its socket.
  Address(const std::string& job, int rank) {
    address.sun_family = AF_UNIX;
    const std::string name = job + "." + std::to_string(rank);
    const std::size_t length = std::min(name.size(), sizeof address.sun_path - 1);
    std::memcpy(address.sun_path + 1, name.data(), length);
    size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
  }
  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&address); }
};

using Seconds = std::chrono::duration<double>;

constexpr double kLongWait = 10e-3;            // an expected wait from which the first pause is long [s]
constexpr double kPart = 0.75;                 // first pause over expected wait [-]
constexpr double kShare = 1.0 / 64.0;          // pause over time waited [-]
constexpr double kShortest = 5e-6;             // pause [s]
constexpr double kLongest = 500e-6;            // pause without a doorbell [s]
constexpr double kLongestWithDoorbell = 5e-3;  // [s]
constexpr double kLate = 0.3;                  // delay of any action on a busy machine [s]

}  // namespace

Doorbell::Doorbell(std::string job, int rank)
    : job_(std::move(job)), socket_(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  const Address mine(job_, rank);
  if (socket_ >= 0 && bind(socket_, mine.get(), mine.size) != 0) {
    close(socket_);
    socket_ = -1;
  }
}

Doorbell::~Doorbell() {
  if (socket_ >= 0) close(socket_);
}

bool Doorbell::ring(int rank) const {
  if (socket_ < 0) return false;
  const Address other(job_, rank);
  // A full queue is no failure: the receiver will wake.
  return sendto(socket_, "!", 1, MSG_NOSIGNAL, other.get(), other.size) >= 0 || errno != ECONNREFUSED;
}

void Doorbell::wait(double seconds) const {
  if (socket_ < 0) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    return;
  }
  pollfd bell{socket_, POLLIN, 0};
  timespec time{};
  time.tv_sec = static_cast<time_t>(std::floor(seconds));
  time.tv_nsec = static_cast<long>((seconds - std::floor(seconds)) * 1e9);
  if (ppoll(&bell, 1, &time, nullptr) <= 0) return;
  char received[16];
  while (recv(socket_, received, sizeof received, 0) >= 0) {
  }
}

void PollingWait::pause() {
  double length = kPart * expected_;
  if (expected_ > kLongWait) {
    expected_ = 0.0;
  } else {
    const double waited = Seconds(std::chrono::steady_clock::now() - start_).count();
    length = std::clamp(kShare * waited, kShortest, doorbell_ ? kLongestWithDoorbell : kLongest);
  }
  const double overdue = 4.0 * length + kLate;
  promise_progress(overdue);
  stopped_ = stopped();
  const auto asleep = std::chrono::steady_clock::now();
  if (doorbell_)
    doorbell_->wait(length);
  else
    std::this_thread::sleep_for(Seconds(length));
  last_ = std::chrono::steady_clock::now();
  if (const double slept = Seconds(last_ - asleep).count(); slept > overdue) stopped_ += slept;
}

double PollingWait::stopped() const {
  const double awake = Seconds(std::chrono::steady_clock::now() - last_).count();
  return stopped_ + (awake > kLate ? awake : 0.0);
}

void wait_polling(MPI_Request& request, const Doorbell* doorbell) {
  PollingWait wait(doorbell);
  for (;;) {
    int done = 0;
    check_mpi(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "MPI_Test");
    if (done) return;
    wait.pause();
  }
}

}  // namespace footfall

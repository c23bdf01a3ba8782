#include "coupler/doorbell.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <thread>
#include <utility>

namespace footfall {
namespace {

struct Address {
  sockaddr_un address{};
  socklen_t size = 0;

  // A name that begins with a zero byte is no file: it goes with its socket.
  Address(const std::string& job, int seat) {
    address.sun_family = AF_UNIX;
    const std::string name = job + "." + std::to_string(seat);
    const std::size_t length = std::min(name.size(), sizeof address.sun_path - 1);
    std::memcpy(address.sun_path + 1, name.data(), length);
    size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
  }
  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&address); }
};

}  // namespace

Doorbell::Doorbell(std::string job, int seat)
    : job_(std::move(job)), socket_(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  const Address mine(job_, seat);
  if (socket_ >= 0 && bind(socket_, mine.get(), mine.size) != 0) {
    close(socket_);
    socket_ = -1;
  }
}

Doorbell::~Doorbell() {
  if (socket_ >= 0) close(socket_);
}

bool Doorbell::ring(int seat) const {
  if (socket_ < 0) return false;
  const Address other(job_, seat);
  // Rung so often that the queue is full: that is fine.
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
  char heard[16];
  while (recv(socket_, heard, sizeof heard, 0) >= 0) {
  }
}

}  // namespace footfall

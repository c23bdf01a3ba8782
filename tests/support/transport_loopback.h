#pragma once
// A pair of queues within one process: the whole exchange without MPI, with the two sides on two threads, or on one thread
// that sends before it receives. Two queues with a mutex each; receive() waits on a condition variable.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/codes.h"
#include "coupler/programs.h"
#include "coupler/transport.h"

namespace footfall {

class TransportLoopback : public Transport {
 public:
  // The two ends. When one is destroyed, receive() at the other throws PartnerError once its queue is empty.
  static std::pair<std::unique_ptr<TransportLoopback>, std::unique_ptr<TransportLoopback>> make_pair(
      std::string first_name = kDemProgram, std::string second_name = kMbdProgram);
  ~TransportLoopback() override;

  void send(MessageKind kind, const Bytes& bytes) override;
  bool poll() override;
  MessageKind receive(Bytes& bytes, double patience) override;
  std::string partner() const override { return partner_; }

 private:
  // One direction.
  struct Queue {
    std::mutex mutex;
    std::condition_variable arrived;
    std::deque<std::pair<MessageKind, Bytes>> messages;
    bool sender_gone = false;
  };
  TransportLoopback(std::shared_ptr<Queue> in, std::shared_ptr<Queue> out, std::string partner);

  std::shared_ptr<Queue> in_, out_;
  std::string partner_;
};

inline TransportLoopback::TransportLoopback(std::shared_ptr<Queue> in, std::shared_ptr<Queue> out, std::string partner)
    : in_(std::move(in)), out_(std::move(out)), partner_(std::move(partner)) {}

inline std::pair<std::unique_ptr<TransportLoopback>, std::unique_ptr<TransportLoopback>> TransportLoopback::make_pair(
    std::string first_name, std::string second_name) {
  auto there = std::make_shared<Queue>();
  auto back = std::make_shared<Queue>();
  std::unique_ptr<TransportLoopback> first(new TransportLoopback(back, there, std::move(second_name)));
  std::unique_ptr<TransportLoopback> second(new TransportLoopback(there, back, std::move(first_name)));
  return {std::move(first), std::move(second)};
}

inline TransportLoopback::~TransportLoopback() {
  const std::lock_guard<std::mutex> lock(out_->mutex);
  out_->sender_gone = true;
  out_->arrived.notify_all();
}

inline void TransportLoopback::send(MessageKind kind, const Bytes& bytes) {
  const std::lock_guard<std::mutex> lock(out_->mutex);
  out_->messages.emplace_back(kind, bytes);
  out_->arrived.notify_all();
}

inline bool TransportLoopback::poll() {
  const std::lock_guard<std::mutex> lock(in_->mutex);
  return !in_->messages.empty();
}

inline MessageKind TransportLoopback::receive(Bytes& bytes, double patience) {
  std::unique_lock<std::mutex> lock(in_->mutex);
  const auto ready = [this] { return !in_->messages.empty() || in_->sender_gone; };
  if (patience > 0.0) {
    if (!in_->arrived.wait_for(lock, std::chrono::duration<double>(patience), ready))
      throw PartnerError(code::kPartnerSilent, partner_ + " has sent nothing for " + number_text(patience) + " s");
  } else {
    in_->arrived.wait(lock, ready);
  }
  if (in_->messages.empty()) throw PartnerError(code::kPartnerGone, partner_ + " is gone");
  const MessageKind kind = in_->messages.front().first;
  bytes.swap(in_->messages.front().second);
  in_->messages.pop_front();
  return kind;
}

}  // namespace footfall

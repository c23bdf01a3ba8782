// Two queues with a mutex each; receive() waits on a condition variable.

#include "coupler/transport_loopback.h"

#include <chrono>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/codes.h"

namespace footfall {

TransportLoopback::TransportLoopback(std::shared_ptr<Queue> in, std::shared_ptr<Queue> out, std::string partner)
    : in_(std::move(in)), out_(std::move(out)), partner_(std::move(partner)) {}

std::pair<std::unique_ptr<TransportLoopback>, std::unique_ptr<TransportLoopback>> TransportLoopback::make_pair(
    std::string first_name, std::string second_name) {
  auto there = std::make_shared<Queue>();
  auto back = std::make_shared<Queue>();
  std::unique_ptr<TransportLoopback> first(new TransportLoopback(back, there, std::move(second_name)));
  std::unique_ptr<TransportLoopback> second(new TransportLoopback(there, back, std::move(first_name)));
  return {std::move(first), std::move(second)};
}

TransportLoopback::~TransportLoopback() {
  const std::lock_guard<std::mutex> lock(out_->mutex);
  out_->sender_gone = true;
  out_->arrived.notify_all();
}

void TransportLoopback::send(MessageKind kind, const Bytes& bytes) {
  const std::lock_guard<std::mutex> lock(out_->mutex);
  out_->messages.emplace_back(kind, bytes);
  out_->arrived.notify_all();
}

bool TransportLoopback::poll() {
  const std::lock_guard<std::mutex> lock(in_->mutex);
  return !in_->messages.empty();
}

MessageKind TransportLoopback::receive(Bytes& bytes, double patience) {
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

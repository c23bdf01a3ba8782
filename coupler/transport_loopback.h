#pragma once
// A pair of queues within one process: the whole exchange without MPI. Tests and accuracy studies use it, with the two
// sides on two threads, or on one thread that sends before it receives.

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

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

}  // namespace footfall

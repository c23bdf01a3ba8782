#pragma once
// Messages to the partner program over MPI. It waits by polling with short pauses: a blocking MPI receive would keep a
// core busy that the grains need.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "coupler/communicator.h"
#include "coupler/transport.h"

namespace footfall {

// Every rank of a program constructs one, and all call send() and receive(). Only the root exchanges messages with the
// partner; it forwards each message that it receives, or its PartnerError or Interrupted, to the other ranks. The
// communicator must outlive the transport. Precondition: has_partner().
class TransportMpi : public Transport {
 public:
  TransportMpi(const Communicator& communicator, std::string partner_name);
  // Waits until the last message has left, at most kCloseWait.
  ~TransportMpi() override;

  void send(MessageKind kind, const Bytes& bytes) override;
  void wake_partner() override;
  bool poll() override;  // not collective: false on other ranks than the root
  MessageKind receive(Bytes& bytes, double patience) override;
  std::string partner() const override { return partner_; }

  // From here on the root forwards nothing: for the final message, when the other ranks no longer take part.
  void stop_forwarding() { forwards_ = false; }

 private:
  // The message that the root forwards: kind, size and the first bytes, which are all bytes of most messages; the
  // rest follows. For a failure the bytes are its reason.
  struct Head {
    static constexpr int kFailure = 0, kInterrupt = -1;
    int kind = kFailure, size = 0;
    std::array<std::uint8_t, 4000> bytes{};  // small enough that Open MPI sends the whole without a handshake
  };

  bool finish(MPI_Request& request, double patience) const;
  bool partner_is_gone();
  void throw_noted_failure() const;
  void ring_partner();
  bool message_waits(MPI_Status& status) const;
  MPI_Request forward(void* data, std::size_t size) const;
  void wake_own_ranks() const;
  MessageKind receive_at_root(Bytes& bytes, double patience);

  MPI_Comm exchange_;
  MPI_Comm world_;  // the ranks of this program
  bool is_root_;
  bool forwards_;  // receive() forwards its message to the other ranks
  int partner_root_;
  const Doorbell* doorbell_;    // of the communicator; may be null
  std::vector<int> own_ranks_;  // in exchange()
  std::string partner_;
  // The shorter of the last two waits, when both were for messages of the same kind, as window follows window [s].
  double expected_wait_ = 0.0;
  double last_wait_ = 0.0;  // [s]
  int last_kind_ = 0;
  bool ring_due_ = false;          // a message was sent and the partner's doorbell not rung
  bool partner_was_rung_ = false;  // successfully, at least once
  double gone_since_ = 0.0;        // wall clock [s]; 0: the partner is there
  Bytes sending_;                  // kept until the send is complete
  MPI_Request request_ = MPI_REQUEST_NULL;
  // The root continues before the other ranks have received the forwarded message.
  Head head_;
  MPI_Request forwarding_ = MPI_REQUEST_NULL;
};

}  // namespace footfall

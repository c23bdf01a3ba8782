#pragma once
// Messages to the partner program over MPI. Waiting means polling with short sleeps: a blocking MPI receive would keep
// a core busy that the grains need.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "coupler/communicator.h"
#include "coupler/transport.h"

namespace footfall {

// Every rank of a program constructs one, and send() and receive() are called by all of them: the root alone talks to
// the partner, the others get a copy of what it receives, and of its PartnerError or Interrupted. The communicator must outlive it.
// Precondition: has_partner().
class TransportMpi : public Transport {
 public:
  TransportMpi(const Communicator& communicator, std::string partner_name);
  // Waits until what was sent has left, at most kParting.
  ~TransportMpi() override;

  void send(MessageKind kind, const Bytes& bytes) override;
  void wake_partner() override;
  bool poll() override;  // not collective: false on other ranks than the root
  MessageKind receive(Bytes& bytes, double patience) override;
  std::string partner() const override { return partner_; }

  // From here on the root sends and receives by itself: for last words, when the other ranks no longer take part.
  void root_speaks_alone() { shared_ = false; }

 private:
  // What the root hands on: kind and size with the first bytes, which are all of most messages, then what is left of
  // them; of a failure the bytes are why.
  struct Head {
    static constexpr int kFailure = 0, kInterrupt = -1;
    int kind = kFailure, size = 0;
    std::array<std::uint8_t, 4000> bytes{};  // with them still below what Open MPI sends without asking
  };

  bool finish_last_send(double patience);
  bool finish(MPI_Request& request, double patience) const;
  bool partner_is_gone();
  void ring_partner();
  bool has_come(MPI_Status& status) const;
  MPI_Request hand_on(void* data, std::size_t size) const;
  void wake_own_ranks() const;
  MessageKind receive_at_root(Bytes& bytes, double patience);

  MPI_Comm exchange_;
  MPI_Comm world_;  // the ranks of this program
  bool is_root_;
  bool shared_;  // receive() hands its message to the other ranks
  int partner_root_;
  const Doorbell* doorbell_;  // of the communicator; may be null
  std::vector<int> own_seats_;
  std::string partner_;
  // the shorter of the last two for messages of one kind, as windows follow each other [s]
  double expected_wait_ = 0.0;
  double last_wait_ = 0.0;  // [s]
  int last_kind_ = 0;
  bool unheard_ = false;        // something was sent and the partner's doorbell not rung
  bool partner_heard_ = false;  // its doorbell
  double gone_since_ = 0.0;     // on the clock [s]; 0: it is there
  Bytes sending_;               // owned until the send is complete
  MPI_Request request_ = MPI_REQUEST_NULL;
  // The root goes on with its work before the others have taken what it hands on.
  Head head_;
  MPI_Request handing_ = MPI_REQUEST_NULL;
};

}  // namespace footfall

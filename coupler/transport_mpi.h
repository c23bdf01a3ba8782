#pragma once
// Messages to the partner program over MPI. Waiting means polling with short sleeps: a blocking MPI receive would keep a core busy
// that the grains need.

#include <string>

#include "coupler/communicator.h"
#include "coupler/transport.h"

namespace footfall {

// Only the root rank of each program constructs one. The communicator must outlive it. Precondition: has_partner().
class TransportMpi : public Transport {
 public:
  TransportMpi(const Communicator& communicator, std::string partner_name);
  // Waits until what was sent has left, at most two seconds.
  ~TransportMpi() override;

  void send(MessageKind kind, const Bytes& bytes) override;
  bool poll() override;
  MessageKind receive(Bytes& bytes, double patience) override;
  std::string partner() const override { return partner_; }

 private:
  void finish_last_send(double patience);

  MPI_Comm exchange_;
  int partner_root_;
  std::string partner_;
  Bytes sending_;                          // owned until the send is complete
  MPI_Request request_ = MPI_REQUEST_NULL;
};

}  // namespace footfall

#include "coupler/transport_mpi.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <thread>
#include <utility>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/communicator.h"
#include "coupler/interrupt.h"
#include "coupler/polling_wait.h"

namespace footfall {

TransportMpi::TransportMpi(const Communicator& communicator, std::string partner_name)
    : exchange_(communicator.exchange()),
      world_(communicator.world()),
      is_root_(communicator.is_root()),
      shared_(communicator.size() > 1),
      partner_root_(communicator.partner_root()),
      doorbell_(communicator.doorbell()),
      own_seats_(communicator.own_seats()),
      partner_(std::move(partner_name)) {
  FOOTFALL_DEMAND(communicator.has_partner());
}

TransportMpi::~TransportMpi() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized) return;
  finish(handing_, kParting);  // a rank that has failed never takes it
  if (request_ == MPI_REQUEST_NULL) return;
  try {
    if (finish_last_send(kParting)) return;
  } catch (const PartnerError&) {  // the partner is gone, and the message with it
  }
  // The partner never read it. MPI may still look at the bytes, so they stay with the process.
  std::make_unique<Bytes>(std::move(sending_)).release();
  MPI_Request_free(&request_);
}

void TransportMpi::send(MessageKind kind, const Bytes& bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw ProtocolError("message " + message_name(kind) + " has " + std::to_string(bytes.size()) +
                        " bytes; MPI takes at most 2^31 - 1");
  if (!is_root_) return;
  // A partner that is stopped may never read the message before; the last word does not wait for that.
  if (!finish_last_send(kind == MessageKind::kClose ? kParting : 0.0))
    throw PartnerError(partner_ + " does not read what it was sent");
  sending_ = bytes;
  check_mpi(MPI_Isend(sending_.data(), static_cast<int>(sending_.size()), MPI_BYTE, partner_root_,
                      static_cast<int>(kind), exchange_, &request_),
            "MPI_Isend");
  unheard_ = true;
  if (kind == MessageKind::kClose) ring_partner();
}

// Not when something is sent but when this side has nothing to do any more: a partner that wakes before takes its core,
// and ranks that share one need milliseconds to part again.
void TransportMpi::ring_partner() {
  if (doorbell_ && unheard_ && doorbell_->ring(partner_root_)) partner_heard_ = true;
  unheard_ = false;
}

// On a machine whose cores all belong to ranks, one of them wakes on this core: it goes first, and this side works where
// ranks wait for each other. Without that the exchange took as long as what was done meanwhile.
void TransportMpi::wake_partner() {
  ring_partner();
  std::this_thread::yield();
}

bool TransportMpi::poll() {
  MPI_Status status;
  return is_root_ && has_come(status);
}

// Twice: Open MPI looks at its queue first and fetches what has come afterwards, so that one look alone tells of a
// message at the next one only. A nap between the two was most of what an exchange cost.
bool TransportMpi::has_come(MPI_Status& status) const {
  int waiting = 0;
  for (int look = 0; look < 2 && !waiting; ++look)
    check_mpi(MPI_Iprobe(partner_root_, MPI_ANY_TAG, exchange_, &waiting, &status), "MPI_Iprobe");
  return waiting != 0;
}

MessageKind TransportMpi::receive(Bytes& bytes, double patience) {
  if (!shared_) return receive_at_root(bytes, patience);
  wait_politely(handing_, doorbell_);
  if (is_root_) {
    try {
      head_.kind = static_cast<int>(receive_at_root(bytes, patience));
    } catch (const PartnerError& error) {
      head_.kind = dynamic_cast<const Interrupted*>(&error) ? Head::kInterrupt : Head::kFailure;
      const std::string why = error.what();
      bytes.assign(why.begin(), why.end());
    }
    head_.size = static_cast<int>(bytes.size());
    std::copy_n(bytes.begin(), std::min(bytes.size(), head_.bytes.size()), head_.bytes.begin());
  }
  handing_ = hand_on(&head_, sizeof head_);
  if (!is_root_) wait_politely(handing_, doorbell_);
  bytes.resize(static_cast<std::size_t>(head_.size));
  const std::size_t known = std::min(bytes.size(), head_.bytes.size());
  std::copy_n(head_.bytes.begin(), known, bytes.begin());
  if (bytes.size() > known) {
    MPI_Request rest = hand_on(bytes.data() + known, bytes.size() - known);
    wait_politely(rest, doorbell_);
  }
  if (head_.kind == Head::kFailure) throw PartnerError(std::string(bytes.begin(), bytes.end()));
  if (head_.kind == Head::kInterrupt) throw Interrupted(std::string(bytes.begin(), bytes.end()));
  return static_cast<MessageKind>(head_.kind);
}

// From the root to all ranks of this program.
MPI_Request TransportMpi::hand_on(void* data, std::size_t size) const {
  MPI_Request request = MPI_REQUEST_NULL;
  check_mpi(MPI_Ibcast(data, static_cast<int>(size), MPI_BYTE, 0, world_, &request), "MPI_Ibcast");
  wake_own_ranks();
  return request;
}

// The root has handed something on.
void TransportMpi::wake_own_ranks() const {
  if (!doorbell_ || !is_root_) return;
  for (std::size_t rank = 1; rank < own_seats_.size(); ++rank) doorbell_->ring(own_seats_[rank]);
}

// Its bell was there, and has been missing for so long that its last message has come.
bool TransportMpi::partner_is_gone() {
  constexpr double kLastMessage = 0.5;  // [s]
  if (!partner_heard_ || doorbell_->ring(partner_root_)) {
    gone_since_ = 0.0;
    return false;
  }
  const double now = wall_clock();
  if (gone_since_ == 0.0) gone_since_ = now;
  return now - gone_since_ > kLastMessage;
}

MessageKind TransportMpi::receive_at_root(Bytes& bytes, double patience) {
  ring_partner();
  const double start = wall_clock();
  constexpr double kBetweenLooks = 0.2;  // at the partner [s]
  double next_look = start + kBetweenLooks;
  PoliteWait wait(doorbell_, expected_wait_);
  MPI_Status status;
  for (;;) {
    if (has_come(status)) break;
    if (patience > 0.0 && wall_clock() - start - wait.stopped() > patience)
      throw PartnerError(partner_ + " has said nothing for " + std::to_string(patience) + " s");
    // The last word has a wait of its own (Link::fail).
    if (!parted() && waited_enough(wall_clock() - start))
      throw Interrupted("stopped by a signal while " + partner_ + " was waited for");
    if (wall_clock() > next_look) {
      if (partner_is_gone()) throw PartnerError(partner_ + " is gone");
      next_look = wall_clock() + kBetweenLooks;
    }
    wait.nap();
  }
  const double waited = wall_clock() - start;
  constexpr double kLongestSleep = 1.0;  // a Close must not wait longer to be heard [s]
  expected_wait_ = status.MPI_TAG == last_kind_ ? std::min({waited, last_wait_, kLongestSleep}) : 0.0;
  last_wait_ = waited;
  last_kind_ = status.MPI_TAG;
  int size = 0;
  check_mpi(MPI_Get_count(&status, MPI_BYTE, &size), "MPI_Get_count");
  bytes.resize(static_cast<std::size_t>(size));
  check_mpi(MPI_Recv(bytes.data(), size, MPI_BYTE, partner_root_, status.MPI_TAG, exchange_, MPI_STATUS_IGNORE),
            "MPI_Recv");
  return static_cast<MessageKind>(status.MPI_TAG);
}

// True once the last send has left. patience [s]: 0 waits for ever.
bool TransportMpi::finish_last_send(double patience) { return finish(request_, patience); }

bool TransportMpi::finish(MPI_Request& request, double patience) const {
  const double start = wall_clock();
  PoliteWait wait(doorbell_);
  for (;;) {
    int done = 0;
    check_mpi(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "MPI_Test");
    if (done) return true;
    if (patience > 0.0 && wall_clock() - start > patience) return false;
    wait.nap();
  }
}

}  // namespace footfall

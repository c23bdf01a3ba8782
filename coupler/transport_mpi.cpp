// The root sends by MPI_Isend and polls by MPI_Iprobe; messages reach the other ranks by MPI_Ibcast. Doorbells end
// pauses early.

#include "coupler/transport_mpi.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <thread>
#include <utility>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/interrupt.h"
#include "coupler/base/text.h"
#include "coupler/codes.h"
#include "coupler/polling_wait.h"
#include "coupler/programs.h"

namespace footfall {

TransportMpi::TransportMpi(const Communicator& communicator, std::string partner_name)
    : exchange_(communicator.exchange()),
      world_(communicator.world()),
      is_root_(communicator.is_root()),
      forwards_(communicator.size() > 1),
      partner_root_(communicator.partner_root()),
      doorbell_(communicator.doorbell()),
      own_ranks_(communicator.own_ranks()),
      partner_(std::move(partner_name)) {
  FOOTFALL_DEMAND(communicator.has_partner());
}

TransportMpi::~TransportMpi() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized) return;
  finish(forwarding_, kCloseWait);  // a rank that has failed never receives it
  if (request_ == MPI_REQUEST_NULL) return;
  try {
    if (finish(request_, kCloseWait)) return;
  } catch (const PartnerError&) {  // the partner is gone
  }
  // The partner never received it. MPI may still read the bytes: they remain allocated.
  std::make_unique<Bytes>(std::move(sending_)).release();
  MPI_Request_free(&request_);
}

void TransportMpi::send(MessageKind kind, const Bytes& bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw ProtocolError(code::kMessageTooLarge, "message " + message_name(kind) + " has " +
                                                    std::to_string(bytes.size()) +
                                                    " bytes; MPI sends at most 2^31 - 1");
  if (!is_root_) return;
  // A stopped partner may never receive the previous message; Close does not wait for that.
  if (!finish(request_, kind == MessageKind::kClose ? kCloseWait : 0.0))
    throw PartnerError(code::kPartnerNotReceiving, partner_ + " does not receive what was sent to it");
  sending_ = bytes;
  check_mpi(MPI_Isend(sending_.data(), static_cast<int>(sending_.size()), MPI_BYTE, partner_root_,
                      static_cast<int>(kind), exchange_, &request_),
            "MPI_Isend");
  ring_due_ = true;
  if (kind == MessageKind::kClose) ring_partner();
}

// Rings only when this side has no work left, not when it sends: a partner that wakes earlier takes this side's core,
// and processes that share a core need milliseconds to separate.
void TransportMpi::ring_partner() {
  if (doorbell_ && ring_due_ && doorbell_->ring(partner_root_)) partner_was_rung_ = true;
  ring_due_ = false;
}

// Where ranks occupy all cores, one of them wakes on this core. It runs first, and this side works while ranks wait for
// each other; otherwise the exchange would take as long as the work that overlaps with it.
void TransportMpi::wake_partner() {
  ring_partner();
  std::this_thread::yield();
}

bool TransportMpi::poll() {
  MPI_Status status;
  return is_root_ && message_waits(status);
}

// Probes twice: Open MPI reads its queue first and fetches new messages afterwards, so that a single probe finds a
// message only the next time, after a pause that costs more than the rest of an exchange.
bool TransportMpi::message_waits(MPI_Status& status) const {
  int waiting = 0;
  for (int probe = 0; probe < 2 && !waiting; ++probe)
    check_mpi(MPI_Iprobe(partner_root_, MPI_ANY_TAG, exchange_, &waiting, &status), "MPI_Iprobe");
  return waiting != 0;
}

MessageKind TransportMpi::receive(Bytes& bytes, double patience) {
  if (!forwards_) return receive_at_root(bytes, patience);
  wait_polling(forwarding_, doorbell_);
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
  forwarding_ = forward(&head_, sizeof head_);
  if (!is_root_) wait_polling(forwarding_, doorbell_);
  bytes.resize(static_cast<std::size_t>(head_.size));
  const std::size_t known = std::min(bytes.size(), head_.bytes.size());
  std::copy_n(head_.bytes.begin(), known, bytes.begin());
  if (bytes.size() > known) {
    MPI_Request rest = forward(bytes.data() + known, bytes.size() - known);
    wait_polling(rest, doorbell_);
  }
  if (head_.kind == Head::kFailure) throw PartnerError(std::string(bytes.begin(), bytes.end()));
  if (head_.kind == Head::kInterrupt) throw Interrupted(std::string(bytes.begin(), bytes.end()));
  return static_cast<MessageKind>(head_.kind);
}

// From the root to all ranks of this program.
MPI_Request TransportMpi::forward(void* data, std::size_t size) const {
  MPI_Request request = MPI_REQUEST_NULL;
  check_mpi(MPI_Ibcast(data, static_cast<int>(size), MPI_BYTE, 0, world_, &request), "MPI_Ibcast");
  wake_own_ranks();
  return request;
}

// After the root has forwarded something.
void TransportMpi::wake_own_ranks() const {
  if (!doorbell_ || !is_root_) return;
  for (std::size_t rank = 1; rank < own_ranks_.size(); ++rank) doorbell_->ring(own_ranks_[rank]);
}

// Its doorbell was there, and has been missing for so long that its last message must have come.
bool TransportMpi::partner_is_gone() {
  constexpr double kLastMessage = 0.5;  // [s]
  if (!partner_was_rung_ || doorbell_->ring(partner_root_)) {
    gone_since_ = 0.0;
    return false;
  }
  const double now = wall_clock();
  if (gone_since_ == 0.0) gone_since_ = now;
  return now - gone_since_ > kLastMessage;
}

// A rank of LIGGGHTS that has failed alone cannot reach this program; mpirun then ends all others with a signal.
void TransportMpi::throw_noted_failure() const {
  if (partner_ != kDemProgram || closing()) return;
  if (const std::string reason = noted_failure(); !reason.empty()) throw PartnerError(partner_ + " stopped: " + reason);
}

MessageKind TransportMpi::receive_at_root(Bytes& bytes, double patience) {
  ring_partner();
  const double start = wall_clock();
  constexpr double kBetweenChecks = 0.2;  // whether the partner is there [s]
  double next_check = start + kBetweenChecks;
  PollingWait wait(doorbell_, expected_wait_);
  MPI_Status status;
  for (;;) {
    if (message_waits(status)) break;
    if (patience > 0.0 && wall_clock() - start - wait.stopped() > patience)
      throw PartnerError(code::kPartnerSilent, partner_ + " has sent nothing for " + number_text(patience) + " s");
    // The answer to Close has its own time limit (Link::fail).
    if (!closing() && must_stop_waiting(wall_clock() - start)) {
      throw_noted_failure();
      throw Interrupted(code::kInterruptedWaiting, "stopped by a signal while waiting for " + partner_);
    }
    if (wall_clock() > next_check) {
      throw_noted_failure();
      if (partner_is_gone()) throw PartnerError(code::kPartnerGone, partner_ + " is gone");
      next_check = wall_clock() + kBetweenChecks;
    }
    wait.pause();
  }
  const double waited = wall_clock() - start;
  constexpr double kLongestSleep = 1.0;  // a Close must not wait longer than this to be received [s]
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

// True once the request is complete. patience [s]: 0: no limit.
bool TransportMpi::finish(MPI_Request& request, double patience) const {
  const double start = wall_clock();
  PollingWait wait(doorbell_);
  for (;;) {
    int done = 0;
    check_mpi(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "MPI_Test");
    if (done) return true;
    if (patience > 0.0 && wall_clock() - start > patience) return false;
    wait.pause();
  }
}

}  // namespace footfall

#include "coupler/link.h"

#include "coupler/base/clock.h"
#include "coupler/interrupt.h"

namespace footfall {

void Link::receive_bytes(MessageKind expected, double patience) {
  FOOTFALL_DEMAND(!closed_);
  const MessageKind kind = transport_.receive(in_, patience);
  if (kind == expected) return;
  if (kind == MessageKind::kClose) {
    const std::string reason = take_close();
    if (partner_status_ == Status::kBadInput) throw ProtocolError(reason);
    if (partner_status_ == Status::kInterrupted) throw Interrupted(reason);
    throw PartnerError(reason);
  }
  throw ProtocolError(partner() + " sent " + message_name(kind) + " where " + message_name(expected) + " was expected");
}

// The partner's Close is in in_: answers it and returns what it says.
std::string Link::take_close() {
  Close close;
  unpack(in_, close);
  partner_status_ = close.status;
  closed_ = true;
  transport_.part();
  send(Close{});
  switch (close.status) {
    case Status::kFailed:
    case Status::kBadInput: return partner() + " stopped: " + close.reason;
    case Status::kInterrupted: return partner() + " was interrupted: " + close.reason;
    case Status::kOk: break;
  }
  return partner() + " ended the coupling before the last window";
}

void Link::close() {
  FOOTFALL_DEMAND(!closed_);
  send(Close{});
  closed_ = true;
  transport_.part();
  const MessageKind kind = transport_.receive(in_, patience_);
  if (kind != MessageKind::kClose)
    throw ProtocolError(partner() + " sent " + message_name(kind) + " after the last window; Close was expected");
  Close answer;
  unpack(in_, answer);
  partner_status_ = answer.status;
  if (answer.status == Status::kFailed || answer.status == Status::kBadInput)
    throw PartnerError(partner() + " stopped: " + answer.reason);
}

bool Link::fail(const std::string& reason, Status status) noexcept {
  if (closed_) return true;
  closed_ = true;
  transport_.part();
  try {
    send(Close{status, reason});
    const double start = wall_clock();
    for (double left = kParting; left > 0.0; left = start + kParting - wall_clock())
      if (transport_.receive(in_, left) == MessageKind::kClose) return true;
  } catch (const std::exception&) {  // the partner is gone: there is nobody left to tell
  }
  transport_.give_up();
  return false;
}

}  // namespace footfall

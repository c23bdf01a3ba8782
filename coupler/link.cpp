// One conversation. A Close may come at any time instead of the expected message: it is answered, and thrown as the
// error that gives both programs the same exit code.

#include "coupler/link.h"

#include "coupler/base/clock.h"
#include "coupler/codes.h"

namespace footfall {
namespace {

// A reason that ends with a code keeps it.
std::string coded(const MessageCode& code, const std::string& text) {
  return has_code(text) ? text : with_code(code, text);
}

}  // namespace

void Link::receive_bytes(MessageKind expected, double patience) {
  FOOTFALL_DEMAND(!closed_);
  const MessageKind kind = transport_.receive(in_, patience);
  if (kind == expected) return;
  if (kind == MessageKind::kClose) throw_partners_close();
  throw ProtocolError(code::kMessageUnexpected,
                      partner() + " sent " + message_name(kind) + "; " + message_name(expected) + " was expected");
}

// The partner's Close is in in_.
void Link::throw_partners_close() {
  Close close;
  unpack(in_, close);
  partner_status_ = close.status;
  closed_ = true;
  transport_.set_closing();
  send(Close{});
  const std::string stopped = partner() + " stopped: " + close.reason;
  switch (close.status) {
    case Status::kFailed: throw PartnerError(coded(code::kPartnerStopped, stopped));
    case Status::kBadInput: throw ProtocolError(coded(code::kPartnerStopped, stopped));
    case Status::kInterrupted:
      throw Interrupted(coded(code::kPartnerInterrupted, partner() + " was interrupted: " + close.reason));
    case Status::kOk: break;
  }
  throw PartnerError(code::kPartnerClosedEarly, partner() + " closed the coupling before the last window");
}

void Link::close() {
  FOOTFALL_DEMAND(!closed_);
  send(Close{});
  closed_ = true;
  transport_.set_closing();
  const MessageKind kind = transport_.receive(in_, patience_);
  if (kind != MessageKind::kClose)
    throw ProtocolError(code::kMessageUnexpected,
                        partner() + " sent " + message_name(kind) + " after the last window; Close was expected");
  Close answer;
  unpack(in_, answer);
  partner_status_ = answer.status;
  if (answer.status == Status::kFailed || answer.status == Status::kBadInput)
    throw PartnerError(coded(code::kPartnerStopped, partner() + " stopped: " + answer.reason));
}

bool Link::fail(const std::string& reason, Status status) noexcept {
  if (closed_) return true;
  closed_ = true;
  transport_.set_closing();
  try {
    send(Close{status, reason});
    const double start = wall_clock();
    for (double left = kCloseWait; left > 0.0; left = start + kCloseWait - wall_clock())
      if (transport_.receive(in_, left) == MessageKind::kClose) return true;
  } catch (const std::exception&) {  // the partner is gone
  }
  transport_.set_unanswered();
  return false;
}

}  // namespace footfall

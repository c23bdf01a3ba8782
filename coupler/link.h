#pragma once
// Typed messages over a transport, and the end of a coupled run: in order, by failure, or interrupted.

#include <string>

#include "coupler/messages.h"
#include "coupler/transport.h"

namespace footfall {

// Both sides hold one. Every receive() may meet the partner's Close instead of the expected message. It then throws
// PartnerError with the partner's name and reason; ProtocolError when the partner met bad input; Interrupted when the
// end of the partner was requested. Both programs then end with the same exit code. Nothing here prints.
class Link {
 public:
  // patience [s]: how long receive() waits for the partner; 0: for ever. The transport must outlive the link.
  explicit Link(Transport& transport, double patience = 0.0) : transport_(transport), patience_(patience) {}

  template <class Message>
  void send(const Message& message) {
    pack(message, out_);
    transport_.send(Message::kKind, out_);
  }

  void wake_partner() { transport_.wake_partner(); }  // before work that overlaps with the partner's

  // The next message, which must be of this kind: ProtocolError for another kind, PartnerError when the partner has
  // closed or is gone.
  template <class Message>
  void receive(Message& message) {
    receive_bytes(Message::kKind, patience_);
    unpack(in_, message);
  }
  // The same without a time limit (a DEM script may settle its bed before it sends Hello).
  template <class Message>
  void receive_without_limit(Message& message) {
    receive_bytes(Message::kKind, 0.0);
    unpack(in_, message);
  }

  // Orderly end: sends Close(ok) and waits for the partner's Close. Throws PartnerError if that reports a failure.
  void close();
  // This side stops: sends Close(status, reason) once and waits at most kCloseWait for the partner's Close. Never
  // throws. True if the partner has received it (or the link was closed before).
  bool fail(const std::string& reason, Status status = Status::kFailed) noexcept;
  // True after close(), fail(), or the partner's Close: nothing more may be sent.
  bool closed() const { return closed_; }
  // Status of the partner's Close; kOk until it comes.
  Status partner_status() const { return partner_status_; }
  void set_patience(double seconds) { patience_ = seconds; }
  std::string partner() const { return transport_.partner(); }

 private:
  void receive_bytes(MessageKind expected, double patience);
  [[noreturn]] void throw_partners_close();

  Transport& transport_;
  double patience_;  // [s]
  Bytes in_, out_;
  bool closed_ = false;
  Status partner_status_ = Status::kOk;
};

}  // namespace footfall

#pragma once
// Typed messages over a transport, and the one place that says how a run ends: in order, by failure, or interrupted.

#include <string>

#include "coupler/base/errors.h"
#include "coupler/messages.h"
#include "coupler/transport.h"

namespace footfall {

// Both sides hold one. Every receive() may meet the partner's Close instead of what was expected; it then throws
// PartnerError with the partner's name and reason (ProtocolError when the partner met bad input, Interrupted when its end
// was asked for: both programs then end with the same exit code). Nothing here prints.
class Link {
 public:
  // patience [s]: how long receive() waits before it calls the partner lost; 0: for ever. The transport must outlive
  // the link.
  explicit Link(Transport& transport, double patience = 0.0) : transport_(transport), patience_(patience) {}

  template <class Message>
  void send(const Message& message) {
    pack(message, out_);
    transport_.send(Message::kKind, out_);
  }

  void wake_partner() { transport_.wake_partner(); }  // before work that is done while the partner is at work

  // Next message, which must be of this kind: ProtocolError if it is another, PartnerError if the partner closed or is
  // gone.
  template <class Message>
  void receive(Message& message) {
    receive_bytes(Message::kKind, patience_);
    unpack(in_, message);
  }
  // The same, waiting as long as it takes (a DEM script may settle its bed before it says Hello).
  template <class Message>
  void receive_patiently(Message& message) {
    receive_bytes(Message::kKind, 0.0);
    unpack(in_, message);
  }

  // Orderly end: says Close(ok) and waits for the partner's. Throws PartnerError if the partner closes with a failure.
  void close();
  // This side stops: sends Close(status, reason) once and waits at most kParting for the partner's answer. Never
  // throws. True if the partner has heard it (or the link was closed before).
  bool fail(const std::string& reason, Status status = Status::kFailed) noexcept;
  // True after close(), fail(), or the partner's Close: nothing more may be sent.
  bool closed() const { return closed_; }
  // What the partner's Close said; kOk until it comes.
  Status partner_status() const { return partner_status_; }
  void set_patience(double seconds) { patience_ = seconds; }
  std::string partner() const { return transport_.partner(); }

 private:
  void receive_bytes(MessageKind expected, double patience);
  std::string take_close();

  Transport& transport_;
  double patience_;  // [s]
  Bytes in_, out_;
  bool closed_ = false;
  Status partner_status_ = Status::kOk;
};

}  // namespace footfall

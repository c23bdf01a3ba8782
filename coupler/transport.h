#pragma once
// Carries bytes to the partner program: MPI between two programs; tests have a loopback between two threads of one.

#include <string>

#include "coupler/messages.h"

namespace footfall {

// How long a side that ends waits for the other: for its Close, or until its own last message has left [s].
inline constexpr double kCloseWait = 2.0;

class Transport {
 public:
  virtual ~Transport() = default;
  // Does not wait until the partner receives. Throws PartnerError when the partner is known to be gone.
  virtual void send(MessageKind kind, const Bytes& bytes) = 0;
  // Wakes a partner that waits for the message sent. Otherwise receive() does so; call it where this side has other work
  // before it waits.
  virtual void wake_partner() {}
  // True when a message has come. Never blocks.
  virtual bool poll() = 0;
  // Waits for the next message without keeping a core busy, and returns its kind. Throws PartnerError when the
  // partner is gone or has sent nothing for `patience` [s] (0: no limit); Interrupted when the end of this program
  // was requested and the partner has not answered soon after.
  virtual MessageKind receive(Bytes& bytes, double patience) = 0;
  // Name of the other end for messages: "mbd_solver", "liggghts_mbd".
  virtual std::string partner() const = 0;

  // State of the end of the conversation. closing: Close was sent. unanswered: the partner did not answer it; it may be
  // stopped or hang, and an orderly end would wait for it for ever.
  void set_closing() { closing_ = true; }
  bool closing() const { return closing_; }
  void set_unanswered() { unanswered_ = true; }
  bool unanswered() const { return unanswered_; }

 private:
  bool closing_ = false, unanswered_ = false;
};

}  // namespace footfall

#pragma once
// How bytes get to the partner program. Two kinds: MPI between two programs, loopback between two threads of one.

#include <string>

#include "coupler/messages.h"

namespace footfall {

// How long a side that ends waits for the other: for its answer, or for the last message to leave [s].
inline constexpr double kParting = 2.0;

class Transport {
 public:
  virtual ~Transport() = default;
  // Sends without waiting for the partner to read. Throws PartnerError when the partner is known to be gone.
  virtual void send(MessageKind kind, const Bytes& bytes) = 0;
  // This side has other work to do before it waits for an answer, and the partner shall not wait for that: it is told of
  // what was sent at once. Who waits next leaves it out.
  virtual void wake_partner() {}
  // True when a message waits. Never blocks.
  virtual bool poll() = 0;
  // Waits, without keeping a core busy, for the next message and returns its kind.
  // Throws PartnerError when the partner is gone, or has said nothing for patience [s] (0: wait for ever); Interrupted
  // when the end of this program was asked for and the partner has not answered soon after.
  virtual MessageKind receive(Bytes& bytes, double patience) = 0;
  // Who is at the other end, for messages: "mbd_solver", "liggghts_mbd".
  virtual std::string partner() const = 0;

  // How the conversation ended, for who ends the program. parted: the last word was sent. given_up: the partner did not
  // answer it, may be stopped or hung, and an orderly end would wait for it for ever.
  void part() { parted_ = true; }
  bool parted() const { return parted_; }
  void give_up() { given_up_ = true; }
  bool given_up() const { return given_up_; }

 private:
  bool parted_ = false, given_up_ = false;
};

}  // namespace footfall

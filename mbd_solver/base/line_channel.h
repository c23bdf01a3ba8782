#pragma once
// Lines of text between two processes, over a socket or a pair of pipes. Numbers in them have all
// digits (exact_number.h).

#include <string>

namespace footfall {

class LineChannel {
 public:
  LineChannel() = default;  // open to nobody
  // Files that are open for reading and for writing; the same one for a socket. They remain the
  // caller's.
  LineChannel(int from, int to) : from_(from), to_(to) {}

  // False: the other side has gone. A pipe without a reader raises SIGPIPE, which the caller
  // ignores.
  bool send(const std::string& line);
  enum class Heard { kLine, kNothing, kGone };
  // The next line, without its end; waits for at most this many milliseconds.
  Heard receive(std::string& line, int patience);

 private:
  bool take_line(std::string& line);

  int from_ = -1, to_ = -1;
  std::string received_;  // not read yet
};

}  // namespace footfall

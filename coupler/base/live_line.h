#pragma once
// What a program says of its work while it goes on: a line that rewrites itself on a terminal, else a line per per cent.

#include <string>

namespace footfall {

class LiveLine {
 public:
  // quiet: says nothing at all. terminal: what stands behind standard output.
  LiveLine(bool quiet, bool terminal) : quiet_(quiet), terminal_(terminal) {}

  // Is it time for another line, at this share of the work [0 ... 1]? On a terminal five times a second; else when
  // another per cent is done, and at most once a second.
  bool due(double share);
  void show(const std::string& text);
  // The line stays as it is, and the next output begins a new one; clear: it goes away, on a terminal.
  void finish(bool clear = false);

 private:
  bool quiet_, terminal_;
  double last_ = -1e9;  // wall clock of the last line [s]
  int percent_ = 0;     // of the last line
  bool open_ = false;
};

// "12 %", and what is left of the time at this pace: empty as long as nobody can know it.
struct Pace {
  double share = 0.0;       // of the work that is done [0 ... 1]
  double done_since = 0.0;  // share done since the clock was started
  double spent = 0.0;       // since then [s]
};
std::string percent_text(double share);
// "about 45 s left", "about 3 min left", "about 2.5 h left"; empty in the first second, or before 0.1 % is done.
std::string time_left(const Pace& pace);

// "t = 0.1234 of 1 s (12 %), about 45 s left": what `footfall run` and `footfall watch` begin their lines with.
std::string time_text(double time, double t_end, const Pace& pace);

}  // namespace footfall

#pragma once
// Progress of a program: on a terminal one line that is rewritten, elsewhere one line for each per cent.

#include <string>

namespace footfall {

class LiveLine {
 public:
  // quiet: no output at all. terminal: standard output is a terminal.
  LiveLine(bool quiet, bool terminal) : quiet_(quiet), terminal_(terminal) {}

  // Is the next line due, at this share of the work [0 ... 1]? On a terminal five times per second; elsewhere when
  // another per cent is done, and at most once per second.
  bool due(double share);
  void show(const std::string& text);
  // Ends the line, so that the next output begins a new one; clear: removes it from the terminal.
  void finish(bool clear = false);

 private:
  bool quiet_, terminal_;
  double last_ = -1e9;  // wall clock of the last line [s]
  int percent_ = 0;     // of the last line
  bool open_ = false;
};

// How far the work has come, for estimates of the remaining time.
struct Pace {
  double share = 0.0;       // of the work done so far [0 ... 1]
  double done_since = 0.0;  // share done since the clock was started
  double spent = 0.0;       // wall-clock time since then [s]
};
std::string percent_text(double share);  // "12 %"
// "about 45 s left", "about 3 min left", "about 2.5 h left"; empty in the first second, or before 0.1 % is done.
std::string time_left(const Pace& pace);

// "t = 0.1234 of 1 s (12 %), about 45 s left": the start of every progress line of a run.
std::string time_text(double time, double t_end, const Pace& pace);

}  // namespace footfall

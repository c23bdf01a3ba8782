#pragma once
// What the log of LIGGGHTS tells, while it is written and afterwards.

#include <map>
#include <string>
#include <vector>

#include "mbd_solver/base/live_line.h"

namespace footfall {

// The lines of a log, and behind its command `log FILE` those of that file.
std::vector<std::string> log_lines(const std::string& log);

// The lines that say ERROR, one per line; empty without.
std::string liggghts_errors(const std::string& log);

// Where LIGGGHTS is in the run command that is under way, from its last thermo row.
struct LogProgress {
  long first = -1, step = -1, last = -1;  // steps: the command's first one, the last that was told, the command's last
  int runs = 0;                           // run commands so far

  bool begun() const { return step >= 0 && last > first; }
  double share() const;  // of this command [0 ... 1]
  std::string text()
      const;  // "step 5000 of 15000 (33 %)", of the second command "run 2, step ..."; before: "setting up"
};
LogProgress log_progress(const std::string& log);

// A tick of run_child: tells on standard output how far LIGGGHTS has come with what its script does before the coupling
// begins, such as settling its grains.
class SettlingLine {
 public:
  // `begun`: a file that is there once the coupled run is under way.
  SettlingLine(std::string log, std::string begun, bool quiet);
  void operator()();

 private:
  std::string log_, begun_;
  LiveLine live_;
  double next_look_ = 0.0;  // wall clock [s]
  double started_;          // of the run command, wall clock [s]
  double share_ = 0.0;      // at that time
  int runs_ = 0;
  bool over_ = false;
};

// LIGGGHTS reads some damaged restart files for ever. A tick of run_child: says so once the log has ended with a
// read_restart for this long [s].
class ReadingWatch {
 public:
  ReadingWatch(std::string log, double limit) : log_(std::move(log)), limit_(limit) {}
  std::string operator()();

 private:
  std::string log_;
  double limit_;            // [s]
  double next_look_ = 0.0;  // wall clock [s]
  double since_ = 0.0;      // wall clock [s]; 0: it does something else
};

// Where in its script LIGGGHTS stood when it stopped, by its log.

// What to say of a log that holds errors: where, the ERROR lines, and what they mean where that is known.
std::string why_liggghts_stopped(const std::string& log, const std::string& script,
                                 const std::map<std::string, std::string>& variables);

// "FILE:LINE: COMMAND" of the script's last line that the log repeats before its first ERROR; the script's name alone
// where none is found.
std::string where_liggghts_stopped(const std::string& log, const std::string& script,
                                   const std::map<std::string, std::string>& variables);

}  // namespace footfall

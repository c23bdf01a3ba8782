#pragma once
// The log of LIGGGHTS, while it is written and afterwards: progress, errors, and the command of the script at which it
// stopped.

#include <map>
#include <string>
#include <vector>

#include "mbd_solver/base/live_line.h"

namespace footfall {

// The lines of a log, and after its command `log FILE` the lines of that file.
std::vector<std::string> log_lines(const std::string& log);

// The lines that begin with ERROR; empty when there are none.
std::string liggghts_errors(const std::string& log);

// Progress of the current run command, from the last thermo row.
struct LogProgress {
  long first = -1, step = -1, last = -1;  // first step of the command, latest step in the log, last step of the command
  int runs = 0;                           // run commands so far

  bool begun() const { return step >= 0 && last > first; }
  double share() const;      // of this command [0 ... 1]
  std::string text() const;  // "step 5000 of 15000 (33 %)", from the second command on "run 2, step ..."; "setting up"
};
LogProgress log_progress(const std::string& log);

// A tick of run_child: shows on standard output the progress of what the script does before the coupling begins, such as
// settling grains.
class SettlingLine {
 public:
  // `begun`: a file that exists once the coupled run has begun.
  SettlingLine(std::string log, std::string begun, bool quiet);
  void operator()();

 private:
  std::string log_, begun_;
  LiveLine live_;
  double next_look_ = 0.0;  // wall clock [s]
  double started_;          // wall clock at the start of the run command [s]
  double share_ = 0.0;      // of the run command at that time
  int runs_ = 0;
  bool over_ = false;
};

// A tick of run_child: LIGGGHTS reads some damaged restart files without end; ends it when the log has ended with
// read_restart for `limit` [s].
class ReadingWatch {
 public:
  ReadingWatch(std::string log, double limit) : log_(std::move(log)), limit_(limit) {}
  std::string operator()();

 private:
  std::string log_;
  double limit_;            // [s]
  double next_look_ = 0.0;  // wall clock [s]
  double since_ = 0.0;      // wall clock [s]; 0: LIGGGHTS is not reading a restart file
};

// Of a log that holds errors: the place in the script, the ERROR lines, and their meaning where it is known.
std::string why_liggghts_stopped(const std::string& log, const std::string& script,
                                 const std::map<std::string, std::string>& variables);

// "FILE:LINE: COMMAND" of the last line of the script that the log repeats before its first ERROR; the script's name alone
// when there is none.
std::string where_liggghts_stopped(const std::string& log, const std::string& script,
                                   const std::map<std::string, std::string>& variables);

}  // namespace footfall

#pragma once
// What the log of LIGGGHTS tells, while it is written and afterwards.

#include <string>

namespace footfall {

// The lines that say ERROR, one per line; empty without.
std::string liggghts_errors(const std::string& log);

// "step 5000 of 15000", from the last thermo row and the last run command; "setting up" before.
std::string log_progress(const std::string& log);

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

}  // namespace footfall

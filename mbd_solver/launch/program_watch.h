#pragma once
// Ticks of run_child that end programs which do not get on: what was waited for is in the message.

#include <cstdint>
#include <string>

namespace footfall {

// For an mpirun: ends it when its programs are gone, or when nothing shows that they get on. The time of a suspended job
// does not count.
class ProgramWatch {
 public:
  // limit [s]: how long the programs may be silent. pulse: the file or folder whose time shows that they are not; a
  // folder: the latest of its files. begun: once this file exists the programs watch each other; empty: they never do.
  // log: of LIGGGHTS; its last line names the present step.
  ProgramWatch(double limit, std::string pulse, std::string begun, std::string log);
  std::string operator()();

 private:
  std::string gone_programs();
  std::string silence();

  double limit_;  // [s]
  std::string pulse_, begun_, log_;
  double looked_;                     // wall clock at the last look [s]
  std::int64_t seen_ = 0;             // time of the pulse [ns]
  double silent_ = 0.0, gone_ = 0.0;  // for so long [s]
  bool had_programs_ = false;
};

// Ends a program that takes longer than `limit` [s].
class TimeLimit {
 public:
  TimeLimit(std::string program, double limit);
  std::string operator()() const;

 private:
  std::string program_;
  double limit_, started_;  // [s]; wall clock [s]
};

// Descendants of this process that have not ended.
int count_descendants(bool only_suspended);

}  // namespace footfall

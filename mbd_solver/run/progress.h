#pragma once
// The progress line: simulated time, real-time factor, time left, windows, contact force.

#include <cstdio>

namespace footfall {

class Progress {
 public:
  // On a terminal the line rewrites itself; elsewhere a new line comes every few seconds.
  Progress(double t_end, bool quiet);
  void show(double time, long windows, double contact_force);
  void finish();  // ends the line

 private:
  double t_end_;  // [s]
  bool quiet_;
  bool terminal_;
  double started_;   // wall clock [s]
  double last_ = 0;  // wall clock of the last line [s]
  bool open_ = false;
};

}  // namespace footfall

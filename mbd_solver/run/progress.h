#pragma once
// What a run says while it goes on: simulated time, time left, real-time factor, windows, contact force.

#include <string>

#include "coupler/base/live_line.h"

namespace footfall {

class Progress {
 public:
  // On a terminal the line rewrites itself; elsewhere there is one per per cent.
  Progress(double t_end, bool quiet, bool coupled);
  void show(double time, long windows, double contact_force);
  void finish();  // the last state, and the end of the line

 private:
  std::string line() const;

  double t_end_;  // [s]
  bool coupled_;  // only then there are windows
  LiveLine live_;
  double started_;            // wall clock [s]
  double from_ = 0.0;         // time of the first state: of a resumed run not zero [s]
  double time_ = 0.0;         // of the last state [s]
  double contact_force_ = 0;  // likewise [N]
  long windows_ = 0;          // likewise
  bool begun_ = false, shown_ = false;
};

}  // namespace footfall

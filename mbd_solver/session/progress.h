#pragma once
// Progress of a run on standard output, and the pace of a trial run.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/base/live_line.h"
#include "mbd_solver/session/simulation.h"

namespace footfall {

// The progress line: simulated time, remaining time, real-time factor, windows, contact force.
class Progress {
 public:
  // On a terminal the line is updated in place; otherwise one line is printed per per cent.
  Progress(double t_end, bool quiet, bool coupled);
  void show(double time, long windows, double contact_force);
  void finish();  // the last state, and the end of the line

 private:
  std::string line() const;

  double t_end_;  // [s]
  bool coupled_;  // shows windows
  LiveLine live_;
  double started_;            // wall clock [s]
  double from_ = 0.0;         // time of the first state; not zero in a resumed run [s]
  double time_ = 0.0;         // of the last state [s]
  double contact_force_ = 0;  // likewise [N]
  long windows_ = 0;          // likewise
  bool begun_ = false, shown_ = false;
};

// A trial: a run that ends after some wall-clock seconds and reports its pace, from which the time of the whole run is
// estimated (app/check_command.h).
class Trial {
 public:
  // seconds: wall-clock, from the first sample; 0: not a trial.
  explicit Trial(double seconds) : seconds_(seconds) {}

  bool active() const { return seconds_ > 0.0; }
  // At every sample. Marks the first, the first after half of the seconds, and the last one.
  void observe(const Simulation& simulation, double time);
  bool over() const { return over_; }

  // For summary.json: begun, the clock at the first mark (coupler/base/clock.h, one for all programs of a machine), and
  // at the three marks: time_s (simulated), wall_s, dem_wall_s (of LIGGGHTS), steps and windows of the mechanism since
  // the start. Null before there are three marks.
  nlohmann::ordered_json marks() const;

 private:
  struct Mark {
    double time, wall, dem_wall;  // [s]
    long steps, windows;
  };

  double seconds_;  // [s]
  bool over_ = false;
  std::vector<Mark> marks_;
};

}  // namespace footfall

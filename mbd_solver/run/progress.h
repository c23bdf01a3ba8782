#pragma once
// What a run says while it goes on: simulated time, time left, real-time factor, windows, contact force.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/base/live_line.h"
#include "mbd_solver/run/simulation.h"

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

// A trial: a run that ends after some seconds on the wall and tells its pace, so that the time of the whole run can be
// foretold (cli/launch/run_time.h).

class Trial {
 public:
  // seconds on the wall, from the first sample; 0: the run is none, and goes to its end.
  explicit Trial(double seconds) : seconds_(seconds) {}

  bool runs() const { return seconds_ > 0.0; }
  // At every sample. Marks the first, the first after half of the seconds, and the last one.
  void look(const Simulation& simulation, double time);
  bool over() const { return over_; }

  // For summary.json: begun, the clock (coupler/base/clock.h, one for all programs of a machine) at the first mark, and with values at the three marks: time_s (simulated), wall_s, dem_wall_s (of LIGGGHTS), and
  // steps and windows of the mechanism since the start. Null before there are three marks.
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

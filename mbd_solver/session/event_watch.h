#pragma once
// Detects events that follow each other faster than the motion can change: without hysteresis the conditions of two states may
// become true in turn at once, and the run would never end.

#include <array>
#include <cstddef>
#include <string>

namespace footfall {

class EventWatch {
 public:
  // After an event without a period, at `time` of a run to t_end [s]. Throws NumericalError that names the events.
  void count(const std::string& event, double time, double t_end);

 private:
  static constexpr std::size_t kWatched = 300;  // events
  static constexpr double kMostEvents = 1e6;    // that may remain at the present rate
  static constexpr double kShortest = 1e-5;     // mean interval of events that are no chatter [s]

  std::array<std::string, kWatched> names_;
  std::size_t count_ = 0;
  double since_ = 0.0;  // time of the first that is watched [s]
};

// Detects windows so short that the run would never end: the time does not change at all, or too little.
class WindowWatch {
 public:
  static constexpr long kWatched = 20000;       // windows
  static constexpr double kMostWindows = 1e12;  // that may remain at the present rate
  explicit WindowWatch(double time) : since_(time) {}
  // At the begin of each window of a run to t_end [s].
  bool is_stuck(double time, double t_end) {
    if (++windows_ < kWatched) return false;
    windows_ = 0;
    moved_ = time - since_;
    since_ = time;
    return t_end - time > kMostWindows / kWatched * moved_;
  }
  double moved() const { return moved_; }  // over the windows that were watched last [s]

 private:
  double since_, moved_ = 0.0;  // [s]
  long windows_ = 0;
};

}  // namespace footfall

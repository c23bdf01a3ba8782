#pragma once
// How long the mechanism of a scene will take, from a run of it that is broken off after some seconds.

#include <string>
#include <vector>

namespace footfall {

// What a run had reached [s of simulated time] after so many seconds on the clock.
struct TimeMark {
  double clock = 0.0;
  double reached = 0.0;
};

// Time on the clock of a whole run to `end` [s]: what was measured, and the rest at the pace of the second half of that
// time. 0 when nothing has moved.
double expected_run_time(const std::vector<TimeMark>& marks, double end);

// Runs `scene`, which touches no grains, in a folder of its own for at most so many seconds and tells in one line what
// to expect. Throws InputError where no process can be started, Interrupted.
std::string run_time_report(const std::string& scene, const std::vector<std::string>& settings, double end,
                            double seconds);

}  // namespace footfall

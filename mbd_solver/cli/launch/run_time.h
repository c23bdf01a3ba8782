#pragma once
// How long a whole run takes, from what a trial of it (run/trial.h) told.

#include <nlohmann/json.hpp>
#include <string>

namespace footfall {

struct RunTime {
  double seconds = 0.0;            // of the whole run, on the wall [s]
  double least = 0.0, most = 0.0;  // [s]
  double share_of_grains = 0.0;    // of LIGGGHTS' work in it [0 ... 1]
};

// With marks 0, 1, 2 of the trial (its start, middle and end), rates of the second half, and R = t_end - t_2 to come:
//   T = t_wall,2 + R (grains + mechanism),   grains = (dem_2 - dem_1) / (t_2 - t_1)
// Grains take the same time in every substep, but for those that neighbour lists cost at an impact. A mechanism that has
// just touched hard takes short steps, and later as few as its windows ask for, a quarter of those of the trial at least:
//   most = its pace of the second half,   least = most max(windows / steps, 1/4)
// The root of least and most counts where its steps grew from the first half of the trial to the second; else most. The
// bounds hold the slower and the faster half of the grains as well.
// `trial`: "trial" of summary.json. Throws nlohmann::json::exception where it lacks something.
RunTime expected_run_time(const nlohmann::ordered_json& trial, double t_end);

// "45 s", "3.2 min", "1.5 h": two digits.
std::string duration_text(double seconds);

}  // namespace footfall

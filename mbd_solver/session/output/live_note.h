#pragma once
// What mbd_solver adds to run.json once it has begun, for pages of a run in progress.

#include <nlohmann/json.hpp>
#include <string>

namespace footfall {

struct LiveNote {
  double dt_dem = 0.0;           // DEM time step [s]; 0: not known yet, or no grains
  nlohmann::ordered_json scene;  // with all defaults, as in summary.json; null: not known yet
};

// In the folder of the run, next to what write_run_note (summary.h) has written. Throw InputError as it does.
void add_live_note(const std::string& folder, const LiveNote& note);
LiveNote read_live_note(const std::string& folder);

}  // namespace footfall

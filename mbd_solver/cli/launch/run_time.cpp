#include "mbd_solver/cli/launch/run_time.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/text.h"

namespace footfall {
namespace {

constexpr double kFewest = 0.25;  // of the steps of the trial
constexpr double kGrown = 0.8;    // steps per simulated second, of those before: below it they have grown

}  // namespace

RunTime expected_run_time(const nlohmann::ordered_json& trial, double t_end) {
  const auto at = [&](const char* what, std::size_t mark) { return trial.at(what).at(mark).get<double>(); };
  const auto late = [&](const char* what) { return at(what, 2) - at(what, 1); };
  const auto early = [&](const char* what) { return at(what, 1) - at(what, 0); };
  const double rest = std::max(0.0, t_end - at("time_s", 2)) / late("time_s");  // in second halves of the trial
  const double grains = late("dem_wall_s") * rest;
  const double grains_early =
      early("time_s") > 0.0 ? early("dem_wall_s") / early("time_s") * late("time_s") * rest : grains;
  const double most = std::max(0.0, late("wall_s") - late("dem_wall_s")) * rest;
  const double share = late("steps") > 0.0 ? std::clamp(late("windows") / late("steps"), kFewest, 1.0) : 1.0;
  const bool grown = late("steps") * early("time_s") < kGrown * early("steps") * late("time_s");
  const double so_far = at("wall_s", 2);
  RunTime time;
  time.seconds = so_far + grains + (grown ? std::sqrt(share) * most : most);
  time.least = so_far + std::min(grains, grains_early) + share * most;
  time.most = so_far + std::max(grains, grains_early) + most;
  time.share_of_grains = (at("dem_wall_s", 2) + grains) / time.seconds;
  return time;
}

std::string duration_text(double seconds) {
  if (seconds < 99.5) return number_text(seconds, 2) + " s";
  if (seconds < 99.5 * 60.0) return number_text(seconds / 60.0, 2) + " min";
  const double hours = seconds / 3600.0;
  return (hours < 99.5 ? number_text(hours, 2) : fixed_text(hours, 0)) + " h";
}

}  // namespace footfall

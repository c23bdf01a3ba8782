#pragma once
// Grains and bodies of a run, frame by frame, packed for a page.

#include <string>

#include "mbd_solver/cli/analysis/viewer/page_parts.h"

namespace footfall {

struct FrameLimits {
  int frames = 0;                  // of the grains, at most; 0: as many as `most_grains` allows
  double most_grains = 1.5e7;      // grains times frames: about 100 MB of page at the very worst
  std::size_t moments = 201;       // of surfaces that were recorded window by window
  std::vector<std::string> notes;  // what was left out
};

// The dumps of grains in `run`, evenly thinned to the limits: run.grains (count, times, box, view, numbers) and chunks
// grains-radius, grains-K. Absent when there are none: run.grains is null. dt: of the grains [s]. Throws InputError for
// damaged files.
void add_grains(const std::string& run, double dt, FrameLimits& limits, PageParts& parts);

// The mechanism as MechanismShapes finds it: run.bodies (points, cells, times, box, view, stress) and run.bodyNames, and
// chunks bodies-triangles, -lines, -cells, -radius, bodies-K. run.bodies is null when there is nothing.
void add_bodies(const std::string& run, const nlohmann::ordered_json& summary, FrameLimits& limits, PageParts& parts);

}  // namespace footfall

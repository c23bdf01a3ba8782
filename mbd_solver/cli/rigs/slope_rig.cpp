// Angle of repose: the surface that a wall leaves which has drawn back (analysis/bed_slope.h), between a fifth and four
// fifths of the height of the step.
#include "coupler/base/errors.h"
#include "mbd_solver/cli/grains/bed_slope.h"
#include "mbd_solver/cli/rigs/rig_curves.h"

namespace footfall {

namespace {

constexpr double kLowerPart = 0.2, kUpperPart = 0.8;

}  // namespace

void demand_repose(const Scene& scene) {
  const BoxSpec& box = box_of(scene);
  if (box.pit.empty()) throw InputError(scene.file + ": this rig needs particles.box.pit");
  if (!(box.frames > 0.0)) throw InputError(scene.file + ": this rig needs particles.box.frames");
}

RigSample evaluate_repose(const std::vector<RigRun>& runs) {
  RigSample sample;
  for (const RigRun& run : runs) {
    const double r = -mean_surface(run);
    demand_repose(run.scene);
    const BoxSpec& box = box_of(run.scene);
    const auto frames = find_bed_frames(run.folder);
    if (frames.empty()) throw InputError(run.folder + ": no dumps of the grains");
    const double half = 0.5 * box.size[0], step = box.pit_depth;
    const BedSlope slope = bed_slope(
        read_bed_frame(frames.rbegin()->second),
        {box.centre[0] - half, box.centre[0] + half, r, (kLowerPart - 1.0) * step, (kUpperPart - 1.0) * step});
    sample.answers.push_back({"angle of repose", "deg", slope.angle});
    sample.answers.push_back({"R^2 of the slope", "", slope.r_squared});
    sample.curves.push_back({run.name, slope.x, slope.height});
  }
  return sample;
}

}  // namespace footfall

// Angle of repose: the surface that a wall leaves which has drawn back. Height of the surface over x: the highest point of
// a grain in slices two grain diameters wide, less a radius. The slices overlap, a quarter of a diameter apart: a steep
// slope is hardly longer than two of them. A line through the slices between a fifth and four fifths of the height of the
// step; the angle is the arc tangent of its slope.
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/cli/analysis/bed_frames.h"
#include "mbd_solver/cli/rigs/rig_curves.h"

namespace footfall {

namespace {

constexpr double kSlice = 2.0, kApart = 0.25;  // width of a slice, between their middles [grain diameters]
constexpr double kLowerPart = 0.2, kUpperPart = 0.8;

}  // namespace

RigSample evaluate_repose(const std::vector<RigRun>& runs) {
  RigSample sample;
  for (const RigRun& run : runs) {
    const double r = -mean_surface(run);
    const BoxSpec& box = *run.scene.particles->box;
    if (box.pit.empty()) throw InputError(run.scene.file + ": this rig needs particles.box.pit");
    const auto frames = find_bed_frames(run.folder);
    if (frames.empty()) throw InputError(run.folder + ": no dumps of the grains; this rig needs particles.box.frames");
    const BedFrame bed = read_bed_frame(frames.rbegin()->second);
    const double width = kSlice * 2.0 * r, apart = kApart * 2.0 * r, left = box.centre[0] - 0.5 * (box.size[0] - width);
    const long count = std::lround(std::floor((box.size[0] - width) / apart)) + 1;
    std::vector<double> top(static_cast<std::size_t>(std::max(0L, count)), -std::numeric_limits<double>::infinity());
    for (int i = 0; i < bed.count(); ++i) {
      const double at = (bed.x(0, i) - left) / apart, reach = 0.5 * width / apart;  // in slices
      const long first = std::max(0L, std::lround(std::ceil(at - reach)));
      const long last = std::min(count - 1, std::lround(std::floor(at + reach)));
      for (long k = first; k <= last; ++k) {
        double& slice = top[static_cast<std::size_t>(k)];
        slice = std::max(slice, bed.x(2, i));
      }
    }
    RigCurve curve{run.name, {}, {}};
    std::vector<std::pair<double, double>> line;
    const double low = -box.pit_depth + kLowerPart * box.pit_depth, high = -box.pit_depth + kUpperPart * box.pit_depth;
    for (std::size_t k = 0; k < top.size(); ++k) {
      if (!std::isfinite(top[k])) continue;
      const double x = left + static_cast<double>(k) * apart;
      curve.x.push_back(x), curve.y.push_back(top[k]);
      if (top[k] >= low && top[k] <= high) line.emplace_back(x, top[k]);
    }
    Eigen::MatrixXd A(static_cast<Eigen::Index>(line.size()), 2);
    Eigen::VectorXd h(A.rows());
    for (std::size_t i = 0; i < line.size(); ++i) {
      A.row(static_cast<Eigen::Index>(i)) << 1.0, line[i].first;
      h(static_cast<Eigen::Index>(i)) = line[i].second;
    }
    const LineFit fit = least_squares(A, h);
    sample.answers.push_back({"angle of repose", "deg", std::atan(std::abs(fit.c(1))) * 180.0 / kPi});
    sample.answers.push_back({"R^2 of the slope", "", fit.r_squared});
    sample.curves.push_back(curve);
  }
  return sample;
}

}  // namespace footfall

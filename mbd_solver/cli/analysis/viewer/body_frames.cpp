#include <algorithm>
#include <set>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/analysis/mechanism_shape.h"
#include "mbd_solver/cli/analysis/viewer/frames_of_run.h"
#include "mbd_solver/cli/analysis/viewer/packed_series.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

const Eigen::VectorXd* cell_numbers(const VtkFrame& frame, const std::string& name) {
  for (const auto& [key, values] : frame.cell_numbers)
    if (key == name && values.size() == static_cast<Eigen::Index>(frame.triangles.size() + frame.lines.size()))
      return &values;
  return nullptr;
}

// The moments that are packed: all that were drawn; of recorded ones so many, evenly spread.
std::vector<double> moments_of(const MechanismShapes& shapes, std::size_t most) {
  const std::vector<double>& all = shapes.times();
  if (shapes.drawn() || all.size() <= most) return all;
  std::vector<double> chosen;
  for (std::size_t i = 0; i < most; ++i) chosen.push_back(all[i * (all.size() - 1) / (most - 1)]);
  return chosen;
}

// The bodies whose stress is known: others are drawn in their own colour, not in that of no stress.
std::set<int> stressed_bodies(const std::vector<MechanismShape>& frames) {
  std::set<int> stressed;
  for (const MechanismShape& shape : frames) {
    const Eigen::VectorXd* stress = cell_numbers(shape.frame, "von_mises_Pa");
    const Eigen::VectorXd* body = cell_numbers(shape.frame, "body");
    for (Eigen::Index i = 0; stress != nullptr && body != nullptr && i < stress->size(); ++i)
      if ((*stress)(i) > 0.0) stressed.insert(static_cast<int>((*body)(i)));
  }
  return stressed;
}

void add_cells(const MechanismShape& first, PageParts& parts) {
  std::vector<std::uint32_t> triangles, lines, bodies;
  for (const Eigen::Vector3i& t : first.frame.triangles)
    for (int k = 0; k < 3; ++k) triangles.push_back(static_cast<std::uint32_t>(t(k)));
  for (const Eigen::Vector2i& l : first.frame.lines)
    for (int k = 0; k < 2; ++k) lines.push_back(static_cast<std::uint32_t>(l(k)));
  const Eigen::VectorXd* body = cell_numbers(first.frame, "body");
  for (std::size_t i = 0; i < first.frame.triangles.size() + first.frame.lines.size(); ++i)
    bodies.push_back(body != nullptr ? static_cast<std::uint32_t>((*body)(static_cast<Eigen::Index>(i))) : 0u);
  const std::vector<float> radius(first.line_radius.begin(), first.line_radius.end());
  parts.chunks.emplace_back("bodies-triangles", packed_numbers(triangles));
  parts.chunks.emplace_back("bodies-lines", packed_numbers(lines));
  parts.chunks.emplace_back("bodies-cells", packed_numbers(bodies));
  parts.chunks.emplace_back("bodies-radius", packed_numbers(radius));
}

}  // namespace

void add_bodies(const std::string& run, const Json& summary, FrameLimits& limits, PageParts& parts) {
  parts.run["bodies"] = nullptr;
  const MechanismShapes shapes(run, summary);
  parts.run["bodyNames"] = shapes.body_names();
  if (shapes.empty()) return;
  if (!shapes.drawn())
    limits.notes.push_back(
        "The run drew no bodies: only their surfaces that touch the grains are shown, without their bending. "
        "Run it with --set output.vtk=true to see all.");
  const std::vector<double> times = moments_of(shapes, limits.moments);
  std::vector<MechanismShape> frames;
  Box box;
  double stress = 0.0;  // largest of all frames [Pa]
  for (const double t : times) {
    frames.push_back(shapes.near(t));
    const VtkFrame& frame = frames.back().frame;
    const VtkFrame& first = frames.front().frame;
    if (frame.points.cols() != first.points.cols() || frame.triangles.size() != first.triangles.size() ||
        frame.lines.size() != first.lines.size())
      throw InputError(run + ": its drawings of the bodies hold different points; were files of two runs mixed?");
    if (!frame.points.allFinite())
      throw InputError(run + ": a drawing of the bodies holds a point that is not finite; was a file damaged?");
    for (Eigen::Index j = 0; j < frame.points.cols(); ++j) box.include(frame.points.col(j));
    if (const Eigen::VectorXd* values = cell_numbers(frame, "von_mises_Pa"); values != nullptr && values->size() > 0)
      stress = std::max(stress, values->maxCoeff());
  }
  const std::size_t points = static_cast<std::size_t>(frames.front().frame.points.cols());
  const std::size_t cells = frames.front().frame.triangles.size() + frames.front().frame.lines.size();
  if (points == 0) return;

  Json& bodies = parts.run["bodies"];
  bodies = {{"points", points},
            {"cells", cells},
            {"times", times},
            {"stress", stress},
            {"stressed", stressed_bodies(frames)}};
  add_box(box, box, bodies);
  add_cells(frames.front(), parts);
  PackedSeries series(3 * points + (stress > 0.0 ? cells : 0));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const VtkFrame& frame = frames[k].frame;
    std::vector<std::uint16_t> values;
    values.reserve(3 * points + cells);
    for (int axis = 0; axis < 3; ++axis)
      for (Eigen::Index j = 0; j < frame.points.cols(); ++j)
        values.push_back(box.number_of(axis, frame.points(axis, j)));
    if (stress > 0.0) {
      const Eigen::VectorXd* of_cell = cell_numbers(frame, "von_mises_Pa");
      for (std::size_t i = 0; i < cells; ++i) {
        const double share = of_cell != nullptr ? (*of_cell)(static_cast<Eigen::Index>(i)) / stress : 0.0;
        values.push_back(static_cast<std::uint16_t>(65535.0 * std::clamp(share, 0.0, 1.0)));
      }
    }
    parts.add_frame("bodies", k, series.add(values));
  }
}

}  // namespace footfall

// The outline of each shape against the surface, row by row.
#include "mbd_solver/run/observe/unheld_bodies.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/run/codes.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/shape_outline.h"

namespace footfall {
namespace {

constexpr double kThrough = 0.05;      // of the size of a body: deeper is no touch
constexpr std::size_t kMostNamed = 6;  // bodies

}  // namespace

void UnheldBodies::Depth::visit(Archive& archive) {
  archive("start", start);
  archive("largest", largest);
  archive("time", time);
}

UnheldBodies::UnheldBodies(const Subject& subject) {
  const Scene& scene = subject.scene;
  if (!scene.ground.is_flat()) return;
  ground_ = ground_level(subject);
  for (const BodySpec& spec : scene.bodies) {
    if (scene.boundary_of(spec.name) != nullptr || stands_still(scene, spec.name)) continue;
    Watched watched{scene.body_index(spec.name), spec.name, 0.0, shape_outline(spec)};
    for (Eigen::Vector3d& p : watched.outline) {
      p = spec.orientation.conjugate() * (p - spec.position);
      watched.size = std::max(watched.size, p.norm());
    }
    if (!watched.outline.empty()) watched_.push_back(std::move(watched));
  }
  depths_.resize(watched_.size());
}

void UnheldBodies::update(const Sample& sample) {
  for (std::size_t k = 0; k < watched_.size(); ++k) {
    const Watched& watched = watched_[k];
    Depth& depth = depths_[k];
    const BodyKinematics& body = sample.kinematics.of(watched.body);
    const bool first = depth.start < 0.0;
    if (first) depth.start = 0.0;
    if (ground_->above(body.r) > watched.size) continue;
    double deepest = 0.0;
    for (const Eigen::Vector3d& p : watched.outline) deepest = std::max(deepest, -ground_->above(body.r + body.A * p));
    if (first) depth.start = deepest;
    if (deepest <= depth.largest) continue;
    depth.largest = deepest;
    depth.time = sample.state.time;
  }
}

std::string UnheldBodies::warning() const {
  std::vector<std::size_t> through;
  for (std::size_t k = 0; k < watched_.size(); ++k)
    if (depths_[k].largest - std::max(0.0, depths_[k].start) > kThrough * watched_[k].size) through.push_back(k);
  if (through.empty()) return "";
  std::stable_sort(through.begin(), through.end(),
                   [&](std::size_t a, std::size_t b) { return depths_[a].largest > depths_[b].largest; });
  std::vector<std::string> others;
  for (std::size_t i = 1; i < std::min(through.size(), kMostNamed); ++i) others.push_back(watched_[through[i]].name);
  const std::size_t more = through.size() > kMostNamed ? through.size() - kMostNamed : 0;
  const Depth& depth = depths_[through[0]];
  const std::string& name = watched_[through[0]].name;
  return with_code(code::kThroughGround,
                   "body " + name + " went " + number_text(depth.largest, 3) +
                       " m below the surface of the ground, at t = " + number_text(depth.time, 3) + " s" +
                       (others.empty() ? "" : " (others: " + joined(others)) +
                       (more > 0 ? " and " + std::to_string(more) + " more" : "") + (others.empty() ? "" : ")") +
                       ": it has no boundary, so the ground does not hold it; add  [[boundaries]] body = \"" + name +
                       "\", surface = {}  or judge the run until then only");
}

}  // namespace footfall

// The outline of each shape against the surface, row by row.
#include "mbd_solver/session/observe/unheld_bodies.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

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
    std::optional<UnheldShape> shape = unheld_shape(scene, spec);
    if (!shape) continue;
    Watched watched{scene.body_index(spec.name), spec.name, shape->size, std::move(shape->outline)};
    const std::vector<HullEntry>& hulls = subject.mechanism.hulls;
    watched.held =
        std::any_of(hulls.begin(), hulls.end(), [&](const HullEntry& hull) { return hull.body == watched.body; });
    watched_.push_back(std::move(watched));
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
    if (depths_[k].largest - std::max(0.0, depths_[k].start) > kHullDepth * watched_[k].size) through.push_back(k);
  if (through.empty()) return "";
  std::stable_sort(through.begin(), through.end(),
                   [&](std::size_t a, std::size_t b) { return depths_[a].largest > depths_[b].largest; });
  std::vector<std::string> others;
  for (std::size_t i = 1; i < std::min(through.size(), kMostNamed); ++i) others.push_back(watched_[through[i]].name);
  const std::size_t more = through.size() > kMostNamed ? through.size() - kMostNamed : 0;
  const Depth& depth = depths_[through[0]];
  const std::string& name = watched_[through[0]].name;
  const bool held = watched_[through[0]].held;
  return with_code(code::kThroughGround,
                   "body " + name + " went " + number_text(depth.largest, 3) +
                       " m below the surface of the ground, at t = " + number_text(depth.time, 3) + " s" +
                       (others.empty() ? "" : " (others: " + joined(others)) +
                       (more > 0 ? " and " + std::to_string(more) + " more" : "") + (others.empty() ? "" : ")") +
                       ": it has no boundary, so the ground " +
                       (held ? "holds only a coarse surface of its shape, 5 % of its size lower" : "does not hold it") +
                       "; add  [[boundaries]] body = \"" + name + "\", surface = {}  or judge the run until then only");
}

}  // namespace footfall

// flexible.segments = N: a tube or rod as N bodies in a row with fixed joints. Each bends little in its own frame, so that
// the frames describe what linear modes in one floating frame omit: stiffening by tension, and large bending. theory 1.4.
#include <algorithm>
#include <cmath>

#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {

using namespace code;

namespace {

// In addition to the static shapes, which describe most of a short segment.
constexpr int kModesOfASegment = 2;

struct Cut {
  BodySpec whole;
  int count = 1;
  Eigen::Vector3d from, axis;  // axis: whole length [m]

  std::string name(int k) const { return whole.name + "_" + std::to_string(k + 1); }
  Eigen::Vector3d at(int k) const { return from + axis * k / count; }
  Eigen::Vector3d centre(int k) const { return from + axis * (k + 0.5) / count; }
  // The segment that a point of D belongs to; at a cut, the earlier one.
  int segment_at(const Eigen::Vector3d& point) const {
    const double share = (point - from).dot(axis) / axis.squaredNorm() * count;
    constexpr double kAtTheCut = 1e-9;
    return std::clamp(static_cast<int>(std::ceil(share - kAtTheCut)) - 1, 0, count - 1);
  }
};

bool may_be_cut(const BodySpec& body, Findings& findings) {
  const int before = findings.error_count();
  const FlexibleSpec& f = *body.flexible;
  const bool round = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod);
  const bool of_shape = f.file.empty() && f.mesh.empty() && f.nodes.empty() && f.stiffness_matrix.empty();
  if (!round || !of_shape)
    findings.error(
        kSegments, body.source, "flexible.segments",
        "divides a tube or rod along its axis, but this body has another elastic model; remove it, or define "
        "the bodies and joints one by one");
  for (const char* key : {"inertia", "position", "orientation"})
    if (body.source.given(key))
      findings.error(kSegments, body.source, key, "follows from the shape of each segment; remove it");
  if (body.mass_is_remainder)
    findings.error(kSegments, body.source, "mass",
                   "is the remainder, expected a number, or none, for a body in segments");
  return findings.error_count() == before;
}

std::vector<BodySpec> bodies_of(const Cut& cut) {
  std::vector<BodySpec> bodies;
  for (int k = 0; k < cut.count; ++k) {
    BodySpec body = cut.whole;
    body.name = cut.name(k);
    body.mass = cut.whole.mass / cut.count;
    body.shape->from = cut.at(k);
    body.shape->to = cut.at(k + 1);
    FlexibleSpec& f = *body.flexible;
    f.segments = 1;
    f.elements = std::max(2, (cut.whole.flexible->elements + cut.count - 1) / cut.count);
    if (!f.modes && !f.max_frequency) f.modes = kModesOfASegment;
    bodies.push_back(body);
  }
  return bodies;
}

void join(Scene& scene, const Cut& cut) {
  for (int k = 1; k < cut.count; ++k) {
    JointSpec joint;
    joint.source = cut.whole.source;
    joint.name = cut.name(k - 1) + "_" + std::to_string(k + 1);
    joint.type = JointType::kFixed;
    joint.bodies = {cut.name(k - 1), cut.name(k)};
    joint.point_a = joint.point_b = cut.at(k);
    scene.joints.push_back(joint);
  }
}

// Joints, struts, springs and forces of the whole act on the segment at their point.
void attach(Scene& scene, const Cut& cut, Findings& findings) {
  const auto pick = [&](std::string& name, const Eigen::Vector3d& point) {
    if (name == cut.whole.name) name = cut.name(cut.segment_at(point));
  };
  for (JointSpec& joint : scene.joints) {
    pick(joint.bodies[0], joint.point_a);
    pick(joint.bodies[1], joint.point_b);
  }
  for (StrutSpec& strut : scene.struts)
    for (std::size_t end = 0; end < 2; ++end) pick(strut.bodies[end], strut.points[end]);
  for (SpringSpec& spring : scene.springs) {
    const bool acts = spring.bodies[0] == cut.whole.name || spring.bodies[1] == cut.whole.name;
    if (acts && !spring.source.given("point"))
      findings.error(kPointOfAction, spring.source, "point",
                     "is missing; \"" + cut.whole.name + "\" is in segments, of which one is turned");
    for (std::string& name : spring.bodies) pick(name, spring.point);
  }
  for (ForceSpec& force : scene.forces) {
    if (force.body == cut.whole.name && !force.point)
      findings.error(kPointOfAction, force.source, "point",
                     "is missing; \"" + cut.whole.name + "\" is in segments, of which one is pushed");
    else
      pick(force.body, force.point.value_or(Eigen::Vector3d::Zero()));
  }
}

void replace_name(std::vector<std::string>& names, const Cut& cut) {
  const auto found = std::find(names.begin(), names.end(), cut.whole.name);
  if (found == names.end()) return;
  std::vector<std::string> segments;
  for (int k = 0; k < cut.count; ++k) segments.push_back(cut.name(k));
  names.insert(names.erase(found), segments.begin(), segments.end());
}

// Every entry of the whole becomes one of each segment; change(entry, k) adapts it.
template <class Entry, class Change>
void repeat(std::vector<Entry>& entries, const Cut& cut, const Change& change) {
  std::vector<Entry> result;
  for (const Entry& entry : entries) {
    if (entry.body != cut.whole.name) {
      result.push_back(entry);
      continue;
    }
    for (int k = 0; k < cut.count; ++k) {
      result.push_back(entry);
      result.back().body = cut.name(k);
      change(result.back(), k);
    }
  }
  entries = std::move(result);
}

void cut_boundaries(Scene& scene, const Cut& cut, Findings& findings) {
  for (const BoundarySpec& boundary : scene.boundaries) {
    if (boundary.body != cut.whole.name) continue;
    if (boundary.surface && !boundary.surface->file.empty())
      findings.error(kSegments, boundary.source, "surface.file",
                     "is one surface, but \"" + cut.whole.name +
                         "\" is in segments; use beams, or give each segment (" + cut.name(0) + ", ...) a surface");
    if (boundary.beams && !boundary.beams->points.empty())
      findings.error(
          kSegments, boundary.source, "beams.points",
          "are one chain, but \"" + cut.whole.name + "\" is in segments; remove them: beams follow the axis");
  }
  repeat(scene.boundaries, cut, [&](BoundarySpec& boundary, int) {
    if (boundary.beams) boundary.beams->segments = (boundary.beams->segments + cut.count - 1) / cut.count;
  });
  if (scene.ground.plane) replace_name(scene.ground.plane->bodies, cut);
}

void cut_initial_velocities(Scene& scene, const Cut& cut) {
  const InitialSpec& initial = scene.initial;
  const Eigen::Matrix3d R_WD = rotation_from_rpy(initial.roll, initial.pitch, initial.yaw);
  const Eigen::Vector3d middle = cut.from + 0.5 * cut.axis;
  repeat(scene.initial.bodies, cut, [&](BodyVelocitySpec& start, int k) {
    if (start.velocity && start.angular_velocity)
      *start.velocity += start.angular_velocity->cross(R_WD * (cut.centre(k) - middle));
  });
}

}  // namespace

void resolve_segments(Scene& scene, Findings& findings) {
  std::vector<BodySpec> bodies;
  for (const BodySpec& body : scene.bodies) {
    const bool whole = !body.flexible || body.flexible->segments == 1;
    if (whole || !may_be_cut(body, findings)) {
      bodies.push_back(body);
      continue;
    }
    const Cut cut{body, body.flexible->segments, body.shape->from, body.shape->to - body.shape->from};
    for (BodySpec& segment : bodies_of(cut)) bodies.push_back(std::move(segment));
    attach(scene, cut, findings);
    join(scene, cut);
    cut_boundaries(scene, cut, findings);
    cut_initial_velocities(scene, cut);
    replace_name(scene.output.bodies, cut);
    for (const ControllerSpec& controller : scene.controllers)
      if (controller.body == body.name)
        findings.error(kUnknownBody, controller.source, "body",
                       "\"" + body.name + "\" is in segments; name one of them, such as \"" + cut.name(0) + "\"");
  }
  scene.bodies = std::move(bodies);
}

}  // namespace footfall

// Each path is followed in a thousand steps; the first one beyond a side is reported. Heights are above the surface of the bed, which a
// terrain gives; its rocks are ground, not bodies that touch it.

#include "mbd_solver/bed/bed_forecast.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/assemble/time_functions.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {
namespace {

constexpr int kSteps = 1000;
constexpr double kHeld = 0.5;  // share of the friction that holds a body on a bed that may give way

// Bodies that joints, struts or springs connect with the ground.
std::set<std::string> held_by_ground(const Scene& scene) {
  std::set<std::string> held = {"ground"};
  for (std::size_t before = 0; before != held.size();) {
    before = held.size();
    const auto connect = [&](const auto& entries) {
      for (const auto& entry : entries)
        if (held.count(entry.bodies[0]) > 0 || held.count(entry.bodies[1]) > 0)
          held.insert(entry.bodies.begin(), entry.bodies.end());
    };
    connect(scene.joints);
    connect(scene.struts);
    connect(scene.springs);
    connect(cable_pairs(scene.cables));
  }
  return held;
}

using Path = std::function<Eigen::Vector3d(double t)>;  // displacement since the start [m]

// Of the body that a joint of type prescribed moves relative to the ground; nothing for other joints.
std::optional<Path> prescribed_path(const JointSpec& joint, const Mechanism& mechanism) {
  if (joint.type != JointType::kPrescribed || !joint.motion) return std::nullopt;
  Eigen::Matrix3d axes;
  axes.col(2) = joint.axis.normalized();
  axes.col(0) = (joint.axis2 - joint.axis2.dot(axes.col(2)) * axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  axes = mechanism.placement.R_WD * axes;
  const double sign = joint.bodies[0] == "ground" ? 1.0 : -1.0;
  std::vector<TimeFunctionPtr> along;
  for (const auto& part : {joint.motion->x, joint.motion->y, joint.motion->z})
    along.push_back(part ? time_function(*part, TableShape::kSpline) : nullptr);
  return [=](double t) {
    Eigen::Vector3d s = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      if (const TimeFunctionPtr& f = along[k]) s += sign * (f->at(t).value - f->at(0.0).value) * axes.col(k);
    return s;
  };
}

// The surface of the bed, in W.
class Surface {
 public:
  explicit Surface(const Scene& scene) {
    if (scene.ground.terrain) terrain_ = terrain_of(*scene.ground.terrain);
    if (const std::optional<TerrainBed> bed = terrain_bed(scene)) rocks_ = bed->rocks.size();
  }
  Terrain::Height at(const Eigen::Vector2d& place) const {
    return terrain_ ? terrain_->at(place.x(), place.y()) : Terrain::Height();
  }
  double height_of(const Eigen::Vector3d& p) const { return p.z() - at(p.head<2>()).h; }
  double lowest_of(const Eigen::Matrix3Xd& points) const {
    double lowest = HUGE_VAL;
    for (const auto& p : points.colwise()) lowest = std::min(lowest, height_of(p));
    return lowest;
  }
  bool is_rock(const std::string& body) const {
    for (std::size_t k = 0; k < rocks_; ++k)
      if (body == rock_name(k)) return true;
    return false;
  }

 private:
  std::shared_ptr<Terrain> terrain_;  // null: z = 0
  std::size_t rocks_ = 0;
};

// The way of a free body whose lowest point is `gap` above the surface at the place `from` of its origin [m].
std::vector<Eigen::Vector3d> free_path(const Scene& scene, const Surface& surface, const Eigen::Vector2d& from,
                                       Eigen::Vector3d v, double gap) {
  const Eigen::Vector3d& g = scene.gravity;
  const double dt = scene.end_time / kSteps;
  const double friction =
      kHeld * scene.particles->box->bodies.friction.value_or(scene.particles->box->material.friction);
  const double start = surface.at(from).h;
  const auto above = [&](const Eigen::Vector3d& s) { return gap + s.z() - (surface.at(from + s.head<2>()).h - start); };
  std::vector<Eigen::Vector3d> path = {Eigen::Vector3d::Zero()};
  for (int k = 0; k < kSteps; ++k) {
    v += dt * g;
    Eigen::Vector3d next = path.back() + dt * v;
    if (above(next) <= 0.0) {  // on the surface
      const Eigen::Vector2d slope = surface.at(from + path.back().head<2>()).slope;
      const Eigen::Vector3d normal = Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
      v -= std::min(0.0, normal.dot(v)) * normal;
      const double speed = v.norm(), slowing = friction * dt * std::max(0.0, -normal.dot(g));
      v *= speed > slowing ? 1.0 - slowing / speed : 0.0;
      next = path.back() + dt * v;
      next.z() -= std::min(0.0, above(next));
    }
    path.push_back(next);
  }
  return path;
}

// The nodes of a body at the start in W [m].
Eigen::Matrix3Xd nodes_at_start(const Mechanism& mechanism, const BodyBoundary& entry) {
  const BodyState& start = mechanism.model.initial(entry.body);
  const Eigen::Matrix3d R = Eigen::Quaterniond(start.L[0], start.L[1], start.L[2], start.L[3]).toRotationMatrix();
  return (R * entry.boundary.rho0()).colwise() + start.r;
}

// Where a body goes from its place at the start [m]; empty: not known.
std::vector<Eigen::Vector3d> path_of(const Scene& scene, const Mechanism& mechanism, const Surface& surface,
                                     const BodyBoundary& entry, bool held) {
  const std::string& name = entry.boundary.name();
  if (!held) {
    const BodyState& start = mechanism.model.initial(entry.body);
    return free_path(scene, surface, start.r.head<2>(), start.dr, surface.lowest_of(nodes_at_start(mechanism, entry)));
  }
  std::vector<Eigen::Vector3d> path;
  for (const JointSpec& joint : scene.joints) {
    const bool moves_it = (joint.bodies[0] == "ground" && joint.bodies[1] == name) ||
                          (joint.bodies[1] == "ground" && joint.bodies[0] == name);
    if (!moves_it) continue;
    if (const std::optional<Path> prescribed = prescribed_path(joint, mechanism))
      for (int k = 0; k <= kSteps; ++k) path.push_back((*prescribed)(k * scene.end_time / kSteps));
  }
  return path;
}

// The way along x and y, from its least to its largest value: of free bodies and of all that are prescribed [m].
Eigen::Matrix2d way_of(const Scene& scene, const Mechanism& mechanism, const Surface& surface,
                       const std::set<std::string>& held) {
  Eigen::Matrix2d way = Eigen::Matrix2d::Zero();
  const auto include = [&](const Eigen::Vector3d& s) {
    way.col(0) = way.col(0).cwiseMin(s.head<2>());
    way.col(1) = way.col(1).cwiseMax(s.head<2>());
  };
  for (const BodyBoundary& entry : mechanism.boundaries)
    if (held.count(entry.boundary.name()) == 0)
      for (const Eigen::Vector3d& s : path_of(scene, mechanism, surface, entry, false)) include(s);
  for (const JointSpec& joint : scene.joints)
    if (joint.bodies[0] == "ground" || joint.bodies[1] == "ground")
      if (const std::optional<Path> prescribed = prescribed_path(joint, mechanism))
        for (int k = 0; k <= kSteps; ++k) include((*prescribed)(k * scene.end_time / kSteps));
  return way;
}

}  // namespace

std::vector<std::string> leaving_bodies(const Scene& scene, const Mechanism& mechanism) {
  if (!scene.touches_particles() || !scene.particles->box) return {};
  const BoxSpec& box = *scene.particles->box;
  if (box.periodic || !box.walls) return {};
  const std::set<std::string> held = held_by_ground(scene);
  const Surface surface(scene);
  std::vector<std::string> warnings;
  for (const BodyBoundary& entry : mechanism.boundaries) {
    const std::string& name = entry.boundary.name();
    const BodyState& start = mechanism.model.initial(entry.body);
    const std::vector<Eigen::Vector3d> path = path_of(scene, mechanism, surface, entry, held.count(name) > 0);
    const auto beyond = [&](const Eigen::Vector3d& s, int axis) {
      const std::size_t c = axis;
      return std::abs(start.r[axis] + s[axis] - box.centre[c]) > 0.5 * box.size[c];
    };
    if (path.empty() || beyond(path.front(), 0) || beyond(path.front(), 1)) continue;  // it starts outside the bed
    const auto first =
        std::find_if(path.begin(), path.end(), [&](const Eigen::Vector3d& s) { return beyond(s, 0) || beyond(s, 1); });
    if (first == path.end()) continue;
    const double t = static_cast<double>(first - path.begin()) * scene.end_time / kSteps;
    const Eigen::Vector3d at = start.r + *first;
    warnings.push_back(
        with_code(code::kMayLeaveBed, "body \"", name, "\" may leave the bed through a side at t = ", number_text(t, 2),
                  " s, at x = ", number_text(at.x(), 3), " m, y = ", number_text(at.y(), 3),
                  " m: by its motion at the start and ", held.count(name) == 0 ? "gravity" : "its prescribed motion",
                  ". Make particles.box.size larger, move the bed (particles.box.centre), or end the scene earlier"));
  }
  return warnings;
}

BedProposal proposed_bed(const Scene& scene, const Mechanism& mechanism) {
  constexpr double kSolid = 0.57;        // volume of grains in a bed [-]
  constexpr double kPressure = 50.0;     // of a plate over rho g depth: loose soils (Li, Zhang and Goldman 2013) [-]
  constexpr double kOfRectangle = 0.7;   // area of a round or narrow body [-]
  constexpr double kMoves = 0.5;         // ways above this share of the width [-]
  constexpr double kTilt = 0.36;         // of a free mechanism about its first contact, at most: 20 degrees
  constexpr double kThinnest = 0.5;      // share of the depth on level ground that the lowest place has at least [-]
  constexpr double kFewestGrains = 5.0;  // below a narrow body and on each side of it
  const BoxSpec& box = *scene.particles->box;
  BedProposal bed;
  if (!box.walls) return bed;  // bodies hold it
  const Surface surface(scene);
  const std::set<std::string> held = held_by_ground(scene);
  std::vector<const BodyBoundary*> bodies;
  double lowest = HUGE_VAL;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();  // place of the lowest body
  for (const BodyBoundary& entry : mechanism.boundaries) {
    if (surface.is_rock(entry.boundary.name())) continue;
    bodies.push_back(&entry);
    const Eigen::Matrix3Xd x = nodes_at_start(mechanism, entry);
    if (const double low = surface.lowest_of(x); low < lowest) {
      lowest = low;
      first = x.topRows<2>().rowwise().mean();
    }
  }
  const Eigen::Matrix2d way = way_of(scene, mechanism, surface, held);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL), high = -low;
  double area = 0.0, under = HUGE_VAL;  // of the bodies [m2]; height of the surface under the lowest of them [m]
  for (const BodyBoundary* entry : bodies) {
    const Eigen::Matrix3Xd x = nodes_at_start(mechanism, *entry);
    const Eigen::Vector2d least = x.topRows<2>().rowwise().minCoeff(), most = x.topRows<2>().rowwise().maxCoeff();
    const Eigen::Vector2d middle = 0.5 * (least + most);
    const double width = (most - least).minCoeff();
    const double tilted = held.count(entry->boundary.name()) > 0 ? 0.0 : kTilt * (middle - first).norm();
    if (surface.lowest_of(x) > lowest + width + tilted) continue;  // it stays above the bed
    bed.width = std::max(bed.width, width);
    area += kOfRectangle * (most - least).prod();
    low = low.cwiseMin(least);
    high = high.cwiseMax(most);
    under = std::min(under, surface.at(middle).h);
    const Eigen::Vector3d& v = mechanism.model.initial(entry->body).dr;
    bed.further = bed.further || (held.count(entry->boundary.name()) > 0 && v.head<2>().norm() > 0.0);
  }
  if (!(area > 0.0) || !(bed.width > 0.0)) return bed;
  // A plate of this area stops at the depth s where 1/2 k A s^2 = M g s + 1/2 M v^2.
  double mass = 0.0;
  for (const BodySpec& body : scene.bodies)
    if (!surface.is_rock(body.name)) mass += body.mass;
  const double g = scene.gravity.norm(), v = scene.initial.velocity.z();
  const double stiffness = kPressure * kSolid * box.material.density * g * area;
  bed.sinkage = (mass * g + std::sqrt(mass * g * mass * g + stiffness * mass * v * v)) / stiffness;
  const double beside =
      std::max(bed.width, kFewestGrains * 2.0 * *std::max_element(box.radius.begin(), box.radius.end()));
  bed.depth = bed.sinkage + beside;
  Eigen::Vector2d from, to;
  for (int axis = 0; axis < 2; ++axis) {
    const bool follows = follows_along(box, axis);
    const bool moves = (way(axis, 1) - way(axis, 0)) > kMoves * bed.width;
    const double clear = (moves ? 2.0 : 1.0) * beside;
    from[axis] = low[axis] + (follows ? 0.0 : way(axis, 0)) - clear;
    to[axis] = high[axis] + (follows ? 0.0 : way(axis, 1)) + clear;
    bed.size[axis] = to[axis] - from[axis];
    bed.centre[axis] = 0.5 * (from[axis] + to[axis]);
    // Its body stays 0.3 of the side from both ends, and its slabs are a tenth of it, as long as the bed is deep.
    if (follows) bed.size[axis] = std::max((0.5 * (high[axis] - low[axis]) + clear) / 0.3, 10.0 * bed.depth);
  }
  // The floor is level, below the lowest place of the surface in the bed.
  constexpr int kPlaces = 60;
  double bottom = under;
  for (int i = 0; i <= kPlaces; ++i)
    for (int j = 0; j <= kPlaces; ++j)
      bottom = std::min(
          bottom, surface.at(from + (to - from).cwiseProduct(Eigen::Vector2d(i, j)) / static_cast<double>(kPlaces)).h);
  bed.depth = std::max(bed.depth - (under - bottom), kThinnest * bed.depth);
  return bed;
}

std::string proposal_text(const Scene& scene, const BedProposal& bed) {
  if (!(bed.width > 0.0)) return "";
  const auto two = [](double value) { return number_text(value, 2); };
  const auto place = [&](int axis) {
    return std::abs(bed.centre[axis]) < 0.005 * bed.size[axis] ? 0.0 : bed.centre[axis];
  };
  Scene with = scene;
  with.particles->box->size = {bed.size.x(), bed.size.y()};
  with.particles->box->centre = {bed.centre.x(), bed.centre.y()};
  with.particles->box->depth = bed.depth;
  const double grains = box_numbers(with).grains;
  const double digit = std::pow(10.0, std::floor(std::log10(grains)) - 1.0);  // the second
  return concat("  Suggested bed (", std::lround(digit * std::round(grains / digit)), " grains",
                bed.further || !scene.drives.empty() ? "; longer if the body travels" : "", "), for bodies up to ",
                two(bed.width), " m wide and about ", two(bed.sinkage),
                " m deep in a loose bed: --set particles.box.size=[", two(bed.size[0]), ",", two(bed.size[1]),
                "] --set particles.box.centre=[", two(place(0)), ",", two(place(1)),
                "] --set particles.box.depth=", two(bed.depth), " (docs/how-to/size_a_bed.md)\n");
}

}  // namespace footfall

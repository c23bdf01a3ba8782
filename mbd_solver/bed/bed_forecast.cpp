// Each path is followed in a thousand steps; the first one beyond a side is reported.

#include "mbd_solver/bed/bed_forecast.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/build/time_functions.h"
#include "mbd_solver/scene/box_bed.h"

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
      if (const TimeFunctionPtr& f = along[static_cast<std::size_t>(k)])
        s += sign * (f->at(t).value - f->at(0.0).value) * axes.col(k);
    return s;
  };
}

// Points of a free body above the surface z = 0 at the height `gap` [m].
std::vector<Eigen::Vector3d> free_path(const Scene& scene, Eigen::Vector3d v, double gap) {
  const Eigen::Vector3d& g = scene.gravity;
  const double dt = scene.end_time / kSteps;
  const double slowing =
      kHeld * scene.particles->box->bodies.friction.value_or(scene.particles->box->material.friction) * std::abs(g.z());
  std::vector<Eigen::Vector3d> path = {Eigen::Vector3d::Zero()};
  for (int k = 0; k < kSteps; ++k) {
    v += dt * g;
    if (gap + path.back().z() <= 0.0) {  // on the surface
      v.z() = 0.0;
      const double speed = v.norm();
      v *= speed > slowing * dt ? 1.0 - slowing * dt / speed : 0.0;
    }
    path.push_back(path.back() + dt * v);
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
std::vector<Eigen::Vector3d> path_of(const Scene& scene, const Mechanism& mechanism, const BodyBoundary& entry,
                                     bool held) {
  const std::string& name = entry.boundary.name();
  if (!held)
    return free_path(scene, mechanism.model.initial(entry.body).dr, nodes_at_start(mechanism, entry).row(2).minCoeff());
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
Eigen::Matrix2d way_of(const Scene& scene, const Mechanism& mechanism) {
  Eigen::Matrix2d way = Eigen::Matrix2d::Zero();
  const auto include = [&](const Eigen::Vector3d& s) {
    way.col(0) = way.col(0).cwiseMin(s.head<2>());
    way.col(1) = way.col(1).cwiseMax(s.head<2>());
  };
  const std::set<std::string> held = held_by_ground(scene);
  for (const BodyBoundary& entry : mechanism.boundaries)
    if (held.count(entry.boundary.name()) == 0)
      for (const Eigen::Vector3d& s : path_of(scene, mechanism, entry, false)) include(s);
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
  std::vector<std::string> warnings;
  for (const BodyBoundary& entry : mechanism.boundaries) {
    const std::string& name = entry.boundary.name();
    const BodyState& start = mechanism.model.initial(entry.body);
    const std::vector<Eigen::Vector3d> path = path_of(scene, mechanism, entry, held.count(name) > 0);
    const auto beyond = [&](const Eigen::Vector3d& s, int axis) {
      const auto c = static_cast<std::size_t>(axis);
      return std::abs(start.r[axis] + s[axis] - box.centre[c]) > 0.5 * box.size[c];
    };
    if (path.empty() || beyond(path.front(), 0) || beyond(path.front(), 1)) continue;  // it starts beside the bed
    const auto first =
        std::find_if(path.begin(), path.end(), [&](const Eigen::Vector3d& s) { return beyond(s, 0) || beyond(s, 1); });
    if (first == path.end()) continue;
    const double t = static_cast<double>(first - path.begin()) * scene.end_time / kSteps;
    const Eigen::Vector3d at = start.r + *first;
    warnings.push_back(with_code(code::kMayLeaveBed,
                                 "body \"" + name + "\" may leave the bed through a side at t = " + number_text(t, 2) +
                                     " s, at x = " + number_text(at.x(), 3) + " m, y = " + number_text(at.y(), 3) +
                                     " m: by its motion at the start and " +
                                     (held.count(name) == 0 ? "gravity" : "its prescribed motion") +
                                     ". Make particles.box.size larger, move the bed (particles.box.centre), or "
                                     "end the scene earlier"));
  }
  return warnings;
}

BedProposal proposed_bed(const Scene& scene, const Mechanism& mechanism) {
  constexpr double kSolid = 0.57;       // volume of grains in a bed [-]
  constexpr double kPressure = 50.0;    // of a plate over rho g depth: loose soils (Li, Zhang and Goldman 2013) [-]
  constexpr double kOfRectangle = 0.7;  // area of a round or narrow body [-]
  constexpr double kMoves = 0.5;        // ways above this share of the width [-]
  const BoxSpec& box = *scene.particles->box;
  BedProposal bed;
  double lowest = HUGE_VAL;
  for (const BodyBoundary& entry : mechanism.boundaries)
    lowest = std::min(lowest, nodes_at_start(mechanism, entry).row(2).minCoeff());
  const Eigen::Matrix2d way = way_of(scene, mechanism);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL), high = -low;
  double area = 0.0;
  for (const BodyBoundary& entry : mechanism.boundaries) {
    const Eigen::Matrix3Xd x = nodes_at_start(mechanism, entry);
    const Eigen::Vector2d least = x.topRows<2>().rowwise().minCoeff(), most = x.topRows<2>().rowwise().maxCoeff();
    const double width = (most - least).minCoeff();
    if (x.row(2).minCoeff() > lowest + width) continue;  // it stays above the bed
    bed.width = std::max(bed.width, width);
    area += kOfRectangle * (most - least).prod();
    low = low.cwiseMin(least);
    high = high.cwiseMax(most);
  }
  if (!(area > 0.0) || !(bed.width > 0.0)) return bed;
  // A plate of this area stops at the depth s where 1/2 k A s^2 = M g s + 1/2 M v^2.
  double mass = 0.0;
  for (const BodySpec& body : scene.bodies) mass += body.mass;
  const double g = scene.gravity.norm(), v = scene.initial.velocity.z();
  const double stiffness = kPressure * kSolid * box.material.density * g * area;
  bed.sinkage = (mass * g + std::sqrt(mass * g * mass * g + stiffness * mass * v * v)) / stiffness;
  bed.depth = bed.sinkage + bed.width;
  for (int axis = 0; axis < 2; ++axis) {
    const bool follows = follows_along(box, axis);
    const bool moves = (way(axis, 1) - way(axis, 0)) > kMoves * bed.width;
    const double clear = (moves ? 2.0 : 1.0) * bed.width;
    const double from = low[axis] + (follows ? 0.0 : way(axis, 0)) - clear,
                 to = high[axis] + (follows ? 0.0 : way(axis, 1)) + clear;
    bed.size[axis] = to - from;
    bed.centre[axis] = 0.5 * (from + to);
    // Its body stays 0.3 of the side from both ends, and its slabs are a tenth of it, as long as the bed is deep.
    if (follows) bed.size[axis] = std::max((0.5 * (high[axis] - low[axis]) + clear) / 0.3, 10.0 * bed.depth);
  }
  return bed;
}

std::string proposal_text(const Scene& scene, const BedProposal& bed) {
  if (!(bed.width > 0.0)) return "";
  const BoxSpec& box = *scene.particles->box;
  const auto two = [](double value) { return number_text(std::abs(value) < 1e-6 ? 0.0 : value, 2); };
  const double grains =
      bed.size.prod() * bed.depth / (box.size[0] * box.size[1] * box.depth) * box_numbers(scene).grains;
  const double digit = std::pow(10.0, std::floor(std::log10(grains)) - 1.0);  // the second
  return "  for these bodies, up to " + two(bed.width) + " m wide and about " + two(bed.sinkage) +
         " m deep in a loose bed, start with " + std::to_string(std::lround(digit * std::round(grains / digit))) +
         " grains" + (scene.drives.empty() ? "" : " (and more for the way that drives make)") +
         ": --set particles.box.size=[" + two(bed.size[0]) + "," + two(bed.size[1]) + "] --set particles.box.centre=[" +
         two(bed.centre[0]) + "," + two(bed.centre[1]) + "] --set particles.box.depth=" + two(bed.depth) +
         " (docs/how-to/size_a_bed.md)\n";
}

}  // namespace footfall

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
    const Eigen::Matrix3d R = Eigen::Quaterniond(start.L[0], start.L[1], start.L[2], start.L[3]).toRotationMatrix();
    const double lowest = start.r.z() + (R.row(2) * entry.boundary.rho0()).minCoeff();
    std::vector<Eigen::Vector3d> path;
    if (held.count(name) == 0) {
      path = free_path(scene, start.dr, lowest);
    } else {
      for (const JointSpec& joint : scene.joints) {
        const bool moves_it = (joint.bodies[0] == "ground" && joint.bodies[1] == name) ||
                              (joint.bodies[1] == "ground" && joint.bodies[0] == name);
        if (!moves_it) continue;
        if (const std::optional<Path> prescribed = prescribed_path(joint, mechanism))
          for (int k = 0; k <= kSteps; ++k) path.push_back((*prescribed)(k * scene.end_time / kSteps));
      }
    }
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

}  // namespace footfall

// Bodies that other joints connect to either side of a joint move with it; the ground does not move.

#include "mbd_solver/assemble/mechanism.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The sets of bodies (the ground is the last) that joints other than `left_out` connect: one number for each set.
std::vector<int> connected(const Scene& scene, const Model& model, int left_out) {
  std::vector<int> set(static_cast<std::size_t>(model.body_count()) + 1);
  std::iota(set.begin(), set.end(), 0);
  // A tree for each set; a body is led to its root.
  const auto root_of = [&](int body) {
    std::size_t i = body == kGround ? set.size() - 1 : static_cast<std::size_t>(body);
    for (; set[i] != static_cast<int>(i); i = static_cast<std::size_t>(set[i])) set[i] = set[set[i]];
    return static_cast<int>(i);
  };
  for (int j = 0; j < static_cast<int>(scene.joints.size()); ++j) {
    if (j == left_out) continue;
    const int from = root_of(model.joint(j).m1.body), to = root_of(model.joint(j).m2.body);
    set[from] = to;
  }
  std::vector<int> roots(set.size());
  for (int i = 0; i < model.body_count(); ++i) roots[i] = root_of(i);
  roots.back() = root_of(kGround);
  return roots;
}

// Mass or inertia of the bodies for which `counts` holds, about the axis e through p, or along it.
template <class Counts>
double sum_of(const Model& model, bool turns, const Eigen::Vector3d& p, const Eigen::Vector3d& e, Counts counts) {
  double sum = 0.0;
  for (int i = 0; i < model.body_count(); ++i) {
    if (!counts(static_cast<std::size_t>(i))) continue;
    const Body& body = model.body(i);
    const BodyState& at = model.initial(i);
    if (!turns) {
      sum += body.mass();
      continue;
    }
    const Eigen::Vector3d e_B = rotation_matrix(at.L).transpose() * e;
    sum += e_B.dot(body.rigid_inertia() * e_B) + body.mass() * (at.r - p).cross(e).squaredNorm();
  }
  return sum;
}

// Without gears and rotors.
double joined_mass(const Scene& scene, const Model& model, int index, Coordinate coordinate) {
  const Joint& joint = model.joint(index);
  const bool turns = coordinate == Coordinate::kAngle;
  const Marker& on = joint.m1.body == kGround ? joint.m2 : joint.m1;
  const Eigen::Vector3d p = model.initial_position(on);
  const Eigen::Vector3d e = rotation_matrix(model.initial(on.body).L) * on.axes.col(axis_of(coordinate));
  const std::vector<int> set = connected(scene, model, index);
  const int ground = set.back();
  const auto side = [&](int body) {
    if (body == kGround || set[body] == ground) return kInfinite;
    return sum_of(model, turns, p, e, [&](std::size_t i) { return set[i] == set[body]; });
  };
  const double least = std::min(side(joint.m1.body), side(joint.m2.body));
  return least < kInfinite ? least : sum_of(model, turns, p, e, [](std::size_t) { return true; });
}

}  // namespace

double moved_mass(const Scene& scene, const Mechanism& mechanism, int joint, Coordinate coordinate) {
  const Model& model = mechanism.model;
  double mass = joined_mass(scene, model, joint, coordinate);
  for (const DriveSpec& drive : scene.drives)
    if (scene.joint_index(drive.joint) == joint && scene.coordinate_of(drive) == coordinate)
      mass += drive.rotor_inertia * drive.motor.gear_ratio * drive.motor.gear_ratio;
  // For a gear f_1 q_1 + f_2 q_2 = 0 the other member moves by f_1 / f_2.
  for (const GearSpec& gear : scene.gears) {
    const auto is_this = [&](std::size_t i) {
      return scene.joint_index(gear.joints[i]) == joint && scene.coordinate_of(gear, i) == coordinate;
    };
    for (std::size_t i = 0; i < gear.joints.size(); ++i) {
      if (!is_this(i)) continue;
      for (std::size_t k = 0; k < gear.joints.size(); ++k) {
        if (k == i) continue;
        const double ratio = gear.factors[i] / gear.factors[k];
        mass +=
            ratio * ratio * joined_mass(scene, model, scene.joint_index(gear.joints[k]), scene.coordinate_of(gear, k));
      }
    }
  }
  return mass;
}

}  // namespace footfall

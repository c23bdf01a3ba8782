#pragma once
// Mechanisms with a smooth motion and no exact solution, for tests of integrators: loops of two to four rigid bodies from
// the ground to the ground, with springs and dampers.

#include <string>
#include <vector>

#include "mbd_solver/model/laws/springs.h"
#include "tests/unit/dynamics/random_model.h"

namespace footfall::test {

inline std::unique_ptr<ForceElement> spring_between(const std::string& name, const Marker& m1, const Marker& m2,
                                                    double length) {
  std::vector<std::unique_ptr<StrutLaw>> laws;
  LinearSpringDamperParameters spring;
  spring.stiffness = 60.0;
  spring.damping = 0.5;
  laws.push_back(std::make_unique<LinearSpringDamper>(spring));
  return std::make_unique<Strut>(name, m1, m2, std::move(laws), length);
}

// Bodies between the points of a random polygon whose ends stand on the ground; revolute joints at both ends and
// spherical ones between, so that two to five degrees of freedom are left.
inline Model smooth_loop(unsigned seed) {
  Random random(seed);
  Model model({0.0, 0.0, -9.81});
  const int count = 2 + static_cast<int>(seed % 3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= count; ++i) points.push_back(Eigen::Vector3d(0.8 * i, 0.0, 0.0) + random.vector(0.3));
  for (int i = 0; i < count; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    BodyState state;
    state.r = 0.5 * (points[at] + points[at + 1]) + random.vector(0.1);
    state.L = random.quaternion();
    state.dr = random.vector(1.0);
    state.w = random.vector(2.0);
    const Eigen::Matrix3d inertia = random.inertia(0.1);
    model.add_body(Body("link_" + std::to_string(i), random.number(0.5, 2.0), inertia), state);
  }
  for (int i = 0; i <= count; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const int body_1 = i == 0 ? kGround : i - 1, body_2 = i < count ? i : kGround;
    const Eigen::Matrix3d axes = random.axes();
    const Marker m1 = model.marker_at(body_1, points[at], axes), m2 = model.marker_at(body_2, points[at], axes);
    const bool turns = i == 0 || (i == count && count > 2);
    model.add_joint(turns ? revolute_joint("joint_" + std::to_string(i), m1, m2)
                          : spherical_joint("joint_" + std::to_string(i), m1, m2));
  }
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d foot = random.vector(1.5), eye = model.initial(i).r + random.vector(0.2);
    model.add_force(spring_between("spring_" + std::to_string(i), ground_marker(foot), model.marker_at(i, eye),
                                   0.7 * (foot - eye).norm()));
  }
  return model;
}

}  // namespace footfall::test

#pragma once
// Mechanisms of rigid rods with published or exact answers, for tests and for the page docs/mechanisms_checked.md:
// Bricard, Bennett, N four-bars, planar crank-rockers, hanging chains.

#include <cmath>
#include <string>
#include <vector>

#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/model.h"

namespace footfall::test {

// A uniform rod between two points of W, `diameter` thick, with its angular velocity and the velocity of `from`.
inline int add_rod(Model& model, const std::string& name, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                   const Eigen::Vector3d& w = Eigen::Vector3d::Zero(),
                   const Eigen::Vector3d& v_from = Eigen::Vector3d::Zero(), double mass = 1.0,
                   double diameter = 0.01) {
  const MassProperties rod = with_mass(rod_properties(from, to, diameter, 1000.0), mass);
  BodyState state;
  state.r = rod.centre;
  state.w = w;
  state.dr = v_from + w.cross(Eigen::Vector3d(rod.centre - from));
  return model.add_body(Body(name, rod.mass, rod.inertia), state);
}

// A hinge about `axis` at a point of W.
inline Joint hinge(const Model& model, const std::string& name, int body_1, int body_2, const Eigen::Vector3d& point,
                   const Eigen::Vector3d& axis = Eigen::Vector3d::UnitZ()) {
  const Eigen::Matrix3d axes = axes_with_z(axis);
  return revolute_joint(name, model.marker_at(body_1, point, axes), model.marker_at(body_2, point, axes));
}

// N cells of hinged rods of 1 m and 1 kg, upright, the upper left corner moving at 1 m/s to the right (IFToMM
// benchmark A02). Whenever the posts lie flat the mechanism could change its branch: Phi_v loses rank.
inline Model n_four_bar(int cells) {
  Model model({0.0, -9.81, 0.0});
  std::vector<int> posts, beams;
  const Eigen::Vector3d up = Eigen::Vector3d::UnitY(), right = Eigen::Vector3d::UnitX();
  for (int i = 0; i <= cells; ++i)
    posts.push_back(
        add_rod(model, "post_" + std::to_string(i), i * right, i * right + up, -Eigen::Vector3d::UnitZ()));
  for (int i = 0; i < cells; ++i)
    beams.push_back(add_rod(model, "beam_" + std::to_string(i), i * right + up, (i + 1) * right + up,
                            Eigen::Vector3d::Zero(), right));
  for (int i = 0; i <= cells; ++i) {
    const std::string number = std::to_string(i);
    const std::size_t at = static_cast<std::size_t>(i);
    model.add_joint(hinge(model, "foot_" + number, kGround, posts[at], i * right));
    if (i < cells) model.add_joint(hinge(model, "left_" + number, posts[at], beams[at], i * right + up));
    if (i > 0) model.add_joint(hinge(model, "right_" + number, beams[at - 1], posts[at], i * right + up));
  }
  return model;
}

// A closed chain of rods with a hinge at every corner; the last side is the ground.
inline Model closed_chain(const Eigen::Vector3d& gravity, const std::vector<Eigen::Vector3d>& corners,
                          const std::vector<Eigen::Vector3d>& axes) {
  Model model(gravity);
  const std::size_t n = corners.size();
  int last = kGround;
  for (std::size_t i = 0; i < n; ++i) {
    const int next =
        i + 1 < n ? add_rod(model, "rod_" + std::to_string(i + 1), corners[i], corners[i + 1]) : kGround;
    model.add_joint(hinge(model, "hinge_" + std::to_string(i), last, next, corners[i], axes[i]));
    last = next;
  }
  return model;
}

// Bricard's mechanism (IFToMM benchmark A03): five rods of 1 m and 1 kg along the edges of a cube, six hinges, each
// square to both its rods. One degree of freedom, 30 conditions, one too many in every position.
inline Model bricard() {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  return closed_chain({0.0, -9.81, 0.0}, {0.0 * x, x, x - y, x - y + z, z - y, z}, {y, z, x, y, z, x});
}

// Bennett's mechanism: four hinges out of parallel, sin(alpha) / a = sin(beta) / b. One degree of freedom, 20
// conditions, three too many in every position. `angle`: of the first hinge [rad].
inline Model bennett(double angle = 1.0) {
  const double alpha = M_PI / 6.0, beta = 7.0 / 18.0 * M_PI, a = 1.0, b = a * std::sin(beta) / std::sin(alpha);
  // tan(theta_1 / 2) tan(theta_2 / 2) = sin((beta + alpha) / 2) / sin((beta - alpha) / 2)
  const double theta_2 = 2.0 * std::atan(std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha)) /
                                         std::tan(0.5 * angle));
  const double theta[4] = {angle, theta_2, 2.0 * M_PI - angle, 2.0 * M_PI - theta_2};
  const double length[4] = {a, b, a, b}, twist[4] = {alpha, beta, alpha, beta};
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector3d> corners, axes;
  for (int i = 0; i < 4; ++i) {
    corners.push_back(frame.translation());
    axes.push_back(frame.linear().col(2));
    frame.rotate(Eigen::AngleAxisd(theta[i], Eigen::Vector3d::UnitZ()));
    frame.translate(length[i] * Eigen::Vector3d::UnitX());
    frame.rotate(Eigen::AngleAxisd(twist[i], Eigen::Vector3d::UnitX()));
  }
  // The first rod leads from the first to the second corner, the last is the ground.
  return closed_chain({0.0, -9.81, 0.0}, corners, axes);
}

}  // namespace footfall::test

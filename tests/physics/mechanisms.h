#pragma once
// Mechanisms of rigid rods with published or exact answers, for tests:
// N four-bars, Bricard, Bennett, planar crank-rockers.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/model.h"

namespace footfall::test {

// A uniform rod between two points of W, `diameter` thick, with its angular velocity and the velocity of `from`.
inline int add_rod(Model& model, const std::string& name, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                   const Eigen::Vector3d& w = Eigen::Vector3d::Zero(),
                   const Eigen::Vector3d& v_from = Eigen::Vector3d::Zero(), double mass = 1.0, double diameter = 0.01) {
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
    posts.push_back(add_rod(model, "post_" + std::to_string(i), i * right, i * right + up, -Eigen::Vector3d::UnitZ()));
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
    const int next = i + 1 < n ? add_rod(model, "rod_" + std::to_string(i + 1), corners[i], corners[i + 1]) : kGround;
    model.add_joint(hinge(model, "hinge_" + std::to_string(i), last, next, corners[i], axes[i]));
    last = next;
  }
  return model;
}

// Bricard's mechanism (IFToMM benchmark A03): five rods of 1 m and 1 kg along the edges of a cube, six hinges, each
// square to both its rods. One degree of freedom, 30 conditions, one too many in every position. turn() gives the angle
// of the markers about the axis of a hinge, exchange() whether its bodies change places: the mechanism is the same.
template <typename Turn, typename Exchange>
Model bricard(double diameter, Turn turn, Exchange exchange) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d corners[6] = {0.0 * x, x, x - y, x - y + z, z - y, z}, axes[6] = {y, z, x, y, z, x};
  Model model({0.0, -9.81, 0.0});
  int last = kGround;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::string number = std::to_string(i);
    const int next =
        i < 5 ? add_rod(model, "rod_" + number, corners[i], corners[i + 1], 0.0 * x, 0.0 * x, 1.0, diameter) : kGround;
    const Eigen::Matrix3d at = axes_with_z(axes[i]) * Eigen::AngleAxisd(turn(), z).toRotationMatrix();
    const bool exchanged = exchange();
    model.add_joint(revolute_joint("hinge_" + number, model.marker_at(exchanged ? next : last, corners[i], at),
                                   model.marker_at(exchanged ? last : next, corners[i], at)));
    last = next;
  }
  return model;
}

// Peaucellier's linkage: two long rods from O, a rhombus of short ones, and a crank that leads its corner B around a circle
// through O, so that the corner P opposite moves along x = (long^2 - short^2) / (2 crank). Seven rods, ten hinges, gravity
// along -y. Where the rhombus lies flat (OB = long - short) its two corners C and D pass through each other: there the
// mechanism could change its branch. `angle` [rad] and `speed` [rad/s] of the crank about its end on the ground.
inline Model peaucellier(double angle, double speed) {
  const double crank = 0.6, length = 1.0, side = 0.5;
  using Point = Eigen::Vector3d;
  const Point O = Point::Zero(), A(crank, 0.0, 0.0), B = A + crank * Point(std::cos(angle), std::sin(angle), 0.0);
  const double to_B = B.norm(), along = (length * length - side * side + to_B * to_B) / (2.0 * to_B);
  const double across = std::sqrt(length * length - along * along);
  const Point u = B / to_B, n(-u.y(), u.x(), 0.0), C = along * u + across * n, D = along * u - across * n;
  const Point P = 2.0 * along * u - B;
  // Rates: to_B along the circle, the corners by the lengths.
  const Point z = Point::UnitZ(), v_B = speed * z.cross(Point(B - A));
  const double rate = u.dot(v_B), turn = n.dot(v_B) / to_B;
  const double along_rate = rate * (0.5 - (length * length - side * side) / (2.0 * to_B * to_B));
  const double across_rate = -along * along_rate / across;
  const auto moved = [&](double a, double b, double a_rate, double b_rate) -> Point {
    return a_rate * u + b_rate * n + turn * (a * n - b * u);
  };
  const Point v_C = moved(along, across, along_rate, across_rate),
              v_D = moved(along, -across, along_rate, -across_rate);
  Model model({0.0, -9.81, 0.0});
  const auto rod = [&](const std::string& name, const Point& from, const Point& to, const Point& v_from,
                       const Point& v_to) {
    const Point e = to - from, w = e.cross(Point(v_to - v_from)) / e.squaredNorm();
    return add_rod(model, name, from, to, w, v_from);
  };
  const Point v_P = 2.0 * moved(along, 0.0, along_rate, 0.0) - v_B;
  const int AB = rod("AB", A, B, 0.0 * z, v_B), OC = rod("OC", O, C, 0.0 * z, v_C), OD = rod("OD", O, D, 0.0 * z, v_D);
  const int BC = rod("BC", B, C, v_B, v_C), BD = rod("BD", B, D, v_B, v_D);
  const int PC = rod("PC", P, C, v_P, v_C), PD = rod("PD", P, D, v_P, v_D);
  model.add_joint(hinge(model, "A", kGround, AB, A));
  model.add_joint(hinge(model, "O_C", kGround, OC, O));
  model.add_joint(hinge(model, "O_D", kGround, OD, O));
  model.add_joint(hinge(model, "B_C", AB, BC, B));
  model.add_joint(hinge(model, "B_D", AB, BD, B));
  model.add_joint(hinge(model, "C_B", OC, BC, C));
  model.add_joint(hinge(model, "C_P", OC, PC, C));
  model.add_joint(hinge(model, "D_B", OD, BD, D));
  model.add_joint(hinge(model, "D_P", OD, PD, D));
  model.add_joint(hinge(model, "P", PC, PD, P));
  return model;
}

// A scissor lift: pairs of crossed bars of 1 m at `angle` [rad] to the floor, which changes at `rate` [rad/s]; the foot of the
// first pair slides on a rail, gravity along -y. Where all bars lie flat the lift could change its branch at every pin.
inline Model scissor_lift(int stages, double angle, double rate) {
  using Point = Eigen::Vector3d;
  const double w = std::cos(angle), h = std::sin(angle), dw = -h * rate, dh = w * rate;
  const Point z = Point::UnitZ();
  Model model({0.0, -9.81, 0.0});
  std::vector<int> rising, falling;
  for (int i = 0; i < stages; ++i) {
    const std::string number = std::to_string(i);
    rising.push_back(
        add_rod(model, "rising_" + number, {0.0, i * h, 0.0}, {w, (i + 1) * h, 0.0}, rate * z, {0.0, i * dh, 0.0}));
    falling.push_back(
        add_rod(model, "falling_" + number, {w, i * h, 0.0}, {0.0, (i + 1) * h, 0.0}, -rate * z, {dw, i * dh, 0.0}));
  }
  const int foot = add_rod(model, "foot", {w - 0.05, 0.0, 0.0}, {w + 0.05, 0.0, 0.0}, 0.0 * z, {dw, 0.0, 0.0});
  const Eigen::Matrix3d along = axes_with_z(Point::UnitX());
  model.add_joint(prismatic_joint("rail", model.marker_at(kGround, {w, 0.0, 0.0}, along),
                                  model.marker_at(foot, {w, 0.0, 0.0}, along)));
  model.add_joint(hinge(model, "fixed", kGround, rising[0], 0.0 * z));
  model.add_joint(hinge(model, "sliding", foot, falling[0], {w, 0.0, 0.0}));
  for (std::size_t i = 0; i < rising.size(); ++i) {
    const std::string number = std::to_string(i);
    const double low = static_cast<double>(i) * h, top = low + h;
    model.add_joint(hinge(model, "middle_" + number, rising[i], falling[i], {0.5 * w, low + 0.5 * h, 0.0}));
    if (i + 1 == rising.size()) continue;
    model.add_joint(hinge(model, "left_" + number, falling[i], rising[i + 1], {0.0, top, 0.0}));
    model.add_joint(hinge(model, "right_" + number, rising[i], falling[i + 1], {w, top, 0.0}));
  }
  return model;
}

// A planar four-bar with a crank that turns all around, of random lengths, speed and plane, gravity in the plane; with
// four hinges, or with a ball and a cylinder in place of the last two.
inline Model crank_rocker(unsigned seed, bool ball_and_cylinder) {
  std::mt19937 engine(seed);
  const auto random = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
  do {  // Grashof
    a = random(0.2, 0.5), b = random(0.6, 1.5), c = random(0.6, 1.5), d = random(0.6, 1.5);
  } while (a + 2.0 * std::max({b, c, d}) > 0.98 * (b + c + d));
  const double angle = random(0.0, 6.28), w = random(1.0, 4.0);
  Eigen::Vector4d L;  // not as arguments, whose order is the compiler's
  for (const int i : {3, 2, 1, 0}) L[i] = random(-1.0, 1.0);
  const Eigen::Matrix3d R = rotation_matrix(L.normalized());
  const Eigen::Vector2d A(a * std::cos(angle), a * std::sin(angle)), D(d, 0.0), e = D - A;
  const double x = (b * b - c * c + e.squaredNorm()) / (2.0 * e.norm()), h = std::sqrt(b * b - x * x);
  const Eigen::Vector2d B = A + (x * e + h * Eigen::Vector2d(-e.y(), e.x())) / e.norm();
  const auto at = [&](const Eigen::Vector2d& p) { return Eigen::Vector3d(R * Eigen::Vector3d(p.x(), p.y(), 0.0)); };
  const auto turned = [](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.y(), p.x()); };
  const Eigen::Vector2d v_A = w * turned(A);
  Eigen::Matrix2d speeds;  // v_A + w_b turned(B - A) = w_c turned(B - D)
  speeds << turned(B - A), -turned(B - D);
  const Eigen::Vector2d w_bc = speeds.inverse() * -v_A;
  const Eigen::Vector3d z = R.col(2), none = Eigen::Vector3d::Zero();
  Model model(R * Eigen::Vector3d(0.0, -9.81, 0.0));
  const int crank = add_rod(model, "crank", at({0.0, 0.0}), at(A), w * z, none, 1.0, 0.2);
  const int coupler = add_rod(model, "coupler", at(A), at(B), w_bc[0] * z, at(v_A), 1.0, 0.2);
  const int rocker = add_rod(model, "rocker", at(D), at(B), w_bc[1] * z, none, 1.0, 0.2);
  model.add_joint(hinge(model, "bearing", kGround, crank, at({0.0, 0.0}), z));
  model.add_joint(hinge(model, "pin", crank, coupler, at(A), z));
  if (ball_and_cylinder) {
    const Eigen::Matrix3d axes = axes_with_z(z);
    model.add_joint(spherical_joint("ball", model.marker_at(coupler, at(B)), model.marker_at(rocker, at(B))));
    model.add_joint(
        cylindrical_joint("foot", model.marker_at(kGround, at(D), axes), model.marker_at(rocker, at(D), axes)));
  } else {
    model.add_joint(hinge(model, "ball", coupler, rocker, at(B), z));
    model.add_joint(hinge(model, "foot", kGround, rocker, at(D), z));
  }
  return model;
}

// Bennett's mechanism: four hinges out of parallel, sin(alpha) / a = sin(beta) / b. One degree of freedom, 20
// conditions, three too many in every position. `angle`: of the first hinge [rad].
inline Model bennett(double angle = 1.0) {
  const double alpha = M_PI / 6.0, beta = 7.0 / 18.0 * M_PI, a = 1.0, b = a * std::sin(beta) / std::sin(alpha);
  // tan(theta_1 / 2) tan(theta_2 / 2) = sin((beta + alpha) / 2) / sin((beta - alpha) / 2)
  const double theta_2 =
      2.0 * std::atan(std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha)) / std::tan(0.5 * angle));
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

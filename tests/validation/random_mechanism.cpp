#include "tests/validation/random_mechanism.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/model/rotation.h"
#include "tests/physics/motion_of.h"
#include "tests/support/linear_algebra.h"
#include "tests/validation/random_forces.h"
#include "tests/validation/random_numbers.h"

namespace footfall::test {
namespace {

using Eigen::Vector3d;

// Solid of about half a metre, turned at will; its velocity is made to fit the joints later.
int add_body(Plan& plan, Numbers& numbers, const Vector3d& centre) {
  PlannedBody body;
  body.name = "body_" + std::to_string(plan.bodies.size());
  body.mass = numbers.between(0.5, 2.0);
  const double z = numbers.between(0.2, 0.6), y = numbers.between(0.2, 0.6), x = numbers.between(0.2, 0.6);
  const Vector3d size(x, y, z);
  body.inertia = body.mass / 12.0 *
                 (size.squaredNorm() * Eigen::Matrix3d::Identity() - Eigen::Matrix3d(size.cwiseAbs2().asDiagonal()));
  body.state.r = centre;
  body.state.L = numbers.quaternion();
  body.state.dr = numbers.vector(1.0);
  body.state.w = numbers.vector(2.0);
  plan.bodies.push_back(body);
  return static_cast<int>(plan.bodies.size()) - 1;
}

void add_joint(Plan& plan, JointKind kind, int body_1, int body_2, const Vector3d& point, const Eigen::Matrix3d& axes) {
  PlannedJoint joint;
  joint.name = "joint_" + std::to_string(plan.joints.size());
  joint.kind = kind;
  joint.body_1 = body_1;
  joint.body_2 = body_2;
  joint.point_1 = joint.point_2 = point;
  joint.axes = axes;
  plan.joints.push_back(joint);
}

int conditions(JointKind kind) {
  switch (kind) {
    case JointKind::kFixed:
    case JointKind::kDriven: return 6;
    case JointKind::kRevolute:
    case JointKind::kPrismatic: return 5;
    case JointKind::kUniversal:
    case JointKind::kCylindrical: return 4;
    case JointKind::kDisc:
    case JointKind::kSphere:
    case JointKind::kSpherical: return 3;
    case JointKind::kDistance:
    case JointKind::kPlane:
    case JointKind::kAxialHold: return 1;
  }
  FOOTFALL_DEMAND(false);
  return 0;
}

// Every body on an earlier one (or the ground), by a joint of any kind.
void grow_tree(Plan& plan, Numbers& numbers, bool grounded) {
  constexpr JointKind kKinds[] = {JointKind::kSpherical, JointKind::kUniversal,   JointKind::kRevolute,
                                  JointKind::kPrismatic, JointKind::kCylindrical, JointKind::kFixed,
                                  JointKind::kDistance,  JointKind::kPlane};
  const int count = numbers.whole(2, 5);
  for (int i = 0; i < count; ++i) {
    const int parent = i == 0 ? kGround : numbers.whole(grounded ? kGround : 0, i - 1);
    const Vector3d from = parent == kGround ? Vector3d::Zero() : plan.bodies[static_cast<std::size_t>(parent)].state.r;
    const Vector3d point = from + numbers.arrow(0.3, 0.6);
    const int body = add_body(plan, numbers, point + numbers.arrow(0.3, 0.6));
    if (parent == kGround && !grounded) continue;
    const Eigen::Matrix3d axes = numbers.axes();
    add_joint(plan, kKinds[numbers.whole(0, 7)], parent, body, point, axes);
    if (plan.joints.back().kind == JointKind::kDistance) plan.joints.back().point_2 += numbers.direction() * 0.4;
  }
}

// A chain through the corners of a random polygon: from the ground to the ground, or a ring. Joints are drawn until one
// to four degrees of freedom are left besides the freedoms of the ring as a whole.
void close_loop(Plan& plan, Numbers& numbers, bool grounded, bool driven, int least = 1) {
  constexpr JointKind kKinds[] = {JointKind::kSpherical, JointKind::kUniversal, JointKind::kRevolute,
                                  JointKind::kCylindrical, JointKind::kPrismatic};
  const int bodies = grounded ? numbers.whole(driven || least > 1 ? 3 : 2, 4) : numbers.whole(3, 5),
            joints = grounded ? bodies + 1 : bodies;
  std::vector<JointKind> kinds(static_cast<std::size_t>(joints));
  int freedom = 0;
  do {
    freedom = 6 * bodies - (grounded ? 0 : 6);
    for (JointKind& kind : kinds) kind = kKinds[numbers.whole(0, 4)];
    kinds.front() = JointKind::kRevolute;  // what is driven, or carries a spring
    for (const JointKind kind : kinds) freedom -= conditions(kind);
  } while (freedom < (driven ? 2 : least) || freedom > 4);
  if (driven) kinds.front() = JointKind::kDriven;
  std::vector<Vector3d> corners;
  const double turn = 2.0 * M_PI / joints;
  for (int i = 0; i < joints; ++i)
    corners.push_back(Vector3d(std::cos(i * turn), std::sin(i * turn), 0.0) * 0.3 * joints + numbers.vector(0.3));
  for (int i = 0; i < bodies; ++i)
    add_body(plan, numbers,
             0.5 * (corners[static_cast<std::size_t>(i)] + corners[static_cast<std::size_t>((i + 1) % joints)]) +
                 numbers.vector(0.1));
  for (int i = 0; i < joints; ++i) {
    const int before = grounded ? i - 1 : (i + bodies - 1) % bodies;
    add_joint(plan, kinds[static_cast<std::size_t>(i)], before < 0 ? kGround : before, i < bodies ? i : kGround,
              corners[static_cast<std::size_t>(i)], numbers.axes());
  }
  plan.joints.front().drive_rate = numbers.between(-2.0, 2.0);
  plan.joints.front().drive_sway = numbers.between(-0.2, 0.2);
}

// A chain of two or three bodies from a hinge on the ground to a wheel that rolls on a plane of the ground, or to a plane
// that rolls on a wheel at rest.
void close_by_rolling(Plan& plan, Numbers& numbers) {
  constexpr JointKind kKinds[] = {JointKind::kSpherical, JointKind::kUniversal, JointKind::kRevolute};
  const int bodies = numbers.whole(2, 3);
  std::vector<JointKind> kinds(static_cast<std::size_t>(bodies));
  int freedom = 0;
  do {
    freedom = 6 * bodies - 3;
    for (JointKind& kind : kinds) kind = kKinds[numbers.whole(0, 2)];
    for (const JointKind kind : kinds) freedom -= conditions(kind);
  } while (freedom < 1 || freedom > 5);
  Vector3d point = Vector3d::Zero();
  for (int i = 0; i < bodies; ++i) {
    const Vector3d next = point + Vector3d(0.5, 0.0, 0.1) + numbers.vector(0.2);
    add_body(plan, numbers, 0.5 * (point + next));
    add_joint(plan, kinds[static_cast<std::size_t>(i)], i - 1, i, point, numbers.axes());
    point = next;
  }
  const bool wheel_moves = numbers.one_in(2);
  const Eigen::Matrix3d axes = numbers.axes();
  add_joint(plan, numbers.one_in(2) ? JointKind::kDisc : JointKind::kSphere, wheel_moves ? kGround : bodies - 1,
            wheel_moves ? bodies - 1 : kGround, point, axes);
  PlannedJoint& rolling = plan.joints.back();
  const Vector3d n = rolling.axes.col(2);
  rolling.point_2 += numbers.between(0.2, 0.5) * n + 0.1 * rolling.axes.col(0);
  // The disc leans by at most some 50 degrees.
  rolling.axes_2 = axes_with_z(rolling.axes.col(1) + numbers.between(-0.8, 0.8) * n);
}

// Two or three coordinates of a loop, if it has so many.
void add_gears(Plan& plan, Numbers& numbers) {
  PlannedGear gear;
  gear.name = "gear";
  for (const PlannedJoint& joint : plan.joints) {
    if (gear.members.size() == 3) break;
    const double size = numbers.between(0.5, 2.0), factor = numbers.one_in(2) ? -size : size;
    if (joint.kind == JointKind::kRevolute || joint.kind == JointKind::kCylindrical)
      gear.members.push_back({joint.name, Coordinate::kAngle, factor});
    if (joint.kind == JointKind::kPrismatic || joint.kind == JointKind::kCylindrical)
      gear.members.push_back({joint.name, Coordinate::kDisplacement, 3.0 * factor});
  }
  if (gear.members.size() >= 2) plan.gears.push_back(gear);
}

// Hinges through the corners, about the axes; the last side is the ground.
void close_hinges(Plan& plan, Numbers& numbers, const std::vector<Vector3d>& corners,
                  const std::vector<Vector3d>& axes) {
  int last = kGround;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int next = i + 1 < corners.size()
                         ? add_body(plan, numbers, 0.5 * (corners[i] + corners[i + 1]) + numbers.vector(0.1))
                         : kGround;
    add_joint(plan, JointKind::kRevolute, last, next, corners[i], axes_with_z(axes[i]));
    last = next;
  }
}

void four_bar(Plan& plan, Numbers& numbers) {
  const Eigen::Matrix3d R = numbers.axes();
  std::vector<Vector3d> corners;
  for (const Vector3d& corner :
       {Vector3d(0.0, 0.0, 0.0), Vector3d(0.1, 0.8, 0.0), Vector3d(1.2, 1.0, 0.0), Vector3d(1.0, 0.0, 0.0)}) {
    const double y = numbers.between(-0.2, 0.2), x = numbers.between(-0.2, 0.2);
    corners.push_back(R * (corner + Vector3d(x, y, 0.0)));
  }
  close_hinges(plan, numbers, corners, std::vector<Vector3d>(4, R.col(2)));
}

// Posts and beams as in the N-four-bar, leaning, every post of the same length; or crank, rod and slider with five
// conditions at the slider.
void parallelogram_or_slider(Plan& plan, Numbers& numbers) {
  const Eigen::Matrix3d R = numbers.axes();
  const double lean = numbers.between(-0.7, 0.7), length = numbers.between(0.5, 1.0);
  const Vector3d post = R * Vector3d(length * std::sin(lean), length * std::cos(lean), 0.0), z = R.col(2);
  if (numbers.one_in(3)) {
    const Vector3d end = post + R * Vector3d(std::sqrt(1.5 * 1.5 - post.squaredNorm() * std::pow(std::cos(lean), 2)),
                                             -length * std::cos(lean), 0.0);
    const int crank = add_body(plan, numbers, 0.5 * post), rod = add_body(plan, numbers, 0.5 * (post + end)),
              slider = add_body(plan, numbers, end);
    const Eigen::Matrix3d axes = axes_with_z(z);
    add_joint(plan, JointKind::kRevolute, kGround, crank, Vector3d::Zero(), axes);
    add_joint(plan, JointKind::kRevolute, crank, rod, post, axes);
    add_joint(plan, JointKind::kRevolute, rod, slider, end, axes);
    add_joint(plan, JointKind::kPrismatic, kGround, slider, end, axes_with_z(R.col(0)));
    return;
  }
  const int cells = numbers.whole(1, 3);
  std::vector<int> posts;
  std::vector<Vector3d> feet;
  for (int i = 0; i <= cells; ++i) {
    feet.push_back(i == 0 ? Vector3d::Zero() : Vector3d(feet.back() + numbers.between(0.5, 1.0) * R.col(0)));
    posts.push_back(add_body(plan, numbers, feet.back() + 0.5 * post));
    add_joint(plan, JointKind::kRevolute, kGround, posts.back(), feet.back(), axes_with_z(z));
  }
  for (std::size_t i = 0; i + 1 < posts.size(); ++i) {
    const int beam = add_body(plan, numbers, 0.5 * (feet[i] + feet[i + 1]) + post);
    add_joint(plan, JointKind::kRevolute, posts[i], beam, feet[i] + post, axes_with_z(z));
    add_joint(plan, JointKind::kRevolute, beam, posts[i + 1], feet[i + 1] + post, axes_with_z(z));
  }
}

void bennett(Plan& plan, Numbers& numbers) {
  const double alpha = numbers.between(0.4, 0.9), beta = alpha + numbers.between(0.3, 0.6),
               angle = numbers.between(0.7, 2.4);
  const double a = 0.5, b = a * std::sin(beta) / std::sin(alpha);
  const double ratio = std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha));
  const double theta_2 = 2.0 * std::atan(ratio / std::tan(0.5 * angle));
  const double theta[4] = {angle, theta_2, 2.0 * M_PI - angle, 2.0 * M_PI - theta_2};
  const double length[4] = {a, b, a, b}, twist[4] = {alpha, beta, alpha, beta};
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.rotate(numbers.axes());
  std::vector<Vector3d> corners, axes;
  for (int i = 0; i < 4; ++i) {
    corners.push_back(frame.translation());
    axes.push_back(frame.linear().col(2));
    frame.rotate(Eigen::AngleAxisd(theta[i], Vector3d::UnitZ()));
    frame.translate(length[i] * Vector3d::UnitX());
    frame.rotate(Eigen::AngleAxisd(twist[i], Vector3d::UnitX()));
  }
  close_hinges(plan, numbers, corners, axes);
}

void bricard(Plan& plan, Numbers& numbers) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const double a = numbers.between(0.4, 0.8);
  close_hinges(plan, numbers, {0.0 * x, a * x, a * (x - y), a * (x - y + z), a * (z - y), a * z}, {y, z, x, y, z, x});
}

// Two pairs of plates across each other lift a top without turning it.
void sarrus(Plan& plan, Numbers& numbers) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const double h = numbers.between(0.5, 0.9), s = numbers.between(0.2, 0.5), t = numbers.between(0.2, 0.5);
  const Eigen::Matrix3d R = numbers.axes();
  const std::vector<Vector3d> corners = {-0.4 * y,         -(0.4 + s) * y + 0.5 * h * z, -0.4 * y + h * z,
                                         -0.4 * x + h * z, -(0.4 + t) * x + 0.5 * h * z, -0.4 * x};
  std::vector<Vector3d> turned, axes;
  for (const Vector3d& corner : corners) turned.push_back(R * corner);
  for (int i = 0; i < 6; ++i) axes.push_back(R * (i < 3 ? x : y));
  close_hinges(plan, numbers, turned, axes);
}

// The smallest singular value of Phi_v that is not zero for good: number `rank` of them.
double hold(const Model& model, const Layout& layout, int rank, State state) {
  ConstraintRows rows(model, layout);
  Eigen::MatrixXd Phi_v(layout.row_count, layout.v_size);
  state.v.setZero();
  rows.evaluate(state);
  const Eigen::VectorXd at_rest = rows.rate;
  for (int k = 0; k < layout.v_size; ++k) {
    state.v = Eigen::VectorXd::Unit(layout.v_size, k);
    rows.evaluate(state);
    Phi_v.col(k) = rows.rate - at_rest;
  }
  return singular_values(Phi_v).s[rank - 1];
}

// How long the mechanism stays away from positions in which Phi_v loses rank: until the smallest singular value is a
// third of what it was.
double time_until_singular(const Plan& plan) {
  constexpr int kLooks = 25;
  const Model model = build(plan);
  const Layout layout(model);
  if (layout.row_count == 0) return plan.duration;
  IntegratorOptions options = as_a_scene(1e-4);
  options.order = 2;
  Run run(model, "one_step", options);
  const double start = hold(model, layout, run.assembly.rank, run.state);
  for (int i = 1; i <= kLooks; ++i) {
    try {
      run.to(plan.duration * i / kLooks);
    } catch (const NumericalError&) {  // what is driven may jam
      return plan.duration * (i - 1) / kLooks;
    }
    if (hold(model, layout, run.assembly.rank, run.state) < start / 3.0) return plan.duration * (i - 1) / kLooks;
  }
  return plan.duration;
}

}  // namespace

const char* name_of(Family family) {
  switch (family) {
    case Family::kTree: return "Tree";
    case Family::kFreeTree: return "FreeTree";
    case Family::kLoop: return "Loop";
    case Family::kFreeLoop: return "FreeLoop";
    case Family::kFourBar: return "FourBar";
    case Family::kParallelogram: return "Parallelogram";
    case Family::kOverclosed: return "Overclosed";
    case Family::kDrivenLoop: return "DrivenLoop";
    case Family::kMotorLoop: return "MotorLoop";
    case Family::kLimitLoop: return "LimitLoop";
    case Family::kGearLoop: return "GearLoop";
    case Family::kRollingLoop: return "RollingLoop";
  }
  return "";
}

Plan random_mechanism(Family family, unsigned seed) {
  Numbers numbers(1000u * static_cast<unsigned>(family) + seed);
  Plan plan;
  plan.what = std::string(name_of(family)) + ", seed " + std::to_string(seed);
  plan.gravity = Vector3d(0.0, 0.0, -9.81);
  bool free = false;
  switch (family) {
    case Family::kTree: grow_tree(plan, numbers, true); break;
    case Family::kFreeTree: grow_tree(plan, numbers, !(free = true)); break;
    case Family::kLoop: close_loop(plan, numbers, true, false); break;
    case Family::kFreeLoop: close_loop(plan, numbers, !(free = true), false); break;
    case Family::kFourBar: four_bar(plan, numbers); break;
    case Family::kParallelogram: parallelogram_or_slider(plan, numbers); break;
    case Family::kOverclosed: {
      const int kind = numbers.whole(0, 2);
      kind == 0 ? bennett(plan, numbers) : kind == 1 ? bricard(plan, numbers) : sarrus(plan, numbers);
      break;
    }
    case Family::kDrivenLoop: close_loop(plan, numbers, true, true); break;
    case Family::kMotorLoop:
      close_loop(plan, numbers, true, false);
      add_random_drives(plan, numbers);
      break;
    case Family::kLimitLoop:
      close_loop(plan, numbers, true, false);
      add_random_limits(plan, numbers);
      break;
    case Family::kGearLoop:
      close_loop(plan, numbers, true, false, 2);
      add_gears(plan, numbers);
      break;
    case Family::kRollingLoop: close_by_rolling(plan, numbers); break;
  }
  add_random_forces(plan, numbers, free);
  plan = settled(plan);
  plan.regular_until = time_until_singular(plan);
  return plan;
}

}  // namespace footfall::test

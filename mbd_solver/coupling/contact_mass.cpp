// Effective mass of a load: for a body without joints from its inertia in closed form, otherwise by one solve with the
// factors of the mechanism's equations (SaddleSystem::respond).

#include "mbd_solver/coupling/contact_mass.h"

#include <algorithm>
#include <limits>

namespace footfall {
namespace {

// Constraint rows are solved to 1e-12: an effective mass this many times the body's own counts as infinite.
constexpr double kHeld = 1e8;

double largest_mode(const ModalBoundary& boundary) {
  double largest = 0.0;
  if (boundary.mode_count() == 0) return largest;
  for (int j = 0; j < boundary.node_count(); ++j)
    largest = std::max(largest, boundary.Phi().middleRows<3>(3 * j).norm());
  return largest;
}

bool is_joined(const Model& model, int body) {
  for (int i = 0; i < model.joint_count(); ++i)
    if (model.joint(i).m1.body == body || model.joint(i).m2.body == body) return true;
  return false;
}

// x / f, no longer than `longest`.
template <class Vector>
Vector cut_off(const Vector& x, double f, double longest) {
  const double length = x.norm();
  return length > longest * f ? Vector(longest / length * x) : Vector(x / f);
}

}  // namespace

ContactMass::ContactMass(Equations& equations, int body, const ModalBoundary& boundary)
    : equations_(equations),
      body_(body),
      joined_(is_joined(equations.model(), body)),
      mass_(equations.model().body(body).mass()),
      reach_(boundary.rho0().colwise().norm().maxCoeff()),
      largest_mode_(largest_mode(boundary)),
      q_(equations.layout().v_size),
      moved_(q_) {}

double ContactMass::along(const ExternalLoad& load, const State& state, double H) {
  const double f = load.F_W.norm();
  if (f == 0.0) return mass_;
  const Body& body = equations_.model().body(body_);
  const double own = body.mass();
  const Eigen::Vector3d F = load.F_W / f, T = cut_off(load.T_B, f, reach_);
  Eigen::VectorXd Q;
  if (load.Q_a.size() > 0) {
    Q = cut_off(load.Q_a, f, largest_mode_);
    for (Eigen::Index i = 0; i < Q.size(); ++i) {
      const double theta2 = body.modal()->stiffness[i] * H * H;
      Q[i] /= 1.0 + theta2 * theta2;
    }
  }
  if (!joined_) {  // modes have mass 1
    mass_ = 1.0 / (1.0 / own + T.dot(body.rigid_inertia().ldlt().solve(T)) + Q.squaredNorm());
    return mass_;
  }
  equations_.load(state);
  const int first = equations_.layout().body_v[body_];
  q_.setZero();
  q_.segment<3>(first) = F;
  q_.segment<3>(first + 3) = equations_.motion(body_).A * T;
  q_.segment(first + 6, Q.size()) = Q;
  moved_ = q_;
  equations_.saddle().respond(state, moved_);
  const double inverse_mass = q_.dot(moved_);  // [1/kg]
  mass_ = inverse_mass * own * kHeld > 1.0 ? 1.0 / inverse_mass : std::numeric_limits<double>::infinity();
  return mass_;
}

}  // namespace footfall

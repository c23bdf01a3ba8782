#include "mbd_solver/coupling/contact_mass.h"

#include <algorithm>
#include <limits>

namespace footfall {
namespace {

// Rows of joints are solved to 1e-12: a body that is this much heavier than it is does not move.
constexpr double kHeld = 1e8;

double largest_mode(const ModalBoundary& boundary) {
  double largest = 0.0;
  if (boundary.mode_count() == 0) return largest;
  for (int j = 0; j < boundary.node_count(); ++j)
    largest = std::max(largest, boundary.Phi().middleRows<3>(3 * j).norm());
  return largest;
}

bool joined(const Model& model, int body) {
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
      joined_(joined(equations.model(), body)),
      mass_(equations.model().body(body).mass()),
      reach_(boundary.rho0().colwise().norm().maxCoeff()),
      largest_mode_(largest_mode(boundary)),
      rates_(equations.layout().size()),
      moved_(rates_) {}

double ContactMass::along(const ExternalLoad& felt, const State& state, const Inputs& inputs, double H) {
  const double f = felt.F_W.norm();
  if (f == 0.0) return mass_;
  const Body& body = equations_.model().body(body_);
  const double own = body.mass();
  const Eigen::Vector3d F = felt.F_W / f, T = cut_off(felt.T_B, f, reach_);
  Eigen::VectorXd Q;
  if (felt.Q_a.size() > 0) {
    Q = cut_off(felt.Q_a, f, largest_mode_);
    for (Eigen::Index i = 0; i < Q.size(); ++i) {
      const double theta2 = body.modal()->stiffness[i] * H * H;
      Q[i] /= 1.0 + theta2 * theta2;
    }
  }
  if (!joined_) {  // modes have mass 1
    mass_ = 1.0 / (1.0 / own + T.dot(body.rigid_inertia().ldlt().solve(T)) + Q.squaredNorm());
    return mass_;
  }
  // As large as what gives the body alone 1 m/s2: far above the round-off of accelerations.
  const Eigen::Vector3d F_W = own * F, T_B = own * T;
  probe_ = inputs;
  ExternalLoad& load = probe_.loads[static_cast<std::size_t>(body_)];
  load.F_W += F_W;
  load.T_B += T_B;
  const Eigen::VectorXd Q_a = own * Q;
  if (Q_a.size() > 0) load.Q_a += Q_a;
  equations_.accelerations(state, inputs, rates_);
  equations_.accelerations(state, probe_, moved_);
  const int first = equations_.layout().v0() + equations_.layout().body_v[static_cast<std::size_t>(body_)];
  const auto dv = [&](int from, auto size) {
    return moved_.segment(first + from, size) - rates_.segment(first + from, size);
  };
  equations_.load(state);
  double power = F_W.dot(dv(0, 3)) + (equations_.motion(body_).A * T_B).dot(dv(3, 3));
  if (Q_a.size() > 0) power += Q_a.dot(dv(6, Q_a.size()));
  mass_ = power * kHeld > own ? own * own / power : std::numeric_limits<double>::infinity();
  return mass_;
}

}  // namespace footfall

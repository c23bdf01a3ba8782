// A body is known if no load on it moves it (SaddleSystem::respond). Its poses follow from those before by the projection on
// the joints at each time.

#include "mbd_solver/coupling/known_motion.h"

#include <algorithm>
#include <cmath>

#include "coupler/body_motion.h"

namespace footfall {
namespace {

constexpr double kUnmoved = 1e-8;   // of the acceleration of the body alone: none
constexpr double kStraight = 1e-9;  // deviation from the straight path, of the way [-] and of the attitude [rad]: none

// Some prescribed motion, and positions follow from the joints (not so behind a rolling wheel).
bool may_be_known(const Model& model) {
  bool driven = false;
  for (int i = 0; i < model.joint_count(); ++i)
    for (const ConstraintRow& row : model.joint(i).rows) {
      if (!row.holds_positions()) return false;
      driven = driven || row.motion != nullptr;
    }
  return driven;
}

}  // namespace

KnownMotion::KnownMotion(const Model& model, const Assembly& assembly, const State& start, std::vector<int> bodies)
    : model_(model), bodies_(std::move(bodies)), known_(bodies_.size(), false) {
  if (may_be_known(model)) find_bodies(assembly, start);
}

void KnownMotion::find_bodies(const Assembly& assembly, const State& start) {
  equations_ = std::make_unique<Equations>(model_, assembly);
  Eigen::VectorXd response(equations_->layout().v_size);
  bool any = false;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Body& body = model_.body(bodies_[k]);
    const int first = equations_->layout().body_v[bodies_[k]];
    const double turns = body.rigid_inertia().diagonal().minCoeff();  // [kg m2]
    bool held = true;
    for (int i = 0; i < 6 && held; ++i) {
      response.setZero();
      response[first + i] = 1.0;
      equations_->saddle().respond(start, response);
      held = response[first + i] * (i < 3 ? body.mass() : turns) < kUnmoved;
    }
    known_[k] = held;
    any = any || held;
  }
  if (!any) equations_.reset();
}

// The joints at `time`, from a state shortly before it.
State KnownMotion::at(const State& before, double time) {
  const Layout& layout = equations_->layout();
  State state = before;
  const double tau = time - before.time;
  state.time = time;
  for (int i = 0; i < model_.body_count(); ++i) {
    const std::size_t body = i;
    const int q = layout.body_q[body], v = layout.body_v[body];
    state.q.segment<3>(q) += tau * before.v.segment<3>(v);
    state.q.segment<4>(q + 3) = turned(before.q.segment<4>(q + 3), tau * before.v.segment<3>(v + 3));
  }
  equations_->saddle().project(state, SaddleSystem::Close::kFully);
  return state;
}

// The known bodies move straight on, at constant rates, as far as three instants of the window show.
bool KnownMotion::goes_straight(const State& state, int n, double dt) {
  const Layout& layout = equations_->layout();
  for (const double share : {0.37, 0.71, 1.0}) {
    const double tau = std::ceil(share * n) * dt;
    const State later = at(state, state.time + tau);
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (!known_[k]) continue;
      const std::size_t body = bodies_[k];
      const int q = layout.body_q[body], v = layout.body_v[body];
      const Eigen::Vector3d way = tau * state.v.segment<3>(v), turn = tau * state.v.segment<3>(v + 3);
      const Eigen::Vector3d off = later.q.segment<3>(q) - state.q.segment<3>(q) - way;
      const Eigen::Vector4d L = turned(state.q.segment<4>(q + 3), turn);
      const double size = std::max(state.q.segment<3>(q).norm(), way.norm());
      if (off.norm() > kStraight * size || rotation_vector(L, later.q.segment<4>(q + 3)).norm() > kStraight)
        return false;
    }
  }
  return true;
}

const std::vector<KnownPath>& KnownMotion::paths(const State& state, int n, double dt) {
  if (!equations_) return none_;
  const Layout& layout = equations_->layout();
  equations_->saddle().forget();  // the result depends on the state alone
  if (goes_straight(state, n, dt)) return none_;
  paths_.assign(bodies_.size(), KnownPath());
  State now = state;
  for (int i = 0; i < n; ++i) {
    now = at(now, state.time + (i + 1) * dt);
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (!known_[k]) continue;
      const std::size_t body = bodies_[k];
      paths_[k].conservativeResize(13, n);
      paths_[k].col(i) << now.q.segment<7>(layout.body_q[body]), now.v.segment<6>(layout.body_v[body]);
    }
  }
  return paths_;
}

}  // namespace footfall

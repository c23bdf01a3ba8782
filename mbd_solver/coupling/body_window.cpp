#include "mbd_solver/coupling/body_window.h"

#include <utility>

#include "coupler/message_fields.h"
#include "mbd_solver/coupling/fast_modes.h"

namespace footfall {

BodyWindow::BodyWindow(const Scheme& scheme, const Body& body, const BodyMotion& initial, const BodyLoad& last)
    : scheme_(scheme),
      body_(body),
      predicted_(scheme, initial),
      start_(initial),
      load_(last),
      before_(initial.mode_count()) {
  if (load_.mean.Q_a.size() != initial.mode_count()) load_.mean = MeanLoad(initial.mode_count());
}

// The next window begins with a state, a path and a reaction of its own.
void BodyWindow::visit(Archive& archive) {
  archive("predicted", predicted_);
  archive("load", load_);
  archive("n", n_);
}

Matrix6d BodyWindow::rigid_inertia() const {
  Matrix6d M = Matrix6d::Zero();
  M.diagonal().head<3>().setConstant(body_.mass());
  const Eigen::Matrix3d A = start_.rotation();
  M.bottomRightCorner<3, 3>() = A * body_.rigid_inertia() * A.transpose();
  return M;
}

void BodyWindow::begin(int n, double dt, BodyMotion& motion) {
  start_ = motion;
  n_before_ = n_;
  n_ = n;
  length_ = n * dt;
  scheme_.set_path_rates(rigid_inertia(), load_, length_, motion);
  if (body_.mode_count() > 0) slow_down_fast_modes(start_, body_.modal()->stiffness, length_, motion);
  predicted_.begin(motion, n, dt);
}

void BodyWindow::answer(const BodyLoad& load, ExternalLoad& felt) {
  std::swap(before_, load_.mean);
  load_ = load;
  reaction_ = scheme_.reaction(rigid_inertia(), load_, predicted_.path(), length_);
  felt.F_W = load_.mean.F_W;
  felt.T_B = load_.mean.T_B;
  if (load_.mean.Q_a.size() > 0) felt.Q_a = load_.mean.Q_a;
  felt.tangent = reaction_;
}

double BodyWindow::pending_work(const BodyMotion& computed) const {
  const double ratio = n_before_ > 0 ? static_cast<double>(n_) / n_before_ : 0.0;
  return scheme_.pending_work({load_, before_, ratio}, predicted_.path(), computed);
}

std::optional<Eigen::Vector3d> BodyWindow::surplus_impulse(const BodyMotion& computed) const {
  if (!reaction_) return std::nullopt;
  return footfall::surplus_impulse(*reaction_, start_, computed, length_);
}

}  // namespace footfall

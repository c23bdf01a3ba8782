#include "liggghts_fix/dem_body.h"

#include <algorithm>

namespace footfall {

DemBody::DemBody(const CoupledBody& scene_body, const Scheme& scheme)
    : boundary_(scene_body.boundary),
      path_(scheme, scene_body.initial),
      average_(scheme, scene_body.boundary.mode_count()),
      now_(scene_body.boundary.mode_count()),
      wants_slopes_(scheme.wants_tangent()) {
  load_.mean = MeanLoad(boundary_.mode_count());
  if (wants_slopes_) load_.tangent.resize(1);
}

void DemBody::begin_window(const BodyMotion& start, int n, double dt) {
  path_.begin_window(start, n, dt);
  average_.begin_window(path_.jump(), path_.pose());
  stiffness_time_ = 0.0;
  time_ = 0.0;
  overlap_ = 0.0;
  slopes_time_ = {};
}

void DemBody::clear_contacts() {
  now_.set_zero();
  if (wants_slopes_) slopes_now_ = {};
  stiffness_now_ = 0.0;
  contacts_now_ = 0;
}

void DemBody::add_contact(const BoundaryPoint& point, const Eigen::Vector3d& f_W, const Eigen::Vector3d& m_W,
                          double overlap_over_radius, double stiffness) {
  boundary_.add_point_force(path_.pose(), point, f_W, now_);
  boundary_.add_point_moment(path_.pose(), point, m_W, now_);
  count_contact(overlap_over_radius, stiffness);
}

void DemBody::add_load(const GeneralizedForce& Q) {
  now_.F_W += Q.F_W;
  now_.T_W += Q.T_W;
  now_.Q_a += Q.Q_a;
}

void DemBody::count_contact(double overlap_over_radius, double stiffness) {
  overlap_ = std::max(overlap_, overlap_over_radius);
  stiffness_now_ += stiffness;
  ++contacts_now_;
}

// The point moves by J [dr; dtheta], J = [1, -rho~]; its force -k J dx acts on the body by J^T.
void DemBody::add_slope(const Eigen::Vector3d& point_W, const ContactSlope& slope) {
  const Eigen::Vector3d& n = slope.normal_W;
  const Eigen::Vector3d rho = point_W - path_.pose().r;
  Eigen::Matrix3d rho_skew;
  rho_skew << 0.0, -rho.z(), rho.y(), rho.z(), 0.0, -rho.x(), -rho.y(), rho.x(), 0.0;
  const Eigen::Matrix3d along = n * n.transpose(), across = Eigen::Matrix3d::Identity() - along;
  const auto add = [&](double k_n, double k_t, Eigen::Matrix<double, 6, 6>& sum) {
    const Eigen::Matrix3d k = k_n * along + k_t * across;
    const Eigen::Matrix3d turning = rho_skew * k;
    sum.topLeftCorner<3, 3>() += k;
    sum.bottomLeftCorner<3, 3>() += turning;
    sum.topRightCorner<3, 3>() += turning.transpose();
    sum.bottomRightCorner<3, 3>() -= turning * rho_skew;
  };
  add(slope.stiffness, slope.shear_stiffness, slopes_now_.K);
  add(slope.damping, slope.shear_damping, slopes_now_.C);
}

void DemBody::take_standing() {
  average_.set_standing(now_, path_.pose());
}

void DemBody::end_substep(double dt) {
  average_.add_step(now_, path_.pose(), path_.last_step(), dt);
  stiffness_time_ += stiffness_now_ * dt;
  if (wants_slopes_) {
    slopes_time_.K += dt * slopes_now_.K;
    slopes_time_.C += dt * slopes_now_.C;
  }
  time_ += dt;
}

void DemBody::write_sums(double* out) {
  const MeanLoad& mean = average_.finish();
  const auto put = [&out](const auto& vector) {
    for (Eigen::Index i = 0; i < vector.size(); ++i) *out++ = vector[i];
  };
  put(mean.F_W);
  put(mean.T_B);
  put(mean.Q_a);
  put(mean.impulse_W);
  *out++ = mean.work;
  *out++ = mean.jump_work;
  *out++ = static_cast<double>(contacts_now_);
  *out++ = stiffness_time_ / time_;
  if (wants_slopes_) {
    put((slopes_time_.K / time_).reshaped().eval());
    put((slopes_time_.C / time_).reshaped().eval());
  }
  *out = overlap_;
}

void DemBody::fold_sums(const double* rows, int ranks, std::size_t stride) {
  load_.mean.set_zero();
  double contacts = 0.0;
  load_.contact_stiffness = 0.0;
  load_.max_overlap_over_radius = 0.0;
  if (wants_slopes_) load_.tangent.front() = {};
  for (int rank = 0; rank < ranks; ++rank) {
    const double* in = rows + static_cast<std::size_t>(rank) * stride;
    const auto add = [&in](auto& vector) {
      for (Eigen::Index i = 0; i < vector.size(); ++i) vector[i] += *in++;
    };
    add(load_.mean.F_W);
    add(load_.mean.T_B);
    add(load_.mean.Q_a);
    add(load_.mean.impulse_W);
    load_.mean.work += *in++;
    load_.mean.jump_work += *in++;
    contacts += *in++;
    load_.contact_stiffness += *in++;
    if (wants_slopes_) {
      for (double& k : load_.tangent.front().K.reshaped()) k += *in++;
      for (double& c : load_.tangent.front().C.reshaped()) c += *in++;
    }
    load_.max_overlap_over_radius = std::max(load_.max_overlap_over_radius, *in);
  }
  load_.contacts = static_cast<std::int64_t>(contacts);
}

double DemBody::work_between(const BodyMotion& from, const BodyMotion& to) const {
  // T_B turns with the body: its work is T_B . theta_B, and theta has the same components in B at both ends.
  const Eigen::Vector3d theta_B = from.rotation().transpose() * rotation_vector(from.L, to.L);
  return load_.mean.F_W.dot(to.r - from.r) + load_.mean.T_B.dot(theta_B) + load_.mean.Q_a.dot(to.a - from.a);
}

}  // namespace footfall

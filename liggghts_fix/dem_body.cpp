#include "liggghts_fix/dem_body.h"

#include <algorithm>
#include <tuple>

namespace footfall {
namespace {

// Slopes change slowly beside forces, and multiply only what the prediction missed: a mean of so many substeps is as
// good as one of all.
constexpr int kSlopeSamples = 8;

}  // namespace

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
  substep_ = 0;
  slope_stride_ = (n + kSlopeSamples - 1) / kSlopeSamples;
  slope_samples_ = 0;
  slopes_sum_ = {};
}

void DemBody::clear_contacts() {
  now_.set_zero();
  samples_slopes_ = wants_slopes_ && substep_ % slope_stride_ == slope_stride_ / 2;
  if (samples_slopes_) slopes_now_ = {};
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

// The point moves by J [dr; dtheta], J = [1, -rho~]; its force -k J dx acts on the body by J^T. With k = k_t 1 + (k_n -
// k_t) n n^T J^T k J = (k_n - k_t) u u^T + k_t J^T J, u = J^T n = [n; rho x n]: a rank-one update, and nothing more
// while the contact slides.
void DemBody::add_slope(const Eigen::Vector3d& point_W, const ContactSlope& slope) {
  const Eigen::Vector3d rho = point_W - path_.pose().r;
  Eigen::Matrix<double, 6, 1> u;
  u << slope.normal_W, rho.cross(slope.normal_W);
  const auto add = [&](double k_n, double k_t, Eigen::Matrix<double, 6, 6>& sum) {
    if (k_n == 0.0) return;  // elastic: no damping
    const Eigen::Matrix<double, 6, 1> scaled = (k_n - k_t) * u;
    for (int column = 0; column < 6; ++column) sum.col(column) += u[column] * scaled;
    if (k_t == 0.0) return;
    const Eigen::Vector3d t = k_t * rho;
    sum.diagonal().head<3>().array() += k_t;
    sum.bottomRightCorner<3, 3>() -= t * rho.transpose();
    sum.diagonal().tail<3>().array() += t.dot(rho);
    for (const auto& [row, column, value] :
         {std::tuple(4, 2, -t.x()), std::tuple(5, 1, t.x()), std::tuple(3, 2, t.y()), std::tuple(5, 0, -t.y()),
          std::tuple(3, 1, -t.z()), std::tuple(4, 0, t.z())}) {
      sum(row, column) += value;
      sum(column, row) += value;
    }
  };
  add(slope.stiffness, slope.shear_stiffness, slopes_now_.K);
  add(slope.damping, slope.shear_damping, slopes_now_.C);
}

void DemBody::take_standing() { average_.set_standing(now_, path_.pose()); }

void DemBody::end_substep(double dt) {
  average_.add_step(now_, path_.pose(), path_.last_step(), dt);
  stiffness_time_ += stiffness_now_ * dt;
  if (samples_slopes_) {
    slopes_sum_.K += slopes_now_.K;
    slopes_sum_.C += slopes_now_.C;
    ++slope_samples_;
  }
  ++substep_;
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
    const double share = 1.0 / std::max(1, slope_samples_);
    put((share * slopes_sum_.K).reshaped().eval());
    put((share * slopes_sum_.C).reshaped().eval());
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

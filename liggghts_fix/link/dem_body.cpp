// Projects contacts on the body, averages over the window, and samples contact slopes at a few DEM steps.

#include "liggghts_fix/link/dem_body.h"

#include <algorithm>
#include <cmath>

#include "coupler/message_fields.h"

namespace footfall {
namespace {

// Slopes change slowly compared with forces, and multiply only the error of the prediction: a mean over so many DEM steps
// is as good as one over all.
constexpr int kSlopeSamples = 8;

}  // namespace

DemBody::DemBody(const CoupledBody& scene_body, const Scheme& scheme, double gravity)
    : boundary_(scene_body.boundary),
      path_(scheme, scene_body.initial),
      average_(scheme, scene_body.boundary.mode_count()),
      now_(scene_body.boundary.mode_count()),
      slopes_(scheme.requires_tangent()),
      gravity_(gravity) {
  share_.mean = MeanLoad(boundary_.mode_count());
  if (scheme.requires_tangent()) share_.tangent.resize(1);
  load_ = share_;
}

const Eigen::Vector3d* BedSides::direction_of(const std::string& wall) const {
  for (const Passed& side : passed_)
    if (side.wall == wall) return &side.to_side;
  return nullptr;
}

void BedSides::Passed::visit(Archive& archive) {
  archive("wall", wall);
  archive("to_side", to_side);
}

void BedSides::visit(Archive& archive) {
  archive("passed_sides", passed_);
  archive("off_bed", off_bed_);
}

void SlopeMean::begin_window(int n) {
  stride_ = (n + kSlopeSamples - 1) / kSlopeSamples;
  count_ = 0;
  sum_ = {};
}

void SlopeMean::begin_substep(int substep) {
  samples_ = required_ && substep % stride_ == stride_ / 2;
  if (samples_) now_ = {};
}

void SlopeMean::end_substep() {
  if (!samples_) return;
  sum_.K += now_.K;
  sum_.C += now_.C;
  ++count_;
}

void SlopeMean::write(ContactTangent& mean) const {
  const double per_sample = 1.0 / std::max(1, count_);
  mean.K = per_sample * sum_.K;
  mean.C = per_sample * sum_.C;
}

void DemBody::visit(Archive& archive) {
  archive("path", path_);
  archive("load", load_);
  sides_.visit(archive);
}

void DemBody::begin_window(const BodyMotion& start, int n, double dt, double inverse_mass, int closing,
                           const KnownPath& known) {
  inverse_mass_ = inverse_mass;
  path_.begin_window(start, n, dt, closing, known);
  average_.begin_window(path_.jump(), path_.pose());
  stiffness_time_ = 0.0;
  time_ = 0.0;
  share_.max_overlap_over_radius = share_.max_patch_over_facet = 0.0;
  share_.grain_energy = share_.grain_mass = share_.grain_omega2 = 0.0;
  contact_time_ = 0.0;
  substep_ = 0;
  step_forces_.setZero(3, n);
  slopes_.begin_window(n);
}

void DemBody::clear_contacts() {
  now_.set_zero();
  slopes_.begin_substep(substep_);
  stiffness_now_ = 0.0;
  contacts_now_ = 0;
}

void DemBody::add_contact(const BoundaryPoint& point, const Eigen::Vector3d& f_W, const Eigen::Vector3d& m_W,
                          double overlap_over_radius, double stiffness, const TouchingGrain& grain) {
  boundary_.add_point_force(path_.pose(), point, f_W, now_);
  boundary_.add_point_moment(path_.pose(), point, m_W, now_);
  count_contact(overlap_over_radius, stiffness, point, grain);
}

void DemBody::count_patch(double over_facet) {
  share_.max_patch_over_facet = std::max(share_.max_patch_over_facet, over_facet);
}

void DemBody::add_load(const GeneralizedForce& Q) {
  now_.F_W += Q.F_W;
  now_.T_W += Q.T_W;
  now_.Q_a += Q.Q_a;
}

void DemBody::count_contact(double overlap_over_radius, double stiffness, const BoundaryPoint& point,
                            const TouchingGrain& grain) {
  share_.max_overlap_over_radius = std::max(share_.max_overlap_over_radius, overlap_over_radius);
  stiffness_now_ += stiffness;
  ++contacts_now_;
  if (grain.mass <= 0.0) return;
  const double overlap = overlap_over_radius * grain.radius;
  const double v2 = (grain.v_W - boundary_.velocity(path_.pose(), point)).squaredNorm();
  const double energy = grain.mass * (0.5 * v2 + gravity_ * grain.radius) + 0.5 * stiffness * overlap * overlap;
  share_.grain_energy = std::max(share_.grain_energy, energy);
  share_.grain_mass = std::max(share_.grain_mass, grain.mass);
  share_.grain_omega2 = std::max(share_.grain_omega2, stiffness / grain.mass);
}

void DemBody::add_slope(const BoundaryPoint& point, const Eigen::Vector3d& arm_W, const ContactSlope& slope) {
  add_slope(boundary_.position(path_.pose(), point) + arm_W, slope);
}

void DemBody::add_slope(const Eigen::Vector3d& point_W, const ContactSlope& slope) {
  slopes_.add(slope, point_W - path_.pose().r);
}

void DemBody::use_as_opening_force() { average_.set_opening_force(now_, path_.pose()); }

void DemBody::end_substep(double dt) {
  step_forces_.col(substep_) = average_.add_step(now_, path_.pose(), path_.last_step(), dt);
  stiffness_time_ += stiffness_now_ * dt;
  contact_time_ += static_cast<double>(contacts_now_) * dt;
  slopes_.end_substep();
  ++substep_;
  time_ += dt;
}

void DemBody::append_share(std::vector<double>& row) {
  share_.mean = average_.finish();
  share_.contacts = contacts_now_;
  share_.mean_contacts = contact_time_ / time_;
  share_.contact_stiffness = stiffness_time_ / time_;
  for (ContactTangent& tangent : share_.tangent) slopes_.write(tangent);
  footfall::append_share(share_, row);
  row.insert(row.end(), step_forces_.data(), step_forces_.data() + step_forces_.size());
}

void DemBody::clear_load() {
  clear(load_);
  all_step_forces_.setZero(3, step_forces_.cols());
}

const double* DemBody::add_share(const double* row) {
  row = footfall::add_share(row, load_);
  all_step_forces_ += Eigen::Map<const Eigen::Matrix3Xd>(row, 3, all_step_forces_.cols());
  return row + all_step_forces_.size();
}

void DemBody::finish_load() {
  Eigen::Index peak = 0;
  const double most = std::sqrt(all_step_forces_.colwise().squaredNorm().maxCoeff(&peak));
  load_.peak = {};
  if (!(most > 0.0)) return;
  const auto is_large = [&](Eigen::Index i) { return all_step_forces_.col(i).norm() >= kOfPeak * most; };
  Eigen::Index first = peak, end = peak + 1;
  while (first > 0 && is_large(first - 1)) --first;
  while (end < all_step_forces_.cols() && is_large(end)) ++end;
  load_.peak = {most, peak + 1, end - first};
}

double DemBody::work_between(const BodyMotion& from, const BodyMotion& to) const {
  // On a known path the body received the work that the grains gave.
  if (path_.is_known() && from.mode_count() == 0) return load_.mean.work;
  // T_B turns with the body: its work is T_B . theta_B, where theta has the same components in B at both ends.
  const Eigen::Vector3d theta_B = from.rotation().transpose() * rotation_vector(from.L, to.L);
  return load_.mean.F_W.dot(to.r - from.r) + load_.mean.T_B.dot(theta_B) + load_.mean.Q_a.dot(to.a - from.a);
}

}  // namespace footfall

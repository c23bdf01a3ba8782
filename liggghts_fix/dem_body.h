#pragma once
// One coupled body on the grains' side: where its boundary is, and what the grains of this rank do to it. No
// LIGGGHTS headers.

#include <cstdint>

#include "coupler/load_average.h"
#include "coupler/messages.h"
#include "coupler/modal_boundary.h"
#include "coupler/window.h"

namespace footfall {

// What a contact does to a small motion of the body at its point: stiffness [N/m] and damping [N s/m] along
// the normal and across it (across: 0 while it slides).
struct ContactSlope {
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();
  double stiffness = 0.0, shear_stiffness = 0.0;
  double damping = 0.0, shear_damping = 0.0;
};

// Life of a window: begin_window, then per substep advance, clear_contacts, add_contact for every contact of
// this rank, end_substep. Sums are of this rank alone until fold_sums has added those of all ranks.
class DemBody {
 public:
  // Both must outlive the body.
  DemBody(const CoupledBody& scene_body, const Scheme& scheme);

  const ModalBoundary& boundary() const { return boundary_; }
  const BoundaryPath& path() const { return path_; }
  const BodyMotion& pose() const { return path_.pose(); }

  void begin_window(const BodyMotion& start, int n, double dt);
  void advance() { path_.advance(); }

  void clear_contacts();
  // A contact: force f_W [N] ON the body at the boundary point and moment m_W [N m] about that point
  // (contacts beside the axis of a beam, or in the middle of the overlap; rolling friction), overlap over
  // grain radius [-], normal stiffness [N/m] (0: unknown).
  void add_contact(const BoundaryPoint& point, const Eigen::Vector3d& f_W, const Eigen::Vector3d& m_W,
                   double overlap_over_radius, double stiffness);
  // The same in two parts, for who projects many contacts at once (beams): their generalized force ON the
  // body, and each contact's figures.
  void add_load(const GeneralizedForce& Q);
  void count_contact(double overlap_over_radius, double stiffness);
  // Does the scheme use contact slopes, and is this one of the substeps at which they are sampled? Then add_slope
  // follows for every contact, at its point in W [m].
  bool wants_slopes() const { return samples_slopes_; }
  void add_slope(const Eigen::Vector3d& point_W, const ContactSlope& slope);
  // The forces just evaluated stand before the next substep (a run was set up).
  void take_standing();
  void end_substep(double dt);

  // What the ranks add up at the end of a window, as a plain row of numbers; the last is a maximum, the
  // others are sums.
  int sum_count() const { return 14 + boundary_.mode_count() + (wants_slopes_ ? 72 : 0); }
  void write_sums(double* out);
  // rows: the rows of all ranks, `stride` numbers apart.
  void fold_sums(const double* rows, int ranks, std::size_t stride);

  // Valid after fold_sums.
  const BodyLoad& load() const { return load_; }
  // Mean moment about Bo in W at the end of the window [N m].
  Eigen::Vector3d mean_moment_W() const { return pose().rotation() * load_.mean.T_B; }
  // Work that the mean load of the last window does between two computed states [J].
  double work_between(const BodyMotion& from, const BodyMotion& to) const;

 private:
  const ModalBoundary& boundary_;
  BoundaryPath path_;
  LoadAverage average_;
  GeneralizedForce now_;        // of the contacts since clear_contacts
  double stiffness_now_ = 0.0;  // [N/m]
  std::int64_t contacts_now_ = 0;
  double stiffness_time_ = 0.0;  // integral over the window [N s/m]
  double time_ = 0.0;            // of the window [s]
  bool wants_slopes_;
  bool samples_slopes_ = false;
  int substep_ = 0, slope_stride_ = 1, slope_samples_ = 0;  // in the window
  ContactTangent slopes_now_, slopes_sum_;                  // sums over contacts; over samples as well
  double overlap_ = 0.0;                                    // largest in the window over radius [-]
  BodyLoad load_;
};

}  // namespace footfall

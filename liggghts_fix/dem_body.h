#pragma once
// One coupled body on the grains' side: where its boundary is, and what the grains of this rank do to it. No LIGGGHTS
// headers.

#include <cstdint>
#include <vector>

#include "coupler/load_average.h"
#include "coupler/messages.h"
#include "coupler/modal_boundary.h"
#include "coupler/window.h"
#include "liggghts_fix/contact_slope.h"
#include "liggghts_fix/rank_shares.h"

namespace footfall {

// Life of a window: begin_window, then per substep advance, clear_contacts, add_contact for every contact of this rank,
// end_substep; then append_share, and add_share for every rank.
class DemBody {
 public:
  // Both must outlive the body.
  DemBody(const CoupledBody& scene_body, const Scheme& scheme);

  const ModalBoundary& boundary() const { return boundary_; }
  const BoundaryPath& path() const { return path_; }
  const BodyMotion& pose() const { return path_.pose(); }

  // inverse_mass [1/kg]: 1/m of the mass that contacts meet; 0 where it is not asked for, or does not give way.
  void begin_window(const BodyMotion& start, int n, double dt, double inverse_mass = 0.0);
  double inverse_mass() const { return inverse_mass_; }
  void advance() { path_.advance(); }

  void clear_contacts();
  // A contact: force f_W [N] ON the body at the boundary point and moment m_W [N m] about that point (contacts beside
  // the axis of a beam, or in the middle of the overlap; rolling friction), overlap over grain radius [-], normal
  // stiffness [N/m] (0: unknown).
  void add_contact(const BoundaryPoint& point, const Eigen::Vector3d& f_W, const Eigen::Vector3d& m_W,
                   double overlap_over_radius, double stiffness);
  // A contact on a curved part of a mesh: sqrt(2 R overlap) over the width of its facet [-].
  void count_patch(double over_facet);
  // The same in two parts, for who projects many contacts at once (beams): their generalized force ON the body, and
  // each contact's figures.
  void add_load(const GeneralizedForce& Q);
  void count_contact(double overlap_over_radius, double stiffness);
  // Does the scheme use contact slopes, and is this one of the substeps at which they are sampled? Then add_slope
  // follows for every contact, at arm_W [m] from a boundary point; the point of a mesh that touches may be a
  // periodic image, and is told by its place on the boundary here too. Or at its point in W [m].
  bool samples_slopes() const { return samples_slopes_; }
  void add_slope(const BoundaryPoint& point, const Eigen::Vector3d& arm_W, const ContactSlope& slope);
  void add_slope(const Eigen::Vector3d& point_W, const ContactSlope& slope);
  // The forces just evaluated stand before the next substep (a run was set up).
  void take_standing();
  // They go on from a set-up as they were before it.
  void set_opening_force(const OpeningForce& force) { average_.set_opening_force(force); }
  const OpeningForce& standing() const { return average_.opening_force(); }  // of this rank
  void end_substep(double dt);
  // Of the contacts on this rank since clear_contacts.
  const GeneralizedForce& contact_force() const { return now_; }

  // At the end of a window: appends what the grains of this rank did to its row (rank_shares.h).
  void append_share(std::vector<double>& row);
  std::size_t share_size() const { return footfall::share_size(load_); }
  // Then, with the rows of all ranks: clear_load, and add_share for every rank. add_share returns where the next share
  // of the row begins.
  void clear_load() { clear(load_); }
  const double* add_share(const double* row) { return footfall::add_share(row, load_); }

  // Complete when the shares of all ranks are added.
  const BodyLoad& load() const { return load_; }
  // Mean moment about Bo in W at the end of the window [N m].
  Eigen::Vector3d mean_moment_W() const { return pose().rotation() * load_.mean.T_B; }
  // Between two windows, but the force that stands: each rank has its part of it (DemLink::standing).
  void visit(Archive& archive);
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
  double contact_time_ = 0.0;    // integral of the contacts over the window [s]
  double time_ = 0.0;            // of the window [s]
  double inverse_mass_ = 0.0;    // [1/kg]
  bool scheme_wants_slopes_;
  bool samples_slopes_ = false;
  int substep_ = 0, slope_stride_ = 1, slope_samples_ = 0;  // in the window
  ContactTangent slopes_now_, slopes_sum_;                  // sums over contacts; over samples as well
  double overlap_ = 0.0;                                    // largest in the window over radius [-]
  double patch_over_facet_ = 0.0;                           // likewise [-]
  BodyLoad share_;                                          // of this rank, in the last window
  BodyLoad load_;                                           // of all ranks
};

}  // namespace footfall

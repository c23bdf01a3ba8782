#pragma once
// One coupled body on the DEM side: the path of its boundary, and the load of this rank's grains on
// it.

#include <cstdint>
#include <string>
#include <vector>

#include "coupler/load_average.h"
#include "coupler/messages.h"
#include "coupler/modal_boundary.h"
#include "coupler/window.h"
#include "liggghts_fix/link/contact_slope.h"
#include "liggghts_fix/link/rank_shares.h"

namespace footfall {

// A grain that touches a body.
struct TouchingGrain {
  double mass = 0.0;                              // [kg]; 0: unknown
  double radius = 0.0;                            // [m]
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();  // of its centre [m/s]
};

// Sides of the bed that a body has passed, and whether all of it has left the bed.
class BedSides {
 public:
  // The wall of a fix; to_side: from the bed.
  void pass(const std::string& wall, const Eigen::Vector3d& to_side) { passed_.push_back({wall, to_side}); }
  bool has_passed() const { return !passed_.empty(); }                 // a part of the body
  const Eigen::Vector3d* direction_of(const std::string& wall) const;  // to_side; null: not passed
  void leave_bed() { off_bed_ = true; }
  bool off_bed() const { return off_bed_; }
  void visit(Archive& archive);

 private:
  struct Passed {
    std::string wall;
    Eigen::Vector3d to_side = Eigen::Vector3d::Zero();
    void visit(Archive& archive);
  };
  std::vector<Passed> passed_;
  bool off_bed_ = false;
};

// The mean slope of all contacts of a window, sampled at a few DEM steps.
class SlopeMean {
 public:
  explicit SlopeMean(bool required) : required_(required) {}
  void begin_window(int n);                  // DEM steps
  void begin_substep(int substep);           // in the window
  bool samples() const { return samples_; }  // at this DEM step
  void add(const ContactSlope& slope, const Eigen::Vector3d& arm_W) { add_slope(slope, arm_W, now_); }
  void end_substep();
  void write(ContactTangent& mean) const;

 private:
  bool required_, samples_ = false;
  int stride_ = 1, count_ = 0;
  ContactTangent now_, sum_;  // sum over contacts; sum over samples
};

// A window: begin_window; per DEM step advance, clear_contacts, add_contact for every contact of
// this rank, end_substep; then append_share, a gather over the ranks, clear_load, add_share for
// every rank and finish_load.
class DemBody {
 public:
  // Both must outlive the body. gravity: on the grains [m/s2].
  DemBody(const CoupledBody& scene_body, const Scheme& scheme, double gravity = 0.0);

  const ModalBoundary& boundary() const { return boundary_; }
  const BoundaryPath& path() const { return path_; }
  const BodyMotion& pose() const { return path_.pose(); }

  // inverse_mass [1/kg]: 1/m of the mass that contacts act on; 0: unknown, fixed or driven.
  // closing, known: of BoundaryPath::begin_window.
  void begin_window(const BodyMotion& start, int n, double dt, double inverse_mass = 0.0, int closing = 0,
                    const KnownPath& known = KnownPath());
  double inverse_mass() const { return inverse_mass_; }
  void advance() { path_.advance(); }

  void clear_contacts();
  // Adds a contact: force f_W [N] ON the body at the boundary point, and moment m_W [N m] about
  // that point (rolling friction, and contacts at a distance from the point, as on the surface of a
  // beam); overlap over grain radius [-]; normal stiffness [N/m] (0: unknown).
  void add_contact(const BoundaryPoint& point, const Eigen::Vector3d& f_W, const Eigen::Vector3d& m_W,
                   double overlap_over_radius, double stiffness, const TouchingGrain& grain = {});
  // A contact on a curved part of a mesh: patch radius sqrt(2 R overlap) over the width of the
  // facet [-].
  void count_patch(double over_facet);
  // The same in two parts, where many contacts are projected together (beams): their generalized
  // force ON the body, and the values of each contact.
  void add_load(const GeneralizedForce& Q);
  void count_contact(double overlap_over_radius, double stiffness, const BoundaryPoint& point,
                     const TouchingGrain& grain);
  // Does the scheme use contact slopes, and is this one of the DEM steps at which they are sampled?
  // Then call add_slope for every contact: at arm_W [m] from a boundary point (on a periodic mesh
  // an image may be far from the position in W), or at a point in W [m].
  bool samples_slopes() const { return slopes_.samples(); }
  void add_slope(const BoundaryPoint& point, const Eigen::Vector3d& arm_W, const ContactSlope& slope);
  void add_slope(const Eigen::Vector3d& point_W, const ContactSlope& slope);
  // The forces just evaluated in the set-up of a run open the next DEM step.
  void use_as_opening_force();
  // The forces from before the set-up open it instead.
  void set_opening_force(const OpeningForce& force) { average_.set_opening_force(force); }
  const OpeningForce& opening_force() const { return average_.opening_force(); }  // of this rank
  void end_substep(double dt);
  // Sum over the contacts on this rank since clear_contacts.
  const GeneralizedForce& contact_force() const { return now_; }

  // At the end of a window: appends the load of this rank's grains to its row (rank_shares.h).
  void append_share(std::vector<double>& row);
  std::size_t share_size() const { return footfall::share_size(load_) + static_cast<std::size_t>(step_forces_.size()); }
  // Then, with the rows of all ranks: clear_load, add_share for every rank, and finish_load.
  // add_share returns the start of the next share in the row.
  void clear_load();
  const double* add_share(const double* row);
  void finish_load();

  // Complete after finish_load.
  const BodyLoad& load() const { return load_; }
  // Mean moment about Bo in W at the end of the window [N m].
  Eigen::Vector3d mean_moment_W() const { return pose().rotation() * load_.mean.T_B; }
  BedSides& sides() { return sides_; }
  // State between two windows, without the opening force, of which each rank has a part
  // (opening_forces.h).
  void visit(Archive& archive);
  // Work of the mean load of the last window between two computed states [J].
  double work_between(const BodyMotion& from, const BodyMotion& to) const;

 private:
  const ModalBoundary& boundary_;
  BoundaryPath path_;
  LoadAverage average_;
  GeneralizedForce now_;        // of all contacts since clear_contacts
  double stiffness_now_ = 0.0;  // [N/m]
  std::int64_t contacts_now_ = 0;
  double stiffness_time_ = 0.0;  // integral over the window [N s/m]
  double contact_time_ = 0.0;    // integral of the contacts over the window [s]
  double time_ = 0.0;            // of the window [s]
  double inverse_mass_ = 0.0;    // [1/kg]
  BedSides sides_;
  SlopeMean slopes_;
  int substep_ = 0;  // in the window
  double gravity_;   // [m/s2]
  BodyLoad share_;   // of this rank, in this window
  BodyLoad load_;    // of all ranks
  // Mean force of every DEM step of the window: of this rank, and of all [N].
  Eigen::Matrix3Xd step_forces_, all_step_forces_;
};

}  // namespace footfall

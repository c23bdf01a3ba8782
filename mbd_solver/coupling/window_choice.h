#pragma once
// The length of the next window for `every auto`, and the time until a boundary can meet a grain.

#include <Eigen/Dense>
#include <vector>

#include "coupler/archive.h"
#include "coupler/body_motion.h"
#include "coupler/schemes/window_map.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/scene/run_spec.h"

namespace footfall {

// Time [s] until the lowest point of the undeformed boundary, descending at its present speed, is as low as the highest
// grain that may lie under it; infinity when it does not descend; 0 when it may touch a grain now, or when the height of
// the grains is unknown.
//   speed v = |w| reach - up . dr,  reach = largest |rho0|;  height h = v t
// A body whose path is known: with its downward acceleration, h = v t + a t^2 / 2,  a = (|dw| + w^2) reach - up . ddr.
// up: unit vector. site: the grains below this boundary at the start, valid while it stays above them; null after its
// first contact: then the highest grain of all counts.
double flight_time(const BodyMotion& motion, const ModalBoundary& boundary, const Placement& placement,
                   const Eigen::Vector3d& up, const LandingSite* site, bool known = false);

// The number of DEM steps of the next window for `every auto`: few while forces change, many in flight and at rest.
//
// After a window of n DEM steps, for every body: K = stiffness of its contacts, e = distance of the computed motion from
// the predicted one at the window's end.
//   response stiffness  K_s = 3 |change of the mean force| / |displacement| since the window before, at most K: grains
//                       that yield respond softer than their contacts, but to a fast disturbance stiffer than to the
//                       whole displacement. K itself where the displacement is at most e. K_s decreases by at most 10 %
//                       per window: a force may pass through an extremum. Among grains without contact: K so far.
//   error estimate      eta = K_s e / F,  F = largest mean force of the run so far (at least the weight of the lightest
//                       body)
//   next window         n sqrt(0.9 tolerance / eta): e is of second order in H. It covers all that bends the motion:
//                       contacts, springs, motors, prescribed motions of other bodies;
//                       omega H at most kAim of the limit that warnings have (OmegaHLimit), omega = sqrt(K / m);
//                       omega_g H at most 0.8, omega_g = sqrt(k / m_g) of a contact with a grain of mass m_g: the mean
//                       force of a window then shows the peak of that contact within 3 %. Between two contacts, and for
//                       a body that is led, the largest value so far counts;
//                       at most twice the last one, and at most max_substeps.
// A body without contact: at most half of the time until its lowest point can meet a grain, so that windows shrink on
// the way; among the grains, as for the stiffest contact of this body so far, or, before its first, of any body;
// single DEM steps before the first of all.

class WindowChoice {
 public:
  struct Body {
    double mass = 0.0;                                // [kg]
    double stiffness = 0.0;                           // K, window mean [N/m]; 0 without contact
    double gap = 0.0;                                 // e, at its farthest point [m]
    double flight = 0.0;                              // time until it can meet a grain [s]; 0: it may touch one now
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // mean over the window, in W [N]
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // of Bo, likewise [m]
    double grain_omega2 = 0.0;                        // omega_g^2, the largest [1/s2]
  };

  // dt: DEM step [s]. weight: of the lightest body, the smallest F [N]. limit: of omega H.
  WindowChoice(const CouplingSpec& spec, double dt, double weight, const OmegaHLimit& limit);

  int substeps() const { return n_; }                                          // of the next window
  double estimate() const { return estimate_; }                                // largest eta of the last window [-]
  double force_error(std::size_t i) const { return history_[i].force_error; }  // K_s e of body i in it [N]
  // Before the first window: distances from the grains.
  void start(const std::vector<Body>& bodies);
  // After a window of n DEM steps.
  void observe(int n, const std::vector<Body>& bodies);

  void visit(Archive& archive);

 private:
  struct History {
    double stiffness = 0.0;                           // of its contacts so far: decreases by 5 % per window [N/m]
    double response = 0.0;                            // K_s before it is limited by K [N/m]
    double grain_omega2 = 0.0;                        // likewise [1/s2]
    double force_error = 0.0;                         // K_s e of the last window [N]
    bool touched = false;                             // in the window before
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // of the window before [N]
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // likewise [m]

    void visit(Archive& archive);
  };

  static double response(const Body& body, History& history);  // K_s; the window becomes the previous one
  // DEM steps that contacts of this stiffness [N/m] and frequency omega_g^2 [1/s2], or the flight, allow.
  double longest(const Body& body, double stiffness, double grain_omega2);

  CouplingSpec spec_;
  double dt_;  // [s]
  OmegaHLimit limit_;
  double force_scale_;            // F [N]
  std::vector<History> history_;  // per body
  double estimate_ = 0.0;
  int n_ = 1;
};

}  // namespace footfall

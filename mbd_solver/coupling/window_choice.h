#pragma once
// How long a boundary falls before it can meet a grain.

#include <Eigen/Dense>
#include <vector>

#include "coupler/archive.h"
#include "coupler/body_motion.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/scene/run_spec.h"

namespace footfall {

// Time [s] until the lowest point of the undeformed boundary, falling at its present speed, is as low as the highest
// grain that may lie under it; infinity when it does not fall; 0 when it may touch a grain now, or when nobody said how
// high the grains stand.
//   speed = |w| reach - up . dr,  reach = largest |rho0|
// up: unit vector. site: the grains below this boundary at the start, which count as long as it stays above them; null
// once it has touched: from then on the highest grain of all counts.
double flight_time(const BodyMotion& motion, const ModalBoundary& boundary, const Placement& placement,
                   const Eigen::Vector3d& up, const LandingSite* site);

// How many substeps the next window takes, when the script says `every auto`: few while forces change, many in flight
// and at rest.
//
// After a window of n substeps, for every body: K = stiffness of its contacts, e = how far the computed motion ends
// from the predicted one.
//   answer          K_s = 3 |change of the mean force| / |way| since the window before, at most K: grains that give way
//   answer softer than
//                         their contacts, but to something quick stiffer than to the way as a whole. K itself where the
//                         way is no longer than e. K_s falls by 10 % per window at most: a force may pass through an
//                         extremum.
//   error estimate  eta = K_s e / F,  F = largest mean force of the run so far (at least the weight of the lightest
//   body) next window     n sqrt(0.9 tolerance / eta): e is of second order in H;
//                   at most warn_omega_h / (omega_s dt), omega_s = sqrt(K_s / m), and never omega H above kChosenOmegaH
//                   warn_omega_h, omega = sqrt(K / m): explicit schemes end at 2. Where contacts open or have just
//                   closed, omega_s = omega;
//                   at most twice as long as the last one, and never more than max_substeps.
// A body without contact: at most half of the time until its lowest point can meet a grain, so that windows shrink on
// the way; below that, as for the stiffest contact that it has had, or, before its first, that any other has had;
// single substeps before the first of all.

// omega H of chosen windows over warn_omega_h: their error is watched, that of fixed ones is not
inline constexpr double kChosenOmegaH = 2.4;

class WindowChoice {
 public:
  struct Body {
    double mass = 0.0;                                // [kg]
    double stiffness = 0.0;                           // K, window mean [N/m]; 0 without contact
    double gap = 0.0;                                 // e, at its worst point [m]
    double flight = 0.0;                              // time until it can meet a grain [s]; 0: it may be among them
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // mean over the window, in W [N]
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // of Bo, likewise [m]
  };

  // dt: substep [s]. weight: of the lightest body, the least F [N].
  WindowChoice(const CouplingSpec& spec, double dt, double weight);

  int substeps() const { return n_; }            // of the next window
  double estimate() const { return estimate_; }  // largest eta of the last window [-]
  // omega H of body i in the next window above which it deserves a warning: contacts that answer softer may stiffen by
  // a quarter of it.
  double allowed_omega_h(std::size_t i) const;
  // Before the first window: how far everything is from the grains.
  void start(const std::vector<Body>& bodies);
  // After a window of n substeps.
  void observe(int n, const std::vector<Body>& bodies);

  void visit(Archive& archive);

 private:
  struct Memory {
    double stiffness = 0.0;                           // of contacts met: falls by 5 % per window [N/m]
    double answer = 0.0;                              // K_s before it is held against K [N/m]
    double omega_h = 0.0;                             // of the next window at most; 0: not limited by contacts
    bool touched = false;                             // in the window before
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // of the window before [N]
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // likewise [m]

    void visit(Archive& archive);
  };

  static double answer(const Body& body, Memory& memory);  // K_s; the window becomes the one before
  // Largest omega H of the next window. stiffness: as it has been met; answer: K_s.
  double largest_omega_h(const Body& body, double stiffness, double answer) const;
  double longest(const Body& body, double stiffness, double omega_h) const;  // substeps that this or the flight allows

  CouplingSpec spec_;
  double dt_;                   // [s]
  double force_scale_;          // F [N]
  std::vector<Memory> memory_;  // per body
  double estimate_ = 0.0;
  int n_ = 1;
};

}  // namespace footfall

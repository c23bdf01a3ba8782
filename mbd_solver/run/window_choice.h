#pragma once
// How many substeps the next window takes, when the script says `every auto`: few while forces change, many in flight and at rest.
//
// After a window of n substeps, for every body: K = its contact stiffness, e = how far the computed motion ends from the predicted one.
//   error estimate  eta = K e / F,  F = largest mean force of the run so far (at least the weight of the lightest body)
//   next window     n sqrt(0.9 tolerance / eta): e is of second order in H;
//                   at most warn_omega_h / (omega dt), omega = sqrt(K / m): explicit schemes stay stable and accurate;
//                   at most twice as long as the last one, and never more than max_substeps.
// A body without contact: it may fly until its lowest point can meet a grain; below that, its windows are as for the stiffest contact that
// it has had, and single substeps before its first.

#include <vector>

#include "mbd_solver/scene/run_spec.h"

namespace footfall {

class WindowChoice {
 public:
  struct Body {
    double mass = 0.0;       // [kg]
    double stiffness = 0.0;  // K, window mean [N/m]; 0 without contact
    double force = 0.0;      // mean over the window [N]
    double gap = 0.0;        // e, at its worst point [m]
    double flight = 0.0;     // time until it can meet a grain [s]; 0: it may be among them
  };

  // dt: substep [s].
  WindowChoice(const CouplingSpec& spec, double dt, double weight);

  int substeps() const { return n_; }                      // of the next window
  double estimate() const { return estimate_; }            // largest eta of the last window [-]
  // Before the first window: how far everything is from the grains.
  void start(const std::vector<Body>& bodies);
  // After a window of n substeps.
  void observe(int n, const std::vector<Body>& bodies);

 private:
  double longest(const Body& body, double stiffness) const;  // substeps that omega H or the flight allows

  CouplingSpec spec_;
  double dt_;                        // [s]
  double force_scale_;               // F [N]
  std::vector<double> stiffness_;    // per body, of contacts met: falls by 5 % per window [N/m]
  double estimate_ = 0.0;
  int n_ = 1;
};

}  // namespace footfall

#pragma once
// A massless cable between two ends, over any number of pulleys and eyelets without friction: one tension all along. An end is
// a point of a body, or a round of a body that takes the cable up (drum; a pulley that the cable turns is the end of two
// cables). The cable leaves a round, circle of radius R about c in the plane normal to a, along the common tangent with the
// next guide. It runs round a by the right hand.
//   p_out = c_i - R_i a_i x e_i,  e_i = u cos(beta) + a_i x u sin(beta),  sin(beta) = (R_i - R_j a_i.a_j) / L
//   u, L: direction and length of c_j - c_i in the plane of i;  p_in on the next guide likewise, in its plane
//   theta_out, theta_in: angles of p_out and p_in about a, from a direction b that is fixed on the body
//   s = s_0 - R_1 theta_out,1 + R_m theta_in,m    unstretched length between the ends: what drums have not taken up
//   e = sum |p_in - p_out| + sum R (theta_out - theta_in) - s          stretch; the sums over spans and pulleys
//   V = 1/2 k e^2, or 1/2 EA e^2 / s, where e > 0;  F = max(0, dV/de + c e' min(1, e / toe))
//   Q = -F de/dx - (dV/ds) ds/dx
// Forces are derivatives of V whatever the angle at which a span leaves the plane of its round. A pulley whose wrap
// theta_out - theta_in falls below zero is not touched. Inner states count the turns, as in torsional springs.

#include <vector>

#include "mbd_solver/model/force_element.h"

namespace footfall {

struct CableGuide {
  Marker marker;        // c, and a = its z axis, b = its x axis
  double radius = 0.0;  // R [m]; 0: a point
  double angle = 0.0;   // at the start: of an end theta, else the wrap [rad]
};

struct CableParameters {
  double stiffness = 0.0;        // k [N/m], or
  double axial_stiffness = 0.0;  // EA [N]
  double damping = 0.0;          // c [N s/m]
  double length = 0.0;           // s_0, at theta = 0 [m] > 0
};

struct CableSample {
  double length = 0.0;             // of the way between the ends [m]
  double stretch = 0.0;            // e [m]; negative: slack
  double rate = 0.0;               // e' [m/s]
  double force = 0.0;              // F [N] >= 0
  double unstretched = 0.0;        // s [m]
  double first = 0.0, last = 0.0;  // theta of the ends, since the start where they are rounds [rad]
};

// A point of the way in W [m], and the guide at which it is, with its centre [m] and axis in W.
struct CablePoint {
  Eigen::Vector3d p;
  int guide;
  Eigen::Vector3d centre, axis;
};

class Cable : public ForceElement {
 public:
  // Two guides at least; the bodies of all are eight at most (InputError).
  Cable(std::string name, std::vector<CableGuide> guides, const CableParameters& parameters);

  int state_count() const override { return states_; }
  int state_block() const override { return states_ > 0 ? 1 : 0; }
  Eigen::VectorXd initial_state() const override;
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;

  CableSample sample(const ElementInput& in) const;
  // Two points of each span, in order: where the cable leaves one guide and meets the next that it touches.
  std::vector<CablePoint> points(const ElementInput& in) const;
  const std::vector<CableGuide>& guides() const { return guides_; }

 private:
  struct Way;
  struct Force;
  class Measurement;
  bool is_end(std::size_t guide) const { return guide == 0 || guide + 1 == guides_.size(); }
  void measure(const ElementInput& in, bool second, Way& way) const;
  Force force(const Way& way) const;

  std::vector<CableGuide> guides_;
  CableParameters parameters_;
  std::vector<int> state_of_;  // per guide: its inner state; -1 of a point
  int states_ = 0;
};

// The angle about a of the point at which the way from p to q, or from q to p, touches a round (theory 3.8), for the
// builder: both directions of the contact points from the centre, unit vectors in W.
struct CableTouch {
  Eigen::Vector3d in, out;
};
// Of each guide of a way given in W: centre, axis, radius.
struct CablePlace {
  Eigen::Vector3d centre, axis;
  double radius = 0.0;
};
// The touching directions of every round, as if all were touched, and the length of all spans. Throws NumericalError, with
// the number of the guide from 1, if one is inside of another.
std::vector<CableTouch> touch(const std::vector<CablePlace>& places, double& spans);

}  // namespace footfall

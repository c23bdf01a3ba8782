#pragma once
// A sphere against a chain of capsules, and the motion and load of the chain's body. theory 6.2.
//
// Segment p_s p_e with radius R, sphere at x with radius r:
//   mu = (x - p_s).(p_e - p_s) / |p_e - p_s|^2, clamped to [0, 1]
//   p = (1 - mu) p_s + mu p_e
//   gap = |x - p| - R - r
// The chain is the union of its capsules: its gap is the smallest gap of its segments. A sphere therefore touches a chain
// once. At a shared node two segments give the same point, hence neither a double force nor a hole. On the inner side of
// a bend the touch changes segment where both gaps are equal: the gap is continuous there, and the normal turns by the
// angle of the bend.

#include <Eigen/Dense>
#include <vector>

#include "coupler/modal_boundary.h"

namespace footfall {

// The point of a chain closest to a sphere.
struct BeamTouch {
  int segment = -1;        // index into BeamChain::segments()
  double mu = 0.0;         // 0 at the segment's start, 1 at its end
  double gap = 0.0;        // from surface to surface [m]; contact where it is not positive
  double radius = 0.0;     // of the segment [m]
  Eigen::Vector3d p;       // on the axis [m]
  Eigen::Vector3d normal;  // unit vector from p to the sphere's centre
  // In a periodic box the sphere may touch an image of the chain at this offset from the chain [m]. All other values are
  // those at the chain, where the sphere's centre is at x - image.
  Eigen::Vector3d image = Eigen::Vector3d::Zero();

  // From p to the point where the forces act [m]: the middle of the overlap, as in LIGGGHTS' torques on grains; the
  // surface without overlap.
  Eigen::Vector3d arm() const { return (gap < 0.0 ? radius + 0.5 * gap : radius) * normal; }
  Eigen::Vector3d contact_point() const { return p + arm(); }
};

// One beam: segments between nodes, numbered 0 .. node_count()-1 within the chain, and the present node positions.
class BeamChain {
 public:
  // The segments of the boundary with this chain number, in their order; nodes at their undeformed positions rho0.
  // Throws InputError when there are none.
  BeamChain(const ModalBoundary& boundary, int chain);

  int node_count() const { return static_cast<int>(x_.cols()); }
  int segment_count() const { return static_cast<int>(segments_.size()); }
  // start, end: numbers within the chain
  const std::vector<BeamSegment>& segments() const { return segments_; }
  BoundaryPoint boundary_point(int node) const;
  double largest_radius() const { return largest_radius_; }  // [m]

  // Node positions in W [m], 3 x node_count(); written by the caller that moves the chain.
  Eigen::Matrix3Xd& x() { return x_; }
  const Eigen::Matrix3Xd& x() const { return x_; }
  // Moves the nodes with the body.
  void follow(const BodyMotion& motion);
  // Upper bound of the distance of any node between the motions `from` and `to` [m].
  double largest_travel(const BodyMotion& from, const BodyMotion& to) const;
  double length(int segment) const;  // now [m]

  // Closest point of one segment to a sphere of radius r [m] at x [m].
  BeamTouch touch(int segment, const Eigen::Vector3d& x, double r) const;

 private:
  std::vector<BeamSegment> segments_;
  std::vector<int> boundary_node_;  // node of the chain -> node of the boundary
  Eigen::Matrix3Xd rho0_;           // of the nodes, in B [m]
  Eigen::MatrixXd Phi_;             // of the nodes, 3 node_count() x modes
  Eigen::VectorXd largest_Phi_;     // of each mode: its largest displacement of a node
  double largest_rho0_ = 0.0;       // [m]
  Eigen::Matrix3Xd x_;
  double largest_radius_ = 0.0;
};

// --- Forces between a body and contacts on its chain.

// The motion of the chain with its body, and the load of contacts on the chain, which are conjugate in virtual work: the
// contacts give the body the power
//   sum_c f_c . v_c = F_W . dr + T_W . w + Q_a . da.
// Both work through the nodes: only nodes meet the modes, and the cost of a contact does not depend on their number.
//
// The axis between nodes is straight, and its sections turn linearly from node to node:
//   v_c = (1 - mu) v_s + mu v_e + ((1 - mu) w_s + mu w_e) x arm,
// with node velocities v and angular velocities w of ModalBoundary.
class BeamMotion {
 public:
  // Both must outlive this.
  BeamMotion(const ModalBoundary& boundary, const BeamChain& chain);

  // Begins a step: velocities at the nodes in this motion, no contacts.
  void begin_step(const BodyMotion& motion);
  // Velocity of the beam's material at the contact point of a touch, in W [m/s].
  Eigen::Vector3d velocity(const BeamTouch& touch) const;
  // Adds the force f_W [N] on the beam and its moment m_p_W [N m] about the touch's point p on the axis: m_p = arm x f
  // for a force at the contact point; rolling friction adds its couple.
  void add_force(const BeamTouch& touch, const Eigen::Vector3d& f_W, const Eigen::Vector3d& m_p_W);
  // Adds the forces since begin_step, projected on the body.
  void project(const BodyMotion& motion, GeneralizedForce& Q) const;

 private:
  const ModalBoundary& boundary_;
  const BeamChain& chain_;
  Eigen::Matrix3Xd v_;  // of nodes [m/s]
  Eigen::Matrix3Xd w_;  // [rad/s]
  Eigen::Matrix3Xd f_;  // on nodes [N]
  Eigen::Matrix3Xd m_;  // [N m]
};

// Contact force of a sphere of radius r [m] on a round beam of radius R [m], relative to Hertz' force of a sphere on
// a plane at the same overlap and of the same materials.
//   side, a cylinder: principal radii r along the beam, rho = r R / (r + R) across; the contact is an ellipse,
//     F = 4/3 E* sqrt(R_e) (overlap / F2)^(3/2),  R_e = sqrt(r rho),  F2 = 1 - ((r/rho)^0.0684 - 1)^1.531  [Hale 1999]
//   end, a sphere of radius R: F = 4/3 E* sqrt(rho) overlap^(3/2)
// The closed form of F2 replaces Hertz' elliptic integrals; the error of the force is below 0.6 % for R > r / 50.
double hertz_on_side(double r, double R);
double hertz_on_end(double r, double R);

}  // namespace footfall

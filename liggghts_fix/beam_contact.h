#pragma once
// A sphere against a chain of capsules. theory 6.2.
//
// Segment p_s p_e with radius R, sphere at x with radius r:
//   mu = (x - p_s).(p_e - p_s) / |p_e - p_s|^2, clamped to [0, 1]
//   p = (1 - mu) p_s + mu p_e
//   gap = |x - p| - R - r
// The chain is the union of its capsules: its gap is the smallest of its segments' gaps. So a sphere touches a chain
// once; at a node that two segments share both give the same point, hence neither a double force nor a hole. On the
// inner side of a bend the touch changes segment where both gaps are equal: the gap is continuous there, the normal
// turns by the angle of the bend.

#include <Eigen/Dense>
#include <vector>

#include "coupler/modal_boundary.h"

namespace footfall {

// The point of a chain that is closest to a sphere.
struct BeamTouch {
  int segment = -1;        // index into BeamChain::segments()
  double mu = 0.0;         // 0 at the segment's start, 1 at its end
  double gap = 0.0;        // from surface to surface [m]; contact where it is not positive
  double radius = 0.0;     // of the segment [m]
  Eigen::Vector3d p;       // on the axis [m]
  Eigen::Vector3d normal;  // unit vector from p to the sphere's centre
  // In a periodic box the sphere may touch an image of the chain, which stands this far from the chain itself [m]. All
  // else here is told at the chain: the sphere's centre is there at x - image.
  Eigen::Vector3d image = Eigen::Vector3d::Zero();

  // From p to where the forces act: the middle of the overlap, as in LIGGGHTS' torques on grains; the surface where
  // there is no overlap [m].
  Eigen::Vector3d arm() const { return (gap < 0.0 ? radius + 0.5 * gap : radius) * normal; }
  Eigen::Vector3d contact_point() const { return p + arm(); }
};

// One beam: segments between nodes, numbered 0 .. node_count()-1 within the chain, and where the nodes are now.
class BeamChain {
 public:
  // Those segments of the boundary whose chain number is `chain`, in their order; nodes stand at their undeformed
  // places rho0. Throws InputError when there are none.
  BeamChain(const ModalBoundary& boundary, int chain);

  int node_count() const { return static_cast<int>(x_.cols()); }
  int segment_count() const { return static_cast<int>(segments_.size()); }
  // start, end: numbers within the chain
  const std::vector<BeamSegment>& segments() const { return segments_; }
  BoundaryPoint boundary_point(int node) const;
  double largest_radius() const { return largest_radius_; }  // [m]

  // Node positions in W [m], 3 x node_count(); whoever moves the chain writes them.
  Eigen::Matrix3Xd& x() { return x_; }
  const Eigen::Matrix3Xd& x() const { return x_; }
  // Places the nodes where the body's motion carries them.
  void follow(const BodyMotion& motion);
  // No node is farther from where it is under `from` than this, under `to` [m].
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

}  // namespace footfall

#pragma once
// The boundary of one body: nodes that move with the body, and the triangles and beam segments between them.
// This file alone moves boundary points and projects forces on the body, so that virtual work is conserved: for forces
// f_c at points c,  sum_c f_c . v_c = F_W . dr + T_W . w + Q_a . da  in every motion. [Lin25 5-12, 34], theory 6.3.

#include <Eigen/Dense>
#include <array>
#include <string>
#include <vector>

#include "coupler/body_motion.h"

namespace footfall {

// Two-node piece of a beam chain: a capsule of this radius around the line between its nodes.
struct BeamSegment {
  int start = 0;        // node index
  int end = 0;          // node index
  double radius = 0.0;  // [m]
  int chain = 0;        // segments of one beam share a chain number
};

// A point of the boundary: the weighted mean of up to three nodes (weights sum to 1).
// Triangle: barycentric. Segment: (1 - mu, mu, 0) with the third node unused.
struct BoundaryPoint {
  std::array<int, 3> nodes{0, 0, 0};
  std::array<double, 3> weights{1.0, 0.0, 0.0};
};

// Node j in B: rho_j = rho0_j + Phi_j a; small rotation Psi_j a. In W: r_j = r + A rho_j,
//   dr_j = dr + w x (A rho_j) + A Phi_j da.   s = 0 is a rigid body: Phi and Psi are empty, without modal loops.
// Immutable; nothing here allocates after construction.
class ModalBoundary {
 public:
  // rho0 [m] 3 x N in B; Phi 3N x s (empty: rigid); Psi 3N x s, or empty when the nodal rotations are unknown. Throws
  // InputError for no nodes, node indices out of range, a segment without length or radius, or shapes of the wrong size.
  ModalBoundary(std::string name, Eigen::Matrix3Xd rho0, std::vector<Eigen::Vector3i> triangles,
                std::vector<BeamSegment> segments = {}, Eigen::MatrixXd Phi = {}, Eigen::MatrixXd Psi = {});

  const std::string& name() const { return name_; }
  int node_count() const { return static_cast<int>(rho0_.cols()); }
  int mode_count() const { return static_cast<int>(Phi_.cols()); }
  const Eigen::Matrix3Xd& rho0() const { return rho0_; }
  const std::vector<Eigen::Vector3i>& triangles() const { return triangles_; }
  const std::vector<BeamSegment>& segments() const { return segments_; }
  const Eigen::MatrixXd& Phi() const { return Phi_; }
  const Eigen::MatrixXd& Psi() const { return Psi_; }

  // All nodes in W [m], [m/s]; the outputs are 3 x N and sized by the caller.
  void node_positions(const BodyMotion& motion, Eigen::Matrix3Xd& x_W) const;
  void node_velocities(const BodyMotion& motion, Eigen::Matrix3Xd& v_W) const;

  BoundaryPoint triangle_point(int triangle, const Eigen::Vector3d& weights) const;
  BoundaryPoint segment_point(int segment, double mu) const;

  Eigen::Vector3d position(const BodyMotion& motion, const BoundaryPoint& point) const;  // in W [m]
  Eigen::Vector3d velocity(const BodyMotion& motion, const BoundaryPoint& point) const;  // in W [m/s]

  // Angular velocity of the material at the point: w + A Psi(c) da, in W [rad/s]. Without Psi the modal part is zero.
  Eigen::Vector3d angular_velocity(const BodyMotion& motion, const BoundaryPoint& point) const;

  // Adds the force f_W [N] at a boundary point: F += f, T += (c - r) x f, Q_a += (A Phi(c))^T f.
  void add_point_force(const BodyMotion& motion, const BoundaryPoint& point, const Eigen::Vector3d& f_W,
                       GeneralizedForce& Q) const;
  // Adds the moment m_W [N m] at a boundary point: T += m, Q_a += (A Psi(c))^T m. A force f at the distance d from the
  // point, as on the surface of a beam, equals f and the moment d x f at the point; the conjugate velocity is
  // velocity() + angular_velocity() x d.
  void add_point_moment(const BodyMotion& motion, const BoundaryPoint& point, const Eigen::Vector3d& m_W,
                        GeneralizedForce& Q) const;

 private:
  Eigen::Vector3d rho(const BodyMotion& motion, const BoundaryPoint& point) const;  // in B [m]

  std::string name_;
  Eigen::Matrix3Xd rho0_;
  std::vector<Eigen::Vector3i> triangles_;
  std::vector<BeamSegment> segments_;
  Eigen::MatrixXd Phi_;
  Eigen::MatrixXd Psi_;
};

// Barycentric weights of the point c, projected on the plane of the triangle x0 x1 x2; they sum to 1. A triangle without
// area counts as its longer edge at x0.
Eigen::Vector3d barycentric_weights(const Eigen::Vector3d& x0, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2,
                                    const Eigen::Vector3d& c);

}  // namespace footfall

// Positions and velocities of boundary points, and the transposed projection of forces on F, T and Q_a.

#include "coupler/modal_boundary.h"

#include <utility>

#include "coupler/base/errors.h"
#include "coupler/codes.h"

namespace footfall {
namespace {

[[noreturn]] void refuse(const std::string& body, const std::string& what) {
  throw InputError(code::kBoundaryInvalid, "boundary of body \"" + body + "\": " + what);
}

}  // namespace

ModalBoundary::ModalBoundary(std::string name, Eigen::Matrix3Xd rho0, std::vector<Eigen::Vector3i> triangles,
                             std::vector<BeamSegment> segments, Eigen::MatrixXd Phi, Eigen::MatrixXd Psi)
    : name_(std::move(name)),
      rho0_(std::move(rho0)),
      triangles_(std::move(triangles)),
      segments_(std::move(segments)),
      Phi_(std::move(Phi)),
      Psi_(std::move(Psi)) {
  const int nodes = node_count();
  const auto is_node = [nodes](int j) { return j >= 0 && j < nodes; };
  if (nodes == 0) refuse(name_, "it has no nodes");
  if (!rho0_.allFinite() || !Phi_.allFinite() || !Psi_.allFinite()) refuse(name_, "a node or mode shape is not finite");
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Eigen::Vector3i& t = triangles_[i];
    if (!is_node(t[0]) || !is_node(t[1]) || !is_node(t[2]))
      refuse(name_, "triangle " + std::to_string(i) + " refers to a node outside 0.." + std::to_string(nodes - 1));
  }
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const BeamSegment& s = segments_[i];
    if (!is_node(s.start) || !is_node(s.end))
      refuse(name_, "segment " + std::to_string(i) + " refers to a node outside 0.." + std::to_string(nodes - 1));
    if (!(s.radius > 0.0)) refuse(name_, "segment " + std::to_string(i) + " has no radius");
    if (rho0_.col(s.start) == rho0_.col(s.end)) refuse(name_, "segment " + std::to_string(i) + " has no length");
  }
  if (Phi_.cols() > 0 && Phi_.rows() != 3 * nodes)
    refuse(name_,
           "Phi has " + std::to_string(Phi_.rows()) + " rows; expected three per node, " + std::to_string(3 * nodes));
  if (Psi_.size() > 0 && (Psi_.rows() != 3 * nodes || Psi_.cols() != Phi_.cols()))
    refuse(name_, "Psi must be empty or have the size of Phi");
  if (Phi_.cols() == 0) Phi_.resize(3 * nodes, 0);
}

void ModalBoundary::node_positions(const BodyMotion& motion, Eigen::Matrix3Xd& x_W) const {
  const Eigen::Matrix3d A = motion.rotation();
  if (mode_count() == 0) {
    for (int j = 0; j < node_count(); ++j) x_W.col(j) = motion.r + A * rho0_.col(j);
    return;
  }
  Eigen::Map<Eigen::VectorXd>(x_W.data(), x_W.size()).noalias() = Phi_ * motion.a;
  for (int j = 0; j < node_count(); ++j) {
    const Eigen::Vector3d rho = rho0_.col(j) + x_W.col(j);
    x_W.col(j) = motion.r + A * rho;
  }
}

void ModalBoundary::node_velocities(const BodyMotion& motion, Eigen::Matrix3Xd& v_W) const {
  const Eigen::Matrix3d A = motion.rotation();
  const Eigen::Vector3d w_B = A.transpose() * motion.w;
  if (mode_count() == 0) {
    for (int j = 0; j < node_count(); ++j) v_W.col(j) = motion.dr + A * w_B.cross(Eigen::Vector3d(rho0_.col(j)));
    return;
  }
  Eigen::Map<Eigen::VectorXd>(v_W.data(), v_W.size()).noalias() = Phi_ * motion.da;
  for (int j = 0; j < node_count(); ++j) {
    const Eigen::Vector3d rho = rho0_.col(j) + Phi_.middleRows<3>(3 * j) * motion.a;
    const Eigen::Vector3d v_B = w_B.cross(rho) + v_W.col(j);
    v_W.col(j) = motion.dr + A * v_B;
  }
}

BoundaryPoint ModalBoundary::triangle_point(int triangle, const Eigen::Vector3d& weights) const {
  const Eigen::Vector3i& t = triangles_[triangle];
  return {{t[0], t[1], t[2]}, {weights[0], weights[1], weights[2]}};
}

BoundaryPoint ModalBoundary::segment_point(int segment, double mu) const {
  const BeamSegment& s = segments_[segment];
  return {{s.start, s.end, s.end}, {1.0 - mu, mu, 0.0}};
}

Eigen::Vector3d ModalBoundary::rho(const BodyMotion& motion, const BoundaryPoint& point) const {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const int j = point.nodes[k];
    result += point.weights[k] * rho0_.col(j);
    if (mode_count() > 0) result.noalias() += point.weights[k] * (Phi_.middleRows<3>(3 * j) * motion.a);
  }
  return result;
}

Eigen::Vector3d ModalBoundary::position(const BodyMotion& motion, const BoundaryPoint& point) const {
  return motion.r + motion.rotation() * rho(motion, point);
}

Eigen::Vector3d ModalBoundary::velocity(const BodyMotion& motion, const BoundaryPoint& point) const {
  const Eigen::Matrix3d A = motion.rotation();
  Eigen::Vector3d v = motion.dr + motion.w.cross(A * rho(motion, point));
  if (mode_count() > 0)
    for (std::size_t k = 0; k < 3; ++k)
      v.noalias() += point.weights[k] * (A * (Phi_.middleRows<3>(3 * point.nodes[k]) * motion.da));
  return v;
}

void ModalBoundary::add_point_force(const BodyMotion& motion, const BoundaryPoint& point, const Eigen::Vector3d& f_W,
                                    GeneralizedForce& Q) const {
  const Eigen::Matrix3d A = motion.rotation();
  Q.F_W += f_W;
  Q.T_W += (A * rho(motion, point)).cross(f_W);
  if (mode_count() == 0) return;
  const Eigen::Vector3d f_B = A.transpose() * f_W;
  for (std::size_t k = 0; k < 3; ++k)
    Q.Q_a.noalias() += Phi_.middleRows<3>(3 * point.nodes[k]).transpose() * (point.weights[k] * f_B);
}

Eigen::Vector3d ModalBoundary::angular_velocity(const BodyMotion& motion, const BoundaryPoint& point) const {
  Eigen::Vector3d w = motion.w;
  if (Psi_.size() == 0) return w;
  const Eigen::Matrix3d A = motion.rotation();
  for (std::size_t k = 0; k < 3; ++k)
    w.noalias() += point.weights[k] * (A * (Psi_.middleRows<3>(3 * point.nodes[k]) * motion.da));
  return w;
}

void ModalBoundary::add_point_moment(const BodyMotion& motion, const BoundaryPoint& point, const Eigen::Vector3d& m_W,
                                     GeneralizedForce& Q) const {
  Q.T_W += m_W;
  if (Psi_.size() == 0) return;
  const Eigen::Vector3d m_B = motion.rotation().transpose() * m_W;
  for (std::size_t k = 0; k < 3; ++k)
    Q.Q_a.noalias() += Psi_.middleRows<3>(3 * point.nodes[k]).transpose() * (point.weights[k] * m_B);
}

Eigen::Vector3d barycentric_weights(const Eigen::Vector3d& x0, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2,
                                    const Eigen::Vector3d& c) {
  // c - x0 = b1 e1 + b2 e2 + (normal part): normal equations of this least-squares problem.
  const Eigen::Vector3d e1 = x1 - x0, e2 = x2 - x0, d = c - x0;
  const double e11 = e1.dot(e1), e12 = e1.dot(e2), e22 = e2.dot(e2);
  const double d1 = d.dot(e1), d2 = d.dot(e2);
  const double determinant = e11 * e22 - e12 * e12;
  if (determinant <= 1e-14 * e11 * e22) {  // no area: a point of the longer edge
    if (e11 >= e22) return {1.0 - d1 / e11, d1 / e11, 0.0};
    return {1.0 - d2 / e22, 0.0, d2 / e22};
  }
  const double b1 = (e22 * d1 - e12 * d2) / determinant;
  const double b2 = (e11 * d2 - e12 * d1) / determinant;
  return {1.0 - b1 - b2, b1, b2};
}

}  // namespace footfall

#include "mbd_solver/model/principal_axes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kAlong = 1e-9;  // [rad] axes that are nearer to the frame's are the frame's

// The frame turned on the shortest way, so that its axis nearest to `axis` lies along it.
Matrix3d turned_frame(const Vector3d& axis) {
  Index nearest = 0;
  axis.cwiseAbs().maxCoeff(&nearest);
  const Vector3d along = axis(nearest) < 0.0 ? Vector3d(-axis) : axis;
  return shortest_turn(Vector3d::Unit(nearest), along.normalized());
}

// Each column to the axis of the frame that is nearest to it: the nearest of all first, then of those left.
Matrix3d in_order(Matrix3d columns) {
  Matrix3d nearness = columns.cwiseAbs(), ordered;
  for (int chosen = 0; chosen < 2; ++chosen) {
    Index axis = 0, column = 0;
    nearness.maxCoeff(&axis, &column);
    ordered.col(axis) = columns(axis, column) < 0.0 ? Vector3d(-columns.col(column)) : Vector3d(columns.col(column));
    nearness.row(axis).setConstant(-1.0);
    nearness.col(column).setConstant(-1.0);
  }
  Index last = 0, column = 0;
  nearness.maxCoeff(&last, &column);
  ordered.col(last) = Vector3d(ordered.col((last + 1) % 3)).cross(Vector3d(ordered.col((last + 2) % 3)));
  return ordered;
}

}  // namespace

Matrix3d principal_axes(const Matrix3d& inertia) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(inertia);
  const Vector3d moments = eigen.eigenvalues();  // rising
  const double same = kSameMoment * moments(2);
  const bool low = moments(1) - moments(0) <= same, high = moments(2) - moments(1) <= same;
  if (low && high) return Matrix3d::Identity();
  const Matrix3d vectors = eigen.eigenvectors();
  const Matrix3d axes = low || high ? turned_frame(vectors.col(low ? 2 : 0)) : in_order(vectors);
  return axes.isIdentity(kAlong) ? Matrix3d(Matrix3d::Identity()) : axes;
}

Matrix3d principal_axes(const ModalBody& body) {
  Matrix3d inertia = Matrix3d::Zero();
  for (Index j = 0; j < body.node_count(); ++j) {
    const Matrix3d rho = skew(body.rho0.col(j));
    inertia += body.node_inertia[static_cast<std::size_t>(j)] - body.node_mass(j) * rho * rho;
  }
  return principal_axes(inertia);
}

}  // namespace footfall

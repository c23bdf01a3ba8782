// Closed forms of simple solids, sums by the parallel-axis theorem, and principal axes from an eigenvalue problem.

#include "mbd_solver/model/mass_properties.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

void demand_positive(double value, const std::string& what) {
  if (!(value > 0.0))
    throw InputError(code::kMassProperties, what + " is " + number_text(value) + "; it must be positive.");
}

// A solid of revolution between two points: transverse and axial inertia about its middle.
MassProperties along_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double mass, double axial,
                          double transverse) {
  const Eigen::Vector3d e = (to - from).normalized();
  MassProperties out;
  out.mass = mass;
  out.centre = 0.5 * (from + to);
  out.inertia = transverse * Eigen::Matrix3d::Identity() + (axial - transverse) * e * e.transpose();
  return out;
}

// Inertia of a mass concentrated at x, about the origin.
Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& x) { return -mass * skew(x) * skew(x); }

}  // namespace

MassProperties box_properties(const Eigen::Vector3d& size, double density) {
  demand_positive(size.minCoeff(), "smallest edge of a box [m]");
  demand_positive(density, "density [kg/m3]");
  MassProperties out;
  out.mass = density * size.prod();
  const Eigen::Vector3d s2 = size.cwiseAbs2();
  out.inertia =
      (out.mass / 12.0) * Eigen::Vector3d(s2[1] + s2[2], s2[2] + s2[0], s2[0] + s2[1]).asDiagonal().toDenseMatrix();
  return out;
}

MassProperties tube_properties(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter, double wall,
                               double density) {
  const double length = (to - from).norm();
  demand_positive(length, "length of a tube [m]");
  demand_positive(diameter, "diameter of a tube [m]");
  demand_positive(wall, "wall of a tube [m]");
  demand_positive(density, "density [kg/m3]");
  const double outer = 0.5 * diameter, inner = outer - wall;
  if (inner < 0.0)
    throw InputError(code::kMassProperties, "wall of a tube is " + number_text(wall) +
                                                " m; it must not exceed the radius, " + number_text(outer) + " m.");
  const double mass = density * length * kPi * (outer * outer - inner * inner);
  const double r2 = outer * outer + inner * inner;
  return along_line(from, to, mass, 0.5 * mass * r2, mass * (3.0 * r2 + length * length) / 12.0);
}

MassProperties rod_properties(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter, double density) {
  return tube_properties(from, to, diameter, 0.5 * diameter, density);
}

MassProperties disc_properties(double radius, double thickness, double density) {
  const Eigen::Vector3d half(0.0, 0.0, 0.5 * thickness);
  demand_positive(radius, "radius of a disc [m]");
  demand_positive(thickness, "thickness of a disc [m]");
  return rod_properties(-half, half, 2.0 * radius, density);
}

MassProperties sphere_properties(double radius, double density) {
  demand_positive(radius, "radius of a sphere [m]");
  demand_positive(density, "density [kg/m3]");
  MassProperties out;
  out.mass = density * 4.0 / 3.0 * kPi * radius * radius * radius;
  out.inertia = 0.4 * out.mass * radius * radius * Eigen::Matrix3d::Identity();
  return out;
}

// Half a ball of mass m has its centre 3/8 r from its flat side, the inertia 2/5 m r^2 about any axis through the middle
// of that side that lies in it or is normal to it.
MassProperties capsule_properties(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter,
                                  double density) {
  const MassProperties middle = rod_properties(from, to, diameter, density);
  const MassProperties ball = sphere_properties(0.5 * diameter, density);  // both ends together
  const double r = 0.5 * diameter, half = 0.5 * (to - from).norm(), to_centre = 0.375 * r;
  const double about_end = 0.4 * ball.mass * r * r;
  const double across = about_end + ball.mass * (half * half + 2.0 * half * to_centre);
  const Eigen::Vector3d e = (to - from).normalized();
  MassProperties out = middle;
  out.mass += ball.mass;
  out.inertia += across * Eigen::Matrix3d::Identity() + (about_end - across) * e * e.transpose();
  return out;
}

MassProperties with_mass(const MassProperties& solid, double mass) {
  demand_positive(mass, "mass [kg]");
  MassProperties out = solid;
  out.inertia *= mass / solid.mass;
  out.mass = mass;
  return out;
}

MassProperties operator+(const MassProperties& a, const MassProperties& b) {
  MassProperties out;
  out.mass = a.mass + b.mass;
  out.centre = (a.mass * a.centre + b.mass * b.centre) / out.mass;
  out.inertia = a.inertia + point_inertia(a.mass, a.centre - out.centre) + b.inertia +
                point_inertia(b.mass, b.centre - out.centre);
  return out;
}

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Eigen::MatrixXd rigid_motions(const Eigen::Matrix3Xd& x, bool rotations) {
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(6 * x.cols(), 6);
  for (Index j = 0; j < x.cols(); ++j) {
    R.block<3, 3>(6 * j, 0).setIdentity();
    for (int i = 0; i < 3; ++i) R.block<3, 1>(6 * j, 3 + i) = Vector3d::Unit(i).cross(Vector3d(x.col(j)));
    if (rotations) R.block<3, 3>(6 * j + 3, 3).setIdentity();
  }
  return R;
}

MassProperties mass_properties(const Eigen::Matrix3Xd& x, const Eigen::SparseMatrix<double>& M) {
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(M.rows(), 6);
  R.topRows(6 * x.cols()) = rigid_motions(x);
  const Eigen::MatrixXd rigid = R.transpose() * (M * R);
  const Matrix3d S = 0.5 * (rigid.block<3, 3>(3, 0) - rigid.block<3, 3>(3, 0).transpose());  // m c~
  MassProperties out;
  out.mass = rigid.topLeftCorner<3, 3>().trace() / 3.0;
  out.centre = Vector3d(S(2, 1), S(0, 2), S(1, 0)) / out.mass;
  const Matrix3d J = rigid.bottomRightCorner<3, 3>();
  out.inertia = 0.5 * (J + J.transpose()) - point_inertia(out.mass, out.centre);
  return out;
}

namespace {

constexpr double kAlong = 1e-9;  // axes nearer to the frame's than this are the frame's [rad]

// The frame turned by the shortest rotation that aligns its nearest axis with `axis`.
Matrix3d turned_frame(const Vector3d& axis) {
  Index nearest = 0;
  axis.cwiseAbs().maxCoeff(&nearest);
  const Vector3d along = axis(nearest) < 0.0 ? Vector3d(-axis) : axis;
  return shortest_turn(Vector3d::Unit(nearest), along.normalized());
}

// Assigns each column to the nearest axis of the frame, the best match first.
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
  if (body.mass.size() > 0) return principal_axes(mass_properties(body.rho0, body.mass).inertia);
  Matrix3d inertia = Matrix3d::Zero();
  for (Index j = 0; j < body.node_count(); ++j) {
    const Matrix3d rho = skew(body.rho0.col(j));
    inertia += body.node_inertia[j] - body.node_mass(j) * rho * rho;
  }
  return principal_axes(inertia);
}

}  // namespace footfall

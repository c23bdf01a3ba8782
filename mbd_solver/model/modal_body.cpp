// Stress recovery from modal coordinates, and the measures that the range of linear modes is checked with.

#include "mbd_solver/model/modal_body.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {

double lowest_frequency(const ModalBody& body) {
  FOOTFALL_DEMAND(body.mode_count() > 0);
  return std::sqrt(body.stiffness.minCoeff());
}

double extent(const ModalBody& body) {
  return (body.rho0.rowwise().maxCoeff() - body.rho0.rowwise().minCoeff()).norm();
}

using Eigen::Index;
using Eigen::VectorXd;

// sigma_v^2 = 1/2 ((xx - yy)^2 + (yy - zz)^2 + (zz - xx)^2) + 3 (xy^2 + yz^2 + zx^2)
VectorXd von_mises_of_points(const ModalBody& body, const VectorXd& a) {
  FOOTFALL_DEMAND(a.size() == body.mode_count());
  if (a.size() == 0 || body.stress_modes.rows() == 0) return VectorXd(0);
  const VectorXd sigma = body.stress_modes * a;
  VectorXd result(sigma.size() / 6);
  for (Index p = 0; p < result.size(); ++p) {
    const Eigen::Matrix<double, 6, 1> s = sigma.segment<6>(6 * p);
    result(p) = std::sqrt(0.5 * (std::pow(s(0) - s(1), 2) + std::pow(s(1) - s(2), 2) + std::pow(s(2) - s(0), 2)) +
                          3.0 * s.tail<3>().squaredNorm());
  }
  return result;
}

VectorXd von_mises_of_cells(const ModalBody& body, const VectorXd& a) {
  const VectorXd points = von_mises_of_points(body, a);
  const Index per_triangle = 2, per_segment = 8;
  const auto triangles = static_cast<Index>(body.triangles.size());
  const auto segments = static_cast<Index>(body.segments.size());
  if (points.size() == body.node_count() && points.size() != per_triangle * triangles + per_segment * segments) {
    VectorXd result(triangles + segments);
    for (Index t = 0; t < triangles; ++t) result(t) = points(body.triangles[t]).maxCoeff();
    for (Index e = 0; e < segments; ++e) result(triangles + e) = points(body.segments[e]).maxCoeff();
    return result;
  }
  if (points.size() == 0 || points.size() != per_triangle * triangles + per_segment * segments) return VectorXd(0);
  VectorXd result(triangles + segments);
  for (Index t = 0; t < triangles; ++t) result(t) = points.segment(per_triangle * t, per_triangle).maxCoeff();
  for (Index e = 0; e < segments; ++e)
    result(triangles + e) = points.segment(per_triangle * triangles + per_segment * e, per_segment).maxCoeff();
  return result;
}

double von_mises(const ModalBody& body, const VectorXd& a) {
  const VectorXd points = von_mises_of_points(body, a);
  return points.size() == 0 ? 0.0 : points.maxCoeff();
}

double largest_deflection(const ModalBody& body, const VectorXd& a) {
  FOOTFALL_DEMAND(a.size() == body.mode_count());
  if (a.size() == 0) return 0.0;
  const VectorXd u = body.Phi * a;
  double largest = 0.0;
  for (Index j = 0; j < body.node_count(); ++j) largest = std::max(largest, u.segment<3>(3 * j).norm());
  return largest;
}

}  // namespace footfall

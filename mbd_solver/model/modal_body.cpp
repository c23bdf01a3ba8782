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

namespace {

// sigma_v^2 = 1/2 ((xx - yy)^2 + (yy - zz)^2 + (zz - xx)^2) + 3 (xy^2 + yz^2 + zx^2)
double von_mises(const Eigen::Matrix<double, 6, 1>& s) {
  const double x = s(0) - s(1), y = s(1) - s(2), z = s(2) - s(0);
  return std::sqrt(0.5 * (x * x + y * y + z * z) + 3.0 * s.tail<3>().squaredNorm());
}

}  // namespace

VectorXd von_mises_of_points(const ModalBody& body, const VectorXd& a) {
  FOOTFALL_DEMAND(a.size() == body.mode_count());
  if (a.size() == 0 || body.stress_modes.rows() == 0) return VectorXd(0);
  const VectorXd sigma = body.stress_modes * a;
  VectorXd result(sigma.size() / 6);
  for (Index p = 0; p < result.size(); ++p) result(p) = von_mises(sigma.segment<6>(6 * p));
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

LargestStress::LargestStress(const ModalBody& body)
    : body_(body), of_modes_(body.stress_modes.rows() / 6, body.stress_modes.cols()) {
  for (Index p = 0; p < of_modes_.rows(); ++p)
    for (Index k = 0; k < of_modes_.cols(); ++k) of_modes_(p, k) = von_mises(body.stress_modes.block<6, 1>(6 * p, k));
}

double LargestStress::of_point(Index point, const VectorXd& a) const {
  return von_mises(body_.stress_modes.middleRows<6>(6 * point).lazyProduct(a));
}

double LargestStress::at(const VectorXd& a) {
  FOOTFALL_DEMAND(a.size() == body_.mode_count());
  if (a.size() == 0 || of_modes_.rows() == 0) return 0.0;
  most_.noalias() = of_modes_ * a.cwiseAbs();
  double largest = of_point(last_, a);
  for (Index p = 0; p < most_.size(); ++p) {
    if (!(most_[p] > largest)) continue;
    const double here = of_point(p, a);
    if (!(here > largest)) continue;
    largest = here;
    last_ = p;
  }
  return largest;
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

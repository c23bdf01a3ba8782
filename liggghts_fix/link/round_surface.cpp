// Nagata patches. The nearest point of a patch is found by Newton's method, inside first, then on the edges.

#include "liggghts_fix/link/round_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall {
namespace {

constexpr double kFlatPiece =
    1e-8;                   // 1 - cosine between the normals of a facet and of its node: 1.4e-4 rad, round-off of nodes
constexpr int kSteps = 20;  // of Newton's method; four or five are used
constexpr double kDone = 1e-13;

}  // namespace

// The parabola x_i + t d + t (1 - t) q leaves square to n_i and arrives square to n_j where
//   n_i . (d + q) = 0,   n_j . (d - q) = 0.
// q along the mean normal m satisfies both on an arc, and in general the sum of both.
RoundFacet::RoundFacet(const Eigen::Matrix3d& corners, const Eigen::Matrix3d& normals) : x_(corners) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Eigen::Vector3d d = x_.col(j) - x_.col(i), m = (normals.col(i) + normals.col(j)).normalized();
    q_.col(i) = (normals.col(j) - normals.col(i)).dot(d) / (2.0 * m.dot(normals.col(i))) * m;
  }
}

Eigen::Vector3d RoundFacet::at(double b1, double b2) const {
  const double b0 = 1.0 - b1 - b2;
  return b0 * x_.col(0) + b1 * x_.col(1) + b2 * x_.col(2) + b0 * b1 * q_.col(0) + b1 * b2 * q_.col(1) +
         b2 * b0 * q_.col(2);
}

// Newton's method for the minimum of |S - p|^2, from the nearest point of the flat facet's plane. False: the minimum is
// not inside the facet.
bool RoundFacet::inner(const Eigen::Vector3d& p, double& b1, double& b2) const {
  Eigen::Matrix<double, 3, 2> S;
  S << x_.col(1) - x_.col(0), x_.col(2) - x_.col(0);
  Eigen::Vector2d b = (S.transpose() * S).ldlt().solve(S.transpose() * (p - x_.col(0)));
  const Eigen::Vector3d S11 = -2.0 * q_.col(0), S22 = -2.0 * q_.col(2), S12 = q_.col(1) - q_.col(0) - q_.col(2);
  for (int step = 0; step < kSteps; ++step) {
    const double b0 = 1.0 - b.sum();
    const Eigen::Vector3d gap = at(b[0], b[1]) - p;
    S.col(0) = x_.col(1) - x_.col(0) + (b0 - b[0]) * q_.col(0) + b[1] * (q_.col(1) - q_.col(2));
    S.col(1) = x_.col(2) - x_.col(0) + b[0] * (q_.col(1) - q_.col(0)) + (b0 - b[1]) * q_.col(2);
    Eigen::Matrix2d H = S.transpose() * S;
    const Eigen::Matrix2d flat = H;
    H(0, 0) += gap.dot(S11);
    H(1, 1) += gap.dot(S22);
    H(0, 1) = H(1, 0) += gap.dot(S12);
    // Beyond the centre of curvature the distance has no minimum: take the step of the flat facet.
    if (H(0, 0) <= 0.0 || H.determinant() <= 1e-3 * flat.determinant()) H = flat;
    const Eigen::Vector2d change = -H.inverse() * (S.transpose() * gap);
    b += change;
    if (!(b.cwiseAbs().maxCoeff() < 10.0)) return false;  // far away
    if (change.cwiseAbs().maxCoeff() < kDone) break;
  }
  b1 = b[0];
  b2 = b[1];
  return b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
}

// t of the nearest point of an edge, from 0 at its first corner to 1.
double RoundFacet::on_edge(const Eigen::Vector3d& p, int edge) const {
  const Eigen::Vector3d x = x_.col(edge), d = x_.col((edge + 1) % 3) - x, q = q_.col(edge);
  double t = std::clamp(d.dot(p - x) / d.squaredNorm(), 0.0, 1.0);
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::Vector3d gap = x + t * d + t * (1.0 - t) * q - p, tangent = d + (1.0 - 2.0 * t) * q;
    const double flat = tangent.squaredNorm(), bent = flat - 2.0 * gap.dot(q);
    const double change = -gap.dot(tangent) / (bent > 1e-3 * flat ? bent : flat);
    const double before = t;
    t = std::clamp(t + change, 0.0, 1.0);
    if (std::abs(t - before) < kDone) break;
  }
  return t;
}

RoundFacet::Nearest RoundFacet::nearest(const Eigen::Vector3d& p) const {
  double b1 = 0.0, b2 = 0.0;
  if (inner(p, b1, b2)) return {{1.0 - b1 - b2, b1, b2}, at(b1, b2)};
  Nearest best{};
  double least = std::numeric_limits<double>::infinity();
  for (int edge = 0; edge < 3; ++edge) {
    const double t = on_edge(p, edge);
    std::array<double, 3> b{};
    b[edge] = 1.0 - t;
    b[(edge + 1) % 3] = t;
    const Eigen::Vector3d point = at(b[1], b[2]);
    const double distance = (point - p).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best = {b, point};
  }
  return best;
}

RoundSurface::RoundSurface(const SurfacePieces& pieces, const Eigen::Matrix3Xd& nodes)
    : normals_(static_cast<std::size_t>(pieces.size())), flat_(normals_.size()) {
  deform(pieces, nodes);
  for (int t = 0; t < pieces.size(); ++t) {
    const CornerNodes& corners = pieces.corners(t);
    Eigen::Matrix3d x;
    x << nodes.col(corners[0]), nodes.col(corners[1]), nodes.col(corners[2]);
    if (!is_flat(t)) bulge_ = std::max(bulge_, facet(t, x).largest_bulge());
  }
}

// The normal at a corner is the mean over the facets around it that belong to the same smooth surface, weighted by their
// angle at the corner times their area. The angle makes it the bisector between equal facets; the area keeps a large face
// flat up to a narrow rounding.
void RoundSurface::deform(const SurfacePieces& pieces, const Eigen::Matrix3Xd& nodes) {
  const auto normal = [&](int t) -> Eigen::Vector3d {
    const CornerNodes& c = pieces.corners(t);
    return 0.5 * (nodes.col(c[1]) - nodes.col(c[0])).cross(nodes.col(c[2]) - nodes.col(c[0]));
  };
  const auto angle = [&](int t, std::size_t k) {
    const CornerNodes& c = pieces.corners(t);
    const Eigen::Vector3d a = nodes.col(c[(k + 1) % 3]) - nodes.col(c[k]),
                          b = nodes.col(c[(k + 2) % 3]) - nodes.col(c[k]);
    return std::atan2(a.cross(b).norm(), a.dot(b));
  };
  for (int t = 0; t < pieces.size(); ++t) {
    const Eigen::Vector3d own = normal(t);
    bool flat = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const int node = pieces.corners(t)[k];
      Eigen::Vector3d sum = angle(t, k) * own;
      for (const int other : pieces.neighbours(t)) {
        const CornerNodes& corners = pieces.corners(other);
        const auto place = std::find(corners.begin(), corners.end(), node);
        if (place == corners.end()) continue;
        const Eigen::Vector3d n = normal(other);
        sum += std::copysign(angle(other, static_cast<std::size_t>(place - corners.begin())), n.dot(own)) * n;
      }
      sum.normalize();
      flat = flat && sum.dot(own) > (1.0 - kFlatPiece) * own.norm();
      normals_[t].col(static_cast<Eigen::Index>(k)) = sum;
    }
    flat_[t] = flat;
  }
}

}  // namespace footfall

// Corners, and four points of each round edge.
#include "mbd_solver/scene/shape_outline.h"

#include <array>

namespace footfall {
namespace {

using Eigen::Vector3d;

// Any two unit vectors that are perpendicular to the axis and to each other.
std::array<Vector3d, 2> across(const Vector3d& axis) {
  const Vector3d x = axis.unitOrthogonal();
  return {x, axis.normalized().cross(x)};
}

}  // namespace

std::vector<Vector3d> shape_outline(const BodySpec& body) {
  std::vector<Vector3d> out;
  if (!body.shape) return out;
  const ShapeSpec& s = *body.shape;
  const auto ring = [&](const Vector3d& centre, const Vector3d& axis, double radius) {
    for (const Vector3d& e : across(axis))
      for (const double side : {-radius, radius}) out.push_back(centre + side * e);
  };
  switch (s.kind) {
    case ShapeKind::kBox:
      for (int k = 0; k < 8; ++k) {
        const Vector3d corner(k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5);
        out.push_back(s.centre + body.orientation * corner.cwiseProduct(s.size));
      }
      break;
    case ShapeKind::kCapsule: {
      const Vector3d end = 0.5 * s.diameter * (s.to - s.from).normalized();
      out = {s.from - end, s.to + end};
    }
      [[fallthrough]];
    case ShapeKind::kTube:
    case ShapeKind::kRod:
      for (const Vector3d& end : {s.from, s.to}) ring(end, s.to - s.from, 0.5 * s.diameter);
      break;
    case ShapeKind::kDisc:
    case ShapeKind::kCylinder: {
      const double half = 0.5 * (s.kind == ShapeKind::kDisc ? s.thickness : s.length);
      for (const double side : {-half, half}) ring(s.centre + side * s.axis.normalized(), s.axis, s.radius);
      break;
    }
    case ShapeKind::kDish:
      out.push_back(s.centre);
      ring(s.centre + s.depth * s.axis.normalized(), s.axis, s.radius);
      break;
    case ShapeKind::kSphere:
      for (int k = 0; k < 3; ++k)
        for (const double side : {-s.radius, s.radius}) out.push_back(s.centre + side * Vector3d::Unit(k));
      break;
    case ShapeKind::kPoints: out = s.points; break;
    case ShapeKind::kMesh: break;  // its file was read for the mass, and is not kept
  }
  return out;
}

}  // namespace footfall

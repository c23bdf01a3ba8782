// Centres of the spheres of each shape; volume and inertia of their union in closed form.
#include "mbd_solver/scene/clump_shape.h"

#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/codes.h"

namespace footfall {

namespace {

const double kApart = std::sqrt(3.0);  // of touching centres, over the radius

// Centres about their mean, for spheres of radius 1.
Eigen::Matrix3Xd unit_centres(ClumpShape shape) {
  const double d = kApart;
  const double corner = d / std::sqrt(3.0);  // of a triangle, from its middle
  const double t = d / std::sqrt(8.0), top = std::sqrt(6.0) / 3.0 * d, o = d / std::sqrt(2.0);
  Eigen::Matrix3Xd x;
  switch (shape) {
    case ClumpShape::kPair: x.setZero(3, 2), x.row(0) << -0.5 * d, 0.5 * d; break;
    case ClumpShape::kRod: x.setZero(3, 3), x.row(0) << -d, 0.0, d; break;
    case ClumpShape::kTriangle:
    case ClumpShape::kBipyramid:
      x.setZero(3, shape == ClumpShape::kTriangle ? 3 : 5);
      for (int k = 0; k < 3; ++k)
        x.col(k) << corner * std::cos(2.0 * kPi * k / 3.0), corner * std::sin(2.0 * kPi * k / 3.0), 0.0;
      if (shape == ClumpShape::kBipyramid) x(2, 3) = top, x(2, 4) = -top;
      break;
    case ClumpShape::kTetrahedron:
      x.resize(3, 4);
      x << t, t, -t, -t, t, -t, t, -t, t, -t, -t, t;
      break;
    case ClumpShape::kOctahedron:
      x.setZero(3, 6);
      for (int k = 0; k < 3; ++k) x(k, 2 * k) = o, x(k, 2 * k + 1) = -o;
      break;
  }
  return x;
}

// Of the lens in which two unit spheres overlap whose centres are 2 h apart: volume, and its second moments about its
// middle, along the line of the centres and across it.
//   V = 2 pi int_h^1 (1 - z^2) dz     along = 2 pi int_h^1 (z - h)^2 (1 - z^2) dz     across = pi/2 int_h^1 (1 - z^2)^2 dz
struct Lens {
  double volume, along, across;
};
Lens lens_of(double h) {
  const auto plain = [](double z) { return z - z * z * z / 3.0; };
  const auto first = [](double z) { return z * z / 2.0 - std::pow(z, 4) / 4.0; };
  const auto second = [](double z) { return z * z * z / 3.0 - std::pow(z, 5) / 5.0; };
  const auto squared = [](double z) { return z - 2.0 * z * z * z / 3.0 + std::pow(z, 5) / 5.0; };
  const double along = second(1.0) - second(h) - 2.0 * h * (first(1.0) - first(h)) + h * h * (plain(1.0) - plain(h));
  return {2.0 * kPi * (plain(1.0) - plain(h)), 2.0 * kPi * along, 0.5 * kPi * (squared(1.0) - squared(h))};
}

}  // namespace

Clump clump_of(ClumpShape shape, double equal_radius) {
  const Eigen::Matrix3Xd x = unit_centres(shape);
  const double sphere = 4.0 / 3.0 * kPi;
  Clump clump;
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    clump.volume += sphere;
    S += sphere * (Eigen::Matrix3d::Identity() / 5.0 + x.col(i) * x.col(i).transpose());
    for (Eigen::Index j = 0; j < i; ++j) {
      const Eigen::Vector3d apart = x.col(i) - x.col(j), middle = 0.5 * (x.col(i) + x.col(j));
      if (apart.norm() >= 2.0) continue;
      const Lens lens = lens_of(0.5 * apart.norm());
      const Eigen::Matrix3d along = apart.normalized() * apart.normalized().transpose();
      clump.volume -= lens.volume;
      S -= lens.across * (Eigen::Matrix3d::Identity() - along) + lens.along * along +
           lens.volume * middle * middle.transpose();
    }
  }
  const double scale = equal_radius * std::cbrt(sphere / clump.volume);  // radius of the spheres [m]
  clump.centres = scale * x;
  clump.radius = scale;
  clump.volume *= std::pow(scale, 3);
  clump.inertia = std::pow(scale, 5) * (S.trace() * Eigen::Matrix3d::Identity() - S);
  // Zeros by symmetry, which another compiler may miss by round-off: these numbers identify a cached bed.
  constexpr double kRoundOff = 1e-13;
  clump.centres = (clump.centres.array().abs() < kRoundOff * scale).select(0.0, clump.centres);
  clump.inertia = (clump.inertia.array().abs() < kRoundOff * clump.inertia.trace()).select(0.0, clump.inertia);
  return clump;
}

ClumpShape clump_shape(const std::string& name) {
  const std::vector<std::string> names = names_of<ClumpShape>();
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return static_cast<ClumpShape>(k);
  throw InputError(code::kUnknownClump, "unknown clump \"" + name + "\"." + known_names("clumps", name, names));
}

}  // namespace footfall

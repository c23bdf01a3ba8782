// Depth buffer with two fine pixels per pixel and direction; a pixel is the mean of its fine pixels.
#include "mbd_solver/bed/depth_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"

namespace footfall {
namespace {

constexpr int kFine = 2;  // fine pixels per pixel and direction, for smooth edges

// Light from behind the eye, above and to the left, and some from all directions.
double brightness(const Eigen::Vector3d& normal_E) {
  const Eigen::Vector3d light = Eigen::Vector3d(-0.45, 0.65, 0.61).normalized();
  return 0.40 + 0.60 * std::max(0.0, normal_E.dot(light));
}

}  // namespace

Eigen::Matrix3d eye_axes(double azimuth, double elevation) {
  const double ca = std::cos(azimuth), sa = std::sin(azimuth), ce = std::cos(elevation), se = std::sin(elevation);
  Eigen::Matrix3d R_EW;
  R_EW << -sa, ca, 0, -se * ca, -se * sa, ce, ce * ca, ce * sa, se;
  return R_EW;
}

DepthImage::DepthImage(const Eye& eye, int width) : eye_(eye), width_(width) {
  const Eigen::Vector2d size = eye.high_E - eye.low_E;
  FOOTFALL_DEMAND(width > 0 && size.minCoeff() > 0.0);
  height_ = std::max(1, static_cast<int>(std::lround(width * size(1) / size(0))));
  fine_width_ = kFine * width_;
  fine_height_ = kFine * height_;
  scale_ = fine_width_ / size(0);
  const auto points = static_cast<std::size_t>(fine_width_) * static_cast<std::size_t>(fine_height_);
  nearness_.assign(points, -std::numeric_limits<float>::infinity());
  colour_.assign(points, Colour{255, 255, 255});
}

Eigen::Vector3d DepthImage::to_picture(const Eigen::Vector3d& x_W) const {
  const Eigen::Vector3d x_E = eye_.R_EW * x_W;
  return {scale_ * (x_E(0) - eye_.low_E(0)), scale_ * (eye_.high_E(1) - x_E(1)), scale_ * x_E(2)};
}

void DepthImage::put(int column, int row, double nearness, const Eigen::Vector3d& normal_E, const Colour& colour) {
  const auto k =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(fine_width_) + static_cast<std::size_t>(column);
  if (static_cast<float>(nearness) <= nearness_[k]) return;
  nearness_[k] = static_cast<float>(nearness);
  const double light = brightness(normal_E);
  for (std::size_t c = 0; c < 3; ++c) colour_[k][c] = static_cast<std::uint8_t>(std::lround(light * colour[c]));
}

void DepthImage::sphere(const Eigen::Vector3d& x_W, double radius, const Colour& colour) {
  capsule(x_W, x_W, radius, colour);
}

// A capsule is the union of spheres at c(s) along its axis. Along the line of sight at p the one whose nearness
// z(s) + sqrt(r^2 - |p - c(s)|^2) is largest is seen; c(s) and z(s) are linear in s, so s follows from the foot of p on
// the axis in closed form.
void DepthImage::capsule(const Eigen::Vector3d& a_W, const Eigen::Vector3d& b_W, double radius, const Colour& colour) {
  const Eigen::Vector3d a = to_picture(a_W), b = to_picture(b_W), along = b - a;
  const double r = scale_ * radius, flat2 = along.head<2>().squaredNorm(), length2 = along.squaredNorm();
  const int first_column = std::max(0, static_cast<int>(std::floor(std::min(a(0), b(0)) - r)));
  const int last_column = std::min(fine_width_ - 1, static_cast<int>(std::ceil(std::max(a(0), b(0)) + r)));
  const int first_row = std::max(0, static_cast<int>(std::floor(std::min(a(1), b(1)) - r)));
  const int last_row = std::min(fine_height_ - 1, static_cast<int>(std::ceil(std::max(a(1), b(1)) + r)));
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column) {
      const Eigen::Vector2d p(column + 0.5, row + 0.5);
      double s = 0.0;
      if (flat2 > 0.0) {
        const double foot = (p - a.head<2>()).dot(along.head<2>()) / flat2;
        const double aside2 = std::max(0.0, (p - a.head<2>()).squaredNorm() - foot * foot * flat2);
        if (aside2 > r * r) continue;
        s = foot + along(2) * std::sqrt((r * r - aside2) / (length2 * flat2));
      } else if (along(2) > 0.0) {
        s = 1.0;
      }
      const Eigen::Vector3d centre = a + std::clamp(s, 0.0, 1.0) * along;
      const Eigen::Vector2d d = p - centre.head<2>();
      const double rest = r * r - d.squaredNorm();
      if (rest < 0.0) continue;
      const double depth = std::sqrt(rest);
      put(column, row, centre(2) + depth, Eigen::Vector3d(d(0), -d(1), depth) / r, colour);
    }
}

void DepthImage::triangle(const Eigen::Vector3d& a_W, const Eigen::Vector3d& b_W, const Eigen::Vector3d& c_W,
                          const Colour& colour, double lift) {
  const Eigen::Vector3d a = to_picture(a_W), u = to_picture(b_W) - a, v = to_picture(c_W) - a;
  const double area = u(0) * v(1) - u(1) * v(0);
  if (std::abs(area) < 1e-9) return;  // seen from its edge
  Eigen::Vector3d normal = u.cross(v).normalized();
  if (normal(2) < 0.0) normal = -normal;
  normal(1) = -normal(1);  // rows count downwards
  const double low_x = std::min({0.0, u(0), v(0)}), high_x = std::max({0.0, u(0), v(0)});
  const double low_y = std::min({0.0, u(1), v(1)}), high_y = std::max({0.0, u(1), v(1)});
  const int first_column = std::max(0, static_cast<int>(std::floor(a(0) + low_x)));
  const int last_column = std::min(fine_width_ - 1, static_cast<int>(std::ceil(a(0) + high_x)));
  const int first_row = std::max(0, static_cast<int>(std::floor(a(1) + low_y)));
  const int last_row = std::min(fine_height_ - 1, static_cast<int>(std::ceil(a(1) + high_y)));
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column) {
      const double x = column + 0.5 - a(0), y = row + 0.5 - a(1);
      const double s = (x * v(1) - y * v(0)) / area, t = (u(0) * y - u(1) * x) / area;
      if (s < 0.0 || t < 0.0 || s + t > 1.0) continue;
      put(column, row, a(2) + s * u(2) + t * v(2) + scale_ * lift, normal, colour);
    }
}

Colour DepthImage::pixel(int column, int row) const {
  Colour mean{};
  for (std::size_t c = 0; c < 3; ++c) {
    int sum = 0;
    for (int j = 0; j < kFine; ++j)
      for (int i = 0; i < kFine; ++i)
        sum += colour_[static_cast<std::size_t>(kFine * row + j) * static_cast<std::size_t>(fine_width_) +
                       static_cast<std::size_t>(kFine * column + i)][c];
    mean[c] = static_cast<std::uint8_t>(sum / (kFine * kFine));
  }
  return mean;
}

void DepthImage::write(const std::string& path) const {
  std::string bytes;
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column)
      for (const std::uint8_t value : pixel(column, row)) bytes += static_cast<char>(value);
  write_whole_file(path, bytes, "is the disk full?");
}

}  // namespace footfall

#pragma once
// A small software renderer of spheres, capsules and triangles in parallel projection: each point of the picture shows
// what is nearest to the eye, whatever the order of drawing. It needs neither screen nor graphics library.

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace footfall {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

// Where the eye is. Rows of R_EW: to the right of the picture, up in it, towards the eye.
struct Eye {
  Eigen::Matrix3d R_EW;
  Eigen::Vector2d low_E, high_E;  // corners of the picture: lower left, upper right [m]
};

// Eye at `azimuth` about z from +x, `elevation` above the horizon [rad]; z is up in the picture.
Eigen::Matrix3d eye_axes(double azimuth, double elevation);

class DepthImage {
 public:
  // `width` in pixels; the height follows from the eye's corners. The background is white.
  DepthImage(const Eye& eye, int width);

  // Points in the inertial frame [m]. Parts outside the picture are cut off.
  void sphere(const Eigen::Vector3d& x_W, double radius, const Colour& colour);
  void capsule(const Eigen::Vector3d& a_W, const Eigen::Vector3d& b_W, double radius, const Colour& colour);
  // Both sides are lit. It counts as nearer to the eye by `lift` [m], so that a plate without thickness covers the grains
  // that overlap it.
  void triangle(const Eigen::Vector3d& a_W, const Eigen::Vector3d& b_W, const Eigen::Vector3d& c_W,
                const Colour& colour, double lift = 0.0);

  int width() const { return width_; }
  int height() const { return height_; }
  Colour pixel(int column, int row) const;  // mean of its fine pixels; row 0 is the uppermost
  // Bytes red, green, blue, rows from top to bottom. Throws InputError when the file cannot be written.
  void write(const std::string& path) const;

 private:
  Eigen::Vector3d to_picture(const Eigen::Vector3d& x_W) const;  // column, row, nearness, all in fine pixels
  void put(int column, int row, double nearness, const Eigen::Vector3d& normal_E, const Colour& colour);

  Eye eye_;
  int width_, height_, fine_width_, fine_height_;
  double scale_;  // fine pixels per m
  std::vector<float> nearness_;
  std::vector<Colour> colour_;
};

}  // namespace footfall

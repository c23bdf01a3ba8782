// Moments of the changes. Motion that is nearly one-sided (a glide, a decay) determines no spring: x and v change alike.

#include "mbd_solver/session/observe/spring_fit.h"

namespace footfall {
namespace {

constexpr double kMemory = 0.9;           // of a moment, from sample to sample
constexpr double kExplained = 0.9;        // least part of the changes of the force
constexpr double kIndependent = 0.02;     // least 1 - (correlation of dx and dv)^2
constexpr double kRoundOffOfFit = 1e-20;  // of squares, relative
constexpr int kFewestSamples = 12;

}  // namespace

std::optional<SpringAndDamper> SpringFit::add(double x, double v, double F) {
  const Eigen::Vector3d now(x, v, F), change = now - last_;
  const Eigen::Vector3d size = now.cwiseAbs() + last_.cwiseAbs();
  last_ = now;
  if (++count_ < 2) return std::nullopt;
  moments_ = kMemory * moments_ + change * change.transpose();
  if (count_ < kFewestSamples || change[2] * change[2] <= kRoundOffOfFit * size[2] * size[2]) return std::nullopt;
  const Eigen::Matrix2d motion = moments_.topLeftCorner<2, 2>();
  const Eigen::Vector2d answer = moments_.topRightCorner<2, 1>();
  const double determinant = motion(0, 0) * motion(1, 1) - motion(0, 1) * motion(1, 0);
  if (!(determinant > kIndependent * motion(0, 0) * motion(1, 1))) return std::nullopt;
  const Eigen::Vector2d slope(motion(1, 1) * answer[0] - motion(0, 1) * answer[1],
                              motion(0, 0) * answer[1] - motion(1, 0) * answer[0]);
  if (slope.dot(answer) < kExplained * moments_(2, 2) * determinant) return std::nullopt;
  return SpringAndDamper{-slope[0] / determinant, -slope[1] / determinant};
}

}  // namespace footfall

#pragma once
// Whether a force that another program computes answers the motion as a spring with a damper does:
//   dF = -k dx - d dv
// for changes from sample to sample, by least squares, older samples forgotten.

#include <Eigen/Dense>
#include <optional>

namespace footfall {

struct SpringAndDamper {
  double k = 0.0;  // [N/m] or [N m/rad]
  double d = 0.0;  // [N s/m] or [N m s/rad]
};

class SpringFit {
 public:
  // Of the displacement x, the velocity v and the force F at a sample. Nothing until motion and force determine both numbers well.
  std::optional<SpringAndDamper> add(double x, double v, double F);

 private:
  Eigen::Vector3d last_ = Eigen::Vector3d::Zero();     // x, v, F
  Eigen::Matrix3d moments_ = Eigen::Matrix3d::Zero();  // of their changes
  int count_ = 0;                                      // samples
};

}  // namespace footfall

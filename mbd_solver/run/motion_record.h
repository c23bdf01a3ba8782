#pragma once
// How the surfaces that touch grains moved, window by window, so that a run's bed can be made again without the mechanism
// (footfall compare): DIR/motion/BODY.csv and BODY.stl.

#include <memory>
#include <string>
#include <vector>

#include "mbd_solver/output/history.h"
#include "mbd_solver/run/simulation.h"

namespace footfall {

// The rigid motion that brings points nearest to others: x ~ centre + R (x0 - centre0), least squares over all points.
struct RigidFit {
  Eigen::Vector3d centre0, centre;  // mean of the points before and after [m]
  Eigen::Matrix3d R;
  double left_over;                 // largest distance that remains: how far the surface is bent [m]
};
RigidFit fit_rigid(const Eigen::Matrix3Xd& x0, const Eigen::Matrix3Xd& x);

// Of every body with triangles that LIGGGHTS asked for. BODY.stl: its surface at the start, in W. BODY.csv, a row per window:
//   time; x y z of the mean of its nodes; rotation since the start as a vector rx ry rz (axis times angle, in W); bend: how far the farthest
//   node is from where that rigid motion puts it; fx fy fz: mean force of the grains in the window that ends then, ON the body.
class MotionRecord {
 public:
  // Makes the folder. Throws InputError when it cannot be written.
  MotionRecord(Simulation& simulation, const std::string& folder);
  void write(const Sample& sample);
  void flush();

 private:
  struct Surface {
    const BodyBoundary* boundary;
    Eigen::Index q;       // of the body in State::q
    Eigen::Matrix3Xd x0;  // nodes at the start [m]
    std::unique_ptr<HistoryWriter> file;
  };
  Eigen::Matrix3Xd nodes(const Surface& surface, const State& state) const;

  std::vector<Surface> surfaces_;
};

}  // namespace footfall

#pragma once
// How the surfaces that touch grains moved, window by window, so that a run's bed can be made again without the
// mechanism (footfall compare): DIR/motion/BODY.csv and BODY.stl.

#include <memory>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/observe/sample.h"
#include "mbd_solver/output/history.h"

namespace footfall {

// The rigid motion that brings points nearest to others: x ~ centre + R (x0 - centre0), least squares over all points.
struct RigidFit {
  Eigen::Vector3d centre0, centre;  // mean of the points before and after [m]
  Eigen::Matrix3d R;
  double left_over;  // largest distance that remains: how far the surface is bent [m]
};
RigidFit fit_rigid(const Eigen::Matrix3Xd& x0, const Eigen::Matrix3Xd& x);

// Of every body with triangles that LIGGGHTS asked for. BODY.stl: its surface at the start, in W. BODY.csv, a row per
// window:
//   time; x y z of the mean of its nodes; rotation since the start as a vector rx ry rz (axis times angle, in W); bend:
//   how far the farthest node is from where that rigid motion puts it; fx fy fz: mean force of the grains in the window
//   that ends then, ON the body.
// The nodes are where the grains met them: at the end of a window that is the scheme's prediction, not yet the computed
// state.
class MotionRecord {
 public:
  // Of a coupled run; start: its kinematics then. Makes the folder. What the subject views must outlive this. Throws
  // InputError when the folder cannot be written.
  MotionRecord(const Subject& subject, const Kinematics& start, const std::string& folder,
               Beginning beginning = Beginning::kNew);
  void write(const Sample& sample);
  void flush();
  void visit(Archive& archive);

 private:
  struct Surface {
    const BodyBoundary* boundary;
    BodyMotion motion;     // computed, at the end of the last window
    BodyMotion predicted;  // by the scheme from there
    Eigen::Matrix3Xd x0;   // nodes at the start [m]
    Eigen::Matrix3Xd x;    // now
    std::unique_ptr<HistoryWriter> file;

    void visit(Archive& archive);
  };

  const Scheme& scheme_;
  double time_ = 0.0;  // of the last window's end [s]
  bool started_ = false;
  std::vector<Surface> surfaces_;
};

}  // namespace footfall

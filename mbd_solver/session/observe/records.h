#pragma once
// Records of coupled runs for other commands: momentum for `run --audit` (mechanism.csv), surface motion for `compare`
// (motion/BODY.csv and BODY.stl).

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/session/observe/sampler.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

// A row at the start and after every window, with 17 digits:
//   time, px, py, pz, size, mass, gx, gy, gz (gravity [m/s2]), free (1 or 0), reacts (1: scheme `tangent`, whose loads
//   move with the body within the window),
//   then per coupled body: NAME.fx .. fz, NAME.mx .. mz: mean force in W and moment about Bo in B over the window, as
//   applied by the integrator; NAME.received: work of the grains on it since the start [J]
class MomentumRecord {
 public:
  // The subject's parts must outlive this. Creates the folder. Throws InputError when the file cannot be written.
  MomentumRecord(const Subject& subject, const std::string& folder);
  void write(const Sample& sample);  // throws InputError likewise

 private:
  Subject subject_;
  std::string path_;
  std::ofstream file_;
};

// The rigid motion nearest to given displacements: x ~ centre + R (x0 - centre0), least squares over all points.
struct RigidFit {
  Eigen::Vector3d centre0, centre;  // mean of the points before and after [m]
  Eigen::Matrix3d R;
  double residual;  // largest remaining distance: deformation of the surface [m]
};
RigidFit fit_rigid(const Eigen::Matrix3Xd& x0, const Eigen::Matrix3Xd& x);

// The motion of every coupled body with triangles, window by window, so that a bed can be replayed without the mechanism:
// BODY.stl, its surface at the start, in W, and BODY.csv, a row per window:
//   time; x y z of the mean of its nodes; rotation since the start as a vector rx ry rz (axis times angle, in W); bend:
//   largest distance of a node from its place after that rigid motion; fx fy fz: mean force of the grains ON the body
//   over the window.
// Nodes are where the grains met them: at the end of a window that is the scheme's prediction, not yet the computed
// state.
class MotionRecord {
 public:
  // start: initial kinematics. Creates the folder. The subject's parts must outlive this. Throws InputError when the
  // folder cannot be written.
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

#pragma once
// What the mechanism got in every window, for `footfall audit`: FOLDER/mechanism.csv. Made only in coupled runs that are
// audited.

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/run/observe/sampler.h"
#include "mbd_solver/run/output/history.h"

namespace footfall {

// Of all bodies together, in W.
struct MomentumSum {
  double mass = 0.0;                                 // [kg]
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();  // sum of m v [N s]
  double size = 0.0;                                 // sum of |m v| [N s]
};
// Of flexible bodies node by node: sum of m_j (dr + w x A rho_j + A Phi_j da), rho_j = rho0_j + Phi_j a (theory 1.2).
MomentumSum momentum_of(const Model& model, const Kinematics& kinematics);

// Whether nothing outside of the mechanism but gravity and grains acts on it: no joint and no force element reaches the
// ground, and no force is applied.
bool is_free(const Model& model);

// A row at the start and after every window, with 17 digits:
//   time, px, py, pz, size, mass, gx, gy, gz (gravity [m/s2]), free (1 or 0), reacts (1: scheme `tangent`, whose loads
//   move with the body within the window),
//   then per coupled body: NAME.fx .. fz, NAME.mx .. mz: mean force in W and moment about Bo in B of the window that
//   ends then, as the integrator felt them; NAME.received: work of the grains on it since the start [J]
class MomentumRecord {
 public:
  // What the subject views must outlive this. Makes the folder. Throws InputError when the file cannot be written.
  MomentumRecord(const Subject& subject, const std::string& folder);
  void write(const Sample& sample);  // throws InputError likewise

 private:
  Subject subject_;
  std::string path_;
  std::ofstream file_;
};

// How the surfaces that touch grains moved, window by window, so that a run's bed can be made again without the
// mechanism (footfall compare): DIR/motion/BODY.csv and BODY.stl.

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

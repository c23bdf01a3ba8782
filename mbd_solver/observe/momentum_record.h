#pragma once
// What the mechanism got in every window, for `footfall audit`: FOLDER/mechanism.csv. Made only in coupled runs that are
// audited.

#include <fstream>
#include <string>

#include "mbd_solver/observe/sample.h"

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

}  // namespace footfall

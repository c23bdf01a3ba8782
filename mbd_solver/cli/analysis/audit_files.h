#pragma once
// The two files of an audited run, read back.

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

namespace footfall {

// One line of grains.csv (liggghts_fix/fix_couple_mbd_audit.h says what stands there).
struct AuditSource {
  std::string kind, name;
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   // [N s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  // [N m s]
  double force = 0.0, moment = 0.0;                   // integrals of the magnitudes [N s, N m s]
};

struct AuditWindow {
  long number = 0;
  double end = 0.0, length = 0.0;  // [s]
  double substeps = 0.0;
  int periodic = 0;  // directions: 1 x, 2 y, 4 z
  double count = 0.0;
  AuditSource state;                                 // at its end
  Eigen::Vector3d energy = Eigen::Vector3d::Zero();  // kinetic, m g . x [J], count; at its end
  std::vector<AuditSource> sources;

  // Throws InputError when there is none.
  const AuditSource& find(const std::string& kind, const std::string& name) const;
};

struct GrainsAudit {
  AuditSource start;
  Eigen::Vector3d start_energy = Eigen::Vector3d::Zero();
  double start_count = 0.0;
  std::vector<AuditWindow> windows;
};

struct MechanismLoad {
  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();  // mean of the window that ends here [N]
  Eigen::Vector3d T_B = Eigen::Vector3d::Zero();  // about Bo [N m]
  double received = 0.0;                          // work since the start [J]
};

struct MechanismRow {
  double time = 0.0;                                   // [s]
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  // [N s]
  double size = 0.0;                                   // sum of |m v| [N s]
  double mass = 0.0;                                   // [kg]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();   // [m/s2]
  std::map<std::string, MechanismLoad> loads;          // by body
};

struct MechanismAudit {
  bool free = false, reacts = false;
  std::vector<MechanismRow> rows;  // at the start, and after every window
};

// Both throw InputError "file:line: ...".
GrainsAudit read_grains_audit(const std::string& path);
MechanismAudit read_mechanism_audit(const std::string& path);

}  // namespace footfall

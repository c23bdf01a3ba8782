#pragma once
// footfall run --audit: does the momentum and energy that the grains lose agree with what mechanism, walls and gravity
// receive? From two files that both programs write: DIR/audit/grains.csv (fix couple/mbd, its audit) and mechanism.csv
// (session/observe/records.h).

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

#include "mbd_solver/app/run_command.h"
#include "mbd_solver/base/kinds.h"

namespace footfall {

// One line of grains.csv.
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
  int periodic = 0;                                  // directions: 1 x, 2 y, 4 z
  double tags = 0.0;                                 // summed over all grains
  AuditSource state;                                 // at its end
  Eigen::Vector3d energy = Eigen::Vector3d::Zero();  // kinetic, m g . x [J], number of grains; at its end
  std::vector<AuditSource> sources;

  // Throws InputError if there is none.
  const AuditSource& find(const std::string& kind, const std::string& name) const;
};

struct GrainsAudit {
  AuditSource start;
  Eigen::Vector3d start_energy = Eigen::Vector3d::Zero();
  double start_tags = 0.0;
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

enum class AuditVerdict {
  kHolds,
  kWrong,
  kNotExercised,  // nothing was exchanged
  kNotChecked,    // impossible; `note` gives the reason
  kReported       // a value without a bound
};
constexpr std::string_view name_of(AuditVerdict verdict) {
  return name_in(verdict, "holds", "WRONG", "nothing exchanged", "not checked", "reported");
}
// One line of the table: of all windows the one with the largest error relative to its bound.
struct AuditLine {
  std::string quantity;
  std::string unit;
  double defect = 0.0;    // in that window [unit]
  double flowed = 0.0;    // exchanged in that window [unit]
  double relative = 0.0;  // defect over flowed; 0 where nothing flowed
  double bound = 0.0;     // of `defect` [unit]
  long window = -1;       // -1: of the whole run
  AuditVerdict verdict = AuditVerdict::kNotExercised;
  std::string note;
};

// Largest error over the exchange between bodies and grains; round-off of the sums over all grains is added.
inline constexpr double kAuditBound = 1e-10;
// Of the momentum of the mechanism, which includes errors of time integration.
inline constexpr double kMechanismBound = 1e-6;

std::vector<AuditLine> audit_lines(const GrainsAudit& grains, const MechanismAudit& mechanism);

// As an aligned table with a summary in the last line.
std::string audit_table(const std::vector<AuditLine>& lines);
bool audit_holds(const std::vector<AuditLine>& lines);

// Runs the scene with recording for so many windows, or until run.until, and prints the table. Returns the exit code: 0 when
// every quantity holds, 1 when one does not; otherwise the code of the run. Throws InputError.
int audit_command(const RunArguments& run, int windows);

}  // namespace footfall

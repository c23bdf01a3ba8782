#pragma once
// Does what the grains lost agree with what mechanism, walls and gravity got? From the two files that both programs of an
// audited run write (liggghts_fix/fix_couple_mbd_audit.h, mbd_solver/observe/momentum_record.h). docs/audit.md.

#include <string>
#include <vector>

#include "mbd_solver/cli/analysis/audit_files.h"

namespace footfall {

enum class AuditVerdict {
  kHolds,
  kWrong,
  kNotExercised,  // nothing flowed
  kNotChecked,    // cannot be known; `note` says why
  kTold           // a figure without a bound
};
std::string verdict_text(AuditVerdict verdict);

// One line of the table: of all windows the one that is farthest out, measured by its own bound.
struct AuditLine {
  std::string quantity;
  std::string unit;
  double defect = 0.0;    // in that window [unit]
  double flowed = 0.0;    // what was exchanged in that window [unit]
  double relative = 0.0;  // defect over flowed; 0 where nothing flowed
  double bound = 0.0;     // of `defect` [unit]
  long window = -1;       // -1: of the whole run
  AuditVerdict verdict = AuditVerdict::kNotExercised;
  std::string note;
};

// Largest defect over what bodies and grains exchanged; round-off of the sums over all grains is added to it.
inline constexpr double kAuditBound = 1e-10;
// Of the momentum of the mechanism, which has the errors of its time integration as well.
inline constexpr double kMechanismBound = 1e-6;

// folder: that of the audit (grains.csv, mechanism.csv). Throws InputError when a file is missing or no such file.
std::vector<AuditLine> audit_lines(const std::string& folder);
std::vector<AuditLine> audit_lines(const GrainsAudit& grains, const MechanismAudit& mechanism);

// As a table for people; its last line says what it comes to.
std::string audit_table(const std::vector<AuditLine>& lines);
bool audit_holds(const std::vector<AuditLine>& lines);

}  // namespace footfall

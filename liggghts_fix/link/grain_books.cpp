// A row has the numbers of one rank; rows of all ranks are added in their order, so that every rank
// finds the same sums.

#include "liggghts_fix/link/grain_books.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/message_fields.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/number.h"

namespace footfall {
namespace {

// Numbers of a rank.
enum RankNumber : std::size_t {
  kGrains,
  kLost,
  kInserted,
  kLeft,
  kChanged,
  kLostMass,
  kAdded,
  kRemoved,
  kAddedMass,
  kRemovedMass,
  kFault,
  kFaultTime,
  kFaultTag,
  kFaultBody,
  kFaultSpeed,
  kFaultRadius,
  kOfTheRank
};

[[noreturn]] void stop_for(const GrainFault& fault, const std::string& body, double dt) {
  const std::string which = concat("t = ", ten_digits(fault.time), " s: grain ", fault.tag);
  const std::string name = "body \"" + body + "\"";
  if (fault.kind == GrainFault::kPassed)
    throw NumericalError(code::kGrainPassed, which, " has passed through the surface of ", name,
                         ": its contact was pressed in by more than its radius, ", fault.radius,
                         " m. Use stiffer grains, or smaller loads or speeds; a smaller time step if it is fast (",
                         number_text(fault.speed, 3), " m/s)");
  throw NumericalError(code::kGrainTooFast, which, " meets ", name, " at ", number_text(fault.speed, 3), " m/s, ",
                       number_text(fault.speed * dt, 3), " m in a time step, with a radius of ",
                       number_text(fault.radius, 3), " m: it may pass through without a contact. Use a time step of ",
                       number_text(0.1 * fault.radius / fault.speed, 2),
                       " s or less, or look for what makes the grain so fast");
}

}  // namespace

void GrainBooks::begin() {
  lost_here_ = 0.0;
  here_ = {};
}

void GrainBooks::changed(const GrainChanges& more) {
  here_.lost_mass += more.lost_mass;
  here_.added += more.added;
  here_.removed += more.removed;
  here_.added_mass += more.added_mass;
  here_.removed_mass += more.removed_mass;
  if (!counts_changes()) return;
  here_.inserted += more.inserted;
  here_.left += more.left;
  here_.changed += more.changed;
}

std::size_t GrainBooks::row_size() { return kOfTheRank; }

void GrainBooks::append_share(std::int64_t grains, std::vector<double>& row) {
  row.resize(row.size() + kOfTheRank, 0.0);
  double* const at = row.data() + row.size() - kOfTheRank;
  at[kGrains] = static_cast<double>(grains);
  at[kLost] = lost_here_;
  at[kInserted] = here_.inserted;
  at[kLeft] = here_.left;
  at[kChanged] = here_.changed;
  at[kLostMass] = here_.lost_mass;
  at[kAdded] = here_.added;
  at[kRemoved] = here_.removed;
  at[kAddedMass] = here_.added_mass;
  at[kRemovedMass] = here_.removed_mass;
  at[kFault] = fault_.kind;
  at[kFaultTime] = fault_.time;
  at[kFaultTag] = fault_.tag;
  at[kFaultBody] = fault_.body;
  at[kFaultSpeed] = fault_.speed;
  at[kFaultRadius] = fault_.radius;
  lost_here_ = 0.0;
  here_ = {};
  fault_ = {};
}

void GrainBooks::add_share(const double* row, const std::vector<std::string>& bodies, double dt) {
  grains_now_ += row[kGrains];
  lost_now_ += row[kLost];
  changes_.inserted += row[kInserted];
  changes_.left += row[kLeft];
  changes_.changed += row[kChanged];
  changes_.lost_mass += row[kLostMass];
  changes_.added += row[kAdded];
  changes_.removed += row[kRemoved];
  changes_.added_mass += row[kAddedMass];
  changes_.removed_mass += row[kRemovedMass];
  if (row[kFault] == 0.0) return;
  const auto body = static_cast<int>(std::lround(row[kFaultBody]));
  stop_for({static_cast<GrainFault::Kind>(std::lround(row[kFault])), row[kFaultTime],
            static_cast<int>(std::lround(row[kFaultTag])), body, row[kFaultSpeed], row[kFaultRadius]},
           bodies[body], dt);
}

void GrainBooks::finish_window(double time, Load& load) {
  const double grains = grains_now_, lost = lost_now_;
  grains_now_ = lost_now_ = 0.0;
  const bool first = lost_ == 0;
  if (lost > 0.0) lost_ += std::llround(lost);
  load.particles = std::llround(grains);
  load.lost = lost_;
  load.changes = changes_;
  if (lost <= 0.0 || outflow_) return;
  const double all = grains + static_cast<double>(lost_);
  const std::string what = concat("t = ", ten_digits(time), " s: ", lost_, " of ", ten_digits(all),
                                  " grains have left the box, and LIGGGHTS has lost them");
  if (static_cast<double>(lost_) > max_lost_ * all)
    throw NumericalError(code::kTooManyGrainsLost, what, "; a share of ", ten_digits(max_lost_),
                         " may. Give them more room (headroom and margin of [particles.box]; in a LIGGGHTS script the "
                         "region of create_box), or make the bed calmer; where grains are meant to leave, set "
                         "particles.outflow = true in the scene");
  if (first)
    load.warnings.push_back(with_code(code::kGrainsLost, what, " (reported once; total: grains_lost in the summary)"));
}

void GrainBooks::visit(Archive& archive) {
  archive("lost", lost_);
  archive("changes", changes_);
}

}  // namespace footfall

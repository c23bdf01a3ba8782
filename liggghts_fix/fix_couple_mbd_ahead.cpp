#include "liggghts_fix/fix_couple_mbd_ahead.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "domain.h"
#include "fix.h"
#include "modify.h"

namespace LAMMPS_NS {
namespace {

// What LIGGGHTS calls between the start of a step and the forces of fixes.
constexpr int kBetween =
    FixConst::POST_INTEGRATE | FixConst::PRE_EXCHANGE | FixConst::PRE_NEIGHBOR | FixConst::PRE_FORCE;

// Meshes hand themselves on and find their grains in pre_force, which waits for the motion with them, and so do walls;
// clumps forget the forces of the last step there, and take those of grains on each other up at the end of the step.
// Histories and properties look at grains alone.
constexpr std::array<std::string_view, 10> kKnown = {
    "mesh/surface",   "mesh/surface/stress", "mesh/surface/stress/servo",
    "neighlist/mesh", "contacthistory",      "contacthistory/mesh",
    "property/atom",  "wall/gran",           "wall/gran/beam",
    "multisphere"};

}  // namespace

std::string why_grains_wait(LAMMPS* lmp) {
  constexpr int kShrinkWrapped = 2;
  if (lmp->domain->box_change != 0 || lmp->domain->nonperiodic == kShrinkWrapped)
    return "a box that follows its content";
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    const Fix& fix = *lmp->modify->fix[i];
    if ((lmp->modify->fmask[i] & kBetween) != 0 && std::find(kKnown.begin(), kKnown.end(), fix.style) == kKnown.end())
      return std::string("fix ") + fix.id + " (" + fix.style + ")";
  }
  return "";
}

}  // namespace LAMMPS_NS

// Reads fixes, variables and grains of the script through LIGGGHTS' interfaces. Warnings go to mbd_solver, which prints
// them.

#include "liggghts_fix/couple/script_checks.h"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>

#include "atom.h"
#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "coupler/communicator.h"
#include "domain.h"
#include "fix.h"
#include "fix_gravity.h"
#include "fix_multisphere.h"
#include "fix_wall_gran.h"
#include "input.h"
#include "lammps.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/link/codes.h"
#include "modify.h"
#include "variable.h"

namespace LAMMPS_NS {
namespace {

namespace code = footfall::code;

// Checked properties of a grain, in this order.
enum Property { kRadius, kMass, kPlace, kVelocity, kProperties };
constexpr const char* kNames[kProperties] = {"radius", "mass", "position", "velocity"};

bool is_finite(const double* vector) {
  return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}
bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

bool is_good(const Atom& atom, int i, int property) {
  switch (static_cast<Property>(property)) {
    case kRadius: return atom.radius == nullptr || is_positive(atom.radius[i]);
    case kMass: return atom.rmass == nullptr || is_positive(atom.rmass[i]);
    case kPlace: return is_finite(atom.x[i]);
    case kVelocity: return is_finite(atom.v[i]);
    case kProperties: break;
  }
  return true;
}

// Hooks that LIGGGHTS calls between the start of a step and the forces of fixes.
constexpr int kBetween =
    FixConst::POST_INTEGRATE | FixConst::PRE_EXCHANGE | FixConst::PRE_NEIGHBOR | FixConst::PRE_FORCE;

// Styles with such hooks that allow the overlap. Meshes and walls exchange elements and find their grains in pre_force,
// which waits for the motion as well. Clumps clear the forces of the last step there, and collect the pair forces at the
// end of the step. Histories and properties depend on grains only; bed/follow decides at the end of a step.
constexpr std::array<std::string_view, 11> kAllowed = {
    "mesh/surface",   "mesh/surface/stress", "mesh/surface/stress/servo",
    "neighlist/mesh", "contacthistory",      "contacthistory/mesh",
    "property/atom",  "wall/gran",           "wall/gran/beam",
    "multisphere",    "bed/follow"};

}  // namespace

// --- Grains.

void warn_of_radius(LAMMPS* lmp, footfall::Start& script) {
  static char name[] = "radius";
  Variable& variables = *lmp->input->variable;
  const int at = variables.find(name);
  const Atom& atom = *lmp->atom;
  if (at < 0 || atom.radius == nullptr) return;
  const char* const text = variables.retrieve(name);
  char* end = nullptr;
  const double radius = text == nullptr ? 0.0 : footfall::read_number(text, &end);
  if (text == nullptr || *end != '\0' || !is_positive(radius)) return;
  // Maxima over the grains: has this radius, minus the smallest radius, the largest radius.
  constexpr double kSame = 1e-6;
  double found[3] = {0.0, -std::numeric_limits<double>::infinity(), 0.0};
  for (int i = 0; i < atom.nlocal; ++i) {
    if (std::abs(atom.radius[i] - radius) <= kSame * radius) found[0] = 1.0;
    found[1] = std::max(found[1], -atom.radius[i]);
    found[2] = std::max(found[2], atom.radius[i]);
  }
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, found, 3, MPI_DOUBLE, MPI_MAX, lmp->world), "MPI_Allreduce");
  if (found[0] > 0.0 || found[2] == 0.0) return;
  script.warnings.push_back(footfall::with_code(
      code::kRadiusDiffers, "the run has radius = ", footfall::number_text(radius),
      " m, but its grains have radii from ", footfall::number_text(-found[1]), " to ", footfall::number_text(found[2]),
      " m: the bed was made with another radius; make them equal unless this is intended"));
}

void check_grains(LAMMPS* lmp, const std::string& where) {
  const Atom& atom = *lmp->atom;
  // Lowest tag of a grain with a wrong value, for each property.
  constexpr int kNone = std::numeric_limits<int>::max();
  std::array<int, kProperties> bad;
  bad.fill(kNone);
  for (int i = 0; i < atom.nlocal; ++i)
    for (int property = 0; property < kProperties; ++property)
      if (!is_good(atom, i, property)) {
        int& tag = bad[property];
        tag = std::min(tag, static_cast<int>(atom.tag[i]));
      }
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, bad.data(), kProperties, MPI_INT, MPI_MIN, lmp->world),
                      "MPI_Allreduce");
  for (int property = 0; property < kProperties; ++property) {
    const int tag = bad[property];
    if (tag == kNone) continue;
    throw footfall::InputError(code::kGrainInvalid, where, "the ", kNames[property], " of grain ", tag, " is ",
                               property < kPlace ? "not a positive number" : "not finite",
                               ": check the command that creates or reads it (set, create_atoms, read_restart)");
  }
}

// --- Gravity, clumps, liquid.

// Sums up all fix gravity. Without any, integrated grains are weightless; for grains that are not integrated gravity has
// no meaning.
bool read_gravity(Modify& modify, footfall::Start& script) {
  bool grains_move = false, any = false;
  for (int i = 0; i < modify.nfix; ++i) {
    grains_move = grains_move || modify.fix[i]->time_integrate == 1;
    auto* gravity = dynamic_cast<FixGravity*>(modify.fix[i]);
    if (gravity == nullptr) continue;
    gravity->init();  // it may be defined after couple/mbd
    if (!footfall::gravity_is_constant(gravity)) {
      script.warnings.push_back(footfall::with_code(
          code::kGravityVaries, "fix ", gravity->id,
          " gravity depends on a variable: it is compared with the gravity of the scene at the start only"));
      return false;
    }
    Eigen::Vector3d g;
    gravity->get_gravity(g.data());
    script.gravity += g;
    any = true;
  }
  script.gravity_known = any || grains_move;
  return true;
}

Eigen::Vector3d gravity_now(Modify& modify) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < modify.nfix; ++i) {
    auto* gravity = dynamic_cast<FixGravity*>(modify.fix[i]);
    if (gravity == nullptr) continue;
    Eigen::Vector3d g;
    gravity->get_gravity(g.data());
    sum += g;
  }
  return sum;
}

void warn_of_clumps(Modify& modify, footfall::Start& script) {
  const Fix* clumps = nullptr;
  for (int i = 0; i < modify.nfix; ++i) {
    if (dynamic_cast<FixMultisphere*>(modify.fix[i]) != nullptr) clumps = modify.fix[i];
    if (clumps == nullptr || dynamic_cast<FixWallGran*>(modify.fix[i]) == nullptr) continue;
    script.warnings.push_back(footfall::with_code(
        code::kClumpsBeforeWall, "fix ", clumps->id, " (multisphere) is defined before fix ", modify.fix[i]->id,
        " (wall/gran): in the first half step of a run LIGGGHTS' clumps lack the forces of that wall, although the "
        "mechanism gets them; define fix multisphere after all walls"));
    return;
  }
}

void warn_of_spheres_at_rest(LAMMPS* lmp, footfall::Start& script) {
  const Modify& modify = *lmp->modify;
  FixMultisphere* clumps = nullptr;
  int moved = 0;  // group bits of other integrating fixes
  for (int i = 0; i < modify.nfix; ++i) {
    if (auto* one = dynamic_cast<FixMultisphere*>(modify.fix[i])) {
      clumps = one;
    } else if (modify.fix[i]->time_integrate == 1) {
      moved |= modify.fix[i]->groupbit;
    }
  }
  if (clumps == nullptr) return;
  // Without any clump, LIGGGHTS' belongs_to is meaningless for grains that existed before the fix.
  const Atom& atom = *lmp->atom;
  // Clumps; spheres that no other fix integrates; such spheres without a clump.
  long sums[3] = {clumps->n_body(), 0, 0};
  for (int i = 0; i < atom.nlocal; ++i) {
    if ((atom.mask[i] & moved) != 0) continue;
    ++sums[1];
    sums[2] += clumps->belongs_to(i) < 0 ? 1 : 0;
  }
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, sums, 3, MPI_LONG, MPI_SUM, lmp->world), "MPI_Allreduce");
  const long at_rest = sums[0] == 0 ? sums[1] : sums[2];
  if (at_rest == 0) return;
  script.warnings.push_back(
      footfall::with_code(code::kSpheresAtRest, "fix ", clumps->id, " (multisphere) integrates only clumps: ", at_rest,
                          " spheres belong to none and do not move; was the bed made without clumps?"));
}

void warn_of_liquid_on_walls(Modify& modify, footfall::Start& script) {
  bool dry = false, as_atom = false;
  for (int i = 0; i < modify.nfix; ++i) {
    auto* wall = dynamic_cast<FixWallGran*>(modify.fix[i]);
    if (wall == nullptr || std::strncmp(wall->style, "wall/gran", 9) != 0)
      continue;  // other styles have no contact model
    const std::string name = footfall::concat("fix ", wall->id, " (wall/gran)");
    if (!dry && wall->contact_match("cohesion", "washino/capillary/viscous")) {
      dry = true;
      script.warnings.push_back(footfall::with_code(
          code::kLiquidOnlyApart, name,
          " has cohesion washino/capillary/viscous: in LIGGGHTS its liquid attracts grains and walls only while they "
          "are apart, not while they touch; easo/capillary/viscous attracts in both states"));
    }
    if (!as_atom && std::strcmp(wall->style, "wall/gran") == 0 &&
        wall->contact_match("cohesion", "easo/capillary/viscous")) {
      as_atom = true;
      script.warnings.push_back(footfall::with_code(
          code::kLiquidWallVelocity, name,
          " has cohesion easo/capillary/viscous: at a distance LIGGGHTS uses the velocity of some atom for the wall, "
          "so that fluidViscosity has a wrong effect, and at primitive walls the run may end with a segmentation "
          "fault. Set fluidViscosity to 0 and use meshes, or beams (wall/gran/beam), which have the right velocity"));
    }
  }
}

// --- Overlap.

std::string overlap_obstacle(LAMMPS* lmp) {
  constexpr int kShrinkWrapped = 2;
  if (lmp->domain->box_change != 0 || lmp->domain->nonperiodic == kShrinkWrapped)
    return "a box that follows the grains";
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    const Fix& fix = *lmp->modify->fix[i];
    if ((lmp->modify->fmask[i] & kBetween) != 0 &&
        std::find(kAllowed.begin(), kAllowed.end(), fix.style) == kAllowed.end())
      return footfall::concat("fix ", fix.id, " (", fix.style, ")");
  }
  return "";
}

}  // namespace LAMMPS_NS

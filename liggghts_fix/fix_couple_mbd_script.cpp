#include "liggghts_fix/fix_couple_mbd_script.h"

#include <mpi.h>

#include <cstring>

#include "atom.h"
#include "coupler/communicator.h"
#include "fix_gravity.h"
#include "fix_multisphere.h"
#include "fix_wall_gran.h"
#include "lammps.h"
#include "liggghts_fix/liggghts_access.h"
#include "modify.h"

namespace LAMMPS_NS {

// The sum of all fix gravity; none at all is weightlessness for grains that move, and means nothing for grains that
// nothing moves.
bool read_gravity(Modify& modify, footfall::Start& script) {
  bool grains_move = false, any = false;
  for (int i = 0; i < modify.nfix; ++i) {
    grains_move = grains_move || modify.fix[i]->time_integrate == 1;
    auto* gravity = dynamic_cast<FixGravity*>(modify.fix[i]);
    if (gravity == nullptr) continue;
    gravity->init();  // it may stand behind us in the script
    if (!footfall::gravity_is_constant(gravity)) {
      script.warnings.push_back(
          std::string("fix ") + gravity->id +
          " gravity varies with a variable: it is held against the gravity of the scene at the start alone");
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
    script.warnings.push_back(
        std::string("fix ") + clumps->id + " (multisphere) stands before fix " + modify.fix[i]->id +
        " (wall/gran): in the first half step of a run LIGGGHTS' clumps do not feel a wall behind "
        "them, and the mechanism does; let fix multisphere stand behind all walls");
    return;
  }
}

void warn_of_still_spheres(LAMMPS* lmp, footfall::Start& script) {
  const Modify& modify = *lmp->modify;
  FixMultisphere* clumps = nullptr;
  int moved = 0;  // groups that another fix integrates
  for (int i = 0; i < modify.nfix; ++i) {
    if (auto* one = dynamic_cast<FixMultisphere*>(modify.fix[i])) {
      clumps = one;
    } else if (modify.fix[i]->time_integrate == 1) {
      moved |= modify.fix[i]->groupbit;
    }
  }
  if (clumps == nullptr) return;
  // Of grains that were there before it, LIGGGHTS' fix says nothing that is meant where there is no clump at all.
  const Atom& atom = *lmp->atom;
  long sums[3] = {clumps->n_body(), 0,
                  0};  // clumps; spheres that nothing else moves, and those of them that have no clump
  for (int i = 0; i < atom.nlocal; ++i) {
    if ((atom.mask[i] & moved) != 0) continue;
    ++sums[1];
    sums[2] += clumps->belongs_to(i) < 0 ? 1 : 0;
  }
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, sums, 3, MPI_LONG, MPI_SUM, lmp->world), "MPI_Allreduce");
  const long still = sums[0] == 0 ? sums[1] : sums[2];
  if (still == 0) return;
  script.warnings.push_back("fix " + std::string(clumps->id) +
                            " (multisphere) integrates clumps alone: " + std::to_string(still) +
                            " spheres belong to none and stand still; was the bed poured without clumps?");
}

void warn_of_liquid_on_walls(Modify& modify, footfall::Start& script) {
  bool dry = false, as_atom = false;
  for (int i = 0; i < modify.nfix; ++i) {
    auto* wall = dynamic_cast<FixWallGran*>(modify.fix[i]);
    if (wall == nullptr || std::strncmp(wall->style, "wall/gran", 9) != 0) continue;  // others have no contact model
    const std::string name = std::string("fix ") + wall->id + " (wall/gran)";
    if (!dry && wall->contact_match("cohesion", "washino/capillary/viscous")) {
      dry = true;
      script.warnings.push_back(name +
                                " has cohesion washino/capillary/viscous: in LIGGGHTS its liquid pulls grains "
                                "and bodies to each other while they are apart, and not while they touch; "
                                "easo/capillary/viscous pulls in both states");
    }
    if (!as_atom && std::strcmp(wall->style, "wall/gran") == 0 &&
        wall->contact_match("cohesion", "easo/capillary/viscous")) {
      as_atom = true;
      script.warnings.push_back(name +
                                " has cohesion easo/capillary/viscous: where its liquid is stretched LIGGGHTS takes "
                                "the velocity of some atom for that of the wall, so that fluidViscosity acts as if "
                                "the wall moved like it, and at primitive walls the run may end with a segmentation "
                                "fault. Set fluidViscosity to 0 and use meshes, or beams (wall/gran/beam), which have "
                                "the right velocity");
    }
  }
}

}  // namespace LAMMPS_NS

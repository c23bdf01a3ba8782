// At the end of every N-th step the ranks agree whether any grain is in the region; if so, the next step builds its
// neighbour lists anew and the grains are removed before, when contact histories are with the grains.

#include "liggghts_fix/couple/fix_remove_region.h"

#include <mpi.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/communicator.h"
#include "domain.h"
#include "liggghts_fix/link/codes.h"
#include "region.h"
#include "update.h"

namespace LAMMPS_NS {

FixRemoveRegion::FixRemoveRegion(LAMMPS* lmp_, int narg, char** arg)
    : Fix(lmp_, narg, arg), until_(std::numeric_limits<double>::infinity()) {
  nevery = 0;
  bool good = narg % 2 == 1;
  for (int i = 3; good && i + 1 < narg; i += 2) {
    if (std::strcmp(arg[i], "region") == 0) {
      region_ = domain->find_region(arg[i + 1]);
    } else if (std::strcmp(arg[i], "every") == 0) {
      nevery = std::atoi(arg[i + 1]);
    } else if (std::strcmp(arg[i], "from") == 0) {
      from_ = footfall::read_number(arg[i + 1], nullptr);
    } else if (std::strcmp(arg[i], "until") == 0) {
      until_ = footfall::read_number(arg[i + 1], nullptr);
    } else {
      good = false;
    }
  }
  if (!good || region_ < 0 || nevery <= 0)
    throw footfall::InputError(
        footfall::code::kSourceSyntax, "fix ", id,
        ": expected: fix ID all remove/region region REGION every N [from T] [until T], with a region of the script");
  restart_global = 1;
  force_reneighbor = 1;
  next_reneighbor = 0;
  vector_flag = 1;
  size_vector = 2;
  global_freq = 1;
}

int FixRemoveRegion::setmask() { return FixConst::END_OF_STEP | FixConst::PRE_EXCHANGE; }

void FixRemoveRegion::init() { next_reneighbor = 0; }

// At a checkpoint LIGGGHTS is set up at the end of a step, where a resumed run begins: both remove the grains in the region.
void FixRemoveRegion::setup(int) {
  if (update->ntimestep > 0) end_of_step();
}

bool FixRemoveRegion::is_here(int grain) const {
  const double* x = atom->x[grain];
  return (atom->mask[grain] & groupbit) != 0 && domain->regions[region_]->match(x[0], x[1], x[2]);
}

void FixRemoveRegion::end_of_step() {
  const double t = static_cast<double>(update->ntimestep) * update->dt;
  if (update->ntimestep % nevery != 0 || t < from_ || t > until_) return;
  int here = 0;
  for (int i = 0; i < atom->nlocal && here == 0; ++i) here = is_here(i) ? 1 : 0;
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, &here, 1, MPI_INT, MPI_MAX, world), "MPI_Allreduce");
  if (here != 0) next_reneighbor = update->ntimestep + 1;
}

void FixRemoveRegion::pre_exchange() {
  if (next_reneighbor != update->ntimestep) return;
  std::array<double, 2> removed = {0.0, 0.0};
  for (int i = 0; i < atom->nlocal;) {
    if (!is_here(i)) {
      ++i;
      continue;
    }
    removed[0] += 1.0;
    removed[1] += atom->rmass[i];
    atom->avec->copy(atom->nlocal - 1, i, 1);
    --atom->nlocal;
  }
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, removed.data(), 2, MPI_DOUBLE, MPI_SUM, world), "MPI_Allreduce");
  count_ += removed[0];
  mass_ += removed[1];
  atom->natoms -= static_cast<bigint>(removed[0]);
  if (atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
}

void FixRemoveRegion::write_restart(FILE* file) {
  const double state[2] = {count_, mass_};
  if (comm->me != 0) return;
  const int size = sizeof(state);
  std::fwrite(&size, sizeof(int), 1, file);
  std::fwrite(state, sizeof(double), 2, file);
}

void FixRemoveRegion::restart(char* buffer) {
  double state[2];
  std::memcpy(state, buffer, sizeof(state));
  count_ = state[0];
  mass_ = state[1];
}

}  // namespace LAMMPS_NS

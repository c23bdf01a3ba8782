// What fix wall/gran/beam tells of its beams: f_ID[...] of the last step.

#include <mpi.h>

#include <algorithm>

#include "coupler/communicator.h"
#include "liggghts_fix/dem_link.h"
#include "liggghts_fix/fix_wall_gran_beam.h"

namespace LAMMPS_NS {

double FixWallGranBeam::compute_vector(int n) {
  double mine = 0.0;
  for (const std::unique_ptr<Beam>& beam : beams_) {
    const footfall::GeneralizedForce& load = beam->load;
    if (n < 3) {
      mine += load.F_W[n];
    } else if (n < 6) {
      mine += load.T_W[n - 3] + link_.body(beam->body).pose().r.cross(load.F_W)[n - 3];
    } else if (n == 6) {
      mine += static_cast<double>(beam->contacts);
    } else {
      mine = std::max(mine, beam->overlap);
    }
  }
  return over_ranks(mine, n == 7);
}

double FixWallGranBeam::compute_array(int beam, int n) {
  const Beam& b = *beams_[static_cast<std::size_t>(beam)];
  const double mine = n < 3    ? b.load.F_W[n]
                      : n < 6  ? b.load.T_W[n - 3]
                      : n == 6 ? static_cast<double>(b.contacts)
                               : b.overlap;
  return over_ranks(mine, n == 7);
}

// Largest or sum over the ranks of LIGGGHTS.
double FixWallGranBeam::over_ranks(double mine, bool largest) const {
  double all = 0.0;
  footfall::check_mpi(MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, largest ? MPI_MAX : MPI_SUM, world), "MPI_Allreduce");
  return all;
}

}  // namespace LAMMPS_NS

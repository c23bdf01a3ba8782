#include "liggghts_fix/fix_couple_mbd_grains.h"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "atom.h"
#include "coupler/base/errors.h"
#include "coupler/mpi_check.h"
#include "lammps.h"

namespace LAMMPS_NS {
namespace {

// What a grain is checked for, in this order.
enum Property { kRadius, kMass, kPlace, kVelocity, kProperties };
constexpr const char* kNames[kProperties] = {"radius", "mass", "place", "velocity"};

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

}  // namespace

void check_grains(LAMMPS* lmp, const std::string& where) {
  const Atom& atom = *lmp->atom;
  // Of each property the lowest tag of a grain that is not good.
  constexpr int kNone = std::numeric_limits<int>::max();
  std::array<int, kProperties> bad;
  bad.fill(kNone);
  for (int i = 0; i < atom.nlocal; ++i)
    for (int property = 0; property < kProperties; ++property)
      if (!is_good(atom, i, property)) {
        int& tag = bad[static_cast<std::size_t>(property)];
        tag = std::min(tag, static_cast<int>(atom.tag[i]));
      }
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, bad.data(), kProperties, MPI_INT, MPI_MIN, lmp->world),
                      "MPI_Allreduce");
  for (int property = 0; property < kProperties; ++property) {
    const int tag = bad[static_cast<std::size_t>(property)];
    if (tag == kNone) continue;
    throw footfall::InputError(where + "the " + kNames[property] + " of grain " + std::to_string(tag) + " is " +
                               (property < kPlace ? "not a positive number" : "not finite") +
                               ": look at where the script makes or reads it (set, create_atoms, read_restart)");
  }
}

}  // namespace LAMMPS_NS

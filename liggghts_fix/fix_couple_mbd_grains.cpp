#include "liggghts_fix/fix_couple_mbd_grains.h"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "atom.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/communicator.h"
#include "input.h"
#include "lammps.h"
#include "variable.h"

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

void warn_of_radius(LAMMPS* lmp, footfall::Start& script) {
  static char name[] = "radius";
  Variable& variables = *lmp->input->variable;
  const int at = variables.find(name);
  const Atom& atom = *lmp->atom;
  if (at < 0 || atom.radius == nullptr) return;
  const char* const text = variables.retrieve(name);
  char* end = nullptr;
  const double radius = text == nullptr ? 0.0 : std::strtod(text, &end);
  if (text == nullptr || *end != '\0' || !is_positive(radius)) return;
  // Largest of: has it, minus the smallest radius, the largest.
  constexpr double kSame = 1e-6;
  double found[3] = {0.0, -std::numeric_limits<double>::infinity(), 0.0};
  for (int i = 0; i < atom.nlocal; ++i) {
    if (std::abs(atom.radius[i] - radius) <= kSame * radius) found[0] = 1.0;
    found[1] = std::max(found[1], -atom.radius[i]);
    found[2] = std::max(found[2], atom.radius[i]);
  }
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, found, 3, MPI_DOUBLE, MPI_MAX, lmp->world), "MPI_Allreduce");
  if (found[0] > 0.0 || found[2] == 0.0) return;
  script.warnings.push_back("the run says radius = " + footfall::number_text(radius) +
                            " m, but its grains have radii from " + footfall::number_text(-found[1]) + " to " +
                            footfall::number_text(found[2]) +
                            " m: the bed was poured under another radius; make them agree if this is not meant");
}

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

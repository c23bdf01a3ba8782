// Differences of sums over the grains of a rank are shares of the ranks, which the link adds up.

#include "liggghts_fix/couple/grain_changes.h"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "coupler/communicator.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

using footfall::GrainChanges;
using When = footfall::GrainChangeListener::When;

// Differences below this are round-off [of the sum].
constexpr double kRoundOff = 1e-12;

// Fixes that act before the exchange of grains, but neither insert nor delete any, or count these themselves.
constexpr std::array<std::string_view, 8> kHarmless = {"contacthistory", "contactproperty", "mesh/surface",
                                                       "multisphere",    "neighlist",       "property/",
                                                       "couple/mbd",     "bed/follow"};
struct Changer {
  std::string_view style;
  When when;
};
// Fixes that change grains elsewhere in a step.
constexpr std::array<Changer, 7> kChangers = {{{"adapt", When::kForces},
                                               {"move", When::kIntegration},
                                               {"momentum", When::kEnd},
                                               {"recenter", When::kIntegration},
                                               {"insert/stream", When::kEnd},
                                               {"insert/stream/predefined", When::kEnd},
                                               {"deform", When::kEnd}}};

bool begins(std::string_view style, std::string_view with) { return style.substr(0, with.size()) == with; }

GrainChanges changes(const GrainSum& before, const GrainSum& now) {
  GrainChanges difference;
  const double energy = now.energy - before.energy;
  if (std::abs(energy) <= kRoundOff * std::max(now.size, before.size) && now.count == before.count) return difference;
  (now.count > before.count   ? difference.inserted
   : now.count < before.count ? difference.left
                              : difference.changed) = energy;
  return difference;
}

}  // namespace

GrainChangeWatch::~GrainChangeWatch() { footfall::set_listener<GrainChangeListener>(lmp, nullptr); }

bool GrainChangeWatch::watches(Fix& fix, When when) {
  const std::string_view style = fix.style;
  ahead_ = when == When::kExchange ? 0.5 * update->dt : 0.0;
  if (when == When::kExchange)
    return std::none_of(kHarmless.begin(), kHarmless.end(), [&](std::string_view one) { return begins(style, one); });
  return std::any_of(kChangers.begin(), kChangers.end(),
                     [&](const Changer& one) { return one.when == when && style == one.style; });
}

bool GrainChangeWatch::any_watched() const {
  for (int i = 0; i < modify->nfix; ++i) {
    const std::string_view style = modify->fix[i]->style;
    const bool exchanges =
        (modify->fmask[i] & FixConst::PRE_EXCHANGE) != 0 &&
        std::none_of(kHarmless.begin(), kHarmless.end(), [&](std::string_view one) { return begins(style, one); });
    if (exchanges ||
        std::any_of(kChangers.begin(), kChangers.end(), [&](const Changer& one) { return style == one.style; }))
      return true;
  }
  return false;
}

void GrainChangeWatch::initialized() {
  footfall::set_listener<GrainChangeListener>(lmp, any_watched() ? this : nullptr);
  if (!at_end_) return;
  // Commands may also have moved grains to other ranks: only the sums over the ranks are compared.
  const GrainSum now = sum_of_grains(lmp, link_.script_gravity());
  std::array<double, 6> sums = {at_end_->energy, at_end_->size, static_cast<double>(at_end_->count),
                                now.energy,      now.size,      static_cast<double>(now.count)};
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, sums.data(), 6, MPI_DOUBLE, MPI_SUM, world), "MPI_Allreduce");
  at_end_ = now;
  int rank = 0;
  MPI_Comm_rank(world, &rank);
  if (rank == 0)
    link_.grains().changed(
        changes({sums[0], sums[1], 0.0, std::lround(sums[2])}, {sums[3], sums[4], 0.0, std::lround(sums[5])}));
}

void GrainChangeWatch::run_ended() {
  if (link_.grains().counts_changes()) at_end_ = sum_of_grains(lmp, link_.script_gravity());
}

GrainSum GrainChangeWatch::sum() const { return sum_of_grains(lmp, link_.script_gravity(), false, ahead_); }

void GrainChangeWatch::before() {
  if (link_.grains().counts_changes()) before_ = sum();
}

void GrainChangeWatch::after() {
  if (link_.grains().counts_changes()) link_.grains().changed(changes(before_, sum()));
}

}  // namespace LAMMPS_NS

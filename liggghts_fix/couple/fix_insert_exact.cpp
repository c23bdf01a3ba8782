// LIGGGHTS' own insertion does the work; only the number, the steps and the seeds are chosen here. The state of random
// generators is not kept in restart files, so every insertion sets them from seed and step.

#include "liggghts_fix/couple/fix_insert_exact.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "domain.h"
#include "fix_particledistribution_discrete.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/dem_link.h"
#include "random_park.h"
#include "region.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

constexpr double kRoundOffOfGrain = 1e-6;  // of a grain
constexpr int kLargestSeed = 800000000;

// Protected generators of others, by pointers to members of a derived class.
struct RegionGenerator : Region {
  static RanPark& of(Region& region) { return *(region.*(&RegionGenerator::random)); }
};
struct DistributionGenerator : FixParticledistributionDiscrete {
  static RanPark& of(FixParticledistributionDiscrete& fix) { return *(fix.*(&DistributionGenerator::random)); }
};

// A seed from others: splitmix64.
int mixed(std::uint64_t seed, std::uint64_t step, std::uint64_t stream) {
  std::uint64_t z = seed * 0x9e3779b97f4a7c15u + step * 0xbf58476d1ce4e5b9u + (stream + 1) * 0x94d049bb133111ebu;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return 1 + static_cast<int>(z % kLargestSeed);
}

}  // namespace

FixInsertExact::FixInsertExact(LAMMPS* lmp_, int narg, char** arg)
    : FixInsertRateRegion(lmp_, narg, arg), until_(std::numeric_limits<double>::infinity()) {
  for (; iarg < narg; iarg += 2) {
    const bool has_value = iarg + 1 < narg;
    if (has_value && std::strcmp(arg[iarg], "from") == 0) {
      from_ = footfall::read_number(arg[iarg + 1], nullptr);
    } else if (has_value && std::strcmp(arg[iarg], "until") == 0) {
      until_ = footfall::read_number(arg[iarg + 1], nullptr);
    } else {
      throw footfall::InputError(footfall::code::kSourceSyntax, "fix ", id, ": unexpected \"", arg[iarg],
                                 "\", expected the keywords of fix insert/rate/region, then from T and until T [s]");
    }
  }
  if (insert_every <= 0 || !(nflowrate > 0.0 || massflowrate > 0.0))
    throw footfall::InputError(footfall::code::kSourceSyntax, "fix ", id,
                               ": expected nparticles 1, a particlerate or massrate, and insert_every N");
  by_mass_ = massflowrate > 0.0;
  ninsert_exists = 0;  // no last grain
  first_seed_ = seed - comm->me;
  print_stats_during_flag = 0;
}

void FixInsertExact::init() {
  next_reneighbor = 0;  // the value of the script is not checked
  FixInsertRateRegion::init();
  // LIGGGHTS sets the other of its two rates in setup, where it refuses both.
  rate_ = by_mass_ ? massflowrate / fix_distribution->mass_expect() : nflowrate;
  next_reneighbor = next_insertion(update->ntimestep);
}

double FixInsertExact::come() const {
  return by_mass_ ? massinserted * rate_ / massflowrate : static_cast<double>(ninserted);
}

long FixInsertExact::due(bigint step) const {
  const double t = std::min(static_cast<double>(step) * update->dt, until_);
  const double more = std::max(0.0, rate_ * (t - from_)) - come() + kRoundOffOfGrain;
  return ninserted + static_cast<long>(std::floor(std::max(0.0, more)));
}

bigint FixInsertExact::next_insertion(bigint after) const {
  bigint step = (after / insert_every + 1) * insert_every;
  if (due(step) > ninserted) return step;
  // The first multiple of insert_every at which another grain is due.
  const double t = from_ + (come() + 1.0) / rate_;
  if (t > until_ + kRoundOffOfGrain / rate_) return 0;
  const double steps = (t - kRoundOffOfGrain / rate_) / (update->dt * insert_every);
  if (!(steps < 1e15)) return 0;
  const bigint at = static_cast<bigint>(std::ceil(steps)) * insert_every;
  return std::max(step, at);
}

int FixInsertExact::calc_ninsert_this() {
  FixInsertRateRegion::calc_ninsert_this();  // checks the region
  draw_anew();
  return static_cast<int>(due(update->ntimestep) - ninserted);
}

void FixInsertExact::draw_anew() {
  const auto step = static_cast<std::uint64_t>(update->ntimestep);
  const auto from = static_cast<std::uint64_t>(first_seed_);
  const int rank = comm->me;
  random->reset(mixed(from, step, 0) + rank);
  RegionGenerator::of(*ins_region).reset(mixed(from, step, 1) + rank);
  DistributionGenerator::of(*fix_distribution).reset(mixed(from, step, 2) + rank);
}

void FixInsertExact::pre_exchange() {
  if (next_reneighbor != update->ntimestep || most_recent_ins_step == update->ntimestep) return;
  const long wanted = due(update->ntimestep);
  FixInsertRateRegion::pre_exchange();
  const long late = wanted - ninserted;
  footfall::DemLink* const link = footfall::find_dem_link(lmp);
  if (late > 0 && !late_ && comm->me == 0 && link != nullptr) {
    late_ = true;
    link->window().warn(
        footfall::with_code(footfall::code::kNoSpaceForGrains,
                            "t = ", footfall::number_text(static_cast<double>(update->ntimestep) * update->dt),
                            " s: grain source ", id, ": ", late, " of ", wanted, " grains found no space in its region",
                            ins_region->id == std::string(id) ? "" : std::string(" ") + ins_region->id,
                            "; they come later, so that the flow is less than its rate. Move the region out of the "
                            "bed, enlarge it, or give new grains a velocity out of it"));
  }
  next_reneighbor = next_insertion(update->ntimestep);
}

void FixInsertExact::write_restart(FILE* file) {
  const double state[2] = {static_cast<double>(ninserted), massinserted};
  if (comm->me != 0) return;
  const int size = sizeof(state);
  std::fwrite(&size, sizeof(int), 1, file);
  std::fwrite(state, sizeof(double), 2, file);
}

void FixInsertExact::restart(char* buffer) {
  double state[2];
  std::memcpy(state, buffer, sizeof(state));
  ninserted = static_cast<int>(state[0]);
  massinserted = state[1];
}

}  // namespace LAMMPS_NS

// Grains are taken from the top and laid down from the lowest on, so that each finds its place on those before it.

#include "liggghts_fix/link/bed_exchange.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace footfall {
namespace {

constexpr double kMostPushed = 0.5;  // of the mass that comes
constexpr double kGap = 1e-6;        // over the radius: what neighbours remember of a contact ends

bool is_lower(const BedGrain& a, const BedGrain& b) { return a.x.z() != b.x.z() ? a.x.z() < b.x.z() : a.tag < b.tag; }

Eigen::Vector3d nearest_image(Eigen::Vector3d d, const Eigen::Vector2d& period) {
  for (int axis = 0; axis < 2; ++axis)
    if (period[axis] > 0.0) d[axis] = std::remainder(d[axis], period[axis]);
  return d;
}

bool is_pressed(const BedGrain& grain, const SlabChange& change, const std::vector<BedGrain>& coming) {
  return std::any_of(coming.begin(), coming.end(), [&](const BedGrain& other) {
    const double sum = grain.radius + other.radius, least = std::min(grain.radius, other.radius);
    const double along = std::remainder(grain.x[change.axis] - other.x[change.axis], change.period[change.axis]);
    return std::abs(along) < sum &&
           sum - nearest_image(grain.x - other.x, change.period).norm() > change.allowed_overlap * least;
  });
}

// Takes the uppermost grains that may be taken out of the list, as long as each brings the excess nearer to zero.
template <typename May>
std::vector<BedGrain> take(std::vector<BedGrain>& from, double& excess, double most, const May& may) {
  std::sort(from.begin(), from.end(), is_lower);
  std::vector<BedGrain> taken, left;
  for (auto grain = from.rbegin(); grain != from.rend(); ++grain) {
    const bool does = may(*grain) && grain->mass <= most && std::abs(excess) >= 0.5 * grain->mass;
    (does ? taken : left).push_back(*grain);
    if (!does) continue;
    most -= grain->mass;
    excess -= std::copysign(grain->mass, excess);
  }
  from = left;
  return taken;
}

// Down from above to the first grain that it meets, not below its place.
void lay_on_top(BedGrain& grain, const std::vector<BedGrain>& bed, const Eigen::Vector2d& period) {
  double height = grain.x.z();
  for (const BedGrain& other : bed) {
    const double sum = grain.radius + other.radius,
                 square = sum * sum - nearest_image(grain.x - other.x, period).head<2>().squaredNorm();
    if (square > 0.0) height = std::max(height, other.x.z() + std::sqrt(square));
  }
  grain.x.z() = height + kGap * grain.radius;
}

}  // namespace

BedExchange bed_exchange(const SlabChange& change) {
  const auto beyond = [&](const BedGrain& grain) {
    return change.way * std::remainder(grain.x[change.axis] - change.end, change.period[change.axis]);
  };
  // In the farther half of the room, so that none rolls over the end onto the new grains.
  const auto laid = [&](const BedGrain& grain) { return 0.5 * (change.room + std::abs(beyond(grain))); };
  const auto fits = [&](const BedGrain& grain) { return laid(grain) + grain.radius < change.room; };
  // Only grains at the two ends of the slab meet grains outside it.
  double comes = 0.0, first = 0.0, largest = 0.0;
  for (const BedGrain& grain : change.coming) {
    comes += grain.mass;
    first = std::min(first, beyond(grain));
    largest = std::max(largest, grain.radius);
  }
  for (const BedGrain& grain : change.beside) largest = std::max(largest, grain.radius);
  const auto is_at_end = [&](const BedGrain& grain) {
    const double place = beyond(grain), reach = 2.0 * largest;
    return std::abs(place) <= reach || std::abs(place - first) <= reach;
  };
  std::vector<BedGrain> coming, go = change.in_slab, stay, moved;
  std::copy_if(change.coming.begin(), change.coming.end(), std::back_inserter(coming), is_at_end);
  for (const BedGrain& grain : change.beside) {
    if (!is_at_end(grain) || !is_pressed(grain, change, coming)) {
      stay.push_back(grain);
    } else {
      (fits(grain) ? moved : go).push_back(grain);
    }
  }
  double excess = change.excess - comes;
  for (const BedGrain& grain : go) excess += grain.mass;
  const double most = kMostPushed * comes;
  if (excess > 0.0) {
    const auto may = [&](const BedGrain& grain) { return beyond(grain) <= 0.0 && fits(grain); };
    const std::vector<BedGrain> back = take(go, excess, most, may);
    moved.insert(moved.end(), back.begin(), back.end());
  } else {
    const auto may = [&](const BedGrain& grain) { return beyond(grain) > 0.0 && fits(grain); };
    const std::vector<BedGrain> more = take(stay, excess, most, may);
    go.insert(go.end(), more.begin(), more.end());
  }
  BedExchange exchange;
  for (const BedGrain& grain : go) exchange.removed.push_back(grain.tag);
  std::sort(exchange.removed.begin(), exchange.removed.end());
  stay.insert(stay.end(), change.coming.begin(), change.coming.end());
  std::sort(moved.begin(), moved.end(), is_lower);
  for (BedGrain& grain : moved) {
    grain.x[change.axis] += change.way * (laid(grain) - beyond(grain));
    lay_on_top(grain, stay, change.period);
    exchange.lifted.emplace(grain.tag, grain.x);
    stay.push_back(grain);
  }
  return exchange;
}

}  // namespace footfall

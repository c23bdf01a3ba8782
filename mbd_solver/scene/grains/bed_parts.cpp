// Zones as blocks, the volumes of parts by cells between all faces of blocks, and the words for LIGGGHTS.

#include "mbd_solver/scene/grains/bed_parts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/grains/grain_sizes.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPouredFraction = 0.61;  // assumed of the mass that is poured: as dense as equal grains become [-]
constexpr double kFilled = 0.28,
                 kFilledByClumps = 0.14;  // share of the space by poured grains; next to walls there are none [-]
constexpr double kSurplus = 0.1;          // poured above the surface, over the depth
constexpr double kSurplusRadii = 0.5;     // the same of a bed with zones, in radii of the largest grain

// Seeds of templates, primes as LIGGGHTS requires; grains of one radius do not depend on them.
constexpr int kPrimes[kMostKinds] = {15485867,  67867967,  86028121,  49979687,  104395301, 122949823,
                                     141650939, 160481183, 179424673, 198491317, 217645177, 236887691,
                                     250000013, 250000019, 250000073, 250000103, 250000117, 250000123,
                                     250000129, 250000139, 250000141, 250000189, 250000193, 250000211};

std::string in_digits(double value) { return number_text(value, 12); }

// Lowest and highest place of the surface under a block.
std::pair<double, double> surface_over(const Scene& scene, const Vector2d& low, const Vector2d& high) {
  constexpr int kPlaces = 8;
  const std::shared_ptr<Terrain> terrain = terrain_of(*scene.ground.terrain);
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (int i = 0; i <= kPlaces; ++i)
    for (int j = 0; j <= kPlaces; ++j) {
      const Vector2d p = low + (high - low).cwiseProduct(Vector2d(i, j)) / kPlaces;
      const double h = terrain->at(p.x(), p.y()).h;
      least = std::min(least, h);
      most = std::max(most, h);
    }
  return {least, most};
}

std::vector<double> faces(const std::vector<BedPart>& parts, const AlignedBox3d& bed, int axis) {
  std::vector<double> list = {bed.min()[axis], bed.max()[axis]};
  for (const BedPart& part : parts)
    for (const AlignedBox3d& block : part.blocks) {
      list.push_back(block.min()[axis]);
      list.push_back(block.max()[axis]);
    }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

// Speed at which the largest grain presses the smallest one on the floor by kPressed of its radius [m/s]: 1/2 m v^2 = 8/15 E* r^1/2 d^5/2.
double impact_limit(const BoxSpec& box) {
  constexpr double kPressed = 0.25;
  const GrainMaterialSpec& m = box.material;
  const double small = smallest_radius(box), mass = m.density * 4.0 / 3.0 * kPi * std::pow(largest_radius(box), 3);
  const double young = m.young / (2.0 * (1.0 - m.poisson * m.poisson));
  return std::sqrt(16.0 / 15.0 * young * std::sqrt(small) * std::pow(kPressed * small, 2.5) / mass);
}

// Each cell between faces belongs to the first part that has it, or to the rest.
void measure(std::vector<BedPart>& parts, const AlignedBox3d& bed) {
  const std::vector<double> x = faces(parts, bed, 0), y = faces(parts, bed, 1), z = faces(parts, bed, 2);
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t k = 0; k + 1 < z.size(); ++k) {
        const AlignedBox3d cell(Vector3d(x[i], y[j], z[k]), Vector3d(x[i + 1], y[j + 1], z[k + 1]));
        const auto owner = std::find_if(parts.begin(), parts.end() - 1, [&](const BedPart& part) {
          return std::any_of(part.blocks.begin(), part.blocks.end(),
                             [&](const AlignedBox3d& block) { return block.contains(cell.center()); });
        });
        owner->volume += cell.volume();
      }
}

std::string block_words(const AlignedBox3d& block) {
  std::string words = "block";
  for (int c = 0; c < 3; ++c) words += " " + in_digits(block.min()[c]) + " " + in_digits(block.max()[c]);
  return words + " units box";
}

void add_word(std::string& list, const std::string& words) { list += (list.empty() ? "'" : " '") + words + "'"; }

// The words of a template after its style, of each size and shape; their number of spheres and shares in the mass of their part.
struct GrainKind {
  std::string words;
  double share;
};
std::vector<GrainKind> kinds_of(const BoxSpec& box, const GrainSizesSpec& sizes, std::size_t first) {
  const std::string density = in_digits(box.material.density);
  std::vector<GrainKind> kinds;
  for (std::size_t i = 0; i < sizes.radius.size(); ++i) {
    const double share = share_of(sizes.shares, i, sizes.radius.size());
    for (std::size_t c = 0; c < std::max<std::size_t>(1, box.clumps.size()); ++c) {
      std::string words = std::to_string(kPrimes[first + kinds.size()]) + " atom_type 1 density constant " + density;
      if (box.clumps.empty()) {
        words += " radius constant " + in_digits(sizes.radius[i]);
        kinds.push_back({words, share});
        continue;
      }
      words += " " + clump_words(clump_of(clump_shape(box.clumps[c]), sizes.radius[i]), box.material.density) +
               " type " + std::to_string(first + kinds.size() + 1);
      kinds.push_back({words, share * share_of(box.clump_shares, c, box.clumps.size())});
    }
  }
  return kinds;
}

}  // namespace

bool has_parts(const BoxSpec& box) { return !box.zones.empty() || box.radius.size() > 2; }

std::vector<Vector2d> zone_places(const Scene& scene, const GrainZoneSpec& zone) {
  if (zone.centre.size() == 2) return {Vector2d(zone.centre[0], zone.centre[1])};
  const Eigen::Matrix3d R = rotation_from_rpy(0.0, 0.0, scene.initial.yaw);
  const Vector3d middle = mass_centre(scene);
  std::vector<Vector2d> places;
  for (const std::string& name : zone.under)
    if (const BodySpec* body = scene.body(name))
      places.emplace_back((middle + R * (body->position - middle) + scene.initial.position).head<2>());
  return places;
}

std::vector<BedPart> bed_parts(const Scene& scene, double floor, double top, bool terrain, double above) {
  const BoxSpec& box = *scene.particles->box;
  const Vector2d centre(box.centre[0], box.centre[1]), half = 0.5 * Vector2d(box.size[0], box.size[1]);
  AlignedBox3d bed(Vector3d(0.0, 0.0, floor), Vector3d(0.0, 0.0, top));
  bed.min().head<2>() = centre - half;
  bed.max().head<2>() = centre + half;
  std::vector<BedPart> parts;
  for (const GrainZoneSpec& zone : box.zones) {
    BedPart part{&zone, {}, 0.0};
    for (const Vector2d& place : zone_places(scene, zone)) {
      const Vector2d reach = 0.5 * Vector2d(zone.size[0], zone.size[1]);
      double low = 0.0, high = 0.0;
      if (terrain)
        std::tie(low, high) = surface_over(scene, (place - reach).cwiseMax(centre - half).cwiseMin(centre + half),
                                           (place + reach).cwiseMax(centre - half).cwiseMin(centre + half));
      AlignedBox3d block(Vector3d(0.0, 0.0, low - zone.depth), Vector3d(0.0, 0.0, high + above));
      block.min().head<2>() = place - reach;
      block.max().head<2>() = place + reach;
      const AlignedBox3d inside = block.intersection(bed);
      if (!inside.isEmpty() && inside.volume() > 0.0) part.blocks.push_back(inside);
    }
    parts.push_back(std::move(part));
  }
  parts.push_back({&box, {}, 0.0});
  measure(parts, bed);
  return parts;
}

double levelling_radius(const BoxSpec& box) {
  const GrainSizesSpec* finest = &box;
  for (const GrainZoneSpec& zone : box.zones)
    if (mean_radius(zone) < mean_radius(*finest)) finest = &zone;
  if (box.clumps.empty()) return mean_radius(*finest);
  double largest = 0.0;
  for (const double radius : finest->radius)
    for (const std::string& name : box.clumps) largest = std::max(largest, clump_of(clump_shape(name), radius).radius);
  return largest;
}

double grains_of_parts(const Scene& scene, double deep, double fraction) {
  double count = 0.0;
  for (const BedPart& part : bed_parts(scene, -deep, -levelling_radius(*scene.particles->box), false, 0.0))
    for (std::size_t i = 0; i < part.sizes->radius.size(); ++i)
      count += share_of(part.sizes->shares, i, part.sizes->radius.size()) * mixed_fraction(*part.sizes, fraction) *
               part.volume / (4.0 / 3.0 * kPi * std::pow(part.sizes->radius[i], 3));
  return count;
}

PouredBed poured_bed(const Scene& scene) {
  const BoxSpec& box = *scene.particles->box;
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  const double whole = (bed ? bed->high : 0.0) - box_floor(scene), largest = largest_radius(box);
  PouredBed poured{(1.0 + kSurplus) * whole, kPouredFraction, box.clumps.empty() ? kFilled : kFilledByClumps, 0.0};
  if (!has_parts(box)) return poured;
  if (!box.zones.empty()) poured.depth = whole + kSurplusRadii * largest;
  poured.fraction = mixed_fraction(box, kPouredFraction);
  for (const GrainZoneSpec& zone : box.zones)
    poured.fraction = std::max(poured.fraction, mixed_fraction(zone, kPouredFraction));
  if (!box.periodic) poured.filled *= (1.0 - 2.0 * largest / box.size[0]) * (1.0 - 2.0 * largest / box.size[1]);
  const double height = poured.depth * (poured.fraction / poured.filled - 1.0) + largest;
  const double limit = impact_limit(box);
  if (box.clumps.empty() && limit * limit < 2.0 * scene.gravity.norm() * height) poured.limit = limit;
  return poured;
}

double fall_time(const Scene& scene) {
  const PouredBed poured = poured_bed(scene);
  const double height = poured.depth * poured.fraction / poured.filled + box_floor(scene), g = scene.gravity.norm();
  return poured.limit > 0.0 ? height / poured.limit + poured.limit / g : std::sqrt(2.0 * height / g);
}

void add_parts(const Scene& scene, std::map<std::string, std::string>& variables) {
  const BoxSpec& box = *scene.particles->box;
  const PouredBed poured = poured_bed(scene);
  const double floor = box_floor(scene), stretch = poured.fraction / poured.filled;
  const bool terrain = terrain_bed(scene).has_value();
  const std::vector<BedPart> parts =
      bed_parts(scene, floor, floor + poured.depth, terrain, terrain ? 2.0 * levelling_radius(box) : poured.depth);
  std::string kinds, region_names, region_words, names, words, mixes, masses, outside;
  std::size_t kind = 0, block = 0, earlier = 0;
  const auto add_region = [&](const std::string& name, const std::string& what) {
    region_names += (region_names.empty() ? "" : " ") + name;
    add_word(region_words, what);
  };
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const BedPart& part = parts[k];
    const std::vector<GrainKind> own = kinds_of(box, *part.sizes, kind);
    std::string mix = std::to_string(own.size());
    for (const GrainKind& one : own) {
      add_word(kinds, one.words);
      mix += " kind_" + std::to_string(++kind) + " " + in_digits(one.share);
    }
    const std::string zone = "zone_" + std::to_string(k + 1);
    if (part.volume > 0.0) {
      const bool rest = k + 1 == parts.size();
      const std::string region = rest ? "soil" : "soil " + zone;
      const std::size_t count = (rest ? 1 : 2) + earlier;
      names += (names.empty() ? "" : " ") + std::string("part_") + std::to_string(k + 1);
      add_word(words, count == 1 ? "union 2 soil soil" : "intersect " + std::to_string(count) + " " + region + outside);
      add_word(mixes, mix);
      masses += (masses.empty() ? "" : " ") +
                in_digits(box.material.density * mixed_fraction(*part.sizes, kPouredFraction) * part.volume);
    }
    if (part.blocks.empty()) continue;
    std::string all;
    for (AlignedBox3d one : part.blocks) {
      one.min().z() = floor + stretch * (one.min().z() - floor);
      one.max().z() = floor + stretch * (one.max().z() - floor);
      const std::string name = "block_" + std::to_string(++block);
      add_region(name, block_words(one));
      all += " " + name;
    }
    if (part.blocks.size() == 1) all += all;  // a union has two members at least
    const std::string of = "union " + std::to_string(std::max<std::size_t>(2, part.blocks.size())) + all;
    add_region(zone, of);
    add_region("not_" + zone, of + " side out");
    outside += " not_" + zone;
    ++earlier;
  }
  variables["parts"] = "1";
  variables["kind_words"] = kinds;
  if (earlier > 0) {
    variables["zone_count"] = std::to_string(earlier);
    variables["region_names"] = region_names;
    variables["region_words"] = region_words;
  }
  variables["part_names"] = names;
  variables["part_words"] = words;
  variables["part_mixes"] = mixes;
  variables["part_masses"] = masses;
  variables["poured"] = in_digits(poured.depth);
  variables["fraction"] = in_digits(poured.fraction);
  variables["filled"] = in_digits(poured.filled);
  variables["level"] = in_digits(-levelling_radius(box));
}

double largest_at(const Scene& scene, const Vector3d& centre, double radius) {
  const BoxSpec& box = *scene.particles->box;
  const double rest = *std::max_element(box.radius.begin(), box.radius.end());
  for (const GrainZoneSpec& zone : box.zones) {
    const double own = *std::max_element(zone.radius.begin(), zone.radius.end());
    const std::shared_ptr<Terrain> terrain = terrain_of(*scene.ground.terrain);
    if (terrain->at(centre.x(), centre.y()).h - (centre.z() - radius) > zone.depth) continue;
    for (const Vector2d& place : zone_places(scene, zone)) {
      const Vector2d away = (centre.head<2>() - place).cwiseAbs();
      if (own < rest && away.x() + radius < 0.5 * zone.size[0] && away.y() + radius < 0.5 * zone.size[1]) return own;
    }
  }
  return rest;
}

}  // namespace footfall

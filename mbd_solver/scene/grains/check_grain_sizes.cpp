// What is wrong with sizes of grains and with zones: keys that exclude each other, counts, shares that are no whole, blocks that
// are not in the bed.

#include <algorithm>
#include <cmath>

#include "coupler/base/concat.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/grains/bed_parts.h"
#include "mbd_solver/scene/grains/grain_sizes.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;  // NOLINT: the codes of this module

namespace {

constexpr double kWhole = 1e-3;           // shares of a table sum up to 1 within this
constexpr double kWidestDeviation = 1.0;  // of ln(diameter)
constexpr std::size_t kMostZones = 8, kMostBlocks = 64;
constexpr double kLeastZone = 4.0, kLeastZoneDepth = 2.0;  // of a zone, over its largest radius

std::string count_text(std::size_t count) { return concat("has ", count, " numbers"); }

// "particles.box." and "particles.box.zones.0.": keys of one part of the bed.
class SizesCheck {
 public:
  SizesCheck(const EntryFindings& at, std::string prefix) : at_(at), prefix_(std::move(prefix)) {}

  // Without radii where there are findings.
  void resolve(GrainSizesSpec& sizes) const {
    const int before = at_.all().error_count();
    set_sizes(sizes);
    if (at_.all().error_count() > before) sizes.radius.clear();
  }

 private:
  void set_sizes(GrainSizesSpec& sizes) const {
    if (sizes.size_distribution && (given("radius") || given("shares"))) choose(sizes);
    if (sizes.size_distribution) {
      sizes.radius.clear();
      sizes.shares.clear();
      const int before = at_.all().error_count();
      if (!check(*sizes.size_distribution) || at_.all().error_count() > before) return;
      for (const GrainClass& one : classes_of(*sizes.size_distribution)) {
        sizes.radius.push_back(one.radius);
        sizes.shares.push_back(one.share);
      }
      return;
    }
    at_.missing_if(!given("radius"), prefix_ + "radius", "give the radius of the grains [m], or size_distribution");
    const std::size_t n = sizes.radius.size();
    at_.error_if(n > kMostSizes, kWrongCount, prefix_ + "radius", count_text(n), ", expected at most ", kMostSizes,
                 " radii, in m");
    at_.error_if(n > 0 && !sizes.shares.empty() && sizes.shares.size() != n, kWrongCount, prefix_ + "shares",
                 count_text(sizes.shares.size()), " and radius ", n, ", expected as many in each, or no shares");
  }

  bool given(const std::string& key) const { return at_.given(prefix_ + key); }
  bool is_set(const std::string& key) const {
    const std::string path = prefix_ + key;
    const auto& lines = at_.source().lines;
    return std::any_of(lines.begin(), lines.end(), [&](const auto& line) {
      return line.second == Source::kFromSet && (line.first == path || line.first.rfind(path + ".", 0) == 0);
    });
  }

  // Of radii and a distribution the one from --set counts.
  void choose(GrainSizesSpec& sizes) const {
    const bool distribution = is_set("size_distribution"), radius = is_set("radius");
    if (radius && !distribution) {
      sizes.size_distribution.reset();
    } else if (!distribution || radius) {
      at_.error(kConflictingKeys, prefix_ + "size_distribution", "excludes ", given("radius") ? "radius" : "shares",
                ", which follows from it; keep one of the two");
    }
  }

  // Strictly increasing sizes, at least `least` of them.
  bool check_diameters(const SizeDistributionSpec& d, std::size_t least, std::size_t most) const {
    const std::string key = prefix_ + "size_distribution.diameters";
    const std::size_t n = d.diameters.size();
    if (n < least || n > most) {
      at_.error(kSizeDistribution, key, count_text(n), ", expected ", least, " to ", most, " diameters in m");
      return false;
    }
    for (std::size_t k = 0; k + 1 < n; ++k)
      if (d.diameters[k + 1] <= d.diameters[k]) {
        at_.error(kSizeDistribution, key, "has ", d.diameters[k + 1], " after ", d.diameters[k],
                  " m, expected increasing diameters, each once");
        return false;
      }
    return true;
  }

  bool has_keys(const std::string& kind, const std::vector<std::string>& needed,
                const std::vector<std::string>& also) const {
    const std::string of = prefix_ + "size_distribution.";
    bool all = true;
    for (const std::string& key : needed) {
      at_.missing_if(!at_.given(of + key), of + key, "the kind \"", kind, "\" needs it");
      all = all && at_.source().good(of + key);
    }
    for (const char* key :
         {"diameters", "fractions", "passing", "median", "deviation", "finest", "coarsest", "classes"})
      at_.no_effect_if(at_.given(of + key) && !is_in(needed, key) && !is_in(also, key), of + key,
                       "the kind \"" + kind + "\"");
    return all;
  }

  // Whether all that its kind needs is there and was accepted by the reader.
  bool check(const SizeDistributionSpec& d) const {
    if (!at_.source().good(prefix_ + "size_distribution.kind")) {
      at_.missing_if(!given("size_distribution.kind") && !at_.all().has_errors(), prefix_ + "size_distribution.kind",
                     "give \"table\", \"lognormal\" or \"sieve\"");
      return false;
    }
    switch (d.kind) {
      case SizeDistributionKind::kTable: return check_table(d);
      case SizeDistributionKind::kLognormal: return check_lognormal(d);
      case SizeDistributionKind::kSieve: return check_sieve(d);
    }
    return false;
  }

  bool check_table(const SizeDistributionSpec& d) const {
    if (!has_keys("table", {"diameters", "fractions"}, {}) || !check_diameters(d, 1, kMostSizes)) return false;
    const std::string key = prefix_ + "size_distribution.fractions";
    if (d.fractions.size() != d.diameters.size()) {
      at_.error(kSizeDistribution, key, count_text(d.fractions.size()), " for ", d.diameters.size(),
                " diameters, expected one for each");
      return false;
    }
    double sum = 0.0;
    for (const double fraction : d.fractions) sum += fraction;
    at_.error_if(std::abs(sum - 1.0) > kWhole, kSizeDistribution, key, "sum up to ", number_text(sum, 4),
                 ", expected 1: the shares of the diameters in the mass");
    return true;
  }

  bool check_sieve(const SizeDistributionSpec& d) const {
    if (!has_keys("sieve", {"diameters", "passing"}, {}) || !check_diameters(d, 2, kMostSizes + 1)) return false;
    const std::string key = prefix_ + "size_distribution.passing";
    if (d.passing.size() != d.diameters.size()) {
      at_.error(kSizeDistribution, key, count_text(d.passing.size()), " for ", d.diameters.size(),
                " sieves, expected one for each");
      return false;
    }
    for (std::size_t k = 0; k + 1 < d.passing.size(); ++k)
      if (d.passing[k + 1] < d.passing[k]) {
        at_.error(kSizeDistribution, key, "has ", d.passing[k + 1], " after ", d.passing[k],
                  ", expected the share of the mass that passes each sieve, which does not fall from fine to coarse");
        return false;
      }
    at_.error_if(!(d.passing.back() > d.passing.front()), kSizeDistribution, key, "is ", d.passing.front(),
                 " for all sieves, so no grain lies between them; expected a curve that rises");
    return true;
  }

  bool check_lognormal(const SizeDistributionSpec& d) const {
    if (!has_keys("lognormal", {"median", "deviation"}, {"finest", "coarsest", "classes"})) return false;
    const std::string of = prefix_ + "size_distribution.";
    at_.error_if(d.deviation > kWidestDeviation, kSizeDistribution, of + "deviation", "is ", d.deviation,
                 ", expected at most 1: the standard deviation of the natural logarithm of the diameter, 0.3 if "
                 "most grains are within 30 % of the median");
    at_.error_if(d.classes > static_cast<int>(kMostSizes), kSizeDistribution, of + "classes", "is ", d.classes,
                 ", expected at most ", kMostSizes);
    const double finest = d.finest.value_or(0.0), coarsest = d.coarsest.value_or(HUGE_VAL);
    at_.error_if(finest >= d.median, kSizeDistribution, of + "finest", "is ", finest,
                 " m, expected less than the median, ", d.median, " m");
    at_.error_if(coarsest <= d.median, kSizeDistribution, of + "coarsest", "is ", coarsest,
                 " m, expected more than the median, ", d.median, " m");
    return true;
  }

  const EntryFindings& at_;
  std::string prefix_;
};

void check_zone(const Scene& scene, const EntryFindings& at, const GrainZoneSpec& zone, const std::string& key) {
  const BoxSpec& box = *scene.particles->box;
  if (zone.size.size() != 2) {
    at.error(kWrongCount, key + ".size", count_text(zone.size.size()), ", expected [along x, along y] in m");
    return;
  }
  at.missing_if(zone.under.empty() && !at.given(key + ".centre"), key + ".under",
                "name the bodies under which the zone lies, or give its centre = [x, y]");
  at.given_twice_if(!zone.under.empty() && !zone.centre.empty(), key + ".centre", "under");
  at.error_if(!zone.centre.empty() && zone.centre.size() != 2, kWrongCount, key + ".centre",
              count_text(zone.centre.size()), ", expected [x, y] in m");
  for (const std::string& name : zone.under)
    at.error_if(!scene.body(name), kUnknownBody, key + ".under", "unknown body \"", name, "\".",
                known_names("bodies", name, names_in(scene.bodies)));
  const double radius = *std::max_element(zone.radius.begin(), zone.radius.end());
  const double narrow = std::min(zone.size[0], zone.size[1]);
  at.error_if(narrow < kLeastZone * radius * (1.0 - 1e-9), kGrainZone, key + ".size", "is ", narrow,
              " m, expected at least four radii of its grains, ", kLeastZone * radius, " m");
  at.error_if(zone.depth < kLeastZoneDepth * radius * (1.0 - 1e-9), kGrainZone, key + ".depth", "is ", zone.depth,
              " m, expected at least two radii of its grains, ", kLeastZoneDepth * radius, " m");
  for (const Eigen::Vector2d& place : zone_places(scene, zone))
    for (int c = 0; c < 2; ++c) {
      const std::size_t k = c;
      const double away = std::abs(place[c] - box.centre[k]);
      if (away >= 0.5 * (box.size[k] + zone.size[k])) {
        at.error(kGrainZone, key + (zone.under.empty() ? ".centre" : ".under"), "lies at [", number_text(place.x(), 4),
                 ", ", number_text(place.y(), 4), "] m, outside the bed, which reaches from ",
                 number_text(box.centre[k] - 0.5 * box.size[k], 4), " to ",
                 number_text(box.centre[k] + 0.5 * box.size[k], 4), " m along ", "xy"[c],
                 "; move it, or make the bed larger");
        return;
      }
    }
}

}  // namespace

void resolve_grain_sizes(Scene& scene, Findings& findings) {
  BoxSpec& box = *scene.particles->box;
  const EntryFindings at(findings, scene.particles->source);
  SizesCheck(at, "box.").resolve(box);
  for (std::size_t k = 0; k < box.zones.size(); ++k) SizesCheck(at, concat("box.zones.", k, ".")).resolve(box.zones[k]);
  const std::size_t kinds = all_radii(box).size() * std::max<std::size_t>(1, box.clumps.size());
  if (kinds <= kMostKinds) return;
  box.radius.clear();
  at.error(kTooLarge, box.zones.empty() ? "box.clumps" : "box.zones", "make ", kinds,
           " kinds of grains of the bed, expected at most ", kMostKinds,
           ": radii of all its parts, times shapes of clumps");
}

void check_zones(const Scene& scene, const EntryFindings& at) {
  const BoxSpec& box = *scene.particles->box;
  const int before = at.all().error_count();
  at.error_if(box.zones.size() > kMostZones, kWrongCount, "box.zones", "has ", box.zones.size(),
              " entries, expected at most ", kMostZones);
  std::size_t blocks = 0;
  for (std::size_t k = 0; k < box.zones.size(); ++k) {
    check_zone(scene, at, box.zones[k], concat("box.zones.", k));
    blocks += std::max<std::size_t>(1, box.zones[k].under.size());
  }
  at.error_if(at.all().error_count() == before && blocks > kMostBlocks, kTooLarge, "box.zones", "have ", blocks,
              " blocks, expected at most ", kMostBlocks);
}

}  // namespace footfall

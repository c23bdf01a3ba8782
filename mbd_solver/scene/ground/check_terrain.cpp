// [ground.terrain]: a level or tilted one becomes the plane of the ground, a map is read, and what contradicts is reported.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;  // NOLINT: the codes of this module

namespace {

constexpr double kSteepestTerrain = 60.0;  // [degrees]
constexpr double kMostAbundance = 0.5;     // share of the area; the law ends far below
constexpr double kMostWaveRatio = 50.0;
constexpr double kMostRocks = 20000.0;
constexpr double kPi180 = kPi / 180.0;

void check_parts(const TerrainSpec& terrain, const EntryFindings& at) {
  at.error_if(!(std::abs(terrain.slope) <= kSteepestTerrain * kPi180), kOutOfRange, "terrain.slope", "is ",
              terrain.slope / kPi180, " degrees, expected at most ", kSteepestTerrain,
              ": heights are over a level plane; tilt gravity instead for steeper walls");
  if (terrain.roughness) {
    const RoughnessSpec& r = *terrain.roughness;
    at.error_if(!(r.longest > r.shortest), kOutOfRange, "terrain.roughness.longest", "is ", r.longest,
                " m, expected more than the shortest wavelength, ", r.shortest, " m");
    at.error_if(r.longest > kMostWaveRatio * r.shortest, kTerrain, "terrain.roughness.shortest", "is ", r.shortest,
                " m, expected at least ", number_text(r.longest / kMostWaveRatio, 3), " m, ", "1/", kMostWaveRatio,
                " of the longest wavelength; shorten that");
  }
  if (!terrain.rock_field) return;
  const RockFieldSpec& r = *terrain.rock_field;
  at.error_if(!(r.abundance <= kMostAbundance), kOutOfRange, "terrain.rock_field.abundance", "is ", r.abundance,
              ", expected a share of the area from 0 to ", kMostAbundance);
  at.error_if(!(r.largest > r.smallest), kOutOfRange, "terrain.rock_field.largest", "is ", r.largest,
              " m, expected more than the smallest diameter, ", r.smallest, " m");
  at.error_if(r.size.size() != 2, kTerrain, "terrain.rock_field.size", "has ", r.size.size(),
              " numbers, expected the lengths of the field along x and y [m]");
  if (!(r.largest > r.smallest) || r.size.size() != 2 || !(r.smallest > 0.0)) return;
  const double rocks = expected_rocks(r);
  at.error_if(!(rocks <= kMostRocks), kTerrain, "terrain.rock_field.smallest", "gives about ", number_text(rocks, 2),
              " rocks, expected at most ", kMostRocks, "; leave out the small ones, or make the field smaller");
}

}  // namespace

// Integral of -F'(D) / (pi D^2 / 4) over the diameters, by Simpson's rule over ln D.
double expected_rocks(const RockFieldSpec& field) {
  if (!(field.abundance > 0.0)) return 0.0;
  const double q = 1.79 + 0.152 / field.abundance;
  constexpr int kParts = 400;
  const double step = std::log(field.largest / field.smallest) / kParts;
  double sum = 0.0;
  for (int i = 0; i <= kParts; ++i) {
    const double D = field.smallest * std::exp(i * step);
    const double weight = i == 0 || i == kParts ? 1.0 : i % 2 ? 4.0 : 2.0;
    sum += weight * field.abundance * q * std::exp(-q * D) / (0.25 * kPi * D);
  }
  return sum * step / 3.0 * field.size[0] * field.size[1];
}

void resolve_terrain(Scene& scene, Findings& findings) {
  GroundSpec& ground = scene.ground;
  if (!ground.terrain) return;
  TerrainSpec& terrain = *ground.terrain;
  const EntryFindings at(findings, ground.source);
  const std::string used = ground.kind == GroundKind::kSoil ? "law." : "plane.";
  // A base or --set may give one of the two on purpose.
  const auto& lines = ground.source.lines;
  const bool here = std::any_of(lines.begin(), lines.end(), [](const auto& key_line) {
    return key_line.first.rfind("terrain", 0) == 0 && key_line.second > 0;
  });
  for (const std::string& key : {used + "point", used + "normal"})
    at.error_if(here && ground.source.given(key) && lines.at(key) > 0, kConflictingKeys, key,
                "is given by ground.terrain as well (position, slope and azimuth); keep one of the two");
  check_parts(terrain, at);
  if (terrain.map && at.source().good("terrain.map.file")) {
    try {
      std::error_code ignored;
      if (std::filesystem::is_regular_file(terrain.map->file, ignored))
        terrain.map->grid = read_height_map(*terrain.map);
    } catch (const InputError& error) {
      findings.coded_error(ground.source, "terrain.map.file", error.what());
    }
  }
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  if (terrain.is_plane())
    normal = {std::sin(terrain.slope) * std::cos(terrain.azimuth), std::sin(terrain.slope) * std::sin(terrain.azimuth),
              std::cos(terrain.slope)};
  if (ground.plane) {
    ground.plane->point = terrain.position;
    ground.plane->normal = normal;
  }
  if (ground.law) {
    ground.law->point = terrain.position;
    ground.law->normal = normal;
  }
  at.error_if(ground.kind == GroundKind::kSoil && (!terrain.rocks.empty() || terrain.rock_field) && !ground.plane,
              kGroundIncomplete, "plane",
              "is missing: rocks in a soil are rigid; give [ground.plane] with their contact law (young or stiffness, "
              "friction)");
  if (scene.touches_particles()) resolve_terrain_bed(scene, findings);
}

}  // namespace footfall

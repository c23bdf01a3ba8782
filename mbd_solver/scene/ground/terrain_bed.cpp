// A box of grains under a terrain: its floor is level, `depth` below the lowest place of the surface. The settled bed is cut to
// the surface by columns as wide as a grain; rocks are bodies that stand still, and no grain is within them.

#include <algorithm>
#include <cmath>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;  // NOLINT: the codes of this module

namespace {

constexpr double kMostColumns = 1600.0;  // of a bed; their heights are words of a command line
constexpr double kStandsRolling = 30.0;  // steepest slope of spheres with rolling friction, or clumps [degrees]
constexpr double kStandsSpheres = 22.0;  // of spheres without [degrees]
constexpr std::size_t kMostRockBodies = 40;

}  // namespace

std::optional<TerrainBed> terrain_bed(const Scene& scene) {
  if (!scene.ground.terrain || !scene.particles || !scene.particles->box || !scene.touches_particles())
    return std::nullopt;
  const BoxSpec& box = *scene.particles->box;
  const std::shared_ptr<Terrain> terrain = terrain_of(*scene.ground.terrain);
  const double largest = *std::max_element(box.radius.begin(), box.radius.end());
  const double wide = std::max(2.0 * largest, std::sqrt(box.size[0] * box.size[1] / kMostColumns));
  TerrainBed bed;
  bed.columns = std::max(1, static_cast<int>(box.size[0] / wide));
  bed.rows = std::max(1, static_cast<int>(box.size[1] / wide));
  const double dx = box.size[0] / bed.columns, dy = box.size[1] / bed.rows;
  bed.low = HUGE_VAL;
  bed.high = -HUGE_VAL;
  double sum = 0.0;
  for (int j = 0; j < bed.rows; ++j) {
    for (int i = 0; i < bed.columns; ++i) {
      const Eigen::Vector2d place(box.centre[0] + (i + 0.5) * dx - 0.5 * box.size[0],
                                  box.centre[1] + (j + 0.5) * dy - 0.5 * box.size[1]);
      const Terrain::Height here = terrain->at(place.x(), place.y());
      bed.heights.push_back(here.h);
      bed.low = std::min(bed.low, here.h);
      bed.high = std::max(bed.high, here.h);
      sum += here.h;
    }
  }
  bed.mean = sum / static_cast<double>(bed.heights.size());
  for (const Terrain::Sphere& rock : terrain->rocks()) {
    const Eigen::Vector2d away = rock.centre.head<2>() - Eigen::Vector2d(box.centre[0], box.centre[1]);
    if (std::abs(away.x()) < 0.5 * box.size[0] - rock.radius && std::abs(away.y()) < 0.5 * box.size[1] - rock.radius)
      bed.rocks.push_back(rock);
  }
  return bed;
}

double steepest_of_bed(const Scene& scene) {
  constexpr int kPlaces = 3;  // of a column along x and y
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  if (!bed) return 0.0;
  const BoxSpec& box = *scene.particles->box;
  const std::shared_ptr<Terrain> terrain = terrain_of(*scene.ground.terrain);
  const Eigen::Vector3d up = -scene.gravity.normalized();
  const int columns = kPlaces * bed->columns, rows = kPlaces * bed->rows;
  double least = 1.0;  // cosine
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Eigen::Vector2d slope = terrain
                                        ->at(box.centre[0] + ((i + 0.5) / columns - 0.5) * box.size[0],
                                             box.centre[1] + ((j + 0.5) / rows - 0.5) * box.size[1])
                                        .slope;
      least = std::min(least, Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized().dot(up));
    }
  }
  return std::acos(std::max(-1.0, least));
}

StandingSlope standing_slope(const BoxSpec& box) {
  const bool rolls = box.clumps.empty() && !(box.material.rolling_friction > 0.0);
  return {std::min(std::atan(box.material.friction) * 180.0 / kPi, rolls ? kStandsSpheres : kStandsRolling),
          concat("grains of friction ", box.material.friction, rolls ? " without rolling friction" : "")};
}

std::string rock_name(std::size_t k) { return concat("rock_", k + 1); }

std::string rock_joint_name(std::size_t k) { return rock_name(k) + "_in_the_ground"; }

double box_floor(const Scene& scene) {
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  return (bed ? bed->low : 0.0) - scene.particles->box->depth;
}

void resolve_terrain_bed(Scene& scene, Findings& findings) {
  const EntryFindings at(findings, scene.ground.source);
  if (!scene.particles) return;  // reported elsewhere
  if (!scene.particles->box) {
    at.error(kTerrain, "terrain",
             "shapes beds of [particles.box] only; a bed of a LIGGGHTS script has the shape that the script gives it");
    return;
  }
  const BoxSpec& box = *scene.particles->box;
  if (findings.has_errors() || box.size.size() != 2 || box.centre.size() != 2 || box.radius.empty()) return;
  const TerrainBed bed = *terrain_bed(scene);
  const StandingSlope stands = standing_slope(box);
  const double steepest = steepest_of_bed(scene) * 180.0 / kPi;
  at.error_if(steepest > stands.degrees, kTerrainSteep, "terrain", "is as steep as ", number_text(steepest, 3),
              " degrees against gravity within the bed, but ", stands.grains, " stand at most at ",
              number_text(stands.degrees, 3),
              " degrees (the least of atan(friction), 30 degrees, and 22 for spheres that roll); make it less steep, "
              "or the grains rougher");
  at.error_if(box.periodic, kTerrain, "terrain", "excludes particles.box.periodic = true: its ends would not fit");
  at.error_if(!box.follow.empty(), kTerrain, "terrain",
              "excludes particles.box.follow: the bed that follows is the same after each of its lengths; tilt gravity "
              "for a slope");
  at.error_if(!box.pit.empty(), kTerrain, "terrain",
              "excludes particles.box.pit, whose depth counts from z = 0; give the terrain a crater or a wave");
  at.error_if(bed.rocks.size() > kMostRockBodies, kTerrain, "terrain.rock_field", "puts ", bed.rocks.size(),
              " rocks into the bed, expected at most ", kMostRockBodies,
              ", as each is a body with a surface; leave out the small ones");
  if (findings.has_errors() || bed.rocks.empty()) return;
  // Rocks, as bodies that hang on the ground and stand still.
  const PlaneSpec* const law = scene.ground.plane ? &*scene.ground.plane : nullptr;
  std::vector<std::string> others;
  for (const BoundarySpec& boundary : scene.boundaries) others.push_back(boundary.body);
  if (!scene.initial.groups) scene.initial.groups.emplace();
  const bool still = scene.initial.groups->moving.empty();
  for (std::size_t k = 0; k < bed.rocks.size(); ++k) {
    const std::string name = rock_name(k);
    if (scene.body(name)) {
      at.error(kTerrain, "terrain", "makes a body \"", name, "\" of a rock, but the scene has one; rename that");
      return;
    }
    BodySpec body;
    body.source = scene.ground.source;
    body.name = name;
    const MassProperties sphere = with_mass(sphere_properties(bed.rocks[k].radius, 1.0), 1.0);  // it never moves
    body.mass = sphere.mass;
    body.inertia = sphere.inertia;
    body.position = bed.rocks[k].centre;
    body.shape.emplace();
    body.shape->kind = ShapeKind::kSphere;
    body.shape->radius = bed.rocks[k].radius;
    body.shape->centre = bed.rocks[k].centre;
    scene.bodies.push_back(std::move(body));
    JointSpec joint;
    joint.source = scene.ground.source;
    joint.source.lines["point"] = scene.ground.source.line_of("terrain");
    joint.name = rock_joint_name(k);
    joint.type = JointType::kFixed;
    joint.bodies = {"ground", name};
    joint.point_a = joint.point_b = bed.rocks[k].centre;
    scene.joints.push_back(std::move(joint));
    BoundarySpec boundary;
    boundary.source = scene.ground.source;
    boundary.body = name;
    boundary.surface.emplace();
    scene.boundaries.push_back(std::move(boundary));
    if (still) scene.initial.groups->still.push_back(name);
    for (const std::string& other : others) {
      ContactSpec contact;
      if (law) static_cast<ContactLawSpec&>(contact) = *law;
      contact.source = scene.ground.source;
      contact.between = {other, name};
      contact.ignore = law == nullptr;
      scene.contacts.push_back(std::move(contact));
    }
  }
  at.error_if(
      law == nullptr, kGroundIncomplete, "plane",
      "is missing: rocks in a bed are bodies that touch the mechanism; give [ground.plane] with their contact law");
}

}  // namespace footfall

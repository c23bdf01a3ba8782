#pragma once
// Parts of a bed by numbers: its zones, and all the rest. inputs/box/in.bed pours each part with its own grains.
//
// Grains are poured loosely, `stretch` times as high as they settle: what will lie at the height z of the settled bed is poured
// at floor + stretch (z - floor). The mass of a part follows from its volume in the settled bed.

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "mbd_solver/scene/box_spec.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Whether the bed has parts, or more than two radii: in.bed then gets lists.
bool has_parts(const BoxSpec& box);

// Middles of the blocks of a zone along x and y of W [m]. Names of unknown bodies are left out.
std::vector<Eigen::Vector2d> zone_places(const Scene& scene, const GrainZoneSpec& zone);

struct BedPart {
  const GrainSizesSpec* sizes;
  std::vector<Eigen::AlignedBox3d>
      blocks;     // of the settled bed in W [m]; the last part has what the others leave: none
  double volume;  // without what earlier parts have [m3]
};

// The zones in order and the rest of a bed between the heights floor and top [m], under the surface at z = 0. With `terrain`, under
// the terrain of the scene: blocks reach from the zone's depth below the lowest place above them to `above` [m] over the highest one.
std::vector<BedPart> bed_parts(const Scene& scene, double floor, double top, bool terrain, double above);

// Radius by which the surface is levelled [m]: the mean of the finest part, of clumps their largest sphere.
double levelling_radius(const BoxSpec& box);

// Number of grains of a bed that is `deep` to its mean surface, at this solid fraction of equal grains.
double grains_of_parts(const Scene& scene, double deep, double fraction);

// What somewhat more than the bed takes before it is levelled, and how dense it is assumed to settle.
struct PouredBed {
  double depth;     // above the floor, settled [m]
  double fraction;  // solid, settled [-]
  double filled;    // solid, as poured [-]
  double limit;     // of the speed of falling grains [m/s]; 0: they fall freely
};
PouredBed poured_bed(const Scene& scene);

// Until the uppermost grains have come down [s].
double fall_time(const Scene& scene);

// The lists of in.bed for a bed with parts.
void add_parts(const Scene& scene, std::map<std::string, std::string>& variables);

// Of a rock in the bed: radius of the largest grain that may be next to it [m].
double largest_at(const Scene& scene, const Eigen::Vector3d& centre, double radius);

}  // namespace footfall

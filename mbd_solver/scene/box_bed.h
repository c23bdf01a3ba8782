#pragma once
// A bed by numbers, [particles.box]: time steps of grains, the scripts of inputs/box and their variables, and clumps.
//
// Clumps are grains with corners: equal spheres that LIGGGHTS moves as one rigid body (fix multisphere).
//
// The spheres of a clump are sqrt(3) radii apart. That is as near as three spheres can be without sharing a point, so
// volume and moments of their union are the sums over spheres minus the sums over lenses where two overlap, in closed
// form:
//   V = n 4/3 pi s^3 - m V_lens        S = sum of int x x^T dV over spheres - the same over lenses        I / density = tr(S) 1 - S
// What overlaps counts once. The centre of mass is the mean of the centres, because each shape is symmetric.

#include <Eigen/Dense>
#include <string>
#include <string_view>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/scene/toml_file.h"

namespace footfall {

// 2 spheres; 3 in a line; 3; 4; 5: two tetrahedra on one triangle; 6.
enum class ClumpShape { kPair, kRod, kTriangle, kTetrahedron, kBipyramid, kOctahedron };
constexpr std::string_view name_of(ClumpShape kind) {
  return name_in(kind, "pair", "rod", "triangle", "tetrahedron", "bipyramid", "octahedron");
}

struct Clump {
  Eigen::Matrix3Xd centres;  // of the spheres, from the centre of mass [m]
  double radius = 0.0;       // of each sphere [m]
  double volume = 0.0;       // of their union [m3]
  Eigen::Matrix3d inertia;   // about the centre of mass, over the density [m5]
};

// The clump with the volume of a sphere of this radius [m] > 0.
Clump clump_of(ClumpShape shape, double equal_radius);

// Its words of a template of LIGGGHTS: spheres, mass and inertia. LIGGGHTS estimates only the share of each sphere in the clump's
// volume (ntry), for its own statistics.
std::string clump_words(const Clump& clump, double density);

// The shape of this name; throws InputError with what is known.
ClumpShape clump_shape(const std::string& name);

// Times that limit the time step of grains: theory 5.
struct ElasticGrain {
  double radius;   // r [m]
  double density;  // rho [kg/m3]
  double young;    // E [Pa]
  double poisson;  // nu [-]
};

// Rayleigh time of a grain [s]:
//   pi r sqrt(rho / G) / (0.1631 nu + 0.8766),  G = E / (2 (1 + nu))
double rayleigh_time(const ElasticGrain& grain);

// Duration of a Hertz contact of two equal grains at the impact speed `speed` [m/s] > 0 [s]:
//   2.87 (m*^2 / (r* E*^2 speed))^(1/5),  m* = m / 2, r* = r / 2, E* = E / (2 (1 - nu^2))
double hertz_time(const ElasticGrain& grain, double speed);

// The value > 0 rounded down to two digits: 8.84e-5 -> 8.8e-5.
double rounded_down(double value);

// From [particles.box] to the scripts of inputs/box and their variables.
// Numbers that follow from the box and the scene.
struct BoxNumbers {
  double rayleigh = 0.0, hertz = 0.0;  // times of the smallest grain [s]
  double time_step = 0.0;              // of the grains [s]
  double grains = 0.0;                 // about this number
  double headroom = 0.0;               // of the simulation box above z = 0 [m]
  double margin = 0.0;                 // of the simulation box around the walls [m]
};
// Of a bed that follows a body: whether along x (0) or y (1); how far from its ends the body stays, and at most may [m].
bool follows_along(const BoxSpec& box, int axis);
double follow_distance(const BoxSpec& box);
double longest_follow_distance(const BoxSpec& box);

// Of a scene whose box has no finding of check_box.
BoxNumbers box_numbers(const Scene& scene);

// Rolling friction replaces corners: clumps have none unless the scene names a model.
RollingModel rolling_model_of(const Scene& scene);

// A box of grains under [ground.terrain]: columns of its surface, and the rocks in it.
struct TerrainBed {
  int columns = 1, rows = 1;                 // along x and y
  std::vector<double> heights;               // of the surface at their middles, row after row, in W [m]
  double low = 0.0, high = 0.0, mean = 0.0;  // of the surface [m]
  std::vector<Terrain::Sphere> rocks;
};
std::optional<TerrainBed> terrain_bed(const Scene& scene);  // none: the surface is z = 0
double box_floor(const Scene& scene);                       // z of the floor [m]
double steepest_of_bed(const Scene& scene);                 // under a terrain, against the level of gravity [rad]
// The steepest slope on which grains stand: grains of friction mu slide on each other beyond atan(mu), and roll at less.
struct StandingSlope {
  double degrees = 0.0;
  std::string grains;  // "grains of friction 0.5 without rolling friction"
};
StandingSlope standing_slope(const BoxSpec& box);
std::string rock_name(std::size_t k);        // of the body of TerrainBed::rocks[k]
std::string rock_joint_name(std::size_t k);  // of the joint that holds it
// Refuses slopes on which grains do not stand, and adds the rocks as bodies that stand still.
void resolve_terrain_bed(Scene& scene, Findings& findings);

// Sets both scripts, their variables (the scene's own take precedence), surface_height and max_time_step. Errors become
// findings. Does nothing without a box.
void resolve_box(Scene& scene, Findings& findings);

// Reports errors of the box; true if there is none.
bool check_box(const Scene& scene, Findings& findings);

// Of the grains of a source, over their number [kg], and its grains per second.
double mean_grain_mass(const BoxSpec& box);
double source_rate(const BoxSpec& box, const GrainSourceSpec& source);

// Path of a script of inputs/box (shipped_files.h). Throws InputError.
std::string box_script(const std::string& name);

// particles.soil = "grc-1-dense": a bed with the numbers of a published soil. inputs/soils/NAME.toml holds keys of
// [particles.box] with the source of each. Keys of the scene take precedence.
// Adds the soil's keys to the table particles.box where the scene has none. Does nothing without particles.soil. An unknown
// soil, or one without a box, is a finding.
void add_soil(ConfigNode& scene, Findings& findings);

// Adds keys that are not there yet; their line is the line of the key that named the soil.
void fill_missing(ConfigNode& own, const ConfigNode& soil, int line);

// The same for ground.soil, a file in `folder` or a name in inputs/grounds (ground_soil.cpp): its table [law] goes under
// [ground.law].
void add_ground_soil(ConfigNode& scene, const std::string& folder, Findings& findings);

}  // namespace footfall

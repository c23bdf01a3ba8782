#pragma once
// A bed of grains by numbers instead of a script: [particles.box]. The scripts of inputs/box make it and run on it; they get
// these numbers as variables.

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/kinds.h"

namespace footfall {

enum class RollingModel { kNone, kCdt, kEpsd2 };
constexpr std::string_view name_of(RollingModel kind) { return name_in(kind, "none", "cdt", "epsd2"); }

enum class CohesionModel { kSjkr, kSjkr2 };
constexpr std::string_view name_of(CohesionModel kind) { return name_in(kind, "sjkr", "sjkr2"); }

// How the bed is poured.
enum class Packing {
  kLoose,  // with the friction of its grains
  kDense   // nearly smooth
};
constexpr std::string_view name_of(Packing kind) { return name_in(kind, "loose", "dense"); }

// Along which sides a bed follows a body.
enum class FollowDirections { kX, kY, kXY };
constexpr std::string_view name_of(FollowDirections kind) { return name_in(kind, "x", "y", "xy"); }

// Hertz and Mindlin contacts. Grains are softer than sand, which allows longer time steps.
struct GrainMaterialSpec {
  double density = 2600.0;  // [kg/m3] > 0
  double young = 1e7;       // [Pa] >= 1e4
  double poisson = 0.3;     // [-] in [0, 0.5)
  // Grain on grain:
  double restitution = 0.3;                         // [-] in (0.05, 1]
  double friction = 0.5;                            // [-] >= 0
  double rolling_friction = 0.2;                    // [-] >= 0
  RollingModel rolling_model = RollingModel::kCdt;  // of clumps: none, unless given
  double cohesion = 0.0;                            // cohesion energy density [J/m3] >= 0
  CohesionModel cohesion_model = CohesionModel::kSjkr;
};

// The bodies of the mechanism, and their contacts with grains; not given: as grain on grain.
struct BodyContactSpec {
  double young = 2e11;   // [Pa] >= 1e4
  double poisson = 0.3;  // [-] in [0, 0.5)
  std::optional<double> restitution, friction, rolling_friction, cohesion;
};

// A block of W in which grains come into being, or vanish: two opposite corners [m], and when [s].
struct GrainRegionSpec {
  std::array<Eigen::Vector3d, 2> region{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  double from = 0.0;
  std::optional<double> until;  // not given: to the end
};

struct GrainSourceSpec : GrainRegionSpec {
  std::optional<double> rate;                          // [kg/s], or
  std::optional<double> grains_per_second;             // [1/s]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // of new grains [m/s]
};

// How a size distribution is given; all by mass.
enum class SizeDistributionKind {
  kTable,      // the share of each diameter
  kLognormal,  // ln(diameter) has a normal distribution
  kSieve       // what passes each of some sieves
};
constexpr std::string_view name_of(SizeDistributionKind kind) { return name_in(kind, "table", "lognormal", "sieve"); }

struct SizeDistributionSpec {
  SizeDistributionKind kind = SizeDistributionKind::kTable;
  std::vector<double> diameters;           // of the grains, or openings of the sieves, increasing [m]
  std::vector<double> fractions;           // table: share of each diameter in the mass, sum 1 [-]
  std::vector<double> passing;             // sieve: share of the mass that passes each opening [-]
  double median = 0.0;                     // lognormal: half the mass is finer [m]
  double deviation = 0.0;                  // lognormal: standard deviation of ln(diameter) [-]
  std::optional<double> finest, coarsest;  // lognormal: what is beyond is left out; not given: 5 and 95 % pass [m]
  int classes = 5;                         // lognormal: number of radii that represent it
};

// Radii of grains and their shares in the mass.
struct GrainSizesSpec {
  std::vector<double> radius;                             // of clumps: of the sphere of their volume [m]
  std::vector<double> shares;                             // of the radii in the mass; empty: equal [-]
  std::optional<SizeDistributionSpec> size_distribution;  // instead of both, which follow from it (grain_sizes.h)
};

// A part of the bed with other grains, mostly finer ones: below the surface, a block under each of some bodies, or at one
// place. Of zones that overlap the first in the list has the place.
struct GrainZoneSpec : GrainSizesSpec {
  std::vector<std::string> under;  // bodies, in the reference configuration moved by initial.position and initial.yaw
  std::vector<double> centre;      // of one block along x and y of W, instead [m]
  std::vector<double> size;        // of a block along x and y [m]
  double depth = 0.0;              // below the surface [m]
};

// How the bed is poured and comes to rest. Not given: by packing.
struct PourSpec {
  std::optional<double> friction;          // of the grains while they are poured [-]
  std::optional<double> rolling_friction;  // likewise [-]
  std::optional<double>
      rayleigh_fraction;              // of the Rayleigh time: the time step of pouring; as rayleigh_fraction of the box
  std::optional<double> young;        // of the grains while they fall; not given: material.young [Pa]
  std::optional<double> settle_time;  // given to come to rest after the fall [s]; not given: twice the fall
};

struct BoxSpec : GrainSizesSpec {
  std::vector<double> size;  // along x and y [m]
  double depth = 0.0;        // of the levelled bed: floor at z = -depth, surface at z = 0 of W [m]
  std::vector<GrainZoneSpec> zones;
  std::vector<std::string> clumps;          // shapes of the grains (box_bed.h); empty: spheres
  std::vector<double> clump_shares;         // of the shapes in the mass; empty: equal [-]
  std::vector<double> centre = {0.0, 0.0};  // of the bed along x and y of W [m]
  std::vector<double> pit;  // [x_1, x_2]: there the settled bed is removed, across its width; empty: nowhere [m]
  double pit_depth = 0.0;   // of the pit below the surface [m]
  bool periodic = false;    // in x and y; else walls of grain material
  std::string follow;       // body that the bed goes along with; then periodic; empty: none
  FollowDirections follow_directions = FollowDirections::kXY;
  std::optional<double>
      follow_distance;  // of the body to the ends of the bed [m]; not given: 0.3 of its shorter side there
  bool walls = true;    // floor and sides act in the run, too; else bodies of the scene replace them
  Packing packing = Packing::kLoose;
  PourSpec pour;
  int seed = 1;                     // each number >= 1 gives another sample of the bed
  std::optional<double> headroom;   // of the simulation box above the surface [m]
  std::optional<double> margin;     // of the simulation box around the walls [m]
  std::optional<double> time_step;  // of the grains [s]; not given: by rayleigh_fraction
  double rayleigh_fraction = 0.1;   // of the Rayleigh time, and half of it of the Hertz time: the time step
  std::optional<int> every;         // DEM steps per coupling interval; not given: chosen for each interval
  double frames = 0.0;              // interval of dumps of the grains [s]; 0: none
  std::vector<GrainSourceSpec> sources;
  std::vector<GrainRegionSpec> sinks;
  GrainMaterialSpec material;
  BodyContactSpec bodies;
};

}  // namespace footfall

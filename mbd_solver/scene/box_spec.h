#pragma once
// A bed of grains by numbers instead of by a script: [particles.box]. It is made and run by the scripts of inputs/box,
// which get these numbers as variables.

#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/kinds.h"

namespace footfall {

enum class RollingModel { kNone, kCdt, kEpsd2 };
constexpr std::string_view name_of(RollingModel kind) {
  switch (kind) {
    case RollingModel::kNone: return "none";
    case RollingModel::kCdt: return "cdt";
    case RollingModel::kEpsd2: return "epsd2";
  }
  return {};
}

enum class CohesionModel { kSjkr, kSjkr2 };
constexpr std::string_view name_of(CohesionModel kind) {
  switch (kind) {
    case CohesionModel::kSjkr: return "sjkr";
    case CohesionModel::kSjkr2: return "sjkr2";
  }
  return {};
}

// How the bed is poured.
enum class Packing {
  kLoose,  // with the friction of its grains
  kDense   // nearly smooth
};
constexpr std::string_view name_of(Packing kind) {
  switch (kind) {
    case Packing::kLoose: return "loose";
    case Packing::kDense: return "dense";
  }
  return {};
}

// Hertz and Mindlin contacts. Grains are softer than sand is, which allows longer time steps.
struct GrainMaterialSpec {
  double density = 2600.0;  // [kg/m3] > 0
  double young = 1e7;       // [Pa] >= 5e6
  double poisson = 0.3;     // [-] in [0, 0.5)
  // Grain on grain:
  double restitution = 0.3;                         // [-] in (0.05, 1]
  double friction = 0.5;                            // [-] >= 0
  double rolling_friction = 0.2;                    // [-] >= 0
  RollingModel rolling_model = RollingModel::kCdt;  // of clumps none, unless it is given
  double cohesion = 0.0;                            // cohesion energy density [J/m3] >= 0
  CohesionModel cohesion_model = CohesionModel::kSjkr;
};

// The mechanism's bodies, and each of them on grains; what is not given is as grain on grain.
struct BodyContactSpec {
  double young = 2e11;   // [Pa] >= 5e6
  double poisson = 0.3;  // [-] in [0, 0.5)
  std::optional<double> restitution, friction, rolling_friction, cohesion;
};

struct BoxSpec {
  std::vector<double> size;                 // along x and y [m]
  double depth = 0.0;                       // of the levelled bed: floor at z = -depth, surface at z = 0 of W [m]
  std::vector<double> radius;               // of the grains, one or two; of clumps: of the sphere of their volume [m]
  std::vector<double> shares;               // of two radii in the mass; empty: alike [-]
  std::vector<std::string> clumps;          // shapes of the grains (clump_shape.h); empty: spheres
  std::vector<double> clump_shares;         // of the shapes in the mass; empty: alike [-]
  std::vector<double> centre = {0.0, 0.0};  // of the bed along x and y of W [m]
  std::vector<double> pit;  // [x_1, x_2]: there the settled bed is taken away, across its width; empty: nowhere
  double pit_depth = 0.0;   // of the pit below the surface [m]
  bool periodic = false;    // it goes on at its sides; else walls of grain material
  bool walls = true;        // floor and sides stand in the run, too; else bodies of the scene are in their places
  Packing packing = Packing::kLoose;
  int seed = 1;                     // another sample of the bed for each number >= 1
  std::optional<double> headroom;   // of the simulation box above the surface [m]
  std::optional<double> margin;     // of the simulation box around the walls [m]
  std::optional<double> time_step;  // of the grains [s]; not given: by rayleigh_fraction
  double rayleigh_fraction = 0.1;   // of the Rayleigh time, and half of it of the Hertz time: the time step
  std::optional<int> every;         // substeps per window; not given: chosen for each window
  double frames = 0.0;              // between dumps of the grains [s]; 0: none
  GrainMaterialSpec material;
  BodyContactSpec bodies;
};

}  // namespace footfall

#pragma once
// The surface of the ground (model/terrain.h) as a scene gives it: the sum of its parts.

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/model/terrain.h"

namespace footfall {

// A file with heights: an ESRI ASCII grid, or text with x, y and z in each line.
struct TerrainMapSpec {
  std::string file;
  std::optional<Eigen::Vector3d>
      origin;                 // coordinates of the file that lie at terrain.position; not given: its middle [m]
  double height_scale = 1.0;  // of the heights above the origin [-] > 0
  std::shared_ptr<const HeightGrid> grid;  // read from the file, counted from the origin
};

struct CraterSpec {
  double x = 0.0, y = 0.0;  // from terrain.position [m]
  double diameter = 0.0;    // of the crest [m] > 0
  double depth = 0.0;       // below the ground around it [m] >= 0
  double rim_height = 0.0;  // [m] >= 0
};

struct WaveSpec {
  double length = 0.0;   // from crest to crest [m] > 0
  double height = 0.0;   // from trough to crest [m] >= 0
  double azimuth = 0.0;  // across the crests, from x towards y [rad]
  double phase = 0.0;    // at terrain.position [rad]
};

// Isotropic, with a power spectrum of the heights ~ k^-2(H + 1) over wave numbers k.
struct RoughnessSpec {
  double height = 0.0;    // root of the mean square of the heights [m] > 0
  double hurst = 0.8;     // H [-] 0 to 1
  double shortest = 0.0;  // wavelength [m] > 0
  double longest = 0.0;   // [m] > shortest
  int seed = 1;           // each number >= 1 gives another sample
};

struct RockSpec {
  double x = 0.0, y = 0.0;  // from terrain.position [m]
  double diameter = 0.0;    // [m] > 0
  double buried = 0.5;      // share of the diameter below the ground [-] 0 to 1
};

// Rocks of random places and sizes: F(D) = k exp(-q D), q = 1.79 + 0.152 / k [1/m], is the share of the area that rocks of
// diameters above D cover [Golombek and Rapp, J. Geophys. Res. 102 (1997) 4117].
struct RockFieldSpec {
  double abundance = 0.0;                     // k [-] 0 to 0.5; 0: no rocks
  double smallest = 0.0;                      // diameter [m] > 0
  double largest = 0.0;                       // [m] > smallest
  std::vector<double> size;                   // of the field along x and y [m]
  double x = 0.0, y = 0.0;                    // its middle, from terrain.position [m]
  double buried = 0.5;                        // share of the diameter below the ground [-] 0 to 1
  double keep_out = 0.0;                      // no rock is nearer to (keep_out_x, keep_out_y) [m] >= 0
  double keep_out_x = 0.0, keep_out_y = 0.0;  // from terrain.position [m]
  int seed = 1;                               // each number >= 1 gives another sample
};

struct TerrainSpec {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // of its origin in W; z is up [m]
  double slope = 0.0;                                  // [rad] 0 to 60 degrees
  double azimuth = 0.0;                                // in which it falls, from x towards y [rad]
  std::optional<TerrainMapSpec> map;
  std::vector<CraterSpec> craters;
  std::vector<WaveSpec> waves;
  std::optional<RoughnessSpec> roughness;
  std::vector<RockSpec> rocks;
  std::optional<RockFieldSpec> rock_field;

  bool is_plane() const {
    return !map && craters.empty() && waves.empty() && !roughness && rocks.empty() && !rock_field;
  }
};

}  // namespace footfall

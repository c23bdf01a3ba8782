#pragma once
// The positions of the grains of a bed, from the text dump that is written with it.

#include <Eigen/Dense>
#include <string>
#include <vector>

namespace footfall {

struct GrainPlace {
  Eigen::Vector3d centre;  // in W [m]
  double radius;           // [m]
  int clump = 0;           // spheres with the same number are one rigid grain; 0: a single grain
  double speed = -1.0;     // [m/s]; negative: not in the file
};

// Text dump of LIGGGHTS with columns x y z radius after a line "ITEM: ATOMS x y z radius"; the last of several frames. A fifth
// column named mol is the number of the clump, three more may be vx vy vz. Throws InputError: unreadable, no grains, a line that is no grain.
std::vector<GrainPlace> read_grains(const std::string& path);

// Spheres of one clump count as one.
std::size_t count_grains(const std::vector<GrainPlace>& spheres);

}  // namespace footfall

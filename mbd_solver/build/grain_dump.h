#pragma once
// Where the grains of a bed are, from the text dump that is written with it.

#include <Eigen/Dense>
#include <string>
#include <vector>

namespace footfall {

struct GrainPlace {
  Eigen::Vector3d centre;  // in W [m]
  double radius;           // [m]
  int clump = 0;           // spheres of one number are one rigid grain; 0: a grain by itself
};

// Text dump of LIGGGHTS with columns x y z radius after a line "ITEM: ATOMS x y z radius"; of several frames the last. A
// fifth column named mol has the number of the clump.
// Throws InputError: not there, no grains, a line that is no grain.
std::vector<GrainPlace> read_grains(const std::string& path);

// Spheres of one clump count as one.
std::size_t count_grains(const std::vector<GrainPlace>& spheres);

}  // namespace footfall

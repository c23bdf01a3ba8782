#pragma once
// Where the grains of a bed are, from the text dump that is written with it.

#include <Eigen/Dense>
#include <string>
#include <vector>

namespace footfall {

struct GrainPlace {
  Eigen::Vector3d centre;  // in W [m]
  double radius;           // [m]
};

// Text dump of LIGGGHTS with columns x y z radius after a line "ITEM: ATOMS x y z radius"; of several frames the last.
// Throws InputError: not there, no grains, a line that is no grain.
std::vector<GrainPlace> read_grains(const std::string& path);

}  // namespace footfall

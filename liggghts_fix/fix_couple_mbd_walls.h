#pragma once
// Bodies and the script's primitive walls: LIGGGHTS' walls stop grains only, and a body goes through them as if they were
// not there.

#include <Eigen/Core>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "liggghts_fix/dem_link.h"

namespace LAMMPS_NS {

class Modify;
class PrimitiveWall;

// Looks once per window. A node has crossed a wall when the vector d from it to the wall has turned round,
//   d_before . d_now < 0,   |d_now| <= |x_now - x_before|.
// A body that stands on both sides of a wall when it is first looked at is meant to.
class WallWatch {
 public:
  // Throws NumericalError, naming body, wall and time, when a body has gone through a wall below it (along the script's
  // gravity); warns through the link of every other wall, once. time [s].
  void look(Modify& modify, footfall::DemLink& link, double time);

 private:
  struct Pair {  // a wall and a body
    Eigen::Matrix3Xd d;
    bool exempt = false;  // stands on both sides, or was told
  };
  void look(const std::string& wall_id, PrimitiveWall& wall, footfall::DemLink& link, int body, double time);

  std::map<std::pair<std::string, int>, Pair> pairs_;
  std::vector<Eigen::Matrix3Xd> before_, now_;  // nodes of each body [m]
};

}  // namespace LAMMPS_NS

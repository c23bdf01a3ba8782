#pragma once
// Walls of the script and bodies of the scene. LIGGGHTS' walls stop grains only: a body passes through them, unless the
// scene has a contact there.

#include <mpi.h>

#include <Eigen/Core>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "coupler/messages.h"
#include "liggghts_fix/link/dem_link.h"

namespace LAMMPS_NS {

class Modify;
class PrimitiveWall;

// The static walls of the script: planes of fix wall/gran, and meshes of fix wall/gran that neither a body of the scene
// nor the script moves, with their triangles from all ranks. A warning for meshes that the script moves. Collective.
std::vector<footfall::StaticWall> static_walls(Modify& modify, MPI_Comm world, std::vector<std::string>& warnings);

// The walls among `walls` that are removed or moving now.
std::vector<std::string> gone_walls(Modify& modify, const std::vector<footfall::StaticWall>& walls);

// Finds bodies that pass through primitive walls, once per window. A node has crossed a wall when the vector d from it to
// the wall has reversed,
//   d_before . d_now < 0,   |d_now| <= |x_now - x_before|.
// A body on both sides of a wall at the first check is taken as intended.
class WallCrossings {
 public:
  // Throws NumericalError, naming body, wall and time, when a body has passed through the floor: a wall that it reaches
  // within 45 degrees of the script's gravity. Warns through the link of every other wall, once: of a side of the bed,
  // after which the floor is no longer below this body. time [s].
  void check(Modify& modify, footfall::DemLink& link, double time);

 private:
  struct Pair {  // a wall and a body
    Eigen::Matrix3Xd d;
    bool exempt = false;                             // on both sides, or reported
    Eigen::Vector3d side = Eigen::Vector3d::Zero();  // from the bed to a side that the body has passed
  };
  void check(const std::string& wall_id, PrimitiveWall& wall, footfall::DemLink& link, int body, double time);
  // True: the wall is a side of the bed.
  bool report(const std::string& wall_id, const Eigen::Vector3d& to_wall, footfall::DemLink& link, int body,
              double time);

  std::map<std::pair<std::string, int>, Pair> pairs_;
  std::vector<Eigen::Matrix3Xd> before_, now_;  // nodes of each body [m]
};

}  // namespace LAMMPS_NS

// Computes the corners once, in the constructor, from the boundary that the handshake has brought.

#include "liggghts_fix/couple/fix_couple_mbd_geometry.h"

#include <cstring>

#include "coupler/base/errors.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/dem_link.h"
#include "update.h"

namespace LAMMPS_NS {

FixCoupleMbdGeometry::FixCoupleMbdGeometry(LAMMPS* lmp_, int narg, char** arg) : Fix(lmp_, narg, arg) {
  if (narg != 5 || std::strcmp(arg[3], "body") != 0)
    throw footfall::InputError(footfall::code::kGeometrySyntax,
                               std::string("fix ") + id + ": expected: fix ID all couple/mbd/geometry body NAME");
  const footfall::CoupledBody& body = footfall::dem_link_of(lmp_).bodies().scene_body(arg[4], update->unit_style);
  if (body.boundary.triangles().empty())
    throw footfall::InputError(footfall::code::kBodyWithoutTriangles,
                               std::string("fix ") + id + ": body \"" + arg[4] + "\" of the scene has no triangles");

  Eigen::Matrix3Xd x(3, body.boundary.node_count());
  body.boundary.node_positions(body.initial, x);
  for (const Eigen::Vector3i& triangle : body.boundary.triangles())
    for (const int node : triangle) corners_.insert(corners_.end(), x.col(node).data(), x.col(node).data() + 3);
  can_create_mesh_ = true;
}

}  // namespace LAMMPS_NS

#include "liggghts_fix/fix_couple_mbd_walls.h"

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/fix_wall_gran_beam.h"
#include "modify.h"
#include "primitive_wall.h"

namespace LAMMPS_NS {
namespace {

// From each node to the wall [m].
Eigen::Matrix3Xd to_wall(PrimitiveWall& wall, const Eigen::Matrix3Xd& x) {
  Eigen::Matrix3Xd d = Eigen::Matrix3Xd::Zero(3, x.cols());
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    Eigen::Vector3d node = x.col(j);
    wall.resolveContact(node.data(), 0.0, d.col(j).data());
  }
  return d;
}

// Of a plane: do nodes stand on both sides? (Around a cylinder that cannot be told from the vectors alone.)
bool on_both_sides(const Eigen::Matrix3Xd& d) {
  const Eigen::Vector3d first = d.col(0);
  return ((first.transpose() * d).array() < 0.0).any();
}

}  // namespace

void WallWatch::look(Modify& modify, footfall::DemLink& link, double time) {
  const auto bodies = static_cast<std::size_t>(link.body_count());
  now_.resize(bodies);
  for (std::size_t i = 0; i < bodies; ++i) {
    const footfall::DemBody& body = link.body(static_cast<int>(i));
    now_[i].resize(3, body.boundary().node_count());
    body.boundary().node_positions(body.pose(), now_[i]);
  }
  for (int i = 0; i < modify.nfix; ++i) {
    auto* const wall = dynamic_cast<FixWallGran*>(modify.fix[i]);
    if (wall == nullptr || wall->is_mesh_wall() || dynamic_cast<FixWallGranBeam*>(wall) != nullptr) continue;
    PrimitiveWall& surface = *wall->primitiveWall();
    const bool is_plane = surface.axis() < 0;
    for (int body = 0; body < link.body_count(); ++body)
      if (!is_plane || !link.is_held_by_walls(body)) look(wall->id, surface, link, body, time);
  }
  before_ = now_;
}

void WallWatch::look(const std::string& wall_id, PrimitiveWall& wall, footfall::DemLink& link, int body, double time) {
  const Eigen::Matrix3Xd& x = now_[static_cast<std::size_t>(body)];
  const auto [place, is_new] = pairs_.try_emplace({wall_id, body});
  Pair& pair = place->second;
  if (pair.exempt) return;
  const Eigen::Matrix3Xd d = to_wall(wall, x);
  if (is_new || before_.empty()) {
    pair.exempt = on_both_sides(d);
    pair.d = d;
    return;
  }
  const Eigen::Matrix3Xd& x_before = before_[static_cast<std::size_t>(body)];
  for (Eigen::Index j = 0; j < x.cols() && !pair.exempt; ++j) {
    const Eigen::Vector3d d_before = pair.d.col(j);
    if (d_before.dot(d.col(j)) >= 0.0 || d.col(j).norm() > (x.col(j) - x_before.col(j)).norm()) continue;
    pair.exempt = true;
    const std::string what = "t = " + footfall::number_text(time) + " s: body \"" + link.body_name(body) +
                             "\" goes through the wall of fix " + wall_id + ": LIGGGHTS' walls stop grains only";
    if (d_before.dot(link.script_gravity()) > 0.0)
      throw footfall::NumericalError(what +
                                     ", and this one is the floor under the body. Make the bed deeper, or end the "
                                     "scene before");
    link.warn(what);
  }
  for (Eigen::Index j = 0; j < x.cols(); ++j)
    if (!d.col(j).isZero(0.0)) pair.d.col(j) = d.col(j);  // on the wall it is still where it came from
}

}  // namespace LAMMPS_NS

// Static walls are read once, with their triangles from all ranks. Crossings of primitive walls are found by the vector
// from each node of a body to the wall, which reverses.

#include "liggghts_fix/couple/script_walls.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/communicator.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/contact/fix_wall_gran_beam.h"
#include "liggghts_fix/couple/rank_numbers.h"
#include "liggghts_fix/link/codes.h"
#include "modify.h"
#include "primitive_wall.h"
#include "tri_mesh.h"

namespace LAMMPS_NS {
namespace {

namespace code = footfall::code;

// A wall that is reached within 45 degrees of gravity is a floor, or a roof; others are sides of the bed [-].
const double kSteep = std::sqrt(0.5);

bool is_of_a_body(FixMeshSurface& mesh) { return mesh.get_module(footfall::kMeshModule) != nullptr; }

bool moves(FixMeshSurface& mesh) { return mesh.triMesh()->isMoving() || mesh.triMesh()->isDeforming(); }

// The plane x_k = c; nothing for a cylinder.
std::vector<footfall::StaticWall> plane_of(const std::string& name, PrimitiveWall& wall) {
  constexpr int kPlane = -1;
  if (wall.axis() != kPlane) return {};
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(), other = Eigen::Vector3d::Ones(), to_wall, from_other;
  to_wall.setZero();
  from_other.setZero();
  wall.resolveContact(origin.data(), 0.0, to_wall.data());
  wall.resolveContact(other.data(), 0.0, from_other.data());
  footfall::StaticWall plane;
  plane.name = name;
  plane.normal = to_wall - from_other;  // to_wall = c e_k, from_other = (c - 1) e_k
  plane.point = to_wall;
  return {plane};
}

// In the order of their ids. Before its first run LIGGGHTS has all triangles on every rank, later each on one.
std::vector<Eigen::Vector3d> all_corners(TriMesh& mesh, MPI_Comm world) {
  constexpr std::size_t kNumbers = 10;  // of a triangle: id, nine coordinates
  std::vector<double> mine;
  double*** const nodes = footfall::mesh_nodes(&mesh);
  for (int i = 0; i < mesh.sizeLocal(); ++i) {
    mine.push_back(mesh.id(i));
    for (int k = 0; k < 3; ++k) mine.insert(mine.end(), nodes[i][k], nodes[i][k] + 3);
  }
  const std::vector<double> numbers = footfall::of_all_ranks(mine, world);
  std::map<int, const double*> by_id;
  for (std::size_t i = 0; i < numbers.size(); i += kNumbers)
    by_id.emplace(static_cast<int>(numbers[i]), &numbers[i + 1]);
  std::vector<Eigen::Vector3d> corners;
  for (const auto& [id, x] : by_id)
    for (int k = 0; k < 3; ++k) corners.emplace_back(x[3 * k], x[3 * k + 1], x[3 * k + 2]);
  return corners;
}

// From each node to the wall [m].
Eigen::Matrix3Xd to_wall(PrimitiveWall& wall, const Eigen::Matrix3Xd& x) {
  Eigen::Matrix3Xd d = Eigen::Matrix3Xd::Zero(3, x.cols());
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    Eigen::Vector3d node = x.col(j);
    wall.resolveContact(node.data(), 0.0, d.col(j).data());
  }
  return d;
}

// Are nodes on both sides of a plane? (For a cylinder the vectors do not show this.)
bool on_both_sides(const Eigen::Matrix3Xd& d) {
  const Eigen::Vector3d first = d.col(0);
  return ((first.transpose() * d).array() < 0.0).any();
}

}  // namespace

std::vector<footfall::StaticWall> static_walls(Modify& modify, MPI_Comm world, std::vector<std::string>& warnings) {
  std::vector<footfall::StaticWall> walls;
  std::set<FixMeshSurface*> seen;
  for (int i = 0; i < modify.nfix; ++i) {
    auto* const wall = dynamic_cast<FixWallGran*>(modify.fix[i]);
    if (wall == nullptr || dynamic_cast<FixWallGranBeam*>(wall) != nullptr) continue;
    if (!wall->is_mesh_wall()) {
      for (footfall::StaticWall& plane : plane_of(wall->id, *wall->primitiveWall())) walls.push_back(std::move(plane));
      continue;
    }
    for (int k = 0; k < wall->n_meshes(); ++k) {
      FixMeshSurface* const mesh = wall->mesh_list()[k];
      if (is_of_a_body(*mesh) || !seen.insert(mesh).second) continue;
      if (moves(*mesh)) {
        warnings.push_back(
            footfall::with_code(code::kMeshMovedByScript, "mesh ", mesh->id,
                                " is moved by the script: bodies of the scene can pass through it without a warning"));
        continue;
      }
      footfall::StaticWall one;
      one.name = mesh->id;
      one.corners = all_corners(*mesh->triMesh(), world);
      if (!one.corners.empty()) walls.push_back(std::move(one));
    }
  }
  return walls;
}

std::vector<std::string> gone_walls(Modify& modify, const std::vector<footfall::StaticWall>& walls) {
  std::vector<std::string> gone;
  for (const footfall::StaticWall& wall : walls) {
    Fix* const fix = modify.find_fix_id(wall.name.c_str());
    auto* const mesh = dynamic_cast<FixMeshSurface*>(fix);
    const bool there = wall.corners.empty() ? fix != nullptr : mesh != nullptr && !moves(*mesh);
    if (!there) gone.push_back(wall.name);
  }
  return gone;
}

void WallCrossings::check(Modify& modify, footfall::DemLink& link, double time) {
  const auto bodies = static_cast<std::size_t>(link.bodies().count());
  now_.resize(bodies);
  for (std::size_t i = 0; i < bodies; ++i) {
    const footfall::DemBody& body = link.window().body(static_cast<int>(i));
    now_[i].resize(3, body.boundary().node_count());
    body.boundary().node_positions(body.pose(), now_[i]);
  }
  for (int i = 0; i < modify.nfix; ++i) {
    auto* const wall = dynamic_cast<FixWallGran*>(modify.fix[i]);
    if (wall == nullptr || wall->is_mesh_wall() || dynamic_cast<FixWallGranBeam*>(wall) != nullptr) continue;
    PrimitiveWall& surface = *wall->primitiveWall();
    const bool is_plane = surface.axis() < 0;
    for (int body = 0; body < link.bodies().count(); ++body)
      if (!is_plane || !link.is_held_by_walls(body)) check(wall->id, surface, link, body, time);
  }
  before_ = now_;
}

void WallCrossings::check(const std::string& wall_id, PrimitiveWall& wall, footfall::DemLink& link, int body,
                          double time) {
  const Eigen::Matrix3Xd& x = now_[body];
  const auto [place, is_new] = pairs_.try_emplace({wall_id, body});
  Pair& pair = place->second;
  if (const Eigen::Vector3d* const side =
          is_new ? link.window().body(body).sides().direction_of(wall_id) : nullptr) {  // before a checkpoint
    pair.exempt = true;
    pair.side = *side;
  }
  if (!pair.side.isZero(0.0) && (pair.side.transpose() * to_wall(wall, x)).maxCoeff() <= 0.0)
    link.window().body(body).sides().leave_bed();
  if (pair.exempt) return;
  const Eigen::Matrix3Xd d = to_wall(wall, x);
  if (is_new || before_.empty()) {
    pair.exempt = on_both_sides(d);
    pair.d = d;
    return;
  }
  const Eigen::Matrix3Xd& x_before = before_[body];
  for (Eigen::Index j = 0; j < x.cols() && !pair.exempt; ++j) {
    const Eigen::Vector3d d_before = pair.d.col(j);
    if (d_before.dot(d.col(j)) >= 0.0 || d.col(j).norm() > (x.col(j) - x_before.col(j)).norm()) continue;
    pair.exempt = true;
    if (report(wall_id, d_before, link, body, time)) pair.side = d_before;
  }
  for (Eigen::Index j = 0; j < x.cols(); ++j)
    if (!d.col(j).isZero(0.0)) pair.d.col(j) = d.col(j);  // on the wall the old vector remains
}

// The floor ends a run: below it nothing can carry the body. LIGGGHTS' planes have no end, but the bed has: once a body has
// left it sideways, the body is next to the bed and may be below the plane of the floor.
bool WallCrossings::report(const std::string& wall_id, const Eigen::Vector3d& to_wall, footfall::DemLink& link,
                           int body, double time) {
  const std::string what = "t = " + footfall::number_text(time) + " s: body \"" + link.bodies().name(body) +
                           "\" passes through the wall of fix " + wall_id +
                           ", because LIGGGHTS' walls stop grains only";
  const Eigen::Vector3d& g = link.script_gravity();
  const double down = to_wall.dot(g), steep = kSteep * to_wall.norm() * g.norm();
  footfall::DemBody& record = link.window().body(body);
  if (down > 0.0 && down >= steep && !record.sides().has_passed())
    throw footfall::NumericalError(
        code::kBodyThroughFloor, what,
        ". This wall is the floor below the body: make the bed deeper, or end the scene earlier");
  if (std::abs(down) >= steep) {
    link.window().warn(footfall::with_code(code::kBodyThroughWall, what));
    return false;
  }
  record.sides().pass(wall_id, to_wall);
  link.window().warn(
      footfall::with_code(code::kBodyLeavesBed, what,
                          ". This wall is a side of the bed: from here on the body has no grains below it, and its "
                          "results say nothing about the bed. Make the bed larger, or end the scene earlier"));
  return true;
}

}  // namespace LAMMPS_NS

#include "liggghts_fix/fix_couple_mbd_static.h"

#include <map>
#include <set>

#include "coupler/communicator.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/fix_wall_gran_beam.h"
#include "liggghts_fix/liggghts_access.h"
#include "modify.h"
#include "primitive_wall.h"
#include "tri_mesh.h"

namespace LAMMPS_NS {
namespace {

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

// In the order of their ids. Before its first run LIGGGHTS has all triangles on every rank, then each on one.
std::vector<Eigen::Vector3d> all_corners(TriMesh& mesh, MPI_Comm world) {
  constexpr std::size_t kNumbers = 10;  // of a triangle: id, nine coordinates
  std::vector<double> mine;
  double*** const nodes = footfall::mesh_nodes(&mesh);
  for (int i = 0; i < mesh.sizeLocal(); ++i) {
    mine.push_back(mesh.id(i));
    for (int k = 0; k < 3; ++k) mine.insert(mine.end(), nodes[i][k], nodes[i][k] + 3);
  }
  int ranks = 1;
  MPI_Comm_size(world, &ranks);
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(static_cast<std::size_t>(ranks));
  footfall::check_mpi(MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, world), "MPI_Allgather");
  int all = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    starts[rank] = all;
    all += counts[rank];
  }
  std::vector<double> numbers(static_cast<std::size_t>(all));
  footfall::check_mpi(
      MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, numbers.data(), counts.data(), starts.data(), MPI_DOUBLE, world),
      "MPI_Allgatherv");
  std::map<int, const double*> by_id;
  for (std::size_t i = 0; i < numbers.size(); i += kNumbers)
    by_id.emplace(static_cast<int>(numbers[i]), &numbers[i + 1]);
  std::vector<Eigen::Vector3d> corners;
  for (const auto& [id, x] : by_id)
    for (int k = 0; k < 3; ++k) corners.emplace_back(x[3 * k], x[3 * k + 1], x[3 * k + 2]);
  return corners;
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
        warnings.push_back(std::string("mesh ") + mesh->id +
                           " is moved by the script: bodies of the scene go through it, and nothing tells");
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
    const bool stands = wall.corners.empty() ? fix != nullptr : mesh != nullptr && !moves(*mesh);
    if (!stands) gone.push_back(wall.name);
  }
  return gone;
}

}  // namespace LAMMPS_NS

#include "liggghts_fix/fix_couple_mbd_match.h"

#include <algorithm>
#include <limits>
#include <map>

#include "coupler/base/errors.h"
#include "coupler/communicator.h"
#include "liggghts_fix/liggghts_access.h"
#include "tri_mesh.h"

namespace LAMMPS_NS {

std::vector<footfall::CornerNodes> match_over_ranks(TriMesh* mesh, const std::string& mesh_id,
                                                    const footfall::CoupledBody& body, MPI_Comm world) {
  std::vector<footfall::MeshTriangle> mine(static_cast<std::size_t>(mesh->sizeLocal()));
  int highest = -1;
  for (int i = 0; i < mesh->sizeLocal(); ++i) {
    footfall::MeshTriangle& triangle = mine[static_cast<std::size_t>(i)];
    triangle.id = mesh->id(i);
    highest = std::max(highest, triangle.id);
    for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = Eigen::Vector3d(footfall::mesh_nodes(mesh)[i][k]);
  }
  std::string failure;
  std::vector<footfall::CornerNodes> corners;
  try {
    corners = footfall::match_mesh(mesh_id, body.boundary, body.initial, mine);
  } catch (const footfall::InputError& mismatch) {
    failure = mismatch.what();
  }
  // The first rank that failed speaks for all.
  int me = 0, ranks = 1;
  MPI_Comm_rank(world, &me);
  MPI_Comm_size(world, &ranks);
  int speaker = failure.empty() ? ranks : me;
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, &speaker, 1, MPI_INT, MPI_MIN, world), "MPI_Allreduce");
  if (speaker < ranks) {
    int length = static_cast<int>(failure.size());
    footfall::check_mpi(MPI_Bcast(&length, 1, MPI_INT, speaker, world), "MPI_Bcast");
    failure.resize(static_cast<std::size_t>(length));
    footfall::check_mpi(MPI_Bcast(failure.data(), length, MPI_CHAR, speaker, world), "MPI_Bcast");
    throw footfall::InputError(failure);
  }

  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, &highest, 1, MPI_INT, MPI_MAX, world), "MPI_Allreduce");
  std::vector<footfall::CornerNodes> all(static_cast<std::size_t>(highest + 1), footfall::CornerNodes{-1, -1, -1});
  for (std::size_t i = 0; i < mine.size(); ++i) all[static_cast<std::size_t>(mine[i].id)] = corners[i];
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, all.data(), 3 * (highest + 1), MPI_INT, MPI_MAX, world),
                      "MPI_Allreduce");
  return all;
}

std::vector<Eigen::Matrix3d> velocities_over_ranks(TriMesh* mesh, double*** v, std::size_t elements, MPI_Comm world) {
  constexpr double kNotMine = std::numeric_limits<double>::lowest();
  std::vector<Eigen::Matrix3d> all(elements, Eigen::Matrix3d::Constant(kNotMine));
  for (int i = 0; i < mesh->sizeLocal(); ++i)
    for (int k = 0; k < 3; ++k)
      all[static_cast<std::size_t>(mesh->id(i))].col(k) = Eigen::Map<const Eigen::Vector3d>(v[i][k]);
  footfall::check_mpi(
      MPI_Allreduce(MPI_IN_PLACE, all.front().data(), static_cast<int>(9 * elements), MPI_DOUBLE, MPI_MAX, world),
      "MPI_Allreduce");
  return all;
}

void check_whole_surface(const footfall::ModalBoundary& boundary, const std::vector<PartOfSurface>& parts) {
  std::map<footfall::CornerNodes, const std::string*> holder;  // by sorted nodes
  std::string meshes;
  for (const PartOfSurface& part : parts) {
    meshes += (meshes.empty() ? "mesh " : " and mesh ") + part.mesh;
    for (footfall::CornerNodes corners : part.corners) {
      std::sort(corners.begin(), corners.end());
      const auto [place, is_new] = holder.emplace(corners, &part.mesh);
      if (!is_new && place->second != &part.mesh)
        throw footfall::InputError("meshes " + *place->second + " and " + part.mesh +
                                   " hold the same triangle of body \"" + boundary.name() +
                                   "\"; its contacts would count twice");
    }
  }
  const std::size_t whole = boundary.triangles().size();
  if (holder.size() != whole)
    throw footfall::InputError(meshes + (parts.size() == 1 ? " has " : " have ") + std::to_string(holder.size()) +
                               " triangles, body \"" + boundary.name() + "\" of the scene has " +
                               std::to_string(whole));
}

}  // namespace LAMMPS_NS

// Private and protected members of meshes, walls and gravity.

#include "liggghts_fix/liggghts_access.h"

#include <mpi.h>

#include <algorithm>
#include <map>
#include <vector>

#include "fix_gravity.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/liggghts_access_members.h"
#include "tri_mesh.h"

namespace footfall {
namespace {

using namespace LAMMPS_NS;

// The words behind surface_vel and surface_ang_vel; null when they are numbers.
template <int>
struct VelocityWord {
  using type = char* FixMeshSurface::*;
};

struct MeshModules {
  using type = std::map<std::string, MeshModule*> FixMeshSurface::*;
};

struct MeshModuleOrder {
  using type = std::vector<std::string> FixMeshSurface::*;
};

struct LocalElements {
  using type = int MultiNodeMeshParallel<3>::*;
};

struct ClearGhosts {
  using type = void (MultiNodeMeshParallel<3>::*)();
};

// Never made: it only names protected members.
class OpenTriMesh : public TriMesh {
 public:
  static double*** nodes(TriMesh* mesh) { return (mesh->*&OpenTriMesh::node_).begin(); }
  static double** centers(TriMesh* mesh) { return (mesh->*&OpenTriMesh::center_).begin(); }
  static std::vector<double> taken_out(TriMesh* mesh, int element) {
    std::vector<double> bytes(static_cast<std::size_t>(
        (mesh->*&OpenTriMesh::elemBufSize)(OPERATION_COMM_EXCHANGE, nullptr, false, false, false)));
    (mesh->*&OpenTriMesh::pushElemToBuffer)(element, bytes.data(), OPERATION_COMM_EXCHANGE, false, false, false);
    return bytes;
  }
  static void put_in(TriMesh* mesh, std::vector<double>& bytes) {
    (mesh->*&OpenTriMesh::popElemFromBuffer)(bytes.data(), OPERATION_COMM_EXCHANGE, false, false, false);
    ++(mesh->*Revealed<LocalElements>::member);
  }
  static void remove_all(TriMesh* mesh) {
    (mesh->*&OpenTriMesh::clearMap)();
    (mesh->*Revealed<ClearGhosts>::member)();
    while (mesh->sizeLocal() > 0) (mesh->*&OpenTriMesh::deleteElement)(mesh->sizeLocal() - 1);
  }
  static void recalculate(TriMesh* mesh) {
    (mesh->*&OpenTriMesh::updateCenterRbound)(0, mesh->sizeLocal() + mesh->sizeGhost());
    (mesh->*&OpenTriMesh::recalcLocalSurfProperties)();
    (mesh->*&OpenTriMesh::recalcGhostSurfProperties)();
  }
};

// Likewise.
class OpenGravity : public FixGravity {
 public:
  static int varies(FixGravity* gravity) { return gravity->*&OpenGravity::varflag; }
};

// Likewise.
class OpenWall : public FixWallGran {
 public:
  static LIGGGHTS::Walls::IGranularWall*& model(FixWallGran* wall) { return wall->*&OpenWall::impl; }
};

}  // namespace

template struct Reveal<VelocityWord<0>, &FixMeshSurface::vSurfStrX_>;
template struct Reveal<VelocityWord<1>, &FixMeshSurface::vSurfStrY_>;
template struct Reveal<VelocityWord<2>, &FixMeshSurface::vSurfStrZ_>;
template struct Reveal<VelocityWord<3>, &FixMeshSurface::omegaStr_>;
template struct Reveal<MeshModules, &FixMeshSurface::active_mesh_modules>;
template struct Reveal<MeshModuleOrder, &FixMeshSurface::mesh_module_order>;
template struct Reveal<LocalElements, &MultiNodeMeshParallel<3>::nLocal_>;
template struct Reveal<ClearGhosts, &MultiNodeMeshParallel<3>::clearGhosts>;

bool gravity_is_constant(FixGravity* fix) { return OpenGravity::varies(fix) == 0; }

bool surface_velocity_varies(FixMeshSurface* fix) {
  return fix->*Revealed<VelocityWord<0>>::member != nullptr || fix->*Revealed<VelocityWord<1>>::member != nullptr ||
         fix->*Revealed<VelocityWord<2>>::member != nullptr || fix->*Revealed<VelocityWord<3>>::member != nullptr;
}

void attach_mesh_module(FixMeshSurface* fix, const std::string& name, MeshModule* module) {
  (fix->*Revealed<MeshModules>::member)[name] = module;
  (fix->*Revealed<MeshModuleOrder>::member).push_back(name);
}

void detach_mesh_module(FixMeshSurface* fix, const std::string& name) {
  (fix->*Revealed<MeshModules>::member).erase(name);
  std::vector<std::string>& order = fix->*Revealed<MeshModuleOrder>::member;
  order.erase(std::remove(order.begin(), order.end(), name), order.end());
}

LIGGGHTS::Walls::IGranularWall*& wall_model(FixWallGran* wall) { return OpenWall::model(wall); }

double*** mesh_nodes(TriMesh* mesh) { return OpenTriMesh::nodes(mesh); }

double** mesh_centers(TriMesh* mesh) { return OpenTriMesh::centers(mesh); }

void recalculate_mesh(TriMesh* mesh) { OpenTriMesh::recalculate(mesh); }

void reorder_mesh(TriMesh* mesh, const std::vector<int>& order) {
  std::vector<std::vector<double>> elements;
  elements.reserve(order.size());
  for (const int element : order) elements.push_back(OpenTriMesh::taken_out(mesh, element));
  OpenTriMesh::remove_all(mesh);
  for (std::vector<double>& element : elements) OpenTriMesh::put_in(mesh, element);
}

}  // namespace footfall

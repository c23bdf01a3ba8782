// An explicit template instantiation may name a private member, because access is not checked there: it hands out a
// pointer to the member. A derived class may name a protected member as &Derived::member.

#include "liggghts_fix/access/liggghts_access.h"

#include <mpi.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "coupler/base/errors.h"
#include "fix.h"
#include "fix_gravity.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "lammps.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/dem_link.h"
#include "modify.h"
#include "tri_mesh.h"

namespace footfall {

template <class Tag>
struct Revealed {
  static typename Tag::type member;
};
template <class Tag>
typename Tag::type Revealed<Tag>::member;

// To be instantiated in this namespace, outside of unnamed ones:  template struct Reveal<Tag, &Class::member>;
template <class Tag, typename Tag::type member>
struct Reveal {
  Reveal() { Revealed<Tag>::member = member; }
  static Reveal instance;
};
template <class Tag, typename Tag::type member>
Reveal<Tag, member> Reveal<Tag, member>::instance;

namespace {

using namespace LAMMPS_NS;

// --- Tags of private members.

struct FixMap {
  using type = std::map<std::string, FixCreator>* Modify::*;
};

struct RestartIds {
  using type = char** Modify::*;
};

// The variables in surface_vel and surface_ang_vel; null when these are numbers.
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

// --- Classes that are never created: they only name protected members.

class OpenTriMesh : public TriMesh {
 public:
  static double*** nodes(TriMesh* mesh) { return (mesh->*&OpenTriMesh::node_).begin(); }
  static double** centers(TriMesh* mesh) { return (mesh->*&OpenTriMesh::center_).begin(); }
  static std::vector<double> pack_element(TriMesh* mesh, int element) {
    std::vector<double> bytes(
        (mesh->*&OpenTriMesh::elemBufSize)(OPERATION_COMM_EXCHANGE, nullptr, false, false, false));
    (mesh->*&OpenTriMesh::pushElemToBuffer)(element, bytes.data(), OPERATION_COMM_EXCHANGE, false, false, false);
    return bytes;
  }
  static void unpack_element(TriMesh* mesh, std::vector<double>& bytes) {
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

class OpenGravity : public FixGravity {
 public:
  static int varies(FixGravity* gravity) { return gravity->*&OpenGravity::varflag; }
};

class OpenWall : public FixWallGran {
 public:
  static LIGGGHTS::Walls::IGranularWall*& model(FixWallGran* wall) { return wall->*&OpenWall::impl; }
};

// --- Settings of an instance of LIGGGHTS.

struct Style {
  std::string name;
  FixCreator creator;
};
std::vector<Style>& styles() {
  static std::vector<Style> all;
  return all;
}

std::map<LAMMPS*, DemLink*>& links() {
  static std::map<LAMMPS*, DemLink*> all;
  return all;
}

using FixStyles = std::map<std::string, FixCreator>;

FixStyles& styles_of(LAMMPS* lmp) { return *(lmp->modify->*Revealed<FixMap>::member); }

// LIGGGHTS' own creators of meshes.
FixStyles& stock_meshes() {
  static FixStyles all;
  return all;
}

// fix ID GROUP STYLE file|fix|generate SOURCE ...
Fix* create_mesh(LAMMPS* lmp, int narg, char** arg) {
  static char file[] = "file", nothing[] = "/dev/null";
  const DemLink& link = dem_link_of(lmp);
  std::vector<char*> words(arg, arg + narg);
  if (narg > 4 && std::strcmp(words[3], "fix") == 0 && link.resumed()) {
    if (!lmp->modify->have_restart_data_style(arg[2]))
      throw InputError(code::kCheckpointGrainsNotRead, link.grains_not_read());
    words[3] = file;
    words[4] = nothing;
  }
  // LIGGGHTS treats mesh/surface/stress as mesh/surface with the module stress.
  std::string style = arg[2];
  while (stock_meshes().count(style) == 0) style.erase(style.rfind('/'));
  return stock_meshes().at(style)(lmp, narg, words.data());
}

}  // namespace

template struct Reveal<FixMap, &Modify::fix_map>;
template struct Reveal<RestartIds, &Modify::id_restart_global>;
template struct Reveal<VelocityWord<0>, &FixMeshSurface::vSurfStrX_>;
template struct Reveal<VelocityWord<1>, &FixMeshSurface::vSurfStrY_>;
template struct Reveal<VelocityWord<2>, &FixMeshSurface::vSurfStrZ_>;
template struct Reveal<VelocityWord<3>, &FixMeshSurface::omegaStr_>;
template struct Reveal<MeshModules, &FixMeshSurface::active_mesh_modules>;
template struct Reveal<MeshModuleOrder, &FixMeshSurface::mesh_module_order>;
template struct Reveal<LocalElements, &MultiNodeMeshParallel<3>::nLocal_>;
template struct Reveal<ClearGhosts, &MultiNodeMeshParallel<3>::clearGhosts>;

void register_fix_style(LAMMPS* lmp, const std::string& style, FixCreator creator) {
  styles().push_back({style, creator});
  styles_of(lmp)[style] = creator;
}

void restore_fix_styles(LAMMPS* lmp) {
  for (const Style& style : styles()) styles_of(lmp)[style.name] = style.creator;
}

void make_meshes_resumable(LAMMPS* lmp) {
  for (auto& [style, creator] : styles_of(lmp)) {
    if (style.rfind("mesh/surface", 0) != 0) continue;
    stock_meshes()[style] = creator;
    register_fix_style(lmp, style, create_mesh);
  }
}

void attach_dem_link(LAMMPS* lmp, DemLink& link) { links()[lmp] = &link; }

DemLink* find_dem_link(LAMMPS* lmp) {
  const auto found = links().find(lmp);
  return found == links().end() ? nullptr : found->second;
}

DemLink& dem_link_of(LAMMPS* lmp) {
  DemLink* const link = find_dem_link(lmp);
  FOOTFALL_DEMAND(link != nullptr);
  return *link;
}

void forget_restart_data(Modify& modify, const char* id) {
  char** const ids = modify.*Revealed<RestartIds>::member;
  for (int i = 0; i < modify.nfix_restart_global; ++i)
    if (id == std::string(ids[i])) ids[i][0] = '\0';
}

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
  for (const int element : order) elements.push_back(OpenTriMesh::pack_element(mesh, element));
  OpenTriMesh::remove_all(mesh);
  for (std::vector<double>& element : elements) OpenTriMesh::unpack_element(mesh, element);
}

}  // namespace footfall

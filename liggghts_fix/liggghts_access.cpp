// How: an explicit template instantiation may name a private member (access is not checked there), which hands out a
// pointer to member; a derived class may name a protected one as &Derived::member.

#include "liggghts_fix/liggghts_access.h"

#include <dlfcn.h>
#include <mpi.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "fix.h"
#include "fix_gravity.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "lammps.h"
#include "liggghts_fix/dem_link.h"
#include "liggghts_fix/fix_couple_mbd_restart.h"
#include "modify.h"
#include "tri_mesh.h"
#include "update.h"

namespace footfall {
namespace {

using namespace LAMMPS_NS;

template <class Tag>
struct Revealed {
  static typename Tag::type member;
};
template <class Tag>
typename Tag::type Revealed<Tag>::member;

template <class Tag, typename Tag::type member>
struct Reveal {
  Reveal() { Revealed<Tag>::member = member; }
  static Reveal instance;
};
template <class Tag, typename Tag::type member>
Reveal<Tag, member> Reveal<Tag, member>::instance;

struct FixMap {
  using type = std::map<std::string, FixCreator>* Modify::*;
};
template struct Reveal<FixMap, &Modify::fix_map>;

// The words behind surface_vel and surface_ang_vel; null when they are numbers.
template <int>
struct VelocityWord {
  using type = char* FixMeshSurface::*;
};
template struct Reveal<VelocityWord<0>, &FixMeshSurface::vSurfStrX_>;
template struct Reveal<VelocityWord<1>, &FixMeshSurface::vSurfStrY_>;
template struct Reveal<VelocityWord<2>, &FixMeshSurface::vSurfStrZ_>;
template struct Reveal<VelocityWord<3>, &FixMeshSurface::omegaStr_>;

struct MeshModules {
  using type = std::map<std::string, MeshModule*> FixMeshSurface::*;
};
template struct Reveal<MeshModules, &FixMeshSurface::active_mesh_modules>;

struct MeshModuleOrder {
  using type = std::vector<std::string> FixMeshSurface::*;
};
template struct Reveal<MeshModuleOrder, &FixMeshSurface::mesh_module_order>;

struct RestartIds {
  using type = char** Modify::*;
};
template struct Reveal<RestartIds, &Modify::id_restart_global>;

struct LocalElements {
  using type = int MultiNodeMeshParallel<3>::*;
};
template struct Reveal<LocalElements, &MultiNodeMeshParallel<3>::nLocal_>;

struct ClearGhosts {
  using type = void (MultiNodeMeshParallel<3>::*)();
};
template struct Reveal<ClearGhosts, &MultiNodeMeshParallel<3>::clearGhosts>;

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

class OpenGravity : public FixGravity {
 public:
  static int varies(FixGravity* gravity) { return gravity->*&OpenGravity::varflag; }
};

struct Style {
  std::string name;
  FixCreator creator;
};
std::vector<Style>& styles() {
  static std::vector<Style> all;
  return all;
}

// Likewise.
class OpenWall : public FixWallGran {
 public:
  static LIGGGHTS::Walls::IGranularWall*& model(FixWallGran* wall) { return wall->*&OpenWall::impl; }
};

std::map<LAMMPS*, DemLink*>& links() {
  static std::map<LAMMPS*, DemLink*> one;
  return one;
}

std::map<LAMMPS*, ForceWatch*>& watches() {
  static std::map<LAMMPS*, ForceWatch*> one;
  return one;
}

// Null in runs that nobody watches.
ForceWatch* watch_of(LAMMPS* lmp) {
  if (watches().empty()) return nullptr;
  const auto found = watches().find(lmp);
  return found == watches().end() ? nullptr : found->second;
}

// Likewise.
class OpenModify : public Modify {
 public:
  static int* post_force_list(Modify* modify) { return modify->*&OpenModify::list_post_force; }
  static LAMMPS* owner(Modify* modify) { return modify->*&OpenModify::lmp; }
};

using FixStyles = std::map<std::string, FixCreator>;

FixStyles& styles_of(LAMMPS* lmp) { return *(lmp->modify->*Revealed<FixMap>::member); }

// fix ID GROUP STYLE file|fix|generate SOURCE ...
FixStyles& stock_meshes() {
  static FixStyles one;
  return one;
}

Fix* create_mesh(LAMMPS* lmp, int narg, char** arg) {
  static char file[] = "file", nothing[] = "/dev/null";
  const DemLink& link = dem_link_of(lmp);
  std::vector<char*> words(arg, arg + narg);
  if (narg > 4 && std::strcmp(words[3], "fix") == 0 && link.resumed()) {
    if (!lmp->modify->have_restart_data_style(arg[2])) throw InputError(link.wrong_grains());
    words[3] = file;
    words[4] = nothing;
  }
  // LIGGGHTS takes mesh/surface/stress for mesh/surface with the module stress.
  std::string style = arg[2];
  while (stock_meshes().count(style) == 0) style.erase(style.rfind('/'));
  return stock_meshes().at(style)(lmp, narg, words.data());
}

}  // namespace

void register_fix_style(LAMMPS* lmp, const std::string& style, FixCreator creator) {
  styles().push_back({style, creator});
  styles_of(lmp)[style] = creator;
}

void let_meshes_resume(LAMMPS* lmp) {
  for (auto& [style, creator] : styles_of(lmp)) {
    if (style.rfind("mesh/surface", 0) != 0) continue;
    stock_meshes()[style] = creator;
    register_fix_style(lmp, style, create_mesh);
  }
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
  for (const int element : order) elements.push_back(OpenTriMesh::taken_out(mesh, element));
  OpenTriMesh::remove_all(mesh);
  for (std::vector<double>& element : elements) OpenTriMesh::put_in(mesh, element);
}

void watch_forces(LAMMPS* lmp, ForceWatch* watch) {
  if (watch != nullptr) {
    watches()[lmp] = watch;
  } else {
    watches().erase(lmp);
  }
}

void attach_dem_link(LAMMPS* lmp, DemLink& link) { links()[lmp] = &link; }

DemLink& dem_link_of(LAMMPS* lmp) {
  const auto found = links().find(lmp);
  FOOTFALL_DEMAND(found != links().end());
  return *found->second;
}

}  // namespace footfall

// ---- Members of LIGGGHTS that stand here in place of the library's: the launcher exports its symbols, so that the
// library finds these first.

namespace {

// The library's own.
template <class Member>
Member original(const char* symbol) {
  const auto member = reinterpret_cast<Member>(dlsym(RTLD_NEXT, symbol));
  FOOTFALL_DEMAND(member != nullptr);
  return member;
}

}  // namespace

// LIGGGHTS calls this when it has made its parts, at its start and in the command `clear`. All that the library's own does
// is for packages that Debian leaves out (suffixes gpu and omp).
void LAMMPS_NS::LAMMPS::post_create() {
  const auto link = footfall::links().find(this);
  if (link == footfall::links().end()) return;  // its start
  link->second->uncoupled_by("clear");
  for (const footfall::Style& style : footfall::styles()) footfall::styles_of(this)[style.name] = style.creator;
}

// A mesh that a restart file knows by its id. LIGGGHTS takes its triangles from there and wants the mesh file to exist,
// also behind the keyword `fix`. Triangles that a fix makes are made anew instead, where the scene has them, and the
// restart file's are forgotten.
void LAMMPS_NS::FixMesh::create_mesh_restart(char* file_or_fix) {
  Fix* const maker = modify->find_fix_id(file_or_fix);
  if (maker == nullptr || !maker->can_create_mesh()) {
    original<void (*)(FixMesh*, char*)>("_ZN9LAMMPS_NS7FixMesh19create_mesh_restartEPc")(this, file_or_fix);
    return;
  }
  char** const ids = modify->*footfall::Revealed<footfall::RestartIds>::member;
  for (int i = 0; i < modify->nfix_restart_global; ++i)
    if (id == std::string(ids[i])) ids[i][0] = '\0';
  create_mesh(file_or_fix, true);
}

// Grains change ranks. Those that stand outside of the box are lost here, and LIGGGHTS corrects its total at once: only
// before and after can be compared.
void LAMMPS_NS::Comm::exchange() {
  static const auto exchange = original<void (*)(Comm*)>("_ZN9LAMMPS_NS4Comm8exchangeEv");
  const int before = atom->nlocal;
  exchange(this);
  const auto link = footfall::links().find(lmp);
  if (link != footfall::links().end()) link->second->grains_exchanged(before, atom->nlocal);
}

// The forces of fixes, one after the other; and the same when a run is set up.
void LAMMPS_NS::Modify::post_force(int vflag) {
  static const auto post_force = original<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify10post_forceEi");
  footfall::ForceWatch* const watch = footfall::watch_of(footfall::OpenModify::owner(this));
  if (watch == nullptr) {
    post_force(this, vflag);
    return;
  }
  watch->pairs_done(false);
  for (int i = 0; i < n_post_force; ++i) {
    Fix& one = *fix[footfall::OpenModify::post_force_list(this)[i]];
    one.post_force(vflag);
    watch->fix_done(one);
  }
  watch->forces_done(false);
}

// Beside the forces it settles what fixes know of a restart, and computes.
void LAMMPS_NS::Modify::setup(int vflag) {
  static const auto setup = original<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify5setupEi");
  constexpr int kRun = 1, kNothing = 0;
  footfall::ForceWatch* const watch = footfall::watch_of(footfall::OpenModify::owner(this));
  if (watch == nullptr || update->whichflag != kRun) {
    setup(this, vflag);
  } else {
    watch->pairs_done(true);
    update->whichflag = kNothing;
    setup(this, vflag);
    update->whichflag = kRun;
    for (int i = 0; i < nfix; ++i) {
      fix[i]->setup(vflag);
      watch->fix_done(*fix[i]);
    }
    watch->forces_done(true);
  }
  return_held_forces(lmp);
}

void LAMMPS_NS::Modify::end_of_step() {
  static const auto end_of_step = original<void (*)(Modify*)>("_ZN9LAMMPS_NS6Modify11end_of_stepEv");
  if (footfall::ForceWatch* const watch = footfall::watch_of(footfall::OpenModify::owner(this))) watch->step_done();
  end_of_step(this);
}

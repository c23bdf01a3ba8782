// What a LIGGGHTS learns from us: fix styles, how its meshes resume, which coupling is its own. Where it forgets, makes
// meshes of restart files, or loses grains, members that stand here in place of the library's tell.

#include <mpi.h>

#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "fix.h"
#include "fix_mesh_surface.h"
#include "lammps.h"
#include "liggghts_fix/dem_link.h"
#include "liggghts_fix/liggghts_access.h"
#include "liggghts_fix/liggghts_access_members.h"
#include "modify.h"

namespace footfall {
namespace {

using namespace LAMMPS_NS;

struct FixMap {
  using type = std::map<std::string, FixCreator>* Modify::*;
};

struct RestartIds {
  using type = char** Modify::*;
};

struct Style {
  std::string name;
  FixCreator creator;
};
std::vector<Style>& styles() {
  static std::vector<Style> all;
  return all;
}

std::map<LAMMPS*, DemLink*>& links() {
  static std::map<LAMMPS*, DemLink*> one;
  return one;
}

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

template struct Reveal<FixMap, &Modify::fix_map>;
template struct Reveal<RestartIds, &Modify::id_restart_global>;

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

void attach_dem_link(LAMMPS* lmp, DemLink& link) { links()[lmp] = &link; }

DemLink& dem_link_of(LAMMPS* lmp) {
  const auto found = links().find(lmp);
  FOOTFALL_DEMAND(found != links().end());
  return *found->second;
}

}  // namespace footfall

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
    footfall::original<void (*)(FixMesh*, char*)>("_ZN9LAMMPS_NS7FixMesh19create_mesh_restartEPc")(this, file_or_fix);
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
  static const auto exchange = footfall::original<void (*)(Comm*)>("_ZN9LAMMPS_NS4Comm8exchangeEv");
  const int before = atom->nlocal;
  exchange(this);
  const auto link = footfall::links().find(lmp);
  if (link != footfall::links().end()) link->second->grains_exchanged(before, atom->nlocal);
}

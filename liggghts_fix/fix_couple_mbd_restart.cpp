#include "liggghts_fix/fix_couple_mbd_restart.h"

#include <dlfcn.h>
#include <mpi.h>

#include <cstdio>

#include "atom.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/base/file_error.h"
#include "coupler/base/whole_file.h"
#include "coupler/mpi_check.h"
#include "domain.h"
#include "fix_contact_history.h"
#include "fix_contact_history_mesh.h"
#include "lammps.h"
#include "modify.h"
#include "write_restart.h"

namespace {

// While LIGGGHTS writes a file: whether one that it has closed is not what it wrote. It does not look itself.
bool g_watches = false;
bool g_lost = false;

}  // namespace

// LIGGGHTS calls it by its name, which the linker finds here first.
extern "C" int fclose(FILE* file) {
  static const auto original = reinterpret_cast<int (*)(FILE*)>(dlsym(RTLD_NEXT, "fclose"));
  if (!g_watches) return original(file);
  const bool lost_before = std::ferror(file) != 0;
  const int result = original(file);
  g_lost = g_lost || lost_before || result != 0;
  return result;
}

namespace LAMMPS_NS {
namespace {

// What one rank has met concerns all.
bool on_any_rank(bool here, MPI_Comm world) {
  int mine = here ? 1 : 0, any = 0;
  footfall::check_mpi(MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world), "MPI_Allreduce");
  return any != 0;
}

template <class Write>
void watched(LAMMPS* lmp, const std::string& file, const Write& write) {
  g_lost = false;
  g_watches = true;
  write();
  g_watches = false;
  if (on_any_rank(g_lost, lmp->world))
    throw footfall::FileError(file + ": cannot be written whole: the disk is full, or its limit is reached");
}

bool all_grains_in_box(LAMMPS* lmp) {
  const Domain& box = *lmp->domain;
  const Atom& atom = *lmp->atom;
  bool outside = false;
  for (int i = 0; i < atom.nlocal; ++i)
    for (int c = 0; c < 3; ++c) outside = outside || !(atom.x[i][c] >= box.boxlo[c] && atom.x[i][c] < box.boxhi[c]);
  return !on_any_rank(outside, lmp->world);
}

}  // namespace

void keep_grains(LAMMPS* lmp, std::string file) {
  watched(lmp, file, [&] {
    char* words[] = {file.data()};
    WriteRestart(lmp).command(1, words);
  });
}

bool keep_grains_quietly(LAMMPS* lmp, std::string file) {
  if (!all_grains_in_box(lmp)) return false;
  // The history of contacts lives with the list of neighbours, and LIGGGHTS hands it back to the grains when it makes a
  // new list: the file takes it from there. Walls of meshes keep theirs with the grains.
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    Fix* fix = lmp->modify->fix[i];
    if (dynamic_cast<FixContactHistoryMesh*>(fix) != nullptr) continue;
    if (auto* history = dynamic_cast<FixContactHistory*>(fix)) history->pre_exchange();
  }
  watched(lmp, file, [&] { WriteRestart(lmp).write(file.data()); });
  return true;
}

void keep_text(LAMMPS* lmp, const std::string& file, const std::string& text) {
  std::string problem;
  if (lmp->comm->me == 0) {
    try {
      footfall::write_whole_file(file, text);
    } catch (const footfall::InputError& error) {
      problem = error.what();
    }
  }
  if (on_any_rank(!problem.empty(), lmp->world))
    throw footfall::FileError(problem.empty() ? file + ": cannot be written" : problem);
}

}  // namespace LAMMPS_NS

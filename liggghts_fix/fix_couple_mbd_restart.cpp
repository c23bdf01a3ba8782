#include "liggghts_fix/fix_couple_mbd_restart.h"

#include <dlfcn.h>
#include <mpi.h>

#include <cstdio>
#include <string>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/communicator.h"
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

// A fix property/atom of LIGGGHTS: force [N], moment [N m], and 1 while they wait to be returned.
constexpr char kHeldForces[] = "footfall_forces";
enum HeldColumn { kForce = 0, kMoment = 3, kWaits = 6, kHeldColumns };

Fix* held_forces(const LAMMPS* lmp) {
  const int place = lmp->modify->find_fix(kHeldForces);
  return place < 0 ? nullptr : lmp->modify->fix[place];
}

// They go with the grains through files, other orders and other ranks.
void hold_forces(LAMMPS* lmp) {
  if (held_forces(lmp) == nullptr) {
    expect_held_forces(lmp);
    held_forces(lmp)->just_created = false;  // else LIGGGHTS sets defaults when it inits
  }
  const Atom& atom = *lmp->atom;
  double* const* const held = held_forces(lmp)->array_atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    for (int c = 0; c < 3; ++c) {
      held[i][kForce + c] = atom.f[i][c];
      held[i][kMoment + c] = atom.torque[i][c];
    }
    held[i][kWaits] = 1.0;
  }
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
  // Behind all other fixes, in a resumed run too: its files are the same. The command makes LIGGGHTS' lists anew.
  if (held_forces(lmp) != nullptr) lmp->modify->delete_fix(kHeldForces);
  hold_forces(lmp);
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
  const bool held_before = held_forces(lmp) != nullptr;
  hold_forces(lmp);
  watched(lmp, file, [&] { WriteRestart(lmp).write(file.data()); });
  if (!held_before) lmp->modify->delete_fix(kHeldForces);
  return true;
}

void expect_held_forces(LAMMPS* lmp) {
  std::vector<std::string> words = {kHeldForces, "all", "property/atom", kHeldForces, "vector", "yes", "no", "no"};
  words.insert(words.end(), kHeldColumns, "0.");
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  lmp->modify->add_fix(static_cast<int>(pointers.size()), pointers.data());
}

void return_held_forces(LAMMPS* lmp) {
  const Fix* const fix = held_forces(lmp);
  if (fix == nullptr) return;
  const Atom& atom = *lmp->atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    double* const held = fix->array_atom[i];
    if (held[kWaits] != 1.0) continue;
    for (int c = 0; c < 3; ++c) {
      atom.f[i][c] = held[kForce + c];
      atom.torque[i][c] = held[kMoment + c];
    }
    held[kWaits] = 0.0;
  }
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

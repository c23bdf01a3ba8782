// LIGGGHTS writes its restart file through `write_restart`; a fix property/atom carries the forces and moments on the
// grains in it.

#include "liggghts_fix/couple/grain_checkpoint.h"

#include <mpi.h>

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
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/replaced/written_files.h"
#include "modify.h"
#include "write_restart.h"

namespace LAMMPS_NS {
namespace {

// Collective.
bool on_any_rank(bool here, MPI_Comm world) {
  int mine = here ? 1 : 0, any = 0;
  footfall::check_mpi(MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world), "MPI_Allreduce");
  return any != 0;
}

// Throws FileError on all ranks when a file that `write` writes is incomplete.
template <class Write>
void write_checked(LAMMPS* lmp, const std::string& file, const Write& write) {
  footfall::watch_written_files();
  write();
  if (on_any_rank(footfall::written_file_lost(), lmp->world))
    throw footfall::FileError(footfall::code::kCheckpointNotWritten,
                              file + ": cannot be written completely: the disk is full, or a limit is reached");
}

// Columns of a fix property/atom of LIGGGHTS: force [N], moment [N m], and 1 while they are to be restored.
constexpr char kHeldForces[] = "footfall_forces";
enum HeldColumn { kForce = 0, kMoment = 3, kWaits = 6, kHeldColumns };

Fix* held_forces(const LAMMPS* lmp) {
  const int place = lmp->modify->find_fix(kHeldForces);
  return place < 0 ? nullptr : lmp->modify->fix[place];
}

// Stores the present forces. They stay with the grains in files, and when grains change order or rank.
void hold_forces(LAMMPS* lmp) {
  if (held_forces(lmp) == nullptr) {
    create_held_forces(lmp);
    held_forces(lmp)->just_created = false;  // otherwise LIGGGHTS sets default values in its init
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

void write_grains(LAMMPS* lmp, std::string file) {
  // After all other fixes, as in a resumed run: the files are then the same. The command builds LIGGGHTS' lists anew.
  if (held_forces(lmp) != nullptr) lmp->modify->delete_fix(kHeldForces);
  hold_forces(lmp);
  write_checked(lmp, file, [&] {
    char* words[] = {file.data()};
    WriteRestart(lmp).command(1, words);
  });
}

bool write_grains_undisturbed(LAMMPS* lmp, std::string file) {
  if (!all_grains_in_box(lmp)) return false;
  // Contact histories are stored with the neighbour list. LIGGGHTS copies them to the grains, from which the file takes
  // them, only when it builds a new list. Contact histories of mesh walls are stored with the grains.
  for (int i = 0; i < lmp->modify->nfix; ++i) {
    Fix* fix = lmp->modify->fix[i];
    if (dynamic_cast<FixContactHistoryMesh*>(fix) != nullptr) continue;
    if (auto* history = dynamic_cast<FixContactHistory*>(fix)) history->pre_exchange();
  }
  const bool held_before = held_forces(lmp) != nullptr;
  hold_forces(lmp);
  write_checked(lmp, file, [&] { WriteRestart(lmp).write(file.data()); });
  if (!held_before) {
    lmp->modify->delete_fix(kHeldForces);
  } else {  // a set-up to come has its own forces
    for (int i = 0; i < lmp->atom->nlocal; ++i) held_forces(lmp)->array_atom[i][kWaits] = 0.0;
  }
  return true;
}

void create_held_forces(LAMMPS* lmp) {
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

void write_text(LAMMPS* lmp, const std::string& file, const std::string& text) {
  std::string problem;
  if (lmp->comm->me == 0) {
    try {
      footfall::write_whole_file(file, text);
    } catch (const footfall::InputError& error) {
      problem = error.what();
    }
  }
  if (on_any_rank(!problem.empty(), lmp->world))
    throw footfall::FileError(problem.empty() ? footfall::with_code(footfall::code::kCheckpointNotWritten,
                                                                    file + ": cannot be written on another rank")
                                              : problem);
}

}  // namespace LAMMPS_NS

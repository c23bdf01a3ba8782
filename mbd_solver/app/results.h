#pragma once
// After a run: the energy balance by part (ledger.csv), the summary on the terminal, and the plots.
//
// Energy balance on both sides of the interface [J], constant over time:
//   mechanism stored + dissipated + interface + grains stored + grains dissipated - work of prescribed motions
// The mechanism's part comes from history.csv. LIGGGHTS writes kinetic and gravity energy of the grains
// (grains_energy.txt, by the stock commands of inputs/regolith/energy.lammps). Energy dissipated by the grains is the
// rest of the work that they received:
//   received = -work.contact - coupling.energy_error
//   dissipated = received + coupling.grains_* - change of kinetic and gravity energy
// coupling.grains_*: energy that grains brought or took along, or got by commands and fixes that set their motion.
// It includes the elastic energy of their contacts, of which LIGGGHTS has no sum, and may decrease by that much.

#include <exception>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

struct GrainEnergies {          // one entry per row; empty: unknown
  std::vector<double> time;     // [s], rising
  std::vector<double> kinetic;  // translation and rotation [J]
  std::vector<double> gravity;  // sum of m g z, relative to any level [J]
  // Where the script writes them: what grains have brought, taken along and got by commands, at the very step [J].
  std::vector<double> inserted = {}, left = {}, changed = {};
};

// Reads grains_energy.txt: rows "step time kinetic rotation gravity", or with "inserted left changed" behind. Ignores an
// incomplete last row. Throws InputError.
GrainEnergies read_grain_energies(const std::string& path);

// Columns [J] besides time [s] and closing_error [-]:
//   mechanism.kinetic, .gravity, .strain, .gas, .contact (elastic, of a rigid plane); dissipated.* as in history.csv
//   work.motion            work of prescribed motions so far
//   with particles:        work.to_grains (work of the mechanism on them) and interface (the part they did not receive)
//   with `grains`:         grains.inserted, .left, .changed, .kinetic, .gravity, .dissipated: changes since the first row;
//                          the first three from `grains` if it has them, else from `run`, which has them at ends of windows
//   sum                    mechanism + dissipated - work.motion + work.to_grains
//   closing_error          change of the sum over reference_energy
// Rows at the times of `grains`, with the mechanism's values interpolated linearly; without grains at the times of `run`.
// Throws InputError when `run` has no energies.
History energy_ledger(const History& run, const GrainEnergies& grains);

// The energy that errors are related to [J]: in the first row without gravity, or the largest kinetic energy if larger.
double reference_energy(const History& run);

// On standard error: "footfall: TEXT [E0123 name]".
void print_error(const MessageCode& code, const std::string& text);

// Warns on standard error that a file after the run could not be made: with the code of `error`, or W1501.
void warn_missing_file(const std::string& file, const std::exception& error);

// Prints the summary and the paths of the files in `out`.
void print_results(const std::string& out, const std::vector<std::string>& pictures);

// Writes ledger.csv, and its final values into summary.json under "ledger". False when the run has too little data.
// Faults of its files are warnings on standard error.
bool write_ledger(const std::string& out);

// Writes the gnuplot scripts of the run in `out` and runs them; returns the pictures. A missing or failing gnuplot is a
// warning on standard error.
std::vector<std::string> make_pictures(const std::string& out);

}  // namespace footfall

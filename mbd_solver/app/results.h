#pragma once
// Where the energy of a run is at each time, on both sides of the interface [J]:
//   mechanism stored + dissipated + interface + grains stored + grains dissipated - work of prescribed motions =
//   constant.
// The mechanism's side comes from history.csv. The grains' side, their kinetic and gravity energy, LIGGGHTS writes
// (grains_energy.txt, stock commands, inputs/regolith/energy.lammps). What the grains dissipated is what is left of the
// work they received:
//   received = -work.contact - coupling.energy_residual,   dissipated = received - change of kinetic - change of
//   gravity energy.
// It therefore holds the change of the elastic energy in the contacts as well; LIGGGHTS has no sum of that. It may fall
// by no more than that energy.

#include <string>
#include <vector>

#include "mbd_solver/run/output/history.h"

namespace footfall {

struct GrainEnergies {          // one entry per row; empty: unknown
  std::vector<double> time;     // [s], rising
  std::vector<double> kinetic;  // translation and rotation [J]
  std::vector<double> gravity;  // sum of m g z, from any level [J]
};

// grains_energy.txt: rows "step time kinetic rotation gravity". A last row that is cut off is left out. Throws
// InputError "file:line: ...".
GrainEnergies read_grain_energies(const std::string& path);

// Columns, all in J but the first and the last:
//   time [s]; mechanism.kinetic, .gravity, .strain, .gas, .contact (elastic, of a rigid plane); dissipated.* as in
//   history.csv;
//   work.motion: done by prescribed motions so far; with grains: work.to_grains: what the mechanism lost to them,
//   interface: what of it they did not receive; with `grains`: grains.kinetic, grains.gravity and grains.dissipated,
//   changes since the first row;
//   sum: mechanism + dissipated - work.motion + work.to_grains; closing_error: its change over reference_energy [-].
// Rows at the times of `grains`, the mechanism's between two of its rows along a straight line; without grains at those
// of `run`.
// Throws InputError when `run` holds no energies.
History energy_ledger(const History& run, const GrainEnergies& grains);

// What reports mean by "initial energy": of the first row without gravity, or the largest kinetic energy if that is
// more [J].
double reference_energy(const History& run);

// What a run says at its end.

// The summary table and the paths of the files in `out`, on standard output.
void print_results(const std::string& out, const std::vector<std::string>& pictures);

// Writes ledger.csv (output/energy_ledger.h) of the run in `out` and its end figures into summary.json, under "ledger".
// False when the run left too little to make one; what is wrong with its files is a warning on standard error.
bool write_ledger(const std::string& out);

// Writes the gnuplot scripts of the run in `out` and runs them; returns the pictures made. A gnuplot that is missing or
// fails is a warning on standard error, not an end.
std::vector<std::string> make_pictures(const std::string& out);

}  // namespace footfall

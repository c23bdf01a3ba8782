#pragma once
// footfall sweep FILE: all runs of a sweep, several at once; finished ones are not done again; tables and plots at the
// end.

#include <string>

namespace footfall {

struct SweepArguments {
  std::string file;
  std::string out;     // empty: runs/sweeps/NAME
  int jobs = 0;        // runs at once; 0: as many as fit the cores
  int only = -1;       // this run alone, without tables: what one element of a job array does
  bool merge = false;  // no runs: tables and plots of what is there
  bool list = false;   // no runs: their numbers, names and settings
  bool slurm = false;  // no runs: writes OUT/sweep.sbatch, the same sweep as a Slurm job array
};

// Returns the exit code: 0 when every run is done, 1 when one failed, 3 when interrupted. Throws InputError.
int sweep_command(const SweepArguments& arguments);

}  // namespace footfall

#pragma once
// Everything that an experiment writes when its runs are done.

#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/studies/results.h"

namespace footfall {

struct OutputPlace {
  std::string folder, name;  // of the files
  std::string table;         // also write the table for a page to this file; empty: no
  std::string command;       // that makes it
  bool short_form = false;   // without fits, which need all runs
};

// Prints and writes it into the folder. True when all that the file expects came out; of [[parameters]], when every run
// is done as well.
bool write_output(const ExperimentSpec& spec, const Plan& plan, const Results& results, const OutputPlace& place);

// What the figures and plots of the file take from a run, of a finished one in `folder`. Throws InputError for what it
// does not have: told when the first run is done, not after the last.
void demand_results(const ExperimentSpec& spec, const std::string& folder);

// footfall sweep FILE, footfall accuracy FILE: all runs of an experiment (experiment.h), several at once; tables and
// pictures at the end. The two names differ in their defaults: accuracy measures run times, so one run at a time, each
// done anew.

struct ExperimentSpec;
struct Plan;
struct Results;

struct ExperimentArguments {
  std::string command;  // its name: sweep or accuracy
  std::string file;
  std::string out;          // empty: `runs` and the file's name
  std::string runs;         // default folder
  std::string of_case;      // this curve alone; empty: all
  std::string table;        // also write the table to this file, as Markdown; empty: no
  int jobs = 0;             // runs at once; 0: as many as fit the cores
  int only = -1;            // this run alone, without tables: what one element of a job array does
  bool resume = false;      // runs that are done are kept
  bool short_form = false;  // as the tests run it
  bool merge = false;       // no runs: tables and plots of what is there
  bool list = false;        // no runs: beds, and their numbers, names and settings
  bool slurm = false;       // no runs: writes OUT/sweep.sbatch, the experiment as a Slurm job array

  // For a command that makes its own of an experiment, as footfall rig does; each may be empty.
  std::vector<std::string> again;               // words of the same command, instead of command and file
  std::function<void(ExperimentSpec&)> change;  // of what the file says
  std::function<void(Plan&)> extend;            // of its runs; cases stay as they are
  // Instead of write_output: with the folder and the line of the command. True when all came out.
  std::function<bool(const ExperimentSpec&, const Plan&, const Results&, const std::string&, const std::string&)> write;
};

// Returns the exit code: 0; 1 when something that the file expects did not come out, or a run of [[parameters]] failed;
// 3 when interrupted. Throws InputError.
int experiment_command(const ExperimentArguments& arguments);

}  // namespace footfall

#pragma once
// footfall sweep FILE, footfall accuracy FILE: all runs of a sweep file, several at once, then tables and pictures. The two
// differ in their defaults: accuracy measures run times, so it carries out one run at a time and repeats finished ones.

#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/studies/results.h"

namespace footfall {

struct SweepArguments {
  std::string command;  // its name: sweep or accuracy
  std::string file;
  std::string out;            // empty: `runs` and the file's name
  std::string runs;           // default folder
  std::string of_case;        // only this curve; empty: all
  std::string table;          // also write the table to this file, as Markdown; empty: no
  int jobs = 0;               // runs at once; 0: as many as the cores allow
  long row = -1;              // of a campaign: repeat this row with all its files, and stop
  int only = -1;              // only this run, without tables: one element of a job array
  bool resume = false;        // finished runs are not repeated
  bool short_form = false;    // the short form, as in tests
  bool trust_script = false;  // runs may start programs that their scenes name
  bool merge = false;         // no runs: tables and plots of finished ones
  bool list = false;          // no runs: list them; makes nothing
  bool beds = false;          // no runs: make the beds that they need
  bool slurm = false;         // no runs: write OUT/sweep.sbatch, the sweep as a Slurm job array

  // For a command that builds on sweeps, as footfall rig does; each may be empty.
  std::vector<std::string> again;          // words of the same command, instead of command and file
  std::function<void(SweepSpec&)> change;  // changes the spec
  std::function<void(Plan&)> extend;       // adds runs; cases are unchanged
  // Instead of write_output: with the folder and the command. True when the results are as required.
  std::function<bool(const SweepSpec&, const Plan&, const Results&, const std::string&, const std::string&)> write;
};

// Returns the exit code: 0; 1 when a check of [[expect]] is not reproduced, or a run of [[parameters]] failed; 3 when
// interrupted. Throws InputError.
int sweep_command(const SweepArguments& arguments);

// Says that the same command resumes the study, and returns the exit code.
int study_interrupted();

struct OutputFolder {
  std::string folder, name;  // of the files
  std::string table;         // also write the table for a page to this file; empty: no
  std::string command;       // that makes it
  bool short_form = false;   // without fits, which require all runs
};

// Prints all results and writes them into the folder. True when all [[expect]] are reproduced and, of [[parameters]], all
// runs are done.
bool write_output(const SweepSpec& spec, const Plan& plan, const Results& results, const OutputFolder& output);

// Throws InputError when the finished run in `folder` lacks a number or column that metrics or plots require: reported
// after the first run, not after the last.
void require_results(const SweepSpec& spec, const std::string& folder);

}  // namespace footfall

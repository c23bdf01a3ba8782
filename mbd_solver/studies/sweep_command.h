#pragma once
// footfall sweep FILE, footfall accuracy FILE: all runs of a sweep file, several at once, then tables and pictures. The two
// differ in their defaults: accuracy measures run times, so it carries out one run at a time and repeats finished ones.

#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/studies/results.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

struct OutputFolder;

struct SweepArguments {
  std::string command;  // its name: sweep or accuracy
  std::string file;
  std::string out;                    // empty: `runs` and the file's name
  std::string runs;                   // default folder
  std::string of_case;                // only this curve; empty: all
  std::string table;                  // also write the table to this file, as Markdown; empty: no
  int jobs = 0;                       // runs at once; 0: as many as the cores allow
  long row = -1;                      // of a campaign: repeat this row with all its files, and stop
  int only = -1;                      // only this run, without tables: one element of a job array
  bool resume = false;                // finished runs are not repeated
  bool short_form = false;            // the short form, as in tests
  bool trust_script = false;          // runs may start programs that their scenes name
  bool merge = false;                 // no runs: tables and plots of finished ones
  bool list = false;                  // no runs: list them; makes nothing
  bool beds = false;                  // no runs: make the beds that they need
  bool slurm = false;                 // no runs: write OUT/sweep.sbatch, the sweep as a Slurm job array
  std::vector<std::string> settings;  // --set, of every run of a rig or a fit

  // For a command that builds on sweeps, as footfall rig does; each may be empty.
  std::vector<std::string> again;          // words of the same command, instead of command and file
  std::function<void(SweepSpec&)> change;  // changes the spec
  std::function<void(Plan&)> extend;       // adds runs; cases are unchanged
  // Instead of write_output. True when the results are as required.
  std::function<bool(const SweepSpec&, const Plan&, const Results&, const OutputFolder&)> write;
};

// Returns the exit code: 0; 1 when a check of [[expect]] is not reproduced, or a run of [[parameters]] failed; 3 when
// interrupted. Throws InputError.
int sweep_command(const SweepArguments& arguments);

// Prints that the same command resumes the study, and returns the exit code.
int study_interrupted();

struct OutputFolder {
  explicit OutputFolder(const SweepArguments& arguments);
  std::string path(const std::string& file) const;

  std::string folder, name;  // of the files
  std::string table;         // also write the table for a page to this file; empty: no
  std::string command;       // that makes it
  bool short_form = false;   // without fits, which require all runs
};

// A Slurm job array, each of whose elements repeats the command with --only.
struct JobArray {
  std::size_t elements = 1;
  int tasks = 1;         // MPI processes of an element
  std::string options;   // more of them, of each element
  std::string notes;     // comments of the script; {command} is replaced
  std::string contents;  // the contents of the array, for the message
};
// Writes sweep.sbatch into the folder and prints how it is submitted. Throws InputError.
void write_job_array(const SweepArguments& arguments, const OutputFolder& output, const JobArray& array);

// Writes NAME.md, report.html and, for --table, the page.
void write_page(const StudyPage& page, const OutputFolder& output);
void print_settings(const RunRequest& run);  // as --list shows them

// Prints all results and writes them into the folder. True when all [[expect]] are reproduced and, of [[parameters]], all
// runs are done.
bool write_output(const SweepSpec& spec, const Plan& plan, const Results& results, const OutputFolder& output);

// Throws InputError when the finished run in `folder` lacks a number or column that metrics or plots require: reported
// after the first run, not after the last.
void require_results(const SweepSpec& spec, const std::string& folder);

}  // namespace footfall

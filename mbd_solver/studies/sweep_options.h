#pragma once
// Options of footfall sweep: two programs read them, footfall_studies and, for files with drawn runs, footfall_campaign.

#include <CLI/CLI.hpp>
#include <memory>

#include "mbd_solver/base/option_checks.h"
#include "mbd_solver/studies/sweep_command.h"

namespace footfall {

inline void add_out(CLI::App& command, std::string& out, const std::string& usual) {
  command.add_option("--out", out, "Folder for results (default: " + usual + "/NAME)");
}
inline void add_jobs(CLI::App& command, int& jobs) {
  command
      .add_option("--jobs", jobs,
                  "Runs at once (default: " + (jobs ? std::to_string(jobs) : "as many as the cores allow") + ")")
      ->check(positive());
}
inline void add_only(CLI::App& command, int& only) {
  command.add_option("--only", only, "Only this run, without tables: one element of a job array")
      ->check(within(0, 1 << 30));
}
inline void add_list_and_beds(CLI::App& command, bool& list, bool& beds) {
  CLI::Option* const listing = command.add_flag("--list", list, "List the runs with their settings, and stop");
  command.add_flag("--beds", beds, "Make the beds that the runs need, and stop")->excludes(listing);
}

// Options of sweep and accuracy.
inline void add_sweep_options(CLI::App& command, SweepArguments& a) {
  command.add_option("FILE", a.file, "Sweep file, as in inputs/sweeps and inputs/accuracy")->required();
  add_out(command, a.out, a.runs);
  add_jobs(command, a.jobs);
  command.add_option("--case", a.of_case, "Only this curve, or this case of a stability map");
  add_only(command, a.only);
  command.add_option("--table", a.table, "Also write the table to this file, as Markdown");
  command.add_flag("--short", a.short_form, "The short form of the file, as in tests");
  add_list_and_beds(command, a.list, a.beds);
  command.add_flag("--merge", a.merge, "Tables and plots of the finished runs");
  command.add_flag("--trust-script", a.trust_script,
                   "Runs may start programs that their scenes and scripts name, as of run");
  command.add_flag("--slurm", a.slurm, "Write sweep.sbatch, the runs as a Slurm job array, and stop");
}

inline std::shared_ptr<SweepArguments> sweep_options(CLI::App& command) {
  const auto a = std::make_shared<SweepArguments>();
  a->command = "sweep";
  a->runs = "runs/sweeps";
  a->resume = true;
  add_sweep_options(command, *a);
  command.add_option("--row", a->row, "Repeat this row of a file with drawn runs, with all its files, and stop")
      ->check(within(0, 1 << 30));
  return a;
}

}  // namespace footfall

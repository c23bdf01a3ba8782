#include "mbd_solver/studies/studies.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/command_line.h"
#include "mbd_solver/app/option_checks.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/studies/calibrate_command.h"
#include "mbd_solver/studies/calibration.h"
#include "mbd_solver/studies/experiment.h"
#include "mbd_solver/studies/experiment_command.h"
#include "mbd_solver/studies/rig.h"
#include "mbd_solver/studies/rig_command.h"

namespace footfall {
namespace {

// What `footfall sweep` and `footfall accuracy` have in common: both run an experiment.
void add_experiment_options(CLI::App& command, ExperimentArguments& a) {
  command.add_option("FILE", a.file, "Experiment, as in inputs/sweeps and inputs/accuracy")->required();
  command.add_option("--out", a.out, "Folder for results (default: " + a.runs + "/NAME)");
  command
      .add_option("--jobs", a.jobs,
                  "Runs at once (default: " + (a.jobs ? std::to_string(a.jobs) : "as many as fit the cores") + ")")
      ->check(positive());
  command.add_option("--case", a.of_case, "This curve, or case of a stability map, alone");
  command.add_option("--only", a.only, "This run alone, without tables (one element of a job array)")
      ->check(within(0, 1 << 30));
  command.add_option("--table", a.table, "Write the table to this file as well, as Markdown");
  command.add_flag("--short", a.short_form, "The short form, as the tests run it");
  command.add_flag("--list", a.list, "Make the beds, list the runs, and stop");
  command.add_flag("--merge", a.merge, "Tables and plots of what is there");
  command.add_flag("--slurm", a.slurm, "Write sweep.sbatch, the experiment as a Slurm job array, and stop");
}

Action sweep(CLI::App& command) {
  const auto a = std::make_shared<ExperimentArguments>();
  a->command = "sweep";
  a->runs = "runs/sweeps";
  a->resume = true;
  add_experiment_options(command, *a);
  return [a] { return experiment_command(*a); };
}

Action calibrate(CLI::App& command) {
  const auto a = std::make_shared<CalibrateArguments>();
  command.add_option("FILE", a->file, "Calibration, as in inputs/calibrations")->required();
  command.add_option("--out", a->out, "Folder for results (default: runs/calibrations/NAME)");
  command.add_option("--jobs", a->jobs, "Runs at once (default: as many as fit the cores)")->check(positive());
  command.add_option("--table", a->table, "Write the page to this file as well, as Markdown");
  command.add_flag("--estimate", a->estimate, "Run the start, tell how long all will take, and stop");
  command.add_flag("--so-far", a->so_far, "Run nothing: print what is known by now, beside one that goes on, too");
  return [a] { return calibrate_command(*a); };
}

Action accuracy(CLI::App& command) {
  const auto a = std::make_shared<ExperimentArguments>();
  a->command = "accuracy";
  a->runs = "runs/accuracy";
  a->jobs = 1;
  add_experiment_options(command, *a);
  command.add_flag("--resume", a->resume,
                   "Keep the runs in the folder that were done with the same scene, settings and script");
  return [a] { return experiment_command(*a); };
}

Action rig(CLI::App& command) {
  const auto a = std::make_shared<RigArguments>();
  std::string names;
  for (const Rig& one : all_rigs()) names += std::string(names.empty() ? "" : "; ") + one.name + ": " + one.what;
  command.add_option("NAME", a->name, names)->required();
  command
      .add_option("--file", a->file, "Experiment instead of inputs/rigs/NAME.toml: a copy of it that you have edited")
      ->check(CLI::ExistingFile);
  command.add_option("--out", a->out, "Folder for results (default: runs/rigs/NAME)");
  command.add_option("--set", a->settings, "key=value: change one value of the scene, in every run")
      ->allow_extra_args(false);
  command.add_option("--gravity", a->gravity, "earth, moon, mars, or a number [m/s2] (default: the scene's, earth)");
  command.add_option("--samples", a->samples, "Samples of the bed (default: 3)")->check(positive());
  command.add_flag(
      "--checks", a->checks,
      "Also with a bed of twice the size, grains of half the size, and at half the speed: tells what moves "
      "by more than 5 %. Takes many times as long");
  command.add_option("--jobs", a->jobs, "Runs at once (default: as many as fit the cores)")->check(positive());
  command.add_flag("--short", a->short_form,
                   "A short form on a small bed, as the tests run it; its answers mean nothing");
  command.add_option("--only", a->only, "This run alone, without tables")->check(within(0, 1 << 30));
  command.add_flag("--list", a->list, "Make the beds, list the runs, and stop");
  return [a] { return rig_command(*a); };
}

Action schema(CLI::App& command) {
  const auto experiments = std::make_shared<bool>(false), calibrations = std::make_shared<bool>(false);
  CLI::Option* of_experiments =
      command.add_flag("--experiments", *experiments, "Of the files of footfall sweep and footfall accuracy instead");
  command.add_flag("--calibrations", *calibrations, "Of the files of footfall calibrate instead")
      ->excludes(of_experiments);
  return [experiments, calibrations] {
    std::printf("%s\n", (*experiments    ? experiment_schema()
                         : *calibrations ? calibration_schema()
                                         : scene_schema())
                            .c_str());
    return kExitDone;
  };
}

constexpr Subcommand kStudies[] = {
    {"sweep", "Run a scene with many values, several runs at once; goes on where it was interrupted", sweep},
    {"calibrate", "Find the parameters with which runs meet targets, and how far targets determine them", calibrate},
    {"rig",
     "Measure a bed of grains with an instrument: plate, cone, wheel, shear ring, shear box, slope, sphere, drawn "
     "plate",
     rig},
    {"accuracy", "Error against run time (a study), or a stability map: CSV, picture, table", accuracy},
    {"schema", "Print the JSON schema of scenes, experiments or calibrations, for editors that complete and check",
     schema},
};

}  // namespace

const std::vector<Subcommand>& studies() {
  static const std::vector<Subcommand> all(std::begin(kStudies), std::end(kStudies));
  return all;
}

namespace {

const CLI::App& command_named(const CLI::App& app, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
    if (command->get_name() == name) return *command;
    names.push_back(command->get_name());
  }
  throw InputError("footfall help " + name + ": unknown command." + known_names("commands", name, names));
}

}  // namespace

Action print_help(CLI::App& app, CLI::App& command) {
  struct Arguments {
    std::string command, folder;
    bool man = false, bash = false, zsh = false;
  };
  const auto a = std::make_shared<Arguments>();
  command.add_option("COMMAND", a->command, "Of this command");
  command.add_flag("--man", a->man, "As a man page");
  command.add_flag("--bash", a->bash, "Completion for bash");
  command.add_flag("--zsh", a->zsh, "Completion for zsh");
  command.add_option("--write", a->folder, "Write all man pages and both completions into this folder");
  return [a, &app] {
    if (!a->folder.empty()) {
      write_help_pages(app, a->folder);
      return kExitDone;
    }
    const CLI::App* one = a->command.empty() ? nullptr : &command_named(app, a->command);
    std::string text;
    if (a->bash || a->zsh) {
      text = a->bash ? bash_completion(app) : zsh_completion(app);
    } else if (a->man) {
      text = one ? man_page_of(*one) : man_page(app);
    } else {
      text = app.get_formatter()->make_help(one ? one : &app, "footfall" + (one ? " " + a->command : ""),
                                            CLI::AppFormatMode::Normal);
    }
    std::printf("%s", text.c_str());
    return kExitDone;
  };
}

}  // namespace footfall

// footfall_studies: the commands of footfall that start many runs, and the schema of files. A separate program, so that a
// first run does not wait for its compilation; footfall starts it for these commands.
#include <cstdio>
#include <memory>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/app/command_line.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/studies/calibration.h"
#include "mbd_solver/studies/rig.h"
#include "mbd_solver/studies/rig_command.h"
#include "mbd_solver/studies/sweep_command.h"
#include "mbd_solver/studies/sweep_file.h"
#include "mbd_solver/studies/sweep_options.h"

namespace footfall {
namespace {

Action sweep(CLI::App& command) {
  const auto a = sweep_options(command);
  return [a] { return sweep_command(*a); };
}

Action accuracy(CLI::App& command) {
  const auto a = std::make_shared<SweepArguments>();
  a->command = "accuracy";
  a->runs = "runs/accuracy";
  a->jobs = 1;
  add_sweep_options(command, *a);
  command.add_flag("--resume", a->resume, "Do not repeat finished runs with the same scene, settings and script");
  return [a] { return sweep_command(*a); };
}

Action rig(CLI::App& command) {
  const auto a = std::make_shared<RigArguments>();
  std::string names;
  for (const Rig& one : all_rigs()) names += std::string(names.empty() ? "" : "; ") + one.name + ": " + one.what;
  command.add_option("NAME", a->name, names)->required();
  command.add_option("--file", a->file, "Sweep file instead of inputs/rigs/NAME.toml: an edited copy of it")
      ->check(CLI::ExistingFile);
  add_out(command, a->out, "runs/rigs");
  command.add_option("--set", a->settings, "Change one value of the scene in every run: key=value")
      ->allow_extra_args(false);
  command.add_option("--gravity", a->gravity, "earth, moon, mars, or a number [m/s2] (default: the scene's, earth)");
  command.add_option("--samples", a->samples, "Samples of the bed (default: 3)")->check(positive());
  command.add_flag("--checks", a->checks,
                   "Repeat with a bed of twice the size, grains of half the size, and at half the speed, and report "
                   "changes above 5 %. Takes many times as long");
  add_jobs(command, a->jobs);
  command.add_flag("--short", a->short_form, "A short form on a small bed, as in tests; its results have no meaning");
  add_only(command, a->only);
  add_list_and_beds(command, a->list, a->beds);
  return [a] { return rig_command(*a); };
}

Action schema(CLI::App& command) {
  const auto sweeps = std::make_shared<bool>(false), calibrations = std::make_shared<bool>(false);
  CLI::Option* of_sweeps = command.add_flag("--sweeps,--experiments", *sweeps, "Schema of sweep files");
  command.add_flag("--calibrations", *calibrations, "Schema of calibration files")->excludes(of_sweeps);
  return [sweeps, calibrations] {
    const std::string text = *sweeps ? sweep_schema() : *calibrations ? calibration_schema() : scene_schema();
    std::printf("%s\n", text.c_str());
    return kExitDone;
  };
}

}  // namespace
}  // namespace footfall

int main(int argc, char** argv) {
  using namespace footfall;
  return run_command_line(argc, argv,
                          commands_with({{"sweep", sweep}, {"accuracy", accuracy}, {"rig", rig}, {"schema", schema}}));
}

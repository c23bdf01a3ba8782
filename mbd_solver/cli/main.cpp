// footfall: the front door. It only arranges mbd_solver and liggghts_mbd; whatever it does, the line it prints does
// too.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/analysis/compare_command.h"
#include "mbd_solver/cli/analysis/pictures_command.h"
#include "mbd_solver/cli/analysis/report_command.h"
#include "mbd_solver/cli/analysis/surfaces_command.h"
#include "mbd_solver/cli/experiments/experiment_command.h"
#include "mbd_solver/cli/launch/check_command.h"
#include "mbd_solver/cli/launch/child.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/launch/run_command.h"
#include "mbd_solver/cli/positive.h"

using namespace footfall;

namespace {

// The scene of ./footfall run: here, or else in the checkout that this program was built in.
std::string default_scene() {
  const std::string name = "inputs/landing_mr";
  if (std::filesystem::exists(name)) return name;
  const std::filesystem::path checkout =
      std::filesystem::path(built_program("footfall")).parent_path().parent_path().parent_path();
  const std::filesystem::path scene = checkout / name;
  return std::filesystem::exists(scene) ? scene.string() : name;
}

void add_run(CLI::App& app, RunArguments& a, std::function<int()>& action) {
  CLI::App* run = app.add_subcommand("run", "Run a scene: bed, both programs, summary, pictures");
  run->add_option("SCENE", a.scene, "Scene file, or folder with scene.toml")->capture_default_str();
  run->add_option("--out", a.out, "Folder for results (default: runs/NAME, the first that is free)");
  run->add_option("--until", a.until, "End earlier than the scene says [s]")->check(positive());
  run->add_option("--ranks", a.ranks, "LIGGGHTS processes")->check(positive());
  run->add_option("--set", a.settings, "key=value: change one value of the scene, for example solver.integrator=ida")
      ->allow_extra_args(false);
  run->add_option("--scheme", a.scheme, "Coupling scheme (coupling.scheme)");
  run->add_option("--integrator", a.integrator, "Integrator (solver.integrator)");
  run->add_flag("--quiet", a.quiet, "Only errors");
  run->callback([&] { action = [&a] { return run_command(a); }; });
}

void add_check(CLI::App& app, RunArguments& a, std::function<int()>& action) {
  CLI::App* check = app.add_subcommand("check", "Check a scene: every finding as file:line: key: what is wrong");
  check->add_option("SCENE", a.scene, "Scene file, or folder with scene.toml")->capture_default_str();
  check->add_option("--set", a.settings, "key=value: change one value of the scene")->allow_extra_args(false);
  check->callback([&] { action = [&a] { return check_command(a.scene, a.settings); }; });
}

void add_surfaces(CLI::App& app, RunArguments& a, std::function<int()>& action) {
  CLI::App* surfaces = app.add_subcommand("surfaces", "Draw the control surfaces of a scene's fuzzy controllers");
  surfaces->add_option("SCENE", a.scene, "Scene file, or folder with scene.toml")->capture_default_str();
  surfaces->add_option("--out", a.out, "Folder for the pictures (default: runs/surfaces)");
  surfaces->add_option("--set", a.settings, "key=value: change one value of the scene")->allow_extra_args(false);
  surfaces->callback([&] {
    action = [&a] { return surfaces_command(a.scene, a.settings, a.out.empty() ? "runs/surfaces" : a.out); };
  });
}

// What `footfall sweep` and `footfall accuracy` have in common: both run an experiment.
CLI::App* add_experiment(CLI::App& app, const std::string& name, const std::string& what, ExperimentArguments& a,
                         std::function<int()>& action) {
  CLI::App* command = app.add_subcommand(name, what);
  a.command = name;
  command->add_option("FILE", a.file, "Experiment, as in inputs/sweeps and inputs/accuracy")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("--out", a.out, "Folder for results (default: " + a.runs + "/NAME)");
  command
      ->add_option("--jobs", a.jobs,
                   "Runs at once (default: " + (a.jobs ? std::to_string(a.jobs) : "as many as fit the cores") + ")")
      ->check(positive());
  command->add_option("--case", a.of_case, "This curve, or case of a stability map, alone");
  command->add_option("--only", a.only, "This run alone, without tables (one element of a job array)")
      ->check(CLI::Range(0, 1 << 30));
  command->add_option("--table", a.table, "Write the table to this file as well, as Markdown");
  command->add_flag("--short", a.short_form, "The short form, as the tests run it");
  command->add_flag("--list", a.list, "Make the beds, list the runs, and stop");
  command->add_flag("--merge", a.merge, "Tables and plots of what is there");
  command->add_flag("--slurm", a.slurm, "Write sweep.sbatch, the experiment as a Slurm job array, and stop");
  command->callback([&] { action = [&a] { return experiment_command(a); }; });
  return command;
}

void add_sweep(CLI::App& app, ExperimentArguments& a, std::function<int()>& action) {
  a.runs = "runs/sweeps";
  a.resume = true;
  add_experiment(app, "sweep", "Run a scene with many values, several runs at once; goes on where it was interrupted",
                 a, action);
}

struct CompareArguments {
  std::string run, other;
  bool quiet = false;
};

void add_compare(CLI::App& app, CompareArguments& a, std::function<int()>& action) {
  CLI::App* compare = app.add_subcommand(
      "compare", "Compare the bed of a run with stock LIGGGHTS on the same motion, or with another run");
  compare->add_option("DIR", a.run, "Folder of a run with grains")->required();
  compare->add_option("OTHER", a.other, "Folder of another run (default: stock LIGGGHTS replays the motion of DIR)");
  compare->add_flag("--quiet", a.quiet, "Only errors; the table stands in DIR/compare/comparison.txt");
  compare->callback([&] { action = [&a] { return compare_command(a.run, a.other, a.quiet); }; });
}

void add_pictures(CLI::App& app, PicturesArguments& a, std::function<int()>& action) {
  CLI::App* pictures =
      app.add_subcommand("pictures", "Draw the grains of a run, coloured by speed, and the mechanism: DIR/pictures");
  pictures->add_option("DIR", a.run, "Folder of a run that dumped its grains")->required();
  pictures->add_option("--times", a.times, "Times [s], separated by commas; the nearest dumps are drawn")
      ->delimiter(',')
      ->capture_default_str();
  pictures
      ->add_option("--view", a.view, "Where the eye is: azimuth,elevation [deg] (default: -65,28; with a cut: -90,12)")
      ->delimiter(',')
      ->expected(2);
  pictures->add_flag("--cut", a.cut,
                     "Leave out the grains in front of the foremost coupled surface, to look into its crater");
  pictures->add_option("--cut-at", a.cut_at, "Leave out the grains with y below this [m]")->expected(1);
  pictures->add_option("--fastest", a.fastest, "Speed at the end of the colours [m/s] (default: from the grains)")
      ->check(positive());
  pictures->add_option("--width", a.width, "Width of the drawing [pixels]")
      ->check(CLI::Range(100, 20000))
      ->capture_default_str();
  pictures->callback([&] { action = [&a] { return pictures_command(a); }; });
}

void add_report(CLI::App& app, std::string& folder, std::function<int()>& action) {
  CLI::App* report = app.add_subcommand("report", "One HTML page for a run or a sweep: DIR/report.html");
  report->add_option("DIR", folder, "Folder of a run or of a sweep")->required();
  report->callback([&] {
    action = [&folder] {
      std::printf("%s\n", short_path(write_report(folder)).c_str());
      return kExitDone;
    };
  });
}

void add_accuracy(CLI::App& app, ExperimentArguments& a, std::function<int()>& action) {
  a.runs = "runs/accuracy";
  a.jobs = 1;
  add_experiment(app, "accuracy", "Error against run time (a study), or a stability map: CSV, picture, table", a,
                 action)
      ->add_flag("--resume", a.resume,
                 "Keep the runs in the folder that were done with the same scene, settings and script");
}

void add_test(CLI::App& app, std::string& label, std::function<int()>& action) {
  CLI::App* test = app.add_subcommand("test", "Run the tests of this build (./footfall test builds them first)");
  test->add_option("-L,--label", label,
                   "Only tests of this label: unit, physics, mpi, dem, stock, bad_input, example, accuracy");
  test->callback([&] {
    action = [&label] {
      const std::string build = std::filesystem::path(built_program("footfall")).parent_path().parent_path().string();
      Command command{{"ctest", "--test-dir", build, "--output-on-failure", "-j2"}, {}, "", ""};
      if (!label.empty()) command.words.insert(command.words.end(), {"-L", label});
      return run_child(command).code == 0 ? kExitDone : kExitFailed;
    };
  });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"footfall: a flexible multibody mechanism with controlled dampers touches a bed of particles"};
  app.set_version_flag("--version", std::string("footfall ") + FOOTFALL_VERSION);
  app.require_subcommand(1);
  RunArguments arguments;
  arguments.scene = default_scene();
  ExperimentArguments sweep, accuracy;
  std::string label;
  std::function<int()> action;
  add_run(app, arguments, action);
  add_check(app, arguments, action);
  add_surfaces(app, arguments, action);
  add_sweep(app, sweep, action);
  CompareArguments compare;
  add_compare(app, compare, action);
  PicturesArguments pictures;
  add_pictures(app, pictures, action);
  std::string reported;
  add_report(app, reported, action);
  add_accuracy(app, accuracy, action);
  add_test(app, label, action);
  try {
    app.parse(argc, argv);
    return action();
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kExitDone : kExitBadInput;
  } catch (const InputError& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return kExitBadInput;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "footfall: %s\n", e.what());
    return kExitFailed;
  }
}

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/app/audit.h"
#include "mbd_solver/app/check_command.h"
#include "mbd_solver/app/command_line.h"
#include "mbd_solver/app/compare_command.h"
#include "mbd_solver/app/follow.h"
#include "mbd_solver/app/grain_pictures.h"
#include "mbd_solver/app/new_case.h"
#include "mbd_solver/app/option_checks.h"
#include "mbd_solver/app/plots.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/app/run_command.h"
#include "mbd_solver/app/view_page.h"
#include "mbd_solver/bed/process.h"
#include "mbd_solver/bed/programs.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {

Action new_case(CLI::App& command) {
  struct Arguments {
    std::string name, from;
    bool list = false;
  };
  const auto a = std::make_shared<Arguments>();
  CLI::Option* name = command.add_option("NAME", a->name, "Folder to be made");
  command.add_option("--from", a->from, "What it is a copy of; --list names all")->type_name("CASE");
  command.add_flag("--list", a->list, "List the cases, and stop")->excludes(name);
  return [a] {
    if (a->list) {
      for (const CaseKind& kind : case_kinds())
        std::printf("%-14s %-38s %s\n", kind.name.c_str(), kind.title.c_str(), kind.folder.c_str());
      return kExitDone;
    }
    if (a->name.empty() || a->from.empty())
      throw InputError("footfall new: expected a name and a case, as in `" + called_as() +
                       " new my_wheel --from wheel`; `" + called_as() + " new --list` lists the cases");
    make_case(a->name, a->from);
    std::printf("%s: a copy of \"%s\" to edit\nNext: %s check %s; %s run %s\n", a->name.c_str(), a->from.c_str(),
                called_as().c_str(), a->name.c_str(), called_as().c_str(), a->name.c_str());
    return kExitDone;
  };
}

Action plot_columns(CLI::App& command) {
  const auto a = std::make_shared<ColumnPlot>();
  command.add_option("DIR", a->run, "Folder of a run")->required();
  command
      .add_option("COLUMN", a->columns,
                  "Columns of history.csv: cabin.az; patterns: 'leg_*_primary.stroke', 'struts.*.force'; cabin.v: all "
                  "three axes. None: list them")
      ->expected(0, -1);
  command.add_option("--out", a->out, "File of the picture, .png or .svg (default: both, in DIR/plots)")
      ->type_name("FILE");
  command.add_option("--title", a->title, "Line above the picture (default: the scene's title)");
  return [a] {
    for (const std::string& line : plot_columns(*a)) std::printf("%s\n", line.c_str());
    return kExitDone;
  };
}

Action watch_run(CLI::App& command) {
  const auto a = std::make_shared<WatchArguments>();
  command.add_option("DIR", a->run, "Folder of a run")->required();
  command.add_flag("--page", a->page, "Keep DIR/watch.html up to date as well: a page that refreshes itself");
  command.add_flag("--once", a->once, "Say where the run is, and stop");
  command.add_option("--interval", a->interval, "Time between two looks [s]")->check(positive())->capture_default_str();
  return [a] { return watch_run(*a); };
}

namespace {

// The scene of ./footfall run: here, or else that which comes with this program.
std::string default_scene() {
  const std::string name = "inputs/landing_mr";
  if (std::filesystem::exists(name)) return name;
  try {
    return shipped_file(name);
  } catch (const InputError&) {
    return name;  // whoever needs it says that it is not there
  }
}

constexpr double kTrial = 2.0;  // [s]

// ---- the options of each subcommand, and what it does once they are read ----

Action run(CLI::App& command) {
  const auto a = std::make_shared<RunArguments>();
  a->scene = default_scene();
  CLI::Option* scene =
      command.add_option("SCENE", a->scene, "Scene file, or folder with scene.toml")->capture_default_str();
  CLI::Option* out =
      command.add_option("--out", a->out, "Folder for results (default: runs/NAME, the first that is free)");
  command.add_option("--until", a->until, "End earlier than the scene says [s]")->check(positive());
  CLI::Option* ranks = command.add_option("--ranks", a->ranks, "LIGGGHTS processes")->check(positive());
  CLI::Option* settings = command
                              .add_option("--set", a->settings,
                                          "key=value: change one value of the scene, for example solver.integrator=ida")
                              ->allow_extra_args(false);
  CLI::Option* scheme = command.add_option("--scheme", a->scheme, "Coupling scheme (coupling.scheme)");
  CLI::Option* integrator = command.add_option("--integrator", a->integrator, "Integrator (solver.integrator)");
  command.add_flag("--force", a->force,
                   "Run into the folder of an earlier run; the files that it made are removed first");
  command.add_flag("--trust-script", a->trust_script,
                   "LIGGGHTS scripts of the scene may run programs and write anywhere");
  command
      .add_option("--keep-every", a->keep_every,
                  "Without output.checkpoint_interval: a checkpoint every so often on the clock [s]; 0: none")
      ->check(not_negative())
      ->capture_default_str();
  command.add_flag("--quiet", a->quiet, "Only errors");
  const auto folder = std::make_shared<std::string>();
  CLI::Option* resume = command
                            .add_option("--resume", *folder,
                                        "Go on from the newest checkpoint of the run in this folder (default: the "
                                        "run in runs that was kept last)")
                            ->expected(0, 1);
  // What a run was started with stands in its checkpoint.
  for (CLI::Option* option : {scene, out, ranks, settings, scheme, integrator}) resume->excludes(option);
  return [a, resume, folder] {
    a->resume = resume->count() > 0;
    if (a->resume) a->out = *folder;
    return run_command(*a);
  };
}

Action check(CLI::App& command) {
  const auto a = std::make_shared<RunArguments>();
  a->scene = default_scene();
  command.add_option("SCENE", a->scene, "Scene file, or folder with scene.toml")->capture_default_str();
  command.add_option("--set", a->settings, "key=value: change one value of the scene")->allow_extra_args(false);
  const auto seconds = std::make_shared<double>(0.0);  // a bare --time leaves it so
  CLI::Option* time =
      command
          .add_option("--time", *seconds,
                      "Also run it for so many seconds (default: 2) and tell how long the whole run takes")
          ->expected(0, 1)
          ->check(positive());
  command.add_option("--ranks", a->ranks, "LIGGGHTS processes, for --time")->check(positive())->needs(time);
  return [a, time, seconds] {
    const int code = check_command(a->scene, a->settings);
    return code == kExitDone && time->count() > 0 ? trial_command(*a, *seconds > 0.0 ? *seconds : kTrial) : code;
  };
}

Action surfaces(CLI::App& command) {
  const auto a = std::make_shared<RunArguments>();
  a->scene = default_scene();
  command.add_option("SCENE", a->scene, "Scene file, or folder with scene.toml")->capture_default_str();
  command.add_option("--out", a->out, "Folder for the pictures (default: runs/surfaces)");
  command.add_option("--set", a->settings, "key=value: change one value of the scene")->allow_extra_args(false);
  return [a] { return surfaces_command(a->scene, a->settings, a->out.empty() ? "runs/surfaces" : a->out); };
}

Action compare(CLI::App& command) {
  struct Arguments {
    std::string run, other;
    bool trust_script = false, quiet = false;
  };
  const auto a = std::make_shared<Arguments>();
  command.add_option("DIR", a->run, "Folder of a run with grains")->required();
  command.add_option("OTHER", a->other, "Folder of another run (default: stock LIGGGHTS replays the motion of DIR)");
  command.add_flag("--quiet", a->quiet, "Only errors; the table stands in DIR/compare/comparison.txt");
  command.add_flag("--trust-script", a->trust_script, "The script of DIR may run programs and write anywhere");
  return [a] { return compare_command(a->run, a->other, a->trust_script, a->quiet); };
}

Action audit(CLI::App& command) {
  const auto a = std::make_shared<AuditArguments>();
  a->run.scene = default_scene();
  command.add_option("SCENE", a->run.scene, "Scene file, or folder with scene.toml")->capture_default_str();
  command.add_option("--out", a->run.out, "Folder for results (default: runs/audit, the first that is free)");
  command.add_option("--windows", a->windows, "Windows of the coupling, from the start")
      ->check(positive())
      ->capture_default_str();
  command.add_option("--until", a->run.until, "Go on until then [s], however many windows that are")->check(positive());
  command.add_option("--ranks", a->run.ranks, "LIGGGHTS processes")->check(positive());
  command.add_option("--set", a->run.settings, "key=value: change one value of the scene")->allow_extra_args(false);
  command.add_option("--scheme", a->run.scheme, "Coupling scheme (coupling.scheme)");
  command.add_flag("--force", a->run.force,
                   "Run into the folder of an earlier run; the files that it made are removed first");
  command.add_flag("--trust-script", a->run.trust_script,
                   "LIGGGHTS scripts of the scene may run programs and write anywhere");
  return [a] { return audit_command(*a); };
}

Action pictures(CLI::App& command) {
  const auto a = std::make_shared<PicturesArguments>();
  command.add_option("DIR", a->run, "Folder of a run that dumped its grains")->required();
  command.add_option("--times", a->times, "Times [s], separated by commas; the nearest dumps are drawn")
      ->delimiter(',')
      ->capture_default_str();
  command
      .add_option("--view", a->view, "Where the eye is: azimuth,elevation [deg] (default: -65,28; with a cut: -90,12)")
      ->delimiter(',')
      ->expected(2);
  command.add_flag("--cut", a->cut,
                   "Leave out the grains in front of the foremost coupled surface, to look into its crater");
  command.add_option("--cut-at", a->cut_at, "Leave out the grains with y below this [m]")->expected(1);
  command.add_option("--fastest", a->fastest, "Speed at the end of the colours [m/s] (default: from the grains)")
      ->check(positive());
  command.add_option("--width", a->width, "Width of the drawing [pixels]")
      ->check(within(100, 20000))
      ->capture_default_str();
  return [a] { return pictures_command(*a); };
}

Action view(CLI::App& command) {
  const auto a = std::make_shared<ViewArguments>();
  command.add_option("DIR", a->run, "Folder of a run")->required();
  command.add_option("--frames", a->frames, "Dumps of the grains that the page holds, at most (default: about 100 MB)")
      ->check(within(2, 100000));
  return [a] {
    std::printf("%s\n", short_path(write_view(*a)).c_str());
    return kExitDone;
  };
}

Action report(CLI::App& command) {
  const auto folder = std::make_shared<std::string>();
  command.add_option("DIR", *folder, "Folder of a run or of a sweep")->required();
  return [folder] {
    std::printf("%s\n", short_path(write_report(*folder)).c_str());
    return kExitDone;
  };
}

Action test(CLI::App& command) {
  const auto label = std::make_shared<std::string>();
  command.add_option("-L,--label", *label,
                     "Only tests of this label: unit, physics, mpi, dem, stock, bad_input, example, accuracy");
  return [label] {
    const std::string build = std::filesystem::path(built_program("footfall")).parent_path().parent_path().string();
    if (!std::filesystem::exists(std::filesystem::path(build) / "CTestTestfile.cmake"))
      throw InputError(build + ": holds no tests: an installed program has none. Run ./footfall test in a checkout");
    // Programs of a pair wait for each other, and for mpirun: three tests keep two cores busy.
    Command ctest{{"ctest", "--test-dir", build, "--output-on-failure", "-j3"}, {}, "", ""};
    if (!label->empty()) ctest.words.insert(ctest.words.end(), {"-L", *label});
    return run_child(ctest).code == 0 ? kExitDone : kExitFailed;
  };
}

constexpr Subcommand kSubcommands[] = {
    {"run", "Run a scene: bed, both programs, summary, pictures", run},
    {"new", "Make a folder with a scene of your own to edit, from an example", new_case},
    {"check", "Check a scene: every finding as file:line: key: what is wrong", check},
    {"surfaces", "Draw the control surfaces of a scene's fuzzy controllers", surfaces},
    {"compare", "Compare the bed of a run with stock LIGGGHTS on the same motion, or with another run", compare},
    {"audit", "Check that what grains lose mechanism and walls get: momentum and energy, window by window", audit},
    {"pictures", "Draw the grains of a run, coloured by speed, and the mechanism: DIR/pictures", pictures},
    {"plot", "Plot columns of a run's history: DIR/plots", plot_columns},
    {"watch", "Follow a run that is under way, in the terminal or as a page", watch_run},
    {"view", "One HTML page that plays a run in 3D, with plots: DIR/view.html", view},
    {"report", "One HTML page for a run or a sweep: DIR/report.html", report},
    {"test", "Run the tests of this build (./footfall test builds them first)", test},
};

}  // namespace

const std::vector<Subcommand>& subcommands() {
  static const std::vector<Subcommand> all(std::begin(kSubcommands), std::end(kSubcommands));
  return all;
}

}  // namespace footfall

// The commands of footfall: the options of each, and what it does once they are read.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/app/audit.h"
#include "mbd_solver/app/check_command.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/command_line.h"
#include "mbd_solver/app/compare_command.h"
#include "mbd_solver/app/difference/difference_page.h"
#include "mbd_solver/app/difference/samples.h"
#include "mbd_solver/app/film/film.h"
#include "mbd_solver/app/follow.h"
#include "mbd_solver/app/grain_pictures.h"
#include "mbd_solver/app/new_case.h"

#include "mbd_solver/app/plots.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/app/run_command.h"
#include "mbd_solver/app/view_page.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/option_checks.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

// inputs/landing_mr of the current folder, otherwise the copy of this program.
std::string default_scene() {
  const std::string name = "inputs/landing_mr";
  std::error_code unknown;  // where the current folder may not be entered
  if (fs::exists(name, unknown)) return name;
  try {
    return shipped_file(name);
  } catch (const InputError&) {
    return name;  // the command that reads it reports that it is missing
  }
}

CLI::Option* add_scene(CLI::App& command, std::string& scene) {
  scene = default_scene();
  return command.add_option("SCENE", scene, "Scene file, or folder with scene.toml")->capture_default_str();
}
CLI::Option* add_settings(CLI::App& command, std::vector<std::string>& settings) {
  return command.add_option("--set", settings, "Change one value of the scene: key=value, as in solver.integrator=ida")
      ->allow_extra_args(false);
}
CLI::Option* add_run(CLI::App& command, std::string& run) {
  return command.add_option("DIR", run, "Folder of a run")->required();
}

CLI::Option* add_large(CLI::App& command, bool& large) {
  return command.add_flag("--large", large,
                          "Take the scene's larger version, on more and finer grains: large.toml in its folder");
}

Action run(CLI::App& command) {
  const auto a = std::make_shared<RunArguments>();
  CLI::Option* scene = add_scene(command, a->scene);
  const auto large = std::make_shared<bool>(false);
  CLI::Option* larger = add_large(command, *large);
  CLI::Option* out =
      command.add_option("--out", a->out, "Folder for results (default: runs/NAME, the first that is free)");
  command.add_option("--until", a->until, "End before the scene's end time [s]")->check(positive());
  CLI::Option* ranks = command.add_option("--ranks", a->ranks, "LIGGGHTS processes")->check(positive());
  CLI::Option* settings = add_settings(command, a->settings);
  CLI::Option* scheme = command.add_option("--scheme", a->scheme, "Coupling scheme (coupling.scheme)");
  CLI::Option* integrator = command.add_option("--integrator", a->integrator, "Integrator (solver.integrator)");
  command.add_flag("--force", a->force, "Replace the run in the folder: its files are removed first");
  command.add_flag("--trust-script", a->trust_script,
                   "LIGGGHTS scripts may run programs and write anywhere; FMUs of the scene may run");
  command
      .add_option("--keep-every", a->keep_every,
                  "Wall-clock checkpoint interval [s], unless the scene sets output.checkpoint_interval; 0: none")
      ->check(not_negative())
      ->capture_default_str();
  command.add_flag("--quiet", a->quiet, "Print errors only");
  command.add_flag("--view", a->view, "Show the run in the browser while it proceeds, in 3D");
  const auto folder = std::make_shared<std::string>();
  CLI::Option* resume =
      command
          .add_option("--resume", *folder,
                      "Resume the run in this folder from its newest checkpoint (default: the run in runs with the "
                      "newest one)")
          ->expected(0, 1);
  CLI::Option* audit = command.add_flag("--audit", a->audit,
                                        "Run some windows and check conservation of momentum and energy across the "
                                        "coupling");
  const auto windows = std::make_shared<int>(200);
  command.add_option("--windows", *windows, "Windows of the audit; --until overrides it")
      ->check(positive())
      ->capture_default_str()
      ->needs(audit);
  // A checkpoint holds what its run was started with.
  for (CLI::Option* option : {scene, larger, out, ranks, settings, scheme, integrator, audit}) resume->excludes(option);
  return [a, large, resume, folder, windows] {
    if (*large) a->scene = large_scene_file(a->scene);
    a->resume = resume->count() > 0;
    if (a->resume) a->out = *folder;
    return a->audit ? audit_command(*a, *windows) : run_command(*a);
  };
}

Action check(CLI::App& command) {
  constexpr double kTrial = 2.0;  // [s]
  const auto a = std::make_shared<RunArguments>();
  add_scene(command, a->scene);
  const auto large = std::make_shared<bool>(false);
  add_large(command, *large);
  add_settings(command, a->settings);
  const auto seconds = std::make_shared<double>(0.0);  // stays so for --time without a value
  CLI::Option* time = command
                          .add_option("--time", *seconds,
                                      "Also run the scene for so many seconds (default: 2) and estimate the time of "
                                      "the whole run")
                          ->expected(0, 1)
                          ->check(positive());
  command.add_option("--ranks", a->ranks, "LIGGGHTS processes of --time")->check(positive())->needs(time);
  const auto folder = std::make_shared<std::string>();
  CLI::Option* surfaces = command
                              .add_option("--surfaces", *folder,
                                          "Also draw the control surfaces of the scene's fuzzy controllers into this "
                                          "folder (default: runs/surfaces)")
                              ->expected(0, 1);
  const auto picture = std::make_shared<std::string>();
  command
      .add_option("--picture", *picture,
                  "Also draw the mechanism in its reference configuration, with the axes of its joints: FILE.png, or "
                  "FILE.html to turn it")
      ->type_name("FILE");
  return [=] {
    if (*large) a->scene = large_scene_file(a->scene);
    int code = check_command(a->scene, a->settings);
    if (code == kExitDone && !picture->empty()) code = draw_reference(read_scene(a->scene, a->settings), *picture);
    if (code == kExitDone && time->count() > 0) code = trial_command(*a, *seconds > 0.0 ? *seconds : kTrial);
    if (code == kExitDone && surfaces->count() > 0)
      code = draw_control_surfaces(a->scene, a->settings, folder->empty() ? "runs/surfaces" : *folder);
    return code;
  };
}

Action new_case(CLI::App& command) {
  struct Arguments {
    std::string name, from;
    bool list = false;
  };
  const auto a = std::make_shared<Arguments>();
  CLI::Option* name = command.add_option("NAME", a->name, "Folder to create");
  command.add_option("--from", a->from, "Example to copy; --list lists them. Or a robot: URDF, SDF or MJCF file")
      ->type_name("CASE");
  command.add_flag("--list", a->list, "List the examples, and stop")->excludes(name);
  return [a] {
    if (a->list) {
      for (const CaseKind& kind : case_kinds())
        std::printf("%-14s %-38s %s\n", kind.name.c_str(), kind.title.c_str(), kind.folder.c_str());
      return kExitDone;
    }
    const std::string self = called_as();
    if (a->name.empty() || a->from.empty())
      throw InputError(code::kWrongOption, "footfall new: expected a name and an example, as in `" + self +
                                               " new my_wheel --from wheel`; `" + self + " new --list` lists them");
    if (is_robot_file(a->from)) return start_import({"import", a->from, "--out", a->name});
    make_case(a->name, a->from);
    std::printf("%s: a copy of \"%s\" to edit\nNext: %s check %s; %s run %s\n", a->name.c_str(), a->from.c_str(),
                self.c_str(), a->name.c_str(), self.c_str(), a->name.c_str());
    return kExitDone;
  };
}

// azimuth, elevation; of the page also zoom and the point in the middle.
void require_camera(const std::vector<double>& camera, bool films, bool draws) {
  if (camera.empty()) return;
  if (!films && !draws) throw InputError(code::kWrongOption, "--camera belongs to --png, --video and --pictures");
  const std::size_t n = camera.size();
  if (n == 2 || (films && (n == 3 || n == 6) && camera[2] > 0.0)) return;
  throw InputError(code::kWrongOption,
                   "--camera: has " + std::to_string(n) + " numbers, expected azimuth,elevation" +
                       (films ? ", or also a zoom above 0, or also x,y,z of the point in the middle" : ""));
}

Action view(CLI::App& command) {
  struct Arguments {
    ViewArguments page;
    PicturesArguments pictures;
    FollowArguments follow;
    FilmArguments film;
    std::string png, video;
    bool draw = false, watch = false;
  };
  const auto a = std::make_shared<Arguments>();
  add_run(command, a->page.run);
  command.add_option("OTHER", a->page.other,
                     "Folder of a second run: a ghost in the picture, dashed in the plots, with the difference");
  command.add_option("--frames", a->page.frames, "Dumps of grains in the page, at most (default: about 100 MB)")
      ->check(within(2, 100000));
  CLI::Option* draw =
      command.add_flag("--pictures", a->draw, "Draw DIR/pictures instead: grains coloured by speed, and the mechanism");
  PicturesArguments& p = a->pictures;
  command.add_option("--times", p.times, "Times [s], separated by commas; the nearest dumps are drawn")
      ->delimiter(',')
      ->capture_default_str()
      ->needs(draw);
  FilmArguments& v = a->film;
  CLI::Option* png =
      command
          .add_option("--png", a->png, "Draw what the page shows at one time instead, by Chromium: the name of a .png")
          ->type_name("FILE")
          ->excludes(draw);
  CLI::Option* video =
      command
          .add_option("--video", a->video,
                      "Make a video of the page instead, by Chromium and ffmpeg: the name of a .mp4 or .webm")
          ->type_name("FILE")
          ->excludes(draw)
          ->excludes(png);
  command.add_option("--at", v.at, "Time of --png [s] (default: the middle of the run)")
      ->check(not_negative())
      ->needs(png);
  command.add_option("--from", v.from, "Start of the video [s]")
      ->check(not_negative())
      ->capture_default_str()
      ->needs(video);
  command.add_option("--to", v.to, "End of the video [s] (default: end of the run)")->check(positive())->needs(video);
  command.add_option("--fps", v.rate, "Pictures in a second of the video")
      ->check(within(1, 120))
      ->capture_default_str()
      ->needs(video);
  command
      .add_option("--slow", v.slow,
                  "Seconds of the video per second of the run; 1: real time (default: the video lasts 5 to 12 s)")
      ->check(positive())
      ->needs(video);
  command.add_option("--size", v.size, "Size of --png or --video: width,height [pixels] (default: 1280,720)")
      ->delimiter(',')
      ->expected(2);
  command.add_option("--show", v.show,
                     "What else --png or --video shows, as in the address of a page: grains=force&track=cabin&names=1");
  command
      .add_option(
          "--camera", p.camera,
          "Camera: azimuth,elevation [deg] (default: -65,28; with a cut: -90,12); --png, --video: also ,zoom and "
          ",x,y,z of the point in the middle [m]")
      ->delimiter(',')
      ->expected(2, 6);
  command.add_flag("--cut", p.cut, "Leave out grains in front of the foremost coupled surface, to show its crater")
      ->needs(draw);
  command.add_option("--cut-at", p.cut_at, "Leave out grains with y below this [m]")->expected(1)->needs(draw);
  command.add_option("--fastest", p.fastest, "Speed at the end of the colour scale [m/s] (default: from the grains)")
      ->check(positive())
      ->needs(draw);
  command.add_option("--width", p.width, "Width of the pictures [pixels]")
      ->check(within(100, 20000))
      ->capture_default_str()
      ->needs(draw);
  CLI::Option* follow = command
                            .add_flag("--follow", a->watch,
                                      "Follow a run in progress instead, in the terminal and as a page in the browser")
                            ->excludes(draw)
                            ->excludes(png)
                            ->excludes(video);
  FollowArguments& f = a->follow;
  command.add_flag("--once", f.once, "Print the progress once, and stop")->needs(follow);
  command.add_option("--interval", f.interval, "Time between two updates [s]")
      ->check(positive())
      ->capture_default_str()
      ->needs(follow);
  return [a] {
    a->pictures.run = a->follow.run = a->film.run = a->page.run;
    a->film.other = a->page.other;
    if (!a->page.other.empty() && (a->draw || a->watch))
      throw InputError(code::kWrongOption, "two folders belong to the page, --png and --video; name one for " +
                                               std::string(a->draw ? "--pictures" : "--follow"));
    const bool films = !a->png.empty() || !a->video.empty();
    require_camera(a->pictures.camera, films, a->draw);
    if (!films && (!a->film.size.empty() || !a->film.show.empty()))
      throw InputError(code::kWrongOption, "--size and --show belong to --png and --video");
    a->film.camera = a->pictures.camera;
    a->film.frames = a->page.frames;
    if (films) {
      a->film.file = a->png.empty() ? a->video : a->png;
      return a->png.empty() ? make_video(a->film) : draw_page_picture(a->film);
    }
    if (a->draw) return draw_grain_pictures(a->pictures);
    if (a->watch) return follow_run(a->follow);
    std::printf("%s\n", short_path(write_view(a->page)).c_str());
    return kExitDone;
  };
}

Action report(CLI::App& command) {
  const auto folder = std::make_shared<std::string>(), other = std::make_shared<std::string>();
  command.add_option("DIR", *folder, "Folder of a run or of a sweep")->required();
  command.add_option("OTHER", *other, "Folder of a second run: report in what the two differ, in DIR/difference.html");
  return [folder, other] {
    const std::string file = other->empty() ? write_report(*folder) : write_difference(*folder, *other);
    std::printf("%s\n", short_path(file).c_str());
    return kExitDone;
  };
}

Action plot(CLI::App& command) {
  const auto a = std::make_shared<ColumnPlot>();
  add_run(command, a->run);
  command
      .add_option("COLUMN", a->columns,
                  "First, for two runs or sweeps over each other: the folder of the second. Columns of history.csv: "
                  "cabin.az; patterns: 'leg_*_primary.stroke', 'struts.*.force'; cabin.v: all three axes. None: list "
                  "them")
      ->expected(0, -1);
  command.add_option("--out", a->out, "File of the picture, .png, .svg or .pdf (default: PNG and SVG, in DIR/plots)")
      ->type_name("FILE");
  command.add_option("--title", a->title, "Title of the picture (default: the scene's)");
  const auto style = std::make_shared<std::string>(name_of(PlotStyle::kLight));
  command.add_option("--style", *style, "Colours: light, dark, or print")
      ->check(CLI::IsMember(names_of<PlotStyle>()))
      ->capture_default_str();
  constexpr double kQuality = 10.0;
  const auto quality = std::make_shared<double>(kQuality), window = std::make_shared<double>(0.0);
  CLI::Option* srs =
      command
          .add_option("--srs", *quality,
                      "Draw shock response spectra for this quality Q = 1 / (2 damping ratio) (default: 10)")
          ->expected(0, 1)
          ->check(within(1, 1000000));
  CLI::Option* psd =
      command
          .add_option("--psd", *window,
                      "Draw power spectral densities, of windows of this length [s] (default: an eighth of "
                      "the run)")
          ->expected(0, 1)
          ->check(positive())
          ->excludes(srs);
  command.add_option("--cfc", a->cfc, "Also draw the columns filtered by this class of SAE J211: 60, 180, 600 or 1000")
      ->check(CLI::IsMember({60, 180, 600, 1000}))
      ->excludes(srs)
      ->excludes(psd);
  return [=] {
    const auto has_results = [](const std::string& word) {
      return fs::exists(fs::path(word) / "history.csv") || is_sweep(word);
    };
    const bool spectra = srs->count() + psd->count() > 0 || a->cfc > 0;
    if (spectra && is_sweep(a->run))
      throw InputError(code::kWrongOption, "--srs, --psd and --cfc belong to one run; name a folder in " +
                                               (fs::path(a->run) / "runs").string());
    if (!a->columns.empty() && has_results(a->columns.front())) {
      a->other = a->columns.front();
      a->columns.erase(a->columns.begin());
      if (a->columns.empty())
        throw InputError(code::kWrongOption,
                         "footfall plot: a column is missing, expected: footfall plot DIR OTHER COLUMN");
      if (spectra) throw InputError(code::kWrongOption, "--srs, --psd and --cfc belong to one run; name one folder");
    }
    for (const PlotStyle known : every<PlotStyle>())
      if (*style == name_of(known)) a->style = known;
    if (srs->count() > 0) a->srs = *quality > 0.0 ? *quality : kQuality;
    if (psd->count() > 0) a->psd = *window;
    for (const std::string& line : plot_columns(*a)) std::printf("%s\n", line.c_str());
    return kExitDone;
  };
}

Action compare(CLI::App& command) {
  struct Arguments {
    std::string run, other;
    bool trust_script = false, quiet = false;
  };
  const auto a = std::make_shared<Arguments>();
  command.add_option("DIR", a->run, "Folder of a run with grains")->required();
  command.add_option("OTHER", a->other, "Folder of another run (default: stock LIGGGHTS replays the motion of DIR)");
  command.add_flag("--quiet", a->quiet, "Print errors only; the table is in DIR/compare/comparison.txt");
  command.add_flag("--trust-script", a->trust_script, "The script of DIR may run programs and write anywhere");
  return [a] { return compare_command(a->run, a->other, a->trust_script, a->quiet); };
}

Action test(CLI::App& command) {
  struct Arguments {
    bool all = false, nightly = false;
    std::string label;
  };
  const auto a = std::make_shared<Arguments>();
  CLI::Option* all = command.add_flag("--all", a->all, "Also the tests that take half an hour");
  command.add_flag("--nightly", a->nightly, "All tests, some hours")->excludes(all);
  command.add_option("-L,--label", a->label, "Of these, only tests of a label, such as unit, physics, coupled, app");
  return [a] {
    const fs::path build = fs::path(built_program("footfall")).parent_path().parent_path();
    if (!fs::exists(build / "CTestTestfile.cmake"))
      throw InputError(code::kNoTests, build.string() + ": holds no tests; run ./footfall test in a checkout");
    // The two programs of a coupled test wait for each other: three tests keep two cores busy.
    Command ctest{
        Rights::of_user(), {"ctest", "--test-dir", build.string(), "--output-on-failure", "-j3"}, mpirun().environment};
    if (!a->nightly) ctest.words.insert(ctest.words.end(), {"-L", a->all ? "tier_quick|tier_all" : "tier_quick"});
    if (!a->label.empty()) ctest.words.insert(ctest.words.end(), {"-L", a->label});
    return run_child(ctest).code == 0 ? kExitDone : kExitFailed;
  };
}

}  // namespace

const std::vector<Subcommand>& subcommands() {
  static const std::vector<Subcommand> all = commands_with({{"run", run},
                                                            {"check", check},
                                                            {"new", new_case},
                                                            {"view", view},
                                                            {"report", report},
                                                            {"plot", plot},
                                                            {"compare", compare},
                                                            {"test", test}});
  return all;
}

}  // namespace footfall

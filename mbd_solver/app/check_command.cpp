// Checks a scene by reading it and building its mechanism. The trial starts both programs as a run does and stops them
// after some seconds.
#include "mbd_solver/app/check_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/interrupt.h"
#include "coupler/base/pulse.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/film/page_camera.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/assemble/law_files.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/bed/bed.h"
#include "mbd_solver/bed/bed_forecast.h"
#include "mbd_solver/bed/bed_report.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/launch/program_watch.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/model/control/fuzzy_controller.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/foreign/foreign_code.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/observe/start_check.h"
#include "mbd_solver/session/observe/start_values.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {
namespace {

// The dump of the grains of a bed in the cache, as a run gets it; empty without one.
std::string grains_of_bed(const Scene& scene) {
  if (!scene.touches_particles() || !scene.particles->bed) return "";
  const std::string folder = bed_folder(*scene.particles->bed), grains = folder + "/" + kBedGrains;
  std::error_code error;
  return bed_is_made(folder) && std::filesystem::exists(grains, error) ? grains : "";
}

void warn_about(const Scene& scene, const std::string& warning) {
  if (!scene.accepts(warning)) std::fprintf(stderr, "footfall: warning: %s\n", warning.c_str());
}

// Faults that only building the mechanism finds; grains are taken from the bed in the cache. Returns what it proposes.
std::string check(Scene scene, bool judges) {
  std::string proposal;
  if (judges && scene.touches_particles() && scene.particles->grains.empty())
    scene.particles->grains = grains_of_bed(scene);
  const auto warn = [&scene](const std::string& warning) { warn_about(scene, warning); };
  check_by_building(scene, judges, warn, [&](const Scene& placed, const Mechanism& mechanism) {
    require_inside_box(placed, mechanism);
    if (!judges) return;
    for (const std::string& warning : leaving_bodies(placed, mechanism)) warn(warning);
    if (placed.touches_particles() && placed.particles->box)
      proposal = proposal_text(placed, proposed_bed(placed, mechanism));
  });
  if (judges)
    for (const std::string& warning : unset_signals(scene)) warn(warning);
  return proposal;
}

constexpr double kPatience = 8.0;  // [s] what settles for longer is left to the run

// A mechanism that settles at the start comes to rest, as mbd_solver finds. Where it does not find out, that is reported.
void require_rest(const Scene& scene, const std::string& argument, const std::vector<std::string>& settings) {
  if (!scene.initial.settle) return;
  const ScratchFolder temporary("footfall_check");
  const std::string program = built_program(kMbdProgram);
  Command command{Rights::starting({program}), {program, argument, "--start"}, {}, temporary.path() + "/output.txt"};
  for (const std::string& setting : settings) command.words.push_back("--set=" + setting);
  const double begun = wall_clock();
  const ChildEnd end = run_child(command, kMbdProgram, [&] {
    return wall_clock() - begun > kPatience ? "it still moves after " + number_text(kPatience) + " s of computing" : "";
  });
  if (end.interrupted) throw Interrupted(code::kInterruptedEarly, "interrupted while the mechanism settles");
  if (end.code == kExitDone && end.given_up.empty()) return;
  const std::string text = read_whole_file(command.output).value_or(""), name = std::string(kMbdProgram) + ": ";
  const std::size_t begin = text.rfind(name, 0) == 0 ? name.size() : 0;
  const std::string said = text.substr(begin, text.find_last_not_of('\n') + 1 - begin);
  if (end.code == kExitBadInput && end.given_up.empty()) throw InputError(said);
  const std::string warning = with_code(
      code::kRestNotKnown, place_of(scene.file, scene.initial.source, "settle") +
                               "whether the mechanism comes to rest is not known: " +
                               (end.given_up.empty() ? "it failed to settle: " + said : end.given_up) +
                               ". The run finds out before its first step; support what may move, or remove settle");
  warn_about(scene, warning);
}

// What the last run of the scene in runs/ says of its walls; empty if no run has watched them.
std::string walls_of_last_run(const Scene& scene) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::file_time_type last = fs::file_time_type::min();
  std::string text;
  for (const fs::directory_entry& entry : fs::directory_iterator("runs", error)) {
    const fs::path file = entry.path() / "summary.json";
    const fs::file_time_type time = fs::last_write_time(file, error);
    if (error || time <= last) continue;
    try {
      const nlohmann::ordered_json summary = read_summary(file.string());
      if (summary.value("scene_file", "") != fs::absolute(scene.file).lexically_normal().string()) continue;
      last = time;
      text.clear();
      const nlohmann::ordered_json ledger = summary.value("ledger", nlohmann::ordered_json::object());
      if (!ledger.contains("energy_to_floor_share")) continue;
      const auto share = [&](const char* key) { return number_text(100.0 * ledger.value(key, 0.0), 2) + " %"; };
      text = "The last run (" + entry.path().string() + "): of the energy given to the grains at most " +
             share("energy_to_floor_share") + " was at the floor, " + share("energy_to_sides_share") +
             " at the side walls.\n";
    } catch (const std::exception&) {  // of another program, or damaged
    }
  }
  return text;
}

// Where the host of FMUs is not built, their variables remain unchecked.
void check_foreign_code(const Scene& scene) {
  if (runs_foreign_code(scene) && fmu_host().empty()) {
    const std::string text = scene.file + ": the FMUs of its signals are not checked: footfall_fmu_host is not built; ";
    std::fprintf(stderr, "footfall: warning: %s\n", with_code(code::kFmuUnchecked, text + kBuildFmuHost).c_str());
    return;
  }
  require_foreign_code(scene);
}

}  // namespace

Scene checked_scene(const std::string& argument, const std::vector<std::string>& settings) {
  const Scene scene = read_scene(argument, settings);
  check(scene, false);  // its warnings include the scene's
  return scene;
}

int check_command(const std::string& argument, const std::vector<std::string>& settings) {
  const Scene scene = read_scene(argument, settings);
  const std::string proposal = check(scene, true);
  require_rest(scene, argument, settings);
  check_foreign_code(scene);
  const char* grounds[] = {"no ground", "a rigid plane", "particles", "a soil without grains"};
  double mass = 0.0;  // without rocks of a terrain, which stand still
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  const std::size_t rocks = bed ? bed->rocks.size() : 0;
  for (std::size_t k = 0; k + rocks < scene.bodies.size(); ++k) mass += scene.bodies[k].mass;
  std::printf(
      "%s: no faults. %zu bodies (%g kg), %zu joints, %zu struts, %zu cables, %zu springs, %zu controllers, %zu "
      "boundaries on %s.\n",
      scene.file.c_str(), scene.bodies.size(), mass, scene.joints.size(), scene.struts.size(), scene.cables.size(),
      scene.springs.size(), scene.controllers.size(), scene.boundaries.size(),
      grounds[static_cast<int>(scene.ground.kind)]);
  if (scene.touches_particles())
    std::fputs(
        (scene.particles->box ? box_report(scene) + proposal + walls_of_last_run(scene) : script_report(scene)).c_str(),
        stdout);
  return kExitDone;
}

RunTime expected_run_time(const nlohmann::ordered_json& trial, double t_end) {
  constexpr double kFewest = 0.25;  // least share of the trial's steps that are taken later
  constexpr double kGrown = 0.8;  // below this ratio of steps per simulated second, later to earlier, steps have grown
  const auto at = [&](const char* what, std::size_t mark) { return trial.at(what).at(mark).get<double>(); };
  const auto late = [&](const char* what) { return at(what, 2) - at(what, 1); };
  const auto early = [&](const char* what) { return at(what, 1) - at(what, 0); };
  const double rest = std::max(0.0, t_end - at("time_s", 2)) / late("time_s");  // in second halves of the trial
  const double grains = late("dem_wall_s") * rest;
  const double grains_early =
      early("time_s") > 0.0 ? early("dem_wall_s") / early("time_s") * late("time_s") * rest : grains;
  const double most = std::max(0.0, late("wall_s") - late("dem_wall_s")) * rest;
  const double share = late("steps") > 0.0 ? std::clamp(late("windows") / late("steps"), kFewest, 1.0) : 1.0;
  const bool grown = late("steps") * early("time_s") < kGrown * early("steps") * late("time_s");
  const double so_far = at("wall_s", 2);
  RunTime time;
  time.seconds = so_far + grains + (grown ? std::sqrt(share) * most : most);
  time.least = so_far + std::min(grains, grains_early) + share * most;
  time.most = so_far + std::max(grains, grains_early) + most;
  time.share_of_grains = (at("dem_wall_s", 2) + grains) / time.seconds;
  return time;
}

std::string duration_text(double seconds) {
  if (seconds < 99.5) return number_text(seconds, 2) + " s";
  if (seconds < 99.5 * 60.0) return number_text(seconds / 60.0, 2) + " min";
  const double hours = seconds / 3600.0;
  return (hours < 99.5 ? number_text(hours, 2) : fixed_text(hours, 0)) + " h";
}

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

void print_coupling(const Json& summary) {
  std::printf("  %ld grains, time step %g s, ", summary.at("particles").get<long>(),
              summary.at("dt_dem_s").get<double>());
  const Json& substeps = summary.at("substeps_per_window");
  std::printf("%s per window\n",
              substeps.is_number() ? (substeps.dump() + " steps").c_str() : "as many steps as required");
  std::string body;
  double largest = 0.0;
  const Json by_body = summary.value("max_omega_h", Json::object());
  for (const auto& [name, value] : by_body.items())
    if (value.get<double>() > largest) {
      largest = value.get<double>();
      body = name;
    }
  if (body.empty()) {
    std::printf("  omega H: no body has touched grains so far\n");
  } else {
    std::printf("  largest omega H so far: %.2g (%s); overlaps up to %s of the radius\n", largest, body.c_str(),
                share_text(summary.at("max_overlap_over_radius").get<double>()).c_str());
  }
}

void print_time(const Json& summary, double t_end, double started, double memory) {
  const double reached = summary.at("end_time_s").get<double>();
  const double wall = summary.at("wall_s").get<double>();
  if (summary.at("status") == "done") {
    std::printf("Run time: %s; the trial was the whole run\n", duration_text(started + wall).c_str());
  } else {
    const RunTime time = expected_run_time(summary.at("trial"), t_end);
    std::printf("Run time: about %s (%s to %s) at the present load of this machine; trial of %s, to t = %g of %g s\n",
                duration_text(started + time.seconds).c_str(), duration_text(started + time.least).c_str(),
                duration_text(started + time.most).c_str(), duration_text(wall).c_str(), reached, t_end);
    if (summary.contains("particles"))
      std::printf("  %s of it in LIGGGHTS\n", share_text(time.share_of_grains).c_str());
  }
  std::printf("  memory: %.0f MB in all programs\n", memory / 1e6);
}

}  // namespace

int trial_command(const RunArguments& given, double seconds) {
  end_on_signals("footfall");
  RunArguments arguments = given;
  const Scene scene = read_scene(arguments.scene, arguments.settings);
  if (scene.touches_particles() && scene.particles->bed && !bed_is_made(bed_folder(*scene.particles->bed))) {
    std::printf("Run time: unknown until the bed is made; `%s run %s --until %g` makes it\n", called_as().c_str(),
                short_path(scene.file).c_str(), 1e-3 * scene.end_time);
    return kExitDone;
  }
  const ScratchFolder temporary("footfall_trial");
  const fs::path folder = temporary.path();
  arguments.out = (folder / "run").string();
  arguments.quiet = true;
  arguments.keep_every = 0.0;
  RunPlan plan = new_run(arguments);
  Command& command = plan.command;
  command.words.insert(command.words.end(), {"--try-for", number_text(seconds)});
  command.environment[kLockedFolder] = locked_name(plan.out);
  command.output = (folder / "output.txt").string();
  leave_time_to_end(command);

  double memory = 0.0;
  const double begun = wall_clock();
  SuspendedWatch suspended(scene.coupling.timeout);
  const std::string pulse = (fs::path(plan.out) / kLockFile).string();
  command.environment[kPulse] = fs::absolute(pulse).string();
  ProgramWatch progress(scene.coupling.timeout, pulse, (fs::path(plan.out) / "history.csv").string(), plan.log);
  const ChildEnd end = run_child(command, kMbdProgram, [&] {
    memory = std::max(memory, memory_of_descendants());
    const std::string stuck = suspended();
    return stuck.empty() && scene.touches_particles() ? progress() : stuck;
  });
  if (end.interrupted) return kExitInterrupted;
  const fs::path summary_file = fs::path(plan.out) / "summary.json";
  const std::string errors = liggghts_errors(plan.log);
  const Json summary = fs::exists(summary_file) ? read_summary(summary_file.string()) : Json::object();
  const std::string status = with_summary_of(plan.out, [&] { return summary.value("status", ""); });
  if (!errors.empty() || (status != "done" && status != "interrupted")) {
    std::string why = end.given_up.empty() ? "" : ": " + end.given_up;
    if (!errors.empty())
      why = ": LIGGGHTS stopped at " +
            why_liggghts_stopped(plan.log, scene.particles->script, scene.particles->variables);
    std::fprintf(stderr, "%sfootfall: %s\n", read_whole_file(command.output).value_or("").c_str(),
                 with_code(code::kTrialFailed, "the trial failed" + why).c_str());
    return !errors.empty() || end.code == kExitBadInput ? kExitBadInput : kExitFailed;
  }
  with_summary_of(plan.out, [&] {
    const Json& trial = summary.at("trial");
    const double started = trial.is_null() ? 0.0 : std::max(0.0, trial.at("begun").get<double>() - begun);
    print_time(summary, scene.end_time, started, memory);
    if (summary.contains("particles")) print_coupling(summary);
    return 0;
  });
  return kExitDone;
}

namespace {

constexpr std::pair<const char*, const char*> kSecond[] = {{"da", "da [g in 0.1 s]"}, {"alpha", "alpha (pitch) [deg]"}};

std::vector<std::string> write_scripts(const ControllerSpec& controller, const std::string& out) {
  const FuzzySystem system(read_fll(controller.file));
  std::vector<std::string> scripts;
  for (int output : {0, 2}) {
    if (output >= system.output_count()) continue;
    const std::string name = "U" + std::to_string(output + 1);
    for (const auto& [second, axis] : kSecond) {
      const ControlSurface surface = control_surface(system, output, "a", second);
      SurfacePicture picture{controller.name + "_" + name + "_a_" + second,
                             name + " of " + controller.name,
                             "a [g]",
                             axis,
                             name + " [-]",
                             surface.first,
                             surface.second,
                             surface.voltage};
      scripts.push_back(write_surface_script(out, picture));
    }
  }
  return scripts;
}

}  // namespace

int draw_control_surfaces(const std::string& scene_argument, const std::vector<std::string>& settings,
                          const std::string& out) {
  const Scene scene = read_scene(scene_argument, settings);
  std::vector<std::string> scripts;
  for (const ControllerSpec& controller : scene.controllers) {
    if (controller.kind != ControllerKind::kFuzzy) continue;
    const std::vector<std::string> more = write_scripts(controller, out);
    scripts.insert(scripts.end(), more.begin(), more.end());
  }
  if (scripts.empty())
    throw InputError(code::kNoSurfaces,
                     scene.file + ": controllers: none is of kind \"fuzzy\", so there is no surface");
  for (const std::string& picture : run_gnuplot(out, scripts)) std::printf("%s\n", short_path(picture).c_str());
  return kExitDone;
}

}  // namespace footfall

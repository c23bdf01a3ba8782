#include "mbd_solver/cli/run_command.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/analysis/results.h"
#include "mbd_solver/cli/launch/bed.h"
#include "mbd_solver/cli/launch/check_command.h"
#include "mbd_solver/cli/launch/child.h"
#include "mbd_solver/cli/launch/grain_rows.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/output/checkpoint_folder.h"
#include "mbd_solver/output/run_start.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// "inputs/landing_mr/scene.toml" -> "landing_mr", "drop.toml" -> "drop".
std::string scene_name(const std::string& file) {
  const fs::path path = fs::absolute(file).lexically_normal();
  return path.filename() == "scene.toml" ? path.parent_path().filename().string() : path.stem().string();
}

// runs/NAME, runs/NAME-2, ...: no run is ever overwritten without being asked to.
std::string free_folder(const std::string& name) {
  fs::path folder = fs::path("runs") / name;
  for (int k = 2; fs::exists(folder); ++k) folder = fs::path("runs") / (name + "-" + std::to_string(k));
  return folder.string();
}

// What an earlier run left in a folder that is used again must not be taken for ours.
void clear_results(const std::string& out) {
  make_folder(out);
  std::error_code error;
  for (const char* name :
       {"summary.json", "history.csv", "ledger.csv", "grains_energy.txt", "grains_energy_start.txt",
        "grains_energy.before.txt", "checkpoint", "liggghts.log", "plots", "pictures", "vtk", "motion", "compare"})
    fs::remove_all(fs::path(out) / name, error);
}

// What is started, and where it leaves its results.
struct Plan {
  Scene scene;
  std::string out, log;
  Command command;
};

// LIGGGHTS goes on where its script reads the restart file ${bed} first of all, and does the rest in one run.
void demand_resumable(const ParticlesSpec& particles) {
  std::map<std::string, std::string> variables = particles.variables;
  variables["bed"] = "the file that -var bed names";
  bool reads_bed = false;
  int runs = 0;
  const ScriptText script(particles.script, variables);
  for (const ScriptCommand& command : script.commands()) {
    const std::string where = command.file + ":" + std::to_string(command.line) + ": ";
    const auto refuse = [&](const std::string& why) {
      throw InputError(where + command.words[0] + ": a run with this script cannot be resumed: " + why);
    };
    if (command.words[0] == "read_restart" && command.words.size() > 1)
      reads_bed = joined(command.words, " ").find(variables["bed"]) != std::string::npos;
    if (command.words[0] == "reset_timestep") refuse("LIGGGHTS would forget at which step it goes on");
    if (command.words[0] == "run" && ++runs > 1) refuse("it is the second one, and nobody knows in which the run was");
  }
  if (!reads_bed)
    throw InputError(particles.script +
                     ": a run with this script cannot be resumed: it must get its grains by `read_restart ${bed}`, so "
                     "that -var bed can name those of the checkpoint");
}

std::vector<std::string> solver_words(const RunArguments& a, const std::string& out, const std::string& grains) {
  std::vector<std::string> words = {built_program("mbd_solver"), short_path(a.scene), "--out", out};
  if (a.until > 0.0) words.insert(words.end(), {"--until", number_text(a.until, 12)});
  if (!a.scheme.empty()) words.insert(words.end(), {"--scheme", a.scheme});
  if (!a.integrator.empty()) words.insert(words.end(), {"--integrator", a.integrator});
  for (const std::string& setting : a.settings) words.insert(words.end(), {"--set", setting});
  if (!grains.empty()) words.insert(words.end(), {"--set", "particles.grains=\"" + grains + "\""});
  if (a.quiet) words.push_back("--quiet");
  return words;
}

// mpirun ... liggghts_mbd ... : -np 1 mbd_solver ...
Command both_programs(const ParticlesSpec& particles, int ranks, const std::string& out, const std::string& restart,
                      const std::string& log, const std::vector<std::string>& solver) {
  Command command = mpirun();
  const auto append = [&](const std::vector<std::string>& words) {
    command.words.insert(command.words.end(), words.begin(), words.end());
  };
  append({"-np", std::to_string(ranks), built_program("liggghts_mbd")});
  append(script_arguments(particles.script, particles.variables));
  append({"-var", "out", out});
  if (!restart.empty()) append({"-var", "bed", restart});
  append({"-log", log, "-screen", "none"});
  append({":", "-np", "1"});
  append(solver);
  return command;
}

// A run from the start.
Plan new_run(const RunArguments& a) {
  std::vector<std::string> settings = a.settings;
  if (!a.scheme.empty()) settings.push_back("coupling.scheme=\"" + a.scheme + "\"");
  if (!a.integrator.empty()) settings.push_back("solver.integrator=\"" + a.integrator + "\"");
  Plan plan{checked_scene(a.scene, settings), "", "", {}};
  plan.out = short_path(a.out.empty() ? free_folder(scene_name(plan.scene.file)) : a.out);
  plan.log = (fs::path(plan.out) / "liggghts.log").string();
  clear_results(plan.out);
  if (!plan.scene.touches_particles()) {
    plan.command.words = solver_words(a, plan.out, "");
    return plan;
  }
  const ParticlesSpec& particles = *plan.scene.particles;
  const int ranks = a.ranks > 0 ? a.ranks : particles.ranks;
  Bed bed;
  if (particles.bed) bed = prepare_bed(*particles.bed, ranks, a.quiet);
  // A scene that names its own grains keeps them.
  plan.command = both_programs(particles, ranks, plan.out, bed.restart, plan.log,
                               solver_words(a, plan.out, particles.grains.empty() ? bed.grains : ""));
  return plan;
}

// The folder in runs that was kept last.
std::string last_kept() {
  std::string last;
  fs::file_time_type when = fs::file_time_type::min();
  std::error_code error;
  for (const auto& run : fs::directory_iterator("runs", error)) {
    const fs::path checkpoints = run.path() / "checkpoint";
    if (!fs::exists(checkpoints) || fs::last_write_time(checkpoints) <= when) continue;
    when = fs::last_write_time(checkpoints);
    last = run.path().string();
  }
  if (last.empty()) throw InputError("--resume: no run in runs has a checkpoint; name its folder: --resume DIR");
  return last;
}

// A run from its newest checkpoint. Its script must begin with the restart file that -var bed names.
Plan resumed_run(const RunArguments& a) {
  Plan plan;
  plan.out = short_path(a.out.empty() ? last_kept() : a.out);
  const std::string checkpoint = newest_checkpoint(plan.out);
  const RunStart start = read_run_start(checkpoint);
  plan.scene = read_scene(start.scene_file, start.settings);
  std::vector<std::string> solver = {built_program("mbd_solver"), "--resume", plan.out};
  if (a.until > 0.0) solver.insert(solver.end(), {"--until", number_text(a.until, 12)});
  if (a.quiet) solver.push_back("--quiet");
  if (!plan.scene.touches_particles()) {
    plan.command.words = solver;
    return plan;
  }
  const ParticlesSpec& particles = *plan.scene.particles;
  demand_resumable(particles);
  plan.log = (fs::path(plan.out) / ("liggghts_" + fs::path(checkpoint).filename().string() + ".log")).string();
  plan.command =
      both_programs(particles, start.ranks, plan.out, short_path(checkpoint + "/grains.restart"), plan.log, solver);
  set_rows_aside(plan.out, step_of_checkpoint(checkpoint));
  if (const std::string gravity = energy_at_start(plan.out); !gravity.empty()) {
    std::vector<std::string>& words = plan.command.words;
    const std::string value[] = {"-var", "grain_start", gravity};
    words.insert(std::find(words.begin(), words.end(), "-log"), std::begin(value), std::end(value));
  }
  return plan;
}

std::string status_of(const std::string& out) {
  const fs::path summary = fs::path(out) / "summary.json";
  return fs::exists(summary) ? read_summary(summary.string()).value("status", "") : "";
}

// What the run's own exit code means to the user; says what nobody else could say. Of two programs that end differently
// mpirun gives either code: after an interrupt the summary decides.
int exit_code(const ChildEnd& end, const std::string& status) {
  if (end.interrupted && status == "interrupted") return kExitInterrupted;
  if (end.interrupted) {
    std::fprintf(stderr, "footfall: interrupted before there was anything to keep\n");
    return kExitFailed;
  }
  if (end.code <= kExitInterrupted) return end.code;
  if (end.code > 128) {
    std::fprintf(stderr,
                 "footfall: a program of the run was killed by signal %d (%s), from outside or for want of memory\n",
                 end.code - 128, strsignal(end.code - 128));
  } else {
    std::fprintf(stderr, "footfall: the run ended with the unknown exit code %d\n", end.code);
  }
  return kExitFailed;
}

}  // namespace

int run_command(const RunArguments& arguments) {
  Plan plan;
  try {
    plan = arguments.resume ? resumed_run(arguments) : new_run(arguments);
  } catch (const Interrupted&) {
    std::fprintf(stderr, "footfall: interrupted while making the bed; nothing is kept\n");
    return kExitFailed;
  }
  const Scene& scene = plan.scene;
  const std::string& out = plan.out;
  Command& command = plan.command;
  if (!arguments.quiet) std::printf("%s\n", shell_line(command).c_str());
  std::fflush(stdout);
  if (isatty(STDOUT_FILENO) == 1) command.environment["FOOTFALL_TERMINAL"] = "1";

  const ChildEnd end = run_child(command, "mbd_solver");
  if (arguments.resume) join_rows(out);
  const std::string errors = liggghts_errors(plan.log);
  if (!errors.empty()) {
    std::fprintf(stderr, "footfall: LIGGGHTS stopped on %s:\n%s\n", scene.particles->script.c_str(), errors.c_str());
    return kExitBadInput;
  }
  std::vector<std::string> pictures;
  const std::string status = status_of(out);
  if (!status.empty()) write_ledger(out);
  if (!status.empty() && scene.output.plots) pictures = make_pictures(out);
  if (!status.empty() && !arguments.quiet) print_results(out, pictures);
  return exit_code(end, status);
}

}  // namespace footfall

#include "mbd_solver/cli/run_plan.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/grains/grain_rows.h"
#include "mbd_solver/cli/launch/bed.h"
#include "mbd_solver/cli/launch/bed_seal.h"
#include "mbd_solver/cli/launch/box_report.h"
#include "mbd_solver/cli/launch/check_command.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/launch/script_safety.h"
#include "mbd_solver/output/checkpoint_folder.h"
#include "mbd_solver/output/run_start.h"
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

// What a resumed run may be told anew.
void append_common(std::vector<std::string>& words, const RunArguments& a) {
  if (a.keep_every != kKeepEvery) words.insert(words.end(), {"--keep-every", number_text(a.keep_every, 12)});
  if (a.quiet) words.push_back("--quiet");
}

std::vector<std::string> solver_words(const RunArguments& a, const std::string& out, const std::string& grains) {
  std::vector<std::string> words = {built_program("mbd_solver"), short_path(a.scene), "--out", out};
  if (a.until > 0.0) words.insert(words.end(), {"--until", number_text(a.until, 12)});
  if (!a.scheme.empty()) words.insert(words.end(), {"--scheme", a.scheme});
  if (!a.integrator.empty()) words.insert(words.end(), {"--integrator", a.integrator});
  for (const std::string& setting : a.settings) words.insert(words.end(), {"--set", setting});
  if (!grains.empty()) words.insert(words.end(), {"--set", "particles.grains=\"" + grains + "\""});
  append_common(words, a);
  return words;
}

// Restart files that the script names itself.
void check_restart_files(const ParticlesSpec& particles) {
  std::error_code ignored;
  const ScriptText script(particles.script, particles.variables);
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] != "read_restart" || w.size() < 2 || !fs::is_regular_file(w[1], ignored)) continue;
    if (const std::string damage = damage_of_restart(w[1]); !damage.empty())
      throw InputError(command.file + ":" + std::to_string(command.line) + ": read_restart " + w[1] + ": " + damage +
                       "; LIGGGHTS would hang on it, make it anew");
  }
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

// LIGGGHTS takes its scripts apart at blanks, after it has put ${out}, ${bed} and ${here} into them.
void demand_one_word(const std::string& what, const std::string& path) {
  if (path.find_first_of(" \t\n\r\"'#&$") == std::string::npos) return;
  throw InputError(
      what + " is \"" + path +
      "\", but LIGGGHTS takes its script apart at blanks and knows \" ' # & $ as marks of its own; expected "
      "a path without them");
}

void demand_whole_words(const ParticlesSpec& particles, const std::string& out) {
  demand_one_word("the folder for results, --out,", out);
  demand_one_word("the script of the grains", short_path(particles.script));
  if (!particles.bed) return;
  demand_one_word("the script of the bed", short_path(particles.bed->script));
  demand_one_word("the folder of beds (FOOTFALL_CACHE)", cache_folder());
}

// Scripts of a scene from somebody else run nothing and write into the results' folder only.
void keep_scripts_safe(const Scene& scene, const RunArguments& a) {
  if (!scene.touches_particles() || a.trust_script) return;
  demand_safe_script(scene.particles->script, scene.particles->variables);
  if (const auto& bed = scene.particles->bed) demand_safe_script(bed->script, bed->variables);
  setenv(kNoPrograms, "1", 1);
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

}  // namespace

RunPlan new_run(const RunArguments& a) {
  std::vector<std::string> settings = a.settings;
  if (!a.scheme.empty()) settings.push_back("coupling.scheme=\"" + a.scheme + "\"");
  if (!a.integrator.empty()) settings.push_back("solver.integrator=\"" + a.integrator + "\"");
  const Scene scene = checked_scene(a.scene, settings);
  keep_scripts_safe(scene, a);
  const std::string out = short_path(a.out.empty() ? new_run_folder(scene_name(scene.file)) : a.out);
  if (scene.touches_particles()) demand_whole_words(*scene.particles, out);
  RunPlan plan{scene, out, (fs::path(out) / "liggghts.log").string(), OwnFolder(out, a.force), {}, ""};
  if (!scene.touches_particles()) {
    plan.command.words = solver_words(a, out, "");
    return plan;
  }
  const ParticlesSpec& particles = *scene.particles;
  const int ranks = a.ranks > 0 ? a.ranks : particles.ranks;
  check_restart_files(particles);
  Bed bed;
  keep_box_scripts(scene, out);
  if (particles.bed) bed = prepare_bed(*particles.bed, ranks, a.quiet);
  if (!bed.restart.empty()) plan.bed_log = (fs::path(bed.restart).parent_path() / "liggghts.log").string();
  // A scene that names its own grains keeps them.
  plan.command = both_programs(particles, ranks, out, bed.restart, plan.log,
                               solver_words(a, out, particles.grains.empty() ? bed.grains : ""));
  return plan;
}

RunPlan resumed_run(const RunArguments& a) {
  const std::string out = short_path(a.out.empty() ? last_kept() : a.out);
  OwnFolder folder(out);
  const std::string checkpoint = newest_checkpoint(out);
  const RunStart start = read_run_start(checkpoint);
  const std::string log = (fs::path(out) / ("liggghts_" + fs::path(checkpoint).filename().string() + ".log")).string();
  RunPlan plan{read_scene(start.scene_file, start.settings), out, log, std::move(folder), {}, ""};
  std::vector<std::string> solver = {built_program("mbd_solver"), "--resume", out};
  if (a.until > 0.0) solver.insert(solver.end(), {"--until", number_text(a.until, 12)});
  append_common(solver, a);
  if (!plan.scene.touches_particles()) {
    plan.command.words = solver;
    return plan;
  }
  const ParticlesSpec& particles = *plan.scene.particles;
  keep_scripts_safe(plan.scene, a);
  demand_resumable(particles);
  plan.command =
      both_programs(particles, start.ranks, out, short_path(checkpoint + "/grains.restart"), plan.log, solver);
  set_rows_aside(out, step_of_checkpoint(checkpoint));
  if (const std::string gravity = energy_at_start(out); !gravity.empty()) {
    std::vector<std::string>& words = plan.command.words;
    const std::string value[] = {"-var", "grain_start", gravity};
    words.insert(std::find(words.begin(), words.end(), "-log"), std::begin(value), std::end(value));
  }
  return plan;
}

}  // namespace footfall

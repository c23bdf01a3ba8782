#include "mbd_solver/cli/run_command.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/failure_note.h"
#include "coupler/base/folder.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"
#include "mbd_solver/cli/analysis/results.h"
#include "mbd_solver/cli/launch/bed.h"
#include "mbd_solver/cli/launch/bed_seal.h"
#include "mbd_solver/cli/launch/check_command.h"
#include "mbd_solver/cli/launch/child.h"
#include "mbd_solver/cli/launch/liggghts_log.h"
#include "mbd_solver/cli/launch/own_folder.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/launch/script_safety.h"
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
Command coupled_command(const Scene& scene, const RunArguments& a, const std::string& out) {
  const ParticlesSpec& particles = *scene.particles;
  const int ranks = a.ranks > 0 ? a.ranks : particles.ranks;
  check_restart_files(particles);
  Bed bed;
  if (particles.bed) bed = prepare_bed(*particles.bed, ranks, a.quiet);
  Command command = mpirun();
  const auto append = [&](const std::vector<std::string>& words) {
    command.words.insert(command.words.end(), words.begin(), words.end());
  };
  append({"-np", std::to_string(ranks), built_program("liggghts_mbd")});
  append(script_arguments(particles.script, particles.variables));
  append({"-var", "out", out});
  if (!bed.restart.empty()) append({"-var", "bed", bed.restart});
  append({"-log", (fs::path(out) / "liggghts.log").string(), "-screen", "none"});
  append({":", "-np", "1"});
  // A scene that names its own grains keeps them.
  append(solver_words(a, out, particles.grains.empty() ? bed.grains : ""));
  return command;
}

std::string status_of(const std::string& out) {
  const fs::path summary = fs::path(out) / "summary.json";
  return fs::exists(summary) ? read_summary(summary.string()).value("status", "") : "";
}

// What the run's own exit code means to the user; says what nobody else could say. mpirun that was asked to end gives
// the code of a failure, too: then the programs have begun, and none has noted one.
int exit_code(const ChildEnd& end, const std::string& status, bool begun, bool noted) {
  const bool asked = was_asked_to_end(end.code) || (end.code == kExitFailed && begun && !noted);
  if (status == "done" && end.code == kExitDone) return kExitDone;
  if (end.interrupted || (asked && end.given_up.empty())) {
    if (status.empty()) std::fprintf(stderr, "footfall: interrupted before there was anything to keep\n");
    return kExitInterrupted;
  }
  if (!end.given_up.empty()) {
    std::fprintf(stderr, "footfall: %s\n", end.given_up.c_str());
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

// The summary says the same as the exit code, whoever wrote it: mbd_solver may have been ended because another program
// had died, or may not have come to write one.
void settle_summary(const std::string& out, const std::string& status, int code) {
  const std::string ended = code == kExitDone ? "done" : code == kExitInterrupted ? "interrupted" : "failed";
  if (status == ended || (status.empty() && code == kExitBadInput)) return;
  const std::string file = (fs::path(out) / "summary.json").string();
  nlohmann::ordered_json summary;
  if (!status.empty()) summary = read_summary(file);
  summary["status"] = ended;
  if (code != kExitDone) summary["reason"] = "the run ended with exit code " + std::to_string(code);
  write_summary(file, summary);
}

}  // namespace

int run_command(const RunArguments& arguments) {
  std::vector<std::string> settings = arguments.settings;
  if (!arguments.scheme.empty()) settings.push_back("coupling.scheme=\"" + arguments.scheme + "\"");
  if (!arguments.integrator.empty()) settings.push_back("solver.integrator=\"" + arguments.integrator + "\"");
  const Scene scene = checked_scene(arguments.scene, settings);
  if (scene.touches_particles() && !arguments.trust_script) {
    demand_safe_script(scene.particles->script, scene.particles->variables);
    if (const auto& bed = scene.particles->bed) demand_safe_script(bed->script, bed->variables);
    setenv(kNoPrograms, "1", 1);
  }
  const std::string out = short_path(arguments.out.empty() ? new_run_folder(scene_name(scene.file)) : arguments.out);
  const OwnFolder folder(out, arguments.force);

  Command command;
  if (scene.touches_particles())
    command = coupled_command(scene, arguments, out);
  else
    command.words = solver_words(arguments, out, "");
  if (!arguments.quiet) std::printf("%s\n", shell_line(command).c_str());
  std::fflush(stdout);
  if (isatty(STDOUT_FILENO) == 1) command.environment["FOOTFALL_TERMINAL"] = "1";
  command.environment[kLockedFolder] = locked_name(out);

  // Within a window the two programs notice it themselves, and know more to say.
  constexpr double kLater = 5.0;  // [s]
  const std::string log = (fs::path(out) / "liggghts.log").string();
  const fs::path note = fs::absolute(fs::path(out) / "failed");
  command.environment[kFailureNote] = note.string();
  StoppedWatch stopped(scene.coupling.timeout + kLater);
  ReadingWatch reading(log, scene.coupling.timeout);
  const ChildEnd end = run_child(command, kMechanismProgram, [&] {
    const std::string stuck = reading();
    return stuck.empty() ? stopped() : stuck;
  });
  const std::string errors = liggghts_errors(log);
  if (!errors.empty()) {
    std::fprintf(stderr, "footfall: LIGGGHTS stopped on %s:\n%s\n", scene.particles->script.c_str(), errors.c_str());
    settle_summary(out, status_of(out), kExitBadInput);
    return kExitBadInput;
  }
  std::vector<std::string> pictures;
  const std::string status = status_of(out);
  const int code = exit_code(end, status, fs::exists(log), fs::remove(note));
  settle_summary(out, status, code);
  if (!status.empty()) write_ledger(out);
  if (!status.empty() && scene.output.plots) pictures = make_pictures(out);
  if (!status.empty() && !arguments.quiet) print_results(out, pictures);
  return code;
}

}  // namespace footfall

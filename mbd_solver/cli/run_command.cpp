#include "mbd_solver/cli/run_command.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/analysis/results.h"
#include "mbd_solver/cli/launch/bed.h"
#include "mbd_solver/cli/launch/check_command.h"
#include "mbd_solver/cli/launch/child.h"
#include "mbd_solver/cli/launch/own_folder.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/launch/script_safety.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/scene/scene_reader.h"

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

// mpirun ... liggghts_mbd ... : -np 1 mbd_solver ...
Command coupled_command(const Scene& scene, const RunArguments& a, const std::string& out) {
  const ParticlesSpec& particles = *scene.particles;
  const int ranks = a.ranks > 0 ? a.ranks : particles.ranks;
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

std::string status_of(const std::string& out) {
  const fs::path summary = fs::path(out) / "summary.json";
  if (!fs::exists(summary)) return "";
  return with_summary_of(out, [&] { return read_summary(summary.string()).value("status", ""); });
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
  if (scene.touches_particles()) demand_whole_words(*scene.particles, out);
  const OwnFolder folder(out, arguments.force);

  Command command;
  try {
    if (scene.touches_particles()) {
      command = coupled_command(scene, arguments, out);
    } else {
      command.words = solver_words(arguments, out, "");
    }
  } catch (const Interrupted&) {
    std::fprintf(stderr, "footfall: interrupted while making the bed; nothing is kept\n");
    return kExitFailed;
  }
  if (!arguments.quiet) std::printf("%s\n", shell_line(command).c_str());
  std::fflush(stdout);
  if (isatty(STDOUT_FILENO) == 1) command.environment["FOOTFALL_TERMINAL"] = "1";
  command.environment[kLockedFolder] = locked_name(out);

  const ChildEnd end = run_child(command, "mbd_solver");
  const std::string errors = liggghts_errors((fs::path(out) / "liggghts.log").string());
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

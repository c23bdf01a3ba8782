#include "mbd_solver/app/run_command.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <regex>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "coupler/interrupt.h"
#include "coupler/programs.h"
#include "mbd_solver/app/check_command.h"
#include "mbd_solver/app/paraview_files.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/bed/bed.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/bed/bed_report.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/bed/process.h"
#include "mbd_solver/bed/programs.h"
#include "mbd_solver/bed/script_safety.h"
#include "mbd_solver/run/output/checkpoint_folder.h"
#include "mbd_solver/run/output/summary.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// What every run makes, whatever becomes of it: noted at its start.
const std::vector<std::string> kEvery = {"history.csv",  "summary.json",      "ledger.csv", "bodies.pvd",
                                         "liggghts.log", "grains_energy.txt", "run.json",   "paraview.py"};
// What a run may write besides.
constexpr const char* kSome[] = {R"(bodies_[0-9].*\.vtu)",  R"(.*\.vtk\.series)",
                                 R"(.*_[0-9].*\.vtp)",      R"(.*\.pvd)",
                                 R"(motion/.*\.(csv|stl))", R"(plots/.*\.(gp|csv|png|svg))",
                                 R"(plots/gnuplot\.log)",   R"(script/.*)"};

bool is_written_by_runs(const std::string& name) {
  if (std::find(kEvery.begin(), kEvery.end(), name) != kEvery.end()) return true;
  return std::any_of(std::begin(kSome), std::end(kSome),
                     [&](const char* pattern) { return std::regex_match(name, std::regex(pattern)); });
}

// A start that was refused or stopped before the mechanism moved has logs at most: nothing of it is missed.
bool has_results(const std::string& folder) {
  std::error_code error;
  return fs::exists(fs::path(folder) / "history.csv", error) || fs::exists(fs::path(folder) / "checkpoint", error);
}

void refuse(const std::string& folder, bool force) {
  if (!has_results(folder)) return;
  const std::vector<std::string> made = made_files(folder);
  const auto count = std::count_if(made.begin(), made.end(), [&](const std::string& name) {
    std::error_code error;
    return fs::exists(fs::symlink_status(fs::path(folder) / name, error));
  });
  if (count > 0 && !force)
    throw InputError(
        folder + ": holds an earlier run (" + std::to_string(count) + (count == 1 ? " file" : " files") +
        "); choose another folder with --out, or say --force: then the files of that run are removed first");
}

// Written over, a file of the user would be lost.
void refuse_foreign(const std::string& folder, const std::set<std::string>& foreign) {
  for (const std::string& name : foreign)
    if (is_written_by_runs(name))
      throw InputError(
          (fs::path(folder) / name).string() +
          ": is there, no run is known to have made it, and this run would write over it; move it away, or "
          "choose another folder with --out");
}

}  // namespace

OwnFolder::OwnFolder(const std::string& folder, bool force) {
  // A folder that is refused stays as it is; one with a lock may be in use, which is the better reason.
  if (std::error_code error; !fs::exists(fs::path(folder) / kLockFile, error)) refuse(folder, force);
  lock_ = lock_folder(folder);
  refuse(folder, force);
  files_ = std::make_unique<MadeFiles>(folder);
  refuse_foreign(folder, files_->foreign());
  remove_made_files(folder);
  begin();
}

OwnFolder::OwnFolder(const std::string& folder) {
  if (std::error_code error; !fs::is_directory(folder, error))
    throw InputError(folder + ": there is no such folder, and so no run to go on with");
  lock_ = lock_folder(folder);
  files_ = std::make_unique<MadeFiles>(folder);
  begin();
}

void OwnFolder::begin() {
  std::vector<std::string> patterns(std::begin(kSome), std::end(kSome));
  patterns.emplace_back("checkpoint/.*");
  files_->begin(kEvery, patterns);
}

std::string new_run_folder(const std::string& name) {
  make_folder("runs");
  fs::path folder = fs::path("runs") / name;
  std::error_code error;
  // Who makes it has it: two runs that start together take two folders.
  for (int k = 2; !fs::create_directory(folder, error) && !error; ++k)
    folder = fs::path("runs") / (name + "-" + std::to_string(k));
  if (error) throw InputError(folder.string() + ": cannot be made: " + error.message() + "; choose one with --out");
  return folder.string();
}

namespace {

std::string status_of(const std::string& out) {
  const fs::path summary = fs::path(out) / "summary.json";
  if (!fs::exists(summary)) return "";
  return with_summary_of(out, [&] { return read_summary(summary.string()).value("status", ""); });
}

// What the run's own exit code means to the user; says what nobody else could say. mpirun that was asked to end gives
// the code of a failure, too: then the programs have begun, and none has noted one.
int exit_code(const ChildEnd& end, const std::string& status, bool begun, bool noted) {
  const bool asked = was_asked_to_end(end.code) || (end.code == kExitFailed && begun && !noted);
  if (status == "done" && end.code == kExitDone) return kExitDone;
  if (end.crashed && !noted && (status == "done" || status == "interrupted")) {
    // Seen of Open MPI 4.1 that got SIGTERM while it ended by itself.
    std::fprintf(stderr,
                 "footfall: warning: mpirun itself crashed (signal %d, %s) when both programs had ended; what they "
                 "wrote is whole\n",
                 end.code - 128, strsignal(end.code - 128));
    return status == "done" ? kExitDone : kExitInterrupted;
  }
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
  end_on_signals("footfall");
  RunPlan plan = arguments.resume ? resumed_run(arguments) : new_run(arguments);
  const Scene& scene = plan.scene;
  const std::string &out = plan.out, &log = plan.log;
  Command& command = plan.command;
  if (!arguments.quiet) std::printf("%s\n", shell_line(command).c_str());
  std::fflush(stdout);
  if (isatty(STDOUT_FILENO) == 1) command.environment["FOOTFALL_TERMINAL"] = "1";
  command.environment[kLockedFolder] = locked_name(out);
  if (arguments.audit) command.environment[kAuditFolder] = fs::absolute(fs::path(out) / "audit").string();

  // Within a window the two programs notice it themselves, and know more to say.
  constexpr double kLater = 5.0;  // [s]
  const fs::path note = fs::absolute(fs::path(out) / "failed");
  command.environment[kFailureNote] = note.string();
  SuspendedWatch stopped(scene.coupling.timeout + kLater);
  ReadingWatch reading(log, scene.coupling.timeout);
  BedMaterialCheck bed(plan.bed_log, log);
  leave_time_to_end(command);
  const SignalsHeld signals;  // what the run has left is put in order first
  SettlingLine settling(log, (fs::path(out) / "history.csv").string(), arguments.quiet);
  const ChildEnd end = run_child(command, kMbdProgram, [&] {
    bed();
    settling();
    const std::string stuck = reading();
    return stuck.empty() ? stopped() : stuck;
  });
  bed();
  remove_unfinished_sets(out);
  if (arguments.resume) join_rows(out);
  if (!liggghts_errors(log).empty()) {
    const ParticlesSpec& particles = *scene.particles;
    std::fprintf(stderr, "footfall: LIGGGHTS stopped at %s\n",
                 why_liggghts_stopped(log, particles.script, particles.variables).c_str());
    settle_summary(out, status_of(out), kExitBadInput);
    return kExitBadInput;
  }
  std::vector<std::string> pictures;
  const std::string status = status_of(out);
  int code = exit_code(end, status, fs::exists(log), fs::remove(note));
  // The run has begun: a disk that takes no more is no mistake of the scene, and does not hide how the run ended.
  const auto attempt = [&code](const auto& write) {
    try {
      write();
    } catch (const InputError& error) {
      std::fprintf(stderr, "footfall: %s\n", error.what());
      if (code == kExitDone || code == kExitInterrupted) code = kExitFailed;
    }
  };
  attempt([&] { settle_summary(out, status, code); });
  if (!status.empty()) attempt([&] { write_ledger(out); });
  if (!status.empty()) attempt([&] { write_grain_series(out); });
  if (!status.empty()) attempt([&] { write_paraview_script(out); });
  if (!status.empty() && scene.output.plots) pictures = make_pictures(out);
  if (!status.empty() && !arguments.quiet) print_results(out, pictures);
  signals.ignore();
  return code;
}

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
  require_safe_script(scene.particles->script, scene.particles->variables);
  if (const auto& bed = scene.particles->bed) require_safe_script(bed->script, bed->variables);
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
  store_box_scripts(scene, out);
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
  move_rows_aside(out, step_of_checkpoint(checkpoint));
  if (const std::string gravity = energy_at_start(out); !gravity.empty()) {
    std::vector<std::string>& words = plan.command.words;
    const std::string value[] = {"-var", "grain_start", gravity};
    words.insert(std::find(words.begin(), words.end(), "-log"), std::begin(value), std::end(value));
  }
  return plan;
}

}  // namespace footfall

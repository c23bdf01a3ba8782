// Builds the command line of both programs, runs it, and puts the folder in order: exit code, summary, energies, plots.
#include "mbd_solver/app/run_command.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>
#include <thread>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/interrupt.h"
#include "coupler/base/pulse.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"
#include "mbd_solver/app/check_command.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/follow.h"
#include "mbd_solver/app/live/history_tail.h"
#include "mbd_solver/app/paraview_files.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/bed/bed.h"
#include "mbd_solver/bed/bed_frames.h"
#include "mbd_solver/bed/bed_report.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/bed/script_safety.h"
#include "mbd_solver/launch/confined_programs.h"
#include "mbd_solver/launch/launch_limits.h"
#include "mbd_solver/launch/program_watch.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/scene/foreign/foreign_code.h"
#include "mbd_solver/scene/particle_script.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

std::string status_of(const std::string& out) {
  const fs::path summary = fs::path(out) / "summary.json";
  if (!fs::exists(summary)) return "";
  return with_summary_of(out, [&] { return read_summary(summary.string()).value("status", ""); });
}

// The run has written rows.
bool has_rows(const std::string& out) {
  HistoryTail history((fs::path(out) / "history.csv").string());
  history.read();
  return history.last().rows > 0;
}

// The exit code of the run, from the code of its command; reports what no program of the run can report itself, and then sets `why`. An
// mpirun that was asked to end also gives the code of a failure: then both programs had begun, and neither has noted a failure.
int exit_code(const ChildEnd& end, const std::string& status, bool begun, bool rows, bool noted, std::string& why) {
  const auto report = [&why](const MessageCode& code, const std::string& text) {
    print_error(code, text);
    why = with_code(code, text);
  };
  const bool asked = was_asked_to_end(end.code) || (end.code == kExitFailed && begun && !noted);
  if (status == "done" && end.code == kExitDone) return kExitDone;
  if (end.crashed && !noted && (status == "done" || status == "interrupted")) {
    // Open MPI 4.1 does so when it gets SIGTERM while it ends by itself.
    const std::string text = "mpirun crashed (signal " + std::to_string(end.code - 128) + ", " +
                             strsignal(end.code - 128) + ") after both programs had ended; the results are complete";
    std::fprintf(stderr, "footfall: warning: %s\n", with_code(code::kLauncherCrashed, text).c_str());
    return status == "done" ? kExitDone : kExitInterrupted;
  }
  if (end.interrupted || (asked && end.given_up.empty())) {
    if (status.empty() && !rows) report(code::kInterruptedEarly, "interrupted before the run had results");
    return kExitInterrupted;
  }
  if (!end.given_up.empty()) {
    std::fprintf(stderr, "footfall: %s\n", end.given_up.c_str());
    why = end.given_up;
    return kExitFailed;
  }
  if (end.code <= kExitInterrupted) return end.code;
  if (end.code > 128) {
    report(code::kProgramKilled, "a program of the run was killed by signal " + std::to_string(end.code - 128) + " (" +
                                     strsignal(end.code - 128) +
                                     "); look for a lack of memory or a command that ended it");
  } else {
    report(code::kUnknownExitCode, "the run ended with the unknown exit code " + std::to_string(end.code));
  }
  return kExitFailed;
}

// Brings the status in summary.json in line with the exit code: mbd_solver may have ended because another program had
// died, or without writing a summary. reason: as far as this program knows it.
void correct_summary(const std::string& out, const std::string& status, int code, const std::string& reason) {
  const std::string ended = code == kExitDone ? "done" : code == kExitInterrupted ? "interrupted" : "failed";
  if (status == ended) return;
  const std::string file = (fs::path(out) / "summary.json").string();
  nlohmann::ordered_json summary;
  if (!status.empty()) summary = read_summary(file);
  summary["status"] = ended;
  if (code != kExitDone)
    summary["reason"] = !reason.empty()            ? reason
                        : code == kExitInterrupted ? "interrupted by the user"
                                                   : "the run ended with exit code " + std::to_string(code);
  if (ended == "failed" && status.empty() && !has_rows(out)) summary[kFailedAtStart] = true;
  write_summary(file, summary);
}

// What the programs of the run have noted; the note is removed. No value: none has failed.
std::optional<std::string> taken_note(const std::string& file) {
  const std::optional<std::string> note = read_whole_file(file);
  if (note) fs::remove(file);
  return note ? std::optional(note->substr(0, note->find('\n'))) : std::nullopt;
}

// The line of this program, as it was called; with --force where its folder now has results.
std::string same_line(const std::string& out) {
  std::string line = called_as();
  bool folder = false, force = false;
  std::string called = read_whole_file("/proc/self/cmdline").value_or("");
  if (!called.empty()) called.pop_back();  // a zero ends each word
  const std::vector<std::string> words = split(called, '\0');
  for (std::size_t k = 1; k < words.size(); ++k) {  // without the program
    folder = folder || words[k].rfind("--out", 0) == 0;
    force = force || words[k] == "--force";
    line += " " + shell_word(words[k]);
  }
  return line + (folder && !force && fs::exists(fs::path(out) / "history.csv") ? " --force" : "");
}

// Of a run that was interrupted: the command that continues.
std::string how_to_resume(const std::string& out) {
  try {
    newest_checkpoint(out);
    return "footfall: interrupted; resume with: " + called_as() + " run --resume " + shell_word(out);
  } catch (const InputError&) {
    return "footfall: interrupted before the first checkpoint; start it again with: " + same_line(out);
  }
}

// The exit code of a run that is done; names the requirements that are not met.
int judge_requirements(const std::string& out) {
  const nlohmann::ordered_json summary =
      with_summary_of(out, [&] { return read_summary((fs::path(out) / "summary.json").string()); });
  if (requirements_met(summary)) return kExitDone;
  const std::vector<std::string> lines = requirement_lines(summary);
  std::string missed;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (summary.at("requirements").at(i).value("verdict", "") != "met") missed += "\n  " + lines[i];
  print_error(code::kRequirementsMissed, out + ": the run is done, and not all requirements are met:" + missed);
  return kExitRequirements;
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

  // Within the coupling's own time limit the two programs notice it themselves, and their message says more.
  constexpr double kLater = 5.0;  // [s]
  const fs::path note = fs::absolute(fs::path(out) / "failed");
  command.environment[kFailureNote] = note.string();
  SuspendedWatch suspended(scene.coupling.timeout + kLater);
  ReadingWatch reading(log, scene.coupling.timeout);
  const std::string begun = (fs::path(out) / "history.csv").string();
  const std::string pulse = (fs::path(out) / kLockFile).string();
  if (scene.touches_particles()) command.environment[kPulse] = fs::absolute(pulse).string();
  ProgramWatch progress(scene.coupling.timeout + 2.0 * kLater, pulse, begun, log);
  BedMaterialCheck material(plan.bed_log, log);
  leave_time_to_end(command);
  const SignalsHeld signals;  // the folder is put in order first
  std::optional<FollowedRun> followed;
  if (arguments.view) followed.emplace(out);
  SettlingLine settling(log, begun, arguments.quiet);
  const ChildEnd end = run_child(command, kMbdProgram, [&] {
    material();
    settling();
    if (followed) followed->tell();
    std::string stuck = reading();
    if (stuck.empty()) stuck = suspended();
    return stuck.empty() && scene.touches_particles() ? progress() : stuck;
  });
  material();
  remove_unfinished_checkpoints(out);
  if (arguments.resume) join_rows(out);
  if (followed) followed->finish();
  const std::optional<std::string> noted = taken_note(note.string());
  if (!liggghts_errors(log).empty()) {
    const ParticlesSpec& particles = *scene.particles;
    const std::string why = "LIGGGHTS stopped at " + why_liggghts_stopped(log, particles.script, particles.variables);
    print_error(code::kLiggghtsStopped, why);
    correct_summary(out, status_of(out), kExitBadInput, with_code(code::kLiggghtsStopped, why));
    return kExitBadInput;
  }
  std::vector<std::string> pictures;
  const std::string status = status_of(out);
  std::string why = noted.value_or("");
  int code = exit_code(end, status, fs::exists(log), has_rows(out), noted.has_value(), why);
  // The run has begun: a full disk is no fault of the scene, and does not hide how the run ended.
  const auto attempt = [&code](const auto& write) {
    try {
      write();
    } catch (const InputError& error) {
      std::fprintf(stderr, "footfall: %s\n", error.what());
      if (code == kExitDone || code == kExitInterrupted) code = kExitFailed;
    }
  };
  attempt([&] { correct_summary(out, status, code, why); });
  if (!status.empty()) attempt([&] { write_ledger(out); });
  if (!status.empty()) attempt([&] { write_grain_series(out); });
  if (!status.empty()) attempt([&] { write_paraview_script(out); });
  const bool interrupted = code == kExitInterrupted;  // the user waits
  if (!status.empty() && scene.output.plots && !interrupted) pictures = make_pictures(out);
  if (!status.empty() && !arguments.quiet) print_results(out, pictures);
  if (interrupted) std::fprintf(stderr, "%s\n", how_to_resume(out).c_str());
  signals.ignore();
  if (code != kExitDone) return code;
  return judge_requirements(out);
}

namespace {

// "inputs/landing_mr/scene.toml" -> "landing_mr", "02_wheel/large.toml" -> "02_wheel_large", "drop.toml" -> "drop".
std::string scene_name(const std::string& file) {
  const fs::path path = fs::absolute(file).lexically_normal();
  if (path.filename() == "large.toml") return path.parent_path().filename().string() + "_large";
  return path.filename() == "scene.toml" ? path.parent_path().filename().string() : path.stem().string();
}

// A script can be resumed if it reads the restart file ${bed} and has one run command.
void require_resumable(const ParticlesSpec& particles) {
  std::map<std::string, std::string> variables = particles.variables;
  variables["bed"] = "the file that -var bed names";
  bool reads_bed = false;
  int runs = 0;
  const ScriptCommand* hybrid = nullptr;
  const ScriptText script(particles.script, variables);
  for (const ScriptCommand& command : script.commands()) {
    const auto refuse = [&](const std::string& why) {
      throw InputError(code::kNotResumable, command.place() + ": " + command.words[0] +
                                                ": a run with this script cannot be resumed: " + why);
    };
    if (command.words[0] == "read_restart" && command.words.size() > 1)
      reads_bed = joined(command.words, " ").find(variables["bed"]) != std::string::npos;
    if (command.words[0] == "pair_style" && command.words.size() > 1 && command.words[1].rfind("hybrid", 0) == 0)
      hybrid = &command;
    if (command.words[0] == "reset_timestep") refuse("LIGGGHTS would lose the step at which it resumes");
    if (command.words[0] == "run" && ++runs > 1)
      refuse("it is the second one, and the checkpoint does not record in which one the run was");
  }
  if (!reads_bed)
    throw InputError(
        code::kNotResumable,
        particles.script +
            ": a run with this script cannot be resumed: it must read its grains by `read_restart ${bed}`, "
            "so that -var bed can name the grains of the checkpoint");
  if (hybrid == nullptr) return;
  const std::string text = hybrid->place() +
                           ": LIGGGHTS stores no contact histories of pair_style hybrid: the resumed run begins with "
                           "fresh tangential springs, and differs from a run that was not stopped";
  std::fprintf(stderr, "footfall: warning: %s\n", with_code(code::kHistoriesNotStored, text).c_str());
}

// Options that a resumed run takes anew.
void append_common(std::vector<std::string>& words, const RunArguments& a) {
  if (a.keep_every != kCheckpointEvery) words.insert(words.end(), {"--keep-every", number_text(a.keep_every, 12)});
  if (a.quiet) words.push_back("--quiet");
  if (a.trust_script) words.push_back("--trust-script");
}

std::vector<std::string> solver_words(const RunArguments& a, const std::string& out, const std::string& grains) {
  std::vector<std::string> words = {built_program("mbd_solver"), short_path(a.scene), "--out", out};
  if (a.until > 0.0) words.insert(words.end(), {"--until", number_text(a.until, 12)});
  if (!a.scheme.empty()) words.insert(words.end(), {"--scheme", a.scheme});
  if (!a.integrator.empty()) words.insert(words.end(), {"--integrator", a.integrator});
  for (const std::string& setting : a.settings) words.push_back("--set=" + setting);
  if (!grains.empty()) words.push_back("--set=particles.grains=\"" + grains + "\"");
  append_common(words, a);
  return words;
}

// mpirun ... liggghts_mbd ... : -np 1 mbd_solver ...
Command both_programs(const ParticlesSpec& particles, int ranks, const std::string& out, const std::string& restart,
                      const std::string& log, const std::vector<std::string>& solver) {
  Command command = mpirun();
  std::vector<std::string> words = script_arguments(particles.script, particles.variables);
  words.insert(words.end(), {"-var", "out", out});
  if (!restart.empty()) words.insert(words.end(), {"-var", "bed", restart});
  words.insert(words.end(), {"-log", log, "-screen", "none"});
  add_program(command, ranks, built_program("liggghts_mbd"), words);
  add_program(command, 1, solver[0], {solver.begin() + 1, solver.end()});
  return command;
}

// Without grains. Programs of a scene that the user trusts are started by mbd_solver.
Command solver_alone(const std::vector<std::string>& words, bool trusted) {
  return {trusted ? Rights::of_user() : Rights::starting({words[0]}), words};
}

void require_whole_files(const std::map<std::string, std::string>& variables) {
  for (const auto& [name, value] : variables)
    if (names_file(value)) require_one_word("the file of the variable " + name, short_path(value));
}

void require_whole_words(const ParticlesSpec& particles, const std::string& out) {
  require_one_word("the folder of results (--out)", out);
  require_one_word("the script of the grains", short_path(particles.script));
  require_whole_files(particles.variables);
  if (!particles.bed) return;
  require_one_word("the script of the bed", short_path(particles.bed->script));
  require_whole_files(particles.bed->variables);
  require_one_word("the cache (FOOTFALL_CACHE)", cache_folder());
}

// Scripts of a scene run no programs and write into the folder of results only.
void require_safe_scripts(const Scene& scene, const RunArguments& a) {
  if (!scene.touches_particles() || a.trust_script) return;
  const auto& bed = scene.particles->bed;
  std::set<std::string> given = {"out", "here"};
  if (bed || a.resume) given.insert("bed");
  require_safe_script(scene.particles->script, scene.particles->variables, given);
  if (bed) require_safe_script(bed->script, bed->variables, {"bed", "here"});
}

// Of several machines the batch system counts the cores.
void warn_of_ranks(int ranks) {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  if (in_batch_job() || cores == 0 || ranks <= cores) return;
  const std::string text =
      std::to_string(ranks) + " ranks on " + std::to_string(cores) +
      " cores: ranks that share a core wait for each other, and the run takes longer; use at most --ranks " +
      std::to_string(cores);
  std::fprintf(stderr, "footfall: warning: %s\n", with_code(code::kRanksBeyondCores, text).c_str());
}

// The folder in runs with the newest checkpoint.
std::string newest_run() {
  std::string last;
  fs::file_time_type when = fs::file_time_type::min();
  std::error_code error;
  for (const auto& run : fs::directory_iterator("runs", error)) {
    const fs::path checkpoints = run.path() / "checkpoint";
    if (!fs::exists(checkpoints) || fs::last_write_time(checkpoints) <= when) continue;
    when = fs::last_write_time(checkpoints);
    last = run.path().string();
  }
  if (last.empty())
    throw InputError(code::kNoCheckpoint, "--resume: no run in runs has a checkpoint; name its folder: --resume DIR");
  return last;
}

}  // namespace

void require_one_word(const std::string& what, const std::string& path) {
  if (path.find_first_of(" \t\n\r\"'#&$") == std::string::npos) return;
  throw InputError(code::kPathWithBlanks,
                   what + " is \"" + path + "\", expected a path without blanks and \" ' # & $, which LIGGGHTS splits");
}

RunPlan new_run(const RunArguments& a) {
  std::vector<std::string> settings = a.settings;
  if (!a.scheme.empty()) settings.push_back("coupling.scheme=\"" + a.scheme + "\"");
  if (!a.integrator.empty()) settings.push_back("solver.integrator=\"" + a.integrator + "\"");
  const Scene scene = checked_scene(a.scene, settings);
  require_trust(scene, a.trust_script);
  require_foreign_code(scene);
  require_safe_scripts(scene, a);
  const std::string out = short_path(a.out.empty() ? new_run_folder(scene_name(scene.file)) : a.out);
  const int ranks = a.ranks > 0 || !scene.touches_particles() ? a.ranks : scene.particles->ranks;
  if (scene.touches_particles()) {
    require_whole_words(*scene.particles, out);
    require_room_to_launch(ranks + 1);
  }
  RunPlan plan{scene, out, (fs::path(out) / "liggghts.log").string(), RunFolder(out, a.force), {Rights::of_user()}, ""};
  if (a.until > scene.end_time)
    std::fprintf(stderr, "footfall: warning: %s\n",
                 with_code(code::kUntilAfterEnd, "--until " + number_text(a.until) + ": the scene ends before, at " +
                                                     number_text(scene.end_time) +
                                                     " s; for a longer run use --set end_time=" + number_text(a.until))
                     .c_str());
  write_run_note(out, {scene.title, scene.file, a.until > 0.0 ? std::min(a.until, scene.end_time) : scene.end_time});
  if (!scene.touches_particles()) {
    plan.command = solver_alone(solver_words(a, out, ""), a.trust_script);
    return plan;
  }
  const ParticlesSpec& particles = *scene.particles;
  warn_of_ranks(ranks);
  Bed bed;
  store_box_scripts(scene, out);
  try {
    if (particles.bed) bed = prepare_bed(*particles.bed, ranks, a.quiet, a.trust_script, scene.coupling.timeout);
  } catch (const std::exception& error) {
    const bool interrupted = dynamic_cast<const Interrupted*>(&error) != nullptr;
    try {
      note_end_of_run(out, interrupted ? "interrupted" : "failed", error.what());
    } catch (const InputError&) {  // a full disk does not hide the reason
    }
    if (interrupted) throw Interrupted(error.what() + ("\n" + how_to_resume(out)));
    throw;
  }
  if (!bed.restart.empty()) plan.bed_log = (fs::path(bed.restart).parent_path() / "liggghts.log").string();
  // Grains that the scene names itself take precedence.
  plan.command = both_programs(particles, ranks, out, bed.restart, plan.log,
                               solver_words(a, out, particles.grains.empty() ? bed.grains : ""));
  std::vector<std::string> folders = {out};
  if (!bed.restart.empty()) folders.push_back(fs::path(bed.restart).parent_path().string());
  limit_script(plan.command, a.trust_script, folders);
  return plan;
}

RunPlan resumed_run(const RunArguments& a) {
  const std::string out = short_path(a.out.empty() ? newest_run() : a.out);
  RunFolder folder(out);
  const std::string checkpoint = newest_checkpoint(out);
  const RunStart start = read_run_start(checkpoint);
  const std::string log = (fs::path(out) / ("liggghts_" + fs::path(checkpoint).filename().string() + ".log")).string();
  RunPlan plan{read_scene(start.scene_file, start.settings), out, log, std::move(folder), {Rights::of_user()}, ""};
  require_trust(plan.scene, a.trust_script);
  std::vector<std::string> solver = {built_program("mbd_solver"), "--resume", out};
  if (a.until > 0.0) solver.insert(solver.end(), {"--until", number_text(a.until, 12)});
  append_common(solver, a);
  if (!plan.scene.touches_particles()) {
    plan.command = solver_alone(solver, a.trust_script);
    return plan;
  }
  const ParticlesSpec& particles = *plan.scene.particles;
  require_safe_scripts(plan.scene, a);
  require_resumable(particles);
  require_room_to_launch(start.ranks + 1);
  plan.command =
      both_programs(particles, start.ranks, out, short_path(checkpoint + "/grains.restart"), plan.log, solver);
  limit_script(plan.command, a.trust_script, {out});
  move_rows_aside(out, step_of_checkpoint(checkpoint));
  if (const std::string gravity = energy_at_start(out); !gravity.empty()) {
    std::vector<std::string>& words = plan.command.words;
    const std::string value[] = {"-var", "grain_start", gravity};
    words.insert(std::find(words.begin(), words.end(), "-log"), std::begin(value), std::end(value));
  }
  return plan;
}

}  // namespace footfall

#include "mbd_solver/cli/run_command.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/failure_note.h"
#include "coupler/interrupt.h"
#include "coupler/programs.h"
#include "mbd_solver/cli/analysis/grain_series.h"
#include "mbd_solver/cli/analysis/paraview_script.h"
#include "mbd_solver/cli/analysis/results.h"
#include "mbd_solver/cli/grains/grain_rows.h"
#include "mbd_solver/cli/launch/bed_conditions.h"
#include "mbd_solver/cli/launch/liggghts_log.h"
#include "mbd_solver/cli/launch/process.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/launch/script_trace.h"
#include "mbd_solver/cli/run_plan.h"
#include "mbd_solver/output/checkpoint_folder.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

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
  StoppedWatch stopped(scene.coupling.timeout + kLater);
  ReadingWatch reading(log, scene.coupling.timeout);
  BedWatch bed(plan.bed_log, log);
  leave_time_to_end(command);
  const SignalsHeld signals;  // what the run has left is put in order first
  SettlingLine settling(log, (fs::path(out) / "history.csv").string(), arguments.quiet);
  const ChildEnd end = run_child(command, kMechanismProgram, [&] {
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

}  // namespace footfall

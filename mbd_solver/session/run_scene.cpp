// A session owns the simulation and everything that observes it: files, metrics, progress, warnings, checkpoints. It runs
// the loop, then writes the summary and chooses the exit code; after an error it also informs the partner program.

#include "mbd_solver/session/run_scene.h"

#include <cstdio>
#include <filesystem>

#include "coupler/base/interrupt.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/scene/foreign/foreign_code.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/session/checkpoint.h"
#include "mbd_solver/session/leader.h"
#include "mbd_solver/session/observe/carry_over.h"
#include "mbd_solver/session/observe/start_values.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/session/progress.h"
#include "mbd_solver/session/run_files.h"
#include "mbd_solver/session/run_summary.h"

namespace footfall {
namespace {

// By default checkpoints take at most this share of the wall time: 1 / 300.
constexpr double kRest = 300.0;

void print_warning(const Scene& scene, const std::string& text) {
  if (!scene.accepts(text)) std::fprintf(stderr, "mbd_solver: warning: %s\n", text.c_str());
}

// For writing after an error: a second error is not reported.
template <class Write>
void attempt(const Write& write) {
  try {
    write();
  } catch (const std::exception&) {
  }
}

double end_time(const Scene& scene, const RunOptions& options) {
  return options.until > 0.0 ? std::min(options.until, scene.end_time) : scene.end_time;
}

// Started without footfall, a run locks its folder itself.
FileLock lock_of(const std::string& folder) { return folder_is_held_for_us(folder) ? FileLock() : lock_folder(folder); }

// Warns of programs of the user without a state; true: there are some.
bool warn_of_stateless(const Scene& scene) {
  const std::vector<std::string> names = foreign_code_without_state(scene);
  if (names.empty()) return false;
  print_warning(scene,
                with_code(code::kNoCheckpoints,
                          scene.file + ": the run writes no checkpoints and cannot be resumed: the program of signal " +
                              joined(names) +
                              " cannot tell its state (an FMU by canSerializeFMUState, a Python file by the functions "
                              "save() and restore(saved), or stateless = true)"));
  return true;
}

class RunSession {
 public:
  RunSession(const Scene& scene, const RunOptions& options, Transport* transport,
             const volatile std::sig_atomic_t& interrupted)
      : scene_(scene),
        options_(options),
        interrupted_(interrupted),
        lock_(lock_of(options.out)),
        simulation_(scene, end_time(scene, options), transport, options.checkpoint),
        coupled_(simulation_.coupled()),
        leader_(Leader::of_environment(simulation_)),
        files_(announced(simulation_, options.out), options.out, resumed() ? Beginning::kResume : Beginning::kNew),
        metrics_(simulation_.subject()),
        progress_(end_time(scene, options), options.quiet, coupled_ != nullptr),
        trial_(options.try_for),
        checkpoints_(options.out),
        // By default checkpoints are rare enough not to cost time. An interval given by the user is kept exactly.
        safety_(scene.output.checkpoint_interval > 0.0 ? 0.0 : options.keep_every,
                options.keep_every == kCheckpointEvery ? kRest : 0.0),
        stateless_(warn_of_stateless(scene)) {
    if (!leader_)
      for (const std::string& warning : unset_signals(scene)) print_warning(scene, warning);
    if (resumed()) restore();
    simulation_.observe_within(
        [this](const Sample& sample) {
          metrics_.update_peaks(sample);
          files_.observe(sample);
        },
        [this](const Sample& sample) { files_.write_row(sample); });
    if (options.fleeting) return;
    as_file_error([&] {
      const std::string file = std::filesystem::absolute(scene.file).lexically_normal().string();
      write_run_note(options.out, {scene.title, file, end_time(scene, options)});
      add_live_note(options.out,
                    {coupled_ != nullptr ? coupled_->agreement().dt : 0.0, Json::parse(scene_json(scene))});
    });
  }

  int run() {
    std::string reason = trial_.active() ? "the trial is over" : "interrupted by the user";
    work_is_under_way();
    try {
      const auto observer = [this](const Sample& sample) { observe(sample); };
      trial_.active() ? simulation_.run(observer, trial_ends_)
                      : simulation_.run(observer, interrupted_, stateless_ ? CheckpointWriter() : writer());
    } catch (const std::exception& error) {
      attempt([&] { finish_files(); });
      if (!is_interruption(error)) {
        fail(error);
        throw;
      }
      reason = error.what();
      std::fprintf(stderr, "mbd_solver: %s\n", reason.c_str());
    }
    finish_files();
    if (!options_.fleeting) as_file_error([&] { write_end(); });
    for (const std::string& text : warnings_.at_end()) print_warning(scene_, text);
    if (!simulation_.finished()) {
      // The summary first: mpirun ends the programs soon after it has asked them to.
      summarize("interrupted", reason);
      if (coupled_) coupled_->fail(reason, Status::kInterrupted);
      return kExitInterrupted;
    }
    summarize("done", reason_of_end());
    if (safety_.active() && !scene_.output.keep_grains) checkpoints_.clear();
    if (leader_) leader_->done();
    return kExitDone;
  }

 private:
  // footfall has checked the scene before it started this program, and has printed what that finds.
  static const Simulation& announced(const Simulation& simulation, const std::string& folder) {
    if (!folder_is_held_for_us(folder))
      for (const std::string& warning : simulation.mechanism().warnings) print_warning(simulation.scene(), warning);
    for (const std::string& note : simulation.assembly().notes)
      std::fprintf(stderr, "mbd_solver: note: %s\n", note.c_str());
    return simulation;
  }

  bool resumed() const { return !options_.checkpoint.empty(); }

  void visit(Archive& archive) {
    archive("simulation", simulation_);
    archive("files", files_);
    archive("metrics", metrics_);
  }

  void restore() {
    restore_checkpoint(options_.checkpoint, scene_, [this](Archive& archive) { visit(archive); });
    warnings_.news();  // of the earlier part of the run
  }

  void observe(const Sample& sample) {
    metrics_.update(sample);
    files_.write(sample);
    progress_.show(sample.state.time, sample.window, metrics_.metrics().contact_force);
    for (const std::string& text : warnings_.news()) {
      if (!scene_.accepts(text)) std::fputs("\n", stderr);  // ends the progress line
      print_warning(scene_, text);
    }
    if (leader_) leader_->observe(sample, metrics_.metrics().energy_balance_relative());
    const LandingEnd* const landing = files_.observation().landing_end();
    if (landing != nullptr && landing->is_over() && !leader_) simulation_.instructions().request_end();
    trial_.observe(simulation_, sample.state.time);
    if (trial_.over() || interrupted_ != 0) trial_ends_ = 1;
  }

  CheckpointWriter writer() {
    CheckpointWriter writer;
    writer.begin = [this](long windows) {
      safety_.begin();
      return checkpoint_ = as_file_error([&] { return checkpoints_.begin(windows); });
    };
    writer.finish = [this] {
      as_file_error([&] {
        write_checkpoint(checkpoint_, scene_, options_.until, options_.ranks,
                         [this](Archive& archive) { visit(archive); });
        checkpoints_.finish();
      });
      safety_.finish();
      if (leader_) leader_->saved(std::filesystem::path(checkpoint_).replace_extension().string());
    };
    writer.cancel = [this] {
      checkpoints_.cancel();
      safety_.retry_soon();
    };
    writer.overdue = [this] { return safety_.overdue(); };
    return writer;
  }

  // Of a run that is done before its end time; else empty.
  std::string reason_of_end() const {
    if (coupled_ && coupled_->script_has_ended()) return "the LIGGGHTS script ended the run, which `end script` allows";
    const LandingEnd* const landing = files_.observation().landing_end();
    return landing != nullptr && simulation_.instructions().end_requested() ? landing->reason() : "";
  }

  void write_end() {
    const Subject subject = simulation_.subject();
    write_end_state(options_.out, end_state_of(subject.mechanism, subject.layout, simulation_.state()));
  }

  void finish_files() {
    progress_.finish();
    files_.flush();
  }

  void summarize(const std::string& status, const std::string& reason) {
    as_file_error([&] {
      auto summary = run_summary(simulation_, metrics_, files_.observation(), status, reason, options_.mpi_version);
      if (status == "failed" && !resumed() && !(simulation_.state().time > 0.0)) summary[kFailedAtStart] = true;
      if (trial_.active()) summary["trial"] = trial_.marks();
      files_.requirements().judge(summary);
      write_summary(options_.out + "/summary.json", summary);
    });
  }

  // A partner that is gone after a signal received the signal as well, unless a program has failed: then mpirun sent the signal.
  bool is_interruption(const std::exception& error) const {
    return dynamic_cast<const Interrupted*>(&error) ||
           (dynamic_cast<const PartnerError*>(&error) && interrupted_ != 0 && noted_failure().empty());
  }

  void fail(const std::exception& error) {
    const bool bad_input = dynamic_cast<const InputError*>(&error) || dynamic_cast<const ProtocolError*>(&error);
    attempt([&] { summarize("failed", error.what()); });
    if (coupled_) coupled_->fail(error.what(), bad_input ? Status::kBadInput : Status::kFailed);
  }

  const Scene& scene_;
  const RunOptions& options_;
  const volatile std::sig_atomic_t& interrupted_;
  FileLock lock_;
  Simulation simulation_;
  CoupledRun* coupled_;             // null without grains
  std::unique_ptr<Leader> leader_;  // null: nobody leads
  RunFiles files_;
  MetricRecorder metrics_;
  Progress progress_;
  RunWarnings warnings_{simulation_, files_.observation(), metrics_};
  Trial trial_;
  volatile std::sig_atomic_t trial_ends_ = 0;
  CheckpointFolder checkpoints_;
  std::string checkpoint_;  // folder of the checkpoint in progress
  SafetyClock safety_;
  bool stateless_;  // a program of the user cannot tell its state: no checkpoints
};

}  // namespace

int run_scene(const Scene& scene, const RunOptions& options, Transport* transport,
              const volatile std::sig_atomic_t& interrupted) {
  try {
    require_trust(scene, options.trusted);
    require_foreign_code(scene);
    return RunSession(scene, options, transport, interrupted).run();
  } catch (const std::exception& error) {  // mostly before the session could summarize anything
    const bool stopped = dynamic_cast<const Interrupted*>(&error) != nullptr;
    if (folder_is_held_for_us(options.out))
      attempt([&] { note_end_of_run(options.out, stopped ? "interrupted" : "failed", error.what()); });
    throw;
  }
}

}  // namespace footfall

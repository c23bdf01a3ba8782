#include "mbd_solver/run/run_scene.h"

#include <cstdio>
#include <filesystem>
#include <optional>

#include "coupler/base/errors.h"
#include "coupler/interrupt.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/run/checkpoint.h"
#include "mbd_solver/run/output/checkpoint_folder.h"
#include "mbd_solver/run/output/summary.h"
#include "mbd_solver/run/progress.h"
#include "mbd_solver/run/run_files.h"
#include "mbd_solver/run/run_summary.h"

namespace footfall {
namespace {

// Tells on standard error what has come to a list of warnings since the last time.
class WarningTeller {
 public:
  void tell(const std::vector<std::string>& warnings) {
    for (; told_ < warnings.size(); ++told_)
      std::fprintf(stderr, "\nmbd_solver: warning: %s\n", warnings[told_].c_str());
  }
  void skip(const std::vector<std::string>& warnings) {
    told_ = warnings.size();
  }  // told by an earlier part of the run

 private:
  std::size_t told_ = 0;
};

// Sets take less than this share of the run: 1 / 300.
constexpr double kRest = 300.0;

// What a file of a run that is under way does not take is no mistake of the scene.
template <class Write>
auto as_file_error(const Write& write) {
  try {
    return write();
  } catch (const InputError& error) {
    throw FileError(error.what());
  }
}

}  // namespace

int run_scene(const Scene& scene, const RunOptions& options, Transport* transport,
              const volatile std::sig_atomic_t& interrupted) {
  const double t_end = options.until > 0.0 ? std::min(options.until, scene.end_time) : scene.end_time;
  // Started without footfall the run locks its folder itself.
  FileLock lock;
  if (!folder_is_held_for_us(options.out)) {
    lock = lock_folder(options.out);
  }
  Simulation simulation(scene, t_end, transport, options.checkpoint);
  CoupledRun* const coupled = simulation.coupled();
  for (const std::string& warning : simulation.mechanism().warnings)
    std::fprintf(stderr, "mbd_solver: warning: %s\n", warning.c_str());
  for (const std::string& note : simulation.assembly().notes)
    std::fprintf(stderr, "mbd_solver: note: %s\n", note.c_str());

  const bool resumed = !options.checkpoint.empty();
  RunFiles files(simulation, options.out, resumed ? Beginning::kResume : Beginning::kNew);
  FigureTaker taker(simulation.subject());
  const auto visit = [&](Archive& archive) {
    archive("simulation", simulation);
    archive("files", files);
    archive("figures", taker);
  };
  if (resumed) restore_checkpoint(options.checkpoint, scene, visit);
  as_file_error([&] {
    const std::string file = std::filesystem::absolute(scene.file).lexically_normal().string();
    write_run_note(options.out, {scene.title, file, t_end});
  });
  Progress progress(t_end, options.quiet, coupled != nullptr);
  WarningTeller of_coupling, of_bodies, of_joints;
  if (resumed) {
    if (coupled) of_coupling.skip(coupled->watch().warnings());
    of_bodies.skip(files.observation().flexible().warnings());
    of_joints.skip(files.observation().joints().warnings());
  }
  Trial trial(options.try_for);
  volatile std::sig_atomic_t trial_ends = 0;
  const auto observe = [&](const Sample& sample) {
    taker.take(sample);
    files.write(sample);
    progress.show(sample.state.time, sample.window, taker.figures().contact_force);
    if (coupled) of_coupling.tell(coupled->watch().warnings());
    of_bodies.tell(files.observation().flexible().warnings());
    of_joints.tell(files.observation().joints().warnings());
    trial.look(simulation, sample.state.time);
    if (trial.over() || interrupted != 0) trial_ends = 1;
  };
  CheckpointFolder checkpoints(options.out);
  std::string folder;  // of the checkpoint that is being written
  // By default it is never felt: large sets come later. An interval that the user gives is kept to.
  SafetyClock safety(scene.output.checkpoint_interval > 0.0 ? 0.0 : options.keep_every,
                     options.keep_every == kKeepEvery ? kRest : 0.0);
  Keeper keep;
  keep.begin = [&](long windows) {
    safety.begin();
    return folder = as_file_error([&] { return checkpoints.begin(windows); });
  };
  keep.finish = [&] {
    as_file_error([&] {
      write_checkpoint(folder, scene, options.until, options.ranks, visit);
      checkpoints.finish();
    });
    safety.finish();
  };
  keep.drop = [&] {
    checkpoints.drop();
    safety.try_again();
  };
  keep.overdue = [&] { return safety.overdue(); };
  const auto finish_files = [&] {
    progress.finish();
    files.flush();
  };
  const auto summarize = [&](const std::string& status, const std::string& reason) {
    as_file_error([&] {
      auto summary = run_summary(simulation, taker, files.observation(), status, reason, options.mpi_version);
      if (trial.runs()) summary["trial"] = trial.marks();
      write_summary(options.out + "/summary.json", summary);
    });
  };

  std::string why = trial.runs() ? "the trial is over" : "interrupted by the user";
  work_is_under_way();
  try {
    trial.runs() ? simulation.run(observe, trial_ends) : simulation.run(observe, interrupted, keep);
  } catch (const std::exception& error) {
    // What cannot be written now is no second message.
    const auto attempt = [](const auto& write) {
      try {
        write();
      } catch (const std::exception&) {
      }
    };
    attempt(finish_files);
    // A partner that is gone after a signal has had it, too.
    const bool gone = dynamic_cast<const PartnerError*>(&error) != nullptr;
    if (!dynamic_cast<const Interrupted*>(&error) && !(gone && interrupted != 0)) {
      const bool mendable = dynamic_cast<const InputError*>(&error) || dynamic_cast<const ProtocolError*>(&error);
      attempt([&] { summarize("failed", error.what()); });
      if (coupled) coupled->fail(error.what(), mendable ? Status::kBadInput : Status::kFailed);
      throw;
    }
    why = error.what();
    std::fprintf(stderr, "mbd_solver: %s\n", why.c_str());
  }
  finish_files();
  for (const std::string& text : {taker.balance_warning(), simulation.integrator().warning()})
    if (!text.empty()) std::fprintf(stderr, "mbd_solver: warning: %s\n", text.c_str());
  if (simulation.finished()) {
    const bool early = coupled && coupled->script_has_ended();
    summarize("done", early ? "the LIGGGHTS script ended the run, as it may" : "");
    if (safety.runs()) checkpoints.clear();
    return kExitDone;
  }
  // The summary first: mpirun kills soon after it has asked for the end.
  summarize("interrupted", why);
  if (coupled) coupled->fail(why, Status::kInterrupted);
  return kExitInterrupted;
}

}  // namespace footfall

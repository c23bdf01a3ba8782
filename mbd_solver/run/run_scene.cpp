#include "mbd_solver/run/run_scene.h"

#include <cstdio>

#include "coupler/base/errors.h"
#include "mbd_solver/output/summary.h"
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

 private:
  std::size_t told_ = 0;
};

}  // namespace

int run_scene(const Scene& scene, const RunOptions& options, Transport* transport,
              const volatile std::sig_atomic_t& interrupted) {
  const double t_end = options.until > 0.0 ? std::min(options.until, scene.end_time) : scene.end_time;
  Simulation simulation(scene, t_end, transport);
  CoupledRun* const coupled = simulation.coupled();
  for (const std::string& warning : simulation.mechanism().warnings)
    std::fprintf(stderr, "mbd_solver: warning: %s\n", warning.c_str());
  for (const std::string& note : simulation.assembly().notes)
    std::fprintf(stderr, "mbd_solver: note: %s\n", note.c_str());

  RunFiles files(simulation, options.out);
  FigureTaker taker(simulation.subject());
  Progress progress(t_end, options.quiet);
  WarningTeller of_coupling, of_bodies, of_joints;
  const auto observe = [&](const Sample& sample) {
    taker.take(sample);
    files.write(sample);
    progress.show(sample.state.time, sample.window, taker.figures().contact_force);
    if (coupled) of_coupling.tell(coupled->watch().warnings());
    of_bodies.tell(files.observation().flexible().warnings());
    of_joints.tell(files.observation().joints().warnings());
  };
  const auto finish_files = [&] {
    progress.finish();
    files.flush();
  };
  const auto summarize = [&](const std::string& status, const std::string& reason) {
    write_summary(options.out + "/summary.json", run_summary(simulation, taker, files.observation(), status, reason));
  };

  try {
    simulation.run(observe, interrupted);
  } catch (const std::exception& error) {
    finish_files();
    const bool mendable = dynamic_cast<const InputError*>(&error) || dynamic_cast<const ProtocolError*>(&error);
    if (coupled) coupled->fail(error.what(), mendable ? Status::kBadInput : Status::kFailed);
    if (simulation.state().q.allFinite() && simulation.state().v.allFinite())
      files.write_checkpoint_of(simulation.state());
    summarize("failed", error.what());
    throw;
  }
  finish_files();
  if (const std::string text = taker.balance_warning(); !text.empty())
    std::fprintf(stderr, "mbd_solver: warning: %s\n", text.c_str());
  if (simulation.finished()) {
    summarize("done", "");
    return kExitDone;
  }
  files.write_checkpoint_of(simulation.state());
  if (coupled) coupled->fail("interrupted by the user", Status::kInterrupted);
  summarize("interrupted", "");
  return kExitInterrupted;
}

}  // namespace footfall

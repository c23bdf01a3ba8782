#include "mbd_solver/cli/trial_command.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/folder_lock.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "coupler/interrupt.h"
#include "coupler/programs.h"
#include "mbd_solver/cli/launch/bed.h"
#include "mbd_solver/cli/launch/liggghts_log.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/cli/launch/run_time.h"
#include "mbd_solver/cli/launch/script_trace.h"
#include "mbd_solver/cli/run_plan.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// A folder of our own that is gone with this.
class TrialFolder {
 public:
  TrialFolder() {
    std::string name = (fs::temp_directory_path() / "footfall_trial_XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw InputError(name + ": no such folder can be made; set TMPDIR to a folder that may be written");
    path_ = name;
  }
  ~TrialFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void print_coupling(const Json& summary) {
  std::printf("  %ld grains, time step %g s, ", summary.at("particles").get<long>(),
              summary.at("dt_dem_s").get<double>());
  const Json& substeps = summary.at("substeps_per_window");
  std::printf("%s per window\n",
              substeps.is_number() ? (substeps.dump() + " steps").c_str() : "as many steps as it needs");
  std::string body;
  double largest = 0.0;
  const Json by_body = summary.value("max_omega_h", Json::object());
  for (const auto& [name, value] : by_body.items())
    if (value.get<double>() > largest) {
      largest = value.get<double>();
      body = name;
    }
  if (body.empty()) {
    std::printf("  omega H: no body has touched grains so far\n");
  } else {
    std::printf("  omega H: up to %.2g so far (%s); overlaps up to %s of the radius\n", largest, body.c_str(),
                share_text(summary.at("max_overlap_over_radius").get<double>()).c_str());
  }
}

void print_time(const Json& summary, double t_end, double started, double memory) {
  const double reached = summary.at("end_time_s").get<double>();
  const double wall = summary.at("wall_s").get<double>();
  if (summary.at("status") == "done") {
    std::printf("Run time: %s; that was the whole run\n", duration_text(started + wall).c_str());
  } else {
    const RunTime time = expected_run_time(summary.at("trial"), t_end);
    std::printf("Run time: about %s (%s to %s) as busy as this machine is now; tried for %s, to t = %g of %g s\n",
                duration_text(started + time.seconds).c_str(), duration_text(started + time.least).c_str(),
                duration_text(started + time.most).c_str(), duration_text(wall).c_str(), reached, t_end);
    if (summary.contains("particles"))
      std::printf("  %s of it for LIGGGHTS\n", share_text(time.share_of_grains).c_str());
  }
  std::printf("  memory: %.0f MB in all programs\n", memory / 1e6);
}

}  // namespace

int trial_command(const RunArguments& given, double seconds) {
  end_on_signals("footfall");
  RunArguments arguments = given;
  const Scene scene = read_scene(arguments.scene, arguments.settings);
  if (scene.touches_particles() && scene.particles->bed && !bed_is_made(bed_folder(*scene.particles->bed))) {
    std::printf("Run time: not known before the bed is made: %s run %s --until %g makes and keeps it\n",
                called_as().c_str(), short_path(scene.file).c_str(), 1e-3 * scene.end_time);
    return kExitDone;
  }
  const TrialFolder folder;
  arguments.out = (folder.path() / "run").string();
  arguments.quiet = true;
  arguments.keep_every = 0.0;
  RunPlan plan = new_run(arguments);
  Command& command = plan.command;
  command.words.insert(command.words.end(), {"--try-for", number_text(seconds)});
  command.environment[kLockedFolder] = locked_name(plan.out);
  command.output = (folder.path() / "said").string();
  leave_time_to_end(command);

  double memory = 0.0;
  const double begun = wall_clock();
  StoppedWatch stopped(scene.coupling.timeout);
  const ChildEnd end = run_child(command, kMechanismProgram, [&] {
    memory = std::max(memory, memory_of_descendants());
    return stopped();
  });
  if (end.interrupted) return kExitInterrupted;
  const fs::path summary_file = fs::path(plan.out) / "summary.json";
  const std::string errors = liggghts_errors(plan.log);
  const Json summary = fs::exists(summary_file) ? read_summary(summary_file.string()) : Json::object();
  const std::string status = with_summary_of(plan.out, [&] { return summary.value("status", ""); });
  if (!errors.empty() || (status != "done" && status != "interrupted")) {
    std::string why;
    if (!errors.empty())
      why = ": LIGGGHTS stopped at " +
            why_liggghts_stopped(plan.log, scene.particles->script, scene.particles->variables);
    std::fprintf(stderr, "%sfootfall: the trial failed%s\n", read_whole_file(command.output).value_or("").c_str(),
                 why.c_str());
    return !errors.empty() || end.code == kExitBadInput ? kExitBadInput : kExitFailed;
  }
  with_summary_of(plan.out, [&] {
    // How a trial ends is no part of a run.
    const Json& trial = summary.at("trial");
    const double started = trial.is_null() ? 0.0 : std::max(0.0, trial.at("begun").get<double>() - begun);
    print_time(summary, scene.end_time, started, memory);
    if (summary.contains("particles")) print_coupling(summary);
    return 0;
  });
  return kExitDone;
}

}  // namespace footfall

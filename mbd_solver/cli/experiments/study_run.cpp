#include "mbd_solver/cli/experiments/study_run.h"

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/experiments/run_record.h"
#include "mbd_solver/cli/launch/bed.h"
#include "mbd_solver/cli/launch/child.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

// What mbd_solver says about itself is the message; else the last words of the log.
std::string last_message(const std::string& log) {
  std::ifstream in(log);
  std::string line, last, own;
  while (std::getline(in, line)) {
    if (line.empty() || line.find(": warning:") != std::string::npos || line.find(": note:") != std::string::npos)
      continue;
    last = line;
    if (starts_with(line, "mbd_solver: ")) own = line.substr(12);
  }
  return own.empty() ? last : own;
}

// Energy of the mechanism and of the interface: whatever is more than at the start plus the work done by motions. What
// the grains did to the bodies is taken as the grains' own account of it.
double energy_gain(const History& h, double reference) {
  if (h.columns.empty() || h.columns.front().empty() || !(reference > 0.0)) return 0.0;
  std::vector<const std::vector<double>*> plus, minus;
  for (std::size_t i = 0; i < h.names.size(); ++i) {
    const std::string& name = h.names[i];
    if (name == "energy.total" || starts_with(name, "dissipated.")) plus.push_back(&h.columns[i]);
    if (name == "work.contact" || name == "work.motion" || name == "coupling.energy_residual")
      minus.push_back(&h.columns[i]);
  }
  double gain = 0.0;
  for (std::size_t row = 0; row < h.columns.front().size(); ++row) {
    double sum = 0.0;
    for (const std::vector<double>* column : plus) sum += (*column)[row] - column->front();
    for (const std::vector<double>* column : minus) sum -= (*column)[row] - column->front();
    gain = std::max(gain, sum);
  }
  return gain / reference;
}

// Of every child that has ended, and of theirs [s].
double cpu_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// So that the run's own time is without it. What is wrong with the scene or its bed, the run tells.
void make_bed_of(const StudyRunRequest& request) {
  try {
    const Scene scene = read_scene(request.scene, request.settings);
    if (scene.touches_particles() && scene.particles->bed)
      prepare_bed(*scene.particles->bed, scene.particles->ranks, true);
  } catch (const InputError&) {
  } catch (const PartnerError&) {
  } catch (const Interrupted&) {
    throw PartnerError("interrupted by the user");
  }
}

// What follows `footfall run SCENE`, but for the folder.
std::vector<std::string> options_of(const StudyRunRequest& request) {
  std::vector<std::string> words = {"--quiet", "--set", "output.plots=false"};
  if (request.until > 0.0) words.insert(words.end(), {"--until", number_text(request.until)});
  for (const std::string& setting : request.settings) words.insert(words.end(), {"--set", setting});
  return words;
}

// Its last words, warnings and history, once it has ended.
void read_results(const StudyRunRequest& request, StudyRun& run) {
  if (run.code != 0)
    run.message = run.code == StudyRun::kHung ? "hangs: no end within " + std::to_string(request.time_limit) + " s"
                                              : last_message(request.out + ".log");
  if (run.summary.is_null()) return;
  for (const nlohmann::ordered_json& warning : run.summary.value("warnings", nlohmann::ordered_json::array()))
    run.warnings.push_back(warning);
  run.history = read_history((fs::path(request.out) / "history.csv").string());
  run.gain = energy_gain(run.history, run.summary.value("reference_energy_J", 0.0));
}

}  // namespace

std::string recipe_of(const StudyRunRequest& request) {
  return run_recipe(request.scene, request.settings, request.until);
}

StudyRun run_once(const StudyRunRequest& request) {
  StudyRun run;
  run.folder = request.out;
  const fs::path summary = fs::path(request.out) / "summary.json";
  const std::string recipe = recipe_of(request);
  if (const auto cost = request.resume ? recorded_cost(request.out, recipe) : nlohmann::ordered_json();
      cost.is_object()) {
    run.summary = read_summary(summary.string());
    run.wall = cost.value("wall_s", 0.0);
    run.dem = cost.value("dem_wall_s", 0.0);
    run.mbd = cost.value("mbd_wall_s", 0.0);
    run.exchange = cost.value("exchange_wall_s", 0.0);
    run.cpu = cost.value("cpu_s", 0.0);
    read_results(request, run);
    return run;
  }
  make_bed_of(request);
  fs::create_directories(fs::path(request.out).parent_path());
  Command command;
  command.words = {
      "timeout",     "-k",    "2",        std::to_string(request.time_limit), built_program("footfall"), "run",
      request.scene, "--out", request.out};
  for (const std::string& word : options_of(request)) command.words.push_back(word);
  command.output = request.out + ".log";
  for (int k = 0; k < request.repeats; ++k) {
    const double cpu = cpu_of_children();
    const ChildEnd end = run_child(command, "mbd_solver");
    if (end.interrupted) throw PartnerError("interrupted by the user");
    run.code = end.code;
    if (!fs::exists(summary)) break;
    run.summary = read_summary(summary.string());
    const auto time = [&](const char* key) { return run.summary.value(key, 0.0); };
    if (k == 0 || time("wall_s") < run.wall) {
      run.wall = time("wall_s");
      run.dem = time("dem_wall_s");
      run.mbd = time("mbd_wall_s");
      run.exchange = time("exchange_wall_s");
      run.cpu = cpu_of_children() - cpu;
    }
    if (run.code != 0) break;
  }
  if (run.code == 0)
    record_run(request.out, recipe,
               {{"wall_s", run.wall},
                {"dem_wall_s", run.dem},
                {"mbd_wall_s", run.mbd},
                {"exchange_wall_s", run.exchange},
                {"cpu_s", run.cpu}});
  read_results(request, run);
  return run;
}

}  // namespace footfall

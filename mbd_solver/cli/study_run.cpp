#include "mbd_solver/cli/study_run.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "coupler/errors.h"
#include "mbd_solver/cli/child.h"
#include "mbd_solver/cli/programs.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

// What mbd_solver says about itself is the message; else the last words of the log.
std::string last_message(const std::string& log) {
  std::ifstream in(log);
  std::string line, last, own;
  while (std::getline(in, line)) {
    if (line.empty() || line.find(": warning:") != std::string::npos || line.find(": note:") != std::string::npos) continue;
    last = line;
    if (starts_with(line, "mbd_solver: ")) own = line.substr(12);
  }
  return own.empty() ? last : own;
}

// Energy of the mechanism and of the interface: whatever is more than at the start plus the work done by motions. What the grains did to the
// bodies is taken as the grains' own account of it.
double energy_gain(const History& h, double reference) {
  if (h.columns.empty() || h.columns.front().empty() || !(reference > 0.0)) return 0.0;
  std::vector<const std::vector<double>*> plus, minus;
  for (std::size_t i = 0; i < h.names.size(); ++i) {
    const std::string& name = h.names[i];
    if (name == "energy.total" || starts_with(name, "dissipated.")) plus.push_back(&h.columns[i]);
    if (name == "work.contact" || name == "work.motion" || name == "coupling.energy_residual") minus.push_back(&h.columns[i]);
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

}  // namespace

StudyRun run_once(const StudyRunRequest& request) {
  StudyRun run;
  const std::string log = request.out + ".log";
  fs::create_directories(fs::path(request.out).parent_path());
  Command command;
  command.words = {"timeout", "-k", "2", std::to_string(request.time_limit), built_program("footfall"), "run", request.scene, "--quiet",
                   "--out", request.out, "--set", "output.plots=false"};
  if (request.until > 0.0) command.words.insert(command.words.end(), {"--until", short_number(request.until)});
  for (const std::string& setting : request.settings) command.words.insert(command.words.end(), {"--set", setting});
  command.output = log;
  for (int k = 0; k < request.repeats; ++k) {
    const ChildEnd end = run_child(command, "mbd_solver");
    if (end.interrupted) throw PartnerError("interrupted by the user");
    run.code = end.code;
    const fs::path summary = fs::path(request.out) / "summary.json";
    if (!fs::exists(summary)) break;
    run.summary = read_summary(summary.string());
    const auto time = [&](const char* key) { return run.summary.value(key, 0.0); };
    if (k == 0 || time("wall_s") < run.wall) {
      run.wall = time("wall_s");
      run.dem = time("dem_wall_s");
      run.mbd = time("mbd_wall_s");
      run.exchange = time("exchange_wall_s");
    }
    if (run.code != 0) break;
  }
  if (run.code != 0) run.message = run.code == StudyRun::kHung ? "hangs: no end within " + std::to_string(request.time_limit) + " s" : last_message(log);
  if (run.summary.is_null()) return run;
  for (const nlohmann::ordered_json& warning : run.summary.value("warnings", nlohmann::ordered_json::array())) run.warnings.push_back(warning);
  run.history = read_history((fs::path(request.out) / "history.csv").string());
  run.gain = energy_gain(run.history, run.summary.value("reference_energy_J", 0.0));
  return run;
}

}  // namespace footfall

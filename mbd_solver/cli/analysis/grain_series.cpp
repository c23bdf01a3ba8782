#include "mbd_solver/cli/analysis/grain_series.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/bed_frames.h"
#include "mbd_solver/cli/analysis/mechanism_shape.h"
#include "mbd_solver/output/history.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// Length of the window that ends with each drawing [s]. Where the run chose its windows, the history tells how many
// substeps the one at the next row had.
std::vector<double> windows_before(const std::string& out, const std::vector<double>& drawn, double dt,
                                   const Json& summary) {
  if (summary.contains("substeps_per_window") && summary.at("substeps_per_window").is_number())
    return std::vector<double>(drawn.size(), dt * summary.at("substeps_per_window").get<double>());
  const History history = read_history((fs::path(out) / "history.csv").string());
  const std::vector<double>&times = history.column("time"), &substeps = history.column("coupling.substeps");
  std::vector<double> windows;
  if (times.empty()) return std::vector<double>(drawn.size(), dt);
  for (const double t : drawn) {
    const auto row = std::lower_bound(times.begin(), times.end(), t - 0.5 * dt) - times.begin();
    const std::size_t k = std::min(static_cast<std::size_t>(row), times.size() - 1);
    windows.push_back(dt * std::max(1.0, substeps[k]));
  }
  return windows;
}

}  // namespace

void write_grain_series(const std::string& out) {
  try {
    const Json summary = read_summary((fs::path(out) / "summary.json").string());
    const double dt = summary.value("dt_dem_s", 0.0);
    if (!(dt > 0.0)) return;
    const std::map<long, std::string> dumps = find_bed_frames(out);
    if (dumps.empty() || fs::path(dumps.begin()->second).extension() != ".vtk") return;
    std::vector<double> drawn;
    if (const fs::path pvd = fs::path(out) / "bodies.pvd"; fs::exists(pvd))
      for (const auto& [time, file] : read_vtk_series(pvd.string())) drawn.push_back(time);
    const std::vector<double> windows = windows_before(out, drawn, dt, summary);
    Json series = {{"file-series-version", "1.0"}, {"files", Json::array()}};
    for (const auto& [step, file] : dumps) {
      double time = static_cast<double>(step) * dt;
      if (!drawn.empty())
        if (const std::size_t k = nearest(drawn, time); std::abs(drawn[k] - time) < 1.001 * windows[k]) time = drawn[k];
      series["files"].push_back({{"name", fs::path(file).filename().string()}, {"time", time}});
    }
    const std::string stem = fs::path(dumps.begin()->second).stem().string();
    write_whole_file((fs::path(out) / (stem.substr(0, stem.rfind('_')) + ".vtk.series")).string(),
                     series.dump(1) + "\n", "is the disk full?");
  } catch (const std::exception& e) {
    std::fprintf(stderr, "footfall: warning: no list of the grains' dumps: %s\n", e.what());
  }
}

}  // namespace footfall

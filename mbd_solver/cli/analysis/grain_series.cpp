#include "mbd_solver/cli/analysis/grain_series.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/bed_frames.h"
#include "mbd_solver/cli/analysis/mechanism_shape.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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
    const bool fixed = summary.contains("substeps_per_window") && summary.at("substeps_per_window").is_number();
    const double window = dt * (fixed ? summary.at("substeps_per_window").get<double>() : 1.0);
    Json series = {{"file-series-version", "1.0"}, {"files", Json::array()}};
    for (const auto& [step, file] : dumps) {
      double time = static_cast<double>(step) * dt;
      if (!drawn.empty())
        if (const double t = drawn[nearest(drawn, time)]; std::abs(t - time) < 1.001 * window) time = t;
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

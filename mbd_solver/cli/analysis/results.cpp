#include "mbd_solver/cli/analysis/results.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/analysis/energy_ledger.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/analysis/plots.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// One row of the table, when the summary has the figure.
void row(const Json& summary, const char* label, const char* key, double factor, const char* format) {
  if (!summary.contains(key) || !summary[key].is_number()) return;
  std::printf("  %-38s ", label);
  std::printf(format, factor * summary[key].get<double>());
  std::printf("\n");
}

bool touches_ground(const Json& summary) {
  for (const Json& part : summary.value("active", Json::array())) {
    if (part == "plane" || part == "particles") return true;
  }
  return false;
}

void print_times(const Json& summary) {
  if (!summary.contains("wall_s")) return;
  const double wall = summary.at("wall_s");
  const auto part = [&](const char* key) { return summary.value(key, 0.0); };
  std::printf("  %-38s %.1f s", "wall time", wall);
  if (part("dem_wall_s") > 0.0 && wall > 0.0) {
    std::printf(" (grains %.1f s, and %.2f s = %.1f %% waiting for the mechanism, which took %.1f s = %.1f %%)",
                part("dem_wall_s"), part("waited_wall_s"), 100.0 * part("waited_wall_s") / wall, part("mbd_wall_s"),
                100.0 * part("mbd_wall_s") / wall);
  }
  std::printf("\n");
}

}  // namespace

void print_results(const std::string& out, const std::vector<std::string>& pictures) {
  const Json summary = read_summary((fs::path(out) / "summary.json").string());
  std::printf("\n%s: %s", out.c_str(), summary.value("status", "unknown").c_str());
  if (summary.contains("reason")) std::printf(": %s", summary.at("reason").get<std::string>().c_str());
  std::printf("\n");
  row(summary, "simulated time", "end_time_s", 1.0, "%.4g s");
  row(summary, "peak acceleration", "peak_acceleration_g", 1.0, "%.2f g");
  row(summary, "largest descent", "max_descent_m", 1.0, "%.3f m");
  if (touches_ground(summary)) {
    row(summary, "largest depth below the ground", "max_penetration_m", 1.0, "%.3f m");
    row(summary, "largest contact force on one body", "max_contact_force_N", 1e-3, "%.2f kN");
  }
  row(summary, "energy balance of the mechanism", "energy_balance_relative", 100.0, "%.4f %% of the energy moved");
  row(summary, "energy lost or made by the interface", "coupling_energy_residual_relative", 100.0,
      "%.3f %% of the energy moved");
  if (summary.contains("ledger")) {
    row(summary.at("ledger"), "energy given to the grains", "energy_to_grains_J", 1e-3, "%.3f kJ");
    row(summary.at("ledger"), "of it dissipated in the grains", "grains_dissipated_J", 1e-3, "%.3f kJ");
  }
  row(summary, "largest overlap of a grain", "max_overlap_over_radius", 100.0, "%.2f %% of its radius");
  row(summary, "grains", "particles", 1.0, "%.0f");
  row(summary, "steps", "steps", 1.0, "%.0f");
  row(summary, "windows", "windows", 1.0, "%.0f");
  print_times(summary);
  if (summary.contains("warnings")) {
    for (const Json& warning : summary.at("warnings"))
      std::printf("  warning: %s\n", warning.get<std::string>().c_str());
  }
  std::printf("Files: %s\n", (fs::path(out) / "history.csv").c_str());
  for (const char* name : {"summary.json", "ledger.csv", "liggghts.log", "vtk"}) {
    if (fs::exists(fs::path(out) / name)) std::printf("       %s\n", (fs::path(out) / name).c_str());
  }
  for (const std::string& picture : pictures) std::printf("       %s\n", picture.c_str());
}

bool write_ledger(const std::string& out) {
  const fs::path folder(out);
  try {
    if (!fs::exists(folder / "history.csv")) return false;
    const History run = read_history((folder / "history.csv").string());
    if (run.find("energy.total") < 0 || run.column("time").empty()) return false;
    const fs::path grains = folder / "grains_energy.txt";
    const History ledger =
        energy_ledger(run, fs::exists(grains) ? read_grain_energies(grains.string()) : GrainEnergies{});
    write_history((folder / "ledger.csv").string(), ledger);

    const fs::path file = folder / "summary.json";
    if (!fs::exists(file)) return true;
    Json summary = read_summary(file.string());
    Json figures;
    double error = 0.0;
    for (const double e : ledger.column("closing_error")) error = std::max(error, std::abs(e));
    figures["closing_error_relative"] = error;
    if (ledger.find("grains.dissipated") >= 0) {
      const double work = ledger.column("work.to_grains").back();
      figures["energy_to_grains_J"] = work;
      const double initial = reference_energy(run);
      if (initial > 0.0) figures["energy_to_grains_share"] = work / initial;
      figures["grains_dissipated_J"] = ledger.column("grains.dissipated").back();
    }
    summary["ledger"] = figures;
    write_summary(file.string(), summary);
    return true;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "footfall: warning: no energy ledger: %s\n", e.what());
  }
  return false;
}

std::vector<std::string> make_pictures(const std::string& out) {
  const fs::path plots = fs::path(out) / "plots";
  try {
    const Json summary = read_summary((fs::path(out) / "summary.json").string());
    const std::string title = summary.contains("scene") ? summary.at("scene").value("title", "") : "";
    const History history = read_history((fs::path(out) / "history.csv").string());
    std::vector<Figure> figures = standard_figures(history, summary.value("observed_body", ""));
    reduce_long_figures(figures, history, plots.string());
    const fs::path ledger = fs::path(out) / "ledger.csv";
    if (fs::exists(ledger)) {
      const History energies = read_history(ledger.string());
      std::vector<Figure> more = {ledger_figure(energies)};
      reduce_long_figures(more, energies, plots.string());
      if (!more.front().curves.empty()) figures.push_back(more.front());  // where no energy moves there is none to draw
    }
    const std::vector<std::string> scripts = write_plot_scripts(plots.string(), figures, title);
    return run_gnuplot(plots.string(), scripts);
  } catch (const InputError& e) {
    std::fprintf(stderr, "footfall: warning: no pictures: %s\n", e.what());
  }
  return {};
}

}  // namespace footfall

#include "mbd_solver/cli/analysis/report_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/report_parts.h"
#include "mbd_solver/cli/analysis/results.h"
#include "mbd_solver/cli/analysis/viewer/assets.h"
#include "mbd_solver/cli/analysis/viewer/page_parts.h"
#include "mbd_solver/cli/analysis/viewer/view_page.h"
#include "mbd_solver/output/history.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

// A figure of the summary times `factor`, when it is there; `meaning`: a cell behind it.
void figure(const Json& summary, const char* label, const char* key, double factor, const char* unit, Rows& rows,
            const char* meaning = nullptr) {
  if (!summary.contains(key) || !summary[key].is_number()) return;
  rows.push_back({label, short_text(factor * summary[key].get<double>()), unit});
  if (meaning != nullptr) rows.back().emplace_back(meaning);
}

// What a reader has to know before any figure.
void show_warnings(const Json& summary, HtmlPage& page) {
  const std::string status = summary.value("status", "unknown");
  if (status != "done")
    page.warning("This run is not complete: " + status +
                 (summary.contains("reason") ? ": " + summary.at("reason").get<std::string>() : ""));
  for (const Json& text : summary.value("warnings", Json::array())) page.warning(text.get<std::string>());
}

void show_summary(const Json& summary, HtmlPage& page) {
  page.section("Summary");
  const std::string body = summary.value("observed_body", "");
  const std::string observed = "of the body that is observed" + (body.empty() ? "" : ", " + body);
  const std::string peak = "Largest acceleration " + observed + ": what its cargo must stand.",
                    descent = "How far it came down from its start, " + observed + ".";
  Rows rows = {{"figure", "value", "unit", "what it says"}};
  figure(summary, "simulated time", "end_time_s", 1.0, "s", rows, "The run ends here.");
  figure(summary, "peak acceleration", "peak_acceleration_g", 1.0, "g", rows, peak.c_str());
  figure(summary, "largest descent", "max_descent_m", 1.0, "m", rows, descent.c_str());
  figure(summary, "largest depth below the ground", "max_penetration_m", 1.0, "m", rows,
         "How deep the lowest point of a touching surface went.");
  figure(summary, "largest contact force on one body", "max_contact_force_N", 1e-3, "kN", rows,
         "Of all grains together, mean over a window; of a plane at one instant.");
  figure(summary, "grains", "particles", 1.0, "", rows, "In the bed at the end.");
  figure(summary, "steps of the mechanism", "steps", 1.0, "", rows, "Of the time integration, rejected ones apart.");
  figure(summary, "wall time", "wall_s", 1.0, "s", rows, "From the first window to the last.");
  figure(summary, "of it grains", "dem_wall_s", 1.0, "s", rows, "What LIGGGHTS took.");
  figure(summary, "of it waiting", "waited_wall_s", 1.0, "s", rows,
         "The grains stood still for the mechanism and the exchange.");
  figure(summary, "mechanism", "mbd_wall_s", 1.0, "s", rows, "What the multibody solver took.");
  figure(summary, "mechanism, while grains move", "mbd_beside_wall_s", 1.0, "s", rows,
         "The part of its work for which the grains did not wait, rows and controllers with it.");
  page.table(rows);
  std::string active;
  for (const Json& part : summary.value("active", Json::array()))
    active += (active.empty() ? "" : ", ") + part.get<std::string>();
  if (!active.empty()) page.paragraph("Active parts: " + active + ".");
}

// The page that plays the run, made with the report.
void show_view(const fs::path& folder, HtmlPage& page) {
  if (!has_frames(folder.string()) || !fs::exists(folder / "history.csv")) return;
  try {
    write_view({folder.string(), 0});
    page.link("view.html", "Play the run in 3D", "view.html stands beside this page, and is one file too.");
  } catch (const InputError& error) {
    page.warning(std::string("The run cannot be played in 3D: ") + error.what());
  }
}

// Every column of the history, to choose from, zoom and read.
void show_history(const fs::path& folder, const Json& summary, HtmlPage& page) {
  if (!fs::exists(folder / "history.csv")) return;
  const History history = read_history((folder / "history.csv").string());
  if (history.columns.empty() || history.columns.front().empty()) return;
  page.section("History");
  page.paragraph(
      "Type a part of a name to add a column, at most eight. Drag over a plot to zoom, double-click to go back; values "
      "stand under the pointer. docs/history.md says what each column is.");
  PageParts parts;
  add_history(history, first_columns(history, summary.value("observed_body", "")), parts);
  page.plots(parts.elements(kReportScript));
}

void show_quality(const Json& summary, HtmlPage& page) {
  page.section("How far to trust it");
  Rows rows = {{"measure", "value", "unit"}};
  figure(summary, "energy balance of the mechanism", "energy_balance_relative", 100.0, "% of the energy moved", rows);
  figure(summary, "drift of the joints, position", "drift_position", 1.0, "m, rad", rows);
  figure(summary, "drift of the joints, velocity", "drift_velocity", 1.0, "m/s, rad/s", rows);
  figure(summary, "energy lost or made by the interface", "coupling_energy_residual_relative", 100.0,
         "% of the energy moved", rows);
  figure(summary, "largest overlap of a grain", "max_overlap_over_radius", 100.0, "% of its radius", rows);
  figure(summary, "time step of the grains", "dt_dem_s", 1.0, "s", rows);
  figure(summary, "windows", "windows", 1.0, "", rows);
  page.table(rows);
  if (!summary.contains("max_omega_h")) return;
  page.paragraph(
      "Largest omega H of each coupled body: its contact frequency times the window. Below one half the windows are "
      "small enough, above two they are unstable.");
  rows = {{"body", "omega H"}};
  for (const auto& [body, value] : summary.at("max_omega_h").items())
    rows.push_back({body, short_text(value.get<double>())});
  page.table(rows);
}

// ledger.csv at the start and the end of the run, and its picture.
void show_ledger(const fs::path& folder, HtmlPage& page) {
  if (!fs::exists(folder / "ledger.csv")) return;
  const History ledger = read_history((folder / "ledger.csv").string());
  if (ledger.columns.empty() || ledger.columns[0].empty()) return;
  Rows rows = {{"energy", "start [J]", "end [J]", "change [J]"}};
  for (std::size_t k = 0; k < ledger.names.size(); ++k) {
    const std::vector<double>& column = ledger.columns[k];
    const bool nothing = std::all_of(column.begin(), column.end(), [](double v) { return v == 0.0; });
    if (ledger.units[k] != "J" || nothing) continue;
    std::string words = ledger.names[k];
    std::replace(words.begin(), words.end(), '.', ' ');
    std::replace(words.begin(), words.end(), '_', ' ');
    rows.push_back(
        {words, short_text(column.front()), short_text(column.back()), short_text(column.back() - column.front())});
  }
  page.section("Energy ledger");
  page.paragraph(
      "Energy stored and dissipated in the mechanism, work it gave to the grains, and what they made of it. The sum "
      "would stay the same without numerical "
      "errors. What the grains dissipated is the rest of the work they received; it holds the elastic energy in their "
      "contacts too, and may fall by that much.");
  page.table(rows);
  if (has_content((folder / "plots" / kLedgerPicture).string()))
    page.picture((folder / "plots" / kLedgerPicture).string(), "Where the energy is");
}

}  // namespace

std::string run_page(const std::string& run) {
  const fs::path folder(run);
  // A run that was started by its plain line, or without plots, has none yet.
  const bool ledger = fs::exists(folder / "ledger.csv") || write_ledger(folder.string());
  if (ledger && !fs::exists(folder / "plots" / kLedgerPicture)) make_pictures(folder.string());
  const Json summary = read_summary((folder / "summary.json").string());
  const std::string title = summary.contains("scene") ? summary.at("scene").value("title", "") : "";
  HtmlPage page(title.empty() ? folder.filename().string() : title);
  page.paragraph("Run " + folder.string());
  show_warnings(summary, page);
  show_view(folder, page);
  show_summary(summary, page);
  show_pictures((folder / "pictures").string(), "Grains and mechanism", page);
  show_pictures(folder.string(), "Pictures", page);
  show_history(folder, summary, page);
  show_quality(summary, page);
  show_ledger(folder, page);
  show_pictures((folder / "plots").string(), "Plots", page);
  if (fs::exists(folder / "compare/comparison.txt")) {
    page.section("Beside stock LIGGGHTS or another run");
    page.preformatted(read_whole_file((folder / "compare/comparison.txt").string()).value_or(""));
    for (const std::string& picture : pictures_in((folder / "compare/plots").string())) page.picture(picture);
  }
  show_scene(summary, page);
  show_versions(summary, page);
  return page.text();
}

}  // namespace footfall

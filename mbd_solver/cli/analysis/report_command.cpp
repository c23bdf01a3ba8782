#include "mbd_solver/cli/analysis/report_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/made_files.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/html_page.h"
#include "mbd_solver/cli/analysis/results.h"
#include "mbd_solver/output/history.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

namespace {

// how scenes and scripts mark what the paper does not print
const std::vector<std::string> kMarks = {"[A]", "(assumed"};

constexpr const char* kLedgerPicture = "ledger.png";  // stands in a section of its own

std::string short_text(double value) { return number_text(value, 5); }

std::string contents(const fs::path& path) { return read_whole_file(path.string()).value_or(""); }

// A figure of the summary times `factor`, when it is there.
void figure(const Json& summary, const char* label, const char* key, double factor, const char* unit, Rows& rows) {
  if (summary.contains(key) && summary[key].is_number())
    rows.push_back({label, short_text(factor * summary[key].get<double>()), unit});
}

// A picture that gnuplot began and did not draw is empty.
bool has_content(const fs::path& file) {
  std::error_code error;
  return fs::file_size(file, error) > 0 && !error;
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> pictures;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".png" && entry.path().stem() != "overview" &&
        entry.path().filename() != kLedgerPicture && has_content(entry.path()))
      pictures.push_back(entry.path());
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

void show_pictures(const fs::path& folder, const std::string& heading, HtmlPage& page) {
  const std::vector<fs::path> pictures = pictures_in(folder);
  if (pictures.empty()) return;
  page.section(heading);
  for (const fs::path& picture : pictures) page.picture(picture.string());
}

void show_summary(const Json& summary, HtmlPage& page) {
  page.section("Summary");
  const std::string status = summary.value("status", "unknown");
  if (status != "done")
    page.warning("This run is not complete: " + status +
                 (summary.contains("reason") ? ": " + summary.at("reason").get<std::string>() : ""));
  Rows rows = {{"figure", "value", "unit"}};
  figure(summary, "simulated time", "end_time_s", 1.0, "s", rows);
  figure(summary, "peak acceleration", "peak_acceleration_g", 1.0, "g", rows);
  figure(summary, "largest descent", "max_descent_m", 1.0, "m", rows);
  figure(summary, "largest depth below the ground", "max_penetration_m", 1.0, "m", rows);
  figure(summary, "largest contact force on one body", "max_contact_force_N", 1e-3, "kN", rows);
  figure(summary, "grains", "particles", 1.0, "", rows);
  figure(summary, "steps of the mechanism", "steps", 1.0, "", rows);
  figure(summary, "wall time", "wall_s", 1.0, "s", rows);
  figure(summary, "of it grains", "dem_wall_s", 1.0, "s", rows);
  figure(summary, "of it mechanism", "mbd_wall_s", 1.0, "s", rows);
  page.table(rows);
  std::string active;
  for (const Json& part : summary.value("active", Json::array()))
    active += (active.empty() ? "" : ", ") + part.get<std::string>();
  if (!active.empty()) page.paragraph("Active parts: " + active + ".");
  for (const Json& text : summary.value("warnings", Json::array())) page.warning(text.get<std::string>());
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
  if (has_content(folder / "plots" / kLedgerPicture))
    page.picture((folder / "plots" / kLedgerPicture).string(), "Where the energy is");
}

// The scene file, the scenes it is built on, and the scripts of the grains.
std::vector<fs::path> sources_of(const Json& summary) {
  std::vector<fs::path> files;
  fs::path next = summary.value("scene_file", "");
  while (!next.empty() && fs::is_regular_file(next) && files.size() < 9) {
    files.push_back(next);
    std::istringstream lines(contents(next));
    const fs::path folder = next.parent_path();
    next.clear();
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("base", 0) != 0) continue;
      const std::size_t open = line.find('"'), close = line.find('"', open + 1);
      if (close == std::string::npos) continue;
      next = (folder / line.substr(open + 1, close - open - 1)).lexically_normal();
      if (fs::is_directory(next)) next /= "scene.toml";
    }
  }
  const Json& scene = summary.at("scene");
  if (!scene.contains("particles") || !scene.at("particles").is_object()) return files;
  std::vector<fs::path> scripts = {scene.at("particles").value("script", "")};
  if (scene.at("particles").at("bed").is_object())
    scripts.emplace_back(scene.at("particles").at("bed").value("script", ""));
  for (const fs::path& script : scripts) {
    if (!fs::is_regular_file(script)) continue;
    files.push_back(script);
    const ScriptText text(script.string(), {});
    for (const ScriptCommand& command : text.commands())
      if (std::find(files.begin(), files.end(), fs::path(command.file)) == files.end())
        files.emplace_back(command.file);
  }
  return files;
}

void show_scene(const Json& summary, HtmlPage& page) {
  page.section("Scene and assumptions");
  if (!summary.contains("scene")) return;
  const Json settings = summary.value("settings", Json::array());
  if (!settings.empty()) {
    std::string text;
    for (const Json& setting : settings) text += "--set " + setting.get<std::string>() + "\n";
    page.paragraph("Changed for this run:");
    page.preformatted(text);
  }
  const std::vector<fs::path> files = sources_of(summary);
  Rows rows = {{"where", "assumed, because the paper does not print it"}};
  for (const fs::path& file : files) {
    std::istringstream lines(contents(file));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (line.rfind("#", 0) == 0) continue;  // explains the marks
      if (std::none_of(kMarks.begin(), kMarks.end(),
                       [&](const std::string& m) { return line.find(m) != std::string::npos; }))
        continue;
      rows.push_back({(file.parent_path().filename() / file.filename()).string() + ":" + std::to_string(number), line});
    }
  }
  if (rows.size() > 1) page.table(rows);
  for (const fs::path& file : files)
    page.folded((file.parent_path().filename() / file.filename()).string() + ", as it is now", contents(file), kMarks);
  page.folded("the scene as it was run, with all defaults", summary.at("scene").dump(2));
}

void show_versions(const Json& summary, HtmlPage& page) {
  page.section("Versions");
  Rows rows;
  const Json versions = summary.value("versions", Json::object());
  for (const auto& [name, version] : versions.items())
    rows.push_back({name, version.is_string() ? version.get<std::string>() : version.dump()});
  rows.push_back({"integrator", summary.value("integrator", "unknown")});
  page.table(rows, false);
}

std::string run_page(const fs::path& folder) {
  // A run that was started by its plain line, or without plots, has none yet.
  const bool ledger = fs::exists(folder / "ledger.csv") || write_ledger(folder.string());
  if (ledger && !fs::exists(folder / "plots" / kLedgerPicture)) make_pictures(folder.string());
  const Json summary = read_summary((folder / "summary.json").string());
  const std::string title = summary.contains("scene") ? summary.at("scene").value("title", "") : "";
  HtmlPage page(title.empty() ? folder.filename().string() : title);
  page.paragraph("Run " + folder.string());
  show_summary(summary, page);
  show_quality(summary, page);
  show_ledger(folder, page);
  show_pictures(folder / "plots", "Plots", page);
  show_pictures(folder, "Pictures", page);
  show_pictures(folder / "pictures", "Grains and mechanism", page);
  if (fs::exists(folder / "compare/comparison.txt")) {
    page.section("Beside stock LIGGGHTS or another run");
    page.preformatted(contents(folder / "compare/comparison.txt"));
    for (const fs::path& picture : pictures_in(folder / "compare/plots")) page.picture(picture.string());
  }
  show_scene(summary, page);
  show_versions(summary, page);
  return page.text();
}

Rows csv_rows(const fs::path& file) {
  Rows rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    rows.push_back(split(line, ','));
  }
  return rows;
}

std::string sweep_page(const fs::path& folder) {
  HtmlPage page("Sweep " + folder.filename().string());
  page.paragraph("Sweep " + folder.string());
  for (const auto& [name, heading] :
       {std::pair<const char*, const char*>{"cases.csv", "Cases: means over ensembles"}, {"runs.csv", "Runs"}}) {
    if (!fs::exists(folder / name)) continue;
    page.section(heading);
    page.table(csv_rows(folder / name));
  }
  show_pictures(folder, "Plots", page);
  show_pictures(folder / "plots", "Plots", page);
  Rows rows = {
      {"run", "status", "energy balance [%]", "interface [%]", "largest overlap [% of radius]", "wall time [s]"}};
  std::vector<fs::path> runs;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == "summary.json") runs.push_back(entry.path().parent_path());
  std::sort(runs.begin(), runs.end());
  Json last;
  for (const fs::path& run : runs) {
    try {
      last = read_summary((run / "summary.json").string());
    } catch (const InputError&) {  // cut short: one run of many
      rows.push_back({fs::relative(run, folder).string(), "damaged", "-", "-", "-", "-"});
      continue;
    }
    const auto percent = [&](const char* key) {
      return last.contains(key) && last[key].is_number() ? short_text(100.0 * last[key].get<double>())
                                                         : std::string("-");
    };
    rows.push_back({fs::relative(run, folder).string(), last.value("status", "unknown"),
                    percent("energy_balance_relative"), percent("coupling_energy_residual_relative"),
                    percent("max_overlap_over_radius"), short_text(last.value("wall_s", 0.0))});
  }
  if (runs.empty()) return page.text();
  page.section("How far to trust them");
  page.table(rows);
  show_scene(last, page);
  page.paragraph("The scene is that of the run " + runs.back().filename().string() + ".");
  show_versions(last, page);
  return page.text();
}

}  // namespace

std::string write_report(const std::string& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  std::string text;
  const MadeFiles made(path.string());
  if (fs::exists(path / "summary.json")) {
    text = with_summary_of(path.string(), [&] { return run_page(path); });
  } else if (fs::exists(path / "runs.csv")) {
    text = with_summary_of(path.string(), [&] { return sweep_page(path); });
  } else {
    throw InputError(folder + ": holds neither summary.json nor runs.csv; expected the folder of a run or of a sweep");
  }
  const fs::path file = path / "report.html";
  write_whole_file(file.string(), text, "is the disk full?");
  return file.string();
}

}  // namespace footfall

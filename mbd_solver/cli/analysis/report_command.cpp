#include "mbd_solver/cli/analysis/report_command.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/made_files.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/report_parts.h"
#include "mbd_solver/cli/analysis/report_run.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

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
  show_pictures(folder.string(), "Plots", page);
  show_pictures((folder / "plots").string(), "Plots", page);
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
    text = with_summary_of(path.string(), [&] { return run_page(path.string()); });
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

#include "mbd_solver/cli/analysis/column_plot.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/made_files.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/column_choice.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/launch/programs.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t kLongestFile = 60;  // characters of a picture's name

// "struts.*.force" -> "struts.all.force"
std::string file_name(const std::vector<std::string>& words) {
  std::string name;
  for (const char c : joined(words, "-")) {
    if (c == '*') {
      name += "all";
    } else {
      name += std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' ? c : '_';
    }
  }
  return name.substr(0, kLongestFile);
}

// Of a run that is under way there is none yet.
Json summary_of(const fs::path& run) {
  const fs::path file = run / "summary.json";
  return fs::exists(file) ? read_summary(file.string()) : Json::object();
}

void demand_ending(const std::string& out) {
  const std::string ending = fs::path(out).extension().string();
  if (!out.empty() && ending != ".png" && ending != ".svg")
    throw InputError("--out " + out + ": the picture's file ends with \"" + ending + "\", expected .png or .svg");
}

PlotPage page_of(const std::string& name, const std::string& title, Panels panels) {
  PlotPage page{name, title, std::move(panels.figures), panels.multiples ? 2 : 1};
  const int count = static_cast<int>(page.figures.size()), rows = (count + page.columns - 1) / page.columns;
  page.width = page.columns == 1 ? 900 : 1500;
  page.height = count == 1 ? 520 : 60 + 330 * rows;
  // gnuplot's names of data blocks have letters, digits and _ only.
  std::string block = name;
  std::replace_if(
      block.begin(), block.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  for (int i = 0; i < count; ++i)
    page.figures[static_cast<std::size_t>(i)].name = "columns_" + block + "_" + std::to_string(i + 1);
  if (count == 1 && !title.empty() && page.figures.front().title.find(title) == std::string::npos)
    page.figures.front().title = title + (page.figures.front().title.empty() ? "" : ": " + page.figures.front().title);
  return page;
}

std::vector<std::string> listed(const History& history) {
  std::vector<std::string> lines;
  for (std::size_t i = 1; i < history.names.size(); ++i)
    lines.push_back(history.names[i] + " [" + history.units[i] + "]");
  return lines;
}

}  // namespace

std::vector<std::string> plot_columns(const ColumnPlot& plot) {
  const fs::path run(plot.run);
  if (!fs::exists(run / "history.csv"))
    throw InputError(plot.run + ": holds no history.csv; expected the folder of a run");
  demand_ending(plot.out);
  const History history = read_history((run / "history.csv").string());
  if (plot.columns.empty()) return listed(history);
  if (history.columns.front().size() < 2)
    throw InputError(plot.run + "/history.csv: has fewer than two rows: there is nothing to draw yet");
  const Json summary = summary_of(run);
  const Json scene = summary.value("scene", Json::object());
  const std::vector<std::string> columns = chosen_columns(history, scene, plot.columns);

  const std::string title = plot.title.empty() ? scene.value("title", "") : plot.title;
  PlotPage page = page_of(file_name(plot.columns), title, panels_of(history, columns));
  const fs::path plots = run / "plots";
  const MadeFiles made(run.string());
  reduce_long_figures(page.figures, history, plots.string());
  const std::string script = write_page_script(plots.string(), page);
  const std::string picture = run_gnuplot(plots.string(), {script}).front();
  if (plot.out.empty()) return {short_path(picture), short_path(fs::path(picture).replace_extension(".svg").string())};
  const std::string drawn = fs::path(picture).replace_extension(fs::path(plot.out).extension()).string();
  const std::optional<std::string> bytes = read_whole_file(drawn);
  if (!bytes) throw InputError(drawn + ": gnuplot did not draw it; see " + (plots / "gnuplot.log").string());
  write_whole_file(plot.out, *bytes);
  return {plot.out};
}

}  // namespace footfall

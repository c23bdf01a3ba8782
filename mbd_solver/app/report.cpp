// HTML pages by concatenation: style, tables, pictures (base64), and the data and script of what the browser draws are in the page.
#include "mbd_solver/app/report.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/packed_series.h"
#include "mbd_solver/app/plots.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/app/run_folder.h"
#include "mbd_solver/app/view_page.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/base/packed_bytes.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/scene/particle_script.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kSheet =
    ":root{color-scheme:light dark;--page:#fff;--ink:#222;--soft:#666;--line:#e4e4e4;--rule:#ccc;--field:#f6f6f4;"
    "--warn:#fff0e0;--mark:#ffe9a8;--missed:#fbdcd8;--missed-ink:#8c1209;--met:#136b2b}"
    "@media screen and (prefers-color-scheme:dark){:root{--page:#16191d;--ink:#e4e6e8;--soft:#a3a9b0;--line:#333a42;"
    "--rule:#4a525c;--field:#21262c;--warn:#3a2a17;--mark:#5c4a10;--missed:#4a1d1a;--missed-ink:#ffb4ab;--met:#7bd88f}"
    "a{color:#8ab4f8}figure img{background:#fff}}body{font:15px/1.5 sans-serif;color:var(--ink);"
    "background:var(--page);max-width:1000px;margin:2em auto;padding:0 1em}h1{font-size:1.7em}h2{margin-top:2em;"
    "border-bottom:1px solid var(--rule)}.t{overflow-x:auto;margin:1em 0}table{border-collapse:collapse}"
    "td,th{padding:.2em .8em;border-bottom:1px solid var(--line);text-align:left}"
    "td:first-child,th:first-child{padding-left:0}th{vertical-align:bottom}.n{text-align:right;white-space:nowrap;"
    "font-variant-numeric:tabular-nums}th.n{white-space:normal}p,h1{overflow-wrap:anywhere}"
    "pre{background:var(--field);padding:.8em;overflow-x:auto;font-size:12.5px;line-height:1.4}"
    "mark{background:var(--mark);color:inherit}figure{margin:1.2em 0}figure img{max-width:100%}"
    "figcaption,.about{color:var(--soft)}.warning{background:var(--warn);border-left:4px solid #d55e00;"
    "padding:.4em .8em}nav a{margin-right:1em;display:inline-block}summary{cursor:pointer}h3{margin:1.4em 0 .2em}"
    "tr.missed td{background:var(--missed);color:var(--missed-ink);font-weight:600}tr.open td{background:var(--warn)}"
    "tr.met td:last-child{color:var(--met)}@media (max-width:600px){body{margin:1em auto;font-size:14px}"
    "h1{font-size:1.3em}td,th{padding:.2em .5em}.n{white-space:normal}}@media print{:root{color-scheme:light}"
    "body{max-width:none;margin:0;font-size:10pt}nav,details{display:none}.t{overflow:visible}.n{white-space:normal}"
    "h2,h3{break-after:avoid}table,figure,.warning{break-inside:avoid}*{-webkit-print-color-adjust:exact;"
    "print-color-adjust:exact}}";

// Begins with a number, as "12.5" and "3.2 %".
bool is_number(const std::string& text) {
  double value = 0.0;
  return read_number(text.substr(0, text.find(' ')), value);
}

// "[words](path)" is a link to a file below the page's folder; what could lead elsewhere is none.
std::string cell_text(const std::string& cell) {
  const std::size_t middle = cell.find("](");
  if (cell.empty() || cell.front() != '[' || cell.back() != ')' || middle == std::string::npos ||
      cell.find_first_of(":\\") != std::string::npos || cell[middle + 2] == '/')
    return html_text(cell);
  return "<a href=\"" + html_text(cell.substr(middle + 2, cell.size() - middle - 3)) + "\">" +
         html_text(cell.substr(1, middle - 1)) + "</a>";
}

}  // namespace

HtmlPage::HtmlPage(const std::string& title) : title_(title) {}

void HtmlPage::section(const std::string& heading) {
  const std::string id = "s" + std::to_string(++sections_);
  contents_ += "<a href=\"#" + id + "\">" + html_text(heading) + "</a> ";
  body_ += "<h2 id=\"" + id + "\">" + html_text(heading) + "</h2>\n";
}

void HtmlPage::subsection(const std::string& heading) { body_ += "<h3>" + html_text(heading) + "</h3>\n"; }

void HtmlPage::paragraph(const std::string& text) { body_ += "<p>" + html_text(text) + "</p>\n"; }

void HtmlPage::warning(const std::string& text) { body_ += "<p class=\"warning\">" + html_with_code(text) + "</p>\n"; }

void HtmlPage::link(const std::string& file, const std::string& label, const std::string& text) {
  body_ += "<p><a href=\"" + html_text(file) + "\">" + html_text(label) + "</a>: " + html_text(text) + "</p>\n";
}

void HtmlPage::plots() { body_ += "<div class=\"footfall-plots\"></div>\n"; }

void HtmlPage::mechanism(const std::string& caption) {
  body_ += "<figure><canvas class=\"footfall-mechanism\"></canvas><figcaption>" + html_text(caption) +
           "</figcaption></figure>\n";
}

void HtmlPage::figures(const std::vector<Figure>& figures, const History& history) {
  body_ += "<div class=\"footfall-figures\" data-group=\"" + std::to_string(add_figures(figures, history, data_)) +
           "\"></div>\n";
}

void HtmlPage::table(const std::vector<std::vector<std::string>>& rows, bool head,
                     const std::vector<std::string>& classes) {
  body_ += "<div class=\"t\"><table>\n";
  // A column is aligned as most of what it holds.
  std::vector<int> numbers;
  for (std::size_t i = head ? 1 : 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      numbers.resize(std::max(numbers.size(), k + 1));
      if (!rows[i][k].empty()) numbers[k] += is_number(rows[i][k]) ? 1 : -1;
    }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string cell = head && i == 0 ? "th" : "td";
    body_ += i < classes.size() && !classes[i].empty() ? "<tr class=\"" + classes[i] + "\">" : "<tr>";
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      const bool number = k < numbers.size() && numbers[k] > 0;
      body_ += "<" + cell + (number ? " class=\"n\"" : "") + ">" + cell_text(rows[i][k]) + "</" + cell + ">";
    }
    body_ += "</tr>\n";
  }
  body_ += "</table></div>\n";
}

void HtmlPage::preformatted(const std::string& text) { body_ += "<pre>" + html_text(text) + "</pre>\n"; }

void HtmlPage::folded(const std::string& label, const std::string& text, const std::vector<std::string>& marks) {
  body_ += "<details><summary>" + html_text(label) + "</summary><pre>";
  for (const std::string& line : split(text, '\n')) {
    const bool marked = std::any_of(marks.begin(), marks.end(),
                                    [&](const std::string& m) { return line.find(m) != std::string::npos; });
    body_ += (marked ? "<mark>" : "") + html_text(line) + (marked ? "</mark>" : "") + "\n";
  }
  body_ += "</pre></details>\n";
}

void HtmlPage::picture(const std::string& path, const std::string& caption) {
  const std::string bytes = read_whole_file(path).value_or("");
  if (bytes.empty()) throw InputError(code::kPictureNotReadable, path + ": cannot be read; expected a picture");
  const std::filesystem::path name(path);
  const std::string kind = name.extension() == ".svg" ? "svg+xml" : "png";
  std::string words = caption.empty() ? name.stem().string() : caption;
  std::replace(words.begin(), words.end(), '_', ' ');
  body_ += "<figure><img alt=\"" + html_text(words) + "\" src=\"data:image/" + kind + ";base64," + base64(bytes) +
           "\"/><figcaption>" + html_text(words) + "</figcaption></figure>\n";
}

std::string HtmlPage::text() const {
  return "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
         "<meta charset=\"utf-8\"/>\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
         "script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width\"/>\n" +
         (address_.empty() ? "" : "<meta http-equiv=\"refresh\" content=\"0;url=" + html_text(address_) + "\"/>\n") +
         "<title>" + html_text(title_) + "</title>\n<style>" + kSheet + "</style>\n</head>\n<body>\n<h1>" +
         html_text(title_) + "</h1>\n<nav>" + contents_ + "</nav>\n" + body_ +
         (data_.run.is_null() ? "" : data_.elements(kReportScript)) + "</body>\n</html>\n";
}

namespace {

using Rows = std::vector<std::vector<std::string>>;  // of a table

// Marks of assumed values in scenes and scripts.
const std::vector<std::string> kMarks = {"[A]", "(assumed"};

std::string contents(const fs::path& path) { return read_whole_file(path.string()).value_or(""); }

// The scene file, the scenes on which it is based, and the scripts of the grains.
std::vector<fs::path> sources_of(const Json& summary) {
  std::vector<fs::path> files;
  fs::path next = summary.value("scene_file", "");
  while (!next.empty() && fs::is_regular_file(next) && files.size() < 9) {
    files.push_back(next);
    const std::vector<std::string> lines = split(contents(next), '\n');
    const fs::path folder = next.parent_path();
    next.clear();
    for (const std::string& line : lines) {
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

std::string short_text(double value) { return number_text(value, 5); }

// gnuplot leaves an empty file where it fails.
bool has_content(const std::string& file) {
  std::error_code error;
  return fs::file_size(file, error) > 0 && !error;
}

// `but`: names of pictures that the page draws itself.
std::vector<std::string> pictures_in(const std::string& folder, const std::vector<Figure>& but = {}) {
  std::vector<std::string> pictures;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".png" && name != "overview" && has_content(entry.path().string()) &&
        std::none_of(but.begin(), but.end(), [&](const Figure& figure) { return figure.name == name; }))
      pictures.push_back(entry.path().string());
  }
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

void show_pictures(const std::string& folder, const std::string& heading, HtmlPage& page,
                   const std::vector<Figure>& but = {}) {
  const std::vector<std::string> pictures = pictures_in(folder, but);
  if (pictures.empty()) return;
  page.section(heading);
  for (const std::string& picture : pictures) page.picture(picture);
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
  Rows rows = {{"where", "assumed, because the paper does not give it"}};
  for (const fs::path& file : files) {
    int number = 0;
    for (const std::string& line : split(contents(file), '\n')) {
      ++number;
      if (line.rfind("#", 0) == 0) continue;  // an explanation of the marks
      if (std::none_of(kMarks.begin(), kMarks.end(),
                       [&](const std::string& m) { return line.find(m) != std::string::npos; }))
        continue;
      rows.push_back({(file.parent_path().filename() / file.filename()).string() + ":" + std::to_string(number), line});
    }
  }
  if (rows.size() > 1) page.table(rows);
  for (const fs::path& file : files)
    page.folded((file.parent_path().filename() / file.filename()).string() + ", as it is now", contents(file), kMarks);
  page.folded("the scene of this run, with all defaults", summary.at("scene").dump(2));
}

void show_versions(const Json& summary, HtmlPage& page) {
  page.section("Versions");
  Rows rows;
  for (const char* key : {"versions", "machine"}) {
    const Json entries = summary.value(key, Json::object());
    for (const auto& [name, value] : entries.items())
      rows.push_back({name, value.is_string() ? value.get<std::string>() : value.dump()});
  }
  rows.push_back({"integrator", summary.value("integrator", "unknown")});
  page.table(rows, false);
}

// A number of the summary times `factor`, if it has one; `meaning`: a further cell.
void add_metric(const Json& summary, const char* label, const char* key, double factor, const char* unit, Rows& rows,
                const char* meaning = nullptr) {
  if (!summary.contains(key) || !summary[key].is_number()) return;
  const double value = factor * summary[key].get<double>();
  const std::string in = unit;
  const bool by_size = in == "N" || in == "m" || in == "J";
  rows.push_back({label, by_size ? readable(value, in) : short_text(value) + (in.empty() ? "" : " " + in)});
  if (meaning != nullptr) rows.back().emplace_back(meaning);
}

void show_end(const Json& summary, HtmlPage& page) {
  if (summary.value("status", "unknown") != "done") page.warning("This run is not complete: " + end_text(summary));
}

void show_warnings(const Json& summary, HtmlPage& page) {
  for (const Json& text : summary.value("warnings", Json::array())) page.warning(text.get<std::string>());
  for (const Json& accepted : summary.value("accepted_warnings", Json::array()))
    page.warning("Accepted, as " + accepted.value("reason", "") + ": " + accepted.value("warning", ""));
}

void show_summary(const Json& summary, HtmlPage& page) {
  page.section("Run and cost");
  Rows rows = {{"metric", "value", "meaning"}};
  add_metric(summary, "simulated time", "end_time_s", 1.0, "s", rows, "End time of the run.");
  add_metric(summary, "grains", "particles", 1.0, "", rows, "In the bed at the end.");
  add_metric(summary, "steps of the mechanism", "steps", 1.0, "", rows, "Accepted steps of the time integration.");
  add_metric(summary, "wall time", "wall_s", 1.0, "s", rows, "From the first window to the last.");
  add_metric(summary, "of it DEM", "dem_wall_s", 1.0, "s", rows, "Steps of LIGGGHTS.");
  add_metric(summary, "of it waiting", "waited_wall_s", 1.0, "s", rows,
             "LIGGGHTS waited for the mechanism and the exchange.");
  add_metric(summary, "mechanism", "mbd_wall_s", 1.0, "s", rows, "Steps of the multibody solver.");
  add_metric(summary, "mechanism, while grains move", "mbd_beside_wall_s", 1.0, "s", rows,
             "The part for which LIGGGHTS did not wait, including output and controllers.");
  page.table(rows);
  std::string active;
  for (const Json& part : summary.value("active", Json::array()))
    active += (active.empty() ? "" : ", ") + part.get<std::string>();
  if (!active.empty()) page.paragraph("Active parts: " + active + ".");
}

// Writes view.html with the report.
void show_view(const fs::path& folder, HtmlPage& page) {
  if (!has_frames(folder.string()) || !fs::exists(folder / "history.csv")) return;
  try {
    write_view({folder.string()});
    page.link(kViewPage, "Play the run in 3D", "view.html, next to this page.");
  } catch (const InputError& error) {
    page.warning(std::string("The run cannot be played in 3D: ") + error.what());
  }
}

// Interactive plots of any column of the history.
void show_history(const History& history, const Json& summary, HtmlPage& page) {
  page.section("History");
  page.paragraph(
      "Type a part of a name to add a column, at most eight. Drag over a plot to zoom, double-click to reset; the "
      "pointer shows values. docs/reference/history.md explains the columns.");
  add_history(history, first_columns(history, summary.value("observed_body", "")), page.data());
  page.plots();
}

// The standard figures, which gnuplot draws after a run as files.
std::vector<Figure> figures_of(const History& history, const Json& summary) {
  std::vector<Figure> figures = standard_figures(history, summary.value("observed_body", ""));
  mark_figures(history, summary, figures);
  return figures;
}

void show_figures(const std::vector<Figure>& figures, const History& history, HtmlPage& page) {
  if (figures.empty()) return;
  page.section("Figures");
  if (touches_nothing(history)) page.paragraph("No body touches anything.");
  page.figures(figures, history);
}

void show_quality(const Json& summary, HtmlPage& page) {
  page.section("Quality of the results");
  Rows rows = {{"measure", "value"}};
  add_metric(summary, "energy balance of the mechanism", "energy_balance_relative", 100.0, "% of the energy exchanged",
             rows);
  add_metric(summary, "drift of the joints, position", "drift_position", 1.0, "m, rad", rows);
  add_metric(summary, "drift of the joints, velocity", "drift_velocity", 1.0, "m/s, rad/s", rows);
  add_metric(summary, "coupling energy error", "coupling_energy_error_relative", 100.0, "% of the energy exchanged",
             rows);
  add_metric(summary, "largest overlap of a grain", "max_overlap_over_radius", 100.0, "% of its radius", rows);
  add_metric(summary, "time step of the grains", "dt_dem_s", 1.0, "s", rows);
  add_metric(summary, "windows", "windows", 1.0, "", rows);
  page.table(rows);
  if (!summary.contains("max_omega_h")) return;
  page.paragraph(
      "Largest coupling frequency number omega H of each coupled body. Below 0.5 results do not depend on the coupling "
      "interval; above 2 the coupling is unstable.");
  rows = {{"body", "omega H"}};
  for (const auto& [body, value] : summary.at("max_omega_h").items())
    rows.push_back({body, short_text(value.get<double>())});
  page.table(rows);
}

// ledger.csv at the start and the end of the run, and its plot.
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
    // + 0.0: never "-0".
    rows.push_back({words, short_text(column.front() + 0.0), short_text(column.back() + 0.0),
                    short_text(column.back() - column.front())});
  }
  page.section("Energy balance by part");
  page.paragraph(
      "Energy stored and dissipated in the mechanism, its work on the grains, and the energy of the grains. Without "
      "numerical errors the sum is constant. Energy dissipated by the grains is the rest of the work that they "
      "received; it includes the elastic energy of their contacts and may decrease by that much.");
  page.table(rows);
  if (const Figure figure = ledger_figure(ledger); !figure.curves.empty()) page.figures({figure}, ledger);
}

// The mechanism in the middle of the run, if the run recorded it.
void show_mechanism(const fs::path& folder, const Json& summary, HtmlPage& page) {
  try {
    const MechanismShapes shapes(folder.string(), summary);
    if (shapes.empty()) return;
    const double time = shapes.times()[nearest(shapes.times(), 0.5 * summary.value("end_time_s", 0.0))];
    PageParts& data = page.data();
    data.run["bodyNames"] = shapes.body_names();
    add_surroundings(summary.value("scene", Json::object()), data);
    add_shapes({time}, {shapes.near(time)}, data);
    if (!data.run["bodies"].is_null() || !data.run["marks"].is_null())
      page.mechanism("The mechanism at " + number_text(time, 4) + " s");
  } catch (const InputError&) {  // told with view.html
  }
}

// "Run landing_mr of 2026-11-30 01:42 UTC, by footfall 0.2.0."
std::string about(const fs::path& folder, const Json& summary) {
  struct stat file = {};
  std::string text = "Run " + folder.filename().string();
  std::tm when = {};
  char date[64];
  if (stat((folder / "summary.json").c_str(), &file) == 0 && gmtime_r(&file.st_mtime, &when) != nullptr &&
      std::strftime(date, sizeof date, "%Y-%m-%d %H:%M UTC", &when) > 0)
    text += " of " + std::string(date);
  const std::string version = summary.value("versions", Json::object()).value("footfall", "");
  return text + (version.empty() ? "" : ", by footfall " + version) + ".";
}

// A page that is passed on names no folders of this machine: the folders of the run and of its scene are left out.
std::string without_folders(std::string text, const fs::path& folder, const Json& summary) {
  const fs::path scene = summary.value("scene_file", "");
  for (const fs::path& path : {folder, scene.parent_path().parent_path(), scene.parent_path()}) {
    const std::string name = html_text(path.string()) + "/";
    if (name.size() < 3) continue;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at))
      text.erase(at, name.size());
  }
  return text;
}

std::string run_page(const std::string& run) {
  const fs::path folder(run);
  // A run that footfall did not start has none yet.
  if (!fs::exists(folder / "ledger.csv")) write_ledger(folder.string());
  const Json summary = read_summary((folder / "summary.json").string());
  const std::string title = summary.contains("scene") ? summary.at("scene").value("title", "") : "";
  HtmlPage page(title.empty() ? folder.filename().string() : title);
  page.paragraph(about(folder, summary));
  show_end(summary, page);
  show_requirements(summary, page);
  page.section("Sheet");
  show_mechanism(folder, summary, page);
  show_sheet(run, summary, page);
  show_warnings(summary, page);
  show_view(folder, page);
  show_summary(summary, page);
  show_pictures((folder / "pictures").string(), "Grains and mechanism", page);
  show_pictures(folder.string(), "Pictures", page);
  const History history = read_history((folder / "history.csv").string());
  std::vector<Figure> figures;
  if (!history.columns.empty() && !history.columns.front().empty()) {
    figures = figures_of(history, summary);
    show_figures(figures, history, page);
    show_history(history, summary, page);
  }
  show_quality(summary, page);
  show_ledger(folder, page);
  figures.push_back({"ledger", "", "", {}});
  show_pictures((folder / "plots").string(), "Plots", page, figures);
  if (fs::exists(folder / "compare/comparison.txt")) {
    page.section("Comparison with stock LIGGGHTS or another run");
    page.preformatted(contents(folder / "compare/comparison.txt"));
    for (const std::string& picture : pictures_in((folder / "compare/plots").string())) page.picture(picture);
  }
  show_scene(summary, page);
  show_versions(summary, page);
  return without_folders(page.text(), folder, summary);
}

// As Table::csv() of studies writes it: names of cases hold commas, as in gravity=[0,0,-3.71].
Rows csv_rows(const fs::path& file) {
  Rows rows;
  for (CsvReader csv(file.string(), "a table of a sweep"); csv.next();)
    rows.emplace_back(csv.cells().begin(), csv.cells().end());
  return rows;
}

std::string sweep_page(const fs::path& folder) {
  HtmlPage page("Sweep " + folder.filename().string());
  NamedSummaries judged;
  std::vector<fs::path> runs;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == "summary.json") runs.push_back(entry.path().parent_path());
  std::sort(runs.begin(), runs.end());
  Rows rows = {{"run", "status", "energy balance [%]", "coupling energy error [%]", "largest overlap [% of radius]",
                "wall time [s]"}};
  Json last;
  for (const fs::path& run : runs) {
    const std::string name = fs::relative(run, folder).string();
    try {
      last = read_summary((run / "summary.json").string());
    } catch (const InputError&) {  // one damaged run among many
      rows.push_back({name, "damaged", "-", "-", "-", "-"});
      continue;
    }
    judged.emplace_back(name, last);
    const auto percent = [&](const char* key) {
      return last.contains(key) && last[key].is_number() ? short_text(100.0 * last[key].get<double>())
                                                         : std::string("-");
    };
    rows.push_back({name, end_text(last), percent("energy_balance_relative"), percent("coupling_energy_error_relative"),
                    percent("max_overlap_over_radius"), short_text(last.value("wall_s", 0.0))});
  }
  show_worst_cases(judged, page);
  for (const auto& [name, heading] :
       {std::pair<const char*, const char*>{"cases.csv", "Cases: means over ensembles"}, {"runs.csv", "Runs"}}) {
    if (!fs::exists(folder / name)) continue;
    page.section(heading);
    page.table(csv_rows(folder / name));
  }
  show_pictures(folder.string(), "Plots", page);
  show_pictures((folder / "plots").string(), "Plots", page);
  if (runs.empty()) return page.text();
  page.section("Quality of the results");
  page.table(rows);
  show_scene(last, page);
  page.paragraph("The scene is taken from the run " + runs.back().filename().string() + ".");
  show_versions(last, page);
  return page.text();
}

}  // namespace

std::string write_report(const std::string& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  std::string text;
  if (fs::exists(path / "summary.json") && fs::exists(path / "history.csv")) {
    text = with_summary_of(path.string(), [&] { return run_page(path.string()); });
  } else if (fs::exists(path / "runs.csv")) {
    text = with_summary_of(path.string(), [&] { return sweep_page(path); });
  } else {
    throw InputError(
        code::kNoRun,
        without_summary(folder, "neither summary.json nor runs.csv; expected the folder of a run or a sweep"));
  }
  const fs::path file = path / "report.html";
  write_whole_file(file.string(), text, "is the disk full?");
  return file.string();
}

// ---- the data of a page

namespace {

constexpr std::size_t kSpans = 2000;  // of time, for histories with more than twice as many rows

// JSON that neither ends a script element nor has characters with a meaning in XML.
std::string harmless(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
    text += c == '<' ? "\\u003c" : c == '>' ? "\\u003e" : c == '&' ? "\\u0026" : std::string(1, c);
  return text;
}

std::string element(const std::string& name, const std::string& type, const std::string& text) {
  return "<script type=\"" + type + "\" id=\"footfall-" + name + "\">" + text + "</script>\n";
}

Json marks_of(const std::vector<Mark>& marks) {
  Json list = Json::array();
  for (const Mark& mark : marks) list.push_back({{"time", mark.time}, {"value", mark.value}, {"text", mark.text}});
  return list;
}

}  // namespace

void PageParts::add_frame(const std::string& name, std::size_t k, std::string text) {
  (k == 0 ? chunks : later[k]).emplace_back(name + "-" + std::to_string(k), std::move(text));
}

std::string PageParts::elements(const std::string& script) const {
  std::string text = element("run", "application/json", harmless(run));
  text += "<script>//<![CDATA[\n" + script + "\n//]]></script>\n";
  for (const auto& [name, chunk] : chunks) text += element(name, "text/plain", chunk);
  for (const auto& [k, frame] : later)
    for (const auto& [name, chunk] : frame) text += element(name, "text/plain", chunk);
  return text;
}

std::string html_with_code(const std::string& text) {
  const std::vector<std::string> parts = split(text, '`');
  const bool paired = std::count(text.begin(), text.end(), '`') % 2 == 0;
  std::string html;
  for (std::size_t i = 0; i < parts.size(); ++i)
    html += !paired ? (i > 0 ? "`" : "") + html_text(parts[i])
            : i % 2 ? "<code>" + html_text(parts[i]) + "</code>"
                    : html_text(parts[i]);
  return html;
}

void add_history(const History& history, const std::vector<std::string>& shown, PageParts& parts) {
  const std::vector<double>& time = history.column("time");
  const std::vector<std::size_t> rows = rows_to_draw(time, kSpans);
  Json& json = parts.run["history"];
  json["rows"] = rows.size();
  json["time"] = Json::array();
  for (const std::size_t row : rows) json["time"].push_back(time[row]);
  json["names"] = Json::array();
  json["units"] = Json::array();
  std::vector<float> values;
  for (std::size_t i = 0; i < history.names.size(); ++i) {
    if (history.names[i] == "time") continue;
    json["names"].push_back(history.names[i]);
    json["units"].push_back(history.units[i]);
    for (const double value : drawn_values(history.columns[i], rows)) values.push_back(static_cast<float>(value));
  }
  parts.run["shown"] = shown;
  parts.chunks.emplace_back("history", packed_numbers(values));
}

std::size_t add_figures(const std::vector<Figure>& figures, const History& history, PageParts& parts) {
  const std::vector<double>& time = history.column("time");
  const std::vector<std::size_t> rows = rows_to_draw(time, kSpans);
  Json group = {{"times", Json::array()}, {"figures", Json::array()}};
  for (const std::size_t row : rows) group["times"].push_back(time[row]);
  std::vector<float> values;
  for (const Figure& figure : figures) {
    Json curves = Json::array();
    for (std::size_t i = 0; i < figure.curves.size(); ++i) {
      const Curve& curve = figure.curves[i];
      curves.push_back({{"title", curve.title}, {"colour", curve.colour}, {"series", series_of(figure, i)}});
      for (const double value : drawn_values(curve.formula.values(history), rows))
        values.push_back(static_cast<float>(value));
    }
    group["figures"].push_back({{"title", figure.title},
                                {"axis", figure.axis},
                                {"stacked", figure.stacked},
                                {"times", marks_of(figure.times)},
                                {"limits", marks_of(figure.limits)},
                                {"peaks", marks_of(figure.peaks)},
                                {"curves", std::move(curves)}});
  }
  const std::size_t number = parts.run["figures"].size();
  parts.run["figures"].push_back(std::move(group));
  parts.chunks.emplace_back("figures-" + std::to_string(number), packed_numbers(values));
  return number;
}

std::vector<std::string> first_columns(const History& history, const std::string& observed) {
  constexpr std::size_t kMost = 6;
  std::vector<std::string> shown;
  const auto add = [&](const std::string& name) {
    if (history.find(name) >= 0 && shown.size() < kMost) shown.push_back(name);
  };
  add(observed + ".az");
  for (const char* ending : {".contact.fz", ".force", ".joint_torque", ".joint_force", ".angle", ".displacement"}) {
    const std::size_t before = shown.size();
    for (const std::string& name : history.names)
      if (ends_with(name, ending)) add(name);
    if (shown.size() > std::max<std::size_t>(before, 1)) break;
  }
  if (shown.size() < 2)
    for (const char* name : {"energy.kinetic", "energy.gravity", "energy.strain", "energy.total"}) add(name);
  return shown;
}

}  // namespace footfall

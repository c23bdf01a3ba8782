// Chooses columns by kind and name, groups them into panels by unit, and hands figures to plot_script.
#include "mbd_solver/app/plots.h"

#include <fnmatch.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/run_directory.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/bed/programs.h"
#include "mbd_solver/run/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr double kKilo = 1e-3;

// factor times one column
Formula of(const std::string& column, double factor = 1.0) { return {{{1.0, column}}, 0.0, factor}; }

// "energy.kinetic" -> "kinetic", "dissipated.mr_yield" -> "mr yield"
std::string words_after_dot(const std::string& name) {
  std::string words = name.substr(name.find('.') + 1);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

double largest(const History& history, const std::string& name) {
  double size = 0.0;
  for (double value : history.column(name)) size = std::max(size, std::abs(value));
  return size;
}

// Curves for every column that ends so, by the name before it.
std::vector<Curve> curves_of(const History& history, const std::string& ending, double factor) {
  std::vector<Curve> curves;
  for (const std::string& name : history.names) {
    if (ends_with(name, ending)) curves.push_back({name.substr(0, name.size() - ending.size()), of(name, factor)});
  }
  return curves;
}

std::string first_accelerated(const History& history) {
  for (const std::string& name : history.names) {
    if (ends_with(name, ".az")) return name.substr(0, name.size() - 3);
  }
  return "";
}

// Magnitude of the contact force on each body.
std::vector<Curve> contact_curves(const History& history) {
  std::vector<Curve> curves;
  for (const Curve& z : curves_of(history, ".contact.fz", 1.0)) {
    const std::string b = z.title + ".contact.f";
    curves.push_back({z.title, {{{1.0, b + "x"}, {1.0, b + "y"}, {1.0, b + "z"}}, 0.0, kKilo, true}});
  }
  return curves;
}

// Columns that start so, in kJ; parts too small to be seen are left out.
std::vector<Curve> energy_curves(const History& history, const std::string& start) {
  constexpr double kVisible = 2e-3;  // of the largest
  double scale = 0.0;
  std::vector<Curve> curves;
  for (const std::string& name : history.names) {
    if (name.rfind(start, 0) == 0) scale = std::max(scale, largest(history, name));
  }
  for (const std::string& name : history.names) {
    if (name.rfind(start, 0) == 0 && largest(history, name) > kVisible * scale)
      curves.push_back({words_after_dot(name), of(name, kKilo)});
  }
  return curves;
}

std::vector<Curve> dissipation_curves(const History& history) {
  std::vector<Curve> curves = energy_curves(history, "dissipated.");
  const bool grains = history.find("coupling.energy_residual") >= 0;
  if (grains && largest(history, "work.contact") > 0.0) curves.push_back({"to the grains", of("work.contact", -kKilo)});
  return curves;
}

// "leg_2_primary" -> "leg_*_primary"
std::string with_stars_for_numbers(const std::string& name) {
  std::string out;
  for (const char c : name) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0)
      out += c;
    else if (out.empty() || out.back() != '*')
      out += '*';
  }
  return out;
}

// With more series than colours: a figure for each group whose names differ only in numbers, as the primary struts of all
// legs.
void add_split(const Figure& figure, std::vector<Figure>& out) {
  if (figure.curves.size() <= kSeriesColours) {
    out.push_back(figure);
    return;
  }
  std::vector<std::pair<std::string, std::vector<Curve>>> groups;
  for (const Curve& curve : figure.curves) {
    const std::string group = with_stars_for_numbers(curve.title);
    const auto at = std::find_if(groups.rbegin(), groups.rend(), [&](const auto& g) { return g.first == group; });
    if (at == groups.rend() || at->second.size() == kSeriesColours)
      groups.push_back({group, {curve}});
    else
      at->second.push_back(curve);
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Figure part = figure;
    if (i > 0) part.name += "_" + std::to_string(i + 1);
    part.title += ": " + groups[i].first;
    part.curves = groups[i].second;
    out.push_back(part);
  }
}

}  // namespace

std::vector<Figure> standard_figures(const History& history, const std::string& observed) {
  const bool known = !observed.empty() && history.find(observed + ".az") >= 0;
  const std::string body = known ? observed : first_accelerated(history);
  std::vector<Figure> figures;
  if (!body.empty() && !history.columns.front().empty()) {
    const double start = history.column(body + ".z").front();
    figures.push_back({"acceleration",
                       "Acceleration of " + body,
                       "vertical acceleration [g]",
                       {{body, of(body + ".az", 1.0 / 9.80665)}}});
    figures.push_back({"velocity", "Velocity of " + body, "vertical velocity [m/s]", {{body, of(body + ".vz")}}});
    figures.push_back({"descent", "Descent of " + body, "descent [m]", {{body, {{{-1.0, body + ".z"}}, start}}}});
  }
  figures.push_back({"energy", "Mechanical energy and its parts", "energy [kJ]", energy_curves(history, "energy.")});
  figures.push_back(
      {"dissipation", "Dissipated energy and work on the grains", "energy [kJ]", dissipation_curves(history)});
  figures.push_back(
      {"strokes", "Strut strokes, compression positive", "stroke [m]", curves_of(history, ".stroke", 1.0)});
  figures.push_back(
      {"strut_forces", "Strut forces, compression positive", "force [kN]", curves_of(history, ".force", kKilo)});
  figures.push_back({"contact_forces", "Contact forces", "force on the body [kN]", contact_curves(history)});
  std::vector<Figure> split;
  for (const Figure& figure : figures)
    if (!figure.curves.empty()) add_split(figure, split);
  return split;
}

Figure ledger_figure(const History& ledger) {
  constexpr double kVisible = 2e-3;  // of the largest
  struct Band {
    std::string title, colour;
    std::vector<std::string> columns;
  };
  std::vector<Band> bands = {
      {"mechanism, kinetic", "#08519c", {"mechanism.kinetic"}},
      {"mechanism, gravity", "#4292c6", {"mechanism.gravity"}},
      {"mechanism, elastic", "#9ecae1", {"mechanism.strain", "mechanism.gas", "mechanism.contact"}}};
  const std::vector<std::string> warm = {"#a63603", "#e6550d", "#fd8d3c", "#fdae6b",
                                         "#fdd0a2", "#feedde", "#c51b8a", "#fa9fb5"};
  std::size_t next = 0;
  for (const std::string& name : ledger.names)
    if (name.rfind("dissipated.", 0) == 0)
      bands.push_back({"dissipated, " + words_after_dot(name), warm[next++ % warm.size()], {name}});
  if (ledger.find("grains.kinetic") >= 0) {
    bands.push_back({"grains, kinetic", "#00441b", {"grains.kinetic"}});
    bands.push_back({"grains, gravity", "#41ab5d", {"grains.gravity"}});
    bands.push_back({"grains, dissipated and elastic", "#c7e9c0", {"grains.dissipated"}});
  } else if (ledger.find("work.to_grains") >= 0) {
    bands.push_back({"to the grains", "#41ab5d", {"work.to_grains"}});
  }
  // Each band counts from its own lowest value: only changes of energy matter, and no band is negative.
  const auto height = [&](const Band& band) {
    std::vector<double> value(ledger.columns.front().size(), 0.0);
    for (const std::string& name : band.columns) {
      const std::vector<double>& column_values = ledger.column(name);
      for (std::size_t k = 0; k < value.size(); ++k) value[k] += column_values[k];
    }
    return value;
  };
  double scale = 0.0;
  std::vector<std::pair<double, double>> range;
  for (const Band& band : bands) {
    const std::vector<double> value = height(band);
    const auto [low, high] = std::minmax_element(value.begin(), value.end());
    range.emplace_back(*low, *high);
    scale = std::max(scale, *high - *low);
  }
  Formula edge{{}, 0.0, kKilo};  // upper edge of the band
  Figure figure{"ledger", "Energy balance by part, each from its lowest value", "energy [kJ]", {}, "../ledger.csv",
                true};
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (!(range[i].second - range[i].first > kVisible * scale)) continue;
    for (const std::string& name : bands[i].columns) edge.columns.emplace_back(1.0, name);
    edge.constant -= range[i].first;
    figure.curves.push_back({bands[i].title, edge, bands[i].colour});
  }
  return figure;
}

namespace {

using Names = std::vector<std::string>;

constexpr const char* kKinds[] = {"bodies", "joints", "struts", "springs", "drives", "controllers"};

// A * matches within two dots.
bool matches(const std::string& pattern, const std::string& name) {
  const auto as_path = [](std::string text) {
    std::replace(text.begin(), text.end(), '.', '/');
    return text;
  };
  return fnmatch(as_path(pattern).c_str(), as_path(name).c_str(), FNM_PATHNAME | FNM_NOESCAPE) == 0;
}

// The columns of all entries of this kind in the scene.
Names columns_of_kind(const History& history, const Json& scene, const std::string& kind) {
  Names found;
  const Json entries = scene.value(kind, Json::array());
  for (const Json& entry : entries) {
    const std::string owner = entry.value("name", "") + ".";
    for (const std::string& name : history.names)
      if (name.rfind(owner, 0) == 0) found.push_back(name);
  }
  return found;
}

Names columns_for(const History& history, const Json& scene, const std::string& word) {
  if (history.find(word) >= 0) return {word};
  Names found;
  for (const std::string& name : history.names)
    if (name != "time" && matches(word, name)) found.push_back(name);
  const std::size_t dot = word.find('.');
  if (found.empty() && dot != std::string::npos &&
      std::find(std::begin(kKinds), std::end(kKinds), word.substr(0, dot)) != std::end(kKinds)) {
    for (const std::string& name : columns_of_kind(history, scene, word.substr(0, dot)))
      if (matches(word.substr(dot + 1), name)) found.push_back(name);
  }
  for (const std::string between : {"", "."}) {
    if (!found.empty()) break;
    for (const char* axis : {"x", "y", "z"})
      if (history.find(word + between + axis) >= 0) found.push_back(word + between + axis);
  }
  return found;
}

struct Quantity {
  const char* unit;
  const char* name;
  bool grows;    // k, M, G for large values
  bool shrinks;  // m for small ones
};
constexpr Quantity kQuantities[] = {{"N", "force", true, false},    {"N m", "torque", true, false},
                                    {"J", "energy", true, false},   {"W", "power", true, false},
                                    {"Pa", "stress", true, false},  {"m", "length", false, true},
                                    {"m/s", "speed", false, false}, {"m/s2", "acceleration", false, false},
                                    {"rad", "angle", false, false}, {"rad/s", "angular velocity", false, false}};

const Quantity* quantity_of(const std::string& unit) {
  const auto* found =
      std::find_if(std::begin(kQuantities), std::end(kQuantities), [&](const Quantity& q) { return unit == q.unit; });
  return found == std::end(kQuantities) ? nullptr : found;
}

// The word after the last dot, if it is the same in all: "force" of a.force and b.force.
std::string common_ending(const Names& columns) {
  std::string common;
  for (const std::string& name : columns) {
    const std::size_t dot = name.rfind('.');
    const std::string ending = dot == std::string::npos ? "" : name.substr(dot + 1);
    if (ending.empty() || (!common.empty() && ending != common)) return "";
    common = ending;
  }
  return common;
}

// "leg_12_primary.force" -> "leg_12" and "primary.force"; without a number an empty key and the whole name.
std::pair<std::string, std::string> at_number(const std::string& name) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto first = std::find_if(name.begin(), name.end(), digit);
  if (first == name.end()) return {"", name};
  const auto last = std::find_if_not(first, name.end(), digit);
  std::string rest(last, name.end());
  const std::size_t letters = rest.find_first_not_of("_-.");
  return {std::string(name.begin(), last), letters == std::string::npos ? "" : rest.substr(letters)};
}

struct Group {
  std::string title;
  Names columns, labels;
  std::vector<int> colours;
};

// By the first number in the names. Empty if that does not give groups of at most eight.
std::vector<Group> by_number(const Names& columns) {
  std::vector<Group> groups;
  Names roles;
  for (const std::string& name : columns) {
    const auto [key, role] = at_number(name);
    if (key.empty()) return {};
    auto group = std::find_if(groups.begin(), groups.end(), [k = key](const Group& g) { return g.title == k; });
    if (group == groups.end()) group = groups.insert(groups.end(), Group{key, {}, {}, {}});
    auto found = std::find(roles.begin(), roles.end(), role);
    if (found == roles.end()) found = roles.insert(roles.end(), role);
    group->columns.push_back(name);
    group->labels.push_back(role);
    group->colours.push_back(static_cast<int>(found - roles.begin()));
  }
  const bool fit = roles.size() <= kSeriesColours && groups.size() > 1;
  return fit ? groups : std::vector<Group>{};
}

std::vector<Group> by_eights(const Names& columns, const std::string& title) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i % kSeriesColours == 0) groups.push_back({title, {}, {}, {}});
    Group& group = groups.back();
    group.columns.push_back(columns[i]);
    group.labels.push_back(columns[i]);
    group.colours.push_back(static_cast<int>(i % kSeriesColours));
  }
  return groups;
}

// "leg_1_primary.force" -> "leg_1_primary" if all end with ".force", which is then the label of the axis.
void shorten(Names& labels, const std::string& ending) {
  if (ending.empty()) return;
  for (std::string& label : labels)
    if (ends_with(label, "." + ending)) label.resize(label.size() - ending.size() - 1);
}

}  // namespace

Names chosen_columns(const History& history, const Json& scene, const Names& words) {
  Names chosen;
  for (const std::string& word : words) {
    const Names found = columns_for(history, scene, word);
    if (found.empty())
      throw InputError(code::kUnknownColumn, "\"" + word + "\" matches no column of this run's history." +
                                                 known_names("columns", word, history.names));
    for (const std::string& name : found)
      if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
  }
  return chosen;
}

DrawnUnit drawn_unit(const std::string& unit, double largest) {
  const Quantity* quantity = quantity_of(unit);
  if (quantity && quantity->grows) {
    if (largest >= 1e9) return {1e-9, "G" + unit};
    if (largest >= 1e6) return {1e-6, "M" + unit};
    if (largest >= 1e3) return {1e-3, "k" + unit};
  }
  if (quantity && quantity->shrinks && largest > 0.0 && largest < 0.1) return {1e3, "m" + unit};
  return {1.0, unit};
}

Panels panels_of(const History& history, const Names& columns) {
  std::vector<std::pair<std::string, Names>> of_unit;  // in the order of the columns
  for (const std::string& name : columns) {
    const std::string& unit = history.units[static_cast<std::size_t>(history.find(name))];
    auto same = std::find_if(of_unit.begin(), of_unit.end(), [&](const auto& entry) { return entry.first == unit; });
    if (same == of_unit.end()) same = of_unit.insert(of_unit.end(), {unit, {}});
    same->second.push_back(name);
  }
  Panels panels;
  for (const auto& [unit, names] : of_unit) {
    double low = 0.0, high = 0.0;
    for (const std::string& name : names) {
      for (const double value : history.column(name)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    const DrawnUnit drawn = drawn_unit(unit, std::max(-low, high));
    const std::string ending = common_ending(names);
    const Quantity* quantity = quantity_of(unit);
    const bool is_word = ending.size() > 3;  // "force", "angle_rate", but not "az"
    const std::string what = is_word ? ending : quantity ? quantity->name : ending;
    std::vector<Group> groups;
    if (names.size() > kSeriesColours) groups = by_number(names);
    if (groups.empty()) groups = by_eights(names, names.size() == 1 ? names.front() : "");
    panels.multiples = panels.multiples || groups.size() > 1;
    for (Group& group : groups) {
      if (group.columns.size() > 1) shorten(group.labels, ending);
      Figure figure;
      figure.title = group.title;
      figure.axis = (what.empty() ? "" : what + " ") + "[" + drawn.name + "]";
      for (std::size_t i = 0; i < group.columns.size(); ++i)
        figure.curves.push_back(
            {group.labels[i], {{{1.0, group.columns[i]}}, 0.0, drawn.factor}, series_colour(group.colours[i])});
      if (groups.size() > 1 && high > low) {
        const double margin = 0.05 * (high - low);
        figure.low = drawn.factor * (low < 0.0 ? low - margin : 0.0);
        figure.high = drawn.factor * (high > 0.0 ? high + margin : 0.0);
      }
      panels.figures.push_back(std::move(figure));
    }
  }
  return panels;
}

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

// A run in progress has none yet.
Json summary_of(const fs::path& run) {
  const fs::path file = run / "summary.json";
  return fs::exists(file) ? read_summary(file.string()) : Json::object();
}

void require_picture_ending(const std::string& out) {
  const std::string ending = fs::path(out).extension().string();
  if (!out.empty() && ending != ".png" && ending != ".svg")
    throw InputError(code::kWrongOption, "--out " + out + ": ends with \"" + ending + "\", expected .png or .svg");
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

std::vector<std::string> column_list(const History& history) {
  std::vector<std::string> lines;
  for (std::size_t i = 1; i < history.names.size(); ++i)
    lines.push_back(history.names[i] + " [" + history.units[i] + "]");
  return lines;
}

}  // namespace

std::vector<std::string> plot_columns(const ColumnPlot& plot) {
  const fs::path run(plot.run);
  if (!fs::exists(run / "history.csv"))
    throw InputError(code::kNoRun, plot.run + ": no history.csv; expected the folder of a run");
  require_picture_ending(plot.out);
  guard_folder(plot.run);
  const History history = read_history((run / "history.csv").string());
  if (plot.columns.empty()) return column_list(history);
  if (history.columns.front().size() < 2)
    throw InputError(code::kNoRun, plot.run + "/history.csv: fewer than two rows, nothing to draw yet");
  const Json summary = summary_of(run);
  const Json scene = summary.value("scene", Json::object());
  const std::vector<std::string> columns = chosen_columns(history, scene, plot.columns);

  const std::string title = plot.title.empty() ? scene.value("title", "") : plot.title;
  PlotPage page = page_of(file_name(plot.columns), title, panels_of(history, columns));
  const fs::path plots = run / "plots";
  reduce_long_figures(page.figures, history, plots.string());
  const std::string script = write_page_script(plots.string(), page);
  const std::string picture = run_gnuplot(plots.string(), {script}).front();
  if (plot.out.empty()) return {short_path(picture), short_path(fs::path(picture).replace_extension(".svg").string())};
  const std::string drawn = fs::path(picture).replace_extension(fs::path(plot.out).extension()).string();
  const std::optional<std::string> bytes = read_whole_file(drawn);
  if (!bytes)
    throw InputError(code::kGnuplotFailed,
                     drawn + ": gnuplot did not draw it; see " + (plots / "gnuplot.log").string());
  write_whole_file(plot.out, *bytes);
  return {plot.out};
}

}  // namespace footfall

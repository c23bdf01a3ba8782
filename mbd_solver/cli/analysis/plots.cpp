#include "mbd_solver/cli/analysis/plots.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "coupler/base/text.h"

namespace footfall {

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
  if (grains && largest(history, "work.contact") > 0.0)
    curves.push_back({"taken by the grains", of("work.contact", -kKilo)});
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

// More series than there are colours: a figure for each group whose names differ by numbers alone, as the primary
// struts of all legs.
void add_readable(const Figure& figure, std::vector<Figure>& out) {
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
  figures.push_back({"dissipation", "Where the energy went", "energy [kJ]", dissipation_curves(history)});
  figures.push_back(
      {"strokes", "Strut strokes, compression positive", "stroke [m]", curves_of(history, ".stroke", 1.0)});
  figures.push_back(
      {"strut_forces", "Strut forces, compression positive", "force [kN]", curves_of(history, ".force", kKilo)});
  figures.push_back({"contact_forces", "Contact forces", "force on the body [kN]", contact_curves(history)});
  std::vector<Figure> readable;
  for (const Figure& figure : figures)
    if (!figure.curves.empty()) add_readable(figure, readable);
  return readable;
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
    bands.push_back({"taken by the grains", "#41ab5d", {"work.to_grains"}});
  }
  // Each band from its own lowest value: only changes of energy mean something, and then no band is negative.
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
  Figure figure{"ledger", "Where the energy is, each part from its lowest value", "energy [kJ]", {}, "../ledger.csv",
                true};
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (!(range[i].second - range[i].first > kVisible * scale)) continue;
    for (const std::string& name : bands[i].columns) edge.columns.emplace_back(1.0, name);
    edge.constant -= range[i].first;
    figure.curves.push_back({bands[i].title, edge, bands[i].colour});
  }
  return figure;
}

}  // namespace footfall

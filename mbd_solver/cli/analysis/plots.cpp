#include "mbd_solver/cli/analysis/plots.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"
#include "coupler/base/quote.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/analysis/reduced_rows.h"

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

constexpr const char* kStyle = R"(set datafile separator ","
set datafile columnheaders
set encoding utf8
set border 3 lw 1 lc rgb "#404040"
set tics nomirror out
set grid lw 1 lc rgb "#e0e0e0"
set xlabel "time [s]"
set linetype 1 lw 1.8 lc rgb "#0072b2"
set linetype 2 lw 1.8 lc rgb "#d55e00"
set linetype 3 lw 1.8 lc rgb "#009e73"
set linetype 4 lw 1.8 lc rgb "#cc79a7"
set linetype 5 lw 1.8 lc rgb "#e69f00"
set linetype 6 lw 1.8 lc rgb "#56b4e9"
set linetype 7 lw 1.8 lc rgb "#000000"
set linetype 8 lw 1.8 lc rgb "#999999"
set linetype 9 lw 1.8 lc rgb "#f0e442"
set linetype cycle 9
)";

constexpr std::size_t kBlack = 7;  // line type

// The curves of a figure stand in data blocks, $name_0, $name_1 ...: gnuplot reads the long rows of the history once a
// block, not once a curve.
constexpr std::size_t kBlockCurves = 13;  // a `using` of gnuplot takes 14 columns, and the first is the time

std::string block_name(const Figure& figure, std::size_t curve) {
  return "$" + figure.name + "_" + std::to_string(curve / kBlockCurves);
}

std::string data_blocks(const std::vector<Figure>& figures) {
  std::ostringstream text;
  for (const Figure& figure : figures) {
    for (std::size_t i = 0; i < figure.curves.size(); ++i) {
      if (i % kBlockCurves == 0)
        text << "set table " << block_name(figure, i) << " separator tab\nplot " << gnuplot_text(figure.file)
             << " using (column(\"time\"))";
      text << ":" << figure.curves[i].formula.gnuplot();
      if (i % kBlockCurves == kBlockCurves - 1 || i + 1 == figure.curves.size()) text << " with table\nunset table\n";
    }
  }
  text << "unset datafile columnheaders\nset datafile separator tab\n";
  return text.str();
}

std::string curve(const Figure& figure, std::size_t i) {
  return block_name(figure, i) + " using 1:" + std::to_string(i % kBlockCurves + 2);
}

// From the uppermost band to the lowest, so that each is painted over the rest of those above it.
std::string bands(const Figure& figure) {
  std::string text;
  for (std::size_t i = figure.curves.size(); i > 0; --i)
    text += (text.empty() ? "" : ", \\\n     ") + curve(figure, i - 1) +
            " with filledcurves y1=0 fs solid 1 noborder lc rgb " + gnuplot_text(figure.curves[i - 1].colour) +
            " title " + gnuplot_text(figure.curves[i - 1].title);
  return text;
}

std::string lines(const Figure& figure) {
  std::string text;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    const std::size_t style = figure.curves[i].title == "total" ? kBlack : i + 1;
    text += (i ? ", \\\n     " : "") + curve(figure, i) + " with lines lt " + std::to_string(style) + " title " +
            gnuplot_text(figure.curves[i].title);
  }
  return text;
}

std::string plot_command(const Figure& figure) {
  std::ostringstream text;
  text << "set title " << gnuplot_text(figure.title) << " noenhanced\nset ylabel " << gnuplot_text(figure.axis)
       << " noenhanced\n";
  text << (figure.curves.size() == 1 ? "unset key\n" : "set key outside right center samplen 1.5 noenhanced\n");
  if (figure.stacked) text << "set yrange [0:]\n";
  text << "plot " << (figure.stacked ? bands(figure) : lines(figure)) << "\n";
  if (figure.stacked) text << "set yrange [*:*]\n";
  return text.str();
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
  figures.erase(std::remove_if(figures.begin(), figures.end(), [](const Figure& f) { return f.curves.empty(); }),
                figures.end());
  return figures;
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

void reduce_long_figures(std::vector<Figure>& figures, const History& history, const std::string& folder) {
  constexpr std::size_t kSpans = 2000;  // more than a picture has pixels
  const std::vector<double>& time = history.column("time");
  if (time.size() <= 2 * kSpans) return;
  make_folder(folder);
  const std::vector<std::size_t> rows = rows_to_draw(time, kSpans);
  for (Figure& figure : figures) {
    History drawn;
    drawn.names = {"time"};
    drawn.units = {"s"};
    drawn.columns.resize(1);
    for (const std::size_t row : rows) drawn.columns.front().push_back(time[row]);
    for (std::size_t i = 0; i < figure.curves.size(); ++i) {
      drawn.columns.push_back(drawn_values(figure.curves[i].formula.values(history), rows));
      drawn.names.push_back("curve_" + std::to_string(i + 1));
      drawn.units.push_back(figure.axis);
      figure.curves[i].formula = of(drawn.names.back());
    }
    figure.file = figure.name + ".csv";
    write_history((std::filesystem::path(folder) / figure.file).string(), drawn);
  }
}

std::vector<std::string> write_plot_scripts(const std::string& folder, const std::vector<Figure>& figures,
                                            const std::string& title) {
  make_folder(folder);
  std::vector<std::string> names;
  std::string page;
  for (const Figure& figure : figures) {
    names.push_back(
        write_drawing(folder, figure.name, {900, 520}, kStyle + data_blocks({figure}), plot_command(figure)));
    page += plot_command(figure);
  }
  if (figures.empty()) return names;
  const int columns = 2, rows = (static_cast<int>(figures.size()) + columns - 1) / columns;
  const std::string layout = "set multiplot layout " + std::to_string(rows) + "," + std::to_string(columns) +
                             " title " + gnuplot_text(title) + " noenhanced\n";
  names.push_back(write_drawing(folder, "overview", {1500, 380 * rows}, kStyle + data_blocks(figures),
                                layout + page + "unset multiplot\n"));
  return names;
}

}  // namespace footfall

// Curves go into gnuplot's data blocks first, so that it reads the long rows of a history once for several curves.
#include "mbd_solver/app/plot_script.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/run_directory.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/bed/process.h"
#include "mbd_solver/bed/program_watch.h"

namespace footfall {

std::string Formula::gnuplot() const {
  std::string sum = constant != 0.0 ? number_text(constant, 12) : "";
  for (const auto& [c, name] : columns) {
    const std::string term = "column(" + gnuplot_text(name) + ")" + (is_norm ? "**2" : "");
    sum += c < 0.0 ? "-" : sum.empty() ? "" : "+";
    sum += std::abs(c) == 1.0 ? term : number_text(std::abs(c), 12) + "*" + term;
  }
  const std::string whole = is_norm ? "sqrt(" + sum + ")" : "(" + sum + ")";
  return factor == 1.0 ? "(" + whole + ")" : "(" + number_text(factor, 12) + "*" + whole + ")";
}

std::vector<double> Formula::values(const History& history) const {
  std::vector<double> values(history.columns.empty() ? 0 : history.columns.front().size(), is_norm ? 0.0 : constant);
  for (const auto& [c, name] : columns) {
    const std::vector<double>& column = history.column(name);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] += is_norm ? column[k] * column[k] : c * column[k];
  }
  for (double& value : values) value = factor * (is_norm ? std::sqrt(value) : value);
  return values;
}

namespace fs = std::filesystem;

std::string write_drawing(const std::string& folder, const std::string& name, const PictureSize& size,
                          const std::string& setup, const std::string& drawing) {
  const std::string paper =
      " size " + std::to_string(size.width) + "," + std::to_string(size.height) + " font \"DejaVu Sans,11\"";
  const auto on = [&](const std::string& terminal, const std::string& file) {
    return "set terminal " + terminal + "\nset output " + gnuplot_text(file) + "\n" + drawing;
  };
  const std::string script = name + ".gp";
  write_whole_file((fs::path(folder) / script).string(),
                   "# gnuplot " + gnuplot_text(script) + " draws a PNG and an SVG\n" + setup +
                       on("pngcairo" + paper, name + ".png") +
                       on("svg" + paper + " background rgb \"white\"", name + ".svg"));
  return script;
}

std::vector<std::string> run_gnuplot(const std::string& folder, const std::vector<std::string>& scripts) {
  std::vector<std::string> pictures;
  if (scripts.empty()) return pictures;
  for (const std::string& script : scripts)  // gnuplot would write through a link
    for (const char* ending : {".png", ".svg"})
      Place((fs::path(folder) / fs::path(script).replace_extension(ending)).string()).remove();
  const std::string log = "gnuplot.log";
  Command command{{"gnuplot"}, {}, log, folder};
  command.words.insert(command.words.end(), scripts.begin(), scripts.end());
  constexpr double kLimit = 300.0;  // [s]
  const TimeLimit limit("gnuplot", kLimit);
  const ChildEnd end = run_child(command, "", limit);
  if (!end.given_up.empty()) throw InputError(end.given_up);
  if (end.code != 0)
    throw InputError(code::kGnuplotFailed, "gnuplot ended with exit code " + std::to_string(end.code) + "; see " +
                                               (fs::path(folder) / log).string());
  for (const std::string& script : scripts)
    pictures.push_back((fs::path(folder) / fs::path(script).replace_extension(".png")).string());
  return pictures;
}

std::vector<std::size_t> rows_to_draw(const std::vector<double>& time, std::size_t spans) {
  std::vector<std::size_t> rows;
  const std::size_t count = time.size();
  if (count <= 2 * spans) {
    for (std::size_t k = 0; k < count; ++k) rows.push_back(k);
    return rows;
  }
  const double start = time.front(), length = time.back() - time.front();
  const auto span_of = [&](std::size_t k) {
    const double share =
        length > 0.0 ? (time[k] - start) / length : static_cast<double>(k) / static_cast<double>(count);
    return std::min(spans - 1, static_cast<std::size_t>(std::max(0.0, share) * static_cast<double>(spans)));
  };
  for (std::size_t first = 0; first < count;) {
    std::size_t last = first;
    while (last + 1 < count && span_of(last + 1) == span_of(first)) ++last;
    rows.push_back(first);
    if (last > first) rows.push_back(last);
    first = last + 1;
  }
  return rows;
}

std::vector<double> drawn_values(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  std::vector<double> drawn;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // A pair of rows represents all rows between them; a row followed by the next row represents itself.
    const bool pair = i + 1 < rows.size() && rows[i + 1] > rows[i] + 1;
    if (!pair) {
      drawn.push_back(values[rows[i]]);
      continue;
    }
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(rows[i]);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(rows[i + 1] + 1);
    const auto [low, high] = std::minmax_element(begin, end);
    drawn.push_back(low < high ? *low : *high);
    drawn.push_back(low < high ? *high : *low);
    ++i;
  }
  return drawn;
}

namespace {

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

constexpr const char* kColours[kSeriesColours] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#000000", "#999999"};

constexpr std::size_t kBlack = 7;  // line type

constexpr std::size_t kBlockCurves = 13;  // per data block: `using` takes 14 columns, and the first is the time

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

// From the uppermost band to the lowest, so that each is painted over those above it.
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
    const std::string& colour = figure.curves[i].colour;
    const std::size_t style = figure.curves[i].title == "total" ? kBlack : i + 1;
    text += (i ? ", \\\n     " : "") + curve(figure, i) + " with lines " +
            (colour.empty() ? "lt " + std::to_string(style) : "lw 1.8 lc rgb " + gnuplot_text(colour)) + " title " +
            gnuplot_text(figure.curves[i].title);
  }
  return text;
}

std::string plot_command(const Figure& figure) {
  std::ostringstream text;
  text << "set title " << gnuplot_text(figure.title) << " noenhanced\nset ylabel " << gnuplot_text(figure.axis)
       << " noenhanced\n";
  text << (figure.curves.size() == 1 ? "unset key\n" : "set key outside right center samplen 1.5 noenhanced\n");
  const bool fixed = figure.high > figure.low;
  if (figure.stacked) text << "set yrange [0:]\n";
  if (fixed) text << "set yrange [" << figure.low << ":" << figure.high << "]\n";
  text << "plot " << (figure.stacked ? bands(figure) : lines(figure)) << "\n";
  if (figure.stacked || fixed) text << "set yrange [*:*]\n";
  return text.str();
}

}  // namespace

std::string series_colour(int series) { return kColours[series % kSeriesColours]; }

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
      figure.curves[i].formula = {{{1.0, drawn.names.back()}}, 0.0, 1.0};
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

std::string write_page_script(const std::string& folder, const PlotPage& page) {
  make_folder(folder);
  const int count = static_cast<int>(page.figures.size()), rows = (count + page.columns - 1) / page.columns;
  // Equal margins align the panels, whatever their legends.
  std::size_t longest = 0;
  for (const Figure& figure : page.figures)
    for (const Curve& curve : figure.curves)
      if (figure.curves.size() > 1) longest = std::max(longest, curve.title.size());
  std::string drawing = "set lmargin 11\nset rmargin " + std::to_string(longest > 0 ? longest + 7 : 3) + "\n";
  for (const Figure& figure : page.figures) drawing += plot_command(figure);
  if (count > 1)
    drawing = "set multiplot layout " + std::to_string(rows) + "," + std::to_string(page.columns) + " title " +
              gnuplot_text(page.title) + " noenhanced\n" + drawing + "unset multiplot\n";
  return write_drawing(folder, page.name, {page.width, page.height}, kStyle + data_blocks(page.figures), drawing);
}

std::string write_surface_script(const std::string& folder, const SurfacePicture& picture) {
  FOOTFALL_DEMAND(picture.z.rows() == picture.x.size() && picture.z.cols() == picture.y.size());
  make_folder(folder);
  const std::filesystem::path base = std::filesystem::path(folder) / picture.name;

  std::ostringstream data;
  data << "# " << picture.x_axis << ", " << picture.y_axis << ", " << picture.z_axis << "\n";
  for (Eigen::Index i = 0; i < picture.x.size(); ++i) {
    for (Eigen::Index j = 0; j < picture.y.size(); ++j)
      data << picture.x[i] << ' ' << picture.y[j] << ' ' << picture.z(i, j) << '\n';
    data << '\n';
  }
  write_whole_file(base.string() + ".dat", data.str());
  const std::string setup =
      "set encoding utf8\nunset key\nset hidden3d\nset pm3d depthorder border lc rgb \"#404040\" lw 0.3\n"
      "set view 60, 230\nset ticslevel 0\n"
      "set palette defined (0 \"#2c4c8c\", 0.5 \"#7fc8b0\", 1 \"#f4e04d\")\nset zrange [0:1]\nset cbrange [0:1]\n";
  return write_drawing(folder, picture.name, {900, 680}, setup,
                       "set title " + gnuplot_text(picture.title) + " noenhanced\nset xlabel " +
                           gnuplot_text(picture.x_axis) + " noenhanced\nset ylabel " + gnuplot_text(picture.y_axis) +
                           " noenhanced\nset zlabel " + gnuplot_text(picture.z_axis) + " noenhanced rotate\nsplot " +
                           gnuplot_text(picture.name + ".dat") + " with pm3d\n");
}

}  // namespace footfall

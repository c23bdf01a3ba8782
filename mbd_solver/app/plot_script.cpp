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
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/launch/program_watch.h"

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

namespace {

struct Paper {
  const char *ground, *ink, *grid;
  const char* colours[kSeriesColours];
};
constexpr Paper kLightPaper = {"#ffffff",
                               "#404040",
                               "#e0e0e0",
                               {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#7b3fa0",
                                "#8c510a", "#4d7c0f", "#be123c", "#808080", "#3b3bc4", "#0f766e"}};
constexpr Paper kDarkPaper = {"#14181f",
                              "#c9d1d9",
                              "#2d333b",
                              {"#4aa8e0", "#ff8c42", "#2fd0a0", "#f0a6cf", "#ffc24d", "#9ddcff", "#ffffff", "#c59bf0",
                               "#d9a066", "#a3d65c", "#ff7b93", "#a8a8a8", "#9a9cff", "#5fd3c6"}};

const Paper& paper_of(PlotStyle style) { return style == PlotStyle::kDark ? kDarkPaper : kLightPaper; }

// Lines of one width; of the second half dashed. On print each has a dash of its own.
std::string line_types(PlotStyle style) {
  const Paper& paper = paper_of(style);
  std::ostringstream text;
  for (int k = 0; k < kSeriesColours; ++k) {
    const int dash = style == PlotStyle::kPrint ? 1 + k % 5 : k < 7 ? 1 : 2;
    text << "set linetype " << k + 1 << " lw " << (style == PlotStyle::kPrint ? 1.4 : 1.8) << " dt " << dash
         << " lc rgb \"" << paper.colours[k] << "\"\n";
  }
  text << "set linetype cycle " << kSeriesColours << "\n";
  return text.str();
}

}  // namespace

std::string csv_setup() {
  return "set datafile separator ','\nset datafile columnheaders\nset encoding utf8\n" + line_types(PlotStyle::kLight);
}

std::string series_colour(int series, PlotStyle style) { return paper_of(style).colours[series % kSeriesColours]; }

std::string write_drawing(const std::string& folder, const std::string& name, const PictureSize& size,
                          const std::string& setup, const std::string& drawing, PlotStyle style, bool pdf) {
  const std::string pixels =
      " size " + std::to_string(size.width) + "," + std::to_string(size.height) + " font \"DejaVu Sans,11\"";
  const std::string ground = std::string(" background rgb \"") + paper_of(style).ground + "\"";
  constexpr double kPageWidth = 17.0;  // within the margins of A4 [cm]
  const double height = kPageWidth * size.height / size.width;
  const std::string page = " size " + number_text(kPageWidth, 4) + "cm," + number_text(height, 4) +
                           "cm font \"DejaVu Sans," + (size.width > 1200 ? "6" : "8") + "\"";
  const auto on = [&](const std::string& terminal, const std::string& file) {
    return "set terminal " + terminal + "\nset output " + gnuplot_text(file) + "\n" + drawing;
  };
  const std::string script = name + ".gp";
  write_whole_file((fs::path(folder) / script).string(),
                   "# gnuplot " + gnuplot_text(script) + " draws a PNG and an SVG" + (pdf ? ", and a PDF" : "") + "\n" +
                       setup + on("pngcairo" + pixels + ground, name + ".png") +
                       on("svg" + pixels + ground, name + ".svg") +
                       (pdf ? on("pdfcairo" + page + ground, name + ".pdf") : ""));
  return script;
}

std::vector<std::string> run_gnuplot(const std::string& folder, const std::vector<std::string>& scripts) {
  std::vector<std::string> pictures;
  if (scripts.empty()) return pictures;
  for (const std::string& script : scripts)  // gnuplot would write through a link
    for (const char* ending : {".png", ".svg", ".pdf"})
      GuardedPath((fs::path(folder) / fs::path(script).replace_extension(ending)).string()).remove();
  const std::string log = "gnuplot.log";
  Command command{Rights::writing({program_in_path("gnuplot")}, {folder}), {"gnuplot"}, {}, log, folder};
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

int series_of(const Figure& figure, std::size_t i) {
  constexpr int kBlack = 6;
  const Curve& drawn = figure.curves[i];
  return drawn.series >= 0 ? drawn.series : drawn.title == "total" ? kBlack : static_cast<int>(i);
}

namespace {

std::string style_of(PlotStyle style) {
  const Paper& paper = paper_of(style);
  const std::string ink = std::string("rgb \"") + paper.ink + "\"", grid = std::string("rgb \"") + paper.grid + "\"";
  return "set datafile separator \",\"\nset datafile columnheaders\nset encoding utf8\nset border 3 lw 1 lc " + ink +
         "\nset tics nomirror out tc " + ink + "\nset grid lw 1 lc " + grid + "\nset title tc " + ink +
         "\nset xlabel offset 0,0.4 tc " + ink + "\nset ylabel tc " + ink + "\nset key tc " + ink + "\n" +
         line_types(style);
}

constexpr std::size_t kBlockCurves = 13;  // per data block: `using` takes 14 columns, and the first is the time

std::string block_name(const Figure& figure, std::size_t curve) {
  return "$" + figure.name + "_" + std::to_string(curve / kBlockCurves);
}

std::string band_name(const Figure& figure, std::size_t curve) {
  return "$" + figure.name + "_band_" + std::to_string(curve);
}

std::string data_blocks(const std::vector<Figure>& figures) {
  std::ostringstream text;
  for (const Figure& figure : figures) {
    for (std::size_t i = 0; i < figure.curves.size(); ++i) {
      if (figure.curves[i].band.empty()) continue;
      text << "set table " << band_name(figure, i) << " separator tab\nplot " << gnuplot_text(figure.file)
           << " using (column(" << gnuplot_text(figure.x) << "))";
      for (const Formula& edge : figure.curves[i].band) text << ":" << edge.gnuplot();
      text << " with table\nunset table\n";
    }
    for (std::size_t i = 0; i < figure.curves.size(); ++i) {
      if (i % kBlockCurves == 0)
        text << "set table " << block_name(figure, i) << " separator tab\nplot " << gnuplot_text(figure.file)
             << " using (column(" << gnuplot_text(figure.x) << "))";
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

// Equal margins align the panels; legends stand below them.
constexpr const char* kAligned = "set lmargin 11\nset rmargin 3\n";

std::string colour_of(const Figure& figure, std::size_t i) {
  const std::string& colour = figure.curves[i].colour;
  return colour.empty() ? "lt " + std::to_string(series_of(figure, i) % kSeriesColours + 1)
                        : "lc rgb " + gnuplot_text(colour);
}

// Bands first. Later curves are thinner, so that equal ones are seen on each other.
std::string lines(const Figure& figure) {
  std::string text;
  const std::size_t count = figure.curves.size();
  for (std::size_t i = 0; i < count; ++i)
    if (!figure.curves[i].band.empty())
      text += band_name(figure, i) + " using 1:2:3 with filledcurves " + colour_of(figure, i) +
              " fs transparent solid 0.22 noborder notitle, \\\n     ";
  for (std::size_t i = 0; i < count; ++i) {
    const double width = count == 1 ? 1.8 : 3.0 - 1.8 * static_cast<double>(i) / static_cast<double>(count - 1);
    text += (i ? ", \\\n     " : "") + curve(figure, i) + " with lines " + colour_of(figure, i) +
            (figure.curves[i].dashed ? " dt 2" : "") + " lw " + number_text(width, 3) + " title " +
            gnuplot_text(figure.curves[i].title);
  }
  return text;
}

// Vertical lines with their word at the top, horizontal ones with their word above them, points with theirs next to them.
std::string marks(const Figure& figure, PlotStyle style) {
  const std::string ink = std::string(" tc rgb \"") + paper_of(style).ink + "\"",
                    red = style == PlotStyle::kDark ? "#ff6b6b" : "#b91c1c";
  std::ostringstream text;
  text.precision(9);
  for (const Mark& mark : figure.times)
    text << "set arrow from first " << mark.time << ", graph 0 to first " << mark.time
         << ", graph 1 nohead lw 1 dt 3 lc rgb \"" << paper_of(style).ink << "\"\nset label " << gnuplot_text(mark.text)
         << " at first " << mark.time << ", graph 1.04 left noenhanced font \",9\"" << ink << "\n";
  for (const Mark& mark : figure.limits)
    text << "set arrow from graph 0, first " << mark.value << " to graph 1, first " << mark.value
         << " nohead lw 1.2 dt 2 lc rgb \"" << red << "\"\nset label " << gnuplot_text(mark.text)
         << " at graph 0.99, first " << mark.value << " right offset 0,0.5 noenhanced font \",9\" tc rgb \"" << red
         << "\"\n";
  for (const Mark& mark : figure.peaks) {
    text << "set label \"\" at first " << mark.time << ", first " << mark.value << " point pt 7 ps 0.6 lc rgb \""
         << paper_of(style).ink << "\"\nset label " << gnuplot_text(mark.text);
    if (mark.text_at)
      text << " at first " << mark.text_at->first << ", first " << mark.text_at->second << " center";
    else
      text << " at graph 1, graph 1.04 right";
    text << " noenhanced font \",9\"" << ink << "\n";
  }
  return text.str();
}

std::string plot_command(const Figure& figure, PlotStyle style) {
  std::ostringstream text;
  text << "set title " << gnuplot_text(figure.title) << " noenhanced\nset xlabel " << gnuplot_text(figure.x_axis)
       << " noenhanced\nset ylabel " << gnuplot_text(figure.axis) << " noenhanced\n";
  text << (figure.curves.size() == 1 ? "unset key\n" : "set key below samplen 1.5 noenhanced\n");
  if (figure.logarithmic) text << "set logscale xy\nset format xy \"%g\"\nset grid mxtics mytics\n";
  const bool fixed = figure.high > figure.low;
  if (figure.stacked) text << "set yrange [0:]\n";
  if (fixed) text << "set yrange [" << figure.low << ":" << figure.high << "]\n";
  text << "unset arrow\nunset label\n" << marks(figure, style);
  text << "plot " << (figure.stacked ? bands(figure) : lines(figure)) << "\n";
  if (figure.stacked || fixed) text << "set yrange [*:*]\n";
  if (figure.logarithmic) text << "unset logscale\nset format\nset grid nomxtics nomytics\n";
  return text.str();
}

// Panels in rows below a title.
std::string on_one_page(const std::string& title, int rows, int columns, PlotStyle style, const std::string& panels) {
  return "set multiplot layout " + std::to_string(rows) + "," + std::to_string(columns) + " title " +
         gnuplot_text(title) + " noenhanced tc rgb " + gnuplot_text(paper_of(style).ink) + "\n" + kAligned + panels +
         "unset multiplot\n";
}

constexpr std::size_t kDrawnSpans = 2000;  // more than a picture has pixels

}  // namespace

bool is_long(const History& history) { return history.column("time").size() > 2 * kDrawnSpans; }

void thin_figures(std::vector<Figure>& figures, const History& history, const std::string& folder,
                  const std::string& table) {
  make_folder(folder);
  const std::vector<double>& time = history.column("time");
  const std::vector<std::size_t> rows = rows_to_draw(time, kDrawnSpans);
  History drawn{{"time"}, {"s"}, {{}}};
  for (const std::size_t row : rows) drawn.columns.front().push_back(time[row]);
  for (Figure& figure : figures) {
    const auto draw = [&](Formula& formula, const std::string& name) {
      drawn.columns.push_back(drawn_values(formula.values(history), rows));
      drawn.names.push_back(figure.name + "." + name);
      drawn.units.push_back(figure.axis);
      formula = {{{1.0, drawn.names.back()}}, 0.0, 1.0};
    };
    for (std::size_t i = 0; i < figure.curves.size(); ++i) {
      draw(figure.curves[i].formula, std::to_string(i + 1));
      for (std::size_t edge = 0; edge < figure.curves[i].band.size(); ++edge)
        draw(figure.curves[i].band[edge], std::to_string(i + 1) + (edge == 0 ? ".low" : ".high"));
    }
    figure.file = table + ".csv";
  }
  write_history((std::filesystem::path(folder) / (table + ".csv")).string(), drawn);
}

std::vector<std::string> write_plot_scripts(const std::string& folder, const std::vector<Figure>& figures,
                                            const std::string& title, PlotStyle style) {
  make_folder(folder);
  std::vector<std::string> names;
  std::string page;
  for (const Figure& figure : figures) {
    names.push_back(write_drawing(folder, figure.name, {900, 520}, style_of(style) + data_blocks({figure}),
                                  plot_command(figure, style), style));
    page += plot_command(figure, style);
  }
  if (figures.empty()) return names;
  const int columns = 2, rows = (static_cast<int>(figures.size()) + columns - 1) / columns;
  constexpr int kPageHeight = 2121;  // of A4 on a width of 1500
  const int height = std::min(380 * rows, std::max(kPageHeight, 240 * rows));
  names.push_back(write_drawing(folder, "overview", {1500, height}, style_of(style) + data_blocks(figures),
                                on_one_page(title, rows, columns, style, page), style, true));
  return names;
}

std::string write_page_script(const std::string& folder, const PlotPage& page) {
  make_folder(folder);
  const int count = static_cast<int>(page.figures.size()), rows = (count + page.columns - 1) / page.columns;
  std::string panels;
  for (const Figure& figure : page.figures) panels += plot_command(figure, page.style);
  return write_drawing(folder, page.name, {page.width, page.height}, style_of(page.style) + data_blocks(page.figures),
                       count > 1 ? on_one_page(page.title, rows, page.columns, page.style, panels) : kAligned + panels,
                       page.style, page.pdf);
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

#pragma once
// Scripts for gnuplot, and running it: curves over time and surfaces. Each script is stored in DIR/plots, reads ../history.csv
// or ../ledger.csv, and draws itself as PNG and SVG; users can edit and rerun it.

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

// What a curve shows: factor (constant + sum of c_i column_i), or factor times the norm of the columns.
struct Formula {
  std::vector<std::pair<double, std::string>> columns;  // c_i and the column's name
  double constant = 0.0;
  double factor = 1.0;
  bool is_norm = false;

  std::string gnuplot() const;                               // as gnuplot computes it, in parentheses
  std::vector<double> values(const History& history) const;  // one per row; throws InputError for an unknown column
};

// Beginning of a script that draws columns of CSV files by their names, with fourteen line types that differ.
std::string csv_setup();

// Colours and lines of a picture: light and dark for screens, print for pages of A4: without colour the lines differ as well.
enum class PlotStyle { kLight, kDark, kPrint };
constexpr std::string_view name_of(PlotStyle style) { return name_in(style, "light", "dark", "print"); }

struct PictureSize {
  int width, height;  // [pixels]
};

// Writes NAME.gp into `folder`, which draws NAME.png and NAME.svg, and NAME.pdf if wanted: `setup` once, then `drawing` for
// each. Returns NAME.gp.
std::string write_drawing(const std::string& folder, const std::string& name, const PictureSize& size,
                          const std::string& setup, const std::string& drawing, PlotStyle style = PlotStyle::kLight,
                          bool pdf = false);

// Runs the scripts in `folder`; returns the pictures NAME.png. Throws InputError when gnuplot is missing or fails.
std::vector<std::string> run_gnuplot(const std::string& folder, const std::vector<std::string>& scripts);

// Long histories reduced to the resolution of a picture: the lowest and the highest value of every span of time that is
// narrower than a pixel, so that no peak is lost. The rows for the time axis: first and last of every span; all rows when
// there are few.
std::vector<std::size_t> rows_to_draw(const std::vector<double>& time, std::size_t spans);

// Values for these rows: the lowest and the highest of each span, in the order of time.
std::vector<double> drawn_values(const std::vector<double>& values, const std::vector<std::size_t>& rows);

// Seven colours that can be distinguished with any colour vision (Okabe and Ito 2008, without yellow), then seven others for
// dashed lines.
inline constexpr int kSeriesColours = 14;
std::string series_colour(int series, PlotStyle style = PlotStyle::kLight);  // #rrggbb, of 0 ... kSeriesColours - 1

struct Curve {
  std::string title;
  Formula formula;
  std::string colour = "";         // #rrggbb; empty: the colour of the series
  int series = -1;                 // 0 ... kSeriesColours - 1; -1: its place among the curves
  bool dashed = false;             // of a second run
  std::vector<Formula> band = {};  // lower and upper edge of a band behind the curve; empty: none
};

// A value at a time, as "touchdown" or the peak of a curve.
struct Mark {
  double time = 0.0;   // [s]
  double value = 0.0;  // in the unit of the axis
  std::string text;
  // Middle of the text of a peak, in the units of time and value, where no curve passes; none: above the graph, on the right.
  std::optional<std::pair<double, double>> text_at = {};
};
// What a text of so many letters takes at most, of the width and height of a graph, also on a page of many.
constexpr double text_width(std::size_t letters) { return 0.024 * static_cast<double>(letters); }
inline constexpr double kTextHeight = 0.14;

struct Figure {
  std::string name;  // file name without ending
  std::string title;
  std::string axis;  // label of the vertical axis, with unit
  std::vector<Curve> curves;
  std::string file = "../history.csv";  // from the script's folder
  bool stacked = false;                 // each curve is the upper edge of a band, the one before its lower edge
  double low = 0.0, high = 0.0;         // range of the vertical axis; equal: from the data
  std::vector<Mark> times = {};         // vertical lines; their values do not count
  std::vector<Mark> peaks = {};         // points
  std::vector<Mark> limits = {};        // horizontal lines; their times do not count
  std::string x = "time", x_axis = "time [s]";
  bool logarithmic = false;  // both axes
};

// The colour of a curve: its own, black for a total, or its place.
int series_of(const Figure& figure, std::size_t curve);

// Writes the curves of all figures, with no more rows than pictures can show, to one file TABLE.csv in `folder`, which the
// figures then draw: gnuplot reads it much faster than a history with all its columns.
void thin_figures(std::vector<Figure>& figures, const History& history, const std::string& folder,
                  const std::string& table);
bool is_long(const History& history);  // has more rows than pictures can show

// One script per figure and `overview.gp` with all of them on one page, in `folder`. Returns their file names. Throws
// InputError when the folder cannot be written.
std::vector<std::string> write_plot_scripts(const std::string& folder, const std::vector<Figure>& figures,
                                            const std::string& title, PlotStyle style = PlotStyle::kLight);

// Several figures on one page, NAME.gp in `folder`; returns its file name. Throws as write_plot_scripts.
struct PlotPage {
  std::string name, title;
  std::vector<Figure> figures;
  int columns = 1;
  int width = 900, height = 520;  // of the page [pixels]
  PlotStyle style = PlotStyle::kLight;
  bool pdf = false;
};
std::string write_page_script(const std::string& folder, const PlotPage& page);

// A surface z(x, y), as the control surfaces in [Lin25 Figure 4].
struct SurfacePicture {
  std::string name;  // file name without ending
  std::string title;
  std::string x_axis, y_axis, z_axis;
  Eigen::VectorXd x, y;
  Eigen::MatrixXd z;  // x by y
};

// NAME.dat and NAME.gp in `folder`; the script draws NAME.png and NAME.svg. Returns the script's file name. Throws
// InputError when the folder cannot be written.
std::string write_surface_script(const std::string& folder, const SurfacePicture& picture);

}  // namespace footfall

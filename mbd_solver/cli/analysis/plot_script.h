#pragma once
// gnuplot scripts of figures. Each script stands in DIR/plots, reads ../history.csv or ../ledger.csv and draws itself as
// PNG and SVG; a user can edit and rerun it.

#include <string>
#include <vector>

#include "mbd_solver/cli/analysis/formula.h"
#include "mbd_solver/output/history.h"

namespace footfall {

// Eight colours that people with any colour vision can tell apart (Okabe and Ito 2008, grey in place of yellow).
inline constexpr int kSeriesColours = 8;
std::string series_colour(int series);  // #rrggbb, of 0 ... kSeriesColours - 1

struct Curve {
  std::string title;
  Formula formula;
  std::string colour = "";  // #rrggbb; empty: the next of the cycle
};

struct Figure {
  std::string name;  // file name without ending
  std::string title;
  std::string axis;  // label of the vertical axis, with unit
  std::vector<Curve> curves;
  std::string file = "../history.csv";  // from the script's folder
  bool stacked = false;          // each curve is the upper edge of a band, which the one before bounds from below
  double low = 0.0, high = 0.0;  // of the vertical axis; equal: as the data say
};

// Figures of a history with more rows than a picture can show draw NAME.csv in `folder` instead, which this writes: the
// lowest and the highest value of each span of time. gnuplot needs minutes for long ones.
void reduce_long_figures(std::vector<Figure>& figures, const History& history, const std::string& folder);

// One script per figure and `overview.gp` with all of them on one page, in `folder`. Returns their file names. Throws
// InputError when the folder cannot be written.
std::vector<std::string> write_plot_scripts(const std::string& folder, const std::vector<Figure>& figures,
                                            const std::string& title);

// Several figures on one page, NAME.gp in `folder`; returns its file name. Throws as write_plot_scripts.
struct PlotPage {
  std::string name, title;
  std::vector<Figure> figures;
  int columns = 1;
  int width = 900, height = 520;  // of the page [pixels]
};
std::string write_page_script(const std::string& folder, const PlotPage& page);

}  // namespace footfall

#pragma once
// gnuplot scripts for the pictures of a run, as [Lin25 Figure 11]: acceleration, velocity, descent, mechanical energy
// and its parts, strut strokes, contact forces. Each script stands in DIR/plots, reads ../history.csv or ../ledger.csv
// and draws itself as PNG and SVG; a user can edit and rerun it.

#include <string>
#include <vector>

#include "mbd_solver/cli/analysis/formula.h"
#include "mbd_solver/output/history.h"

namespace footfall {

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
  bool stacked = false;  // each curve is the upper edge of a band, which the one before bounds from below
};

// The figures that a history with these columns can show. `observed`: the body whose motion is drawn; empty: the first
// with an acceleration.
std::vector<Figure> standard_figures(const History& history, const std::string& observed);

// Where the energy is, as bands whose sum is constant; parts too small to be seen are left out. `ledger`: as
// energy_ledger makes it.
Figure ledger_figure(const History& ledger);

// Figures of a history with more rows than a picture can show draw NAME.csv in `folder` instead, which this writes: the
// lowest and the highest value of each span of time. gnuplot needs minutes for long ones.
void reduce_long_figures(std::vector<Figure>& figures, const History& history, const std::string& folder);

// One script per figure and `overview.gp` with all of them on one page, in `folder`. Returns their file names. Throws
// InputError when the folder cannot be written.
std::vector<std::string> write_plot_scripts(const std::string& folder, const std::vector<Figure>& figures,
                                            const std::string& title);

}  // namespace footfall

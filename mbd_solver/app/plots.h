#pragma once
// Plots of a history: the standard ones of every run, as in [Lin25 Figure 11] (acceleration, velocity, descent, mechanical
// energy and its parts, strut strokes, contact forces), and any columns for `footfall plot`.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

// The standard figures for the columns of this history, none with more curves than there are colours. `observed`: the
// monitored body; empty: the first one with an acceleration.
std::vector<Figure> standard_figures(const History& history, const std::string& observed);

// Marks touchdown, the peak of each figure, and limits near the curves: requirements of one column, and stops of struts. summary:
// of the run; may be empty.
void mark_figures(const History& history, const nlohmann::ordered_json& summary, std::vector<Figure>& figures);

// The history has contact forces of bodies, and all are zero.
bool touches_nothing(const History& history);

// The energy balance by part, as bands whose sum is constant; parts too small to be seen are left out. `ledger`: as
// energy_ledger returns it.
Figure ledger_figure(const History& ledger);

// The columns that words of a user name. Each word is
//   a column            cabin.az
//   a pattern           leg_*_primary.stroke      * and ? match characters between two dots
//   all of a kind       struts.*.force            bodies, joints, struts, springs, drives, controllers of the scene
//   a vector            cabin.v                   its columns with x, y, z appended; cabin: the position
// `scene`: of summary.json, with the names of each kind; may be empty. Returns every column once, in the order of the words.
// Throws InputError for a word that matches no column.
std::vector<std::string> chosen_columns(const History& history, const nlohmann::ordered_json& scene,
                                        const std::vector<std::string>& words);

// One unit and at most fourteen series per panel. More than eight series of one unit become small multiples with one scale: by
// the first number in their names (leg_1, leg_2, ...), with the same colour for the same rest of the name; otherwise fourteen
// per panel. Units are chosen by size (kN ... GPa, mm, µJ). The panels read ../history.csv.
struct Panels {
  std::vector<Figure> figures;
  bool multiples = false;  // some of them are small multiples
};
Panels panels_of(const History& history, const std::vector<std::string>& columns);

// The unit in which values up to `largest` are drawn: factor and name, as 1e-3 and "kN".
struct DrawnUnit {
  double factor = 1.0;
  std::string name;
};
DrawnUnit drawn_unit(const std::string& unit, double largest);

struct ColumnPlot {
  std::string run;                   // folder of a run, or of a sweep, whose samples become mean and band
  std::string other;                 // of a second one, over the first; empty: none
  std::vector<std::string> columns;  // words for chosen_columns; none: list the columns
  std::string out;                   // .png, .svg or .pdf; empty: the first two, in DIR/plots, named by the words
  std::string title;                 // empty: the scene's title
  double srs = 0.0;                  // quality Q: shock response spectra instead; 0: none
  double psd = -1.0;                 // window [s]: power densities instead; 0: an eighth of the run; below: none
  int cfc = 0;                       // channel frequency class: filtered columns as well; 0: none
  PlotStyle style = PlotStyle::kLight;
};

// footfall plot: draws columns and returns the pictures, or without columns the names of all. Throws InputError when the
// folder has no history, a word matches no column, or gnuplot fails.
std::vector<std::string> plot_columns(const ColumnPlot& plot);

}  // namespace footfall

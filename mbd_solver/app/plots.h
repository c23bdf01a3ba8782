#pragma once
// The pictures of a run, as [Lin25 Figure 11]: acceleration, velocity, descent, mechanical energy and its parts, strut
// strokes, contact forces.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/run/output/history.h"

namespace footfall {

// The figures that a history with these columns can show, none with more curves than there are colours. `observed`: the body whose motion is drawn; empty: the first
// with an acceleration.
std::vector<Figure> standard_figures(const History& history, const std::string& observed);

// Where the energy is, as bands whose sum is constant; parts too small to be seen are left out. `ledger`: as
// energy_ledger makes it.
Figure ledger_figure(const History& ledger);

// Which columns of a history are meant by the words of a user, and how they share a picture.

// Each word is
//   a column            cabin.az
//   a pattern           leg_*_primary.stroke      * and ? stand for letters between two dots
//   one of a kind       struts.*.force            of bodies, joints, struts, springs, drives, controllers of the scene
//   a vector            cabin.v                   all columns that end with x, y, z behind it; cabin: its place
// `scene`: of summary.json, with the names of each kind; may be empty. Every column once, in the order of the words.
// Throws InputError for a word that means no column, with what may have been meant.
std::vector<std::string> chosen_columns(const History& history, const nlohmann::ordered_json& scene,
                                        const std::vector<std::string>& words);

// One colour per series, one unit and at most eight series per panel. More than eight of one unit become small multiples
// with one scale: by the first number in their names (leg_1, leg_2, ...), where what is alike has one colour, else eight
// by eight. Forces, torques, energies, powers and stresses are drawn in kN ... GPa when they are large, lengths in mm
// when they are small. The panels read ../history.csv.
struct Panels {
  std::vector<Figure> figures;
  bool multiples = false;  // some of them are small multiples
};
Panels panels_of(const History& history, const std::vector<std::string>& columns);

// What a unit is drawn in when its largest value is this: factor and name, as 1e-3 and "kN".
struct DrawnUnit {
  double factor = 1.0;
  std::string name;
};
DrawnUnit drawn_unit(const std::string& unit, double largest);

// footfall plot: columns of a run's history as a picture.

struct ColumnPlot {
  std::string run;                   // folder of a run
  std::vector<std::string> columns;  // words for columns (column_choice.h); none: list the columns
  std::string out;                   // .png or .svg; empty: both, in RUN/plots, named by the words
  std::string title;                 // empty: that of the scene
};

// Draws them and returns what to tell the user: the pictures made, or the columns that there are. Throws InputError when
// the folder holds no history, a word means no column, or gnuplot fails.
std::vector<std::string> plot_columns(const ColumnPlot& plot);

}  // namespace footfall

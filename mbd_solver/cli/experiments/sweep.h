#pragma once
// A sweep as its file says it, and the runs it stands for.
//
//   title = "..."                      scene = "../landing_mr/scene.toml" (relative to the file)
//   settings = ["key=value", ...]      for every run            until = 0.5 [s]; 0 or left out: the scene's end time
//   [[parameters]]                     every combination of their values is one run; the last one turns fastest
//     name, settings with {value}, values = [...]
//     or [[parameters.choices]]        name, settings, scene: for values that need more than one number, or a scene of
//     their own ensemble = true                  its runs are one case: figures become mean and spread (seeds of the
//     bed)
//   [[figures]]                        columns of the table
//     name, key = "peak_acceleration_g" (of summary.json)
//     or columns = ["cabin.vz"] (of history.csv), reduce = "max" | "min" | "final" | "largest" (absolute) | "drop"
//     (first minus least)
//        | "variation" (sum of all steps) | "peaks" (maxima that stand out by `prominence`, 0.3 of the largest value
//        unless given)
//     average = true                   the mean of the columns; without it the largest of them (of "min" the least, of
//     "final" the last) over = "reference_energy_J"      divided by this key of summary.json
//   [[limits]] figure, most            cases beyond are out of the ranking
//   minimise = "figure"                ranks the cases that are left
//   [[plots]] name, title, column, label   of history.csv over time, one curve per case
//   [[printed]] name, values           figures that somebody else has published, in the order of [[figures]]: rows
//   beside ours [[statements]]                     what should come out: statements.csv and .md say whether it did,
//   with the numbers
//     text, figure, case; least, most  bounds of the figure of that case (its mean), or of its ratio to that of the
//     case `against` why                              told where it did not come out: the tested explanation
//   [[fits]]                           a power law through all runs (sweep_fit.h)

#include <limits>
#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/sweep_figure.h"
#include "mbd_solver/cli/experiments/sweep_fit_spec.h"

namespace footfall {

struct SweepChoice {
  std::string name;
  std::string scene;  // instead of the sweep's; empty: that one
  std::vector<std::string> settings;
};

struct SweepParameter {
  std::string name;
  std::vector<SweepChoice> choices;
  bool ensemble = false;
};

struct SweepLimit {
  std::string figure;
  double most = 0.0;
};

struct SweepPlot {
  std::string name, title, column, label;
};

struct SweepPrinted {
  std::string name;
  std::vector<double> values;  // as SweepSpec::figures; NaN: not printed
};

struct SweepStatement {
  std::string text, figure, of_case, against, why;  // against empty: the figure itself
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
};

struct SweepSpec {
  std::string file;
  std::string title, scene;
  std::vector<std::string> settings;
  double until = 0.0;  // [s]
  std::vector<SweepParameter> parameters;
  std::vector<SweepFigure> figures;
  std::vector<SweepLimit> limits;
  std::string minimise;
  std::vector<SweepPlot> plots;
  std::vector<SweepPrinted> printed;
  std::vector<SweepStatement> statements;
  std::vector<SweepFit> fits;
};

// Throws InputError "file:line: key: what is wrong, what was expected".
SweepSpec read_sweep(const std::string& file);

struct SweepRun {
  std::string name;                 // of its folder: the values, joined
  std::vector<std::string> values;  // names of the choices, one per parameter
  std::string scene;
  std::string group;                  // the values without those of ensembles
  std::vector<std::string> settings;  // of the sweep and of the choices
};
// In the order of their numbers.
std::vector<SweepRun> runs_of(const SweepSpec& sweep);

}  // namespace footfall

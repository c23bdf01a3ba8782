#pragma once
// A power law that is fitted to the runs of an experiment: figure = A factor_1^p_1 factor_2^p_2 ...
//
//   [[fits]]
//     name                   of its picture
//     figure                 what is fitted: one of [[figures]]
//     label                  how the law writes it (default: the figure's name)
//     marks                  a parameter whose values get symbols of their own in the picture (default: all alike)
//     where                  { diameter = 0.24 }: only the runs with these values of parameters (default: all)
//     [[fits.factors]]
//       name                   how the law writes it
//       sum                    ["height", "depth [m]"]: parameters with numbers for values, and figures, that the
//                              factor is the sum of (default: [name])
//       published              { Uehara = 0.5 }: exponents that others found; who gives all of them gets a law with
//                              only A fitted

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/scene/source.h"
#include "mbd_solver/studies/metrics.h"

namespace footfall {

struct FitFactor {
  std::string name;
  std::vector<std::string> sum;
  std::map<std::string, std::string> published;  // exponents, by who found them
  Source source;
};

struct FitSpec {
  std::string name, figure, label, marks;
  std::map<std::string, std::string> where;  // values, by their parameters
  std::vector<FitFactor> factors;
  Source source;
};

// An experiment as its file says it: many runs, numbers out of them, and what should come out. `footfall sweep FILE`
// and `footfall accuracy FILE` read the same files. Whatever is listed here may be left out.
//
//   title, x_name          texts of tables and pictures
//   scene                  file, relative to this one
//   settings               ["key=value", ...] for every run
//   until                  instead of the scene's end time [s]
//   time_limit             a run that takes longer hangs [s]; 0: none
//   repeats                of every run, once with --short; the shortest of the run times counts
//   minimise               a figure: ranks the cases within the limits
//   [short]                what --short changes: until, and settings besides the others
//
// What is run. A case is one value of a curve, or one combination of the values of parameters; every case is run for
// every value of the ensemble.
//
//   [[parameters]]         every combination of their values; the last one turns fastest
//     name, settings         {value} in settings is replaced by each of
//     values
//     choices                instead of values: [[parameters.choices]] name, settings, scene
//     ensemble               true: its values are samples of one case, as seeds are; figures become mean and spread
//     short                  the values of --short (default: the first)
//   [[curves]]             their values one after another; only ensembles go with them
//     name, settings, values, short, scene, until
//     beside                 what {beside} stands for, one per value, where two numbers go together
//     scale                  x = scale value
//     default                the value that the scene has by itself: run times are recommended over its own
//     reference              settings of a reference of its own, besides those of [reference]; {value} is replaced
//     ends                   how the runs must end: a stability map (verdicts.h has the other keys)
//   [reference]            settings, scene: the run that the others are compared with
//   [growth]               omega_h, short, substeps: growth per window instead of all that (window_growth.h)
//
// What is told.
//
//   [[figures]]            columns of the tables: name, and key or columns (figures.h), error (errors.h)
//   [[limits]]             figure, most: cases beyond are out of the ranking
//   [[printed]]            name, values: figures that somebody else has published, in the order of [[figures]];
//                          "" for what is not printed
//   [[statements]]         what somebody says should come out; the tables tell whether it did
//     text, figure, and one of
//     case, least, most      bounds of the figure of that case (its mean), or, with
//     against                of its ratio to that of this case
//     curve, order           [least, most] of the slope of the error over x
//     curve, error           the most of the error at the last value: files name values from coarse to fine
//     why                    told where it did not come out: the tested explanation
//   [[expect]]             the same keys; the exit code is 1 where one does not come out
//   [[plots]]              name, title, column, label: of history.csv over time, one line per case
//   [[fits]]               power laws through all runs (fit_spec.h)

struct ChoiceSpec {
  std::string name, scene;  // scene empty: the experiment's
  std::vector<std::string> settings;
};

struct ParameterSpec {
  std::string name;
  std::vector<std::string> settings, values, short_values;  // as the file gives them
  std::vector<ChoiceSpec> choices, short_choices;           // its choices, or one for each value
  bool ensemble = false;
  Source source;
};

// How runs must end, and what is looked at: see verdicts.h.
struct EndSpec {
  std::vector<std::string> ends;     // one for all, or one per value; empty: not asked
  std::string group;                 // heading in the table
  std::string message;               // regular expression that warnings or the last message must match; empty: any
  std::vector<std::string> columns;  // of history.csv, compared with the reference; empty: judged by energy
  bool at_end = false;               // compare the last row only: where it comes to rest
  double tolerance = 0.02;           // of the reference's swing [-]
  double order_beyond = 0.0;         // from this value on errors grow at most in proportion to the value; 0: not asked
};

struct CurveSpec {
  std::string name, scene;             // scene empty: the experiment's
  std::vector<std::string> settings;   // "{value}" and "{beside}" are replaced
  std::vector<std::string> reference;  // likewise; empty: [reference] alone
  std::vector<std::string> values, beside;
  std::vector<std::string> short_values = {""};  // of the short form; {""}: the first value; empty: none
  std::string default_value;                     // empty: none of the values
  double scale = 1.0;                            // for values that are numbers
  double until = 0.0;                            // [s]; 0: the experiment's
  EndSpec end;
  Source source;
};

struct ReferenceSpec {
  std::string scene;  // empty: the experiment's, or else the curve's
  std::vector<std::string> settings;
};

struct ShortSpec {
  double until = 0.0;  // [s]; 0: that of the whole form
  std::vector<std::string> settings;
};

struct LimitSpec {
  std::string figure;
  double most = 0.0;
  Source source;
};

struct PlotSpec {
  std::string name, title, column, label;
};

struct PrintedSpec {
  std::string name;
  std::vector<std::string> values;  // numbers, as ExperimentSpec::figures; empty: not printed
  Source source;
};

// About a case; with `order` or `error`, about a curve.
struct StatementSpec {
  std::string text, figure, why;
  std::string of_case, against;  // against empty: the figure itself
  std::string curve;
  std::vector<double> order;    // its bounds: empty, or two
  std::optional<double> error;  // its most [-]
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  bool must = false;  // [[expect]]
  Source source;
};

struct GrowthSpec {
  std::vector<double> omega_h, short_omega_h;  // [-]; short_omega_h empty: all
  int substeps = 20;                           // per window
};

struct ExperimentSpec {
  std::string file, folder;  // of the file
  std::string title, scene, x_name = "value", minimise;
  std::vector<std::string> settings;
  double until = 0.0;  // [s]; 0: the scene's end time
  int time_limit = 0;  // [s]; 0: none
  int repeats = 1;
  ShortSpec short_form;
  std::vector<ParameterSpec> parameters;
  std::vector<CurveSpec> curves;
  std::optional<ReferenceSpec> reference;
  std::vector<FigureSpec> figures;
  std::vector<LimitSpec> limits;
  std::vector<PrintedSpec> printed;
  std::vector<StatementSpec> statements, expected;  // those of [[expect]] stand in both
  std::vector<PlotSpec> plots;
  std::vector<FitSpec> fits;
  std::optional<GrowthSpec> growth;
  Source source;

  bool is_map() const { return !curves.empty() && !curves.front().end.ends.empty(); }
};

class FieldVisitor;
void visit_fields(FieldVisitor& v, ExperimentSpec& spec);  // its keys
// Throws InputError "file:line: key: what is wrong, what was expected", all that is wrong at once.
ExperimentSpec read_experiment(const std::string& file);
// JSON schema (draft 2020-12) of these files, from the same description as the reader's.
std::string experiment_schema();

// "{value}" in every text replaced, or another mark.
std::vector<std::string> filled(std::vector<std::string> texts, const std::string& value,
                                const std::string& mark = "{value}");

// Position of the entry with this name; -1 without.
template <class Named>
int index_of(const std::vector<Named>& list, const std::string& name) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].name == name) return static_cast<int>(i);
  return -1;
}

template <class Named>
std::vector<std::string> names_in(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& entry : list) names.push_back(entry.name);
  return names;
}

}  // namespace footfall

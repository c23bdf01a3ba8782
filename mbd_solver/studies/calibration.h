#pragma once
// A calibration as its file says it: parameters with ranges, targets that runs should meet, and how to search. The
// dialect is that of experiments (experiment.h). `footfall calibrate FILE` reads it. What is listed may be left out.
//
//   title
//   scene                  of every entry of [[scenes]] that names none; relative to this file
//   settings               ["key=value", ...] for every run. In all settings {= formula} stands for the value of a
//                          formula of parameters' names: so one parameter moves several keys (tied)
//   until                  instead of the scene's end time [s]
//   time_limit             a run that takes longer has failed [s]; 0: none
//   step                   of finite differences about the best set, as a share of the range (default: 0.05)
//   confidence             of the intervals (default: 0.95)
//   failed                 misfit of a target whose run failed, in tolerances (default: 10)
//   confirm                sets that are run whole, at most (1): after each, the set next to it that should meet more
//                          is run, if there is one (adjustment.h)
//   alone                  sets that are tried for each target that none has met, with no regard to the others (0)
//   cap                    a target that is further off counts as if it were so many tolerances off: where the question
//                          is how many are met together, one that is out of reach shall not lead; 0: none.
//                          The best set is then the one that meets most, by weight
//
//   [[parameters]]
//     name                 letters, digits and _, so that formulas can read it
//     settings             what {value} goes into
//     least, most          range; scale = "logarithmic": moves by factors, least > 0
//     start                (default: the middle of the range)
//     source               where the range comes from: a text of the tables
//   [[scenes]]             what is run for each set of parameters
//     name, scene, settings, until
//   [seeds]                every scene is run with each; figures are means. They are the same for all sets, so that
//     settings, values     the search does not follow noise
//     search               how many of them the search uses (default: 1); the best set is run with all
//   [[stages]]             searches one after another; each starts from the best set of the one before
//     method               direct, crs2, isres (global), bobyqa, sbplx (local), by NLopt; gauss_newton (local);
//                          surrogate (surfaces through all that is known)
//     evaluations          sets of parameters, at most
//     seed                 of crs2, isres and surrogate (default: 1)
//     precision            ends a local search: change of all parameters, as a share of their ranges (default: 1e-4)
//     settings, until      cheaper runs for this stage: small beds, large steps
//   [limits]
//     runs, hours          of the search: all stages together; hours of one core
//   [[figures]]            numbers of a run (experiments/figures.h)
//   [[targets]]
//     name                 (default: the figure and its scene)
//     figure, scene        of that scene's runs (default: the first scene)
//     against              the ratio to the same figure of this scene instead: an ordering
//     value; least, most   what it should be; or the bounds of a band
//     column, file         instead of a figure: a column of history.csv against a CSV file of x and y,
//     over                 where x is this column (default: time). Counted are rows up to its largest value
//     tolerance            one standard deviation
//     weight               (default: 1)
//     source               a text of the tables
//   [[constraints]]        sets that break one are not run
//     name, formula        of parameters' names
//     least, most

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mbd_solver/scene/source.h"
#include "mbd_solver/studies/metrics.h"

namespace footfall {

enum class RangeScale { kLinear, kLogarithmic };
constexpr std::string_view name_of(RangeScale scale) {
  switch (scale) {
    case RangeScale::kLinear: return "linear";
    case RangeScale::kLogarithmic: return "logarithmic";
  }
  return "";
}

enum class SearchMethod { kDirect, kCrs2, kIsres, kBobyqa, kSbplx, kGaussNewton, kSurrogate };
constexpr std::string_view name_of(SearchMethod method) {
  switch (method) {
    case SearchMethod::kDirect: return "direct";             // DIRECT-L: divides the range; no random numbers
    case SearchMethod::kCrs2: return "crs2";                 // controlled random search, with local mutation
    case SearchMethod::kIsres: return "isres";               // evolution strategy
    case SearchMethod::kBobyqa: return "bobyqa";             // quadratic models in a trust region
    case SearchMethod::kSbplx: return "sbplx";               // simplices in subspaces: for noise and kinks
    case SearchMethod::kGaussNewton: return "gauss_newton";  // least squares from differences (gauss_newton.h)
    case SearchMethod::kSurrogate: return "surrogate";       // response surfaces of the targets (surrogate.h)
  }
  return "";
}
constexpr bool goes_one_by_one(SearchMethod method) {
  return method == SearchMethod::kBobyqa || method == SearchMethod::kSbplx ||
         method == SearchMethod::kSurrogate;  // each set waits for the last
}

struct SoughtParameter {
  std::string name, origin;
  std::vector<std::string> settings;
  double least = 0.0, most = 0.0;
  std::optional<double> start;
  RangeScale scale = RangeScale::kLinear;
  Source source;

  double value(double share) const;      // of the range, 0 to 1
  double share(double value) const;      // the inverse
  std::string text(double share) const;  // the value as runs get it: ten digits
};

struct CalibrationScene {
  std::string name, scene;
  std::vector<std::string> settings;
  double until = 0.0;  // [s]; 0: the calibration's
  Source source;
};

struct SeedsSpec {
  std::vector<std::string> settings, values;
  int search = 1;
  Source source;
};

struct StageSpec {
  SearchMethod method = SearchMethod::kDirect;
  int evaluations = 0, seed = 1;
  double precision = 1e-4;
  std::vector<std::string> settings;
  double until = 0.0;  // [s]; 0: not changed
  Source source;
};

struct CalibrationLimits {
  int runs = 0;        // 0: none
  double hours = 0.0;  // 0: none
};

struct TargetSpec {
  std::string name, figure, scene, against, origin;
  std::optional<double> value;
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  std::string column, over = "time", file;
  double tolerance = 0.0, weight = 1.0;
  Source source;

  bool is_curve() const { return !file.empty(); }
  bool is_band() const { return !is_curve() && !value; }
};

struct ConstraintSpec {
  std::string name, formula;
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  Source source;
};

struct CalibrationSpec {
  std::string file, folder;  // of the file
  std::string title, scene;
  std::vector<std::string> settings;
  double until = 0.0;  // [s]; 0: the scene's end time
  int time_limit = 0;  // [s]; 0: none
  double step = 0.05, confidence = 0.95, failed = 10.0, cap = 0.0;
  int confirm = 1, alone = 0;
  std::vector<SoughtParameter> parameters;
  std::vector<CalibrationScene> scenes;
  std::optional<SeedsSpec> seeds;
  std::vector<StageSpec> stages;
  CalibrationLimits limits;
  std::vector<FigureSpec> figures;
  std::vector<TargetSpec> targets;
  std::vector<ConstraintSpec> constraints;
  Source source;
};

class FieldVisitor;
void visit_fields(FieldVisitor& v, CalibrationSpec& spec);  // its keys
// Throws InputError "file:line: key: what is wrong, what was expected", all that is wrong at once.
CalibrationSpec read_calibration(const std::string& file);
// JSON schema (draft 2020-12) of these files.
std::string calibration_schema();

// Shares of the ranges, one per parameter: where a search is.
using Shares = std::vector<double>;
Shares start_of(const CalibrationSpec& spec);

// "{= formula}" in every text replaced by its value with these parameters. Throws InputError.
std::vector<std::string> with_formulas(std::vector<std::string> texts, const CalibrationSpec& spec,
                                       const Shares& shares);
// 0: no constraint is broken; else by how much, relative to the bound.
double broken_by(const CalibrationSpec& spec, const Shares& shares);

}  // namespace footfall

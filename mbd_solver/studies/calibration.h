#pragma once
// A calibration file: parameters with ranges, targets that runs should meet, and how to search. `footfall calibrate` reads
// it; docs/reference/calibration_files.md describes its keys, in the dialect of sweep files.

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/studies/metrics.h"

namespace footfall {

enum class RangeScale { kLinear, kLogarithmic };
constexpr std::string_view name_of(RangeScale scale) { return name_in(scale, "linear", "logarithmic"); }

// A set of parameters as positions in their ranges, 0 to 1.
using UnitPoint = std::vector<double>;

enum class SearchMethod {
  kListed,       // the sets of a file, one after another
  kDirect,       // DIRECT-L of NLopt: divides the range; global
  kSbplx,        // of NLopt: simplices in subspaces; local, for noise and kinks
  kGaussNewton,  // least squares from differences; local
  kSurrogate     // response surfaces of the targets
};
constexpr std::string_view name_of(SearchMethod method) {
  return name_in(method, "listed", "direct", "sbplx", "gauss_newton", "surrogate");
}

// [[parameters]]
struct CalibrationParameter {
  std::string name, origin;           // origin: where the range comes from, for the tables
  std::vector<std::string> settings;  // {value} is replaced
  double least = 0.0, most = 0.0;     // range
  std::optional<double> start;        // none: the middle of the range
  RangeScale scale = RangeScale::kLinear;
  Source source;

  // Between a value and its position u in the range, 0 to 1.
  double value(double u) const;
  double position(double value) const;
  std::string text(double u) const;  // the value as runs and formulas get it: ten digits
};

// [[scenes]]: runs for each set of parameters.
struct CalibrationScene {
  std::string name, scene;
  std::vector<std::string> settings;
  double until = 0.0;  // [s]; 0: the calibration's
  Source source;
};

// [seeds]: every scene is run with each; metrics are means. They are the same for all sets, so that the search does not
// follow noise.
struct SeedsSpec {
  std::vector<std::string> settings, values;
  int search = 1;  // number of seeds in the search; the best set is run with all
  Source source;
};

// [[stages]]: searches one after another; each starts from the best set of the one before.
struct StageSpec {
  SearchMethod method = SearchMethod::kDirect;
  int evaluations = 0;                // sets of parameters, at most
  int seed = 1;                       // of kSurrogate
  std::string file;                   // of kListed: CSV, a column per parameter with its name in the first line
  std::vector<UnitPoint> sets;        // from that file
  double precision = 1e-4;            // ends a local search: change of all parameters, over their ranges [-]
  std::vector<std::string> settings;  // of cheaper runs
  double until = 0.0;                 // [s]; 0: unchanged
  Source source;
};

// [[targets]]
struct TargetSpec {
  std::string name, metric, scene, origin;
  std::string against;          // the metric over the metric of this scene; empty: the metric itself
  bool difference = false;      // the metric minus the metric of `against`, not over it
  std::optional<double> value;  // required value; otherwise the bounds of a band:
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  std::string column, over = "time", file;  // a column over another one, against a CSV file of x and y
  std::vector<Eigen::Vector2d> rows;        // x and y of that file
  double tolerance = 0.0;                   // one standard deviation
  double weight = 1.0;
  Source source;

  bool is_curve() const { return !file.empty(); }
  bool is_band() const { return !is_curve() && !value; }
  bool uses(const std::string& of_scene) const { return of_scene == scene || of_scene == against; }
};

// [[constraints]]: sets that violate one are not run.
struct ConstraintSpec {
  std::string name, formula;  // of parameters' names
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  Source source;
};

struct CalibrationSpec {
  std::string file, folder;  // of the file
  std::string title, scene;
  std::vector<std::string> settings;  // of every run; in all settings the value replaces {= formula of parameters}
  double until = 0.0;                 // [s]; 0: the scene's end time
  int time_limit = 0;                 // of a run, wall-clock [s]; 0: none
  double step = 0.05;                 // of differences about the best set, over the range [-]
  double confidence = 0.95;           // of the intervals
  double failed = 10.0;               // residual of a target whose run failed [tolerances]
  double cap = 0.0;       // largest residual that counts [tolerances]: then the set that meets most is best;
                          // 0: none
  int confirm = 1;        // sets that are run whole, at most: the best, and adjusted ones
  int single_target = 0;  // sets tried for each target that no set meets, without regard to the others
  std::vector<CalibrationParameter> parameters;
  std::vector<CalibrationScene> scenes;
  std::optional<SeedsSpec> seeds;
  std::vector<StageSpec> stages;
  std::vector<MetricSpec> metrics;  // [[figures]]
  std::vector<TargetSpec> targets;
  std::vector<ConstraintSpec> constraints;
  Source source;
};

class FieldVisitor;
void visit_fields(FieldVisitor& v, CalibrationSpec& spec);  // its keys
// Throws InputError with all findings, "file:line: key: what is wrong, what was expected".
CalibrationSpec read_calibration(const std::string& file);
// JSON schema (draft 2020-12) of these files.
std::string calibration_schema();

UnitPoint start_of(const CalibrationSpec& spec);
double distance(const UnitPoint& a, const UnitPoint& b);  // Euclidean

// Replaces "{= formula}" in every text by its value with these parameters, in ten digits. Throws InputError.
std::vector<std::string> with_formulas(std::vector<std::string> texts, const CalibrationSpec& spec,
                                       const UnitPoint& point);
// 0: all constraints hold; otherwise the sum of violations over their bounds.
double violation_of(const CalibrationSpec& spec, const UnitPoint& point);

}  // namespace footfall

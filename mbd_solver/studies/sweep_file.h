#pragma once
// A sweep file: many runs, metrics of them, and checks. `footfall sweep` and `footfall accuracy` read the same files, whose
// keys docs/reference/sweep_files.md describes. A case is one value of a curve, or one combination of the values of
// parameters; every case is run for every value of the ensemble.

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/studies/metrics.h"

namespace footfall {

// How the runs of a campaign are placed in the unit cube, before the distributions.
enum class Design {
  kRandom,          // each row from its own seed
  kLatinHypercube,  // one row in each of `runs` slices of every quantity
  kSobol            // Sobol' sequence, shifted at random
};
constexpr std::string_view name_of(Design design) { return name_in(design, "random", "latin_hypercube", "sobol"); }

enum class DistributionKind {
  kNormal,
  kLognormal,  // log(X - least) is normal
  kUniform,
  kTriangular,
  kWeibull,   // P(X > least + x) = exp(-(x / scale)^shape)
  kDiscrete,  // values or choices, with weights
  kMeasured   // the numbers of a CSV file, each as likely as the others
};
constexpr std::string_view name_of(DistributionKind kind) {
  return name_in(kind, "normal", "lognormal", "uniform", "triangular", "weibull", "discrete", "measured");
}

// The distribution of a drawn parameter. A normal, lognormal or Weibull distribution with bounds is truncated there;
// the latter two begin at `least`. Mean and deviation belong to the values before truncation.
struct DistributionSpec {
  std::optional<DistributionKind> kind;                                      // none: the parameter is not drawn
  std::optional<double> mean, deviation, least, most, likely, shape, scale;  // units of the parameter, shape [-]
  std::vector<double> weights;                                               // of the values or choices; empty: alike
  std::string file, column;      // of measured values; column: name in the first line, else the first column
  std::vector<double> measured;  // from that file
  bool whole_rows = false;       // of measured: all such parameters of the same file have the values of the same row
};

struct ChoiceSpec {
  std::string name, scene;  // scene empty: the sweep's
  std::vector<std::string> settings;
};

// [[parameters]]: every combination of their values is a case; the last one varies fastest.
struct ParameterSpec {
  std::string name;
  std::vector<std::string> settings, values, short_values;  // {value} in settings is replaced by each value
  std::vector<ChoiceSpec> choices, short_choices;           // given instead of values, or one for each value
  bool ensemble = false;                                    // its values are samples of one case, as seeds are
  DistributionSpec distribution;                            // of a campaign
  Source source;

  bool is_drawn() const { return distribution.kind.has_value(); }
};

// The runs of a stability map: see MapRow in results.h.
struct MapSpec {
  std::string group;                 // heading in the table; empty: not a stability map
  std::vector<std::string> columns;  // of history.csv, compared with the reference; empty: judged by energy
  bool at_end = false;               // compare the last row only
  double tolerance = 0.02;           // of the error, over the reference's range [-]
};

// [[curves]]: their values are cases, one after the other.
struct CurveSpec {
  std::string name, scene;             // scene empty: the sweep's
  std::vector<std::string> settings;   // "{value}" and "{beside}" are replaced
  std::vector<std::string> reference;  // settings of a reference of its own, likewise; empty: [reference] only
  std::vector<std::string> values, beside;
  std::vector<std::string> short_values = {""};  // of the short form; {""}: the first value; empty: none
  std::string default_value;                     // the value that the scene has; empty: none of them
  double scale = 1.0;                            // x = scale value
  double until = 0.0;                            // [s]; 0: the sweep's
  MapSpec map;
  Source source;
};

// [reference]: the run with which the others are compared.
struct ReferenceSpec {
  std::string scene;  // empty: the sweep's, otherwise the curve's
  std::vector<std::string> settings;
};

// [short]: changes for --short.
struct ShortSpec {
  double until = 0.0;  // [s]; 0: unchanged
  std::vector<std::string> settings;
};

// [[limits]]: cases beyond are left out of the ranking.
struct LimitSpec {
  std::string metric;
  double most = 0.0;
  Source source;
};

// [[plots]]: a column of history.csv over time, a line per case.
struct PlotSpec {
  std::string name, title, column, label;
};

// [[statements]] and [[expect]]: bounds of a metric of a case; with `order` or `error`, of a curve.
struct CheckSpec {
  std::string text, metric, why;  // why: explanation, shown where the check is not reproduced
  std::string of_case, against;   // against: case that the metric is compared with; empty: none
  bool difference = false;        // bounds of the difference to `against`, not of the ratio
  std::string curve;
  std::vector<double> order;    // bounds of the slope of the error over x: empty, or two
  std::optional<double> error;  // bound of the error at the last value [-]
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  bool must = false;  // [[expect]]: exit code 1 unless reproduced
  Source source;
};

struct FitFactor {
  std::string name;                              // in the law
  std::vector<std::string> sum;                  // parameters and metrics whose sum it is
  std::map<std::string, std::string> published;  // exponents, by author
  Source source;
};

// [[fits]]: a power law through all runs, metric = A factor_1^p_1 factor_2^p_2 ...
struct FitSpec {
  std::string name, metric, label;           // label: of the metric in the law
  std::string marks;                         // parameter whose values get their own symbols in the picture
  std::map<std::string, std::string> where;  // only runs with these values of parameters
  std::vector<FitFactor> factors;
  Source source;
};

// [[correlations]]: of two drawn parameters, by a normal copula.
struct CorrelationSpec {
  std::vector<std::string> between;
  double rank = 0.0;  // Spearman's coefficient, -1 to 1
  Source source;
};

// [[outcomes]]: events that may happen in a run.
struct OutcomeSpec {
  std::string name, when;         // when: a formula of metrics and drawn parameters; not 0: it has happened
  std::optional<double> at_most;  // probability that a statement with 95 % confidence claims it is below
  // Instead of a formula: it has happened when this metric is out of these bounds, of a requirement of the scene.
  std::string metric;
  std::optional<double> least, most;
  Source source;
};

// [[envelopes]]: where in one or two drawn parameters an outcome happens.
struct EnvelopeSpec {
  std::string name, x, y, outcome;  // y empty: over x alone; outcome empty: the first
  double level = 0.5;               // probability on the boundary
  Source source;
};

// [check]: drawn runs that are repeated with a better model, such as on grains.
struct BetterModelSpec {
  // Least share with which the interval holds wherever the models differ.
  static constexpr double kFar = 0.7;
  std::string scene, outcome;         // empty: as for the run; the first
  std::vector<std::string> settings;  // after the settings of the run
  int runs = 20;                      // of each case
  double far = kFar;                  // share of the weights that all runs get, near the boundary or not [-]
  double until = 0.0;                 // [s]; 0: as for the run
  Source source;
};

// [rare]: the probability of a rare event, whose runs depend on those before (campaign/subset_search.h).
struct RareSpec {
  std::string metric;
  std::optional<double> above, below;  // the event: the metric is beyond; one of them
  Source source;
};

struct SweepSpec {
  std::string file, folder;  // of the file
  std::string title, scene, x_name = "value";
  std::string minimise;               // metric that ranks the cases within the limits; empty: no ranking
  std::vector<std::string> settings;  // of every run
  double until = 0.0;                 // [s]; 0: the scene's end time
  int time_limit = 0;                 // of a run, wall-clock [s]; 0: none
  int repeats = 1;                    // of every run; the shortest run time counts
  bool trusted = false;               // of every run: --trust-script, which the file does not give
  ShortSpec short_form;
  std::vector<ParameterSpec> parameters;
  std::vector<CurveSpec> curves;
  std::optional<ReferenceSpec> reference;
  std::vector<MetricSpec> metrics;  // [[figures]]
  std::vector<LimitSpec> limits;
  std::vector<CheckSpec> checks, expected;  // checks of [[expect]] are in both
  std::vector<PlotSpec> plots;
  std::vector<FitSpec> fits;
  // A campaign: drawn runs.
  int runs = 0;  // of each case; 0: not a campaign
  Design design = Design::kRandom;
  int seed = 1, keep = 20;   // keep: runs that are repeated with all their files
  double until_width = 0.0;  // of the 95 % interval of every outcome, at which it stops; 0: all runs
  std::vector<CorrelationSpec> correlations;
  std::vector<OutcomeSpec> outcomes;
  std::vector<EnvelopeSpec> envelopes;
  std::optional<BetterModelSpec> better_model;
  std::optional<RareSpec> rare;
  Source source;

  bool is_campaign() const { return runs > 0; }
  bool is_map() const { return !curves.empty() && !curves.front().map.group.empty(); }
};

// Texts that may be written as numbers.
inline constexpr Rule kWords{Unit::kNone, Range::kAny, Meaning::kWords};

void visit_fields(FieldVisitor& v, SweepSpec& spec);  // its keys
// Throws InputError with all findings, "file:line: key: what is wrong, what was expected".
SweepSpec read_sweep_file(const std::string& file);
// JSON schema (draft 2020-12) of these files, from the same description of keys.
std::string sweep_schema();

inline constexpr const char* kFormulaMark = "{=";
bool is_formula_name(const std::string& name);  // letters, digits and _, without a leading digit
// The name of a metric or parameter in formulas: "peak acceleration [g]" is peak_acceleration.
std::string formula_name(const std::string& name);
// With as many digits, 15 to 17, as it takes to read back the same number: "0.1", "2147483647".
std::string exact_text(double value);
// In every "{= formula}" of the texts, without those that cannot be read.
std::set<std::string> names_in_formulas(const std::vector<std::string>& texts);
// Replaces every "{= formula}" in the texts by its value, as `written` writes it. Throws InputError.
std::vector<std::string> with_formulas(std::vector<std::string> texts, std::map<std::string, double>& values,
                                       std::string (*written)(double) = exact_text);
inline constexpr double kMostRuns = 1e5;  // of one file

// Replaces "{value}", or another mark, in every text.
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

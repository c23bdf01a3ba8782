// Keys are described as for a scene (scene/field_visitor.h); a validator reports contradictions.
#include "mbd_solver/studies/calibration.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/studies/study_file.h"
#include "mbd_solver/studies/sweep_file.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

static void visit_fields(FieldVisitor& v, CalibrationParameter& p) {
  v.fields(rule::plain, {{"", &p.source}, {"start", &p.start}, {"source", &p.origin}});
  v.fields(rule::required(), {{"name", &p.name}, {"least", &p.least}, {"most", &p.most}});
  v.fields(kWords, {{"settings", &p.settings}});
  v.choice("scale", p.scale);
}

static void visit_fields(FieldVisitor& v, CalibrationScene& s) {
  v.fields(rule::plain, {{"", &s.source}, {"scene", &s.scene}});
  v.fields(rule::required(), {{"name", &s.name}});
  v.fields(kWords, {{"settings", &s.settings}});
  v.fields(rule::not_negative(), {{"until", &s.until}});
}

static void visit_fields(FieldVisitor& v, SeedsSpec& s) {
  v.fields(rule::plain, {{"", &s.source}});
  v.fields(kWords, {{"settings", &s.settings}, {"values", &s.values}});
  v.fields(rule::positive(), {{"search", &s.search}});
}

static void visit_fields(FieldVisitor& v, StageSpec& s) {
  v.fields(rule::plain, {{"", &s.source}, {"file", &s.file}});
  v.choice("method", s.method, rule::required());
  v.fields(rule::positive(), {{"evaluations", &s.evaluations}, {"precision", &s.precision}});
  v.fields(rule::not_negative(), {{"seed", &s.seed}, {"until", &s.until}});
  v.fields(kWords, {{"settings", &s.settings}});
}

static void visit_fields(FieldVisitor& v, TargetSpec& t) {
  v.fields(rule::plain, {{"", &t.source}, {"name", &t.name}, {"figure", &t.metric}, {"scene", &t.scene}});
  v.fields(rule::plain, {{"against", &t.against},
                         {"difference", &t.difference},
                         {"value", &t.value},
                         {"least", &t.least},
                         {"most", &t.most}});
  v.fields(rule::plain, {{"column", &t.column}, {"over", &t.over}, {"file", &t.file}, {"source", &t.origin}});
  v.fields(rule::required(rule::positive()), {{"tolerance", &t.tolerance}});
  v.fields(rule::not_negative(), {{"weight", &t.weight}});
}

static void visit_fields(FieldVisitor& v, ConstraintSpec& c) {
  v.fields(rule::plain, {{"", &c.source}, {"least", &c.least}, {"most", &c.most}});
  v.fields(rule::required(), {{"name", &c.name}, {"formula", &c.formula}});
}

void visit_fields(FieldVisitor& v, CalibrationSpec& s) {
  v.fields(rule::plain, {{"", &s.source}, {"title", &s.title}, {"scene", &s.scene}});
  v.fields(kWords, {{"settings", &s.settings}});
  v.fields(rule::not_negative(), {{"until", &s.until}, {"time_limit", &s.time_limit}});
  v.fields(rule::not_negative(), {{"cap", &s.cap}, {"alone", &s.single_target}});
  v.fields(rule::positive(), {{"step", &s.step}, {"failed", &s.failed}, {"confirm", &s.confirm}});
  v.fields(rule::share, {{"confidence", &s.confidence}});
  v.section("seeds", s.seeds);
  v.list("parameters", s.parameters);
  v.list("scenes", s.scenes);
  v.list("stages", s.stages);
  v.list("figures", s.metrics);
  v.list("targets", s.targets);
  v.list("constraints", s.constraints);
}

std::string calibration_schema() {
  CalibrationSpec defaults;
  return schema_of("Calibration file of footfall", [&](FieldVisitor& v) { visit_fields(v, defaults); });
}

namespace {

bool holds(const std::vector<std::string>& texts, const std::string& mark) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(mark) != std::string::npos; });
}

// Fills values that follow from other keys, and finds contradictions.
class CalibrationValidator : StudyValidator<CalibrationSpec> {
 public:
  CalibrationValidator(CalibrationSpec& spec, Findings& findings) : StudyValidator(spec, findings) {}

  void validate() {
    if (spec_.parameters.empty()) wrong(code::kMissingKey, spec_.source, "parameters", "are missing");
    if (spec_.targets.empty()) wrong(code::kMissingKey, spec_.source, "targets", "are missing");
    if (spec_.stages.empty())
      wrong(code::kMissingKey, spec_.source, "stages",
            "are missing, expected at least one, such as method = \"sbplx\"");
    if (spec_.confidence <= 0.0 || spec_.confidence >= 1.0)
      wrong(code::kOutOfRange, spec_.source, "confidence", "expected a number between 0 and 1, such as 0.95");
    if (spec_.step > 0.5)
      wrong(code::kOutOfRange, spec_.source, "step", "is relative to the ranges, expected at most 0.5");
    validate_scenes();
    for (const CalibrationParameter& p : spec_.parameters) validate(p);
    findings_.throw_if_errors();  // formulas need the parameters
    validate_formulas();
    if (spec_.seeds) validate(*spec_.seeds);
    for (const MetricSpec& f : spec_.metrics) validate(f);
    for (TargetSpec& t : spec_.targets) validate(t);
    for (StageSpec& stage : spec_.stages) validate(stage);
    unique(names_in(spec_.targets), "targets");
    findings_.throw_if_errors();
  }

 private:
  // An error of `action` has a code if it is one of ours.
  template <class Action>
  void attempt(const Source& at, const std::string& key, const Action& action) {
    try {
      action();
    } catch (const CodedError& error) {
      findings_.coded_error(at, key, error.what());
    } catch (const std::exception& error) {
      wrong(code::kStudyFormula, at, key, error.what());
    }
  }

  void unique(std::vector<std::string> names, const std::string& list) {
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end())
      wrong(code::kDuplicateName, spec_.source, list, "two are named \"" + *twice + "\"; expected different names");
  }

  void validate_scenes() {
    if (spec_.scenes.empty()) spec_.scenes = {{"run", "", {}, 0.0, spec_.source}};
    for (CalibrationScene& s : spec_.scenes) {
      if (!is_plain_name(s.name))
        wrong(code::kBadName, s.source, "name",
              "is \"" + s.name + "\", expected letters, digits and _ - . as in folders");
      if (s.scene.empty()) s.scene = spec_.scene;
      if (s.scene.empty()) wrong(code::kMissingKey, s.source, "scene", "is missing");
      s.scene = in_folder(s.scene);
    }
    unique(names_in(spec_.scenes), "scenes");
  }

  void validate(const CalibrationParameter& p) {
    if (!is_formula_name(p.name))
      wrong(code::kBadName, p.source, "name",
            "is \"" + p.name + "\", expected letters, digits and _, without a leading digit, for formulas");
    if (p.name == "value")
      wrong(code::kBadName, p.source, "name", "is \"value\", which {value} would mean; choose another");
    if (!(p.least < p.most))
      wrong(code::kRangeReversed, p.source, "most",
            "is " + number_text(p.most) + ", expected more than least = " + number_text(p.least));
    if (p.scale == RangeScale::kLogarithmic && p.least <= 0.0)
      wrong(code::kOutOfRange, p.source, "least",
            "is " + number_text(p.least) + ", expected more than 0 on a logarithmic scale");
    if (p.start && !(*p.start >= p.least && *p.start <= p.most))
      wrong(code::kOutOfRange, p.source, "start",
            "is " + number_text(*p.start) + ", expected a value between least and most");
    if (!p.settings.empty() && !holds(p.settings, "{value}"))
      wrong(code::kMissingKey, p.source, "settings",
            "do not contain {value}, expected settings such as \"gravity=[0,0,-{value}]\"");
    unique(names_in(spec_.parameters), "parameters");
  }

  // Every formula can be evaluated at the start; every parameter has an effect.
  void validate_formulas() {
    std::vector<std::string> all = spec_.settings;
    for (const CalibrationScene& s : spec_.scenes) append(all, s.settings);
    for (const StageSpec& s : spec_.stages) append(all, s.settings);
    for (const CalibrationParameter& p : spec_.parameters) append(all, p.settings);
    const std::set<std::string> names = names_in_formulas(all);
    attempt(spec_.source, "settings", [&] { with_formulas(all, spec_, start_of(spec_)); });
    for (const CalibrationParameter& p : spec_.parameters)
      if (p.settings.empty() && names.count(p.name) == 0)
        wrong(code::kKeyWithoutEffect, p.source, "settings",
              "are missing, and no {= formula} uses \"" + p.name + "\", which has no effect");
    for (const ConstraintSpec& c : spec_.constraints) {
      if (std::isinf(c.least) && std::isinf(c.most))
        wrong(code::kMissingKey, c.source, "least", "expected least, most or both");
      if (c.least > c.most) wrong(code::kRangeReversed, c.source, "most", "is less than least");
      attempt(c.source, "formula", [&] { with_formulas({"{= " + c.formula + "}"}, spec_, start_of(spec_)); });
    }
    findings_.throw_if_errors();
    if (const UnitPoint start = start_of(spec_); violation_of(spec_, start) > 0.0)
      wrong(code::kOutOfRange, spec_.source, "constraints",
            "the start violates one; give parameters a start that satisfies all");
  }

  void validate(const SeedsSpec& s) {
    if (s.values.empty()) wrong(code::kMissingKey, s.source, "values", "are missing");
    if (!holds(s.settings, "{value}")) wrong(code::kMissingKey, s.source, "settings", "do not contain {value}");
    if (s.search > static_cast<int>(s.values.size()))
      wrong(code::kOutOfRange, s.source, "search",
            "is " + std::to_string(s.search) + ", expected at most the number of values, " +
                std::to_string(s.values.size()));
  }

  void validate(StageSpec& stage) {
    const bool listed = stage.method == SearchMethod::kListed;
    if (!listed && !stage.file.empty())
      wrong(code::kConflictingKeys, stage.source, "file", "is of method = \"listed\" only");
    if (!listed && stage.evaluations <= 0)
      wrong(code::kMissingKey, stage.source, "evaluations", "is missing, expected the largest number of sets");
    if (listed && stage.file.empty())
      wrong(code::kMissingKey, stage.source, "file", "is missing, expected a CSV file with a column per parameter");
    if (!listed || stage.file.empty()) return;
    attempt(stage.source, "file", [&] { stage.sets = listed_sets(in_folder(stage.file)); });
    if (stage.evaluations <= 0) stage.evaluations = static_cast<int>(stage.sets.size());
  }

  std::vector<UnitPoint> listed_sets(const std::string& file) {
    CsvReader csv(file, "a table of sets, a column per parameter");
    std::vector<std::size_t> columns;  // of the parameters
    std::vector<UnitPoint> sets;
    while (csv.next()) {
      if (columns.empty()) {
        for (const CalibrationParameter& p : spec_.parameters) {
          const auto found = std::find(csv.cells().begin(), csv.cells().end(), p.name);
          if (found == csv.cells().end()) csv.fail(code::kMissingKey, "has no column \"" + p.name + "\"");
          columns.push_back(found - csv.cells().begin());
        }
        continue;
      }
      UnitPoint set;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const CalibrationParameter& p = spec_.parameters[i];
        const double value = csv.number(columns[i]);
        if (value < p.least || value > p.most)
          csv.fail(code::kOutOfRange, p.name + " is " + number_text(value) + ", expected " + number_text(p.least) +
                                          " to " + number_text(p.most));
        set.push_back(p.position(value));
      }
      sets.push_back(set);
    }
    if (sets.empty()) csv.fail(code::kEmptyEntry, "has no sets");
    return sets;
  }

  void validate(const MetricSpec& f) {
    validate_source(f);
    if (f.compares_curves())
      wrong(code::kConflictingKeys, f.source, "error",
            "compares with a reference, which a calibration does not have; use a curve as target");
  }

  void validate(TargetSpec& t) {
    if (t.scene.empty()) t.scene = spec_.scenes.front().name;
    if (t.name.empty()) t.name = (t.is_curve() ? t.column : t.metric) + ", " + t.scene;
    for (const std::string& scene : {t.scene, t.against})
      if (!scene.empty() && index_of(spec_.scenes, scene) < 0)
        wrong(code::kUnknownSceneName, t.source, "scene",
              "\"" + scene + "\" is not one of [[scenes]]." + known_names("scenes", scene, names_in(spec_.scenes)));
    if (t.is_curve()) {
      if (t.column.empty())
        wrong(code::kMissingKey, t.source, "column", "is missing, expected the column to compare with y of the file");
      if (!t.metric.empty() || t.value || !t.against.empty())
        wrong(code::kConflictingKeys, t.source, "file", "excludes figure, value and against");
      t.file = in_folder(t.file);
      return attempt(t.source, "file", [&] {
        t.rows = read_two_columns(t.file);
        if (t.rows.empty()) wrong(code::kEmptyEntry, t.source, "file", t.file + " has no rows");
      });
    }
    if (!t.column.empty())
      wrong(code::kMissingKey, t.source, "file", "is missing, expected a file of x and y for the column");
    require_metric(t.source, "figure", t.metric);
    const bool band = std::isfinite(t.least) || std::isfinite(t.most);
    if (t.value.has_value() == band)
      wrong(code::kConflictingKeys, t.source, "value", "expected either value, or least, most or both");
    if (!(t.least <= t.most)) wrong(code::kRangeReversed, t.source, "most", "is less than least");
  }
};

}  // namespace

double CalibrationParameter::value(double u) const {
  if (u <= 0.0) return least;
  if (u >= 1.0) return most;
  return scale == RangeScale::kLinear ? least + u * (most - least) : least * std::pow(most / least, u);
}

double CalibrationParameter::position(double value) const {
  return scale == RangeScale::kLinear ? (value - least) / (most - least)
                                      : std::log(value / least) / std::log(most / least);
}

// Records of runs are known by these digits (docs/data/calibration).
static std::string ten_digits(double value) { return number_text(value, 10); }

std::string CalibrationParameter::text(double u) const { return ten_digits(value(u)); }

double distance(const UnitPoint& a, const UnitPoint& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

UnitPoint start_of(const CalibrationSpec& spec) {
  UnitPoint start;
  for (const CalibrationParameter& p : spec.parameters) start.push_back(p.start ? p.position(*p.start) : 0.5);
  return start;
}

std::vector<std::string> with_formulas(std::vector<std::string> texts, const CalibrationSpec& spec,
                                       const UnitPoint& point) {
  NamedValues values;
  for (std::size_t i = 0; i < point.size(); ++i)
    values[spec.parameters[i].name] = read_number(spec.parameters[i].text(point[i]).c_str(), nullptr);
  return with_formulas(std::move(texts), values, ten_digits);
}

double violation_of(const CalibrationSpec& spec, const UnitPoint& point) {
  double sum = 0.0;
  for (const ConstraintSpec& c : spec.constraints) {
    const double value = read_number(with_formulas({"{= " + c.formula + "}"}, spec, point).front().c_str(), nullptr);
    const double over = std::max({0.0, c.least - value, value - c.most});
    const double bound = value > c.most ? c.most : c.least;
    if (over > 0.0) sum += over / std::max(std::abs(bound), 1e-12);
  }
  return sum;
}

CalibrationSpec read_calibration(const std::string& file) {
  Findings findings(file);
  CalibrationSpec s = read_study<CalibrationSpec>(file, "a calibration file", "inputs/calibrations", findings);
  CalibrationValidator(s, findings).validate();
  return s;
}

}  // namespace footfall

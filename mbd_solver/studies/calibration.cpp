// The keys of a calibration's file, described as those of a scene are (scene/field_visitor.h).
#include "mbd_solver/studies/calibration.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/named_file.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/studies/experiment.h"

namespace footfall {
namespace {

const Rule kAnything{};
const Rule kNeeded{Unit::kNone, Range::kAny, Meaning::kPlain, true};
const Rule kTexts{Unit::kNone, Range::kAny, Meaning::kWords};
const Rule kAboveZero{Unit::kNone, Range::kPositive};
const Rule kNeededAboveZero{Unit::kNone, Range::kPositive, Meaning::kPlain, true};
const Rule kZeroOrMore{Unit::kNone, Range::kNotNegative};
const Rule kShare{Unit::kNone, Range::kUnitInterval};

}  // namespace

static void visit_fields(FieldVisitor& v, SoughtParameter& p) {
  v.field("", &p.source, kAnything);
  v.field("name", &p.name, kNeeded);
  v.field("settings", &p.settings, kTexts);
  v.field("least", &p.least, kNeeded);
  v.field("most", &p.most, kNeeded);
  v.field("start", &p.start, kAnything);
  v.field("source", &p.origin, kAnything);
  v.choice("scale", p.scale);
}

static void visit_fields(FieldVisitor& v, CalibrationScene& s) {
  v.field("", &s.source, kAnything);
  v.field("name", &s.name, kNeeded);
  v.field("scene", &s.scene, kAnything);
  v.field("settings", &s.settings, kTexts);
  v.field("until", &s.until, kZeroOrMore);
}

static void visit_fields(FieldVisitor& v, SeedsSpec& s) {
  v.field("", &s.source, kAnything);
  v.field("settings", &s.settings, kTexts);
  v.field("values", &s.values, kTexts);
  v.field("search", &s.search, kAboveZero);
}

static void visit_fields(FieldVisitor& v, StageSpec& s) {
  v.field("", &s.source, kAnything);
  v.choice("method", s.method, kNeeded);
  v.field("evaluations", &s.evaluations, kNeededAboveZero);
  v.field("seed", &s.seed, kZeroOrMore);
  v.field("precision", &s.precision, kAboveZero);
  v.field("settings", &s.settings, kTexts);
  v.field("until", &s.until, kZeroOrMore);
}

static void visit_fields(FieldVisitor& v, CalibrationLimits& l) {
  v.field("runs", &l.runs, kZeroOrMore);
  v.field("hours", &l.hours, kZeroOrMore);
}

static void visit_fields(FieldVisitor& v, TargetSpec& t) {
  v.field("", &t.source, kAnything);
  v.field("name", &t.name, kAnything);
  v.field("figure", &t.figure, kAnything);
  v.field("scene", &t.scene, kAnything);
  v.field("against", &t.against, kAnything);
  v.field("value", &t.value, kAnything);
  v.field("least", &t.least, kAnything);
  v.field("most", &t.most, kAnything);
  v.field("column", &t.column, kAnything);
  v.field("over", &t.over, kAnything);
  v.field("file", &t.file, kAnything);
  v.field("tolerance", &t.tolerance, kNeededAboveZero);
  v.field("weight", &t.weight, kZeroOrMore);
  v.field("source", &t.origin, kAnything);
}

static void visit_fields(FieldVisitor& v, ConstraintSpec& c) {
  v.field("", &c.source, kAnything);
  v.field("name", &c.name, kNeeded);
  v.field("formula", &c.formula, kNeeded);
  v.field("least", &c.least, kAnything);
  v.field("most", &c.most, kAnything);
}

void visit_fields(FieldVisitor& v, CalibrationSpec& s) {
  v.field("", &s.source, kAnything);
  v.field("title", &s.title, kAnything);
  v.field("scene", &s.scene, kAnything);
  v.field("settings", &s.settings, kTexts);
  v.field("until", &s.until, kZeroOrMore);
  v.field("time_limit", &s.time_limit, kZeroOrMore);
  v.field("step", &s.step, kAboveZero);
  v.field("confidence", &s.confidence, kShare);
  v.field("failed", &s.failed, kAboveZero);
  v.field("cap", &s.cap, kZeroOrMore);
  v.field("confirm", &s.confirm, kAboveZero);
  v.field("alone", &s.alone, kZeroOrMore);
  v.section("seeds", s.seeds);
  v.section("limits", s.limits);
  v.list("parameters", s.parameters);
  v.list("scenes", s.scenes);
  v.list("stages", s.stages);
  v.list("figures", s.figures);
  v.list("targets", s.targets);
  v.list("constraints", s.constraints);
}

std::string calibration_schema() {
  CalibrationSpec defaults;
  return schema_of("Calibration of footfall", [&](FieldVisitor& v) { visit_fields(v, defaults); });
}

namespace fs = std::filesystem;

namespace {

constexpr const char* kFormulaMark = "{=";

bool holds(const std::vector<std::string>& texts, const std::string& mark) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(mark) != std::string::npos; });
}

bool is_formula_name(const std::string& name) {
  return !name.empty() && !std::isdigit(static_cast<unsigned char>(name.front())) &&
         std::all_of(name.begin(), name.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
}

// What follows from the file's own words, and what cannot be.
class CalibrationChecker {
 public:
  CalibrationChecker(CalibrationSpec& spec, Findings& findings) : spec_(spec), findings_(findings) {}

  void check() {
    if (spec_.parameters.empty()) wrong(spec_.source, "parameters", "are missing");
    if (spec_.targets.empty()) wrong(spec_.source, "targets", "are missing");
    if (spec_.stages.empty())
      wrong(spec_.source, "stages", "are missing; expected at least one, such as method = \"bobyqa\"");
    if (spec_.confidence <= 0.0 || spec_.confidence >= 1.0)
      wrong(spec_.source, "confidence", "expected between 0 and 1, such as 0.95");
    if (spec_.step > 0.5) wrong(spec_.source, "step", "is a share of the ranges, expected at most 0.5");
    check_scenes();
    for (const SoughtParameter& p : spec_.parameters) check(p);
    findings_.throw_if_errors();  // formulas need the parameters
    check_formulas();
    if (spec_.seeds) check(*spec_.seeds);
    for (const FigureSpec& f : spec_.figures) check(f);
    for (TargetSpec& t : spec_.targets) check(t);
    unique(names_in(spec_.targets), "targets");
    findings_.throw_if_errors();
  }

 private:
  void wrong(const Source& at, const std::string& key, const std::string& what) { findings_.error(at, key, what); }

  void unique(std::vector<std::string> names, const std::string& list) {
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) wrong(spec_.source, list, "two are named \"" + *twice + "\"; expected different names");
  }

  void check_scenes() {
    if (spec_.scenes.empty()) {
      CalibrationScene only;
      only.name = "run";
      only.source = spec_.source;
      spec_.scenes = {only};
    }
    for (CalibrationScene& s : spec_.scenes) {
      if (!is_plain_name(s.name))
        wrong(s.source, "name", "is \"" + s.name + "\", expected letters, digits and _ - . : it names folders");
      if (s.scene.empty()) s.scene = spec_.scene;
      if (s.scene.empty()) wrong(s.source, "scene", "is missing");
      s.scene = (fs::path(spec_.folder) / s.scene).lexically_normal().string();
    }
    unique(names_in(spec_.scenes), "scenes");
  }

  void check(const SoughtParameter& p) {
    if (!is_formula_name(p.name))
      wrong(p.source, "name",
            "is \"" + p.name + "\", expected letters, digits and _, beginning with no digit: formulas read it");
    if (p.name == "value") wrong(p.source, "name", "is \"value\", which is what {value} stands for; choose another");
    if (!(p.least < p.most))
      wrong(p.source, "most", "is " + number_text(p.most) + ", expected more than least = " + number_text(p.least));
    if (p.scale == RangeScale::kLogarithmic && p.least <= 0.0)
      wrong(p.source, "least", "is " + number_text(p.least) + ", expected more than 0 on a logarithmic scale");
    if (p.start && !(*p.start >= p.least && *p.start <= p.most))
      wrong(p.source, "start", "is " + number_text(*p.start) + ", expected a value between least and most");
    if (!p.settings.empty() && !holds(p.settings, "{value}"))
      wrong(p.source, "settings",
            "hold no {value}; expected what {value} goes into, such as \"gravity=[0,0,-{value}]\"");
    unique(names_in(spec_.parameters), "parameters");
  }

  // Every formula can be computed at the start; every parameter does something.
  void check_formulas() {
    std::vector<std::vector<std::string>> lists = {spec_.settings};
    for (const CalibrationScene& s : spec_.scenes) lists.push_back(s.settings);
    for (const StageSpec& s : spec_.stages) lists.push_back(s.settings);
    for (const SoughtParameter& p : spec_.parameters) lists.push_back(p.settings);
    std::string all;
    for (const std::vector<std::string>& list : lists) {
      try {
        with_formulas(list, spec_, start_of(spec_));
      } catch (const std::exception& e) {
        wrong(spec_.source, "settings", e.what());
      }
      for (const std::string& text : list) all += text + "\n";
    }
    for (const SoughtParameter& p : spec_.parameters) {
      const bool read = [&] {
        for (std::size_t at = all.find(kFormulaMark); at != std::string::npos; at = all.find(kFormulaMark, at + 2))
          if (all.substr(at, all.find('}', at) - at).find(p.name) != std::string::npos) return true;
        return false;
      }();
      if (p.settings.empty() && !read)
        wrong(p.source, "settings", "are missing, and no {= formula} reads \"" + p.name + "\": it changes nothing");
    }
    for (const ConstraintSpec& c : spec_.constraints) {
      if (std::isinf(c.least) && std::isinf(c.most)) wrong(c.source, "least", "expected least, most or both");
      if (c.least > c.most) wrong(c.source, "most", "is less than least");
      try {
        with_formulas({"{= " + c.formula + "}"}, spec_, start_of(spec_));
      } catch (const std::exception& e) {
        wrong(c.source, "formula", e.what());
      }
    }
    findings_.throw_if_errors();
    if (const Shares start = start_of(spec_); broken_by(spec_, start) > 0.0)
      wrong(spec_.source, "constraints", "the start breaks one; give parameters a start that keeps all");
  }

  void check(const SeedsSpec& s) {
    if (s.values.empty()) wrong(s.source, "values", "are missing");
    if (!holds(s.settings, "{value}")) wrong(s.source, "settings", "hold no {value}; expected what {value} goes into");
    if (s.search > static_cast<int>(s.values.size()))
      wrong(s.source, "search",
            "is " + std::to_string(s.search) + ", expected at most the number of values, " +
                std::to_string(s.values.size()));
  }

  void check(const FigureSpec& f) {
    if (const FigureFault fault = fault_of(f); !fault.key.empty()) wrong(f.source, fault.key, fault.text);
    if (f.compares_curves())
      wrong(f.source, "error", "compares with a reference, and a calibration has none; a target may be a curve");
  }

  void check(TargetSpec& t) {
    if (t.scene.empty()) t.scene = spec_.scenes.front().name;
    if (t.name.empty()) t.name = (t.is_curve() ? t.column : t.figure) + ", " + t.scene;
    for (const std::string& scene : {t.scene, t.against})
      if (!scene.empty() && index_of(spec_.scenes, scene) < 0)
        wrong(t.source, "scene",
              "\"" + scene + "\" is not one of [[scenes]]." + known_names("scenes", scene, names_in(spec_.scenes)));
    if (t.is_curve()) {
      if (t.column.empty())
        wrong(t.source, "column", "is missing; expected the column that the file's y is compared with");
      if (!t.figure.empty() || t.value || !t.against.empty())
        wrong(t.source, "file", "is a target by itself; expected no figure, value or against beside it");
      t.file = (fs::path(spec_.folder) / t.file).lexically_normal().string();
      try {
        if (read_two_columns(t.file).empty()) wrong(t.source, "file", t.file + " holds no rows");
      } catch (const std::exception& e) {
        wrong(t.source, "file", e.what());
      }
      return;
    }
    if (!t.column.empty()) wrong(t.source, "file", "is missing; a column is compared with a file of x and y");
    if (index_of(spec_.figures, t.figure) < 0)
      wrong(t.source, "figure",
            "\"" + t.figure + "\" is not one of [[figures]]." +
                known_names("figures", t.figure, names_in(spec_.figures)));
    const bool band = std::isfinite(t.least) || std::isfinite(t.most);
    if (t.value.has_value() == band) wrong(t.source, "value", "expected either value, or least, most or both");
    if (!(t.least <= t.most)) wrong(t.source, "most", "is less than least");
  }

  CalibrationSpec& spec_;
  Findings& findings_;
};

}  // namespace

double SoughtParameter::value(double share) const {
  if (share <= 0.0) return least;
  if (share >= 1.0) return most;
  return scale == RangeScale::kLinear ? least + share * (most - least) : least * std::pow(most / least, share);
}

double SoughtParameter::share(double value) const {
  return scale == RangeScale::kLinear ? (value - least) / (most - least)
                                      : std::log(value / least) / std::log(most / least);
}

std::string SoughtParameter::text(double share) const { return number_text(value(share), 10); }

Shares start_of(const CalibrationSpec& spec) {
  Shares start;
  for (const SoughtParameter& p : spec.parameters) start.push_back(p.start ? p.share(*p.start) : 0.5);
  return start;
}

std::vector<std::string> with_formulas(std::vector<std::string> texts, const CalibrationSpec& spec,
                                       const Shares& shares) {
  NamedValues values;
  for (std::size_t i = 0; i < shares.size(); ++i)
    values[spec.parameters[i].name] = std::stod(spec.parameters[i].text(shares[i]));
  for (std::string& text : texts)
    for (std::size_t at = text.find(kFormulaMark); at != std::string::npos; at = text.find(kFormulaMark)) {
      const std::size_t end = text.find('}', at);
      if (end == std::string::npos)
        throw InputError("\"" + text + "\": a formula begins with {= and does not end; expected }");
      const std::string formula = trimmed(text.substr(at + 2, end - at - 2));
      for (const std::string& name : Expression::names_in(formula))
        if (values.find(name) == values.end())
          throw InputError("\"" + formula + "\": unknown parameter \"" + name + "\"." +
                           known_names("parameters", name, names_in(spec.parameters)));
      text.replace(at, end + 1 - at, number_text(Expression(formula, values).value(), 10));
    }
  return texts;
}

double broken_by(const CalibrationSpec& spec, const Shares& shares) {
  double sum = 0.0;
  for (const ConstraintSpec& c : spec.constraints) {
    const double value = std::stod(with_formulas({"{= " + c.formula + "}"}, spec, shares).front());
    const double over = std::max({0.0, c.least - value, value - c.most});
    const double bound = value > c.most ? c.most : c.least;
    if (over > 0.0) sum += over / std::max(std::abs(bound), 1e-12);
  }
  return sum;
}

CalibrationSpec read_calibration(const std::string& file) {
  require_file(file, "a calibration (TOML), as in inputs/calibrations");
  const ConfigNode root = parse_toml_file(file);
  Findings findings(file);
  CalibrationSpec s;
  s.file = file;
  s.folder = fs::absolute(file).parent_path().string();
  read_fields(
      root, s.folder, [&](FieldVisitor& reader) { visit_fields(reader, s); }, findings);
  findings.throw_if_errors();
  s.settings.insert(s.settings.begin(),
                    {"output.vtk=false", "output.plots=false"});  // nobody looks at hundreds of runs
  CalibrationChecker(s, findings).check();
  return s;
}

}  // namespace footfall

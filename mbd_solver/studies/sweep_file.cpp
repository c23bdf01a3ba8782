// Keys are described as for a scene (scene/field_visitor.h); SweepValidator completes the spec and reports contradictions.
#include "mbd_solver/studies/sweep_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/studies/plan.h"
#include "mbd_solver/studies/study_file.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

static void visit_fields(FieldVisitor& v, ChoiceSpec& c) {
  v.fields(rule::required(kWords), {{"name", &c.name}});
  v.fields(kWords, {{"settings", &c.settings}});
  v.fields(rule::plain, {{"scene", &c.scene}});
}

static void visit_fields(FieldVisitor& v, ParameterSpec& p) {
  v.fields(rule::plain, {{"", &p.source}, {"ensemble", &p.ensemble}});
  v.fields(rule::required(kWords), {{"name", &p.name}});
  v.fields(kWords, {{"settings", &p.settings}, {"values", &p.values}, {"short", &p.short_values}});
  v.list("choices", p.choices);
  DistributionSpec& d = p.distribution;
  v.choice("distribution", d.kind, "none");
  v.fields(rule::plain, {{"mean", &d.mean}, {"least", &d.least}, {"most", &d.most}, {"likely", &d.likely}});
  v.fields(rule::plain, {{"deviation", &d.deviation}, {"shape", &d.shape}, {"scale", &d.scale}});
  v.fields(rule::not_negative(), {{"weights", &d.weights}});
  v.fields(rule::plain, {{"measured", &d.file}, {"whole_rows", &d.whole_rows}});
  v.fields(kWords, {{"column", &d.column}});
}

static void visit_fields(FieldVisitor& v, CorrelationSpec& c) {
  v.fields(rule::plain, {{"", &c.source}});
  v.fields(rule::required(kWords), {{"between", &c.between}});
  v.fields(rule::required(), {{"rank", &c.rank}});
}

static void visit_fields(FieldVisitor& v, OutcomeSpec& o) {
  v.fields(rule::plain, {{"", &o.source}});
  v.fields(rule::required(kWords), {{"name", &o.name}});
  v.fields(rule::required(), {{"when", &o.when}});
  v.fields(rule::share, {{"at_most", &o.at_most}});
}

static void visit_fields(FieldVisitor& v, EnvelopeSpec& e) {
  v.fields(rule::plain, {{"", &e.source}, {"y", &e.y}, {"outcome", &e.outcome}});
  v.fields(rule::required(rule::name), {{"name", &e.name}});
  v.fields(rule::required(), {{"x", &e.x}});
  v.fields(rule::share, {{"level", &e.level}});
}

static void visit_fields(FieldVisitor& v, BetterModelSpec& c) {
  v.fields(rule::plain, {{"", &c.source}, {"scene", &c.scene}, {"outcome", &c.outcome}});
  v.fields(kWords, {{"settings", &c.settings}});
  v.fields(rule::positive(), {{"runs", &c.runs}});
  v.fields(rule::share, {{"far", &c.far}});
  v.fields(rule::not_negative(), {{"until", &c.until}});
}

static void visit_fields(FieldVisitor& v, RareSpec& r) {
  v.fields(rule::plain, {{"", &r.source}, {"above", &r.above}, {"below", &r.below}});
  v.fields(rule::required(), {{"figure", &r.metric}});
}

static void visit_fields(FieldVisitor& v, CurveSpec& c) {
  v.fields(rule::plain, {{"", &c.source}, {"scene", &c.scene}, {"scale", &c.scale}});
  v.fields(rule::required(kWords), {{"name", &c.name}});
  v.fields(kWords, {{"settings", &c.settings}, {"reference", &c.reference}, {"default", &c.default_value}});
  v.fields(kWords, {{"values", &c.values}, {"short", &c.short_values}, {"beside", &c.beside}});
  v.fields(rule::not_negative(), {{"until", &c.until}});
  v.fields(kWords, {{"columns", &c.map.columns}});
  v.fields(rule::plain, {{"group", &c.map.group}, {"at_end", &c.map.at_end}});
  v.fields(rule::not_negative(), {{"tolerance", &c.map.tolerance}});
}

static void visit_fields(FieldVisitor& v, ReferenceSpec& r) {
  v.fields(rule::plain, {{"scene", &r.scene}});
  v.fields(kWords, {{"settings", &r.settings}});
}

static void visit_fields(FieldVisitor& v, ShortSpec& s) {
  v.fields(rule::not_negative(), {{"until", &s.until}});
  v.fields(kWords, {{"settings", &s.settings}});
}

void visit_fields(FieldVisitor& v, MetricSpec& f) {
  v.fields(rule::plain, {{"", &f.source}, {"key", &f.key}, {"average", &f.average}, {"over", &f.over}});
  v.fields(rule::required(kWords), {{"name", &f.name}});
  v.fields(kWords, {{"columns", &f.columns}});
  v.fields(rule::plain, {{"slope", &f.slope}});
  v.fields(rule::not_negative(), {{"prominence", &f.prominence}, {"until", &f.until}});
  v.choice("reduce", f.reduction);
  v.choice("error", f.error);
}

static void visit_fields(FieldVisitor& v, LimitSpec& l) {
  v.fields(rule::plain, {{"", &l.source}});
  v.fields(rule::required(), {{"figure", &l.metric}, {"most", &l.most}});
}

static void visit_fields(FieldVisitor& v, CheckSpec& s) {
  v.fields(rule::plain,
           {{"", &s.source}, {"text", &s.text}, {"why", &s.why}, {"case", &s.of_case}, {"against", &s.against}});
  v.fields(rule::required(), {{"figure", &s.metric}});
  v.fields(rule::plain, {{"difference", &s.difference}, {"least", &s.least}, {"most", &s.most}});
  v.fields(rule::plain, {{"curve", &s.curve}, {"order", &s.order}, {"error", &s.error}});
}

static void visit_fields(FieldVisitor& v, PlotSpec& p) {
  v.fields(rule::required(rule::name), {{"name", &p.name}});
  v.fields(rule::required(), {{"column", &p.column}});
  v.fields(rule::plain, {{"title", &p.title}, {"label", &p.label}});
}

static void visit_fields(FieldVisitor& v, FitFactor& f) {
  v.fields(rule::plain, {{"", &f.source}, {"published", &f.published}});
  v.fields(rule::required(), {{"name", &f.name}});
  v.fields(kWords, {{"sum", &f.sum}});
}

static void visit_fields(FieldVisitor& v, FitSpec& f) {
  v.fields(rule::plain, {{"", &f.source}, {"label", &f.label}, {"marks", &f.marks}});
  v.fields(kWords, {{"where", &f.where}});
  v.fields(rule::required(rule::name), {{"name", &f.name}});
  v.fields(rule::required(), {{"figure", &f.metric}});
  v.list("factors", f.factors);
}

void visit_fields(FieldVisitor& v, SweepSpec& s) {
  v.fields(rule::plain, {{"", &s.source}, {"title", &s.title}, {"x_name", &s.x_name}, {"scene", &s.scene}});
  v.fields(rule::plain, {{"minimise", &s.minimise}});
  v.fields(kWords, {{"settings", &s.settings}});
  v.fields(rule::not_negative(), {{"until", &s.until}, {"time_limit", &s.time_limit}});
  v.fields(rule::positive(), {{"repeats", &s.repeats}});
  v.section("short", s.short_form);
  v.section("reference", s.reference);
  v.list("parameters", s.parameters);
  v.list("curves", s.curves);
  v.list("figures", s.metrics);
  v.list("limits", s.limits);
  v.list("statements", s.checks);
  v.list("expect", s.expected);
  v.list("plots", s.plots);
  v.list("fits", s.fits);
  v.fields(rule::not_negative(), {{"runs", &s.runs}, {"seed", &s.seed}, {"keep", &s.keep}});
  v.fields(rule::share, {{"until_width", &s.until_width}});
  v.choice("design", s.design);
  v.list("correlations", s.correlations);
  v.list("outcomes", s.outcomes);
  v.list("envelopes", s.envelopes);
  v.section("check", s.better_model);
  v.section("rare", s.rare);
}

std::string sweep_schema() {
  SweepSpec defaults;
  return schema_of("Sweep file of footfall", [&](FieldVisitor& v) { visit_fields(v, defaults); });
}

namespace fs = std::filesystem;

namespace {

bool is_in(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// Fills values that follow from other keys, and finds contradictions.
class SweepValidator : StudyValidator<SweepSpec> {
 public:
  SweepValidator(SweepSpec& spec, Findings& findings) : StudyValidator(spec, findings) {}

  // Before validate(), which requires a complete spec.
  void complete() {
    for (ParameterSpec& parameter : spec_.parameters) complete(parameter);
    for (CurveSpec& curve : spec_.curves) complete(curve);
    for (CheckSpec& check_spec : spec_.checks) complete(check_spec);
    for (FitSpec& fit : spec_.fits) complete(fit);
    find_scenes();
    findings_.throw_if_errors();
  }

  void validate() {
    validate_kind();
    validate_runs();
    validate_metrics();
    for (const FitSpec& fit : spec_.fits) validate(fit);
    findings_.throw_if_errors();
    const std::vector<std::string> cases = names_in(plan_of(spec_, false).cases);
    for (const CheckSpec& check_spec : spec_.checks) validate(check_spec, cases);
    findings_.throw_if_errors();
  }

 private:
  void complete(ParameterSpec& p) {
    if (p.is_drawn()) complete_drawn(p);
    if (p.is_drawn() && p.distribution.kind != DistributionKind::kDiscrete) return;
    if (p.values.empty() == p.choices.empty())
      wrong(code::kConflictingKeys, p.source, "values",
            "expected either values with settings that contain {value}, or choices");
    if (!p.values.empty() && p.settings.empty() && !p.is_drawn())
      wrong(code::kMissingKey, p.source, "settings",
            "are missing, expected settings that contain {value}, such as \"initial.velocity=[0,0,{value}]\"");
    for (const std::string& value : p.values) p.choices.push_back({value, "", filled(p.settings, value)});
    for (const std::string& name : p.short_values) {
      const int k = index_of(p.choices, name);
      if (k < 0)
        wrong(code::kNotAValue, p.source, "short", "has \"" + name + "\", expected some of the values");
      else
        p.short_choices.push_back(p.choices[k]);
    }
    if (p.short_choices.empty() && !p.choices.empty()) p.short_choices = {p.choices.front()};
  }

  // Its keys must belong to its kind; reads measured values.
  void complete_drawn(ParameterSpec& p) {
    DistributionSpec& d = p.distribution;
    const DistributionKind kind = *d.kind;
    const std::string name(name_of(kind));
    const auto is = [&](std::initializer_list<DistributionKind> kinds) {
      return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
    };
    using K = DistributionKind;
    const auto number = [&](const char* key, const std::optional<double>& value, bool required, bool allowed) {
      if (required && !value) wrong(code::kMissingKey, p.source, key, "is missing for the distribution " + name);
      if (value && !allowed)
        wrong(code::kKeyWithoutEffect, p.source, key, "has no effect on the distribution " + name + "; remove it");
    };
    const bool bounded = is({K::kUniform, K::kTriangular});
    const bool moments = is({K::kNormal, K::kLognormal}), open = is({K::kNormal, K::kLognormal, K::kWeibull});
    number("mean", d.mean, moments, moments);
    number("deviation", d.deviation, moments, moments);
    number("least", d.least, bounded, bounded || open);
    number("most", d.most, bounded, bounded || open);
    number("likely", d.likely, is({K::kTriangular}), is({K::kTriangular}));
    number("shape", d.shape, is({K::kWeibull}), is({K::kWeibull}));
    number("scale", d.scale, is({K::kWeibull}), is({K::kWeibull}));
    for (const auto& [key, value] : {std::pair{"deviation", d.deviation}, {"shape", d.shape}, {"scale", d.scale}})
      if (value && !(*value > 0.0)) wrong(code::kOutOfRange, p.source, key, "expected a number above 0");
    const double low = d.least.value_or(is({K::kWeibull, K::kLognormal}) ? 0.0 : -HUGE_VAL),
                 high = d.most.value_or(HUGE_VAL);
    if (!(low < high))
      wrong(code::kRangeReversed, p.source, "most", "is not above least, expected an interval");
    else if (d.likely && !(*d.likely >= low && *d.likely <= high))
      wrong(code::kOutOfRange, p.source, "likely", "expected a value between least and most");
    if (kind == K::kLognormal && d.mean && !(*d.mean > low))
      wrong(code::kOutOfRange, p.source, "mean", "expected a number above least (0), where the distribution begins");
    // A truncation far out in the tails leaves nothing to draw from.
    if (kind == K::kNormal && d.mean && d.deviation && *d.deviation > 0.0 &&
        (low > *d.mean + 8.0 * *d.deviation || high < *d.mean - 8.0 * *d.deviation))
      wrong(code::kOutOfRange, p.source, "least",
            "and most are more than 8 deviations from the mean, where there is nothing to draw");
    if (p.ensemble)
      wrong(code::kConflictingKeys, p.source, "ensemble", "is true, expected false: the parameter is drawn");
    if (!is_formula_name(p.name))
      wrong(code::kBadName, p.source, "name",
            "is \"" + p.name + "\", expected letters, digits and _, without a leading digit, for formulas");
    if (p.name == "row" || p.name == "seed")
      wrong(code::kReservedName, p.source, "name", "is \"" + p.name + "\", which formulas have of every run");
    validate_lists(p, kind);
  }

  void validate_lists(ParameterSpec& p, DistributionKind kind) {
    DistributionSpec& d = p.distribution;
    const bool discrete = kind == DistributionKind::kDiscrete;
    const std::string name(name_of(kind));
    const auto without = [&](const char* key, bool given) {
      if (given)
        wrong(code::kKeyWithoutEffect, p.source, key, "has no effect on the distribution " + name + "; remove it");
    };
    if (!discrete) without("values", !p.values.empty()), without("choices", !p.choices.empty());
    if (!discrete) without("weights", !d.weights.empty());
    const std::size_t choices = std::max(p.values.size(), p.choices.size());
    if (discrete && !d.weights.empty() && d.weights.size() != choices)
      wrong(code::kWrongCount, p.source, "weights",
            "has " + std::to_string(d.weights.size()) + " numbers, expected one for each of the " +
                std::to_string(choices) + " values");
    if (discrete && !d.weights.empty() && !(*std::max_element(d.weights.begin(), d.weights.end()) > 0.0))
      wrong(code::kOutOfRange, p.source, "weights", "are all 0");
    if (kind != DistributionKind::kMeasured) {
      without("measured", !d.file.empty());
      without("column", !d.column.empty());
      without("whole_rows", d.whole_rows);
    } else if (d.file.empty()) {
      wrong(code::kMissingKey, p.source, "measured", "is missing, expected a CSV file of measured values");
    } else {
      read_measured(p);
    }
  }

  void read_measured(ParameterSpec& p) {
    DistributionSpec& d = p.distribution;
    d.file = in_folder(d.file);
    try {
      CsvReader csv(d.file, "a table of measured values, a row per measurement");
      std::size_t column = 0;
      if (!d.column.empty()) {
        std::vector<std::string> head;
        if (csv.next()) head.assign(csv.cells().begin(), csv.cells().end());
        const auto found = std::find(head.begin(), head.end(), d.column);
        column = static_cast<std::size_t>(found - head.begin());
        if (found == head.end())
          return wrong(code::kUnknownChoice, p.source, "column",
                       "\"" + d.column + "\" is not in the first line of " + d.file + "." +
                           known_names("columns", d.column, head));
      }
      while (csv.next()) {
        if (csv.cells().size() <= column) csv.require_width(column + 1);
        d.measured.push_back(csv.number(column));
      }
      if (d.measured.size() < 2)
        wrong(code::kWrongCount, p.source, "measured",
              "has " + std::to_string(d.measured.size()) + " values, expected at least 2");
    } catch (const InputError& e) {
      findings_.coded_error(p.source, "measured", e.what());
    }
  }

  void complete(CurveSpec& c) {
    if (c.values.empty() && !c.map.group.empty()) c.values = {""};  // one run
    if (c.values.empty()) return wrong(code::kMissingKey, c.source, "values", "are missing");
    if (c.short_values == CurveSpec().short_values) c.short_values = {c.values.front()};
    if (!c.beside.empty() && c.beside.size() != c.values.size())
      wrong(code::kWrongCount, c.source, "beside",
            "has " + std::to_string(c.beside.size()) + " entries, expected one for each of the " +
                std::to_string(c.values.size()) + " values");
    for (const std::string& value : c.short_values)
      if (!is_in(c.values, value))
        wrong(code::kNotAValue, c.source, "short", "has \"" + value + "\", expected some of the values");
    if (!c.default_value.empty() && !is_in(c.values, c.default_value))
      wrong(code::kNotAValue, c.source, "default", "is \"" + c.default_value + "\", expected one of the values");
  }

  void complete(CheckSpec& s) {
    if (s.curve.empty()) {
      if (s.text.empty()) wrong(code::kMissingKey, s.source, "text", "is missing");
      if (s.of_case.empty()) wrong(code::kMissingKey, s.source, "case", "is missing");
      if (std::isinf(s.least) && std::isinf(s.most))
        wrong(code::kMissingKey, s.source, "least", "expected least, most or both");
      if (s.least > s.most) wrong(code::kRangeReversed, s.source, "most", "is less than least");
      return;
    }
    if (s.order.empty() != s.error.has_value())
      wrong(code::kConflictingKeys, s.source, "curve", "expected order = [least, most] or error = most");
    if (!s.order.empty() && s.order.size() != 2) wrong(code::kWrongCount, s.source, "order", "expected [least, most]");
    if (s.error) s.most = *s.error;
    if (s.order.size() == 2) s.least = s.order[0], s.most = s.order[1];
    if (s.least > s.most)
      wrong(code::kRangeReversed, s.source, "order", "is [most, least], expected the smaller number first");
    if (s.text.empty()) s.text = s.curve + ", " + s.metric;
  }

  void complete(FitSpec& f) {
    if (f.label.empty()) f.label = f.metric;
    if (f.factors.empty()) wrong(code::kMissingKey, f.source, "factors", "are missing");
    for (FitFactor& factor : f.factors)
      if (factor.sum.empty()) factor.sum = {factor.name};
  }

  // Scenes are relative to the file.
  void find_scenes() {
    const auto find = [&](std::string& scene) {
      if (!scene.empty()) scene = in_folder(scene);
    };
    find(spec_.scene);
    if (spec_.reference) find(spec_.reference->scene);
    for (CurveSpec& curve : spec_.curves) find(curve.scene);
    for (ParameterSpec& parameter : spec_.parameters)
      for (auto* choices : {&parameter.choices, &parameter.short_choices})
        for (ChoiceSpec& choice : *choices) find(choice.scene);
    if (spec_.better_model) find(spec_.better_model->scene);
  }

  // Sections of a campaign that other sweeps do not have, and the reverse.
  void validate_kind() {
    const auto only = [&](const char* key, bool given) {
      if (!given) return;
      wrong(spec_.is_campaign() ? code::kConflictingKeys : code::kNeedsOtherKey, spec_.source, key,
            spec_.is_campaign() ? "cannot be combined with runs, expected drawn parameters and outcomes; remove it"
                                : "has an effect on drawn runs only, expected runs = NUMBER as well");
    };
    if (!spec_.is_campaign()) {
      for (const ParameterSpec& p : spec_.parameters)
        if (p.is_drawn())
          return wrong(code::kMissingKey, spec_.source, "runs",
                       "is missing, expected the number of runs to draw (parameter \"" + p.name +
                           "\" has a distribution), such as runs = 1000");
      only("correlations", !spec_.correlations.empty());
      only("outcomes", !spec_.outcomes.empty());
      only("envelopes", !spec_.envelopes.empty());
      only("check", spec_.better_model.has_value());
      only("rare", spec_.rare.has_value());
      for (const char* key : {"until_width", "design", "keep", "seed"}) only(key, spec_.source.given(key));
      return;
    }
    only("curves", !spec_.curves.empty());
    only("reference", spec_.reference.has_value());
    only("limits", !spec_.limits.empty());
    only("statements", !spec_.checks.empty());
    only("plots", !spec_.plots.empty());
    only("fits", !spec_.fits.empty());
    only("minimise", !spec_.minimise.empty());
    only("repeats", spec_.repeats != 1);
    findings_.throw_if_errors();
    validate_campaign();
  }

  void validate_campaign() {
    double cases = 1.0;
    std::set<std::string> drawn;
    for (const ParameterSpec& p : spec_.parameters) {
      if (p.ensemble)
        wrong(code::kConflictingKeys, p.source, "ensemble",
              "is true, expected distribution = \"discrete\" in a file with runs");
      if (p.is_drawn() && !drawn.insert(p.name).second)
        wrong(code::kDuplicateName, p.source, "name", "\"" + p.name + "\" is taken by another parameter");
      if (!p.is_drawn()) cases *= static_cast<double>(p.choices.size());
    }
    if (drawn.empty())
      wrong(code::kNeedsOtherKey, spec_.source, "runs",
            "draws runs, expected at least one of [[parameters]] with a distribution");
    if (spec_.runs * cases > kMostRuns)
      wrong(code::kTooManyRuns, spec_.source, "runs",
            "makes " + number_text(spec_.runs * cases, 3) + " runs of all cases, expected at most " +
                number_text(kMostRuns));
    if (spec_.metrics.empty()) wrong(code::kMissingKey, spec_.source, "figures", "are missing");
    for (const MetricSpec& m : spec_.metrics) {
      if (!is_formula_name(formula_name(m.name)))
        wrong(code::kBadName, m.source, "name",
              "is \"" + m.name + "\", expected letters, digits and blanks, for formulas, before a unit in brackets");
      if (m.compares_curves())
        wrong(code::kConflictingKeys, m.source, "error", "compares with a reference, which drawn runs do not have");
    }
    validate_formulas(drawn);
    for (const CorrelationSpec& c : spec_.correlations) {
      if (c.between.size() != 2 || c.between[0] == c.between[1])
        wrong(code::kWrongCount, c.source, "between", "expected the names of two drawn parameters");
      for (const std::string& name : c.between) require_drawn(c.source, "between", name, drawn);
      for (const std::string& name : c.between)
        if (const int k = index_of(spec_.parameters, name); k >= 0 && spec_.parameters[k].distribution.whole_rows)
          wrong(code::kConflictingKeys, c.source, "between",
                "\"" + name + "\" is drawn in whole rows, which have the correlation of the measurement");
      if (!(std::abs(c.rank) < 1.0))
        wrong(code::kOutOfRange, c.source, "rank", "expected a number between -1 and 1, without the ends");
    }
    for (const EnvelopeSpec& e : spec_.envelopes) {
      require_drawn(e.source, "x", e.x, drawn);
      if (!e.y.empty()) require_drawn(e.source, "y", e.y, drawn);
      if (e.x == e.y) wrong(code::kListedTwice, e.source, "y", "is the same parameter as x");
      if (!(e.level > 0.0 && e.level < 1.0))
        wrong(code::kOutOfRange, e.source, "level", "expected a probability between 0 and 1, without the ends");
      require_outcome(e.source, e.outcome);
    }
    if (spec_.rare) validate_rare(*spec_.rare, cases);
    if (!spec_.better_model) return;
    require_outcome(spec_.better_model->source, spec_.better_model->outcome);
    if (spec_.better_model->settings.empty() && spec_.better_model->scene.empty())
      wrong(code::kMissingKey, spec_.better_model->source, "settings",
            "are missing, expected what differs in the runs of the check, such as \"ground.kind=particles\"");
    if (spec_.better_model->runs < 2)
      wrong(code::kOutOfRange, spec_.better_model->source, "runs", "expected at least 2");
  }

  void validate_rare(const RareSpec& rare, double cases) {
    constexpr int kFewest = 500;
    require_metric(rare.source, "figure", rare.metric);
    if (rare.above.has_value() == rare.below.has_value())
      wrong(code::kConflictingKeys, rare.source, "above", "expected one of above and below");
    if (spec_.runs < kFewest)
      wrong(code::kOutOfRange, spec_.source, "runs",
            "is " + std::to_string(spec_.runs) + ", expected at least " + std::to_string(kFewest) + " with [rare]");
    if (cases > 1.0)
      wrong(code::kConflictingKeys, rare.source, "", "cannot be combined with cases, expected drawn parameters only");
    const auto without = [&](const char* key, bool given) {
      if (given) wrong(code::kConflictingKeys, rare.source, key, "cannot be combined with [rare]; remove it");
    };
    without("outcomes", !spec_.outcomes.empty());
    without("envelopes", !spec_.envelopes.empty());
    without("check", spec_.better_model.has_value());
    for (const char* key : {"until_width", "design"}) without(key, spec_.source.given(key));
  }

  void validate_formulas(const std::set<std::string>& drawn) {
    std::map<std::string, double> values = {{"row", 1.0}, {"seed", 1.0}};
    for (const std::string& name : drawn) values[name] = 1.0;
    std::set<std::string> used;
    const auto validate_texts = [&](const Source& at, const std::string& key, const std::vector<std::string>& texts) {
      const std::set<std::string> names = names_in_formulas(texts);
      used.insert(names.begin(), names.end());
      for (const std::string& text : texts) {
        try {
          with_formulas({text}, values);
        } catch (const InputError& e) {
          findings_.coded_error(at, key, e.what());
        } catch (const NumericalError&) {  // has no value here; the first row is tried before all
        }
      }
    };
    validate_texts(spec_.source, "settings", spec_.settings);
    if (spec_.better_model) validate_texts(spec_.better_model->source, "settings", spec_.better_model->settings);
    for (const ParameterSpec& p : spec_.parameters) {
      validate_texts(p.source, "settings", p.settings);
      for (const ChoiceSpec& choice : p.choices) validate_texts(p.source, "settings", choice.settings);
    }
    for (const ParameterSpec& p : spec_.parameters)
      if (p.is_drawn() && used.count(p.name) == 0 && p.settings.empty() &&
          std::all_of(p.choices.begin(), p.choices.end(),
                      [](const ChoiceSpec& c) { return c.settings.empty() && c.scene.empty(); }))
        wrong(code::kMissingKey, p.source, "settings",
              "are missing, and no {= formula} uses \"" + p.name + "\", which has no effect");
    for (const MetricSpec& m : spec_.metrics)
      if (!values.emplace(formula_name(m.name), 1.0).second)
        wrong(code::kDuplicateName, m.source, "name",
              "\"" + formula_name(m.name) + "\" in formulas is taken by another figure or parameter");
    std::set<std::string> outcomes;
    for (const OutcomeSpec& o : spec_.outcomes) {
      if (o.at_most && !(*o.at_most > 0.0 && *o.at_most < 1.0))
        wrong(code::kOutOfRange, o.source, "at_most", "expected a probability between 0 and 1, without the ends");
      if (!outcomes.insert(o.name).second)
        wrong(code::kDuplicateName, o.source, "name", "\"" + o.name + "\" is taken by another outcome");
      try {
        std::vector<std::string> known;
        for (const auto& [name, value] : values) known.push_back(name);
        bool good = true;
        for (const std::string& name : Expression::names_in(o.when)) {
          if (values.count(name) > 0) continue;
          good = false;
          wrong(code::kUnknownMetric, o.source, "when",
                "\"" + name + "\" is neither a figure nor a drawn parameter." + known_names("names", name, known));
        }
        if (good) Expression(o.when, values);
      } catch (const InputError& e) {
        findings_.coded_error(o.source, "when", e.what());
      }
    }
  }

  // Drawn, with numbers as values.
  void require_drawn(const Source& at, const std::string& key, const std::string& name,
                     const std::set<std::string>& drawn) {
    if (drawn.count(name) == 0)
      return wrong(code::kUnknownParameter, at, key,
                   "\"" + name + "\" is not one of [[parameters]] with a distribution." +
                       known_names("parameters", name, {drawn.begin(), drawn.end()}));
    const ParameterSpec& p = spec_.parameters[index_of(spec_.parameters, name)];
    for (const ChoiceSpec& choice : p.choices)
      if (!number_in(choice.name))
        return wrong(code::kWrongType, at, key,
                     "parameter \"" + name + "\" has the value \"" + choice.name + "\", expected numbers");
  }

  void require_outcome(const Source& at, const std::string& name) {
    if (spec_.outcomes.empty()) return wrong(code::kNeedsOtherKey, at, "outcome", "needs [[outcomes]]");
    if (!name.empty() && index_of(spec_.outcomes, name) < 0)
      wrong(code::kUnknownMetric, at, "outcome",
            "\"" + name + "\" is not one of [[outcomes]]." + known_names("outcomes", name, names_in(spec_.outcomes)));
  }

  void validate_runs() {
    if (spec_.curves.empty() && spec_.parameters.empty())
      wrong(code::kMissingKey, spec_.source, "", "expected [[parameters]] or [[curves]]");
    bool scenes = !spec_.curves.empty();  // each curve names one
    for (const CurveSpec& curve : spec_.curves) {
      scenes = scenes && !curve.scene.empty();
      if (curve.map.group.empty() == spec_.is_map())
        wrong(code::kConflictingKeys, curve.source, "group", "expected a group for all curves, or for none");
      if (!curve.map.columns.empty() && curve.reference.empty() && !spec_.reference)
        wrong(code::kNeedsOtherKey, curve.source, "columns", "have no reference to be compared with");
    }
    if (spec_.scene.empty() && !scenes) wrong(code::kMissingKey, spec_.source, "scene", "is missing");
    for (const ParameterSpec& parameter : spec_.parameters)
      if (!spec_.curves.empty() && !parameter.ensemble)
        wrong(code::kConflictingKeys, parameter.source, "ensemble",
              "is false, expected true: only ensembles are allowed with [[curves]]");
    if (!spec_.curves.empty() && !spec_.is_map() && spec_.metrics.empty())
      wrong(code::kMissingKey, spec_.source, "figures", "are missing");
  }

  void validate_metrics() {
    for (const MetricSpec& f : spec_.metrics) {
      validate_source(f);
      if (f.compares_curves() && f.columns.empty()) wrong(code::kMissingKey, f.source, "columns", "are missing");
      if (f.compares_curves() && !spec_.reference)
        wrong(code::kNeedsOtherKey, f.source, "error", "compares with [reference], which is missing");
      if (f.average && f.columns.size() < 2)
        wrong(code::kWrongCount, f.source, "average", "is true, expected at least two columns");
    }
    for (const LimitSpec& limit : spec_.limits) require_metric(limit.source, "figure", limit.metric);
    if (!spec_.minimise.empty()) require_metric(spec_.source, "minimise", spec_.minimise);
  }

  void validate(const CheckSpec& s, const std::vector<std::string>& cases) {
    require_metric(s.source, "figure", s.metric);
    if (!s.curve.empty() && index_of(spec_.curves, s.curve) < 0)
      wrong(code::kUnknownCurve, s.source, "curve",
            "unknown curve \"" + s.curve + "\"." + known_names("curves", s.curve, names_in(spec_.curves)));
    for (const std::string& name : {s.of_case, s.against})
      if (!name.empty() && !is_in(cases, name))
        wrong(code::kUnknownCurve, s.source, "case",
              "unknown case \"" + name + "\"." + known_names("cases", name, cases));
  }

  void validate(const FitSpec& fit) {
    require_metric(fit.source, "figure", fit.metric);
    if (!fit.marks.empty()) parameter(fit.source, "marks", fit.marks);
    for (const auto& [name, value] : fit.where)
      if (const ParameterSpec* p = parameter(fit.source, "where", name); p && index_of(p->choices, value) < 0)
        wrong(code::kNotAValue, fit.source, "where", "parameter \"" + name + "\" has no value \"" + value + "\"");
    for (const FitFactor& factor : fit.factors) {
      for (const auto& [who, exponent] : factor.published)
        if (!number_in(exponent))
          wrong(code::kWrongType, factor.source, "published." + who, "is \"" + exponent + "\", expected a number");
      for (const std::string& name : factor.sum) {
        if (index_of(spec_.metrics, name) >= 0) continue;
        const ParameterSpec* p = parameter(factor.source, "sum", name);
        for (const std::string& value : p ? names_in(p->choices) : std::vector<std::string>())
          if (!number_in(value))
            wrong(code::kWrongType, factor.source, "sum",
                  "parameter \"" + name + "\" has the value \"" + value + "\", expected numbers in a power law");
      }
    }
  }

  // Null after a finding.
  const ParameterSpec* parameter(const Source& at, const std::string& key, const std::string& name) {
    const int k = index_of(spec_.parameters, name);
    if (k >= 0) return &spec_.parameters[k];
    wrong(code::kUnknownParameter, at, key,
          "\"" + name + "\" is not one of [[parameters]]" + (key == "sum" ? ", nor of [[figures]]." : ".") +
              known_names("parameters", name, names_in(spec_.parameters)));
    return nullptr;
  }
};

}  // namespace

bool is_formula_name(const std::string& name) {
  return !name.empty() && !std::isdigit(static_cast<unsigned char>(name.front())) &&
         std::all_of(name.begin(), name.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
}

std::string formula_name(const std::string& name) {
  std::string text = trimmed(name.substr(0, name.find('[')));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ' ' || c == '-' || c == '.'; }, '_');
  return text;
}

std::string exact_text(double value) {
  std::string text;
  for (int digits = 15; digits <= 17; ++digits)
    if (text = number_text(value, digits); read_number(text.c_str(), nullptr) == value) break;
  return text;
}

std::set<std::string> names_in_formulas(const std::vector<std::string>& texts) {
  std::set<std::string> names;
  for (const std::string& text : texts)
    for (std::size_t at = text.find(kFormulaMark); at != std::string::npos; at = text.find(kFormulaMark, at + 1)) try {
        for (const std::string& name : Expression::names_in(text.substr(at + 2, text.find('}', at) - at - 2)))
          names.insert(name);
      } catch (const InputError&) {  // with_formulas reports it
      }
  return names;
}

std::vector<std::string> with_formulas(std::vector<std::string> texts, std::map<std::string, double>& values,
                                       std::string (*written)(double)) {
  std::vector<std::string> known;
  for (const auto& [name, value] : values) known.push_back(name);
  for (std::string& text : texts)
    for (std::size_t at = text.find(kFormulaMark); at != std::string::npos; at = text.find(kFormulaMark)) {
      const std::size_t end = text.find('}', at);
      if (end == std::string::npos)
        throw InputError(code::kStudyFormula, "\"" + text + "\": a formula begins with {= and lacks the closing }");
      const std::string formula = trimmed(text.substr(at + 2, end - at - 2));
      for (const std::string& name : Expression::names_in(formula))
        if (values.find(name) == values.end())
          throw InputError(code::kStudyFormula, "\"" + formula + "\": unknown parameter \"" + name + "\"." +
                                                    known_names("parameters", name, known));
      text.replace(at, end + 1 - at, written(Expression(formula, values).value()));
    }
  return texts;
}

SweepSpec read_sweep_file(const std::string& file) {
  Findings findings(file);
  SweepSpec s = read_study<SweepSpec>(file, "a sweep file", "inputs/sweeps and inputs/accuracy", findings);
  for (CheckSpec& check_spec : s.expected) {
    check_spec.must = true;
    s.checks.push_back(check_spec);
  }
  SweepValidator validator(s, findings);
  validator.complete();
  validator.validate();
  return s;
}

}  // namespace footfall

#include "mbd_solver/cli/experiments/section_reader.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "mbd_solver/cli/experiments/runs.h"
#include "mbd_solver/cli/experiments/text.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {
namespace {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& entry : list) names.push_back(entry.name);
  return names;
}

void read_factor(TableReader& t, FitFactor& factor) {
  t.take("name", factor.name);
  t.require("name", !factor.name.empty());
  factor.sum = {factor.name};
  t.take("sum", factor.sum);
  t.require("sum", !factor.sum.empty());
  factor.line = t.line();
  const ConfigNode* published = t.next("published");
  if (!published) return;
  if (published->kind != ConfigNode::Kind::kTable)
    t.fail(*published, "published", "is " + published->description() + ", expected { Name = exponent }");
  for (const auto& [who, exponent] : published->table) {
    if (!exponent.is_number())
      t.fail(exponent, "published." + who, "is " + exponent.description() + ", expected a number");
    factor.published.emplace_back(who, exponent.number);
  }
}

void check_fit(const ExperimentSpec& spec, const FitSpec& fit) {
  const auto fail = [&](int line, const std::string& key, const std::string& what) {
    throw InputError(spec.file + ":" + std::to_string(line) + ": fits." + key + ": " + what);
  };
  const auto parameter = [&](const std::string& name) {
    const int k = index_of(spec.parameters, name);
    return k < 0 ? nullptr : &spec.parameters[static_cast<std::size_t>(k)];
  };
  if (index_of(spec.figures, fit.figure) < 0)
    fail(fit.line, "figure", "\"" + fit.figure + "\" is not one of [[figures]]");
  if (!fit.marks.empty() && !parameter(fit.marks))
    fail(fit.line, "marks", "\"" + fit.marks + "\" is not one of [[parameters]]");
  for (const auto& [name, value] : fit.where) {
    if (!parameter(name)) fail(fit.line, "where", "\"" + name + "\" is not one of [[parameters]]");
    if (index_of(parameter(name)->choices, value) < 0)
      fail(fit.line, "where", "parameter \"" + name + "\" has no value \"" + value + "\"");
  }
  for (const FitFactor& factor : fit.factors) {
    for (const std::string& name : factor.sum) {
      if (index_of(spec.figures, name) >= 0) continue;
      if (!parameter(name))
        fail(factor.line, "factors.sum", "\"" + name + "\" is neither one of [[parameters]] nor one of [[figures]]");
      for (const ChoiceSpec& choice : parameter(name)->choices)
        if (!number_in(choice.name))
          fail(factor.line, "factors.sum",
               "parameter \"" + name + "\" has the value \"" + choice.name + "\", expected numbers in a power law");
    }
  }
}

}  // namespace

void read_figure(TableReader& t, FigureSpec& f) {
  t.take("name", f.name, "key", f.key, "columns", f.columns);
  t.take_one_of("reduce", f.reduction,
                {{"max", Reduction::kMax},
                 {"min", Reduction::kMin},
                 {"final", Reduction::kFinal},
                 {"largest", Reduction::kLargest},
                 {"drop", Reduction::kDrop},
                 {"peaks", Reduction::kPeaks},
                 {"variation", Reduction::kVariation}});
  t.take("average", f.average, "prominence", f.prominence, "over", f.over);
  t.take_one_of("error", f.error,
                {{"relative", ErrorKind::kRelative},
                 {"rms", ErrorKind::kRms},
                 {"final", ErrorKind::kFinal},
                 {"itself", ErrorKind::kItself}});
  t.take("until", f.until);
  t.require("name", !f.name.empty());
  if (f.key.empty() == f.columns.empty())
    t.fail("key", "expected either key (of summary.json) or columns (of history.csv)");
  if (f.compares_curves()) t.require("columns", !f.columns.empty());
  if (f.average && f.columns.size() < 2)
    t.fail(*t.next("average"), "average", "is true, expected at least two columns to take the mean of");
}

void read_printed(TableReader& t, PrintedSpec& p) {
  t.take("name", p.name, "values", p.values);
  t.require("name", !p.name.empty());
}

void read_statement(TableReader& t, StatementSpec& s) {
  std::vector<double> order;
  t.take("text", s.text, "figure", s.figure, "case", s.of_case, "against", s.against, "why", s.why, "least", s.least,
         "most", s.most, "curve", s.curve, "order", order);
  const bool error = t.next("error") != nullptr;
  t.require("figure", !s.figure.empty());
  if (s.curve.empty()) {
    t.require("text", !s.text.empty());
    t.require("case", !s.of_case.empty());
    if (std::isinf(s.least) && std::isinf(s.most)) t.fail("least", "expected least, most or both");
    return;
  }
  if (order.empty() != error) t.fail("curve", "expected order = [least, most] or error = most");
  if (error) {
    s.kind = StatementSpec::Kind::kError;
    t.take("error", s.most);
  } else {
    s.kind = StatementSpec::Kind::kOrder;
    if (order.size() != 2) t.fail(*t.next("order"), "order", "expected [least, most]");
    s.least = order[0];
    s.most = order[1];
  }
  if (s.text.empty()) s.text = s.curve + ", " + s.figure;
}

void read_plot(TableReader& t, PlotSpec& p) {
  t.take("title", p.title, "column", p.column, "label", p.label);
  t.take_file_name("name", p.name);
  t.require("column", !p.column.empty());
}

void read_fit(TableReader& t, FitSpec& fit) {
  t.take_file_name("name", fit.name);
  t.take("figure", fit.figure);
  fit.label = fit.figure;
  t.take("label", fit.label, "marks", fit.marks);
  if (const ConfigNode* where = t.next("where")) {
    TableReader values(t.file(), "fits.where", *where);
    for (const auto& [parameter, value] : where->table)
      values.take(parameter, fit.where.emplace_back(parameter, "").second);
  }
  t.take_list("factors", fit.factors, read_factor);
  t.require("figure", !fit.figure.empty());
  t.require("factors", !fit.factors.empty());
  fit.line = t.line();
}

void check_sections(const TableReader& t, const ExperimentSpec& spec) {
  const auto check_figure = [&](const std::string& section, const std::string& name) {
    if (index_of(spec.figures, name) < 0) t.fail(section, "figure \"" + name + "\" is not one of [[figures]]");
  };
  for (const FigureSpec& f : spec.figures)
    if (f.compares_curves() && !spec.reference)
      t.fail("reference", "is missing; figure \"" + f.name + "\" compares with it");
  for (const LimitSpec& limit : spec.limits) check_figure("limits", limit.figure);
  if (!spec.minimise.empty()) check_figure("minimise", spec.minimise);
  for (const PrintedSpec& printed : spec.printed)
    if (printed.values.size() > spec.figures.size())
      t.fail("printed", "\"" + printed.name + "\" has more values than there are [[figures]]");
  std::vector<std::string> cases;
  for (const PlannedCase& c : plan_of(spec, false).cases) cases.push_back(c.name);
  for (const StatementSpec& s : spec.statements) {
    const std::string section = s.must ? "expect" : "statements";
    check_figure(section, s.figure);
    if (!s.curve.empty() && index_of(spec.curves, s.curve) < 0)
      t.fail(section, "unknown curve \"" + s.curve + "\"" + known_names("curves", s.curve, names_of(spec.curves)));
    for (const std::string& name : {s.of_case, s.against})
      if (!name.empty() && std::find(cases.begin(), cases.end(), name) == cases.end())
        t.fail(section, "there is no case \"" + name + "\"" + known_names("cases", name, cases));
  }
  for (const FitSpec& fit : spec.fits) check_fit(spec, fit);
}

}  // namespace footfall

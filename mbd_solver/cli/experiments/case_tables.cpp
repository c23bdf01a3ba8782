#include "mbd_solver/cli/experiments/case_tables.h"

#include <cmath>

#include "coupler/base/text.h"

namespace footfall {

namespace {

std::string word_of(const Outcome& outcome) {
  return std::isnan(outcome.judged) ? "not run" : outcome.came_out ? "yes" : "no";
}

const std::string& about(const StatementSpec& s) { return s.curve.empty() ? s.of_case : s.curve; }

}  // namespace

Table run_table(const ExperimentSpec& spec, const Plan& plan, const Results& results) {
  const bool named = !spec.curves.empty();
  std::vector<std::string> head = {"run"};
  if (named) head.push_back("name");
  append(head, names_in(spec.parameters));
  head.push_back("status");
  append(head, names_in(spec.figures));
  Table table(head);
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    std::vector<std::string> row = {std::to_string(i)};
    if (named) row.push_back(plan.runs[i].name);
    append(row, plan.runs[i].values);
    row.push_back(results.runs[i].end.status);
    for (const double value : results.runs[i].figures) row.push_back(cell(value));
    table.add(row);
  }
  return table;
}

Table case_table(const ExperimentSpec& spec, const std::vector<CaseResult>& cases) {
  std::vector<std::string> head = {"case", "runs", "within_limits"};
  for (const FigureSpec& figure : spec.figures) append(head, {figure.name, "spread of " + figure.name});
  Table table(head);
  for (const CaseResult& c : cases) {
    std::vector<std::string> row = {c.plan.name, std::to_string(c.done.size()), c.within_limits ? "yes" : "no"};
    for (const SampledFigure& f : c.figures) append(row, {cell(f.mean), cell(f.spread)});
    table.add(row);
  }
  return table;
}

std::string case_page(const ExperimentSpec& spec, const std::vector<CaseResult>& cases) {
  const bool limits = !spec.limits.empty();
  std::vector<std::string> head = {spec.title};
  append(head, names_in(spec.figures));
  if (limits) head.push_back("within the limits");
  Table table(head);
  for (const PrintedSpec& printed : spec.printed) {
    std::vector<std::string> row = {printed.name};
    for (const std::string& value : printed.values) row.push_back(value.empty() ? "" : rounded(*number_in(value)));
    row.resize(head.size());
    table.add(row);
  }
  for (const CaseResult& c : cases) {
    std::vector<std::string> row = {c.plan.name};
    for (const SampledFigure& f : c.figures)
      row.push_back(rounded(f.mean) + (c.done.size() > 1 ? " +- " + rounded(f.spread) : ""));
    if (limits) row.push_back(c.within_limits ? "yes" : "no");
    table.add(row);
  }
  return "Made by `./footfall sweep " + spec.file + "`.\n\n" + table.page();
}

Table statement_table(const ExperimentSpec& spec, const std::vector<Outcome>& outcomes) {
  Table table({"statement", "figure", "case", "value", "against", "reference", "judged", "least", "most", "came_out"});
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const StatementSpec& s = spec.statements[i];
    const Outcome& o = outcomes[i];
    table.add({s.text, s.figure, about(s), cell(o.value), s.against, cell(o.reference), cell(o.judged), cell(s.least),
               cell(s.most), word_of(o)});
  }
  return table;
}

std::string statement_page(const ExperimentSpec& spec, const std::vector<Outcome>& outcomes) {
  Table table({"statement", "numbers", "expected", "came out"});
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const StatementSpec& s = spec.statements[i];
    const Outcome& o = outcomes[i];
    std::string numbers = s.figure + ": " + about(s) + " " + rounded(o.value);
    if (!s.against.empty()) numbers += ", " + s.against + " " + rounded(o.reference) + ", ratio " + rounded(o.judged);
    std::vector<std::string> bounds;
    if (std::isfinite(s.least)) bounds.push_back("at least " + rounded(s.least));
    if (std::isfinite(s.most)) bounds.push_back("at most " + rounded(s.most));
    const std::string why = word_of(o) == "no" && !s.why.empty() ? ": " + s.why : "";
    table.add({s.text, numbers, joined(bounds, " "), word_of(o) + why});
  }
  return table.page();
}

}  // namespace footfall

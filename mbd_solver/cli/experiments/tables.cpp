#include "mbd_solver/cli/experiments/tables.h"

#include <cmath>
#include <filesystem>
#include <sstream>

#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/experiments/text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// As in a table that people read.
std::string rounded(double value) { return cell(std::abs(value) < 1e-9 ? 0.0 : value, 3); }

}  // namespace

void write_run_table(const std::string& path, const ExperimentSpec& spec, const Plan& plan, const Results& results) {
  std::ostringstream out;
  out << "run" << (spec.curves.empty() ? "" : ",name");
  for (const ParameterSpec& parameter : spec.parameters) out << ',' << csv_field(parameter.name);
  out << ",status";
  for (const FigureSpec& figure : spec.figures) out << ',' << csv_field(figure.name);
  out << '\n';
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    out << i;
    if (!spec.curves.empty()) out << ',' << csv_field(plan.runs[i].name);
    for (const std::string& value : plan.runs[i].values) out << ',' << csv_field(value);
    out << ',' << results.runs[i].end.status;
    for (const double value : results.runs[i].figures) out << ',' << cell(value);
    out << '\n';
  }
  write_whole_file(path, out.str());
}

void write_case_table(const std::string& path, const ExperimentSpec& spec, const std::vector<CaseResult>& cases) {
  std::ostringstream out;
  out << "case,runs,within_limits";
  for (const FigureSpec& figure : spec.figures)
    out << ',' << csv_field(figure.name) << ',' << csv_field("spread of " + figure.name);
  out << '\n';
  for (const CaseResult& c : cases) {
    out << csv_field(c.plan.name) << ',' << c.done.size() << ',' << (c.within_limits ? "yes" : "no");
    for (const SampledFigure& f : c.figures) out << ',' << cell(f.mean) << ',' << cell(f.spread);
    out << '\n';
  }
  write_whole_file(path, out.str());
}

void write_case_page(const std::string& path, const ExperimentSpec& spec, const std::vector<CaseResult>& cases) {
  std::ostringstream out;
  out << "Made by `./footfall sweep " << spec.file << "`.\n\n| " << spec.title << " |";
  for (const FigureSpec& figure : spec.figures) out << ' ' << figure.name << " |";
  out << (spec.limits.empty() ? "\n|---|" : " within the limits |\n|---|");
  for (std::size_t k = 0; k < spec.figures.size(); ++k) out << "---|";
  out << (spec.limits.empty() ? "\n" : "---|\n");
  for (const PrintedSpec& printed : spec.printed) {
    out << "| " << printed.name << " |";
    for (std::size_t k = 0; k < spec.figures.size(); ++k)
      out << ' ' << (k < printed.values.size() ? rounded(printed.values[k]) : "") << " |";
    out << (spec.limits.empty() ? "\n" : " |\n");
  }
  for (const CaseResult& c : cases) {
    out << "| " << c.plan.name << " |";
    for (const SampledFigure& f : c.figures) {
      out << ' ' << rounded(f.mean);
      if (c.done.size() > 1) out << " +- " << rounded(f.spread);
      out << " |";
    }
    out << (spec.limits.empty() ? "\n" : c.within_limits ? " yes |\n" : " no |\n");
  }
  write_whole_file(path, out.str());
}

void write_statements(const std::string& folder, const ExperimentSpec& spec, const std::vector<Outcome>& outcomes) {
  if (outcomes.empty()) return;
  std::ostringstream csv, page;
  csv << "statement,figure,case,value,against,reference,judged,least,most,came_out\n";
  page << "| statement | numbers | expected | came out |\n|---|---|---|---|\n";
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const StatementSpec& s = spec.statements[i];
    const Outcome& o = outcomes[i];
    const std::string about = s.curve.empty() ? s.of_case : s.curve;
    csv << csv_field(s.text) << ',' << csv_field(s.figure) << ',' << csv_field(about) << ',' << cell(o.value) << ','
        << csv_field(s.against) << ',' << cell(o.reference) << ',' << cell(o.judged) << ',' << cell(s.least) << ','
        << cell(s.most) << ','
        << (std::isnan(o.judged) ? "not run"
            : o.came_out         ? "yes"
                                 : "no")
        << '\n';
    page << "| " << s.text << " | " << s.figure << ": " << about << " " << rounded(o.value);
    if (!s.against.empty()) page << ", " << s.against << " " << rounded(o.reference) << ", ratio " << rounded(o.judged);
    page << " |";
    if (std::isfinite(s.least)) page << " at least " << rounded(s.least);
    if (std::isfinite(s.most)) page << " at most " << rounded(s.most);
    page << " | "
         << (!std::isfinite(o.judged) ? "not run"
             : o.came_out             ? "yes"
             : s.why.empty()          ? "no"
                                      : "no: " + s.why)
         << " |\n";
  }
  write_whole_file((fs::path(folder) / "statements.csv").string(), csv.str());
  write_whole_file((fs::path(folder) / "statements.md").string(), page.str());
}

}  // namespace footfall

#include "mbd_solver/cli/rigs/rig_output.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/quote.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/experiments/power_law.h"
#include "mbd_solver/cli/experiments/table.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr double kAsked = 0.95, kMoved = 0.05;
constexpr int kSampleDigits = 8;

std::string answer_text(double value) { return std::isfinite(value) ? number_text(value, 4) : "not found"; }

// "+12 %", beside the mean of the rig itself.
std::string moved_by(double mean, double own) {
  if (!std::isfinite(mean) || !std::isfinite(own) || own == 0.0) return "not found";
  const double share = (mean - own) / std::abs(own);
  return (share < 0.0 ? "" : "+") + share_text(share) + (std::abs(share) > kMoved ? ", moved" : "");
}

Table answer_table(const std::vector<RigVariant>& variants) {
  std::vector<std::string> head = {"answer", "unit", "mean", "95 % interval: +-", "samples"};
  for (std::size_t v = 1; v < variants.size(); ++v) head.push_back(variants[v].name);
  Table table(head);
  const std::vector<RigAnswer>& answers = variants.front().samples.front().answers;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const RigStatistic own = statistic_of(variants.front().samples, i);
    std::vector<std::string> row = {answers[i].name, answers[i].unit, answer_text(own.mean),
                                    std::isfinite(own.interval) ? number_text(own.interval, 2) : "",
                                    std::to_string(own.samples)};
    for (std::size_t v = 1; v < variants.size(); ++v)
      row.push_back(moved_by(statistic_of(variants[v].samples, i).mean, own.mean));
    table.add(row);
  }
  return table;
}

// A row for each sample of the bed and each check: what the means are made of. Empty: not found.
Table sample_table(const std::vector<RigVariant>& variants) {
  std::vector<std::string> head = {"check", "sample"};
  for (const RigAnswer& answer : variants.front().samples.front().answers) head.push_back(answer.name);
  Table table(head);
  for (const RigVariant& variant : variants)
    for (std::size_t k = 0; k < variant.samples.size(); ++k) {
      std::vector<std::string> row = {variant.name.empty() ? "none" : variant.name, std::to_string(k + 1)};
      for (const RigAnswer& answer : variant.samples[k].answers)
        row.push_back(std::isfinite(answer.value) ? number_text(answer.value, kSampleDigits) : "");
      table.add(row);
    }
  return table;
}

// A bound lies within the interval. R^2 and the like cannot pass 1, so that bound is none.
bool is_open(const RigClaim& claim, const RigStatistic& s) {
  if (!std::isfinite(s.interval)) return false;
  const auto holds = [&](double bound) { return std::abs(bound - s.mean) < s.interval; };
  return holds(claim.least) || (claim.most != 1.0 && holds(claim.most));
}

std::string claim_lines(const Rig& rig, const RigVariant& own) {
  std::string text;
  const std::vector<RigAnswer>& answers = own.samples.front().answers;
  for (const RigClaim& claim : rig.claims) {
    const auto found =
        std::find_if(answers.begin(), answers.end(), [&](const RigAnswer& a) { return a.name == claim.answer; });
    FOOTFALL_DEMAND(found != answers.end());
    const RigStatistic s = statistic_of(own.samples, static_cast<std::size_t>(found - answers.begin()));
    const bool so = s.mean >= claim.least && s.mean <= claim.most;
    text += "| " + claim.text + " (" + claim.source + ") | " + number_text(claim.least) + " to " +
            number_text(claim.most) + " | " + answer_text(s.mean) +
            (std::isfinite(s.interval) ? " +- " + number_text(s.interval, 2) : "") + " | " + (so ? "yes" : "no") +
            (is_open(claim, s) ? ", but the interval leaves it open" : "") + " |\n";
  }
  return text.empty() ? text : "\n| law | asked | found | met |\n|---|---|---|---|\n" + text;
}

// All curves of the rig itself below each other, a blank line between two.
std::string draw_curves(const Rig& rig, const RigVariant& own, const std::string& folder, const std::string& title) {
  Table table({"curve", "x", "y"});
  std::vector<std::string> lines;
  std::size_t row = 0;
  const std::string file = std::string(rig.name) + "_curves.csv";
  for (std::size_t k = 0; k < own.samples.size(); ++k) {
    for (std::size_t c = 0; c < own.samples[k].curves.size(); ++c) {
      const RigCurve& curve = own.samples[k].curves[c];
      if (curve.x.empty()) continue;
      const bool line = std::is_sorted(curve.x.begin(), curve.x.end());
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        table.add({curve.name, number_text(curve.x[i], 8), number_text(curve.y[i], 8)});
      lines.push_back(gnuplot_text(file) + " every ::" + std::to_string(row) +
                      "::" + std::to_string(row + curve.x.size() - 1) + " using 2:3 with " + (line ? "lines" : "") +
                      "points ps 0.8 pt " + std::to_string(c + 1) + " lc " + std::to_string(c + 1) +
                      (k == 0 ? " title " + gnuplot_text(curve.name) : " notitle"));
      row += curve.x.size();
    }
  }
  write_whole_file((fs::path(folder) / file).string(), table.csv());
  if (lines.empty()) return "";
  const std::string drawing = "set grid\nset title " + gnuplot_text(title) + " noenhanced\nset xlabel " +
                              gnuplot_text(rig.x_label) + " noenhanced\nset ylabel " + gnuplot_text(rig.y_label) +
                              " noenhanced\nset key outside below noenhanced\nplot " + joined(lines, ", ") + "\n";
  try {
    return joined(run_gnuplot(folder, {write_drawing(folder, rig.name, {900, 620}, kCsv, drawing)}), "\n") + "\n";
  } catch (const InputError& e) {
    std::fprintf(stderr, "footfall: warning: no picture: %s\n", e.what());
    return "";
  }
}

}  // namespace

RigStatistic statistic_of(const std::vector<RigSample>& samples, std::size_t answer) {
  RigStatistic s;
  s.mean = s.interval = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values;
  for (const RigSample& sample : samples)
    if (answer < sample.answers.size() && std::isfinite(sample.answers[answer].value))
      values.push_back(sample.answers[answer].value);
  s.samples = static_cast<int>(values.size());
  if (values.empty()) return s;
  double sum = 0.0, squares = 0.0;
  for (const double value : values) sum += value;
  s.mean = sum / s.samples;
  for (const double value : values) squares += (value - s.mean) * (value - s.mean);
  if (s.samples > 1) s.interval = student_t(kAsked, s.samples - 1) * std::sqrt(squares / (s.samples - 1) / s.samples);
  return s;
}

void write_rig(const Rig& rig, const std::vector<RigVariant>& variants, const std::string& folder,
               const std::string& title, const std::string& command, bool verdicts) {
  const Table table = answer_table(variants);
  const auto path = [&](const std::string& end) { return (fs::path(folder) / (rig.name + end)).string(); };
  std::string page = "## " + title + "\n\nMade by `" + command + "`.\n\n" + table.page();
  if (verdicts) page += claim_lines(rig, variants.front());
  write_whole_file(path(".csv"), table.csv());
  write_whole_file(path("_samples.csv"), sample_table(variants).csv());
  write_whole_file(path(".md"), page);
  std::printf("%s\n", page.c_str());
  const std::string pictures = draw_curves(rig, variants.front(), folder, title);
  std::printf("%s\n%s%s\n", path(".md").c_str(), pictures.c_str(), path(".csv").c_str());
}

}  // namespace footfall

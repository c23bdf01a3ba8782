// Markdown tables with a row per outcome or figure and case; pictures from CSV files.
#include "mbd_solver/campaign/campaign_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/view_page.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/launch/programs.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr double kGoodChaos = 0.8;  // least explained variance with which Sobol' indices are shown

std::string interval_text(const std::string& value, const Probability& p) {
  return value + " (" + number_text(100.0 * p.low, 3) + " to " + number_text(100.0 * p.high, 3) + ")";
}

std::string share_with_interval(const Probability& p) { return interval_text(number_text(100.0 * p.value, 3), p); }

// Unknown runs give a range instead of a number.
std::string share_with_interval(const Tally& tally) {
  const std::string least = number_text(100.0 * tally.least(), 3), most = number_text(100.0 * tally.most(), 3);
  return interval_text(tally.unknown > 0 ? least + " to " + most : least, tally.probability());
}

std::size_t place_of_outcome(const SweepSpec& spec, const std::string& name) {
  return name.empty() ? 0 : static_cast<std::size_t>(index_of(spec.outcomes, name));
}

// Place among the drawn parameters.
std::size_t drawn_place(const Campaign& campaign, const std::string& name) {
  const std::vector<std::size_t>& all = campaign.draws().parameters();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (campaign.spec().parameters[all[k]].name == name) return k;
  FOOTFALL_DEMAND(false);
  return 0;
}

}  // namespace

std::vector<std::size_t> rows_of_case(const Campaign& campaign, std::size_t which_case) {
  std::vector<std::size_t> rows;
  for (std::size_t draw = 0; draw < campaign.used(); ++draw)
    if (const std::size_t row = draw * campaign.cases() + which_case; !campaign.row(row).metrics.empty())
      rows.push_back(row);
  return rows;
}

Boundary boundary_of(const Campaign& campaign, const EnvelopeSpec& envelope, std::size_t which_case) {
  const bool two = !envelope.y.empty();
  const std::size_t outcome = place_of_outcome(campaign.spec(), envelope.outcome);
  const std::size_t x = drawn_place(campaign, envelope.x), y = two ? drawn_place(campaign, envelope.y) : x;
  std::vector<Boundary::Point> points;
  std::vector<int> happened;
  for (const std::size_t row : rows_of_case(campaign, which_case)) {
    if (campaign.row(row).outcomes[outcome] < 0) continue;
    const std::size_t draw = campaign.draw_of(row);
    points.push_back({campaign.drawn_number(draw, x), two ? campaign.drawn_number(draw, y) : 0.0});
    happened.push_back(campaign.row(row).outcomes[outcome]);
  }
  return {points, happened, two, envelope.level};
}

std::vector<double> chances(const Campaign& campaign, std::size_t outcome, const std::vector<std::size_t>& rows) {
  const std::size_t width = campaign.draws().parameters().size();
  // Squares as well, if there are enough runs for them.
  const bool squares = rows.size() > 20 * (1 + 2 * width);
  Eigen::MatrixXd x(rows.size(), 1 + (squares ? 2 : 1) * width);
  Eigen::VectorXd y(x.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    x(at, 0) = 1.0;
    for (std::size_t k = 0; k < width; ++k) {
      const double u = 2.0 * campaign.draws().positions(campaign.draw_of(rows[i]))[k] - 1.0;
      x(at, 1 + k) = u;
      if (squares) x(at, 1 + width + k) = u * u;
    }
    y[at] = campaign.row(rows[i]).outcomes[outcome] > 0 ? 1.0 : 0.0;
  }
  const Logistic fit = fit_logistic(x, y);
  std::vector<double> p;
  for (Eigen::Index i = 0; i < x.rows(); ++i) p.push_back(fit.probability(x.row(i)));
  return p;
}

// ---- tables ----

Table campaign_table(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  std::vector<std::string> head = {"row"};
  for (const bool drawn : {false, true})
    for (const ParameterSpec& p : spec.parameters)
      if (p.is_drawn() == drawn) head.push_back(p.name);
  head.push_back("seed");
  append(head, names_in(spec.metrics));
  append(head, names_in(spec.outcomes));
  append(head, {"code", "message"});
  Table table(head);
  for (std::size_t row = 0; row < campaign.used() * campaign.cases(); ++row) {
    const CampaignRow& r = campaign.row(row);
    std::vector<std::string> cells = {std::to_string(row)};
    append(cells, campaign.case_values(row));
    append(cells, campaign.drawn_values(row));
    cells.push_back(std::to_string(campaign.draws().seed(campaign.draw_of(row))));
    for (std::size_t k = 0; k < spec.metrics.size(); ++k)
      cells.push_back(r.metrics.empty() ? "" : cell(r.metrics[k], 17));
    for (const int outcome : r.outcomes) cells.push_back(outcome < 0 ? "" : std::to_string(outcome));
    append(cells, {std::to_string(r.code), r.message});
    table.add(cells);
  }
  return table;
}

namespace {

// The values of a metric over the rows of a case, sorted.
std::vector<double> sorted_metric(const Campaign& campaign, std::size_t which_case, std::size_t metric) {
  std::vector<double> values;
  for (const std::size_t row : rows_of_case(campaign, which_case))
    if (std::isfinite(campaign.row(row).metrics[metric])) values.push_back(campaign.row(row).metrics[metric]);
  std::sort(values.begin(), values.end());
  return values;
}

// "E0123" of a message that ends with its code.
std::string message_code(const std::string& message) {
  const std::size_t start = message.rfind('[');
  return has_code(message) ? message.substr(start + 1, message.find(' ', start) - start - 1) : "no code";
}

// Values that are not known may be less than all others or larger: both bounds are widened by their number.
std::string quantile_text(const std::vector<double>& sorted, std::size_t unknown, double share) {
  if (sorted.empty()) return "";
  const auto [low, high] = quantile_bounds(sorted.size() + unknown, share);
  const auto bound = [&](long k) {
    return k < 0 || k >= static_cast<long>(sorted.size()) ? "?" : number_text(sorted[k], 4);
  };
  return number_text(quantile(sorted, share), 4) + " (" + bound(low - static_cast<long>(unknown)) + " to " +
         bound(high) + ")";
}

// Unknown runs count as if the outcome had happened.
double bound_of(const Tally& tally) {
  return upper_bound(static_cast<double>(tally.hits + tally.unknown), static_cast<double>(tally.runs()));
}

Table probability_table(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  Table table({"outcome", "case", "happened", "did not", "unknown", "probability [%] (95 % interval)",
               "with 95 % confidence at most [%]"});
  for (std::size_t k = 0; k < spec.outcomes.size(); ++k)
    for (std::size_t c = 0; c < campaign.cases(); ++c) {
      const Tally& tally = campaign.tally(c, k);
      table.add({spec.outcomes[k].name, campaign.case_name(c), std::to_string(tally.hits), std::to_string(tally.misses),
                 std::to_string(tally.unknown), share_with_interval(tally), number_text(100.0 * bound_of(tally), 3)});
    }
  return table;
}

// With 95 % confidence at least 95 % of the distribution is below, or above, this value; "?": too few runs. Unknown values
// may be anywhere.
std::string tolerance_text(const std::vector<double>& sorted, std::size_t unknown, bool below) {
  const std::size_t place = tolerance_place(sorted.size() + unknown, kToleranceShare);
  if (place >= sorted.size()) return "?";
  return number_text(below ? sorted[place] : sorted[sorted.size() - 1 - place], 4);
}

// The first case and each other one, on the same draws.
Table pair_table(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  Table table({"outcome", "second case less \"" + campaign.case_name(0) + "\"", "both", "only first", "only second",
               "neither", "unknown", "difference of the probabilities [%] (95 % interval)", "McNemar p"});
  for (std::size_t k = 0; k < spec.outcomes.size(); ++k)
    for (std::size_t c = 1; c < campaign.cases(); ++c) {
      PairTally tally;
      for (std::size_t draw = 0; draw < campaign.used(); ++draw)
        tally.add(campaign.row(draw * campaign.cases()).outcomes[k],
                  campaign.row(draw * campaign.cases() + c).outcomes[k]);
      std::vector<std::string> cells = {spec.outcomes[k].name, campaign.case_name(c)};
      for (const long count : {tally.both, tally.first_only, tally.second_only, tally.neither, tally.unknown})
        cells.push_back(std::to_string(count));
      append(cells, {share_with_interval(tally.difference()), number_text(tally.chance(), 2)});
      table.add(cells);
    }
  return table;
}

// Differences draw by draw: their median, and how often the second case has the larger value.
Table paired_figures_table(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  Table table({"figure", "second case less \"" + campaign.case_name(0) + "\"", "pairs", "unknown",
               "median of the differences (95 % interval)", "mean", "second larger [%]"});
  for (std::size_t k = 0; k < spec.metrics.size(); ++k)
    for (std::size_t c = 1; c < campaign.cases(); ++c) {
      std::vector<double> differences;
      for (std::size_t draw = 0; draw < campaign.used(); ++draw) {
        const std::vector<double>& first = campaign.row(draw * campaign.cases()).metrics;
        const std::vector<double>& second = campaign.row(draw * campaign.cases() + c).metrics;
        if (!first.empty() && !second.empty() && std::isfinite(second[k] - first[k]))
          differences.push_back(second[k] - first[k]);
      }
      if (differences.empty()) continue;
      std::sort(differences.begin(), differences.end());
      const auto count = static_cast<double>(differences.size());
      const auto larger = std::count_if(differences.begin(), differences.end(), [](double d) { return d > 0.0; });
      const std::size_t unknown = campaign.used() - differences.size();
      table.add({spec.metrics[k].name, campaign.case_name(c), std::to_string(differences.size()),
                 std::to_string(unknown), quantile_text(differences, unknown, 0.5),
                 number_text(std::accumulate(differences.begin(), differences.end(), 0.0) / count, 4),
                 number_text(100.0 * static_cast<double>(larger) / count, 3)});
    }
  return table;
}

Table quantile_table(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  Table table({"figure", "case", "without a number", "5 %", "50 %", "95 %", "99 %",
               "95 % of runs are below (95 % confidence)", "95 % of runs are above (95 % confidence)"});
  for (std::size_t k = 0; k < spec.metrics.size(); ++k)
    for (std::size_t c = 0; c < campaign.cases(); ++c) {
      const std::vector<double> values = sorted_metric(campaign, c, k);
      const std::size_t unknown = campaign.used() - values.size();
      std::vector<std::string> cells = {spec.metrics[k].name, campaign.case_name(c), std::to_string(unknown)};
      for (const double share : {0.05, 0.5, 0.95, 0.99}) cells.push_back(quantile_text(values, unknown, share));
      append(cells, {tolerance_text(values, unknown, true), tolerance_text(values, unknown, false)});
      table.add(cells);
    }
  return table;
}

std::string distribution_text(const ParameterSpec& p) {
  const DistributionSpec& d = p.distribution;
  std::string text(name_of(*d.kind));
  for (const auto& [name, value] : {std::pair{"mean", d.mean},
                                    {"deviation", d.deviation},
                                    {"scale", d.scale},
                                    {"shape", d.shape},
                                    {"least", d.least},
                                    {"likely", d.likely},
                                    {"most", d.most}})
    if (value) text += ", " + std::string(name) + " " + exact_text(*value);
  if (!d.file.empty())
    text += ": " + std::to_string(d.measured.size()) + " values of " + d.file +
            (d.column.empty() ? "" : ", column " + d.column) + (d.whole_rows ? ", in whole rows" : "");
  std::vector<std::string> values;
  for (std::size_t k = 0; k < p.choices.size(); ++k)
    values.push_back(p.choices[k].name + (d.weights.empty() ? "" : " (weight " + exact_text(d.weights[k]) + ")"));
  return text + (values.empty() ? "" : ": " + joined(values, ", "));
}

Table input_table(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  Table table({"drawn parameter", "distribution", "settings"});
  for (const std::size_t k : campaign.draws().parameters())
    table.add(
        {spec.parameters[k].name, distribution_text(spec.parameters[k]), joined(spec.parameters[k].settings, "; ")});
  for (const CorrelationSpec& c : spec.correlations)
    table.add({joined(c.between, ", "), "rank correlation " + exact_text(c.rank) + ", normal copula", ""});
  return table;
}

Table outcome_table(const SweepSpec& spec) {
  Table table({"outcome", "happens when", "statement: probability below"});
  for (const OutcomeSpec& o : spec.outcomes) {
    std::vector<std::string> bounds;
    if (o.least) bounds.push_back("below " + exact_text(*o.least));
    if (o.most) bounds.push_back("above " + exact_text(*o.most));
    table.add({o.name, o.metric.empty() ? o.when : o.metric + " " + joined(bounds, " or "),
               o.at_most ? exact_text(*o.at_most) : ""});
  }
  return table;
}

Table origin_table(const Campaign& campaign, const std::string& command) {
  const SweepSpec& spec = campaign.spec();
  Table table({"of the campaign", ""});
  table.add({"command", "`" + command + "`"});
  table.add({"program", "footfall " FOOTFALL_VERSION ", OpenTURNS " + openturns_version()});
  table.add({"file", spec.file});
  std::set<std::string> scenes;
  for (std::size_t c = 0; c < campaign.cases(); ++c) scenes.insert(campaign.first_valid(c).first.scene);
  for (const std::string& scene : scenes) table.add({"scene", short_path(scene)});
  for (const std::string& setting : spec.settings) table.add({"setting", setting});
  table.add({"design, seed of the draws",
             std::string(name_of(spec.design)) + ", " + std::to_string(spec.seed) + " (seeds of runs: runs.csv)"});
  table.add({"draws, cases", std::to_string(campaign.used()) + " of " + std::to_string(campaign.draws().count()) +
                                 ", " + std::to_string(campaign.cases())});
  table.add({"fingerprint of scene, files and distributions", campaign.recipe()});
  return table;
}

// Sentences with numbers that may be signed.
std::vector<std::string> statements(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  std::vector<std::string> all;
  for (std::size_t k = 0; k < spec.outcomes.size(); ++k)
    for (std::size_t c = 0; c < campaign.cases(); ++c) {
      const Tally& tally = campaign.tally(c, k);
      const std::string who = campaign.cases() == 1 ? "" : " of case \"" + campaign.case_name(c) + "\"";
      std::string text = "\"" + spec.outcomes[k].name + "\" happened in " + std::to_string(tally.hits) + " of " +
                         std::to_string(tally.runs()) + " runs" + who;
      if (tally.unknown > 0) text += ", and " + std::to_string(tally.unknown) + " runs are unknown";
      text += ". With 95 % confidence its probability is at most " + number_text(100.0 * bound_of(tally), 3) + " %.";
      if (const std::optional<double>& claim = spec.outcomes[k].at_most)
        text += " The statement that it is below " + number_text(100.0 * *claim, 3) + " % is " +
                (bound_of(tally) <= *claim ? "shown." : "NOT shown.");
      all.push_back(text);
    }
  return all;
}

// Rows that lack a result or a number, by cause: the code of the message, else the exit code or the figure.
Table unknown_table(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  struct Cause {
    std::size_t count = 0, first = 0;
    std::string example;
  };
  std::map<std::pair<std::string, std::string>, Cause> causes;  // by case and cause
  const auto add = [&](std::size_t row, const std::string& cause, const std::string& example) {
    Cause& entry = causes[{campaign.case_name(campaign.case_of(row)), cause}];
    if (entry.count++ == 0) entry.first = row, entry.example = example;
  };
  constexpr std::size_t kLongest = 100;  // characters of a message
  for (std::size_t row = 0; row < campaign.used() * campaign.cases(); ++row) {
    const CampaignRow& r = campaign.row(row);
    if (r.metrics.empty())
      add(row, "exit code " + std::to_string(r.code) + (r.message.empty() ? "" : ", " + message_code(r.message)),
          r.message.size() > kLongest ? r.message.substr(0, kLongest) + "..." : r.message);
    for (std::size_t k = 0; k < r.metrics.size(); ++k)
      if (!std::isfinite(r.metrics[k])) add(row, "figure " + spec.metrics[k].name + " has no number", "");
  }
  Table table({"case", "cause", "rows", "first row", "its message"});
  for (const auto& [key, cause] : causes)
    table.add({key.first, key.second, std::to_string(cause.count), std::to_string(cause.first), cause.example});
  return table;
}

Table envelope_table(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  Table table({"envelope", "case", "outcome", "boundary (band of 95 %)", "runs on its right side"});
  for (const EnvelopeSpec& e : spec.envelopes)
    for (std::size_t c = 0; c < campaign.cases(); ++c) {
      const Boundary boundary = boundary_of(campaign, e, c);
      std::vector<std::string> texts;
      for (const Boundary::Crossing& at : boundary.middle()) {
        const std::string& name = at.along_x ? e.x : e.y;
        const std::string value = number_text(at.along_x ? at.x : at.y, 4) + " (" + number_text(at.low, 4) + " to " +
                                  number_text(at.high, 4) + ")";
        const std::string where =
            e.y.empty() ? "" : " at " + (at.along_x ? e.y : e.x) + " = " + number_text(at.along_x ? at.y : at.x, 4);
        texts.push_back(name + " = " + value + where);
      }
      const std::string none = boundary.fitted() ? "none in the sampled range" : "fewer than five runs on one side";
      table.add({e.name, campaign.case_name(c), spec.outcomes[place_of_outcome(spec, e.outcome)].name,
                 texts.empty() ? none : joined(texts, "; "),
                 boundary.fitted() ? share_text(boundary.agreement()) : ""});
    }
  return table;
}

// Which input matters: total Sobol' indices where a polynomial explains the metric, otherwise rank correlations.
Table sensitivity_table(const Campaign& campaign) {
  const SweepSpec& spec = campaign.spec();
  std::vector<std::string> head = {"case", "quantity", "measure"};
  for (const std::size_t k : campaign.draws().parameters()) head.push_back(spec.parameters[k].name);
  Table table(head);
  for (std::size_t c = 0; c < campaign.cases(); ++c) {
    for (std::size_t k = 0; k < spec.metrics.size() + spec.outcomes.size(); ++k) {
      const bool is_metric = k < spec.metrics.size();
      std::vector<std::vector<double>> x;
      std::vector<double> y;
      for (const std::size_t row : rows_of_case(campaign, c)) {
        const CampaignRow& r = campaign.row(row);
        const double value = is_metric ? r.metrics[k] : r.outcomes[k - spec.metrics.size()];
        if (!std::isfinite(value) || (!is_metric && value < 0.0)) continue;
        x.push_back(campaign.draws().positions(campaign.draw_of(row)));
        y.push_back(value);
      }
      const std::string name = is_metric ? spec.metrics[k].name : spec.outcomes[k - spec.metrics.size()].name;
      const auto add = [&](const std::string& measure, const std::vector<double>& values,
                           const std::vector<std::pair<double, double>>& intervals) {
        std::vector<std::string> cells = {campaign.case_name(c), name, measure};
        for (std::size_t j = 0; j < values.size(); ++j)
          cells.push_back(fixed_text(values[j], 2) + (intervals.empty()
                                                          ? ""
                                                          : " (" + fixed_text(intervals[j].first, 2) + " to " +
                                                                fixed_text(intervals[j].second, 2) + ")"));
        if (!values.empty()) table.add(cells);
      };
      if (is_metric && campaign.draws().independent()) {
        const Sensitivity s = sobol_indices(x, y);
        if (s.explained >= kGoodChaos) {
          add("Sobol', alone", s.first, s.first_interval);
          add("Sobol', with interactions (polynomials explain " + share_text(s.explained) + ")", s.total,
              s.total_interval);
          continue;
        }
      }
      add("rank correlation", rank_correlations(x, y), {});
    }
  }
  return table;
}

// Percentage points by which probabilities change when a mean moves by a tenth of the deviation, or a deviation grows by a
// tenth. Of inputs with numbers as values, where enough runs have the outcome and enough lack it.
Table moments_table(const Campaign& campaign) {
  constexpr long kEnough = 40;
  constexpr double kTenth = 0.1;
  const SweepSpec& spec = campaign.spec();
  std::vector<std::size_t> places;  // among the drawn parameters
  std::vector<std::string> head = {"case", "outcome", "when this grows"};
  for (std::size_t k = 0; k < campaign.draws().parameters().size(); ++k) {
    const ParameterSpec& p = spec.parameters[campaign.draws().parameters()[k]];
    if (p.distribution.kind == DistributionKind::kDiscrete) continue;
    places.push_back(k);
    head.push_back(p.name);
  }
  Table table(head);
  for (std::size_t c = 0; c < campaign.cases() && !places.empty() && campaign.draws().independent(); ++c)
    for (std::size_t k = 0; k < spec.outcomes.size(); ++k) {
      const Tally& tally = campaign.tally(c, k);
      if (std::min(tally.hits, tally.misses) < kEnough) continue;
      Eigen::MatrixXd x(tally.hits + tally.misses, places.size());
      Eigen::VectorXd y(x.rows());
      Eigen::Index at = 0;
      for (const std::size_t row : rows_of_case(campaign, c)) {
        if (campaign.row(row).outcomes[k] < 0) continue;
        for (std::size_t j = 0; j < places.size(); ++j)
          x(at, j) = campaign.drawn_number(campaign.draw_of(row), places[j]);
        y[at++] = campaign.row(row).outcomes[k];
      }
      std::vector<Moments> moments;
      for (const std::size_t place : places) moments.push_back(campaign.draws().moments(place));
      const MomentSlopes slopes = moment_slopes(x, y, moments);
      const auto add = [&](const std::string& what, const std::vector<Probability>& of) {
        std::vector<std::string> cells = {campaign.case_name(c), spec.outcomes[k].name, what};
        for (const Probability& p : of)
          cells.push_back(
              interval_text(number_text(100.0 * kTenth * p.value, 2), {0.0, kTenth * p.low, kTenth * p.high}));
        if (!of.empty()) table.add(cells);
      };
      add("mean, by 0.1 deviations", slopes.of_mean);
      add("deviation, by 10 %", slopes.of_deviation);
    }
  return table;
}

Table kept_table(const Campaign& campaign, const std::vector<RepeatedRun>& kept) {
  const SweepSpec& spec = campaign.spec();
  std::vector<std::string> head = {"row", "kept as"};
  append(head, names_in(spec.outcomes));
  append(head, names_in(spec.metrics));
  head.push_back("to play it");
  Table table(head);
  for (const RepeatedRun& run : kept) {
    const CampaignRow& r = campaign.row(run.row);
    std::vector<std::string> cells = {std::to_string(run.row), run.why};
    for (const int outcome : r.outcomes) cells.push_back(outcome < 0 ? "" : outcome > 0 ? "yes" : "no");
    for (std::size_t k = 0; k < spec.metrics.size(); ++k)
      cells.push_back(r.metrics.empty() ? "" : cell(r.metrics[k], 4));
    const std::filesystem::path folder = run.folder, page = folder / kViewPage;
    const std::filesystem::path from_here = folder.parent_path().filename() / folder.filename() / kViewPage;
    cells.push_back(std::filesystem::exists(page) ? "[play](" + from_here.string() + ")"
                                                  : "`footfall view " + run.folder + "`");
    table.add(cells);
  }
  return table;
}

Table better_model_table(const Campaign& campaign, const std::vector<BetterModelResult>& checks) {
  const SweepSpec& spec = campaign.spec();
  const std::size_t place = place_of_outcome(spec, spec.better_model->outcome);
  const std::string outcome = spec.outcomes[place].name;
  Table table({"case", "runs of the check", "without result", "probability of " + outcome + " before [%]",
               "corrected [%]", "called wrong", "of those near the boundary", "missed", "false alarms"});
  for (const BetterModelResult& check : checks) {
    int known = 0, wrong = 0, near = 0, near_wrong = 0;
    for (std::size_t k = 0; k < check.runs.size(); ++k) {
      if (check.better[k] < 0) continue;
      const bool differs = check.better[k] != campaign.row(check.runs[k].row).outcomes[place];
      ++known;
      wrong += differs ? 1 : 0;
      if (std::abs(check.chance[k] - 0.5) > 0.4) continue;  // chances of 10 to 90 %
      ++near;
      near_wrong += differs ? 1 : 0;
    }
    const Tally& tally = campaign.tally(check.which_case, place);
    table.add({campaign.case_name(check.which_case), std::to_string(check.runs.size()),
               std::to_string(static_cast<int>(check.runs.size()) - known), share_with_interval(tally),
               share_with_interval(with_unknown(check.levels.corrected, tally.runs() - tally.unknown, tally.unknown)),
               std::to_string(wrong) + " of " + std::to_string(known),
               std::to_string(near_wrong) + " of " + std::to_string(near), std::to_string(check.levels.missed),
               std::to_string(check.levels.false_alarms)});
  }
  return table;
}

// Differences between the metrics of the rows and of the same rows in the check.
Table better_metrics_table(const Campaign& campaign, const std::vector<BetterModelResult>& checks) {
  const SweepSpec& spec = campaign.spec();
  Table table({"case", "quantity", "median before", "median in the check", "median of the deviations [%]",
               "largest deviation [%]", "in row"});
  for (const BetterModelResult& check : checks)
    for (std::size_t k = 0; k < spec.metrics.size(); ++k) {
      std::vector<double> cheap, better, deviations;
      std::size_t worst = 0;  // row of the largest deviation so far
      double largest = -1.0;
      for (const RepeatedRun& run : check.runs) {
        const std::vector<double>& before = campaign.row(run.row).metrics;
        if (run.metrics.empty() || before.empty() || !std::isfinite(before[k]) || !std::isfinite(run.metrics[k]))
          continue;
        cheap.push_back(before[k]);
        better.push_back(run.metrics[k]);
        const double size = std::abs(run.metrics[k]);
        deviations.push_back(size > 0.0         ? std::abs(before[k] - run.metrics[k]) / size
                             : before[k] == 0.0 ? 0.0
                                                : HUGE_VAL);
        if (deviations.back() > largest) {
          largest = deviations.back();
          worst = run.row;
        }
      }
      if (deviations.empty()) continue;
      table.add({campaign.case_name(check.which_case), spec.metrics[k].name, cell(quantile(cheap, 0.5), 4),
                 cell(quantile(better, 0.5), 4), cell(100.0 * quantile(deviations, 0.5), 3), cell(100.0 * largest, 3),
                 std::to_string(worst)});
    }
  return table;
}

}  // namespace

StudyPage rare_page(const Campaign& campaign, const SubsetSearch& search, const std::string& command) {
  const SweepSpec& spec = campaign.spec();
  const RareSpec& rare = *spec.rare;
  const RareProbability p = search.result();
  StudyPage page(spec.title.empty() ? fs::path(spec.file).stem().string() : spec.title);
  const double sign = rare.above ? 1.0 : -1.0, threshold = rare.above ? *rare.above : *rare.below;
  const std::string event = rare.metric + (rare.above ? " is above " : " is below ") + exact_text(threshold);
  page.section("Statement");
  page.paragraph(p.reached ? "The probability that " + event + " is " + number_text(p.value, 3) + ", between " +
                                 number_text(p.low, 2) + " and " + number_text(p.high, 2) +
                                 " with 95 % confidence, by subset simulation of " + std::to_string(campaign.size()) +
                                 " runs."
                           : "No run of " + std::to_string(campaign.size()) + " has shown that " + event +
                                 ". With 95 % confidence its probability is below " + number_text(p.high, 2) +
                                 ". More runs reach further.");
  if (const std::size_t unknown = rows_without_number(campaign); unknown > 0)
    page.paragraph(std::to_string(unknown) +
                   " runs have no result or no number; the event is taken to have happened in them.");
  page.paragraph(
      "The statement is about the model and the distributions of this page, not about what these leave out.");
  page.section("Levels");
  Table table({"level of " + rare.metric, "share of the runs beyond it", "variation"});
  for (const SubsetSearch::Level& level : search.levels())
    table.add({number_text(sign * level.level, 4), number_text(level.share, 3), number_text(level.variation, 2)});
  page.table(table);
  page.paragraph(
      "The probability is the product of the shares; the interval takes the logarithm as normal, with the sum of the "
      "variations. Runs beyond a level are not independent, and have no percentiles: runs.csv has them all.");
  if (const Table unknown = unknown_table(campaign); unknown.rows().size() > 1) {
    page.section("Rows without a result or a number");
    page.table(unknown);
  }
  page.section("Inputs");
  page.table(input_table(campaign));
  page.section("How to make this page again");
  page.table(origin_table(campaign, command));
  return page;
}

bool statements_shown(const Campaign& campaign) {
  for (std::size_t k = 0; k < campaign.spec().outcomes.size(); ++k)
    for (std::size_t c = 0; c < campaign.cases(); ++c)
      if (const std::optional<double>& claim = campaign.spec().outcomes[k].at_most;
          claim && bound_of(campaign.tally(c, k)) > *claim)
        return false;
  return true;
}

StudyPage campaign_page(const Campaign& campaign, const std::vector<RepeatedRun>& kept,
                        const std::vector<BetterModelResult>& checks, const std::string& command,
                        const std::vector<std::string>& pictures) {
  const SweepSpec& spec = campaign.spec();
  StudyPage page(spec.title.empty() ? fs::path(spec.file).stem().string() : spec.title);
  page.paragraph("`" + command + "`: " + std::to_string(campaign.used()) + " draws" +
                 (campaign.stopped_early()
                      ? ", ended where all intervals were as narrow as " + number_text(spec.until_width)
                      : "") +
                 ". Rows are in `runs.csv`.");
  if (!spec.outcomes.empty()) {
    page.section("Statements");
    for (const std::string& statement : statements(campaign)) page.paragraph(statement);
    page.paragraph(
        "The statements are about the model and the distributions of this page, not about what these leave out.");
    page.section("Probabilities");
    page.table(probability_table(campaign));
    page.paragraph(
        "Intervals of Clopper and Pearson: they hold in at least 95 of 100 campaigns, whatever the probability is. Of "
        "runs whose outcome is unknown it is taken that the outcome happened in none, and in all, of them.");
  }
  page.section("Figures");
  page.table(quantile_table(campaign));
  page.paragraph(
      "Percentiles with intervals of 95 % by order statistics, whatever the distribution is. \"?\": the runs give no "
      "bound. A figure without a number may be less or larger than all others.");
  if (campaign.cases() > 1) {
    page.section("Cases compared on the same draws");
    if (!spec.outcomes.empty()) page.table(pair_table(campaign));
    page.table(paired_figures_table(campaign));
    page.paragraph(
        "Only pairs that differ distinguish the cases. McNemar p: the chance of counts as unlike as \"only first\" "
        "and \"only second\" if the cases were alike.");
  }
  if (const Table unknown = unknown_table(campaign); unknown.rows().size() > 1) {
    page.section("Rows without a result or a number");
    page.table(unknown);
  }
  if (!checks.empty()) {
    page.section("Repeated with the settings of the check");
    page.paragraph(
        "The interval of the corrected probability has the scatter of the draws and of the check. " +
        std::string(spec.better_model->far < BetterModelSpec::kFar
                        ? "It is no interval of 95 %: with far = " + number_text(spec.better_model->far) +
                              " most runs of the check are near the boundary, and wrong calls elsewhere are hardly "
                              "seen; it holds if there are none."
                        : "It holds in 95 of 100 campaigns wherever the two models differ, also where few runs of the "
                          "check found that they do."));
    page.table(better_model_table(campaign, checks));
    page.paragraph("Deviations are relative to the figure in the check.");
    page.table(better_metrics_table(campaign, checks));
  }
  if (!spec.envelopes.empty()) {
    page.section("Envelopes");
    page.table(envelope_table(campaign));
  }
  page.section("Which input matters");
  page.table(sensitivity_table(campaign));
  if (const Table moments = moments_table(campaign); moments.rows().size() > 1) {
    page.section("How probabilities move with the inputs");
    page.table(moments);
    page.paragraph(
        "Percentage points with 95 % intervals, estimated from the runs of this campaign, for small changes of one "
        "input whose other moment stays.");
  }
  page.section("Inputs");
  page.table(input_table(campaign));
  if (!spec.outcomes.empty()) page.table(outcome_table(spec));
  page.section("How to make this page again");
  page.table(origin_table(campaign, command));
  if (!kept.empty()) {
    page.section("Runs to look at");
    page.table(kept_table(campaign, kept));
  }
  if (!pictures.empty()) page.section("Pictures");
  for (const std::string& picture : pictures) page.picture(picture);
  return page;
}

// ---- pictures ----

std::vector<std::string> draw_campaign(const Campaign& campaign, const std::string& folder) {
  const SweepSpec& spec = campaign.spec();
  std::vector<std::string> scripts;
  // Histograms: shares per bin, lines of steps for each case.
  constexpr int kMostBins = 40;
  std::vector<std::string> panels;
  std::ostringstream bins;
  for (std::size_t k = 0; k < spec.metrics.size(); ++k) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    std::vector<std::vector<double>> all;
    std::size_t most = 0;
    for (std::size_t c = 0; c < campaign.cases(); ++c) {
      all.push_back(sorted_metric(campaign, c, k));
      most = std::max(most, all.back().size());
      if (!all.back().empty()) low = std::min(low, all.back().front()), high = std::max(high, all.back().back());
    }
    if (!(high >= low)) continue;
    if (!(high > low)) low -= 0.5, high += 0.5;
    const int count = std::clamp(static_cast<int>(2.0 * std::cbrt(static_cast<double>(most))), 4, kMostBins);
    const double width = (high - low) / count;
    std::vector<std::string> lines;
    for (std::size_t c = 0; c < all.size(); ++c) {
      std::vector<int> in_bin(count, 0);
      for (const double value : all[c]) ++in_bin[std::min(count - 1, static_cast<int>((value - low) / width))];
      for (int b = 0; b < count; ++b)
        bins << k << ',' << c << ',' << number_text(low + (b + 0.5) * width, 8) << ','
             << number_text(100.0 * in_bin[b] / std::max(1.0, static_cast<double>(all[c].size())), 6) << '\n';
      lines.push_back("'histograms.csv' using ($1==" + std::to_string(k) + "&&$2==" + std::to_string(c) +
                      "?$3:1/0):4 with histeps lw 1.6 lc rgb '" + series_colour(static_cast<int>(c) % kSeriesColours) +
                      "' title " + gnuplot_text(campaign.case_name(c)));
    }
    panels.push_back("set xlabel " + gnuplot_text(spec.metrics[k].name) + " noenhanced\nplot " + joined(lines, ", ") +
                     "\n");
  }
  if (!panels.empty()) {
    write_whole_file((fs::path(folder) / "histograms.csv").string(), "figure,case,value,percent\n" + bins.str());
    const int rows = (static_cast<int>(panels.size()) + 1) / 2;
    scripts.push_back(write_drawing(folder, "histograms", {1100, 320 * rows + 40}, csv_setup(),
                                    "set multiplot layout " + std::to_string(rows) +
                                        ",2\nset grid\nset yrange [0:*]\nset ylabel 'runs [%]'\nset key noenhanced\n" +
                                        joined(panels, "") + "unset multiplot\n"));
  }
  for (const EnvelopeSpec& e : spec.envelopes)
    for (std::size_t c = 0; c < campaign.cases(); ++c) {
      const std::string name = e.name + (campaign.cases() == 1 ? "" : "_" + std::to_string(c));
      const std::size_t outcome = place_of_outcome(spec, e.outcome);
      const Boundary boundary = boundary_of(campaign, e, c);
      std::ostringstream points;
      points << "kind,x,y\n";
      const std::size_t x = drawn_place(campaign, e.x), y = e.y.empty() ? 0 : drawn_place(campaign, e.y);
      for (const std::size_t row : rows_of_case(campaign, c))
        if (const int happened = campaign.row(row).outcomes[outcome]; happened >= 0)
          points << happened << ',' << number_text(campaign.drawn_number(campaign.draw_of(row), x), 8) << ','
                 << (e.y.empty() ? std::to_string(happened)
                                 : number_text(campaign.drawn_number(campaign.draw_of(row), y), 8))
                 << '\n';
      for (const Boundary::Crossing& at : boundary.crossings())
        points << "2," << number_text(at.x, 8) << ',' << number_text(e.y.empty() ? 0.5 : at.y, 8) << '\n';
      constexpr int kGrid = 90;
      for (int i = 0; boundary.fitted() && i <= kGrid; ++i)
        for (int j = 0; j <= (e.y.empty() ? 0 : kGrid); ++j) {
          const double px = boundary.low(0) + i * (boundary.high(0) - boundary.low(0)) / kGrid,
                       py = boundary.low(1) + j * (boundary.high(1) - boundary.low(1)) / kGrid;
          if (boundary.in_band(px, py))
            points << "3," << number_text(px, 8) << ',' << number_text(e.y.empty() ? 0.5 : py, 8) << '\n';
        }
      write_whole_file((fs::path(folder) / (name + ".csv")).string(), points.str());
      const std::string file = gnuplot_text(name + ".csv");
      const auto of = [&](int kind) { return file + " using ($1==" + std::to_string(kind) + "?$2:1/0):3 "; };
      scripts.push_back(write_drawing(
          folder, name, {800, 640}, csv_setup(),
          "set grid\nset key outside top center horizontal noenhanced\nset title " +
              gnuplot_text(campaign.cases() == 1 ? spec.title : campaign.case_name(c)) + " noenhanced\nset xlabel " +
              gnuplot_text(e.x) + " noenhanced\nset ylabel " + gnuplot_text(e.y.empty() ? "outcome" : e.y) +
              " noenhanced\nplot " + of(3) + "with points pt 5 ps 0.9 lc rgb '#e0e0e0' title 'band of 95 %', " + of(0) +
              "with points pt 6 ps 0.7 lc rgb '#0072b2' title " + gnuplot_text("not " + spec.outcomes[outcome].name) +
              ", " + of(1) + "with points pt 2 ps 0.9 lc rgb '#d55e00' title " +
              gnuplot_text(spec.outcomes[outcome].name) + ", " + of(2) +
              "with points pt 7 ps 0.3 lc rgb 'black' title 'boundary'\n"));
    }
  return run_gnuplot(folder, scripts);
}

}  // namespace footfall

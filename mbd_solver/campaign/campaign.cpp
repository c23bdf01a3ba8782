// Requests of rows from draws, outcomes by formulas, and the rule that ends a campaign early.
#include "mbd_solver/campaign/campaign.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <set>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/fingerprint.h"
#include "mbd_solver/campaign/worker_pool.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/studies/run_store.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

namespace {

constexpr int kShortRuns = 8;
constexpr std::size_t kFewest = 60, kEvery = 20;  // draws, before and between looks at the intervals
constexpr std::size_t kTried = 50;                // draws, for one whose scene can be read

SweepSpec shortened(SweepSpec spec, bool short_form) {
  if (short_form) spec.runs = std::min(spec.runs, kShortRuns);
  if (short_form && spec.better_model) spec.better_model->runs = std::min(spec.better_model->runs, 2);
  return spec;
}

std::string text_of(const ParameterSpec& p, double value) {
  return p.choices.empty() ? exact_text(value) : p.choices[static_cast<std::size_t>(value)].name;
}

}  // namespace

bool CampaignRow::is_lost() const { return code >= WorkerAnswer::kLost || code == kExitInterrupted; }

Campaign::Campaign(const SweepSpec& spec, bool short_form, const std::vector<std::vector<double>>* points)
    : spec_(shortened(spec, short_form)),
      draws_(spec_, points),
      plan_(plan_of(spec_, short_form)),
      rows_(draws_.count() * plan_.runs.size()),
      tallies_(plan_.runs.size(), std::vector<Tally>(spec_.outcomes.size())) {}

std::string Campaign::case_name(std::size_t c) const { return cases() == 1 ? "all" : plan_.cases[c].name; }

double Campaign::drawn_number(std::size_t draw, std::size_t place) const {
  const ParameterSpec& p = spec_.parameters[draws_.parameters()[place]];
  const double value = draws_.values(draw)[place];
  return p.choices.empty() ? value : number_in(p.choices[static_cast<std::size_t>(value)].name).value_or(value);
}

std::string Campaign::name(std::size_t row) const {
  std::string number = std::to_string(row);
  return "row_" + std::string(number.size() < 6 ? 6 - number.size() : 0, '0') + number;
}

std::map<std::string, double> Campaign::values_of(std::size_t draw) const {
  std::map<std::string, double> values = {{"row", static_cast<double>(draw)},
                                          {"seed", static_cast<double>(draws_.seed(draw))}};
  for (std::size_t k = 0; k < draws_.parameters().size(); ++k)
    values[spec_.parameters[draws_.parameters()[k]].name] = drawn_number(draw, k);
  return values;
}

RunRequest Campaign::request(std::size_t row, const std::vector<std::string>& more) const {
  RunRequest r = plan_.runs[case_of(row)];
  r.name = name(row);
  const std::vector<double>& drawn = draws_.values(draw_of(row));
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const ParameterSpec& p = spec_.parameters[draws_.parameters()[k]];
    r.values.push_back(text_of(p, drawn[k]));
    if (p.choices.empty()) {
      append(r.settings, filled(p.settings, r.values.back()));
    } else {
      const ChoiceSpec& choice = p.choices[static_cast<std::size_t>(drawn[k])];
      append(r.settings, choice.settings);
      if (!choice.scene.empty()) r.scene = choice.scene;
    }
  }
  append(r.settings, more);
  std::map<std::string, double> values = values_of(draw_of(row));
  r.settings = with_formulas(r.settings, values);
  return r;
}

std::pair<RunRequest, Scene> Campaign::first_valid(std::size_t c) const {
  std::exception_ptr first;
  for (std::size_t draw = 0; draw < std::min(kTried, draws_.count()); ++draw) try {
      const RunRequest r = request(draw * cases() + c);
      return {r, read_scene(r.scene, r.settings)};
    } catch (const CodedError&) {
      if (!first) first = std::current_exception();
    }
  std::rethrow_exception(first);
}

std::vector<std::string> Campaign::case_values(std::size_t row) const { return plan_.runs[case_of(row)].values; }

std::vector<std::string> Campaign::drawn_values(std::size_t row) const {
  std::vector<std::string> texts;
  const std::vector<double>& drawn = draws_.values(draw_of(row));
  for (std::size_t k = 0; k < drawn.size(); ++k)
    texts.push_back(text_of(spec_.parameters[draws_.parameters()[k]], drawn[k]));
  return texts;
}

std::vector<int> Campaign::outcomes_of(std::size_t row, const std::vector<double>& metrics) const {
  std::vector<int> outcomes(spec_.outcomes.size(), -1);
  if (metrics.empty()) return outcomes;
  NamedValues values = values_of(draw_of(row));
  for (std::size_t k = 0; k < metrics.size(); ++k) values[formula_name(spec_.metrics[k].name)] = metrics[k];
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    if (const OutcomeSpec& o = spec_.outcomes[k]; !o.metric.empty()) {
      const double value = metrics[index_of(spec_.metrics, o.metric)];
      if (std::isfinite(value)) outcomes[k] = (o.least && value < *o.least) || (o.most && value > *o.most) ? 1 : 0;
      continue;
    }
    const std::string& when = spec_.outcomes[k].when;
    const std::vector<std::string> names = Expression::names_in(when);
    // A comparison with no number would be false.
    if (std::any_of(names.begin(), names.end(), [&](const std::string& name) { return !std::isfinite(values[name]); }))
      continue;
    const double value = Expression(when, values).value_or_nan();
    if (!std::isnan(value)) outcomes[k] = value != 0.0 ? 1 : 0;
  }
  return outcomes;
}

void Campaign::set(std::size_t k, CampaignRow row) {
  row.outcomes = outcomes_of(k, row.metrics);
  rows_[k] = std::move(row);
  look_for_end();
}

// Looks at whole draws in their order, so that the end does not depend on which run ends first.
void Campaign::look_for_end() {
  while (!stopped_ && used_ < draws_.count()) {
    for (std::size_t c = 0; c < cases(); ++c)
      if (!rows_[used_ * cases() + c].is_done()) return;
    for (std::size_t c = 0; c < cases(); ++c)
      for (std::size_t k = 0; k < spec_.outcomes.size(); ++k)
        tallies_[c][k].add(rows_[used_ * cases() + c].outcomes[k]);
    ++used_;
    if (!(spec_.until_width > 0.0) || spec_.outcomes.empty() || used_ < kFewest || used_ % kEvery != 0) continue;
    stopped_ = true;
    for (const std::vector<Tally>& of_case : tallies_)
      for (const Tally& tally : of_case) stopped_ = stopped_ && tally.probability().width() <= spec_.until_width;
  }
}

std::string Campaign::recipe() const {
  std::ostringstream text;
  text.precision(17);
  const auto put = [&](const std::optional<double>& value) { text << ' ' << (value ? number_text(*value, 17) : "-"); };
  text << name_of(spec_.design) << ' ' << spec_.seed << ' '
       << (spec_.design == Design::kLatinHypercube ? spec_.runs : 0) << ' ' << spec_.time_limit << '\n';
  for (const ParameterSpec& p : spec_.parameters) {
    const DistributionSpec& d = p.distribution;
    text << p.name << ' ' << (p.is_drawn() ? name_of(*d.kind) : "") << joined(p.settings, "\n");
    for (const auto& value : {d.mean, d.deviation, d.least, d.most, d.likely, d.shape, d.scale}) put(value);
    for (const double value : d.weights) put(value);
    for (const double value : d.measured) put(value);
    if (d.whole_rows) text << " whole rows of " << d.file;
    for (const ChoiceSpec& choice : p.choices)
      text << '\n' << choice.name << ' ' << choice.scene << ' ' << joined(choice.settings, "\n");
    text << '\n';
  }
  if (spec_.rare) {  // on these the later points depend
    text << "rare " << spec_.rare->metric << ' ' << spec_.runs;
    for (const auto& value : {spec_.rare->above, spec_.rare->below}) put(value);
  }
  for (const double value : draws_.values(0)) put(value);  // by another OpenTURNS it may have other digits
  for (const CorrelationSpec& c : spec_.correlations) text << joined(c.between) << ' ' << c.rank << '\n';
  for (const MetricSpec& m : spec_.metrics) text << metric_recipe(m) << '\n';
  for (std::size_t c = 0; c < cases(); ++c) {
    const auto [r, scene] = first_valid(c);
    text << recipe_of(scene, r.until) << joined(spec_.settings, "\n") << '\n';
  }
  return fingerprint(text.str());
}

SweepSpec with_requirements(SweepSpec spec, bool short_form) {
  const Campaign campaign(spec, short_form);
  for (std::size_t c = 0; c < campaign.cases(); ++c)
    for (const RequirementSpec& r : campaign.first_valid(c).second.requirements) {
      const std::string name = "requirement " + r.name + (r.unit.empty() ? "" : " [" + r.unit + "]");
      if (index_of(spec.metrics, name) >= 0) continue;
      MetricSpec metric;
      metric.name = name;
      metric.requirement = r.name;
      spec.metrics.push_back(metric);
      OutcomeSpec missed;
      missed.name = r.name + ": requirement missed";
      missed.metric = name;
      missed.least = r.least;
      missed.most = r.most;
      spec.outcomes.push_back(missed);
    }
  return spec;
}

std::size_t rows_without_number(const Campaign& campaign) {
  std::size_t count = 0;
  for (std::size_t row = 0; row < campaign.used() * campaign.cases(); ++row) {
    const std::vector<double>& metrics = campaign.row(row).metrics;
    const bool numbers = std::all_of(metrics.begin(), metrics.end(), [](double value) { return std::isfinite(value); });
    count += metrics.empty() || !numbers ? 1 : 0;
  }
  return count;
}

std::vector<RepeatedRun> rows_to_keep(const Campaign& campaign, std::size_t most) {
  const SweepSpec& spec = campaign.spec();
  const std::size_t count = campaign.used() * campaign.cases();
  struct List {
    std::string why;
    std::vector<std::size_t> rows;
    std::size_t next = 0;
  };
  std::vector<List> lists(1);
  lists[0].why = "no result";
  for (std::size_t row = 0; row < count; ++row)
    if (campaign.row(row).code > 0 && !campaign.row(row).is_lost()) lists[0].rows.push_back(row);
  lists.push_back({"figure without a number", {}});
  for (std::size_t row = 0; row < count; ++row) {
    const std::vector<double>& metrics = campaign.row(row).metrics;
    if (std::any_of(metrics.begin(), metrics.end(), [](double value) { return !std::isfinite(value); }))
      lists[1].rows.push_back(row);
  }
  for (std::size_t k = 0; k < spec.outcomes.size(); ++k) {
    List list{spec.outcomes[k].name, {}};
    for (std::size_t row = 0; row < count; ++row)
      if (campaign.row(row).outcomes.size() > k && campaign.row(row).outcomes[k] > 0) list.rows.push_back(row);
    lists.push_back(list);
  }
  for (std::size_t k = 0; k < spec.metrics.size(); ++k)
    for (const bool largest : {true, false}) {
      List list{(largest ? "largest " : "least ") + spec.metrics[k].name, {}};
      const auto value = [&](std::size_t row) { return campaign.row(row).metrics[k]; };
      for (std::size_t row = 0; row < count; ++row)
        if (!campaign.row(row).metrics.empty() && std::isfinite(value(row))) list.rows.push_back(row);
      std::stable_sort(list.rows.begin(), list.rows.end(), [&](std::size_t a, std::size_t b) {
        return largest ? value(a) > value(b) : value(a) < value(b);
      });
      lists.push_back(list);
    }
  std::vector<RepeatedRun> kept;
  std::set<std::size_t> chosen;
  for (bool any = true; any && kept.size() < most;) {
    any = false;
    for (List& list : lists) {
      while (list.next < list.rows.size() && chosen.count(list.rows[list.next]) > 0) ++list.next;
      if (list.next == list.rows.size() || kept.size() == most) continue;
      chosen.insert(list.rows[list.next]);
      kept.push_back({list.rows[list.next++], list.why, "", {}});
      any = true;
    }
  }
  return kept;
}

}  // namespace footfall

#include "mbd_solver/studies/calibration_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/studies/calibration_page.h"
#include "mbd_solver/studies/determination.h"

namespace footfall {
namespace {

// The values of all targets that are asked for, one after another; none where one has failed.
std::vector<double> numbers_in(const Evaluation& e, const Fidelity& fidelity) {
  std::vector<double> all;
  for (std::size_t t = 0; t < e.targets.size(); ++t) {
    if (!fidelity.asks(t)) continue;
    if (e.targets[t].failed) return {};
    all.insert(all.end(), e.targets[t].values.begin(), e.targets[t].values.end());
  }
  return all;
}

// One of these numbers: which target's, and what a curve wants at its row.
struct Number {
  std::size_t target;
  double wanted;
};

}  // namespace

StageSearch::StageSearch(const StageTask& task) : task_(task), spent_(task.spent) {
  questions_.may_go_on = squares_.may_go_on = [this](const Shares&) { return may_go_on(); };
  questions_.misfit = [this](const Shares& set) -> std::optional<double> {
    const Evaluation* e = look_up(set);
    if (!e) return {};
    return e->misfit;
  };
  squares_.residuals = [this](const Shares& set) -> std::optional<std::vector<double>> {
    const Evaluation* e = look_up(set);
    if (!e) return {};
    return e->message.empty() ? e->residuals(task_.spec) : std::vector<double>();
  };
  if (task.stage.method != SearchMethod::kSurrogate || task.stage.evaluations <= 0) return;
  surrogate_.emplace(task.stage, task.start, surrogate_questions());
  spent_ = task.spent;  // what was known before costs this stage nothing
}

bool StageSearch::may_go_on() const {
  return task_.spec.limits.hours <= 0.0 || spent_ < 3600.0 * task_.spec.limits.hours;
}

const Evaluation* StageSearch::look_up(const Shares& set) {
  const Evaluation* e = task_.evaluations.known(task_.fidelity, set);
  if (e) spent_ += e->cpu;
  return e;
}

StageWay StageSearch::go() {
  if (surrogate_) return surrogate_->go();
  spent_ = task_.spent;  // these begin anew
  if (task_.stage.method == SearchMethod::kGaussNewton)
    return walk_least_squares(task_.stage, task_.start, task_.spec.step, squares_);
  const int runs_per_set = static_cast<int>(task_.spec.scenes.size()) * task_.fidelity.seeds;
  return walk(task_.stage, task_.start, questions_,
              static_cast<std::size_t>((task_.jobs + runs_per_set - 1) / runs_per_set));
}

SurrogateQuestions StageSearch::surrogate_questions() {
  const CalibrationSpec& spec = task_.spec;
  SurrogateQuestions questions;
  std::vector<Number> numbers;
  const Evaluation& known = *task_.evaluations.known(task_.fidelity, task_.start);
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    if (!task_.fidelity.asks(t)) continue;
    const std::vector<std::size_t> by = task_.evaluations.moved_by(task_.fidelity, t);
    const TargetResult& result = known.targets[t];
    for (std::size_t row = 0; row < result.values.size(); ++row) {
      questions.moved_by.push_back(by);
      numbers.push_back({t, result.values[row] - result.residuals[row] * spec.targets[t].tolerance});
    }
  }
  const double cap = task_.fidelity.alone ? 0.0 : spec.cap;
  questions.part = [&spec, numbers, cap](std::size_t k, double y) {
    const TargetSpec& target = spec.targets[numbers[k].target];
    const double r = target.is_curve() ? (y - numbers[k].wanted) / target.tolerance : residual_of(target, y);
    const double counted = capped(r, cap);
    return target.weight * counted * counted;
  };
  questions.numbers = [this](const Shares& set) -> std::optional<std::vector<double>> {
    const Evaluation* e = look_up(set);
    if (!e) return {};
    return numbers_in(*e, task_.fidelity);
  };
  questions.earlier = task_.earlier;
  if (!spec.constraints.empty()) questions.allowed = [&spec](const Shares& set) { return broken_by(spec, set) == 0.0; };
  questions.may_go_on = [this](const Shares&) { return may_go_on(); };
  return questions;
}

namespace {

using Clock = std::chrono::steady_clock;

double hours_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count() / 3600.0;
}

// Of one run of a set, as it went in the pool [s]; where it was done before, what it says of itself and what the pool
// adds to others.
double run_time(const Evaluation& one, double added) {
  return one.lasted > 0.0 ? one.lasted : one.wall / std::max(1, one.runs) + added;
}

// What `count` sets of so many runs like those of `one` take.
struct Share {
  std::string what;
  const Evaluation& one;
  int sets, runs;  // runs: of each set
  bool one_by_one;
};

void add_share(Prediction& p, const Share& share, int jobs, double added) {
  const double rounds = share.one_by_one ? std::ceil(static_cast<double>(share.runs) / jobs) * share.sets
                                         : std::ceil(static_cast<double>(share.runs) * share.sets / jobs);
  const double hours = rounds * run_time(share.one, added) / 3600.0;
  p.hours += hours;
  p.sets += share.sets;
  p.runs += share.sets * share.runs;
  p.lines.push_back(share.what + ": " + std::to_string(share.sets) + (share.sets == 1 ? " set, " : " sets, ") +
                    std::to_string(share.sets * share.runs) + " runs, " + number_text(hours, 3) + " h");
}

// With no stage's settings, on one seed: what the confirmation takes for each.
Fidelity whole_once(const CalibrationSpec& spec) {
  Fidelity fidelity = full_fidelity(spec);
  fidelity.seeds = 1;
  return fidelity;
}

}  // namespace

bool CalibrationRun::start() {
  const Shares at = start_of(spec_);
  std::vector<Fidelity> all;
  for (const StageSpec& stage : spec_.stages) all.push_back(fidelity_of(spec_, stage));
  all.push_back(whole_once(spec_));
  for (const Fidelity& fidelity : all) {
    if (!evaluations_.carry_out(fidelity, {at}, jobs_, true)) return false;
    const Evaluation& e = *evaluations_.known(fidelity, at);
    if (!e.message.empty())
      throw NumericalError(spec_.file + ": a run of the start did not end well: " + e.message +
                           "; give parameters a start from which every scene runs");
  }
  outcome_.start = evaluations_.known(all[all.size() - 2], at);
  return true;
}

Prediction CalibrationRun::predict() const {
  const Shares at = start_of(spec_);
  const Evaluation& whole = *evaluations_.known(whole_once(spec_), at);
  std::vector<const Evaluation*> starts = {&whole};
  for (const StageSpec& stage : spec_.stages) starts.push_back(evaluations_.known(fidelity_of(spec_, stage), at));
  double added = 0.0;  // to a run by the pool: its start and its end
  for (const Evaluation* e : starts)
    if (e->lasted > 0.0) added = std::max(added, e->lasted - e->wall / std::max(1, e->runs));
  Prediction p;
  for (std::size_t k = 0; k < spec_.stages.size(); ++k)
    add_share(p,
              {"stage " + std::string(name_of(spec_.stages[k].method)), *starts[k + 1], spec_.stages[k].evaluations,
               starts[k + 1]->runs, goes_one_by_one(spec_.stages[k].method)},
              jobs_, added);
  add_share(
      p,
      {"differences about the best set", *starts.back(), 2 * static_cast<int>(at.size()), starts.back()->runs, false},
      jobs_, added);
  if (spec_.alone > 0)
    add_share(p,
              {"targets that are not met at the start, alone", *starts.back(),
               spec_.alone * (static_cast<int>(spec_.targets.size()) - starts.back()->met()),
               std::min(2, starts.back()->runs), true},
              jobs_, added);
  add_share(p, {"confirmation", whole, spec_.confirm, whole.runs * full_fidelity(spec_).seeds, false}, jobs_, added);
  return p;
}

void CalibrationRun::say(const std::string& text) const {
  if (evaluations_.looks()) return;
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

bool CalibrationRun::walk_stage(const StageSpec& asked, Shares& at) {
  const Fidelity fidelity = fidelity_of(spec_, asked);
  if (!evaluations_.carry_out(fidelity, {at}, jobs_)) return false;
  const Evaluation& from = *evaluations_.known(fidelity, at);
  const int runs_per_set = static_cast<int>(spec_.scenes.size()) * fidelity.seeds;
  StageSpec stage = asked;
  if (spec_.limits.runs > 0)
    stage.evaluations = std::min(stage.evaluations, (spec_.limits.runs - runs_) / runs_per_set);
  StageOutcome outcome;
  bool ended = true;
  outcome.best = from.misfit;
  if (stage.evaluations <= 0) outcome.way.end = "limit of runs reached";
  StageSearch search({spec_, evaluations_, fidelity, stage, at, sets_run_like(asked), jobs_, spent_});
  for (std::size_t said = 0; stage.evaluations > 0;) {
    outcome.way = search.go();
    const StageWay& way = outcome.way;
    if (way.sets.size() >= said + 10 || (way.wanted.empty() && !way.sets.empty())) {
      said = way.sets.size();
      say(std::string(name_of(stage.method)) + ": " + std::to_string(said) + " sets, best misfit " +
          number_text(std::min(way.misfit, from.misfit), 5));
    }
    if (way.wanted.empty()) break;
    ended = evaluations_.carry_out(fidelity, way.wanted, jobs_);
    if (!ended) break;
  }
  for (const Shares& set : outcome.way.sets) {
    const Evaluation* e = evaluations_.known(fidelity, set);
    if (!e) continue;
    outcome.evaluations.push_back(e);
    runs_ += outcome.evaluations.back()->runs;
    spent_ += outcome.evaluations.back()->cpu;
  }
  if (outcome.way.misfit < from.misfit) {
    at = outcome.way.best;
    outcome.best = outcome.way.misfit;
  }
  outcome_.stages.push_back(outcome);
  return ended;
}

bool CalibrationRun::search() {
  const Clock::time_point began = Clock::now();
  const int reused = evaluations_.runs_reused();
  outcome_.predicted = predict().hours;
  Shares at = start_of(spec_);
  for (const StageSpec& stage : spec_.stages)
    if (!walk_stage(stage, at)) return false;
  if (spec_.cap > 0.0) at = most_met(spec_, comparable())->shares;  // the question is how many come together
  const Fidelity last = fidelity_of(spec_, spec_.stages.back());
  const std::vector<Shares> sets = difference_sets(spec_, at);
  say("differences about the best set");
  if (!evaluations_.carry_out(last, sets, jobs_)) return false;
  for (const Shares& set : sets) outcome_.around.push_back(evaluations_.known(last, set));
  if (!confirm(at) || !seek_alone()) return false;
  outcome_.determination = determination_of(spec_, *outcome_.best, outcome_.around);
  outcome_.pulls = pulls_of(spec_, *outcome_.best, outcome_.around);
  outcome_.taken = hours_since(began);
  outcome_.whole_time = reused == 0 || evaluations_.runs_done() > 9 * evaluations_.runs_reused();
  return true;
}

// Runs the set whole, and those next to it that should meet more.
bool CalibrationRun::confirm(Shares at) {
  const Fidelity whole = full_fidelity(spec_), searched = fidelity_of(spec_, spec_.stages.back());
  const Determination about = determination_of(spec_, *evaluations_.known(searched, at), outcome_.around);
  std::vector<const Evaluation*> confirmed;
  while (static_cast<int>(confirmed.size()) < spec_.confirm) {
    say("confirmation");
    if (!evaluations_.carry_out(whole, {at}, jobs_)) return false;
    confirmed.push_back(evaluations_.known(whole, at));
    outcome_.confirmed = most_met(spec_, confirmed);
    const Shares next = adjusted(spec_, *outcome_.confirmed, about.sensitivity);
    if (std::any_of(confirmed.begin(), confirmed.end(), [&](const Evaluation* e) { return e->shares == next; })) break;
    at = next;
  }
  outcome_.confirmations = static_cast<int>(confirmed.size());
  if (!evaluations_.carry_out(searched, {outcome_.confirmed->shares}, jobs_)) return false;
  outcome_.best = evaluations_.known(searched, outcome_.confirmed->shares);
  return true;
}

// By response surfaces, from all that is known and from the set that is nearest to the target.
bool CalibrationRun::seek_alone() {
  if (spec_.alone == 0) return true;
  const std::vector<const Evaluation*> sets = comparable();
  std::vector<Shares> known(sets.size());
  std::transform(sets.begin(), sets.end(), known.begin(), [](const Evaluation* e) { return e->shares; });
  StageSpec stage = spec_.stages.back();
  stage.method = SearchMethod::kSurrogate;
  stage.evaluations = spec_.alone + 1;  // with the first, which is known
  for (const std::size_t target : apart(spec_, sets).never) {
    say("alone: " + spec_.targets[target].name);
    Fidelity fidelity = fidelity_of(spec_, stage);
    fidelity.alone = target;
    if (!evaluations_.carry_out(fidelity, known, jobs_)) return false;
    const auto less = [&](const Evaluation* a, const Evaluation* b) {
      return distance(a->targets[target]) < distance(b->targets[target]);
    };
    Alone alone;
    alone.target = target;
    alone.moved_by = evaluations_.moved_by(fidelity, target);
    alone.before = sets.size();
    alone.nearest = *std::min_element(sets.begin(), sets.end(), less);
    alone.nearest_before = distance(alone.nearest->targets[target]);
    StageSearch search({spec_, evaluations_, fidelity, stage, alone.nearest->shares, known, jobs_, 0.0});
    StageWay way = search.go();
    for (; !way.wanted.empty(); way = search.go())
      if (!evaluations_.carry_out(fidelity, way.wanted, jobs_)) return false;
    alone.sets = way.sets.size() - 1;
    for (const Shares& set : way.sets) {
      const Evaluation* e = evaluations_.known(fidelity, set);
      if (!e->targets[target].failed && less(e, alone.nearest)) alone.nearest = e;
    }
    outcome_.alone.push_back(alone);
  }
  return true;
}

std::vector<Shares> CalibrationRun::sets_run_like(const StageSpec& stage) const {
  std::vector<Shares> sets;
  for (std::size_t k = 0; k < outcome_.stages.size(); ++k)
    if (spec_.stages[k].settings == stage.settings && spec_.stages[k].until == stage.until)
      for (const Evaluation* e : outcome_.stages[k].evaluations) sets.push_back(e->shares);
  return sets;
}

std::vector<const Evaluation*> CalibrationRun::comparable() const {
  std::vector<const Evaluation*> sets;
  std::set<const Evaluation*> seen;
  const auto add = [&](const Evaluation* e) {
    if (e && seen.insert(e).second) sets.push_back(e);
  };
  const StageSpec& last = spec_.stages[outcome_.stages.size() - 1];
  for (std::size_t k = 0; k < outcome_.stages.size(); ++k)
    if (spec_.stages[k].settings == last.settings && spec_.stages[k].until == last.until)
      for (const Evaluation* e : outcome_.stages[k].evaluations) add(e);
  for (const Evaluation* e : outcome_.around) add(e);
  add(outcome_.best);
  return sets;
}

}  // namespace footfall

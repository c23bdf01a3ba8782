// Each step requests sets and carries out their missing runs; an interrupted calibration repeats the steps on finished runs.
#include "mbd_solver/studies/calibrate/calibration_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/studies/calibrate/calibration_page.h"
#include "mbd_solver/studies/calibrate/determination.h"
#include "mbd_solver/studies/codes.h"

namespace footfall {
namespace {

// The values of all required targets; empty if one has failed.
std::vector<double> numbers_in(const Evaluation& e, const Fidelity& fidelity) {
  std::vector<double> all;
  for (std::size_t t = 0; t < e.targets.size(); ++t) {
    if (!fidelity.requires(t)) continue;
    if (e.targets[t].failed) return {};
    all.insert(all.end(), e.targets[t].values.begin(), e.targets[t].values.end());
  }
  return all;
}

// One of these numbers: its target, and the required value of a curve at its row.
struct Number {
  std::size_t target;
  double requested;
};

}  // namespace

StageSearch::StageSearch(const StageTask& task) : task_(task), spent_(task.spent) {
  queries_.may_continue = [this](const UnitPoint&) { return may_continue(); };
  queries_.misfit = [this](const UnitPoint& set) -> std::optional<double> {
    const Evaluation* e = look_up(set);
    if (!e) return {};
    return e->misfit;
  };
  queries_.residuals = [this](const UnitPoint& set) {
    const Evaluation* e = task_.evaluations.known(task_.fidelity, set);
    return e->message.empty() ? e->residuals(task_.spec) : std::vector<double>();
  };
  if (task.stage.method != SearchMethod::kSurrogate || task.stage.evaluations <= 0) return;
  surrogate_.emplace(task.stage, task.start, surrogate_queries());
  spent_ = task.spent;  // sets known before cost this stage nothing
}

bool StageSearch::may_continue() const {
  return task_.spec.limits.hours <= 0.0 || spent_ < 3600.0 * task_.spec.limits.hours;
}

const Evaluation* StageSearch::look_up(const UnitPoint& set) {
  const Evaluation* e = task_.evaluations.known(task_.fidelity, set);
  if (e) spent_ += e->cpu;
  return e;
}

SearchPath StageSearch::go() {
  if (surrogate_) return surrogate_->go();
  spent_ = task_.spent;  // these methods start again
  const int runs_per_set = static_cast<int>(task_.spec.scenes.size()) * task_.fidelity.seeds;
  return search_path(task_.stage, task_.start, task_.spec.step, queries_,
                     static_cast<std::size_t>((task_.jobs + runs_per_set - 1) / runs_per_set));
}

SurrogateQueries StageSearch::surrogate_queries() {
  const CalibrationSpec& spec = task_.spec;
  SurrogateQueries queries;
  std::vector<Number> numbers;
  const Evaluation& known = *task_.evaluations.known(task_.fidelity, task_.start);
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    if (!task_.fidelity.requires(t)) continue;
    const std::vector<std::size_t> by = task_.evaluations.moved_by(task_.fidelity, t);
    const TargetResult& result = known.targets[t];
    for (std::size_t row = 0; row < result.values.size(); ++row) {
      queries.moved_by.push_back(by);
      numbers.push_back({t, result.values[row] - result.residuals[row] * spec.targets[t].tolerance});
    }
  }
  const double cap = task_.fidelity.single_target ? 0.0 : spec.cap;
  queries.part = [&spec, numbers, cap](std::size_t k, double y) {
    const TargetSpec& target = spec.targets[numbers[k].target];
    const double r = target.is_curve() ? (y - numbers[k].requested) / target.tolerance : residual_of(target, y);
    const double counted = capped(r, cap);
    return target.weight * counted * counted;
  };
  queries.numbers = [this](const UnitPoint& set) -> std::optional<std::vector<double>> {
    const Evaluation* e = look_up(set);
    if (!e) return {};
    return numbers_in(*e, task_.fidelity);
  };
  queries.earlier = task_.earlier;
  if (!spec.constraints.empty())
    queries.allowed = [&spec](const UnitPoint& set) { return violation_of(spec, set) == 0.0; };
  queries.may_continue = [this](const UnitPoint&) { return may_continue(); };
  return queries;
}

namespace {

using Clock = std::chrono::steady_clock;

double hours_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count() / 3600.0;
}

// Time of one run of a set in the pool [s]; if it was done before, its own time and the overhead of the pool.
double run_time(const Evaluation& one, double added) {
  return one.lasted > 0.0 ? one.lasted : one.wall / std::max(1, one.runs) + added;
}

// Sets with so many runs each, like those of `one`.
struct WorkEstimate {
  std::string what;
  const Evaluation& one;
  int sets, runs;  // runs: of each set
  bool sequential;
};

void add_work(Prediction& p, const WorkEstimate& work, int jobs, double added) {
  const double rounds = work.sequential ? std::ceil(static_cast<double>(work.runs) / jobs) * work.sets
                                        : std::ceil(static_cast<double>(work.runs) * work.sets / jobs);
  const double hours = rounds * run_time(work.one, added) / 3600.0;
  p.hours += hours;
  p.sets += work.sets;
  p.runs += work.sets * work.runs;
  p.lines.push_back(work.what + ": " + std::to_string(work.sets) + (work.sets == 1 ? " set, " : " sets, ") +
                    std::to_string(work.sets * work.runs) + " runs, " + number_text(hours, 3) + " h");
}

// A whole run with one seed, for the time of the confirmation.
Fidelity whole_once(const CalibrationSpec& spec) {
  Fidelity fidelity = full_fidelity(spec);
  fidelity.seeds = 1;
  return fidelity;
}

}  // namespace

bool CalibrationRun::start() {
  const UnitPoint at = start_of(spec_);
  std::vector<Fidelity> all;
  for (const StageSpec& stage : spec_.stages) all.push_back(fidelity_of(spec_, stage));
  all.push_back(whole_once(spec_));
  for (const Fidelity& fidelity : all) {
    if (!evaluations_.carry_out(fidelity, {at}, jobs_, true)) return false;
    const Evaluation& e = *evaluations_.known(fidelity, at);
    if (!e.message.empty())
      throw NumericalError(code::kStartFailed, spec_.file + ": a run of the start has failed: " + e.message +
                                                   "; give parameters a start with which every scene runs");
  }
  outcome_.start = evaluations_.known(all[all.size() - 2], at);
  return true;
}

Prediction CalibrationRun::predict() const {
  const UnitPoint at = start_of(spec_);
  const Evaluation& whole = *evaluations_.known(whole_once(spec_), at);
  std::vector<const Evaluation*> starts = {&whole};
  for (const StageSpec& stage : spec_.stages) starts.push_back(evaluations_.known(fidelity_of(spec_, stage), at));
  double added = 0.0;  // overhead of the pool for a run
  for (const Evaluation* e : starts)
    if (e->lasted > 0.0) added = std::max(added, e->lasted - e->wall / std::max(1, e->runs));
  Prediction p;
  for (std::size_t k = 0; k < spec_.stages.size(); ++k)
    add_work(p,
             {"stage " + std::string(name_of(spec_.stages[k].method)), *starts[k + 1], spec_.stages[k].evaluations,
              starts[k + 1]->runs, is_sequential(spec_.stages[k].method)},
             jobs_, added);
  add_work(
      p,
      {"differences about the best set", *starts.back(), 2 * static_cast<int>(at.size()), starts.back()->runs, false},
      jobs_, added);
  if (spec_.single_target > 0)
    add_work(p,
             {"targets that are not met at the start, one by one", *starts.back(),
              spec_.single_target * (static_cast<int>(spec_.targets.size()) - starts.back()->met()),
              std::min(2, starts.back()->runs), true},
             jobs_, added);
  add_work(p, {"confirmation", whole, spec_.confirm, whole.runs * full_fidelity(spec_).seeds, false}, jobs_, added);
  return p;
}

void CalibrationRun::print_progress(const std::string& text) const {
  if (evaluations_.is_read_only()) return;
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

bool CalibrationRun::run_stage(const StageSpec& given, UnitPoint& at) {
  const Fidelity fidelity = fidelity_of(spec_, given);
  if (!evaluations_.carry_out(fidelity, {at}, jobs_)) return false;
  const Evaluation& from = *evaluations_.known(fidelity, at);
  const int runs_per_set = static_cast<int>(spec_.scenes.size()) * fidelity.seeds;
  StageSpec stage = given;
  if (spec_.limits.runs > 0)
    stage.evaluations = std::min(stage.evaluations, (spec_.limits.runs - runs_) / runs_per_set);
  StageOutcome outcome;
  bool ended = true;
  outcome.best = from.misfit;
  if (stage.evaluations <= 0) outcome.path.end = "limit of runs reached";
  StageSearch search({spec_, evaluations_, fidelity, stage, at, sets_with_runs_of(given), jobs_, spent_});
  for (std::size_t reported = 0; stage.evaluations > 0;) {
    outcome.path = search.go();
    const SearchPath& path = outcome.path;
    if (path.sets.size() >= reported + 10 || (path.requested.empty() && !path.sets.empty())) {
      reported = path.sets.size();
      print_progress(std::string(name_of(stage.method)) + ": " + std::to_string(reported) + " sets, best misfit " +
                     number_text(std::min(path.misfit, from.misfit), 5));
    }
    if (path.requested.empty()) break;
    ended = evaluations_.carry_out(fidelity, path.requested, jobs_);
    if (!ended) break;
  }
  for (const UnitPoint& set : outcome.path.sets) {
    const Evaluation* e = evaluations_.known(fidelity, set);
    if (!e) continue;
    outcome.evaluations.push_back(e);
    runs_ += outcome.evaluations.back()->runs;
    spent_ += outcome.evaluations.back()->cpu;
  }
  if (outcome.path.misfit < from.misfit) {
    at = outcome.path.best;
    outcome.best = outcome.path.misfit;
  }
  outcome_.stages.push_back(outcome);
  return ended;
}

bool CalibrationRun::search() {
  const Clock::time_point began = Clock::now();
  const int reused = evaluations_.runs_reused();
  outcome_.predicted = predict().hours;
  UnitPoint at = start_of(spec_);
  for (const StageSpec& stage : spec_.stages)
    if (!run_stage(stage, at)) return false;
  if (spec_.cap > 0.0) at = most_met(spec_, comparable())->point;  // the number of targets met decides
  const Fidelity last = fidelity_of(spec_, spec_.stages.back());
  const std::vector<UnitPoint> sets = difference_sets(spec_, at);
  print_progress("differences about the best set");
  if (!evaluations_.carry_out(last, sets, jobs_)) return false;
  for (const UnitPoint& set : sets) outcome_.around.push_back(evaluations_.known(last, set));
  if (!confirm(at) || !seek_single_targets()) return false;
  outcome_.determination = determination_of(spec_, *outcome_.best, outcome_.around);
  outcome_.trade_offs = trade_offs_of(spec_, *outcome_.best, outcome_.around);
  outcome_.taken = hours_since(began);
  outcome_.whole_time = reused == 0 || evaluations_.runs_done() > 9 * evaluations_.runs_reused();
  return true;
}

// Runs the set whole, and sets near it that should meet more targets.
bool CalibrationRun::confirm(UnitPoint at) {
  const Fidelity whole = full_fidelity(spec_), searched = fidelity_of(spec_, spec_.stages.back());
  const Determination about = determination_of(spec_, *evaluations_.known(searched, at), outcome_.around);
  std::vector<const Evaluation*> confirmed;
  while (static_cast<int>(confirmed.size()) < spec_.confirm) {
    print_progress("confirmation");
    if (!evaluations_.carry_out(whole, {at}, jobs_)) return false;
    confirmed.push_back(evaluations_.known(whole, at));
    outcome_.confirmed = most_met(spec_, confirmed);
    const UnitPoint next = adjusted(spec_, *outcome_.confirmed, about.sensitivity);
    if (std::any_of(confirmed.begin(), confirmed.end(), [&](const Evaluation* e) { return e->point == next; })) break;
    at = next;
  }
  outcome_.confirmations = static_cast<int>(confirmed.size());
  if (!evaluations_.carry_out(searched, {outcome_.confirmed->point}, jobs_)) return false;
  outcome_.best = evaluations_.known(searched, outcome_.confirmed->point);
  return true;
}

// By response surfaces, from all known sets, starting at the one nearest to the target.
bool CalibrationRun::seek_single_targets() {
  if (spec_.single_target == 0) return true;
  const std::vector<const Evaluation*> sets = comparable();
  std::vector<UnitPoint> known(sets.size());
  std::transform(sets.begin(), sets.end(), known.begin(), [](const Evaluation* e) { return e->point; });
  StageSpec stage = spec_.stages.back();
  stage.method = SearchMethod::kSurrogate;
  stage.evaluations = spec_.single_target + 1;  // with the known first one
  for (const std::size_t target : conflicts_of(spec_, sets).never) {
    print_progress("target " + spec_.targets[target].name);
    Fidelity fidelity = fidelity_of(spec_, stage);
    fidelity.single_target = target;
    if (!evaluations_.carry_out(fidelity, known, jobs_)) return false;
    const auto less = [&](const Evaluation* a, const Evaluation* b) {
      return distance(a->targets[target]) < distance(b->targets[target]);
    };
    SingleTarget found;
    found.target = target;
    found.moved_by = evaluations_.moved_by(fidelity, target);
    found.before = sets.size();
    found.nearest = *std::min_element(sets.begin(), sets.end(), less);
    found.nearest_before = distance(found.nearest->targets[target]);
    StageSearch search({spec_, evaluations_, fidelity, stage, found.nearest->point, known, jobs_, 0.0});
    SearchPath path = search.go();
    for (; !path.requested.empty(); path = search.go())
      if (!evaluations_.carry_out(fidelity, path.requested, jobs_)) return false;
    found.sets = path.sets.size() - 1;
    for (const UnitPoint& set : path.sets) {
      const Evaluation* e = evaluations_.known(fidelity, set);
      if (!e->targets[target].failed && less(e, found.nearest)) found.nearest = e;
    }
    outcome_.single_targets.push_back(found);
  }
  return true;
}

std::vector<UnitPoint> CalibrationRun::sets_with_runs_of(const StageSpec& stage) const {
  std::vector<UnitPoint> sets;
  for (std::size_t k = 0; k < outcome_.stages.size(); ++k)
    if (spec_.stages[k].settings == stage.settings && spec_.stages[k].until == stage.until)
      for (const Evaluation* e : outcome_.stages[k].evaluations) sets.push_back(e->point);
  return sets;
}

std::vector<const Evaluation*> CalibrationRun::comparable() const {
  std::vector<const Evaluation*> sets;
  std::set<const Evaluation*> coordinates;
  const auto add = [&](const Evaluation* e) {
    if (e && coordinates.insert(e).second) sets.push_back(e);
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

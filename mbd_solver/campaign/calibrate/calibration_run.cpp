// Each step requests sets and carries out their missing runs; an interrupted calibration repeats the steps on finished runs.
#include "mbd_solver/campaign/calibrate/calibration_run.h"

#include <algorithm>
#include <cstdio>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/studies/codes.h"

namespace footfall {
namespace {

const Fidelity kWholeOnce = {};  // for the time of the confirmation

std::vector<UnitPoint> points_of(const Sets& sets) {
  std::vector<UnitPoint> points;
  for (const EvaluatedPoint* e : sets) points.push_back(e->point);
  return points;
}

}  // namespace

bool CalibrationRun::start() {
  const UnitPoint at = start_of(spec_);
  std::vector<Fidelity> all = {kWholeOnce};
  for (const StageSpec& stage : spec_.stages) all.push_back(fidelity_of(spec_, stage));
  for (const Fidelity& fidelity : all) {
    if (!evaluations_.carry_out(fidelity, {at}, true)) return false;
    outcome_.start = evaluations_.known(fidelity, at);
    if (!outcome_.start->message.empty())
      throw NumericalError(code::kStartFailed, spec_.file +
                                                   ": a run of the start has failed: " + outcome_.start->message +
                                                   "; give parameters a start with which every scene runs");
  }
  return true;
}

std::vector<std::string> CalibrationRun::prediction() const {
  std::vector<std::string> lines = {""};
  int all_sets = 0, all_runs = 0;
  double all_hours = 0.0;
  const auto add = [&](const std::string& what, const EvaluatedPoint& like, int sets, int runs_per_set,
                       bool sequential) {
    const int runs = sets * runs_per_set, jobs = evaluations_.jobs();
    const int rounds = sequential ? (runs_per_set + jobs - 1) / jobs * sets : (runs + jobs - 1) / jobs;
    const double hours = rounds * like.lasted / 3600.0;
    all_sets += sets, all_runs += runs, all_hours += hours;
    lines.push_back("  " + what + ": " + std::to_string(sets) + (sets == 1 ? " set, " : " sets, ") +
                    std::to_string(runs) + " runs, " + number_text(hours, 3) + " h");
  };
  for (const StageSpec& stage : spec_.stages) {
    const EvaluatedPoint& like = *evaluations_.known(fidelity_of(spec_, stage), start_of(spec_));
    const bool sequential = stage.method == SearchMethod::kSbplx || stage.method == SearchMethod::kSurrogate;
    add("stage " + std::string(name_of(stage.method)), like, stage.evaluations, like.runs, sequential);
  }
  const EvaluatedPoint &last = *outcome_.start, &whole = *evaluations_.known(kWholeOnce, start_of(spec_));
  add("differences about the best set", last, 2 * static_cast<int>(spec_.parameters.size()), last.runs, false);
  const int tries = spec_.single_target * (static_cast<int>(spec_.targets.size()) - last.met());
  if (tries > 0) add("targets that are not met at the start, one by one", last, tries, std::min(2, last.runs), true);
  add("confirmation", whole, spec_.confirm, whole.runs * full_fidelity(spec_).seeds, false);
  lines.front() = "remaining, at most: " + std::to_string(all_sets) + " sets, " + std::to_string(all_runs) +
                  " runs, about " + number_text(all_hours, 3) + " h";
  return lines;
}

void CalibrationRun::print_progress(const std::string& text) const {
  if (evaluations_.is_read_only()) return;
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

bool CalibrationRun::carry_out_search(const StageSpec& stage, const Fidelity& fidelity, const UnitPoint& start,
                                      const Sets& earlier, SearchPath& path) {
  if (stage.method == SearchMethod::kSurrogate) {
    path = surrogate_path(stage, start, surrogate_queries(fidelity, start, earlier));
    return path.requested.empty();
  }
  SearchQueries queries;
  queries.misfit = [&](const UnitPoint& set) -> std::optional<double> {
    const EvaluatedPoint* e = evaluations_.known(fidelity, set);
    if (!e) return {};
    return e->misfit;
  };
  queries.residuals = [&](const UnitPoint& set) {
    const EvaluatedPoint* e = evaluations_.known(fidelity, set);
    return e->message.empty() ? e->residuals(spec_) : std::vector<double>();
  };
  const std::size_t runs_per_set = spec_.scenes.size() * static_cast<std::size_t>(fidelity.seeds);
  const std::size_t at_once = (static_cast<std::size_t>(evaluations_.jobs()) + runs_per_set - 1) / runs_per_set;
  do {
    path = search_path(stage, start, spec_.step, queries, at_once);
  } while (!path.requested.empty() && evaluations_.carry_out(fidelity, path.requested));
  return path.requested.empty();
}

SurrogateQueries CalibrationRun::surrogate_queries(const Fidelity& fidelity, const UnitPoint& start,
                                                   const Sets& earlier) {
  SurrogateQueries queries;
  std::vector<std::pair<std::size_t, std::size_t>> numbers;  // their targets and rows
  for (std::size_t t = 0; t < spec_.targets.size(); ++t) {
    if (fidelity.single_target.value_or(t) != t) continue;
    const std::size_t rows = evaluations_.known(fidelity, start)->targets[t].values.size();
    for (std::size_t row = 0; row < rows; ++row) numbers.emplace_back(t, row);
    queries.moved_by.insert(queries.moved_by.end(), rows, evaluations_.moved_by(fidelity, t));
  }
  queries.earlier = points_of(earlier);
  queries.part = [this, numbers, cap = fidelity.single_target ? 0.0 : spec_.cap](std::size_t k, double y) {
    const TargetSpec& target = spec_.targets[numbers[k].first];
    const double counted = capped(residual_of(target, y, numbers[k].second), cap);
    return target.weight * counted * counted;
  };
  queries.numbers = [this, numbers, fidelity](const UnitPoint& set) -> std::optional<std::vector<double>> {
    if (!evaluations_.carry_out(fidelity, {set})) return {};
    const EvaluatedPoint& e = *evaluations_.known(fidelity, set);
    std::vector<double> all;
    for (const auto& [t, row] : numbers) {
      if (e.targets[t].failed) return std::vector<double>();
      all.push_back(e.targets[t].values[row]);
    }
    return all;
  };
  queries.allowed = [this](const UnitPoint& set) { return violation_of(spec_, set) == 0.0; };
  return queries;
}

bool CalibrationRun::run_stage(const StageSpec& stage, UnitPoint& at) {
  const Fidelity fidelity = fidelity_of(spec_, stage);
  if (!evaluations_.carry_out(fidelity, {at})) return false;
  StageOutcome outcome;
  outcome.best = evaluations_.known(fidelity, at)->misfit;
  const bool ended = carry_out_search(stage, fidelity, at, sets_like(stage), outcome.path);
  for (const UnitPoint& set : outcome.path.sets) outcome.evaluations.push_back(evaluations_.known(fidelity, set));
  if (outcome.path.misfit < outcome.best) at = outcome.path.best, outcome.best = outcome.path.misfit;
  outcome_.stages.push_back(outcome);
  print_progress(std::string(name_of(stage.method)) + ": " + std::to_string(outcome.path.sets.size()) +
                 " sets, best misfit " + number_text(outcome.best, 5));
  return ended;
}

bool CalibrationRun::search() {
  UnitPoint at = start_of(spec_);
  for (const StageSpec& stage : spec_.stages)
    if (!run_stage(stage, at)) return false;
  if (spec_.cap > 0.0) at = most_met(spec_, comparable())->point;  // the number of targets met decides
  const Fidelity last = fidelity_of(spec_, spec_.stages.back());
  const std::vector<UnitPoint> sets = difference_sets(spec_, at);
  print_progress("differences about the best set");
  if (!evaluations_.carry_out(last, sets)) return false;
  for (const UnitPoint& set : sets) outcome_.around.push_back(evaluations_.known(last, set));
  if (!confirm(at) || !seek_single_targets()) return false;
  outcome_.determination = determination_of(spec_, *outcome_.best, outcome_.around);
  return true;
}

// Runs the set whole, and sets near it that should meet more targets.
bool CalibrationRun::confirm(UnitPoint at) {
  const Fidelity whole = full_fidelity(spec_), searched = fidelity_of(spec_, spec_.stages.back());
  const Determination about = determination_of(spec_, *evaluations_.known(searched, at), outcome_.around);
  Sets confirmed;
  while (static_cast<int>(confirmed.size()) < spec_.confirm) {
    print_progress("confirmation");
    if (!evaluations_.carry_out(whole, {at})) return false;
    confirmed.push_back(evaluations_.known(whole, at));
    outcome_.confirmed = most_met(spec_, confirmed);
    at = adjusted(spec_, *outcome_.confirmed, about.sensitivity);
    if (std::any_of(confirmed.begin(), confirmed.end(), [&](const EvaluatedPoint* e) { return e->point == at; })) break;
  }
  outcome_.confirmations = confirmed.size();
  if (!evaluations_.carry_out(searched, {outcome_.confirmed->point})) return false;
  outcome_.best = evaluations_.known(searched, outcome_.confirmed->point);
  return true;
}

// By response surfaces, from all known sets, starting at the one nearest to the target.
bool CalibrationRun::seek_single_targets() {
  if (spec_.single_target == 0) return true;
  const Sets sets = comparable();
  StageSpec stage = spec_.stages.back();
  stage.method = SearchMethod::kSurrogate;
  stage.evaluations = spec_.single_target + 1;  // with the known first one
  for (const std::size_t target : conflicts_of(spec_, sets).never) {
    print_progress("target " + spec_.targets[target].name);
    Fidelity fidelity = fidelity_of(spec_, stage);
    fidelity.single_target = target;
    if (!evaluations_.carry_out(fidelity, points_of(sets))) return false;
    const auto less = [&](const EvaluatedPoint* a, const EvaluatedPoint* b) {
      return a->targets[target].distance() < b->targets[target].distance();
    };
    SingleTarget found{target, 0, *std::min_element(sets.begin(), sets.end(), less)};
    SearchPath path;
    if (!carry_out_search(stage, fidelity, found.nearest->point, sets, path)) return false;
    found.sets = path.sets.size() - 1;
    for (const UnitPoint& set : path.sets) {
      const EvaluatedPoint* e = evaluations_.known(fidelity, set);
      if (!e->targets[target].failed && less(e, found.nearest)) found.nearest = e;
    }
    outcome_.single_targets.push_back(found);
  }
  return true;
}

Sets CalibrationRun::sets_like(const StageSpec& stage) const {
  Sets sets;
  for (std::size_t k = 0; k < outcome_.stages.size(); ++k)
    if (spec_.stages[k].settings == stage.settings && spec_.stages[k].until == stage.until)
      sets.insert(sets.end(), outcome_.stages[k].evaluations.begin(), outcome_.stages[k].evaluations.end());
  return sets;
}

Sets CalibrationRun::comparable() const {
  Sets all = sets_like(spec_.stages[outcome_.stages.size() - 1]), sets;
  all.insert(all.end(), outcome_.around.begin(), outcome_.around.end());
  if (outcome_.best) all.push_back(outcome_.best);
  for (const EvaluatedPoint* e : all)
    if (std::find(sets.begin(), sets.end(), e) == sets.end()) sets.push_back(e);
  return sets;
}

}  // namespace footfall

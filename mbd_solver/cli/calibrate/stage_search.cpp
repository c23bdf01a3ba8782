#include "mbd_solver/cli/calibrate/stage_search.h"

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

}  // namespace footfall

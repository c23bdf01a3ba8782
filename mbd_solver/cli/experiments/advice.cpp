#include "mbd_solver/cli/experiments/advice.h"

#include <algorithm>
#include <cmath>

namespace footfall {
namespace {

bool is_judged(const CaseResult& point) {
  return point.code == 0 && std::all_of(point.figures.begin(), point.figures.end(),
                                        [](const SampledFigure& f) { return std::isfinite(f.error); });
}

// The figure with the largest error, but for one.
std::size_t worst_figure(const CaseResult& point, std::size_t apart = kNoFigure) {
  std::size_t worst = kNoFigure;
  for (std::size_t m = 0; m < point.figures.size(); ++m)
    if (m != apart && (worst == kNoFigure || point.figures[m].error > point.figures[worst].error)) worst = m;
  return worst;
}

double largest_error(const CaseResult& point, std::size_t apart = kNoFigure) {
  return point.figures[worst_figure(point, apart)].error;
}

// What the curve's run times are measured by.
const CaseResult* yardstick(const ExperimentSpec& spec, const Results& results, int curve) {
  const CaseResult *own = nullptr, *common = nullptr;
  for (const CaseResult& c : results.cases) {
    if (c.is_of(curve) && c.plan.value == spec.curves[static_cast<std::size_t>(curve)].default_value && c.code == 0)
      return &c;
    if (!c.plan.is_reference) continue;
    if (c.plan.curve == curve && !own) own = &c;
    if (c.plan.curve < 0) common = &c;
  }
  return own ? own : common;
}

Advice advice_for(const ExperimentSpec& spec, const Results& results, const CaseResult& point, double limit,
                  std::size_t apart = kNoFigure) {
  Advice advice;
  advice.point = &point;
  advice.apart = apart;
  advice.worst = worst_figure(point, apart);
  for (std::size_t k = 0; k < point.figures.size(); ++k)
    if (k != apart && point.figures[k].standard_error > limit) advice.resolved = false;
  const CaseResult* by = yardstick(spec, results, point.plan.curve);
  advice.time_ratio = by && by->cost.cpu > 0.0 ? point.cost.cpu / by->cost.cpu : 0.0;
  return advice;
}

Advice advice_of_curve(const ExperimentSpec& spec, const Results& results, int curve, double limit) {
  // The first case from which on all are within the limit; null without.
  const auto first_within = [&](std::size_t apart) {
    const CaseResult* first = nullptr;
    for (const CaseResult& c : results.cases) {
      if (!c.is_of(curve)) continue;
      const bool within = is_judged(c) && largest_error(c, apart) <= limit;
      first = !within ? nullptr : first ? first : &c;
    }
    return first;
  };
  const CaseResult* best = nullptr;
  for (const CaseResult& c : results.cases)
    if (c.is_of(curve) && is_judged(c) && (!best || largest_error(c) < largest_error(*best))) best = &c;
  if (!best) return {};
  std::size_t apart = kNoFigure;
  const CaseResult* chosen = first_within(apart);
  if (!chosen && best->figures.size() > 1) {
    apart = worst_figure(*best);
    chosen = first_within(apart);
  }
  Advice advice = chosen ? advice_for(spec, results, *chosen, limit, apart) : advice_for(spec, results, *best, limit);
  advice.within = chosen != nullptr;
  return advice;
}

}  // namespace

std::vector<Advice> advice_of(const ExperimentSpec& spec, const Results& results, double limit) {
  std::vector<Advice> advice;
  for (int curve = 0; curve < static_cast<int>(spec.curves.size()); ++curve)
    advice.push_back(advice_of_curve(spec, results, curve, limit));
  return advice;
}

std::vector<Advice> errors_of_defaults(const ExperimentSpec& spec, const Results& results) {
  std::vector<Advice> defaults;
  for (const CaseResult& c : results.cases)
    if (c.plan.curve >= 0 && !c.plan.is_reference && is_judged(c) &&
        c.plan.value == spec.curves[static_cast<std::size_t>(c.plan.curve)].default_value)
      defaults.push_back(advice_for(spec, results, c, 1.0));
  std::sort(defaults.begin(), defaults.end(),
            [](const Advice& a, const Advice& b) { return a.largest().error > b.largest().error; });
  return defaults;
}

}  // namespace footfall

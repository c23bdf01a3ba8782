#include "mbd_solver/cli/experiments/advice.h"

#include <algorithm>
#include <cmath>

namespace footfall {
namespace {

using Points = std::vector<const CaseResult*>;

Points points_of(const ErrorTable& table, std::size_t curve) {
  Points points;
  for (const CaseResult& point : table.points)
    if (point.plan.curve == static_cast<int>(curve)) points.push_back(&point);
  return points;
}

constexpr std::size_t kNothing = static_cast<std::size_t>(-1);

bool is_judged(const CaseResult& point) {
  return point.code == 0 && std::all_of(point.figures.begin(), point.figures.end(),
                                        [](const SampledFigure& f) { return std::isfinite(f.error); });
}

// The figure with the largest error, but for one.
std::size_t worst_figure(const CaseResult& point, std::size_t apart) {
  std::size_t worst = kNothing;
  for (std::size_t m = 0; m < point.figures.size(); ++m)
    if (m != apart && (worst == kNothing || point.figures[m].error > point.figures[worst].error)) worst = m;
  return worst;
}

double largest_error(const CaseResult& point, std::size_t apart = kNothing) {
  const std::size_t m = worst_figure(point, apart);
  return m == kNothing ? 0.0 : point.figures[m].error;
}

// The first point from which on all are within the limit; null without.
const CaseResult* first_within(const Points& points, double limit, std::size_t apart) {
  const CaseResult* first = nullptr;
  for (const CaseResult* point : points) {
    const bool within = is_judged(*point) && largest_error(*point, apart) <= limit;
    if (!within)
      first = nullptr;
    else if (!first)
      first = point;
  }
  return first;
}

// What the curve's run times are measured by.
const CaseResult* yardstick(const ErrorTable& table, int curve) {
  for (const CaseResult& point : table.points)
    if (point.plan.curve == curve && point.plan.value == table.defaults[static_cast<std::size_t>(curve)] &&
        point.code == 0)
      return &point;
  const CaseResult* common = nullptr;
  for (const CaseResult& reference : table.references) {
    if (reference.plan.curve == curve) return &reference;
    if (reference.plan.curve < 0) common = &reference;
  }
  return common;
}

// All but `value`.
Advice told(const ErrorTable& table, const CaseResult& point, double limit, std::size_t apart = kNothing) {
  Advice advice;
  advice.curve = table.curve_of(point);
  advice.best = point.plan.value;
  const std::size_t m = worst_figure(point, apart);
  if (apart != kNothing) {
    advice.apart = table.figures[apart];
    advice.apart_error = point.figures[apart].error;
  }
  advice.figure = table.figures[m];
  advice.error = point.figures[m].error;
  for (std::size_t k = 0; k < point.figures.size(); ++k) {
    if (k == m && std::isfinite(point.figures[k].standard_error))
      advice.standard_error = point.figures[k].standard_error;
    if (k != apart && point.figures[k].standard_error > limit) advice.resolved = false;
  }
  const CaseResult* by = yardstick(table, point.plan.curve);
  advice.time_ratio = by && by->cost.cpu > 0.0 ? point.cost.cpu / by->cost.cpu : 0.0;
  return advice;
}

}  // namespace

std::vector<Advice> advice_of(const ErrorTable& table, double limit) {
  std::vector<Advice> result;
  for (std::size_t c = 0; c < table.curves.size(); ++c) {
    const Points points = points_of(table, c);
    const CaseResult* best = nullptr;
    for (const CaseResult* point : points)
      if (is_judged(*point) && (!best || largest_error(*point) < largest_error(*best))) best = point;
    Advice advice;
    advice.curve = table.curves[c];
    if (best) {
      std::size_t apart = kNothing;
      const CaseResult* chosen = first_within(points, limit, apart);
      if (!chosen && best->figures.size() > 1) {
        apart = worst_figure(*best, kNothing);
        chosen = first_within(points, limit, apart);
      }
      advice = chosen ? told(table, *chosen, limit, apart) : told(table, *best, limit);
      if (chosen) advice.value = chosen->plan.value;
    }
    result.push_back(advice);
  }
  return result;
}

std::vector<Advice> errors_of_defaults(const ErrorTable& table) {
  std::vector<Advice> result;
  for (std::size_t c = 0; c < table.curves.size(); ++c) {
    for (const CaseResult* point : points_of(table, c)) {
      if (point->plan.value != table.defaults[c] || !is_judged(*point)) continue;
      result.push_back(told(table, *point, 1.0));
      result.back().value = point->plan.value;
    }
  }
  std::sort(result.begin(), result.end(), [](const Advice& a, const Advice& b) { return a.error > b.error; });
  return result;
}

}  // namespace footfall

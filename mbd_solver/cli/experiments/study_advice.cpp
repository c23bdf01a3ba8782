#include "mbd_solver/cli/experiments/study_advice.h"

#include <algorithm>
#include <cmath>

namespace footfall {
namespace {

using Points = std::vector<const StudyPoint*>;

Points points_of(const StudyTable& table, const std::string& curve) {
  Points points;
  for (const StudyPoint& point : table.points)
    if (point.curve == curve) points.push_back(&point);
  return points;
}

constexpr std::size_t kNothing = static_cast<std::size_t>(-1);

bool is_judged(const StudyPoint& point) {
  return point.code == 0 &&
         std::all_of(point.errors.begin(), point.errors.end(), [](double e) { return std::isfinite(e); });
}

// The measure with the largest error, but for one.
std::size_t worst_measure(const StudyPoint& point, std::size_t apart) {
  std::size_t worst = kNothing;
  for (std::size_t m = 0; m < point.errors.size(); ++m)
    if (m != apart && (worst == kNothing || point.errors[m] > point.errors[worst])) worst = m;
  return worst;
}

double largest_error(const StudyPoint& point, std::size_t apart = kNothing) {
  const std::size_t m = worst_measure(point, apart);
  return m == kNothing ? 0.0 : point.errors[m];
}

// The first point from which on all are within the limit; null without.
const StudyPoint* first_within(const Points& points, double limit, std::size_t apart) {
  const StudyPoint* first = nullptr;
  for (const StudyPoint* point : points) {
    const bool within = is_judged(*point) && largest_error(*point, apart) <= limit;
    if (!within)
      first = nullptr;
    else if (!first)
      first = point;
  }
  return first;
}

// What the curve's run times are measured by.
const StudyPoint* yardstick(const StudyTable& table, const std::string& curve, const std::string& default_value) {
  for (const StudyPoint& point : table.points)
    if (point.curve == curve && point.value == default_value && point.code == 0) return &point;
  const StudyPoint* common = nullptr;
  for (const StudyPoint& reference : table.references) {
    if (reference.curve == curve) return &reference;
    if (reference.curve == "reference") common = &reference;
  }
  return common;
}

// All but `value`.
Advice told(const StudyTable& table, const StudyPoint& point, const std::string& default_value, double limit,
            std::size_t apart = kNothing) {
  Advice advice;
  advice.curve = point.curve;
  advice.best = point.value;
  const std::size_t m = worst_measure(point, apart);
  if (apart != kNothing) {
    advice.apart = table.measures[apart];
    advice.apart_error = point.errors[apart];
  }
  advice.measure = table.measures[m];
  advice.error = point.errors[m];
  for (std::size_t k = 0; k < point.sampled.size(); ++k) {
    if (k == m && std::isfinite(point.sampled[k].standard_error))
      advice.standard_error = point.sampled[k].standard_error;
    if (k != apart && point.sampled[k].standard_error > limit) advice.resolved = false;
  }
  const StudyPoint* by = yardstick(table, point.curve, default_value);
  advice.time_ratio = by && by->cpu > 0.0 ? point.cpu / by->cpu : 0.0;
  return advice;
}

}  // namespace

std::vector<Advice> advice_of(const StudyTable& table, double limit) {
  std::vector<Advice> result;
  for (std::size_t c = 0; c < table.curves.size(); ++c) {
    const Points points = points_of(table, table.curves[c]);
    const StudyPoint* best = nullptr;
    for (const StudyPoint* point : points)
      if (is_judged(*point) && (!best || largest_error(*point) < largest_error(*best))) best = point;
    Advice advice;
    advice.curve = table.curves[c];
    if (best) {
      std::size_t apart = kNothing;
      const StudyPoint* chosen = first_within(points, limit, apart);
      if (!chosen && best->errors.size() > 1) {
        apart = worst_measure(*best, kNothing);
        chosen = first_within(points, limit, apart);
      }
      advice =
          chosen ? told(table, *chosen, table.defaults[c], limit, apart) : told(table, *best, table.defaults[c], limit);
      if (chosen) advice.value = chosen->value;
    }
    result.push_back(advice);
  }
  return result;
}

std::vector<Advice> errors_of_defaults(const StudyTable& table) {
  std::vector<Advice> result;
  for (std::size_t c = 0; c < table.curves.size(); ++c) {
    for (const StudyPoint* point : points_of(table, table.curves[c])) {
      if (point->value != table.defaults[c] || !is_judged(*point)) continue;
      result.push_back(told(table, *point, table.defaults[c], 1.0));
      result.back().value = point->value;
    }
  }
  std::sort(result.begin(), result.end(), [](const Advice& a, const Advice& b) { return a.error > b.error; });
  return result;
}

}  // namespace footfall

#include "mbd_solver/cli/study_advice.h"

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

bool is_judged(const StudyPoint& point) {
  return point.code == 0 && std::all_of(point.errors.begin(), point.errors.end(), [](double e) { return std::isfinite(e); });
}

double largest_error(const StudyPoint& point) { return *std::max_element(point.errors.begin(), point.errors.end()); }

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
Advice told(const StudyTable& table, const StudyPoint& point, const std::string& default_value, double limit) {
  Advice advice;
  advice.curve = point.curve;
  advice.best = point.value;
  const auto m = static_cast<std::size_t>(std::max_element(point.errors.begin(), point.errors.end()) - point.errors.begin());
  advice.measure = table.measures[m];
  advice.error = point.errors[m];
  for (std::size_t k = 0; k < point.sampled.size(); ++k) {
    if (k == m && std::isfinite(point.sampled[k].standard_error)) advice.standard_error = point.sampled[k].standard_error;
    if (point.sampled[k].standard_error > limit) advice.resolved = false;
  }
  const StudyPoint* by = yardstick(table, point.curve, default_value);
  advice.time_ratio = by && by->cpu > 0.0 ? point.cpu / by->cpu : 0.0;
  return advice;
}

}  // namespace

std::vector<Advice> advice_of(const StudyTable& table, double limit) {
  std::vector<Advice> result;
  for (std::size_t c = 0; c < table.curves.size(); ++c) {
    const StudyPoint *chosen = nullptr, *best = nullptr;
    for (const StudyPoint* point : points_of(table, table.curves[c])) {
      const bool within = is_judged(*point) && largest_error(*point) <= limit;
      if (!within) chosen = nullptr;
      else if (!chosen) chosen = point;
      if (is_judged(*point) && (!best || largest_error(*point) < largest_error(*best))) best = point;
    }
    Advice advice;
    advice.curve = table.curves[c];
    if (best) advice = told(table, chosen ? *chosen : *best, table.defaults[c], limit);
    if (chosen) advice.value = chosen->value;
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

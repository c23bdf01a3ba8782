#include "mbd_solver/cli/calibrate/target_texts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/text.h"

namespace footfall {

std::string wanted(const TargetSpec& t) {
  if (t.is_curve()) return "curve " + std::filesystem::path(t.file).filename().string();
  if (t.value) return number_text(*t.value);
  if (t.least == t.most) return number_text(t.least);
  if (std::isinf(t.least)) return "at most " + number_text(t.most);
  if (std::isinf(t.most)) return "at least " + number_text(t.least);
  return number_text(t.least) + " to " + number_text(t.most);
}

double distance(const TargetResult& t) {
  double sum = 0.0;
  for (const double r : t.residuals) sum += r * r;
  return std::sqrt(sum / static_cast<double>(t.residuals.size()));
}

std::string value_text(const TargetSpec& spec, const TargetResult& t) {
  if (t.failed) return "failed";
  if (spec.is_curve()) return "within " + number_text(distance(t), 3) + " tolerances";
  return number_text(t.values.front(), 4) + (t.of_seed.size() > 1 ? " +- " + number_text(t.spread.front(), 2) : "");
}

int seeds_that_meet(const TargetSpec& spec, const TargetResult& t) {
  if (t.of_seed.size() < 2 || spec.is_curve()) return t.is_met() ? static_cast<int>(t.of_seed.size()) : 0;
  return static_cast<int>(std::count_if(t.of_seed.begin(), t.of_seed.end(), [&](const std::vector<double>& y) {
    return TargetResult::met({residual_of(spec, y.front())}, spec.is_band());
  }));
}

}  // namespace footfall

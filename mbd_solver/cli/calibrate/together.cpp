#include "mbd_solver/cli/calibrate/together.h"

#include <algorithm>

#include "coupler/base/text.h"

namespace footfall {

const Evaluation* most_met(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets) {
  const auto met = [&](const Evaluation* e) {
    double sum = 0.0;
    for (std::size_t t = 0; t < spec.targets.size(); ++t)
      if (e->targets[t].is_met()) sum += spec.targets[t].weight;
    return sum;
  };
  const Evaluation* most = sets.front();
  for (const Evaluation* e : sets)
    if (met(e) > met(most) || (met(e) == met(most) && e->misfit < most->misfit)) most = e;
  return most;
}

std::vector<std::size_t> weightiest(const CalibrationSpec& spec) {
  double most = 0.0;
  for (const TargetSpec& target : spec.targets) most = std::max(most, target.weight);
  std::vector<std::size_t> chosen;
  for (std::size_t t = 0; t < spec.targets.size(); ++t)
    if (spec.targets[t].weight == most) chosen.push_back(t);
  return chosen;
}

int met_of(const Evaluation& set, const std::vector<std::size_t>& targets) {
  return static_cast<int>(
      std::count_if(targets.begin(), targets.end(), [&](std::size_t t) { return set.targets[t].is_met(); }));
}

Apart apart(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets) {
  const auto count = [&](std::size_t a, std::size_t b) {
    return static_cast<int>(std::count_if(sets.begin(), sets.end(), [&](const Evaluation* e) {
      return e->targets[a].is_met() && e->targets[b].is_met();
    }));
  };
  Apart found;
  for (std::size_t a = 0; a < spec.targets.size(); ++a) {
    if (count(a, a) == 0) found.never.push_back(a);
    for (std::size_t b = a + 1; b < spec.targets.size(); ++b)
      if (count(a, a) > 0 && count(b, b) > 0 && count(a, b) == 0)
        found.pairs.push_back({a, b, count(a, a), count(b, b)});
  }
  return found;
}

namespace {

// Of the targets from `first` on, those in `out` left aside: the first is taken, or it is not.
std::size_t most_from(std::size_t first, std::vector<int> out, const std::vector<std::vector<std::size_t>>& others) {
  const std::size_t n = others.size();
  while (first < n && out[first] > 0) ++first;
  if (first >= n) return 0;
  std::vector<int> with = out;
  std::size_t open = 0;
  for (const std::size_t other : others[first]) open += other > first && with[other]++ == 0 ? 1 : 0;
  const std::size_t taken = 1 + most_from(first + 1, with, others);
  if (open <= 1) return taken;  // with one other at most, taking it is never worse
  return std::max(taken, most_from(first + 1, out, others));
}

}  // namespace

std::size_t most_without_a_pair(const Apart& apart, const std::vector<std::size_t>& targets) {
  const std::size_t n = targets.empty() ? 0 : 1 + *std::max_element(targets.begin(), targets.end());
  std::vector<int> out(n, 1);
  for (const std::size_t target : targets) out[target] = 0;
  std::vector<std::vector<std::size_t>> others(n);
  for (const Apart::Pair& pair : apart.pairs)
    if (pair.a < n && pair.b < n) others[pair.a].push_back(pair.b), others[pair.b].push_back(pair.a);
  for (const std::size_t target : apart.never)
    if (target < n) out[target] = 1;
  return most_from(0, out, others);
}

PagePart apart_part(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets) {
  PagePart part;
  const Apart found = apart(spec, sets);
  std::vector<std::string> never;
  for (const std::size_t t : found.never) never.push_back(spec.targets[t].name);
  part.text =
      never.empty() ? " Every target was met by some set." : "\n\nMet by none of them: " + joined(never, "; ") + ".";
  if (found.pairs.empty()) return part;
  const std::vector<std::size_t> chosen = weightiest(spec);
  part.text += "\n\nAs far as pairs tell, at most " + std::to_string(most_without_a_pair(found, chosen)) + " of the " +
               std::to_string(chosen.size()) + (chosen.size() < spec.targets.size() ? " weightiest" : "") +
               " targets can come together. Each met by some sets, and by none together:";
  part.rows = {{"target", "and target", "sets that meet the one", "the other", "both"}};
  for (const Apart::Pair& pair : found.pairs)
    part.rows.push_back({spec.targets[pair.a].name, spec.targets[pair.b].name, std::to_string(pair.met_a),
                         std::to_string(pair.met_b), "0"});
  return part;
}

}  // namespace footfall

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

PagePart apart_part(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets) {
  PagePart part;
  const Apart found = apart(spec, sets);
  std::vector<std::string> never;
  for (const std::size_t t : found.never) never.push_back(spec.targets[t].name);
  part.text =
      never.empty() ? " Every target was met by some set." : "\n\nMet by none of them: " + joined(never, "; ") + ".";
  if (found.pairs.empty()) return part;
  part.text += "\n\nEach met by some sets, and by none together:";
  part.rows = {{"target", "and target", "sets that meet the one", "the other", "both"}};
  for (const Apart::Pair& pair : found.pairs)
    part.rows.push_back({spec.targets[pair.a].name, spec.targets[pair.b].name, std::to_string(pair.met_a),
                         std::to_string(pair.met_b), "0"});
  return part;
}

}  // namespace footfall

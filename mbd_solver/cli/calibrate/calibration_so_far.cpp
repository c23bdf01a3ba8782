// The page of a calibration that has not ended: sets that are known by now, run as the stage under way runs them.
#include <algorithm>

#include "coupler/base/text.h"
#include "mbd_solver/cli/calibrate/calibration_page.h"
#include "mbd_solver/cli/calibrate/target_texts.h"

namespace footfall {
namespace {

PagePart sets_part(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets, const Evaluation& least,
                   const Evaluation& most) {
  PagePart part;
  part.heading = "Parameters";
  part.rows = {{"parameter", "range", "start", "least misfit", "most met", "source of the range"}};
  const Shares start = start_of(spec);
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const SoughtParameter& p = spec.parameters[i];
    part.rows.push_back({p.name, number_text(p.least) + " to " + number_text(p.most), number_text(p.value(start[i])),
                         number_text(p.value(least.shares[i]), 4), number_text(p.value(most.shares[i]), 4), p.origin});
  }
  part.text = "Of " + std::to_string(sets.size()) + " sets the one of least misfit, " + number_text(least.misfit, 4) +
              ", meets " + std::to_string(least.met()) + " of " + std::to_string(spec.targets.size()) +
              " targets; the one that meets most meets " + std::to_string(most.met()) + ", with a misfit of " +
              number_text(most.misfit, 4) + ".";
  return part;
}

PagePart met_part(const CalibrationSpec& spec, const CalibrationOutcome& o, const std::vector<const Evaluation*>& sets,
                  const Evaluation& most) {
  PagePart part;
  part.heading = "Targets";
  part.text = "Off: distance in the set that meets most, and the least of all sets [tolerances].";
  part.rows = {{"target", "wanted", "start", "most met", "off", "least off", "sets that meet it", "source"}};
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    const auto met =
        std::count_if(sets.begin(), sets.end(), [&](const Evaluation* e) { return e->targets[t].is_met(); });
    double least = distance(most.targets[t]);
    for (const Evaluation* e : sets)
      if (!e->targets[t].failed) least = std::min(least, distance(e->targets[t]));
    part.rows.push_back({spec.targets[t].name, wanted(spec.targets[t]),
                         value_text(spec.targets[t], o.start->targets[t]), value_text(spec.targets[t], most.targets[t]),
                         number_text(distance(most.targets[t]), 3), number_text(least, 3),
                         std::to_string(met) + " of " + std::to_string(sets.size()), spec.targets[t].origin});
  }
  return part;
}

}  // namespace

std::vector<PagePart> so_far_parts(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                   const std::vector<const Evaluation*>& comparable, const std::string& command) {
  PagePart first;
  first.text =
      "So far, by `" + command + "`. The calibration has not ended: nothing is confirmed, and there are no intervals.";
  const StageSpec& asked = spec.stages[outcome.stages.size() - 1];
  if (comparable.empty()) return {first};
  first.text += " Stage " + std::to_string(outcome.stages.size()) + " of " + std::to_string(spec.stages.size()) + ", " +
                std::string(name_of(asked.method)) + ", of " + std::to_string(asked.evaluations) + " sets at most.";
  const Evaluation* least =
      *std::min_element(comparable.begin(), comparable.end(),
                        [](const Evaluation* a, const Evaluation* b) { return a->misfit < b->misfit; });
  const Evaluation* most = most_met(spec, comparable);
  PagePart together = apart_part(spec, comparable);
  together.heading = "What comes together";
  together.text.erase(0, together.text.find_first_not_of(" \n"));
  return {first, sets_part(spec, comparable, *least, *most), met_part(spec, outcome, comparable, *most), together};
}

}  // namespace footfall

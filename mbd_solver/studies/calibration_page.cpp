// Builds pages of parts: text, a table, pictures. gnuplot draws from the CSV files of the folder.
#include "mbd_solver/studies/calibration_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/report.h"

namespace footfall {

double distance(const TargetResult& t) {
  double sum = 0.0;
  for (const double r : t.residuals) sum += r * r;
  return std::sqrt(sum / static_cast<double>(t.residuals.size()));
}

namespace fs = std::filesystem;

namespace {

using PageRows = std::vector<std::vector<std::string>>;

constexpr double kSearchEnded = 1.0;  // largest gain of misfit by a linear step after the search

// "0.9 to 1.1", "at least 2", "0.5".
std::string requirement_text(const TargetSpec& t) {
  if (t.is_curve()) return "curve " + std::filesystem::path(t.file).filename().string();
  if (t.value) return number_text(*t.value);
  if (t.least == t.most) return number_text(t.least);
  if (std::isinf(t.least)) return "at most " + number_text(t.most);
  if (std::isinf(t.most)) return "at least " + number_text(t.least);
  return number_text(t.least) + " to " + number_text(t.most);
}

// The value with its spread over the seeds; "failed".
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

PagePart best_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part;
  part.heading = "The best set";
  const Determination& d = o.determination;
  part.text = "Intervals of " + percent(spec.confidence) + " %, from " + std::to_string(d.rows) +
              " numbers that depend on a parameter" +
              (d.scale > 1.0
                   ? ", widened by " + number_text(std::sqrt(d.scale), 3) + " because the misfit exceeds the tolerances"
                   : "") +
              ". Determined \"no\": the interval covers three quarters of the range or more.";
  if (d.gain > kSearchEnded)
    part.text += "\n\nThe search has not converged: a linear step would lower the misfit by about " +
                 number_text(d.gain, 3) + " of " + number_text(o.best->misfit, 3) +
                 ". The intervals are reliable only with more evaluations in the last stage.";
  if (o.confirmations > 1)
    part.text += "\n\nWhole runs differ from those of the search. The set is the best of " +
                 std::to_string(o.confirmations) +
                 " that were run whole: that of the search, and sets near it that should meet more targets to first "
                 "order. Differences are those about the set of the search.";
  PageRows rows = {{"parameter", "range", "scale", "start", "best", "interval", "determined", "source of the range"}};
  const UnitPoint start = start_of(spec);
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const CalibrationParameter& p = spec.parameters[i];
    const Interval& interval = d.intervals[i];
    rows.push_back({p.name, number_text(p.least) + " to " + number_text(p.most), std::string(name_of(p.scale)),
                    number_text(p.value(start[i])), number_text(p.value(o.best->point[i])),
                    number_text(interval.least, 4) + " to " + number_text(interval.most, 4),
                    interval.is_determined() + (interval.at_edge ? "; at the end of the range" : ""), p.origin});
  }
  part.rows = rows;
  return part;
}

PagePart targets_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part;
  part.heading = "The targets";
  part.text = "Met at the start: " + std::to_string(o.start->met()) + " of " + std::to_string(spec.targets.size()) +
              ", at the best set " + std::to_string(o.best->met()) + ", confirmed " +
              std::to_string(o.confirmed->met()) + ". Misfit: " + number_text(o.start->misfit, 4) + " at the start, " +
              number_text(o.best->misfit, 4) + " at the best set with the runs of the last stage, " +
              number_text(o.confirmed->misfit, 4) + " confirmed by whole runs over all seeds" +
              (o.confirmations > 1 ? ", the best of " + std::to_string(o.confirmations) + " sets run whole" : "") +
              ". Distance: of the confirmed value [tolerances].";
  if (spec.cap > 0.0)
    part.text += " Larger distances count as " + number_text(spec.cap) +
                 " tolerances in the misfit; the best set is the one that meets most targets.";
  if (const std::vector<std::size_t> chosen = heaviest_targets(spec); chosen.size() < spec.targets.size())
    part.text += " Of the " + std::to_string(chosen.size()) + " targets of the largest weight are met: at the start " +
                 std::to_string(met_of(*o.start, chosen)) + ", at the best set " +
                 std::to_string(met_of(*o.best, chosen)) + ", confirmed " +
                 std::to_string(met_of(*o.confirmed, chosen)) + ".";
  if (o.confirmed->met() < o.best->met())
    part.text += "\n\nRuns of the last stage differ from whole ones: " + std::to_string(o.best->met()) +
                 " targets met become " + std::to_string(o.confirmed->met()) +
                 ". Use more accurate runs in the last stage, or more seeds.";
  PageRows rows = {
      {"target", "required", "tolerance", "weight", "start", "best", "confirmed", "distance", "met", "source"}};
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    const TargetSpec& target = spec.targets[t];
    const TargetResult& confirmed = o.confirmed->targets[t];
    std::string met = confirmed.is_met() ? "yes" : "no";
    if (confirmed.of_seed.size() > 1)
      met += ", " + std::to_string(seeds_that_meet(target, confirmed)) + " of " +
             std::to_string(confirmed.of_seed.size()) + " seeds";
    rows.push_back({target.name, requirement_text(target), number_text(target.tolerance), number_text(target.weight),
                    value_text(target, o.start->targets[t]), value_text(target, o.best->targets[t]),
                    value_text(target, confirmed), number_text(distance(confirmed), 3), met, target.origin});
  }
  part.rows = rows;
  return part;
}

PagePart sensitivity_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part;
  part.heading = "Effect of each parameter";
  part.text =
      "Change of each target over the whole range of a parameter, to first order about the best set [tolerances]; of "
      "curves without sign.";
  PageRows rows = {{"target"}};
  append(rows.front(), names_in(spec.parameters));
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    std::vector<std::string> row = {spec.targets[t].name};
    for (std::size_t i = 0; i < spec.parameters.size(); ++i)
      row.push_back(
          number_text(o.determination.sensitivity(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(i)), 3));
    rows.push_back(row);
  }
  part.rows = rows;
  return part;
}

std::string direction_text(const CalibrationSpec& spec, const Eigen::VectorXd& direction) {
  std::vector<std::string> texts;
  for (Eigen::Index i = 0; i < direction.size(); ++i)
    if (std::abs(direction[i]) > 0.1)
      texts.push_back(spec.parameters[static_cast<std::size_t>(i)].name + " " + (direction[i] > 0.0 ? "+" : "") +
                      number_text(direction[i], 2));
  return joined(texts);
}

PagePart correlation_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part;
  part.heading = "Correlation of the parameters";
  part.text = "Near 1 or -1 the targets determine only a combination of the two.";
  for (const Eigen::VectorXd& direction : o.determination.loose)
    part.text += "\n\nThe targets do not determine the direction " + direction_text(spec, direction) +
                 " (relative to the ranges).";
  PageRows rows = {{"parameter"}};
  append(rows.front(), names_in(spec.parameters));
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    std::vector<std::string> row = {spec.parameters[i].name};
    for (std::size_t k = 0; k < spec.parameters.size(); ++k)
      row.push_back(
          fixed_text(o.determination.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)), 2));
    rows.push_back(row);
  }
  part.rows = rows;
  return part;
}

PagePart trade_off_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part;
  part.heading = "Trade-offs between targets";
  if (o.trade_offs.empty()) {
    part.text = "All targets that are single numbers are met at the best set.";
    return part;
  }
  part.text =
      "For each target that the best set does not meet: the smallest step that would meet it to first order, and its "
      "cost "
      "for the others. A step longer than a range is impossible.";
  PageRows rows = {{"target", "distance", "step, relative to the ranges", "cost [tolerances]"}};
  for (const TradeOff& trade_off : o.trade_offs) {
    std::vector<std::string> costs;
    for (const auto& [s, cost] : trade_off.costs) costs.push_back(spec.targets[s].name + " +" + number_text(cost, 2));
    std::vector<std::string> step;
    for (Eigen::Index i = 0; i < trade_off.step.size(); ++i)
      if (std::abs(trade_off.step[i]) > 0.02)
        step.push_back(spec.parameters[static_cast<std::size_t>(i)].name + (trade_off.step[i] > 0.0 ? " +" : " ") +
                       number_text(trade_off.step[i], 2));
    rows.push_back({spec.targets[trade_off.target].name, number_text(distance(o.best->targets[trade_off.target]), 3),
                    trade_off.moved ? joined(step) : "no parameter affects it here",
                    costs.empty() ? "none" : joined(costs)});
  }
  part.rows = rows;
  return part;
}

PagePart conflicts_of_sets_part(const CalibrationSpec& spec, const CalibrationOutcome& o,
                                const std::vector<const Evaluation*>& sets) {
  const Evaluation* most = most_met(spec, sets);
  PagePart part = conflicts_part(spec, sets);
  part.text = "Of " + std::to_string(sets.size()) +
              " sets with runs as in the last stage, one meets most targets: " + std::to_string(most->met()) + " of " +
              std::to_string(spec.targets.size()) + " (misfit " + number_text(most->misfit, 4) +
              "; the best set meets " + std::to_string(o.best->met()) + ")." + part.text;
  return part;
}

PagePart single_targets_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part;
  part.heading = "Targets that no set meets, sought one by one";
  part.text =
      "Without regard to the other targets, from the nearest of the sets above, by response surfaces. Distances in "
      "tolerances; only parameters that affect the target.";
  part.rows = {{"target", "required", "distance of the sets above", "more sets", "nearest of all", "distance", "at"}};
  for (const SingleTarget& single_target : o.single_targets) {
    const TargetSpec& target = spec.targets[single_target.target];
    const TargetResult& result = single_target.nearest->targets[single_target.target];
    std::vector<std::string> at;
    for (std::size_t i = 0; i < spec.parameters.size(); ++i)
      if (std::find(single_target.moved_by.begin(), single_target.moved_by.end(), i) != single_target.moved_by.end())
        at.push_back(spec.parameters[i].name + " " +
                     number_text(spec.parameters[i].value(single_target.nearest->point[i]), 3));
    part.rows.push_back(
        {target.name, requirement_text(target),
         number_text(single_target.nearest_before, 3) + " of " + std::to_string(single_target.before) + " sets",
         std::to_string(single_target.sets), value_text(target, result), number_text(distance(result), 3), joined(at)});
  }
  return part;
}

PagePart search_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part;
  part.heading = "The search";
  if (o.whole_time)
    part.text = "Estimated time: " + number_text(o.predicted, 3) + " h; taken: " + number_text(o.taken, 3) + " h.";
  part.rows = {{"stage", "sets", "runs", "final misfit", "reason of the end"}};
  for (std::size_t k = 0; k < o.stages.size(); ++k) {
    const StageOutcome& stage = o.stages[k];
    int runs = 0;
    for (const Evaluation* e : stage.evaluations) runs += e->runs;
    part.rows.push_back({std::string(name_of(spec.stages[k].method)), std::to_string(stage.evaluations.size()),
                         std::to_string(runs), number_text(stage.best, 5), stage.path.end});
  }
  return part;
}

}  // namespace

PagePart conflicts_part(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets) {
  PagePart part;
  const Conflicts found = conflicts_of(spec, sets);
  std::vector<std::string> never;
  for (const std::size_t t : found.never) never.push_back(spec.targets[t].name);
  part.text =
      never.empty() ? " Every target is met by some set." : "\n\nMet by none of them: " + joined(never, "; ") + ".";
  if (found.pairs.empty()) return part;
  const std::vector<std::size_t> chosen = heaviest_targets(spec);
  part.text += "\n\nFrom pairs, at most " + std::to_string(most_without_conflict(found, chosen)) + " of the " +
               std::to_string(chosen.size()) + " targets" +
               (chosen.size() < spec.targets.size() ? " of the largest weight" : "") +
               " can be met together. These pairs are met by some sets each, and by none together:";
  part.rows = {{"target", "other target", "sets that meet the first", "the other", "both"}};
  for (const Conflicts::Pair& pair : found.pairs)
    part.rows.push_back({spec.targets[pair.a].name, spec.targets[pair.b].name, std::to_string(pair.met_a),
                         std::to_string(pair.met_b), "0"});
  return part;
}

std::vector<PagePart> calibration_parts(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                        const std::vector<const Evaluation*>& comparable, const std::string& command,
                                        const std::vector<std::string>& pictures) {
  PagePart first, last;
  first.text = "Made by `" + command + "`.";
  last.heading = "Pictures";
  last.pictures = pictures;
  std::vector<PagePart> parts = {first,
                                 best_part(spec, outcome),
                                 targets_part(spec, outcome),
                                 sensitivity_part(spec, outcome),
                                 correlation_part(spec, outcome),
                                 trade_off_part(spec, outcome),
                                 conflicts_of_sets_part(spec, outcome, comparable)};
  if (!outcome.single_targets.empty()) parts.push_back(single_targets_part(spec, outcome));
  parts.push_back(search_part(spec, outcome));
  if (!pictures.empty()) parts.push_back(last);
  return parts;
}

std::string markdown(const std::string& title, const std::vector<PagePart>& parts) {
  std::string page = "# " + title + "\n";
  for (const PagePart& part : parts) {
    if (!part.heading.empty()) page += "\n## " + part.heading + "\n";
    if (!part.text.empty()) page += "\n" + part.text + "\n";
    if (!part.rows.empty()) {
      Table table(part.rows.front());
      for (std::size_t k = 1; k < part.rows.size(); ++k) table.add(part.rows[k]);
      page += "\n" + table.page();
    }
    for (const std::string& picture : part.pictures) {
      const std::string name = fs::path(picture).filename().string();
      page += "\n![" + fs::path(name).stem().string() + "](" + name + ")\n";
    }
  }
  return page;
}

std::string html(const std::string& title, const std::vector<PagePart>& parts) {
  HtmlPage page(title);
  for (const PagePart& part : parts) {
    if (!part.heading.empty()) page.section(part.heading);
    if (!part.text.empty()) page.paragraph(part.text);
    if (!part.rows.empty()) page.table(part.rows);
    for (const std::string& picture : part.pictures) page.picture(picture);
  }
  return page.text();
}

namespace {

PagePart sets_part(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets, const Evaluation& least,
                   const Evaluation& most) {
  PagePart part;
  part.heading = "Parameters";
  part.rows = {{"parameter", "range", "start", "least misfit", "most met", "source of the range"}};
  const UnitPoint start = start_of(spec);
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const CalibrationParameter& p = spec.parameters[i];
    part.rows.push_back({p.name, number_text(p.least) + " to " + number_text(p.most), number_text(p.value(start[i])),
                         number_text(p.value(least.point[i]), 4), number_text(p.value(most.point[i]), 4), p.origin});
  }
  part.text = "Of " + std::to_string(sets.size()) + " sets the one with the least misfit, " +
              number_text(least.misfit, 4) + ", meets " + std::to_string(least.met()) + " of " +
              std::to_string(spec.targets.size()) + " targets; the largest number met is " +
              std::to_string(most.met()) + ", with a misfit of " + number_text(most.misfit, 4) + ".";
  return part;
}

PagePart met_part(const CalibrationSpec& spec, const CalibrationOutcome& o, const std::vector<const Evaluation*>& sets,
                  const Evaluation& most) {
  PagePart part;
  part.heading = "Targets";
  part.text = "Distance in the set that meets most targets, and the least of all sets [tolerances].";
  part.rows = {{"target", "required", "start", "most met", "distance", "least", "sets that meet it", "source"}};
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    const auto met =
        std::count_if(sets.begin(), sets.end(), [&](const Evaluation* e) { return e->targets[t].is_met(); });
    double least = distance(most.targets[t]);
    for (const Evaluation* e : sets)
      if (!e->targets[t].failed) least = std::min(least, distance(e->targets[t]));
    part.rows.push_back({spec.targets[t].name, requirement_text(spec.targets[t]),
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
  first.text = "Results so far, by `" + command +
               "`. The calibration is in progress: nothing is confirmed, and there are no intervals.";
  const StageSpec& stage = spec.stages[outcome.stages.size() - 1];
  if (comparable.empty()) return {first};
  first.text += " Stage " + std::to_string(outcome.stages.size()) + " of " + std::to_string(spec.stages.size()) + ", " +
                std::string(name_of(stage.method)) + ", at most " + std::to_string(stage.evaluations) + " sets.";
  const Evaluation* least =
      *std::min_element(comparable.begin(), comparable.end(),
                        [](const Evaluation* a, const Evaluation* b) { return a->misfit < b->misfit; });
  const Evaluation* most = most_met(spec, comparable);
  PagePart together = conflicts_part(spec, comparable);
  together.heading = "Targets met together";
  together.text.erase(0, together.text.find_first_not_of(" \n"));
  return {first, sets_part(spec, comparable, *least, *most), met_part(spec, outcome, comparable, *most), together};
}

namespace {

std::string drawn(const std::string& folder, const std::string& name, int height, const std::string& drawing) {
  return write_drawing(folder, name, {1000, height}, kCsv,
                       "unset logscale\nset autoscale\nunset ylabel\nset ytics noenhanced\nset grid\n" + drawing);
}

// Positions in the ranges: best set, interval.
Table parameter_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome) {
  Table table({"parameter", "best", "least", "most"});
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const CalibrationParameter& p = spec.parameters[i];
    const Interval& interval = outcome.determination.intervals[i];
    table.add({p.name, number_text(outcome.best->point[i]), number_text(p.position(interval.least)),
               number_text(p.position(interval.most))});
  }
  return table;
}

// Distances at the start, at the best set, and confirmed [tolerances].
Table target_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome) {
  Table table({"target", "start", "best", "confirmed"});
  for (std::size_t t = 0; t < spec.targets.size(); ++t)
    table.add({spec.targets[t].name, number_text(distance(outcome.start->targets[t])),
               number_text(distance(outcome.best->targets[t])), number_text(distance(outcome.confirmed->targets[t]))});
  return table;
}

}  // namespace

Table path_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome) {
  std::vector<std::string> head = {"set", "stage"};
  append(head, names_in(spec.parameters));
  append(head, {"misfit", "least", "met"});
  append(head, names_in(spec.targets));
  append(head, {"message"});
  Table table(head);
  int number = 0;
  for (std::size_t k = 0; k < outcome.stages.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (const Evaluation* e : outcome.stages[k].evaluations) {
      least = std::min(least, e->misfit);
      std::vector<std::string> row = {std::to_string(++number), std::to_string(k + 1)};
      for (std::size_t i = 0; i < e->point.size(); ++i) row.push_back(spec.parameters[i].text(e->point[i]));
      append(row, {number_text(e->misfit, 10), number_text(least, 10), std::to_string(e->met())});
      for (std::size_t t = 0; t < e->targets.size(); ++t)
        row.push_back(e->targets[t].failed         ? ""
                      : spec.targets[t].is_curve() ? number_text(distance(e->targets[t]), 10)
                                                   : number_text(e->targets[t].values.front(), 10));
      row.push_back(e->message);
      table.add(row);
    }
  }
  return table;
}

std::vector<std::string> draw_calibration(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                          const std::string& folder) {
  const std::string base = folder + "/";
  Table misfits({"set", "misfit", "least"});
  int number = 0;
  for (const StageOutcome& stage : outcome.stages) {
    double least = std::numeric_limits<double>::infinity();
    for (const Evaluation* e : stage.evaluations) {
      least = std::min(least, e->misfit);
      misfits.add({std::to_string(++number), number_text(std::max(e->misfit, 1e-12), 8),
                   number_text(std::max(least, 1e-12), 8)});
    }
  }
  write_whole_file(base + "misfit.csv", misfits.csv());
  write_whole_file(base + "parameters.csv", parameter_table(spec, outcome).csv());
  write_whole_file(base + "targets.csv", target_table(spec, outcome).csv());
  const int parameters = static_cast<int>(spec.parameters.size()), targets = static_cast<int>(spec.targets.size());
  return run_gnuplot(
      folder,
      {drawn(folder, "misfit", 500,
             "set logscale y\nset xlabel 'set'\nset ylabel 'misfit'\nset key outside right top\n"
             "plot 'misfit.csv' using 1:2 with points pt 7 ps 0.6 lc 'gray' title 'each set', "
             "'' using 1:3 with steps lw 2 lc 1 title 'least of the stage'\n"),
       drawn(
           folder, "parameters", 140 + 40 * parameters,
           "set xlabel 'position in the range'\nset xrange [0:1]\nset yrange [-0.7:" + fixed_text(parameters - 0.3, 1) +
               "] reverse\nplot 'parameters.csv' using 2:0:3:4:ytic(1) with xerrorbars pt 7 lw 2 lc 1 notitle\n"),
       drawn(folder, "targets", 160 + 26 * targets,
             "set xlabel 'distance from the target [tolerances]'\nset key outside right top\nset yrange [-0.7:" +
                 fixed_text(targets - 0.3, 1) +
                 "] reverse\nplot 'targets.csv' using 2:0:ytic(1) with points pt 6 lc 'gray' title 'start', "
                 "'' using 3:0 with points pt 7 lc 1 title 'best', '' using 4:0 with points pt 2 lc 2 title "
                 "'confirmed'\n")});
}

}  // namespace footfall

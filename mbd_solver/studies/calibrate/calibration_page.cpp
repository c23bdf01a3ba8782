// Builds pages of parts: text, a table, pictures. gnuplot draws from the CSV files of the folder.
#include "mbd_solver/studies/calibrate/calibration_page.h"

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

namespace {

namespace fs = std::filesystem;
using Row = std::vector<std::string>;
using Sets = std::vector<const Evaluation*>;

constexpr double kSearchEnded = 1.0;  // largest gain of misfit by a linear step after the search

std::string num(double value, int digits = 6) { return number_text(value, digits); }
std::string num(std::size_t count) { return std::to_string(count); }
std::string num(int count) { return std::to_string(count); }

// "0.9 to 1.1", "at least 2", "0.5".
std::string requirement_text(const TargetSpec& t) {
  if (t.is_curve()) return "curve " + fs::path(t.file).filename().string();
  if (t.value) return num(*t.value);
  if (t.least == t.most) return num(t.least);
  if (std::isinf(t.least)) return "at most " + num(t.most);
  return std::isinf(t.most) ? "at least " + num(t.least) : num(t.least) + " to " + num(t.most);
}

// The value with its spread over the seeds; "failed".
std::string value_text(const TargetSpec& spec, const TargetResult& t) {
  if (t.failed) return "failed";
  if (spec.is_curve()) return "within " + num(distance(t), 3) + " tolerances";
  return num(t.values.front(), 4) + (t.of_seed.size() > 1 ? " +- " + num(t.spread.front(), 2) : "");
}

int seeds_that_meet(const TargetSpec& spec, const TargetResult& t) {
  if (t.of_seed.size() < 2 || spec.is_curve()) return t.is_met() ? static_cast<int>(t.of_seed.size()) : 0;
  return static_cast<int>(std::count_if(t.of_seed.begin(), t.of_seed.end(), [&](const std::vector<double>& y) {
    return TargetResult::met({residual_of(spec, y.front())}, spec.is_band());
  }));
}

std::string range_text(const CalibrationParameter& p) { return num(p.least) + " to " + num(p.most); }

// "young +0.3, friction -0.9": components of a step larger than `least`.
std::string step_text(const CalibrationSpec& spec, const Eigen::VectorXd& step, double least) {
  Row texts;
  for (Eigen::Index i = 0; i < step.size(); ++i)
    if (std::abs(step[i]) > least)
      texts.push_back(spec.parameters[static_cast<std::size_t>(i)].name + (step[i] > 0.0 ? " +" : " ") +
                      num(step[i], 2));
  return joined(texts);
}

PagePart best_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  const Determination& d = o.determination;
  PagePart part{"The best set", "", {}, {}};
  part.text =
      "Intervals of " + percent(spec.confidence) + " %, from " + num(d.rows) + " numbers that depend on a parameter";
  if (d.scale > 1.0)
    part.text += ", widened by " + num(std::sqrt(d.scale), 3) + " because the misfit exceeds the tolerances";
  part.text += ". Determined \"no\": the interval covers three quarters of the range or more.";
  if (d.gain > kSearchEnded)
    part.text += "\n\nThe search has not converged: a linear step would lower the misfit by about " + num(d.gain, 3) +
                 " of " + num(o.best->misfit, 3) +
                 ". The intervals are reliable only with more evaluations in the last stage.";
  if (o.confirmations > 1)
    part.text += "\n\nWhole runs differ from those of the search. The set is the best of " + num(o.confirmations) +
                 " that were run whole: that of the search, and sets near it that should meet more targets to first "
                 "order. Differences are those about the set of the search.";
  part.rows = {{"parameter", "range", "scale", "start", "best", "interval", "determined", "source of the range"}};
  const UnitPoint start = start_of(spec);
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const CalibrationParameter& p = spec.parameters[i];
    const Interval& interval = d.intervals[i];
    part.rows.push_back({p.name, range_text(p), std::string(name_of(p.scale)), num(p.value(start[i])),
                         num(p.value(o.best->point[i])), num(interval.least, 4) + " to " + num(interval.most, 4),
                         interval.is_determined() + (interval.at_edge ? "; at the end of the range" : ""), p.origin});
  }
  return part;
}

PagePart targets_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part{"The targets", "", {}, {}};
  const auto met = [&](const std::string& count_start, const std::string& count_best,
                       const std::string& count_confirmed) {
    return count_start + " at the start, " + count_best + " at the best set, " + count_confirmed + " confirmed";
  };
  part.text = "Targets met (of " + num(spec.targets.size()) +
              "): " + met(num(o.start->met()), num(o.best->met()), num(o.confirmed->met())) +
              ". Misfit: " + met(num(o.start->misfit, 4), num(o.best->misfit, 4), num(o.confirmed->misfit, 4)) +
              ". The best set is that of the last stage's runs; confirmed are whole runs over all seeds" +
              (o.confirmations > 1 ? ", the best of " + num(o.confirmations) + " sets run whole" : "") +
              ". Distance: of the confirmed value [tolerances].";
  if (spec.cap > 0.0)
    part.text += " Larger distances count as " + num(spec.cap) +
                 " tolerances in the misfit; the best set is the one that meets most targets.";
  if (const std::vector<std::size_t> heaviest = heaviest_targets(spec); heaviest.size() < spec.targets.size())
    part.text +=
        " Of the " + num(heaviest.size()) + " targets of the largest weight are met: " +
        met(num(met_of(*o.start, heaviest)), num(met_of(*o.best, heaviest)), num(met_of(*o.confirmed, heaviest))) + ".";
  if (o.confirmed->met() < o.best->met())
    part.text += "\n\nRuns of the last stage differ from whole ones: " + num(o.best->met()) + " targets met become " +
                 num(o.confirmed->met()) + ". Use more accurate runs in the last stage, or more seeds.";
  part.rows = {
      {"target", "required", "tolerance", "weight", "start", "best", "confirmed", "distance", "met", "source"}};
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    const TargetSpec& target = spec.targets[t];
    const TargetResult& confirmed = o.confirmed->targets[t];
    std::string is_met = confirmed.is_met() ? "yes" : "no";
    if (confirmed.of_seed.size() > 1)
      is_met += ", " + num(seeds_that_meet(target, confirmed)) + " of " + num(confirmed.of_seed.size()) + " seeds";
    part.rows.push_back({target.name, requirement_text(target), num(target.tolerance), num(target.weight),
                         value_text(target, o.start->targets[t]), value_text(target, o.best->targets[t]),
                         value_text(target, confirmed), num(distance(confirmed), 3), is_met, target.origin});
  }
  return part;
}

// A row per name, a column per parameter.
PagePart matrix_part(const CalibrationSpec& spec, const PagePart& begin, const std::string& corner, const Row& names,
                     const std::function<std::string(Eigen::Index, Eigen::Index)>& text) {
  PagePart part = begin;
  part.rows = {{corner}};
  append(part.rows.front(), names_in(spec.parameters));
  for (std::size_t k = 0; k < names.size(); ++k) {
    Row row = {names[k]};
    for (std::size_t i = 0; i < spec.parameters.size(); ++i)
      row.push_back(text(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)));
    part.rows.push_back(row);
  }
  return part;
}

PagePart sensitivity_part(const CalibrationSpec& spec, const Determination& d) {
  return matrix_part(spec,
                     {"Effect of each parameter",
                      "Change of each target over the whole range of a parameter, to first order about the best set "
                      "[tolerances]; of curves without sign.",
                      {},
                      {}},
                     "target", names_in(spec.targets),
                     [&](Eigen::Index t, Eigen::Index i) { return num(d.sensitivity(t, i), 3); });
}

PagePart correlation_part(const CalibrationSpec& spec, const Determination& d) {
  PagePart begin{
      "Correlation of the parameters", "Near 1 or -1 the targets determine only a combination of the two.", {}, {}};
  for (const Eigen::VectorXd& direction : d.loose)
    begin.text += "\n\nThe targets do not determine the direction " + step_text(spec, direction, 0.1) +
                  " (relative to the ranges).";
  return matrix_part(spec, begin, "parameter", names_in(spec.parameters),
                     [&](Eigen::Index i, Eigen::Index k) { return fixed_text(d.correlation(i, k), 2); });
}

PagePart trade_off_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  if (o.trade_offs.empty())
    return {"Trade-offs between targets", "All targets that are single numbers are met at the best set.", {}, {}};
  PagePart part{"Trade-offs between targets",
                "For each target that the best set does not meet: the smallest step that would meet it to first order, "
                "and its cost for the others. A step longer than a range is impossible.",
                {{"target", "distance", "step, relative to the ranges", "cost [tolerances]"}},
                {}};
  for (const TradeOff& trade_off : o.trade_offs) {
    Row costs;
    for (const auto& [s, cost] : trade_off.costs) costs.push_back(spec.targets[s].name + " +" + num(cost, 2));
    part.rows.push_back({spec.targets[trade_off.target].name, num(distance(o.best->targets[trade_off.target]), 3),
                         trade_off.moved ? step_text(spec, trade_off.step, 0.02) : "no parameter affects it here",
                         costs.empty() ? "none" : joined(costs)});
  }
  return part;
}

PagePart single_targets_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part{
      "Targets that no set meets, sought one by one",
      "Without regard to the other targets, from the nearest of the sets above, by response surfaces. Distances "
      "in tolerances; only parameters that affect the target.",
      {{"target", "required", "distance of the sets above", "more sets", "nearest of all", "distance", "at"}},
      {}};
  for (const SingleTarget& one : o.single_targets) {
    const TargetSpec& target = spec.targets[one.target];
    const TargetResult& result = one.nearest->targets[one.target];
    Row at;
    for (const std::size_t i : one.moved_by)
      at.push_back(spec.parameters[i].name + " " + num(spec.parameters[i].value(one.nearest->point[i]), 3));
    part.rows.push_back({target.name, requirement_text(target),
                         num(one.nearest_before, 3) + " of " + num(one.before) + " sets", num(one.sets),
                         value_text(target, result), num(distance(result), 3), joined(at)});
  }
  return part;
}

PagePart search_part(const CalibrationSpec& spec, const CalibrationOutcome& o) {
  PagePart part{"The search", "", {{"stage", "sets", "runs", "final misfit", "reason of the end"}}, {}};
  if (o.whole_time) part.text = "Estimated time: " + num(o.predicted, 3) + " h; taken: " + num(o.taken, 3) + " h.";
  for (std::size_t k = 0; k < o.stages.size(); ++k) {
    const StageOutcome& stage = o.stages[k];
    int runs = 0;
    for (const Evaluation* e : stage.evaluations) runs += e->runs;
    part.rows.push_back({std::string(name_of(spec.stages[k].method)), num(stage.evaluations.size()), num(runs),
                         num(stage.best, 5), stage.path.end});
  }
  return part;
}

}  // namespace

PagePart conflicts_part(const CalibrationSpec& spec, const Sets& sets) {
  PagePart part;
  const Conflicts found = conflicts_of(spec, sets);
  Row never;
  for (const std::size_t t : found.never) never.push_back(spec.targets[t].name);
  part.text =
      never.empty() ? " Every target is met by some set." : "\n\nMet by none of them: " + joined(never, "; ") + ".";
  if (found.pairs.empty()) return part;
  const std::vector<std::size_t> heaviest = heaviest_targets(spec);
  part.text += "\n\nFrom pairs, at most " + num(most_without_conflict(found, heaviest)) + " of the " +
               num(heaviest.size()) + " targets" +
               (heaviest.size() < spec.targets.size() ? " of the largest weight" : "") +
               " can be met together. These pairs are met by some sets each, and by none together:";
  part.rows = {{"target", "other target", "sets that meet the first", "the other", "both"}};
  for (const Conflicts::Pair& pair : found.pairs)
    part.rows.push_back({spec.targets[pair.a].name, spec.targets[pair.b].name, num(pair.met_a), num(pair.met_b), "0"});
  return part;
}

std::vector<PagePart> calibration_parts(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                        const Sets& comparable, const std::string& command, const Row& pictures) {
  const Evaluation* most = most_met(spec, comparable);
  PagePart conflicts = conflicts_part(spec, comparable);
  conflicts.text = "Of " + num(comparable.size()) +
                   " sets with runs as in the last stage, one meets most targets: " + num(most->met()) + " of " +
                   num(spec.targets.size()) + " (misfit " + num(most->misfit, 4) + "; the best set meets " +
                   num(outcome.best->met()) + ")." + conflicts.text;
  std::vector<PagePart> parts = {{"", "Made by `" + command + "`.", {}, {}},
                                 best_part(spec, outcome),
                                 targets_part(spec, outcome),
                                 sensitivity_part(spec, outcome.determination),
                                 correlation_part(spec, outcome.determination),
                                 trade_off_part(spec, outcome),
                                 conflicts};
  if (!outcome.single_targets.empty()) parts.push_back(single_targets_part(spec, outcome));
  parts.push_back(search_part(spec, outcome));
  if (!pictures.empty()) parts.push_back({"Pictures", "", {}, pictures});
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
    for (const std::string& picture : part.pictures)
      page += "\n![" + fs::path(picture).stem().string() + "](" + fs::path(picture).filename().string() + ")\n";
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

std::vector<PagePart> so_far_parts(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                   const Sets& comparable, const std::string& command) {
  PagePart first{"",
                 "Results so far, by `" + command +
                     "`. The calibration is in progress: nothing is confirmed, and there are no intervals.",
                 {},
                 {}};
  if (comparable.empty()) return {first};
  const StageSpec& stage = spec.stages[outcome.stages.size() - 1];
  first.text += " Stage " + num(outcome.stages.size()) + " of " + num(spec.stages.size()) + ", " +
                std::string(name_of(stage.method)) + ", at most " + num(stage.evaluations) + " sets.";
  const Evaluation& least = **std::min_element(comparable.begin(), comparable.end(),
                                               [](const auto* a, const auto* b) { return a->misfit < b->misfit; });
  const Evaluation& most = *most_met(spec, comparable);

  PagePart parameters{"Parameters",
                      "Of " + num(comparable.size()) + " sets the one with the least misfit, " + num(least.misfit, 4) +
                          ", meets " + num(least.met()) + " of " + num(spec.targets.size()) +
                          " targets; the largest number met is " + num(most.met()) + ", with a misfit of " +
                          num(most.misfit, 4) + ".",
                      {{"parameter", "range", "start", "least misfit", "most met", "source of the range"}},
                      {}};
  const UnitPoint start = start_of(spec);
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const CalibrationParameter& p = spec.parameters[i];
    parameters.rows.push_back({p.name, range_text(p), num(p.value(start[i])), num(p.value(least.point[i]), 4),
                               num(p.value(most.point[i]), 4), p.origin});
  }
  PagePart targets{"Targets",
                   "Distance in the set that meets most targets, and the least of all sets [tolerances].",
                   {{"target", "required", "start", "most met", "distance", "least", "sets that meet it", "source"}},
                   {}};
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    const TargetSpec& target = spec.targets[t];
    const auto met = std::count_if(comparable.begin(), comparable.end(),
                                   [&](const Evaluation* e) { return e->targets[t].is_met(); });
    double nearest = distance(most.targets[t]);
    for (const Evaluation* e : comparable)
      if (!e->targets[t].failed) nearest = std::min(nearest, distance(e->targets[t]));
    targets.rows.push_back({target.name, requirement_text(target), value_text(target, outcome.start->targets[t]),
                            value_text(target, most.targets[t]), num(distance(most.targets[t]), 3), num(nearest, 3),
                            num(static_cast<int>(met)) + " of " + num(comparable.size()), target.origin});
  }
  PagePart together = conflicts_part(spec, comparable);
  together.heading = "Targets met together";
  together.text.erase(0, together.text.find_first_not_of(" \n"));
  return {first, parameters, targets, together};
}

Table path_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome) {
  Row head = {"set", "stage"};
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
      Row row = {num(++number), num(k + 1)};
      for (std::size_t i = 0; i < e->point.size(); ++i) row.push_back(spec.parameters[i].text(e->point[i]));
      append(row, {num(e->misfit, 10), num(least, 10), num(e->met())});
      for (std::size_t t = 0; t < e->targets.size(); ++t)
        row.push_back(e->targets[t].failed         ? ""
                      : spec.targets[t].is_curve() ? num(distance(e->targets[t]), 10)
                                                   : num(e->targets[t].values.front(), 10));
      row.push_back(e->message);
      table.add(row);
    }
  }
  return table;
}

Row draw_calibration(const CalibrationSpec& spec, const CalibrationOutcome& outcome, const std::string& folder) {
  Table misfits({"set", "misfit", "least"}), parameters({"parameter", "best", "least", "most"}),
      targets({"target", "start", "best", "confirmed"});
  int number = 0;
  for (const StageOutcome& stage : outcome.stages) {
    double least = std::numeric_limits<double>::infinity();
    for (const Evaluation* e : stage.evaluations) {
      least = std::min(least, e->misfit);
      misfits.add({num(++number), num(std::max(e->misfit, 1e-12), 8), num(std::max(least, 1e-12), 8)});
    }
  }
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {  // positions in the ranges
    const CalibrationParameter& p = spec.parameters[i];
    const Interval& interval = outcome.determination.intervals[i];
    parameters.add(
        {p.name, num(outcome.best->point[i]), num(p.position(interval.least)), num(p.position(interval.most))});
  }
  for (std::size_t t = 0; t < spec.targets.size(); ++t)
    targets.add({spec.targets[t].name, num(distance(outcome.start->targets[t])),
                 num(distance(outcome.best->targets[t])), num(distance(outcome.confirmed->targets[t]))});
  const auto drawn = [&](const std::string& name, const Table& table, int height, const std::string& drawing) {
    write_whole_file((fs::path(folder) / (name + ".csv")).string(), table.csv());
    return write_drawing(folder, name, {1000, height}, csv_setup(),
                         "unset logscale\nset autoscale\nunset ylabel\nset ytics noenhanced\nset grid\n" + drawing);
  };
  const auto rows = [](std::size_t count) {
    return "set yrange [-0.7:" + fixed_text(static_cast<double>(count) - 0.3, 1) + "] reverse\n";
  };
  const int count_p = static_cast<int>(spec.parameters.size()), count_t = static_cast<int>(spec.targets.size());
  return run_gnuplot(folder,
                     {drawn("misfit", misfits, 500,
                            "set logscale y\nset xlabel 'set'\nset ylabel 'misfit'\nset key outside right top\n"
                            "plot 'misfit.csv' using 1:2 with points pt 7 ps 0.6 lc 'gray' title 'each set', "
                            "'' using 1:3 with steps lw 2 lc 1 title 'least of the stage'\n"),
                      drawn("parameters", parameters, 140 + 40 * count_p,
                            "set xlabel 'position in the range'\nset xrange [0:1]\n" + rows(spec.parameters.size()) +
                                "plot 'parameters.csv' using 2:0:3:4:ytic(1) with xerrorbars pt 7 lw 2 lc 1 notitle\n"),
                      drawn("targets", targets, 160 + 26 * count_t,
                            "set xlabel 'distance from the target [tolerances]'\nset key outside right top\n" +
                                rows(spec.targets.size()) +
                                "plot 'targets.csv' using 2:0:ytic(1) with points pt 6 lc 'gray' title 'start', '' "
                                "using 3:0 with points "
                                "pt 7 lc 1 title 'best', '' using 4:0 with points pt 2 lc 2 title 'confirmed'\n")});
}

}  // namespace footfall

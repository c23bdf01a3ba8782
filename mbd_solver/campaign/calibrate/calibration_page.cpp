// A section after the other. gnuplot draws from the CSV files of the folder.
#include "mbd_solver/campaign/calibrate/calibration_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/plot_script.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using Row = std::vector<std::string>;

constexpr double kSearchEnded = 1.0;  // largest gain of misfit by a linear step after the search

template <class Number>
std::string num(Number value, int digits = 6) {
  return number_text(static_cast<double>(value), digits);
}

// A set that has its own column in the tables.
struct NamedSet {
  std::string name;
  const EvaluatedPoint* set;
};

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
  if (spec.is_curve()) return "within " + num(t.distance(), 3) + " tolerances";
  return num(t.values.front(), 4) + (t.seeds > 1 ? " +- " + num(t.spread.front(), 2) : "");
}

// "young +0.3, friction -0.9": components of a step larger than `least`.
std::string step_text(const CalibrationSpec& spec, const Eigen::VectorXd& step, double least) {
  Row texts;
  for (Eigen::Index i = 0; i < step.size(); ++i)
    if (std::abs(step[i]) > least)
      texts.push_back(spec.parameters[i].name + (step[i] > 0.0 ? " +" : " ") + num(step[i], 2));
  return joined(texts);
}

void show_intervals(StudyPage& page, const CalibrationSpec& spec, const CalibrationOutcome& o) {
  const Determination& d = o.determination;
  const std::string widened =
      d.scale > 1.0 ? ", widened by " + num(std::sqrt(d.scale), 3) + " because the misfit exceeds the tolerances" : "";
  page.paragraph("Intervals of " + percent(spec.confidence) + " %, from " + num(d.rows) +
                 " numbers that depend on a parameter" + widened +
                 ". Determined \"no\": the interval covers three quarters of the range or more.");
  if (d.gain > kSearchEnded)
    page.paragraph("The search has not converged: a linear step would lower the misfit by about " + num(d.gain, 3) +
                   " of " + num(o.best->misfit, 3) +
                   ". The intervals are reliable only with more evaluations in the last stage.");
  if (o.confirmations > 1)
    page.paragraph("The set is the best of " + num(o.confirmations) +
                   " sets that were run completely: the set of the search, and sets near it that should meet more "
                   "targets to first order. Differences are computed about the set of the search.");
}

void show_parameters(StudyPage& page, const CalibrationSpec& spec, const CalibrationOutcome& o,
                     const std::vector<NamedSet>& sets) {
  const std::vector<Interval>& intervals = o.determination.intervals;
  Row head = {"parameter", "range", "scale"};
  for (const NamedSet& set : sets) head.push_back(set.name);
  if (!intervals.empty()) append(head, {"interval", "determined"});
  append(head, {"source of the range"});
  Table table(head);
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const CalibrationParameter& p = spec.parameters[i];
    Row row = {p.name, num(p.least) + " to " + num(p.most), std::string(name_of(p.scale))};
    for (const NamedSet& set : sets) row.push_back(num(p.value(set.set->point[i])));
    if (!intervals.empty())
      append(row, {num(intervals[i].least, 4) + " to " + num(intervals[i].most, 4),
                   intervals[i].is_determined() + (intervals[i].at_edge ? "; at the end of the range" : "")});
    append(row, {p.origin});
    table.add(row);
  }
  page.table(table);
}

// Distances and seeds belong to the last of `sets`.
void show_targets(StudyPage& page, const CalibrationSpec& spec, const std::vector<NamedSet>& sets,
                  const Sets& comparable) {
  page.section("The targets");
  const auto of_all = [&](const auto& number) {
    Row texts;
    for (const NamedSet& set : sets) texts.push_back(number(*set.set) + " (" + set.name + ")");
    return joined(texts);
  };
  std::string text = "Targets met, of " + num(spec.targets.size()) + ": " +
                     of_all([](const EvaluatedPoint& e) { return num(e.met()); }) +
                     ". Misfit: " + of_all([](const EvaluatedPoint& e) { return num(e.misfit, 4); }) + ".";
  if (std::any_of(spec.targets.begin(), spec.targets.end(), [](const TargetSpec& t) { return t.weight != 1.0; }))
    text += " Their weights together: " + of_all([&](const EvaluatedPoint& e) { return num(weight_met(spec, e), 4); }) +
            ".";
  if (spec.cap > 0.0)
    text += " Distances above " + num(spec.cap) +
            " tolerances are cut to this value in the misfit; the best set meets the most targets.";
  if (sets.back().name == "confirmed")
    text += " The best set comes from the runs of the last stage; confirmed: complete runs over all seeds.";
  page.paragraph(text + " Distances [tolerances] are of \"" + sets.back().name + "\", the least of all " +
                 num(comparable.size()) + " sets.");
  Row head = {"target", "required", "tolerance", "weight"};
  for (const NamedSet& set : sets) head.push_back(set.name);
  append(head, {"distance", "met", "least distance", "sets that meet it", "source"});
  Table table(head);
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    const TargetSpec& target = spec.targets[t];
    const TargetResult& last = sets.back().set->targets[t];
    Row row = {target.name, requirement_text(target), num(target.tolerance), num(target.weight)};
    for (const NamedSet& set : sets) row.push_back(value_text(target, set.set->targets[t]));
    double least = std::numeric_limits<double>::infinity();
    for (const EvaluatedPoint* e : comparable)
      if (!e->targets[t].failed) least = std::min(least, e->targets[t].distance());
    append(row, {num(last.distance(), 3),
                 (last.is_met() ? "yes" : "no") +
                     (last.seeds > 1 ? ", " + num(last.seeds_met) + " of " + num(last.seeds) + " seeds" : ""),
                 num(least, 3),
                 num(std::count_if(comparable.begin(), comparable.end(),
                                   [&](const EvaluatedPoint* e) { return e->targets[t].is_met(); })),
                 target.origin});
    table.add(row);
  }
  page.table(table);
}

// A row per name, a column per parameter.
void show_matrix(StudyPage& page, const CalibrationSpec& spec, const std::string& corner, const Row& names,
                 const std::function<std::string(Eigen::Index, Eigen::Index)>& text) {
  Row head = {corner};
  append(head, names_in(spec.parameters));
  Table table(head);
  for (std::size_t k = 0; k < names.size(); ++k) {
    Row row = {names[k]};
    for (std::size_t i = 0; i < spec.parameters.size(); ++i) row.push_back(text(k, i));
    table.add(row);
  }
  page.table(table);
}

void show_determination(StudyPage& page, const CalibrationSpec& spec, const Determination& d) {
  page.section("Effect of each parameter");
  page.paragraph(
      "Change of each target over the whole range of a parameter, to first order about the best set [tolerances]; of "
      "curves without sign.");
  show_matrix(page, spec, "target", names_in(spec.targets),
              [&](Eigen::Index t, Eigen::Index i) { return num(d.sensitivity(t, i), 3); });
  page.section("Correlation of the parameters");
  page.paragraph("Near 1 or -1 the targets determine only a combination of the two.");
  for (const Eigen::VectorXd& direction : d.loose)
    page.paragraph("The targets do not determine the direction " + step_text(spec, direction, 0.1) +
                   " (relative to the ranges).");
  show_matrix(page, spec, "parameter", names_in(spec.parameters),
              [&](Eigen::Index i, Eigen::Index k) { return fixed_text(d.correlation(i, k), 2); });
}

void show_conflicts(StudyPage& page, const CalibrationSpec& spec, const Sets& sets) {
  page.section("Targets met together");
  const Conflicts found = conflicts_of(spec, sets);
  Row never;
  for (const std::size_t t : found.never) never.push_back(spec.targets[t].name);
  page.paragraph("Of " + num(sets.size()) + " sets with runs as in the last stage one meets most targets: " +
                 num(most_met(spec, sets)->met()) + " of " + num(spec.targets.size()) + ". " +
                 (never.empty() ? "Every target is met by some set." : "Met by none: " + joined(never, "; ") + "."));
  if (found.pairs.empty()) return;
  page.paragraph("These pairs are met by some sets each, and by none together:");
  Table table({"target", "other target", "sets that meet the first", "the other"});
  for (const Conflicts::Pair& pair : found.pairs)
    table.add({spec.targets[pair.a].name, spec.targets[pair.b].name, num(pair.met_a), num(pair.met_b)});
  page.table(table);
}

void show_single_targets(StudyPage& page, const CalibrationSpec& spec, const CalibrationOutcome& o) {
  page.section("Targets that no set meets, sought one by one");
  page.paragraph(
      "Without regard to the other targets, from the nearest of the sets above, by response surfaces; the nearest of "
      "all sets, and its distance [tolerances].");
  Row head = {"target", "required", "more sets", "nearest", "distance"};
  append(head, names_in(spec.parameters));
  Table table(head);
  for (const SingleTarget& one : o.single_targets) {
    const TargetSpec& target = spec.targets[one.target];
    const TargetResult& result = one.nearest->targets[one.target];
    Row row = {target.name, requirement_text(target), num(one.sets), value_text(target, result),
               num(result.distance(), 3)};
    for (std::size_t i = 0; i < spec.parameters.size(); ++i)
      row.push_back(num(spec.parameters[i].value(one.nearest->point[i]), 3));
    table.add(row);
  }
  page.table(table);
}

void show_search(StudyPage& page, const CalibrationSpec& spec, const CalibrationOutcome& o) {
  page.section("The search");
  Table table({"stage", "sets", "at most", "runs", "final misfit", "reason of the end"});
  for (std::size_t k = 0; k < o.stages.size(); ++k) {
    const StageOutcome& stage = o.stages[k];
    int runs = 0;
    for (const EvaluatedPoint* e : stage.evaluations) runs += e->runs;
    table.add({std::string(name_of(spec.stages[k].method)), num(stage.evaluations.size()),
               num(spec.stages[k].evaluations), num(runs), num(stage.best, 5),
               stage.path.requested.empty() ? stage.path.end : "in progress"});
  }
  page.table(table);
}

}  // namespace

StudyPage calibration_page(const CalibrationSpec& spec, const CalibrationOutcome& o, const Sets& comparable,
                           const std::string& command, const std::vector<std::string>& pictures) {
  const bool ended = !o.determination.intervals.empty();
  const std::string title = spec.title.empty() ? fs::path(spec.file).stem().string() : spec.title;
  StudyPage page(title + (ended ? "" : ", so far"));
  page.paragraph("Made by `" + command + "`." +
                 (ended ? "" : " The calibration is in progress: nothing is confirmed, and there are no intervals."));
  if (!ended && comparable.empty()) return page;
  std::vector<NamedSet> sets = {{"start", o.start}};
  if (ended) {
    sets.push_back({"best", o.best});
  } else {
    sets.push_back({"least misfit", *std::min_element(comparable.begin(), comparable.end(),
                                                      [](auto* a, auto* b) { return a->misfit < b->misfit; })});
    sets.push_back({"most met", most_met(spec, comparable)});
  }
  page.section(ended ? "The best set" : "Parameters");
  if (ended) show_intervals(page, spec, o);
  show_parameters(page, spec, o, sets);
  if (ended) sets.push_back({"confirmed", o.confirmed});
  show_targets(page, spec, sets, comparable);
  if (ended) show_determination(page, spec, o.determination);
  show_conflicts(page, spec, comparable);
  if (!o.single_targets.empty()) show_single_targets(page, spec, o);
  show_search(page, spec, o);
  if (!pictures.empty()) page.section("Pictures");
  for (const std::string& picture : pictures) page.picture(picture);
  return page;
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
    for (const EvaluatedPoint* e : outcome.stages[k].evaluations) {
      least = std::min(least, e->misfit);
      Row row = {num(++number), num(k + 1)};
      for (std::size_t i = 0; i < e->point.size(); ++i) row.push_back(spec.parameters[i].text(e->point[i]));
      append(row, {num(e->misfit, 10), num(least, 10), num(e->met())});
      for (std::size_t t = 0; t < e->targets.size(); ++t) {
        const TargetResult& result = e->targets[t];
        row.push_back(result.failed ? ""
                                    : num(spec.targets[t].is_curve() ? result.distance() : result.values.front(), 10));
      }
      row.push_back(e->message);
      table.add(row);
    }
  }
  return table;
}

std::vector<std::string> draw_calibration(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                          const std::string& folder) {
  Table parameters({"parameter", "best", "least", "most"}), targets({"target", "start", "best", "confirmed"});
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {  // positions in the ranges
    const CalibrationParameter& p = spec.parameters[i];
    const Interval& interval = outcome.determination.intervals[i];
    parameters.add(
        {p.name, num(outcome.best->point[i]), num(p.position(interval.least)), num(p.position(interval.most))});
  }
  for (std::size_t t = 0; t < spec.targets.size(); ++t)
    targets.add({spec.targets[t].name, num(outcome.start->targets[t].distance()),
                 num(outcome.best->targets[t].distance()), num(outcome.confirmed->targets[t].distance())});
  write_whole_file((fs::path(folder) / "parameters.csv").string(), parameters.csv());
  write_whole_file((fs::path(folder) / "targets.csv").string(), targets.csv());
  const auto drawn = [&](const std::string& name, std::size_t height, const std::string& drawing) {
    return write_drawing(folder, name, {1000, static_cast<int>(height)}, csv_setup(),
                         "unset logscale\nset autoscale\nunset ylabel\nset ytics noenhanced\nset grid\n" + drawing);
  };
  const auto rows = [](std::size_t count) {
    return "set yrange [-0.7:" + fixed_text(static_cast<double>(count) - 0.3, 1) + "] reverse\n";
  };
  return run_gnuplot(
      folder,
      {drawn("misfit", 500,
             "set logscale y\nset xlabel 'set'\nset ylabel 'misfit'\nset key outside right top\nplot 'way.csv' using "
             "'set':(column('misfit') + 1e-12) with points pt 7 ps 0.6 lc 'gray' title 'each set', '' using "
             "'set':(column('least') + 1e-12) with steps lw 2 lc 1 title 'least of the stage'\n"),
       drawn("parameters", 140 + 40 * spec.parameters.size(),
             "set xlabel 'position in the range'\nset xrange [0:1]\n" + rows(spec.parameters.size()) +
                 "plot 'parameters.csv' using 2:0:3:4:ytic(1) with xerrorbars pt 7 lw 2 lc 1 notitle\n"),
       drawn("targets", 160 + 26 * spec.targets.size(),
             "set xlabel 'distance from the target [tolerances]'\nset key outside right top\n" +
                 rows(spec.targets.size()) +
                 "plot 'targets.csv' using 2:0:ytic(1) with points pt 6 lc 'gray' title 'start', '' using 3:0 with "
                 "points pt 7 lc 1 title 'best', '' using 4:0 with points pt 2 lc 2 title 'confirmed'\n")});
}

}  // namespace footfall

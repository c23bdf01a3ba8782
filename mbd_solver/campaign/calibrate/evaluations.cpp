// Turns sets of parameters into runs of the store, and finished runs into values of targets.
#include "mbd_solver/campaign/calibrate/evaluations.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/fingerprint.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/sweep_file.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

namespace fs = std::filesystem;

double residual_of(const TargetSpec& target, double y, std::size_t row_of_curve) {
  const double value = target.is_curve() ? target.rows[row_of_curve].y() : target.value.value_or(0.0);
  if (!target.is_band()) return (y - value) / target.tolerance;
  if (y > target.most) return (y - target.most) / target.tolerance;
  return y < target.least ? (y - target.least) / target.tolerance : 0.0;
}

double capped(double residual, double cap) { return cap > 0.0 ? std::clamp(residual, -cap, cap) : residual; }

double TargetResult::misfit(const TargetSpec& target, double cap) const {
  double sum = 0.0;
  for (const double r : residuals) sum += target.weight * capped(r, cap) * capped(r, cap);
  return sum;
}

double TargetResult::distance() const {
  double sum = 0.0;
  for (const double r : residuals) sum += r * r;
  return std::sqrt(sum / static_cast<double>(residuals.size()));
}

bool TargetResult::is_met() const {
  constexpr double kCurveWithin = 1.5;  // noise of one tolerance gives about one
  return !failed && distance() <= (band ? 0.0 : residuals.size() > 1 ? kCurveWithin : 1.0);
}

std::vector<double> first_crossings(const std::vector<double>& x, const std::vector<double>& y,
                                    const std::vector<double>& at) {
  const auto rows = static_cast<std::size_t>(std::max_element(x.begin(), x.end()) - x.begin()) + 1;
  std::vector<double> values;
  for (const double place : at) {
    std::size_t k = 0;
    while (k < rows && x[k] < place) ++k;
    if (k == 0 || k == rows)
      values.push_back(k == 0 ? y.front() : y[rows - 1]);
    else
      values.push_back(y[k - 1] + (y[k] - y[k - 1]) * (place - x[k - 1]) / (x[k] - x[k - 1]));
  }
  return values;
}

RunNumbers numbers_of(const CalibrationSpec& spec, const std::string& scene, const std::string& folder) {
  RunNumbers numbers;
  History history;
  for (const TargetSpec& target : spec.targets) {
    if (!target.uses(scene)) continue;
    if (!target.is_curve()) {
      const MetricSpec& metric = spec.metrics[index_of(spec.metrics, target.metric)];
      const double y = metrics_of_run({metric}, folder, spec.file).front();
      if (std::isfinite(y)) numbers.metrics[target.metric] = y;
      continue;
    }
    if (history.names.empty()) history = read_history((fs::path(folder) / "history.csv").string());
    require_columns({target.over, target.column}, history, folder, spec.file, "targets." + target.name);
    std::vector<double> places;
    for (const Eigen::Vector2d& row : target.rows) places.push_back(row.x());
    if (const std::vector<double>& x = history.column(target.over); !x.empty())
      numbers.curves[target.name] = first_crossings(x, history.column(target.column), places);
  }
  return numbers;
}

TargetResult result_of(const CalibrationSpec& spec, std::size_t target,
                       const std::vector<std::vector<RunNumbers>>& runs) {
  const TargetSpec& t = spec.targets[target];
  const std::size_t rows = t.is_curve() ? t.rows.size() : 1;
  const auto of_scene = [&](const std::string& scene) {  // y by row and seed; empty if one is missing
    std::vector<std::vector<double>> all(rows);
    for (const RunNumbers& run : runs[index_of(spec.scenes, scene)]) {
      std::vector<double> y;
      if (run.metrics.count(t.metric) > 0) y = {run.metrics.at(t.metric)};
      if (t.is_curve()) y = run.curves.count(t.name) > 0 ? run.curves.at(t.name) : std::vector<double>();
      if (y.size() != rows) return std::vector<std::vector<double>>();
      for (std::size_t k = 0; k < rows; ++k) all[k].push_back(y[k]);
    }
    return all.front().empty() ? std::vector<std::vector<double>>() : all;
  };
  const std::vector<std::vector<double>> mine = of_scene(t.scene),
                                         others = of_scene(t.against.empty() ? t.scene : t.against);
  const auto compared = [&](double a, double b) { return t.against.empty() ? a : t.difference ? a - b : a / b; };
  TargetResult result, failure;
  failure.failed = true;
  failure.residuals = {spec.failed};
  if (mine.empty() || others.empty()) return failure;
  result.seeds = mine.front().size();
  result.band = t.is_band();
  std::vector<TargetResult> alone(result.seeds, result);
  for (std::size_t k = 0; k < rows; ++k) {
    std::vector<double> y;
    for (std::size_t s = 0; s < result.seeds; ++s) {
      y.push_back(compared(mine[k][s], others[k][s]));
      alone[s].residuals.push_back(residual_of(t, y.back(), k));
    }
    result.values.push_back(compared(sampled_metric(mine[k]).mean, sampled_metric(others[k]).mean));
    if (!std::isfinite(result.values.back())) return failure;
    result.spread.push_back(sampled_metric(y).spread);
    result.residuals.push_back(residual_of(t, result.values.back(), k));
  }
  for (const TargetResult& one : alone) result.seeds_met += one.is_met() ? 1 : 0;
  return result;
}

namespace {

using Json = nlohmann::ordered_json;

// The requirements of the targets on the runs of a scene, as a fingerprint.
std::string requirements_of(const CalibrationSpec& spec, const std::string& scene) {
  std::ostringstream text;
  text.precision(17);
  for (const TargetSpec& target : spec.targets) {
    if (!target.uses(scene)) continue;
    if (target.is_curve()) {
      text << target.name << '\n' << target.column << '\n' << target.over;
      for (const Eigen::Vector2d& row : target.rows) text << ' ' << row.x();
    } else {
      text << metric_recipe(spec.metrics[index_of(spec.metrics, target.metric)]);
    }
    text << '\n';
  }
  return fingerprint(text.str()).substr(0, 16);
}

}  // namespace

RunRecords::RunRecords(const CalibrationSpec& spec, std::string file) : file_(std::move(file)) {
  for (const CalibrationScene& scene : spec.scenes) requirements_[scene.name] = requirements_of(spec, scene.name);
  std::istringstream in(file_.empty() ? "" : read_whole_file(file_).value_or(""));
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty()) continue;
    const Json json = Json::parse(line, nullptr, false);
    if (in.eof() && json.is_discarded()) break;  // incomplete
    try {
      entries_[{json.at("scene"), json.at("recipe"), json.at("asked")}] = {
          json.at("run"), {json.at("figures"), json.at("curves")}, json.at("wall_s"), json.at("cpu_s")};
    } catch (const Json::exception&) {
      throw InputError(code::kRecordsDamaged,
                       file_ + ":" + std::to_string(number) +
                           ": is not a record of a run; remove the line, and the run is repeated");
    }
  }
}

const RunRecords::Entry* RunRecords::find(const std::string& scene, const std::string& recipe) const {
  const auto found = entries_.find({scene, recipe, requirements_.at(scene)});
  return recipe.empty() || found == entries_.end() ? nullptr : &found->second;
}

void RunRecords::add(const std::string& scene, const std::string& recipe, const Entry& entry) {
  if (recipe.empty()) return;
  changed_ = entries_.emplace(std::tuple(scene, recipe, requirements_.at(scene)), entry).second || changed_;
}

void RunRecords::write() {
  if (!changed_ || file_.empty()) return;
  std::string text;
  for (const auto& [key, entry] : entries_)
    text += Json{{"scene", std::get<0>(key)},
                 {"recipe", std::get<1>(key)},
                 {"asked", std::get<2>(key)},
                 {"run", entry.run},
                 {"wall_s", entry.wall},
                 {"cpu_s", entry.cpu},
                 {"figures", entry.numbers.metrics},
                 {"curves", entry.numbers.curves}}
                .dump() +
            "\n";
  write_whole_file(file_, text);
  changed_ = false;
}

Fidelity fidelity_of(const CalibrationSpec& spec, const StageSpec& stage) {
  return {stage.settings, stage.until, spec.seeds ? spec.seeds->search : 1, {}};
}

Fidelity full_fidelity(const CalibrationSpec& spec) {
  return {{}, 0.0, spec.seeds ? static_cast<int>(spec.seeds->values.size()) : 1, {}};
}

int EvaluatedPoint::met() const {
  return static_cast<int>(
      std::count_if(targets.begin(), targets.end(), [](const TargetResult& t) { return t.is_met(); }));
}

std::vector<double> EvaluatedPoint::residuals(const CalibrationSpec& spec) const {
  std::vector<double> all;
  for (std::size_t t = 0; t < targets.size(); ++t)
    for (const double r : targets[t].residuals) all.push_back(std::sqrt(spec.targets[t].weight) * capped(r, spec.cap));
  return all;
}

std::string Evaluations::key(const Fidelity& fidelity, const UnitPoint& point) const {
  Json key = {fidelity.settings, fidelity.until, fidelity.seeds, fidelity.single_target.value_or(spec_.targets.size())};
  for (std::size_t i = 0; i < point.size(); ++i) key.push_back(spec_.parameters[i].text(point[i]));
  return key.dump();
}

std::vector<std::string> Evaluations::settings(const Fidelity& fidelity, std::size_t scene,
                                               const UnitPoint& point) const {
  std::vector<std::string> settings = spec_.settings;
  append(settings, fidelity.settings);
  append(settings, spec_.scenes[scene].settings);
  for (std::size_t i = 0; i < point.size(); ++i)
    append(settings, filled(spec_.parameters[i].settings, spec_.parameters[i].text(point[i])));
  return with_formulas(settings, spec_, point);
}

std::vector<std::size_t> Evaluations::moved_by(const Fidelity& fidelity, std::size_t target) const {
  const UnitPoint from = start_of(spec_);
  std::vector<std::size_t> parameters;
  for (std::size_t i = 0; i < from.size(); ++i) {
    UnitPoint to = from;
    to[i] = from[i] < 0.5 ? 1.0 : 0.0;
    bool moves = false;
    for (std::size_t scene = 0; scene < spec_.scenes.size(); ++scene)
      if (spec_.targets[target].uses(spec_.scenes[scene].name))
        moves = moves || settings(fidelity, scene, from) != settings(fidelity, scene, to);
    if (moves) parameters.push_back(i);
  }
  return parameters;
}

RunRequest Evaluations::request(const Fidelity& fidelity, std::size_t scene, int seed, const UnitPoint& point) const {
  const CalibrationScene& s = spec_.scenes[scene];
  RunRequest request;
  request.scene = s.scene;
  request.settings = settings(fidelity, scene, point);
  if (spec_.seeds) append(request.settings, filled(spec_.seeds->settings, spec_.seeds->values[seed]));
  request.until = fidelity.until > 0.0 ? fidelity.until : s.until > 0.0 ? s.until : spec_.until;
  request.time_limit = spec_.time_limit;
  // Independent of the path of the search.
  request.name =
      s.name + "_" + fingerprint(joined(request.settings, "\n") + "\n" + number_text(request.until, 10)).substr(0, 16);
  return request;
}

const EvaluatedPoint* Evaluations::known(const Fidelity& fidelity, const UnitPoint& point) {
  const std::string name = key(fidelity, point);
  if (const auto found = known_.find(name); found != known_.end()) return &found->second;
  const double violation = violation_of(spec_, point);
  if (violation == 0.0) return nullptr;
  EvaluatedPoint e = evaluation_of(fidelity, point, {});
  e.misfit = kViolated * (1.0 + violation);
  e.message = "violates a constraint";
  return &known_.emplace(name, e).first->second;
}

bool Evaluations::carry_out(const Fidelity& fidelity, const std::vector<UnitPoint>& sets, bool must_be_read) {
  std::vector<std::vector<Planned>> planned(sets.size());
  std::vector<std::size_t> missing;  // not among the records
  std::size_t count = 0;
  for (std::size_t k = 0; k < sets.size(); ++k)
    for (std::size_t scene = 0; scene < spec_.scenes.size() && !known(fidelity, sets[k]); ++scene) {
      if (fidelity.single_target && !spec_.targets[*fidelity.single_target].uses(spec_.scenes[scene].name)) continue;
      for (int seed = 0; seed < fidelity.seeds; ++seed, ++count) {
        RunRequest r = request(fidelity, scene, seed, sets[k]);
        r.may_be_refused = !must_be_read;
        planned[k].push_back({scene, store_.add(r)});
        if (!record(planned[k].back())) missing.push_back(planned[k].back().run);
      }
    }
  std::vector<std::size_t> left = store_.left(missing);
  const auto remove_failed = [&](const auto& failed) {
    left.erase(std::remove_if(left.begin(), left.end(), failed), left.end());
  };
  // A search repeats failed runs; here they count as failed.
  if (read_only_) remove_failed([&](std::size_t run) { return store_.end_of(run).status == "failed"; });
  if (read_only_ && !left.empty()) return false;
  runs_reused_ += static_cast<int>(count - left.size());
  for (const std::size_t run : store_.beds_to_make(left, 2)) {
    if (must_be_read) store_.make_bed(run, false);
    store_.try_bed(run);
  }
  remove_failed([&](std::size_t run) { return store_.has_failed(run); });
  const auto began = std::chrono::steady_clock::now();
  const auto count_run = [&](std::size_t) {
    if (++runs_done_ % 10 == 0) std::printf("%d runs done\n", runs_done_), std::fflush(stdout);
  };
  if (!left.empty() && !store_.carry_out(left, jobs(), count_run)) return false;
  const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (known(fidelity, sets[k])) continue;
    EvaluatedPoint e = evaluation_of(fidelity, sets[k], planned[k]);
    if (left.size() == count) e.lasted = taken / std::ceil(static_cast<double>(left.size()) / jobs());
    known_.emplace(key(fidelity, sets[k]), e);
  }
  if (!read_only_) records_.write();
  return true;
}

const RunRecords::Entry* Evaluations::record(const Planned& planned) const {
  return records_.find(spec_.scenes[planned.scene].name, store_.portable_recipe(planned.run));
}

EvaluatedPoint Evaluations::evaluation_of(const Fidelity& fidelity, const UnitPoint& point,
                                          const std::vector<Planned>& runs) {
  EvaluatedPoint e;
  e.point = point;
  e.runs = static_cast<int>(runs.size());
  std::vector<std::vector<RunNumbers>> numbers(spec_.scenes.size());
  std::vector<std::size_t> failed;  // scenes
  for (const Planned& p : runs) {
    const std::string& scene = spec_.scenes[p.scene].name;
    if (!record(p)) {
      const RunEnd end = store_.end_of(p.run);
      // Such an end is no result of the set.
      if (end.code == kExitInterrupted || (end.code > 128 && spec_.time_limit == 0))
        throw PartnerError(code::kRunEndedFromOutside, "the run " + end.folder + " was ended from outside (exit code " +
                                                           std::to_string(end.code) + "); the same command resumes");
      if (end.done())
        records_.add(scene, store_.portable_recipe(p.run),
                     {store_.request(p.run).name, numbers_of(spec_, scene, end.folder), end.cost.wall, end.cost.cpu});
      else
        e.message = scene + ": " + (end.message.empty() ? end.status : end.message);
    }
    if (const RunRecords::Entry* entry = record(p)) {
      e.lasted += entry->wall / static_cast<double>(runs.size());
      numbers[p.scene].push_back(entry->numbers);
    } else {
      failed.push_back(p.scene);
    }
  }
  for (const std::size_t scene : failed) numbers[scene].clear();
  for (std::size_t t = 0; t < spec_.targets.size(); ++t) {
    e.targets.push_back(result_of(spec_, t, numbers));
    if (fidelity.single_target.value_or(t) == t)
      e.misfit += e.targets.back().misfit(spec_.targets[t], fidelity.single_target ? 0.0 : spec_.cap);
  }
  return e;
}

}  // namespace footfall

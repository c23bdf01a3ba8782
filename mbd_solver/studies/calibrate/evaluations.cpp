// Turns sets of parameters into runs of the store, and finished runs into values of targets.
#include "mbd_solver/studies/calibrate/evaluations.h"

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
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/sweep_file.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr double kCurveWithin = 1.5;  // tolerances, root mean square; noise of one tolerance gives about one

TargetResult failure(const CalibrationSpec& spec) {
  TargetResult result;
  result.failed = true;
  result.residuals = {spec.failed};
  return result;
}

}  // namespace

double residual_of(const TargetSpec& target, double y) {
  if (target.value) return (y - *target.value) / target.tolerance;
  if (y > target.most) return (y - target.most) / target.tolerance;
  return y < target.least ? (y - target.least) / target.tolerance : 0.0;
}

double capped(double residual, double cap) { return cap > 0.0 ? std::clamp(residual, -cap, cap) : residual; }

double TargetResult::misfit(const TargetSpec& target, double cap) const {
  double sum = 0.0;
  for (const double r : residuals) sum += target.weight * capped(r, cap) * capped(r, cap);
  return sum;
}

bool TargetResult::met(const std::vector<double>& residuals, bool band) {
  double squares = 0.0;
  for (const double r : residuals) squares += r * r;
  if (band) return squares == 0.0;
  return std::sqrt(squares / static_cast<double>(residuals.size())) <= (residuals.size() > 1 ? kCurveWithin : 1.0);
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
  numbers.metrics.assign(spec.metrics.size(), std::nan(""));
  numbers.curves.resize(spec.targets.size());
  History history;
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    const TargetSpec& target = spec.targets[t];
    if (target.scene != scene && target.against != scene) continue;
    if (!target.is_curve()) {
      const auto k = static_cast<std::size_t>(index_of(spec.metrics, target.metric));
      if (std::isnan(numbers.metrics[k]))
        numbers.metrics[k] = metrics_of_run({spec.metrics[k]}, folder, spec.file).front();
      continue;
    }
    if (history.names.empty()) history = read_history((fs::path(folder) / "history.csv").string());
    std::vector<double> places;
    for (const Eigen::Vector2d& row : read_two_columns(target.file)) places.push_back(row.x());
    require_columns({target.over, target.column}, history, folder, spec.file, "targets." + target.name);
    const std::vector<double>& x = history.column(target.over);
    if (!x.empty()) numbers.curves[t] = first_crossings(x, history.column(target.column), places);
  }
  return numbers;
}

TargetResult result_of(const CalibrationSpec& spec, std::size_t target,
                       const std::vector<std::vector<RunNumbers>>& runs) {
  const TargetSpec& t = spec.targets[target];
  const std::vector<RunNumbers>& mine = runs[static_cast<std::size_t>(index_of(spec.scenes, t.scene))];
  if (mine.empty()) return failure(spec);
  TargetResult result;
  if (t.is_curve()) {
    const std::vector<Eigen::Vector2d> rows = read_two_columns(t.file);
    for (const RunNumbers& run : mine) {
      if (run.curves[target].size() != rows.size()) return failure(spec);
      result.of_seed.push_back(run.curves[target]);
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      std::vector<double> values;
      for (const RunNumbers& run : mine) values.push_back(run.curves[target][k]);
      const SampledMetric sampled = sampled_metric(values);
      result.values.push_back(sampled.mean);
      result.spread.push_back(sampled.spread);
      result.residuals.push_back((result.values.back() - rows[k].y()) / t.tolerance);
    }
    return result;
  }
  const auto k = static_cast<std::size_t>(index_of(spec.metrics, t.metric));
  std::vector<double> values, others, ratios;
  for (const RunNumbers& run : mine) values.push_back(run.metrics[k]);
  double y = sampled_metric(values).mean;
  if (!t.against.empty()) {
    for (const RunNumbers& run : runs[static_cast<std::size_t>(index_of(spec.scenes, t.against))])
      others.push_back(run.metrics[k]);
    if (others.size() != values.size()) return failure(spec);
    const auto compared = [&](double a, double b) { return t.difference ? a - b : a / b; };
    for (std::size_t s = 0; s < values.size(); ++s) values[s] = compared(values[s], others[s]);
    y = compared(y, sampled_metric(others).mean);
  }
  if (!std::isfinite(y)) return failure(spec);
  for (const double value : values) result.of_seed.push_back({value});
  result.values = {y};
  result.spread = {sampled_metric(values).spread};
  result.residuals = {residual_of(t, y)};
  result.band = t.is_band();
  return result;
}

using Json = nlohmann::ordered_json;

namespace {

// True if the target requires runs of this scene.
bool requires(const TargetSpec& target, const std::string& scene) {
  return target.scene == scene || target.against == scene;
}

std::string text_of(const MetricSpec& f) {
  std::ostringstream text;
  text.precision(17);
  text << f.name << '\n' << f.key << '\n' << joined(f.columns, ",") << '\n' << name_of(f.reduction) << ' ' << f.average;
  text << ' ' << f.prominence << ' ' << f.over;
  for (const double height : f.slope) text << ' ' << height;
  return text.str();
}

}  // namespace

std::string RunRecords::requirements_of(const std::string& scene) const {
  std::ostringstream text;
  text.precision(17);
  for (const TargetSpec& target : spec_.targets) {
    if (!requires(target, scene)) continue;
    if (target.is_curve()) {
      text << target.name << '\n' << target.column << '\n' << target.over;
      for (const Eigen::Vector2d& row : read_two_columns(target.file)) text << ' ' << row.x();
    } else {
      text << text_of(spec_.metrics[static_cast<std::size_t>(index_of(spec_.metrics, target.metric))]);
    }
    text << '\n';
  }
  return fingerprint(text.str()).substr(0, 16);
}

RunRecords::RunRecords(const CalibrationSpec& spec, std::string file) : spec_(spec), file_(std::move(file)) {
  if (file_.empty()) return;
  for (const CalibrationScene& scene : spec_.scenes) requirements_[scene.name] = requirements_of(scene.name);
  std::istringstream in(read_whole_file(file_).value_or(""));
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty()) continue;
    const Json json = Json::parse(line, nullptr, false);
    if (in.eof() && json.is_discarded()) break;  // incomplete
    try {
      const std::string scene = json.at("scene"), required = json.at("asked");
      const auto known = requirements_.find(scene);
      if (known == requirements_.end() || known->second != required) {
        other_lines_ += line + "\n";
        continue;
      }
      Entry entry;
      entry.run = json.at("run");
      entry.wall = json.at("wall_s"), entry.cpu = json.at("cpu_s");
      entry.numbers.metrics.assign(spec_.metrics.size(), std::nan(""));
      entry.numbers.curves.resize(spec_.targets.size());
      for (const auto& [name, value] : json.at("figures").items())
        if (const int k = index_of(spec_.metrics, name); k >= 0)
          entry.numbers.metrics[static_cast<std::size_t>(k)] = value.get<double>();
      for (const auto& [name, values] : json.at("curves").items())
        if (const int t = index_of(spec_.targets, name); t >= 0)
          entry.numbers.curves[static_cast<std::size_t>(t)] = values.get<std::vector<double>>();
      entries_[{scene, json.at("recipe")}] = entry;
    } catch (const Json::exception&) {
      throw InputError(code::kRecordsDamaged,
                       file_ + ":" + std::to_string(number) +
                           ": is not a record of a run; remove the line, and the run is repeated");
    }
  }
}

const RunRecords::Entry* RunRecords::find(const std::string& scene, const std::string& recipe) const {
  const auto found = entries_.find({scene, recipe});
  return recipe.empty() || found == entries_.end() ? nullptr : &found->second;
}

void RunRecords::add(const std::string& scene, const std::string& recipe, const Entry& entry) {
  if (file_.empty() || recipe.empty()) return;
  changed_ = entries_.emplace(std::make_pair(scene, recipe), entry).second || changed_;
}

void RunRecords::write() {
  if (!changed_) return;
  std::string text = other_lines_;
  for (const auto& [key, entry] : entries_) {
    Json metrics = Json::object(), curves = Json::object();
    for (std::size_t k = 0; k < entry.numbers.metrics.size(); ++k)
      if (!std::isnan(entry.numbers.metrics[k])) metrics[spec_.metrics[k].name] = entry.numbers.metrics[k];
    for (std::size_t t = 0; t < entry.numbers.curves.size(); ++t)
      if (!entry.numbers.curves[t].empty()) curves[spec_.targets[t].name] = entry.numbers.curves[t];
    const Json line = {{"scene", key.first}, {"recipe", key.second}, {"asked", requirements_.at(key.first)},
                       {"run", entry.run},   {"wall_s", entry.wall}, {"cpu_s", entry.cpu},
                       {"figures", metrics}, {"curves", curves}};
    text += line.dump() + "\n";
  }
  write_whole_file(file_, text);
  changed_ = false;
}

Fidelity fidelity_of(const CalibrationSpec& spec, const StageSpec& stage) {
  return {stage.settings, stage.until, spec.seeds ? spec.seeds->search : 1, {}};
}

Fidelity full_fidelity(const CalibrationSpec& spec) {
  return {{}, 0.0, spec.seeds ? static_cast<int>(spec.seeds->values.size()) : 1, {}};
}

int Evaluation::met() const {
  return static_cast<int>(
      std::count_if(targets.begin(), targets.end(), [](const TargetResult& t) { return t.is_met(); }));
}

std::vector<double> Evaluation::residuals(const CalibrationSpec& spec) const {
  std::vector<double> all;
  for (std::size_t t = 0; t < targets.size(); ++t)
    for (const double r : targets[t].residuals) all.push_back(std::sqrt(spec.targets[t].weight) * capped(r, spec.cap));
  return all;
}

std::string Evaluations::key(const Fidelity& fidelity, const UnitPoint& point) const {
  std::string text = joined(fidelity.settings, "\n") + "\n" + number_text(fidelity.until, 10) + "\n" +
                     std::to_string(fidelity.seeds) + "\n" +
                     (fidelity.single_target ? std::to_string(*fidelity.single_target) : "");
  for (std::size_t i = 0; i < point.size(); ++i) text += "\n" + spec_.parameters[i].text(point[i]);
  return text;
}

bool Evaluations::needs(const Fidelity& fidelity, std::size_t scene) const {
  if (!fidelity.single_target) return true;
  const TargetSpec& target = spec_.targets[*fidelity.single_target];
  return spec_.scenes[scene].name == target.scene || spec_.scenes[scene].name == target.against;
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
  const TargetSpec& t = spec_.targets[target];
  const UnitPoint from = start_of(spec_);
  std::vector<std::size_t> parameters;
  for (std::size_t i = 0; i < from.size(); ++i) {
    UnitPoint to = from;
    to[i] = from[i] < 0.5 ? 1.0 : 0.0;
    const bool moves = [&] {
      for (std::size_t scene = 0; scene < spec_.scenes.size(); ++scene)
        if ((spec_.scenes[scene].name == t.scene || spec_.scenes[scene].name == t.against) &&
            settings(fidelity, scene, from) != settings(fidelity, scene, to))
          return true;
      return false;
    }();
    if (moves) parameters.push_back(i);
  }
  return parameters;
}

RunRequest Evaluations::request(const Fidelity& fidelity, std::size_t scene, int seed, const UnitPoint& point) const {
  const CalibrationScene& s = spec_.scenes[scene];
  RunRequest request;
  request.scene = s.scene;
  request.settings = settings(fidelity, scene, point);
  if (spec_.seeds)
    append(request.settings, filled(spec_.seeds->settings, spec_.seeds->values[static_cast<std::size_t>(seed)]));
  request.until = fidelity.until > 0.0 ? fidelity.until : s.until > 0.0 ? s.until : spec_.until;
  request.time_limit = spec_.time_limit;
  // Independent of the path of the search.
  request.name =
      s.name + "_" + fingerprint(joined(request.settings, "\n") + "\n" + number_text(request.until, 10)).substr(0, 16);
  return request;
}

const Evaluation* Evaluations::known(const Fidelity& fidelity, const UnitPoint& point) {
  const std::string name = key(fidelity, point);
  const auto found = known_.find(name);
  if (found != known_.end()) return &found->second;
  const double violation = violation_of(spec_, point);
  if (violation == 0.0) return nullptr;
  Evaluation e;
  e.point = point;
  e.misfit = kViolated * (1.0 + violation);
  e.message = "violates a constraint";
  for (std::size_t t = 0; t < spec_.targets.size(); ++t)
    e.targets.push_back(result_of(spec_, t, std::vector<std::vector<RunNumbers>>(spec_.scenes.size())));
  return &known_.emplace(name, e).first->second;
}

bool Evaluations::carry_out(const Fidelity& fidelity, const std::vector<UnitPoint>& sets, int jobs, bool must_be_read) {
  std::vector<std::vector<std::vector<std::size_t>>> runs;  // by set and scene, one per seed
  std::vector<std::size_t> all, required;                   // required: not among the records
  for (const UnitPoint& point : sets) {
    runs.emplace_back();
    for (std::size_t scene = 0; scene < spec_.scenes.size(); ++scene) {
      runs.back().emplace_back();
      if (known(fidelity, point) || !needs(fidelity, scene)) continue;
      for (int seed = 0; seed < fidelity.seeds; ++seed) {
        RunRequest r = request(fidelity, scene, seed, point);
        r.may_be_refused = !must_be_read;
        runs.back().back().push_back(store_.add(r));
        all.push_back(runs.back().back().back());
        if (!in_records(scene, all.back())) required.push_back(all.back());
      }
    }
  }
  std::vector<std::size_t> left = store_.left(required);
  if (read_only_)  // a search repeats failed runs; here they count as failed
    left.erase(std::remove_if(left.begin(), left.end(),
                              [&](std::size_t run) { return store_.end_of(run).status == "failed"; }),
               left.end());
  if (read_only_ && !left.empty()) return false;
  runs_reused_ += static_cast<int>(all.size() - left.size());
  for (const std::size_t run : store_.beds_to_make(left, 2)) {
    std::printf("making the bed of %s\n", store_.request(run).name.c_str());
    std::fflush(stdout);
    if (must_be_read)
      store_.make_bed(run, true);
    else
      store_.try_bed(run);
  }
  left.erase(std::remove_if(left.begin(), left.end(), [&](std::size_t run) { return store_.has_failed(run); }),
             left.end());
  const auto began = std::chrono::steady_clock::now();
  if (!left.empty() && !store_.carry_out(left, jobs, [&](std::size_t) { ++runs_done_; })) return false;
  const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const double rounds = std::ceil(static_cast<double>(left.size()) / jobs);
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (known(fidelity, sets[k])) continue;
    Evaluation e = evaluation_of(fidelity, sets[k], runs[k]);
    if (left.size() == all.size()) e.lasted = taken / rounds;
    known_.emplace(key(fidelity, sets[k]), e);
  }
  if (!read_only_) records_.write();
  return true;
}

const RunRecords::Entry* Evaluations::in_records(std::size_t scene, std::size_t run) const {
  return store_.is_done(run) ? nullptr : records_.find(spec_.scenes[scene].name, store_.portable_recipe(run));
}

Evaluation Evaluations::evaluation_of(const Fidelity& fidelity, const UnitPoint& point,
                                      const std::vector<std::vector<std::size_t>>& runs) {
  Evaluation e;
  e.point = point;
  std::vector<std::vector<RunNumbers>> numbers;
  for (std::size_t scene = 0; scene < runs.size(); ++scene) {
    numbers.emplace_back();
    bool failed = false;
    const std::string& name = spec_.scenes[scene].name;
    for (const std::size_t run : runs[scene]) {
      ++e.runs;
      if (const RunRecords::Entry* entry = in_records(scene, run)) {
        e.wall += entry->wall;
        e.cpu += entry->cpu;
        numbers.back().push_back(entry->numbers);
        continue;
      }
      const RunEnd end = store_.end_of(run);
      e.wall += end.cost.wall;
      e.cpu += end.cost.cpu;
      failed = failed || !end.done();
      // Such an end is no result of the set.
      if (end.code == kExitInterrupted || (end.code > 128 && spec_.time_limit == 0))
        throw PartnerError(code::kRunEndedFromOutside, "the run " + end.folder + " was ended from outside (exit code " +
                                                           std::to_string(end.code) + "); the same command resumes");
      if (!end.done()) {
        e.message = name + ": " + (end.message.empty() ? end.status : end.message);
        continue;
      }
      numbers.back().push_back(numbers_of(spec_, name, end.folder));
      records_.add(name, store_.portable_recipe(run),
                   {store_.request(run).name, numbers.back().back(), end.cost.wall, end.cost.cpu});
    }
    if (failed) numbers.back().clear();
  }
  for (std::size_t t = 0; t < spec_.targets.size(); ++t) {
    e.targets.push_back(result_of(spec_, t, numbers));
    if (fidelity.requires(t))
      e.misfit += e.targets.back().misfit(spec_.targets[t], fidelity.single_target ? 0.0 : spec_.cap);
  }
  return e;
}

}  // namespace footfall

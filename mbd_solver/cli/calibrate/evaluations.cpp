#include "mbd_solver/cli/calibrate/evaluations.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "coupler/base/errors.h"
#include "coupler/base/fingerprint.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/experiments/experiment.h"
#include "mbd_solver/cli/experiments/table.h"

namespace footfall {

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

std::string Evaluations::key(const Fidelity& fidelity, const Shares& shares) const {
  std::string text = joined(fidelity.settings, "\n") + "\n" + number_text(fidelity.until, 10) + "\n" +
                     std::to_string(fidelity.seeds) + "\n" + (fidelity.alone ? std::to_string(*fidelity.alone) : "");
  for (std::size_t i = 0; i < shares.size(); ++i) text += "\n" + spec_.parameters[i].text(shares[i]);
  return text;
}

bool Evaluations::needs(const Fidelity& fidelity, std::size_t scene) const {
  if (!fidelity.alone) return true;
  const TargetSpec& target = spec_.targets[*fidelity.alone];
  return spec_.scenes[scene].name == target.scene || spec_.scenes[scene].name == target.against;
}

std::vector<std::string> Evaluations::settings(const Fidelity& fidelity, std::size_t scene,
                                               const Shares& shares) const {
  std::vector<std::string> settings = spec_.settings;
  append(settings, fidelity.settings);
  append(settings, spec_.scenes[scene].settings);
  for (std::size_t i = 0; i < shares.size(); ++i)
    append(settings, filled(spec_.parameters[i].settings, spec_.parameters[i].text(shares[i])));
  return with_formulas(settings, spec_, shares);
}

std::vector<std::size_t> Evaluations::moved_by(const Fidelity& fidelity, std::size_t target) const {
  const TargetSpec& t = spec_.targets[target];
  const Shares from = start_of(spec_);
  std::vector<std::size_t> parameters;
  for (std::size_t i = 0; i < from.size(); ++i) {
    Shares to = from;
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

RunRequest Evaluations::request(const Fidelity& fidelity, std::size_t scene, int seed, const Shares& shares) const {
  const CalibrationScene& s = spec_.scenes[scene];
  RunRequest request;
  request.scene = s.scene;
  request.settings = settings(fidelity, scene, shares);
  if (spec_.seeds)
    append(request.settings, filled(spec_.seeds->settings, spec_.seeds->values[static_cast<std::size_t>(seed)]));
  request.until = fidelity.until > 0.0 ? fidelity.until : s.until > 0.0 ? s.until : spec_.until;
  request.time_limit = spec_.time_limit;
  // The name does not depend on the way of the search.
  request.name =
      s.name + "_" + fingerprint(joined(request.settings, "\n") + "\n" + number_text(request.until, 10)).substr(0, 16);
  return request;
}

const Evaluation* Evaluations::known(const Fidelity& fidelity, const Shares& shares) {
  const std::string name = key(fidelity, shares);
  const auto found = known_.find(name);
  if (found != known_.end()) return &found->second;
  const double broken = broken_by(spec_, shares);
  if (broken == 0.0) return nullptr;
  Evaluation e;
  e.shares = shares;
  e.misfit = kBroken * (1.0 + broken);
  e.message = "breaks a constraint";
  for (std::size_t t = 0; t < spec_.targets.size(); ++t)
    e.targets.push_back(result_of(spec_, t, std::vector<std::vector<RunNumbers>>(spec_.scenes.size())));
  return &known_.emplace(name, e).first->second;
}

bool Evaluations::carry_out(const Fidelity& fidelity, const std::vector<Shares>& sets, int jobs, bool must_be_read) {
  std::vector<std::vector<std::vector<std::size_t>>> runs;  // by set and scene, one per seed
  std::vector<std::size_t> all, asked;                      // asked: those that the ledger does not have
  for (const Shares& shares : sets) {
    runs.emplace_back();
    for (std::size_t scene = 0; scene < spec_.scenes.size(); ++scene) {
      runs.back().emplace_back();
      if (known(fidelity, shares) || !needs(fidelity, scene)) continue;
      for (int seed = 0; seed < fidelity.seeds; ++seed) {
        RunRequest r = request(fidelity, scene, seed, shares);
        r.may_be_refused = !must_be_read;
        runs.back().back().push_back(store_.add(r));
        all.push_back(runs.back().back().back());
        if (!in_ledger(scene, all.back())) asked.push_back(all.back());
      }
    }
  }
  std::vector<std::size_t> left = store_.left(asked);
  if (looks_)  // one that has failed is done again by a search, but it has been seen to fail
    left.erase(std::remove_if(left.begin(), left.end(),
                              [&](std::size_t run) { return store_.end_of(run).status == "failed"; }),
               left.end());
  if (looks_ && !left.empty()) return false;
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
  if (!looks_) ledger_.write();
  return true;
}

const RunLedger::Entry* Evaluations::in_ledger(std::size_t scene, std::size_t run) const {
  return store_.is_done(run) ? nullptr : ledger_.find(spec_.scenes[scene].name, store_.portable_recipe(run));
}

Evaluation Evaluations::evaluation_of(const Fidelity& fidelity, const Shares& shares,
                                      const std::vector<std::vector<std::size_t>>& runs) {
  Evaluation e;
  e.shares = shares;
  std::vector<std::vector<RunNumbers>> numbers;
  for (std::size_t scene = 0; scene < runs.size(); ++scene) {
    numbers.emplace_back();
    bool failed = false;
    const std::string& name = spec_.scenes[scene].name;
    for (const std::size_t run : runs[scene]) {
      ++e.runs;
      if (const RunLedger::Entry* entry = in_ledger(scene, run)) {
        e.wall += entry->wall;
        e.cpu += entry->cpu;
        numbers.back().push_back(entry->numbers);
        continue;
      }
      const RunEnd end = store_.end_of(run);
      e.wall += end.cost.wall;
      e.cpu += end.cost.cpu;
      failed = failed || !end.done();
      // Whoever ended it, it says nothing about the set.
      if (end.code == kExitInterrupted || (end.code > 128 && spec_.time_limit == 0))
        throw PartnerError("the run " + end.folder + " was ended from outside (code " + std::to_string(end.code) +
                           "); the same command goes on");
      if (!end.done()) {
        e.message = name + ": " + (end.message.empty() ? end.status : end.message);
        continue;
      }
      numbers.back().push_back(numbers_of(spec_, name, end.folder));
      ledger_.note(name, store_.portable_recipe(run),
                   {store_.request(run).name, numbers.back().back(), end.cost.wall, end.cost.cpu});
    }
    if (failed) numbers.back().clear();
  }
  for (std::size_t t = 0; t < spec_.targets.size(); ++t) {
    e.targets.push_back(result_of(spec_, t, numbers));
    if (fidelity.asks(t)) e.misfit += e.targets.back().misfit(spec_.targets[t], fidelity.alone ? 0.0 : spec_.cap);
  }
  return e;
}

}  // namespace footfall

#pragma once
// Sets of parameters and what their runs say. All runs stand in one store (experiments/run_store.h): one that is
// finished is never done again, whoever asks for it. Nor is one that stands in the ledger (run_ledger.h), which gets a
// line from every run that ends well.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/cli/calibrate/misfit.h"
#include "mbd_solver/cli/calibrate/run_ledger.h"
#include "mbd_solver/cli/experiments/run_store.h"

namespace footfall {

// How a set is run: a stage's cheaper settings, or none; how many of the seeds; and for which targets.
struct Fidelity {
  std::vector<std::string> settings;
  double until = 0.0;  // [s]; 0: not changed
  int seeds = 1;
  std::optional<std::size_t> alone;  // for this target alone: other scenes are not run

  bool asks(std::size_t target) const { return !alone || *alone == target; }
};
Fidelity fidelity_of(const CalibrationSpec& spec, const StageSpec& stage);
Fidelity full_fidelity(const CalibrationSpec& spec);  // no stage's settings, all seeds

struct Evaluation {
  Shares shares;
  double misfit = 0.0;                // Phi, of the targets that were asked for
  std::vector<TargetResult> targets;  // as CalibrationSpec::targets; failed: those that were not asked for
  std::string message;                // of a run that failed
  double wall = 0.0, cpu = 0.0;       // of its runs, together [s]
  int runs = 0;
  double lasted = 0.0;  // of the whole round that it was run in, per run and job [s]; 0: done before

  int met() const;                                                   // number of targets
  std::vector<double> residuals(const CalibrationSpec& spec) const;  // sqrt(w) r, all after one another
};

class Evaluations {
 public:
  // `folder`: of the store; `ledger`: file of the ledger, empty: none.
  Evaluations(const CalibrationSpec& spec, const std::string& folder, const std::string& ledger = "")
      : spec_(spec), store_(folder, true), ledger_(spec, ledger) {}

  // Null when its runs are not done yet. The misfit of a set that breaks a constraint is kBroken (1 + by how much).
  const Evaluation* known(const Fidelity& fidelity, const Shares& shares);
  // Runs what is missing of the sets, at most `jobs` runs at once. False when it was interrupted. Throws InputError for
  // a scene that cannot be read, when `must_be_read`; else such a set has failed. Throws PartnerError when somebody
  // ended a run.
  bool carry_out(const Fidelity& fidelity, const std::vector<Shares>& sets, int jobs, bool must_be_read = false);
  // From now on nothing is run or written: carry_out() is false for a set of which a run is missing.
  void only_look() { looks_ = true; }
  bool looks() const { return looks_; }

  int most_ranks() const { return store_.most_ranks(); }
  int runs_done() const { return runs_done_; }      // by this process
  int runs_reused() const { return runs_reused_; }  // done before
  static constexpr double kBroken = 1e6;

  // "--set" of one scene's run at this set, without seeds.
  std::vector<std::string> settings(const Fidelity& fidelity, std::size_t scene, const Shares& shares) const;
  // The parameters that change the settings of the target's runs.
  std::vector<std::size_t> moved_by(const Fidelity& fidelity, std::size_t target) const;

 private:
  std::string key(const Fidelity& fidelity, const Shares& shares) const;
  bool needs(const Fidelity& fidelity, std::size_t scene) const;
  RunRequest request(const Fidelity& fidelity, std::size_t scene, int seed, const Shares& shares) const;
  Evaluation evaluation_of(const Fidelity& fidelity, const Shares& shares,
                           const std::vector<std::vector<std::size_t>>& runs);
  // What the ledger says of a run that the store does not have; null: nothing.
  const RunLedger::Entry* in_ledger(std::size_t scene, std::size_t run) const;

  const CalibrationSpec& spec_;
  RunStore store_;
  RunLedger ledger_;
  std::map<std::string, Evaluation> known_;
  int runs_done_ = 0, runs_reused_ = 0;
  bool looks_ = false;
};

}  // namespace footfall

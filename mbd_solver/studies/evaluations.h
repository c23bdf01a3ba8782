#pragma once
// How far a set of parameters is from the targets.
//
//   Phi = sum over targets t, and rows k of curves, of w_t r_tk^2
//   r   = (y - value) / tolerance, or of a band the distance to it: (y - most)+ / tolerance - (least - y)+ / tolerance
//         in Phi at most CalibrationSpec::cap, and at least -cap, where there is one
//
// y is the mean over the seeds; of an ordering, the ratio of two means.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/run/output/history.h"
#include "mbd_solver/studies/calibration.h"
#include "mbd_solver/studies/run_store.h"

namespace footfall {

// Of one finished run, as far as targets ask.
struct RunNumbers {
  std::vector<double> figures;              // as CalibrationSpec::figures; NaN: not asked, or not there
  std::vector<std::vector<double>> curves;  // one per target: of curves, y at the file's x; else empty
};

struct TargetResult {
  std::vector<double> values;                // y: one, or of a curve one per row
  std::vector<double> spread;                // over the seeds, sample standard deviation; 0 for one seed
  std::vector<double> residuals;             // r
  std::vector<std::vector<double>> of_seed;  // y of every seed alone
  bool band = false;                         // wanted within bounds
  bool failed = false;                       // a run of it did not end; r is CalibrationSpec::failed

  double misfit(const TargetSpec& target, double cap = 0.0) const;  // its part of Phi
  bool is_met() const { return !failed && met(residuals, band); }
  // A number within one tolerance, a band kept, a curve within 1.5 tolerances (root mean square).
  static bool met(const std::vector<double>& residuals, bool band);
};

// `runs`: one per seed, for every scene; empty where one of them failed.
TargetResult result_of(const CalibrationSpec& spec, std::size_t target,
                       const std::vector<std::vector<RunNumbers>>& runs);

// What targets of `scene` ask of the run in `folder`. Throws InputError when it has no such column or key.
RunNumbers numbers_of(const CalibrationSpec& spec, const std::string& scene, const std::string& folder);

// y over x at the places `at`, from rows up to the largest x: at the first crossing, linearly. Before the first row and
// beyond the largest x the nearest row counts.
std::vector<double> first_crossings(const std::vector<double>& x, const std::vector<double>& y,
                                    const std::vector<double>& at);

// r as it counts in Phi.
double capped(double residual, double cap);
// r of one number.
double residual_of(const TargetSpec& target, double y);

// What finished runs of a calibration said, in one small file: a line of JSON for each run of a scene. Whoever has this
// file needs neither the runs' folders nor the hours: a run that stands in it is not done again, here or on another
// machine. An entry holds as long as the run would be made from the same (portable_recipe_of in
// experiments/run_store.h) and is asked the same.

class RunLedger {
 public:
  struct Entry {
    std::string run;  // name of its folder
    RunNumbers numbers;
    double wall = 0.0, cpu = 0.0;  // [s]
  };

  // Reads `file`, if it is there. Empty: nothing is read and nothing written. Throws InputError naming the line that
  // is no entry; the last one, when it is cut short, is left out.
  RunLedger(const CalibrationSpec& spec, std::string file);

  // Null when it is not there, or does not hold all that is asked.
  const Entry* find(const std::string& scene, const std::string& recipe) const;
  void note(const std::string& scene, const std::string& recipe, const Entry& entry);
  void write();  // when something is new

 private:
  std::string asked_of(const std::string& scene) const;  // a fingerprint

  const CalibrationSpec& spec_;
  std::string file_;
  std::map<std::pair<std::string, std::string>, Entry> entries_;  // by scene and recipe
  std::map<std::string, std::string> asked_;                      // by scene
  std::string other_lines_;                                       // of other questions: kept as they are
  bool changed_ = false;
};

// Sets of parameters and what their runs say. All runs stand in one store (experiments/run_store.h): one that is
// finished is never done again, whoever asks for it. Nor is one that stands in the ledger (run_ledger.h), which gets a
// line from every run that ends well.

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

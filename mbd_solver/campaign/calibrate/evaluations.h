#pragma once
// Sets of parameters, their runs, and how far they are from the targets:
//
//   Phi = sum over targets t, and rows k of curves, of w_t r_tk^2
//   r   = (y - value) / tolerance, of a band (y - most)+ / tolerance - (least - y)+ / tolerance; in Phi limited to
//         +-CalibrationSpec::cap, if there is one
//
// y is the mean over the seeds, or the ratio or difference of two means (TargetSpec::against).

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "mbd_solver/studies/calibration.h"
#include "mbd_solver/studies/run_store.h"

namespace footfall {

// Results of one finished run that targets require. A number that the run does not have is not in it.
struct RunNumbers {
  std::map<std::string, double> metrics;              // by the metric's name
  std::map<std::string, std::vector<double>> curves;  // y at the file's x, by the target's name
};

struct TargetResult {
  std::vector<double> values;            // y: one, of a curve one per row
  std::vector<double> spread;            // over the seeds, sample standard deviation; 0 for one seed
  std::vector<double> residuals;         // r
  std::size_t seeds = 0, seeds_met = 0;  // seeds_met: that meet the target by themselves
  bool band = false;                     // the target is a band
  bool failed = false;                   // a run has failed; r is CalibrationSpec::failed

  double misfit(const TargetSpec& target, double cap = 0.0) const;  // its part of Phi
  double distance() const;                                          // root mean square of r [tolerances]
  // A number within one tolerance, a band with r = 0, a curve within 1.5 tolerances.
  bool is_met() const;
};

// `runs`: by scene, one per seed; empty if one of them failed.
TargetResult result_of(const CalibrationSpec& spec, std::size_t target,
                       const std::vector<std::vector<RunNumbers>>& runs);

// Results of the run in `folder` for the targets of `scene`. Throws InputError when it lacks a column or number.
RunNumbers numbers_of(const CalibrationSpec& spec, const std::string& scene, const std::string& folder);

// y over x at the positions of `at`, from rows up to the largest x: at the first crossing, linearly; before the first row and
// beyond the largest x the nearest row.
std::vector<double> first_crossings(const std::vector<double>& x, const std::vector<double>& y,
                                    const std::vector<double>& at);

double capped(double residual, double cap);                                            // r as it counts in Phi
double residual_of(const TargetSpec& target, double y, std::size_t row_of_curve = 0);  // r of one number

// Results of finished runs in one small file, a line of JSON for each run of a scene: a run in it is not repeated, here or
// on another machine, and its folder is not needed. An entry is valid as long as the run's inputs (portable_recipe_of) and
// the requirements of the targets are unchanged; other entries remain stored.
class RunRecords {
 public:
  struct Entry {
    std::string run;  // name of its folder
    RunNumbers numbers;
    double wall = 0.0, cpu = 0.0;  // [s]
  };

  // Reads `file`, if it exists; empty: neither reads nor writes. Throws InputError for a line that is no entry, unless it
  // is an incomplete last one.
  RunRecords(const CalibrationSpec& spec, std::string file);

  // Null: none.
  const Entry* find(const std::string& scene, const std::string& recipe) const;
  void add(const std::string& scene, const std::string& recipe, const Entry& entry);
  void write();  // if something is new

 private:
  std::string file_;
  std::map<std::string, std::string> requirements_;                             // of each scene, a fingerprint
  std::map<std::tuple<std::string, std::string, std::string>, Entry> entries_;  // by scene, recipe, requirements
  bool changed_ = false;
};

// How a set is run: settings of a stage, number of seeds, and targets.
struct Fidelity {
  std::vector<std::string> settings;
  double until = 0.0;  // [s]; 0: unchanged
  int seeds = 1;
  std::optional<std::size_t> single_target;  // only for this target: other scenes are not run
};
Fidelity fidelity_of(const CalibrationSpec& spec, const StageSpec& stage);
Fidelity full_fidelity(const CalibrationSpec& spec);  // without settings of a stage, all seeds

struct EvaluatedPoint {
  UnitPoint point;
  double misfit = 0.0;                // Phi, of the required targets
  std::vector<TargetResult> targets;  // as CalibrationSpec::targets; others count as failed
  std::string message;                // of a run that failed
  int runs = 0;
  double lasted = 0.0;  // wall time of a run; with the overhead of the pool if it was carried out now [s]

  int met() const;                                                   // number of targets
  std::vector<double> residuals(const CalibrationSpec& spec) const;  // sqrt(w) r of all targets
};

using Sets = std::vector<const EvaluatedPoint*>;

class Evaluations {
 public:
  // `folder`: of the store; `records`: file of RunRecords; `jobs`: runs at once, 0: as many as the cores allow. read_only:
  // nothing is run or written, and carry_out() is false for a set with a missing run.
  Evaluations(const CalibrationSpec& spec, const std::string& folder, const std::string& records, int jobs,
              bool read_only)
      : spec_(spec), store_(folder, true), records_(spec, records), jobs_(jobs), read_only_(read_only) {}

  // Null if its runs are not done yet. The misfit of a set that violates a constraint is kViolated (1 + violation).
  const EvaluatedPoint* known(const Fidelity& fidelity, const UnitPoint& point);
  // Carries out the missing runs of the sets. False when interrupted. A scene that cannot be read is an InputError if
  // `must_be_read`; otherwise the set has failed. Throws PartnerError when a run was ended from outside.
  bool carry_out(const Fidelity& fidelity, const std::vector<UnitPoint>& sets, bool must_be_read = false);
  static constexpr double kViolated = 1e6;

  bool is_read_only() const { return read_only_; }
  int jobs() const { return store_.at_once(jobs_); }
  int runs_done() const { return runs_done_; }      // in this process
  int runs_reused() const { return runs_reused_; }  // done before

  // --set of one scene's run at this set, without seeds.
  std::vector<std::string> settings(const Fidelity& fidelity, std::size_t scene, const UnitPoint& point) const;
  // The parameters that affect the settings of the target's runs.
  std::vector<std::size_t> moved_by(const Fidelity& fidelity, std::size_t target) const;

 private:
  struct Planned {
    std::size_t scene, run;  // run: number in the store
  };
  std::string key(const Fidelity& fidelity, const UnitPoint& point) const;
  RunRequest request(const Fidelity& fidelity, std::size_t scene, int seed, const UnitPoint& point) const;
  const RunRecords::Entry* record(const Planned& planned) const;  // null: none
  EvaluatedPoint evaluation_of(const Fidelity& fidelity, const UnitPoint& point, const std::vector<Planned>& runs);

  const CalibrationSpec& spec_;
  RunStore store_;
  RunRecords records_;
  int jobs_;
  bool read_only_;
  std::map<std::string, EvaluatedPoint> known_;
  int runs_done_ = 0, runs_reused_ = 0;
};

}  // namespace footfall

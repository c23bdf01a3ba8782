#pragma once
// A whole calibration: the runs of the start, the stages, differences about the best set, confirmation; and its command.

#include <string>
#include <vector>

#include "mbd_solver/campaign/calibrate/determination.h"
#include "mbd_solver/campaign/calibrate/evaluations.h"
#include "mbd_solver/campaign/calibrate/search.h"
#include "mbd_solver/studies/sweep_command.h"

namespace footfall {

struct StageOutcome {
  SearchPath path;    // complete
  Sets evaluations;   // of path.sets
  double best = 0.0;  // misfit of the stage's best set, or of its start
};

// The search for a target that no set met, without regard to the others.
struct SingleTarget {
  std::size_t target = 0;
  std::size_t sets = 0;                     // that were tried
  const EvaluatedPoint* nearest = nullptr;  // of all sets
};

struct CalibrationOutcome {
  const EvaluatedPoint* start = nullptr;      // with the runs of the last stage
  const EvaluatedPoint* best = nullptr;       // likewise
  const EvaluatedPoint* confirmed = nullptr;  // with whole runs: no settings of a stage, all seeds
  std::size_t confirmations = 0;              // number of sets run whole; `confirmed` is the best of them
  std::vector<StageOutcome> stages;
  Sets around;  // difference_sets
  Determination determination;
  std::vector<SingleTarget> single_targets;
};

class CalibrationRun {
 public:
  CalibrationRun(const CalibrationSpec& spec, Evaluations& evaluations) : spec_(spec), evaluations_(evaluations) {}

  // The start, with the runs of every stage and of the confirmation. False when interrupted. Throws NumericalError when a run
  // fails.
  bool start();
  // After start(): sets, runs and hours that remain, in all and by part.
  std::vector<std::string> prediction() const;
  // Everything else. False when interrupted; the current stage is then the last of the outcome.
  bool search();
  const CalibrationOutcome& outcome() const { return outcome_; }
  // Sets with the same runs as the latest stage: of that stage and earlier ones, and those about the best set.
  Sets comparable() const;

 private:
  bool run_stage(const StageSpec& stage, UnitPoint& at);
  // The search by the method of the stage, with the runs that it requests. False when interrupted.
  bool carry_out_search(const StageSpec& stage, const Fidelity& fidelity, const UnitPoint& start, const Sets& earlier,
                        SearchPath& path);
  SurrogateQueries surrogate_queries(const Fidelity& fidelity, const UnitPoint& start, const Sets& earlier);
  bool confirm(UnitPoint at);
  bool seek_single_targets();
  void print_progress(const std::string& text) const;
  Sets sets_like(const StageSpec& stage) const;  // of stages with the same runs

  const CalibrationSpec& spec_;
  Evaluations& evaluations_;
  CalibrationOutcome outcome_;
};

// footfall calibrate FILE: the parameters with which runs meet targets, how well the targets determine them, and which
// targets exclude each other. The same command resumes an interrupted calibration.
struct CalibrateArguments : SweepArguments {
  CalibrateArguments() { command = "calibrate", runs = "runs/calibrations"; }
  bool estimate = false;  // only the runs of the start, and an estimate of the time of all
  bool so_far = false;    // no runs: print the results so far
};

// Returns the exit code: 0; 3 when interrupted. Throws InputError, NumericalError.
int calibrate_command(const CalibrateArguments& arguments);

}  // namespace footfall

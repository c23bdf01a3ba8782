#pragma once
// A whole calibration: the runs of the start, the stages, differences about the best set, confirmation; and its command.

#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/studies/calibrate/determination.h"
#include "mbd_solver/studies/calibrate/evaluations.h"
#include "mbd_solver/studies/calibrate/search.h"
#include "mbd_solver/studies/calibrate/surrogate.h"

namespace footfall {

struct StageTask {
  const CalibrationSpec& spec;
  Evaluations& evaluations;
  Fidelity fidelity;
  const StageSpec& stage;
  UnitPoint start;                 // its runs are done
  std::vector<UnitPoint> earlier;  // sets of earlier stages with the same fidelity
  int jobs;
  double spent;  // by earlier stages, of one core [s]; counts for limits.hours
};

// The search of one stage by its method, on the evaluations of a calibration.
class StageSearch {
 public:
  explicit StageSearch(const StageTask& task);
  StageSearch(const StageSearch&) = delete;  // its queries refer to it
  StageSearch& operator=(const StageSearch&) = delete;

  // As far as sets are known; the requested ones are to be run before the next call.
  SearchPath go();

 private:
  bool may_continue() const;
  const Evaluation* look_up(const UnitPoint& set);  // and adds its cost
  SurrogateQueries surrogate_queries();

  const StageTask task_;
  double spent_;
  SearchQueries queries_;
  std::optional<SurrogateSearch> surrogate_;
};

struct StageOutcome {
  SearchPath path;                             // complete
  std::vector<const Evaluation*> evaluations;  // of path.sets
  double best = 0.0;                           // misfit of the stage's best set, or of its start
};

// The search for a target that no set met, without regard to the others.
struct SingleTarget {
  std::size_t target = 0;
  std::size_t before = 0, sets = 0;  // number of sets known before, and tried
  double nearest_before = 0.0;       // [tolerances]
  const Evaluation* nearest = nullptr;
  std::vector<std::size_t> moved_by;  // parameters that affect the target
};

struct CalibrationOutcome {
  const Evaluation* start = nullptr;      // with the runs of the last stage
  const Evaluation* best = nullptr;       // likewise
  const Evaluation* confirmed = nullptr;  // with whole runs: no settings of a stage, all seeds
  int confirmations = 0;                  // number of sets run whole; `confirmed` is the best of them
  std::vector<StageOutcome> stages;
  std::vector<const Evaluation*> around;  // difference_sets
  Determination determination;
  std::vector<TradeOff> trade_offs;
  std::vector<SingleTarget> single_targets;
  double predicted = 0.0, taken = 0.0;  // [h]
  bool whole_time = true;               // hardly any run was done before: predicted and taken are comparable
};

// Time after the runs of the start [h].
struct Prediction {
  double hours = 0.0;
  int sets = 0, runs = 0;
  std::vector<std::string> lines;  // by part
};

class CalibrationRun {
 public:
  CalibrationRun(const CalibrationSpec& spec, Evaluations& evaluations, int jobs)
      : spec_(spec), evaluations_(evaluations), jobs_(jobs) {}

  // The start, with the runs of every stage and of the confirmation. False when interrupted. Throws NumericalError when a run
  // fails.
  bool start();
  Prediction predict() const;  // after start()
  // Everything else. False when interrupted; the current stage is then the last of the outcome.
  bool search();
  const CalibrationOutcome& outcome() const { return outcome_; }
  // Sets with the same runs as the latest stage: of that stage and earlier ones, and those about the best set.
  std::vector<const Evaluation*> comparable() const;

 private:
  bool run_stage(const StageSpec& stage, UnitPoint& at);
  bool confirm(UnitPoint at);
  bool seek_single_targets();
  void print_progress(const std::string& text) const;
  // Sets of finished stages with the same runs as this one.
  std::vector<UnitPoint> sets_with_runs_of(const StageSpec& stage) const;

  const CalibrationSpec& spec_;
  Evaluations& evaluations_;
  int jobs_;
  int runs_ = 0;        // of the stages so far
  double spent_ = 0.0;  // by them, of one core [s]
  CalibrationOutcome outcome_;
};

// footfall calibrate FILE: the parameters with which runs meet targets, how well the targets determine them, and trade-offs
// between targets. The folder of results holds NAME.md, report.html, way.csv, best.txt, pictures, and the runs; the same
// command resumes an interrupted calibration.
struct CalibrateArguments {
  std::string file;
  std::string out;        // empty: runs/calibrations/NAME
  std::string table;      // also write the page to this file; empty: no
  int jobs = 0;           // runs at once; 0: as many as the cores allow
  bool estimate = false;  // only the runs of the start, and an estimate of the time of all
  bool so_far = false;    // no runs: print the results so far
};

// Returns the exit code: 0; 3 when interrupted. Throws InputError, NumericalError.
int calibrate_command(const CalibrateArguments& arguments);

}  // namespace footfall

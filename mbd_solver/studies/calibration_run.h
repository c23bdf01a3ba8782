#pragma once
// The search of one stage, whichever its method, with the answers of a calibration's sets.

#include <optional>

#include "mbd_solver/studies/determination.h"
#include "mbd_solver/studies/evaluations.h"
#include "mbd_solver/studies/search.h"
#include "mbd_solver/studies/surrogate.h"

namespace footfall {

struct StageTask {
  const CalibrationSpec& spec;
  Evaluations& evaluations;
  Fidelity fidelity;
  const StageSpec& stage;
  Shares start;                 // its runs are done
  std::vector<Shares> earlier;  // sets with the same fidelity that stages before have run
  int jobs;
  double spent;  // by stages before [s of one core]: limits.hours counts it
};

class StageSearch {
 public:
  explicit StageSearch(const StageTask& task);
  StageSearch(const StageSearch&) = delete;  // its questions point to it
  StageSearch& operator=(const StageSearch&) = delete;

  // As far as sets are known; those that are wanted next are to be run before it is called again.
  StageWay go();

 private:
  bool may_go_on() const;
  const Evaluation* look_up(const Shares& set);  // and counts what it cost
  SurrogateQuestions surrogate_questions();

  const StageTask task_;
  double spent_;
  SearchQuestions questions_;
  LeastSquaresQuestions squares_;
  std::optional<SurrogateSearch> surrogate_;
};

// A whole calibration: start, stages, differences about the best set, confirmation. What came out of it, for the page.

struct StageOutcome {
  StageWay way;                                // complete
  std::vector<const Evaluation*> evaluations;  // of way.sets
  double best = 0.0;                           // misfit, of the stage's best or its start
};

// A target that no set met, sought with no regard to the others.
struct Alone {
  std::size_t target = 0;
  std::size_t before = 0, sets = 0;  // so many sets were known, so many more were tried
  double nearest_before = 0.0;       // [tolerances]
  const Evaluation* nearest = nullptr;
  std::vector<std::size_t> moved_by;  // parameters that can move the target
};

struct CalibrationOutcome {
  const Evaluation* start = nullptr;      // as the last stage runs it
  const Evaluation* best = nullptr;       // likewise
  const Evaluation* confirmed = nullptr;  // with no stage's settings, all seeds
  int confirmations = 0;                  // sets that were run so; the best of them is the one above
  std::vector<StageOutcome> stages;
  std::vector<const Evaluation*> around;  // difference_sets
  Determination determination;
  std::vector<Pull> pulls;
  std::vector<Alone> alone;
  double predicted = 0.0, taken = 0.0;  // [h]
  bool whole_time = true;               // no run was done before: predicted and taken can be compared
};

// The time that is left after the start's runs, of which `jobs` go side by side [h]; and what is said about it.
struct Prediction {
  double hours = 0.0;
  int sets = 0, runs = 0;
  std::vector<std::string> lines;  // how the hours split
};

class CalibrationRun {
 public:
  CalibrationRun(const CalibrationSpec& spec, Evaluations& evaluations, int jobs)
      : spec_(spec), evaluations_(evaluations), jobs_(jobs) {}

  // The start, as every stage and the confirmation run it. False when interrupted. Throws NumericalError when it fails.
  bool start();
  Prediction predict() const;  // after start()
  // All the rest. False when interrupted; the stage that was under way is then the last of the outcome.
  bool search();
  const CalibrationOutcome& outcome() const { return outcome_; }
  // The sets of the last stage that was reached, of stages before it with the same runs, and those about the best: what is
  // known of which targets go together.
  std::vector<const Evaluation*> comparable() const;

 private:
  bool walk_stage(const StageSpec& stage, Shares& at);
  bool confirm(Shares at);
  bool seek_alone();
  void say(const std::string& text) const;  // how far it is
  // Of stages that have ended and have the same runs.
  std::vector<Shares> sets_run_like(const StageSpec& stage) const;

  const CalibrationSpec& spec_;
  Evaluations& evaluations_;
  int jobs_;
  int runs_ = 0;        // of the search's ways so far
  double spent_ = 0.0;  // by them [s of one core]
  CalibrationOutcome outcome_;
};

}  // namespace footfall

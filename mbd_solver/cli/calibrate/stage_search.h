#pragma once
// The search of one stage, whichever its method, with the answers of a calibration's sets.

#include <optional>

#include "mbd_solver/cli/calibrate/evaluations.h"
#include "mbd_solver/cli/calibrate/gauss_newton.h"
#include "mbd_solver/cli/calibrate/surrogate.h"

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

}  // namespace footfall

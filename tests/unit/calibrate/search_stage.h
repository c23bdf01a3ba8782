#pragma once
// A stage of a calibration, for tests of searches.

#include "mbd_solver/studies/calibration.h"

namespace footfall {

inline StageSpec stage_of(SearchMethod method, int evaluations) {
  StageSpec stage;
  stage.method = method;
  stage.evaluations = evaluations;
  return stage;
}

}  // namespace footfall

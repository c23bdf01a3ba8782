#pragma once
// What the tests of the finite elements share: a steel, a member of a frame, and the texts of refusals.

#include "mbd_solver/fe/fe_model.h"
#include "tests/support/refused.h"

namespace footfall::test {

constexpr double kFeRoundOff = 1e-12;  // relative
inline const Material kSteel{7850.0, 207e9, 0.3};

inline BeamMember member(int first, int second, int section = 0) {
  BeamMember result;
  result.first = first;
  result.second = second;
  result.section = section;
  return result;
}

}  // namespace footfall::test

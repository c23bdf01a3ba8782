#pragma once
// What the tests of the finite elements share: a steel, a member of a frame, and the message of a refusal.

#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/fe/fe_model.h"

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

// The message of the InputError that a call throws.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "(accepted)";
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace footfall::test

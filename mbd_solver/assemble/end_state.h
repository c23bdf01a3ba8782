#pragma once
// The end of a run as a file, end_state.json in its folder, from which another scene starts: [initial] from. Everything is
// found by name. Not in it: controllers, signals and states of the scene, prints in a soil without grains, and the time.

#include <map>
#include <string>

#include "mbd_solver/assemble/mechanism.h"

namespace footfall {

inline constexpr const char* kEndStateFile = "end_state.json";

struct EndState {
  struct BodyEnd {
    Eigen::VectorXd q, v;  // [r; L; a], [dr; w; da]
  };
  double time = 0.0;    // [s]
  Placement placement;  // of D at the start of that run
  std::map<std::string, BodyEnd> bodies;
  std::map<std::string, Eigen::VectorXd> elements;  // inner states: crushed honeycombs, turns, friction
  std::map<std::string, double> angles;             // of joints that count turns [rad]
};

// Throws InputError when the file cannot be written.
void write_end_state(const std::string& folder, const EndState& end);
// Reads initial.from. Throws InputError at that key.
EndState read_end_state(const Scene& scene);
// Throws InputError at initial.from.
[[noreturn]] void refuse_end_state(const Scene& scene, const std::string& what);

}  // namespace footfall

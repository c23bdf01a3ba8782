// How near a state is to a singular position.
#include <limits>

#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/workspace.h"

namespace footfall {

double Equations::log_determinant(const State& state) {
  load(state);
  return factor_saddle(state) ? work_->saddle_lu->log_determinant() : -std::numeric_limits<double>::infinity();
}

}  // namespace footfall

// An event ends a step of the mechanism at its instant: found by a step to the end, from whose beginning it is done again.

#include "mbd_solver/fmi/model/stepped_model.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/run/codes.h"

namespace footfall {

double SteppedModel::value(const std::string& column) const {
  const auto found = std::find(names().begin(), names().end(), column);
  if (found == names().end())
    throw InputError(code::kNoSuchColumn,
                     "there is no column \"" + column + "\"." + known_names("columns", column, names()));
  return row()[found - names().begin()];
}

bool MechanismModel::step(double until, bool early) {
  const bool has_states = std::find(names().begin(), names().end(), "state.since") != names().end();
  if (!early || !has_states) {
    simulation_.step_to(until);
    return false;
  }
  const auto last_event = [&] { return simulation_.time() - value("state.since"); };
  const double begin = simulation_.time(), before = last_event();
  const std::string saved = simulation_.save();
  simulation_.step_to(until);
  const double event = last_event();
  if (!(event > before + 1e-9 && event > begin && event < until * (1.0 - 1e-9))) return false;
  simulation_.restore(saved);
  simulation_.step_to(event);
  return true;
}

}  // namespace footfall

// One number has one name on screen, in files and on pages: sinkage, and coupling energy error.

#include "mbd_solver/session/output/former_names.h"

#include <array>
#include <utility>

namespace footfall {

const std::string& present_name(const std::string& name) {
  static const std::array<std::pair<std::string, std::string>, 4> names = {
      {{"max_penetration_m", "max_sinkage_m"},
       {"max_penetration_time_s", "max_sinkage_time_s"},
       {"coupling_energy_residual_relative", "coupling_energy_error_relative"},
       {"coupling.energy_residual", "coupling.energy_error"}}};
  for (const auto& [former, present] : names)
    if (name == former) return present;
  return name;
}

}  // namespace footfall

#pragma once
// Units of scene numbers: SI without a suffix, others by the suffix of the key (angle_deg, diameter_mm), converted by the
// reader.

#include <string>
#include <vector>

#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

struct UnitSuffix {
  std::string suffix;  // "_mm"
  double factor;       // SI value = factor * written value
};

// Name of the SI unit: "m", "Pa"; empty for numbers without a unit.
const char* unit_name(Unit unit);
// The suffixes allowed for this unit; does not contain the empty one.
const std::vector<UnitSuffix>& unit_suffixes(Unit unit);

}  // namespace footfall

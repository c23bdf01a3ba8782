#pragma once
// From a tree of values to structs. Units of numbers: SI without a suffix, others by the suffix of the key (angle_deg,
// diameter_mm), converted here.

#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"
#include "mbd_solver/scene/toml_file.h"

namespace footfall {

struct UnitSuffix {
  std::string suffix;  // "_mm"
  double factor;       // SI value = factor * written value
};

// Name of the SI unit: "m", "Pa"; empty for numbers without a unit.
const char* unit_name(Unit unit);
// The suffixes allowed for this unit; does not contain the empty one.
const std::vector<UnitSuffix>& unit_suffixes(Unit unit);

// "is the number 5, expected a table [E0104 wrong-type]".
std::string is_expected(const ConfigNode& node, const std::string& expected);

// Tree of values -> Scene, by the description of the keys (field_visitor.h). Wrong types, units and ranges, missing and
// unknown keys become findings; the scene then keeps its default.
void read_fields(const ConfigNode& root, Scene& scene, Findings& findings);
// Any file whose keys are described; the files that it names are relative to `folder`.
void read_fields(const ConfigNode& root, const std::string& folder, const std::function<void(FieldVisitor&)>& describe,
                 Findings& findings);

// Two columns of a text file (mbd_solver/base/csv.h; commas, semicolons or blanks); the first line may name them.
std::vector<Eigen::Vector2d> read_two_columns(const std::string& file);

}  // namespace footfall

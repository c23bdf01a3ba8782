#pragma once
// Tree of values -> Scene, by the description of the keys (field_visitor.h). Wrong types, units and ranges, missing and
// unknown keys become findings; the scene then keeps its default.

#include <functional>

#include "mbd_solver/scene/config_node.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

class FieldVisitor;

void read_fields(const ConfigNode& root, Scene& scene, Findings& findings);
// Any file whose keys are described; the files that it names are relative to `folder`.
void read_fields(const ConfigNode& root, const std::string& folder, const std::function<void(FieldVisitor&)>& describe,
                 Findings& findings);

// Two columns of a text file (mbd_solver/base/csv.h; commas, semicolons or blanks); the first line may name them.
std::vector<Eigen::Vector2d> read_two_columns(const std::string& file);

}  // namespace footfall

#pragma once
// Tree of values -> Scene, by the description of the keys (field_visitor.h). Wrong types, units and ranges, missing and
// unknown keys become findings; the scene keeps its defaults there.

#include <functional>

#include "mbd_solver/scene/config_node.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

class FieldVisitor;

void read_fields(const ConfigNode& root, Scene& scene, Findings& findings);
// Any file with a description of its keys; files that it names are seen from `folder`.
void read_fields(const ConfigNode& root, const std::string& folder, const std::function<void(FieldVisitor&)>& describe,
                 Findings& findings);

// Two columns of a CSV file (comma, semicolon or blanks; # comments). Throws InputError "file:line: ...".
std::vector<Eigen::Vector2d> read_two_columns(const std::string& file);

}  // namespace footfall

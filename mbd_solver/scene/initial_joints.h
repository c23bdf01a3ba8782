#pragma once
// knee = 0.3 in [initial.joints]: the one coordinate of a joint, short for [initial.joints.knee] angle = 0.3.

#include "mbd_solver/scene/config_node.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {

// Makes tables of the numbers. Values that no joint accepts are reported and dropped.
void expand_initial_joints(ConfigNode& root, Findings& findings);

}  // namespace footfall

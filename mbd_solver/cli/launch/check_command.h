#pragma once
// footfall check, and the check that starts every run.

#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"

namespace footfall {

// Reads the scene and builds its mechanism once, so that everything a run would refuse (meshes, bases, controllers) is
// found now.
// Warnings go to standard error. Throws InputError.
Scene checked_scene(const std::string& argument, const std::vector<std::string>& settings);

// Prints what the scene holds. Returns the exit code. Throws InputError with every finding.
int check_command(const std::string& argument, const std::vector<std::string>& settings);

}  // namespace footfall

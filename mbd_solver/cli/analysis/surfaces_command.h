#pragma once
// footfall surfaces: the fuzzy controllers of a scene as pictures.

#include <string>
#include <vector>

namespace footfall {

// Of every fuzzy controller the first and the third output over (a, da) and (a, alpha), the other inputs zero, as in
// [Lin25 Figure 4]; of one with fewer outputs, the first. Returns the exit code. Throws InputError; also when the scene
// has no fuzzy controller.
int surfaces_command(const std::string& scene, const std::vector<std::string>& settings, const std::string& out);

}  // namespace footfall

#pragma once
// Files that a user names, and those that are meant.

#include <string>

namespace footfall {

// '. Did you mean "examples/02_wheel"?' for a path of which one part is misspelt; empty where nothing is near.
std::string meant_path(const std::string& path);

// Throws InputError where there is no such file, or a folder; expected: "an experiment (TOML), as in inputs/sweeps".
void demand_file(const std::string& path, const std::string& expected);

}  // namespace footfall

#pragma once
// Files that a user names: the nearest existing path for a misspelt one.

#include <string>

namespace footfall {

// '. Did you mean "examples/02_wheel"?' for a path of which one part is misspelt; empty where no name is near.
std::string suggested_path(const std::string& path);

// Throws InputError when there is no such file, or a folder. expected: "an experiment (TOML), as in inputs/sweeps".
void require_file(const std::string& path, const std::string& expected);

}  // namespace footfall

#pragma once
// Files that are shipped with the program: inputs, examples, scripts of beds. An installed program finds them next to itself,
// one in a build folder in the checkout that it was built from. Nothing is written there.

#include <string>
#include <vector>

namespace footfall {

// The file or folder as a path: "inputs/landing_mr" is PREFIX/share/footfall/inputs/landing_mr of a program
// PREFIX/bin/NAME, or CHECKOUT/inputs/landing_mr. Throws InputError, naming both places, when it is in neither.
std::string shipped_file(const std::string& path);
// The names of the TOML files in a shipped folder, without their ending and sorted.
std::vector<std::string> shipped_tables(const std::string& folder);

}  // namespace footfall

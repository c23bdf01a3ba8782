#pragma once
// What was meant by a name that nobody has.

#include <string>
#include <vector>

namespace footfall {

// The candidate nearest to `word` by edit distance, or empty when none is near.
std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates);
// ' Known bodies: a, b. Did you mean "b"?' for an unknown name; long lists are cut.
std::string known_names(const std::string& what, const std::string& word, const std::vector<std::string>& candidates);

}  // namespace footfall

#pragma once
// Words of a line of a LIGGGHTS script.

#include <string>
#include <vector>

namespace footfall {

// As LIGGGHTS splits a line: outside of quotes blanks separate words, and `#` begins a comment.
std::vector<std::string> script_words(const std::string& text);

}  // namespace footfall

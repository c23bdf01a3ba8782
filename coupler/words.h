#pragma once
// Numbers among the words of a LIGGGHTS command. Whoever asks says what is wrong.

#include <optional>
#include <string>

namespace footfall {

// Nothing unless the whole word is a whole number from `least` to `most`.
std::optional<int> whole_number(const std::string& word, int least, int most);

// Nothing unless the whole word is a number above zero.
std::optional<double> positive_number(const std::string& word);

}  // namespace footfall

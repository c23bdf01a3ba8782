#pragma once
// Texts of messages and tables: numbers, lists, and the nearest known name for an unknown name.

#include <optional>
#include <string>
#include <vector>

namespace footfall {

// --- Numbers to text.

// Appends the number as printf's "%.*g" does.
void append_number(std::string& text, double value, int digits);
// With this many significant digits and without trailing zeros: "1.5", "-900", "1e-06".
std::string number_text(double value, int digits = 6);
// With this many digits after the point: "0.50".
std::string fixed_text(double value, int decimals);
// 0.0123 -> "1.2 %", 0.997 -> "100 %", -1.5 -> "-150 %".
std::string share_text(double share);

// --- Text to numbers: words of a LIGGGHTS command. The caller reports the fault.

// Nothing unless the whole word is a whole number from `least` to `most`.
std::optional<int> whole_number(const std::string& word, int least, int most);
// Nothing unless the whole word is a number above zero.
std::optional<double> positive_number(const std::string& word);

// --- Lists and words.

// "a, b, c".
std::string joined(const std::vector<std::string>& texts, const std::string& between = ", ");
// The cells of a line; a separator at its end starts no further cell.
std::vector<std::string> split(const std::string& line, char separator);
// Without blanks, tabs and carriage returns at both ends.
std::string trimmed(const std::string& text);
// With escapes for control characters: a line end is "\\n", others are "\\x1b"; cut after 200 characters.
std::string visible(const std::string& text);
bool ends_with(const std::string& text, const std::string& end);
// Can be the name of a file or of a column: letters, digits, _ - . without a leading dot, at most kLongestName of them.
inline constexpr int kLongestName = 100;
bool is_plain_name(const std::string& text);

// --- Unknown names.

// The candidate nearest to `word` by edit distance; empty when none is near.
std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates);
// ' Known bodies: a, b. Did you mean "b"?' for an unknown name; long lists are cut.
std::string known_names(const std::string& what, const std::string& word, const std::vector<std::string>& candidates);

}  // namespace footfall

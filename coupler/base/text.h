#pragma once
// Numbers to text, and the few cuts and joins that messages and tables need.

#include <string>
#include <vector>

namespace footfall {

// Appends what printf's "%.*g" writes.
void append_number(std::string& text, double value, int digits);
// As a person writes it: so many significant digits, no trailing zeros ("1.5", "-900", "1e-06").
std::string number_text(double value, int digits = 6);
// So many digits behind the point: "0.50".
std::string fixed_text(double value, int decimals);
// 0.0123 -> "1.2 %", 0.997 -> "100 %", -1.5 -> "-150 %".
std::string share_text(double share);

// "a, b, c".
std::string joined(const std::vector<std::string>& texts, const std::string& between = ", ");
// The cells of a line; nothing stands behind a mark at its end.
std::vector<std::string> split(const std::string& line, char mark);
// May be the name of a file or of a column: letters, digits, _ - . without a dot in front, at most kLongestName of them.
inline constexpr int kLongestName = 100;
bool is_plain_name(const std::string& text);
bool ends_with(const std::string& text, const std::string& end);
// Without blanks, tabs and carriage returns at both ends.
std::string trimmed(const std::string& text);

}  // namespace footfall

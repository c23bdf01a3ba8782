#pragma once
// Numbers that are read and written alike in every locale of the program that uses this code. Others: text.h (number_text, fixed_text).

#include <string>

namespace footfall {

// As strtod in the locale "C": leading blanks, signs, hexadecimal numbers, inf and nan. rest: behind the number; may be null.
double read_number(const char* text, char** rest);
// All digits of a hexadecimal number, as printf's "%a" writes them in the locale "C".
std::string hexadecimal(double value);
// As std::to_string in the locale "C": six digits after the point.
std::string plain_text(double value);

}  // namespace footfall

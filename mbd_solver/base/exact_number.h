#pragma once
// Numbers with all their digits, between programs and in files that are read again.

#include <string>

namespace footfall {

std::string shortest_text(double value);       // the shortest text that is read as this number
double exact_number(const std::string& text);  // NaN: it is none

}  // namespace footfall

#pragma once
// Numbers in messages about times and settings of a script.

#include <string>

#include "coupler/base/text.h"

namespace footfall {

inline std::string ten_digits(double value) { return number_text(value, 10); }

}  // namespace footfall

#pragma once
// Numbers of tables, written in half the time of std::to_chars: a thousand rows of sixty numbers are a tenth of a short run.

namespace footfall {

inline constexpr int kLongestQuickNumber = 32;  // characters

// Writes what printf's "%.*g" writes to `out` (kLongestQuickNumber characters) and returns its end; null where double
// arithmetic is not sure of the last digit or the number is of an unusual size: |value| in [1e-11, 1e21), 1 to 12 digits.
char* write_quickly(char* out, double value, int digits);

}  // namespace footfall

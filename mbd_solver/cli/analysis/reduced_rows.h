#pragma once
// Long histories as a picture can show them: of every span of time that is narrower than a pixel the lowest and the
// highest value, so that no peak is lost.

#include <vector>

namespace footfall {

// Which rows stand for the time axis, two per span: first and last. All rows when there are few.
std::vector<std::size_t> rows_to_draw(const std::vector<double>& time, std::size_t spans);

// Values for these rows: the lowest and the highest of the span, in the order in which they come.
std::vector<double> drawn_values(const std::vector<double>& values, const std::vector<std::size_t>& rows);

}  // namespace footfall

#include "mbd_solver/cli/analysis/reduced_rows.h"

#include <algorithm>

namespace footfall {

std::vector<std::size_t> rows_to_draw(const std::vector<double>& time, std::size_t spans) {
  std::vector<std::size_t> rows;
  const std::size_t count = time.size();
  if (count <= 2 * spans) {
    for (std::size_t k = 0; k < count; ++k) rows.push_back(k);
    return rows;
  }
  const double start = time.front(), length = time.back() - time.front();
  const auto span_of = [&](std::size_t k) {
    const double share =
        length > 0.0 ? (time[k] - start) / length : static_cast<double>(k) / static_cast<double>(count);
    return std::min(spans - 1, static_cast<std::size_t>(std::max(0.0, share) * static_cast<double>(spans)));
  };
  for (std::size_t first = 0; first < count;) {
    std::size_t last = first;
    while (last + 1 < count && span_of(last + 1) == span_of(first)) ++last;
    rows.push_back(first);
    if (last > first) rows.push_back(last);
    first = last + 1;
  }
  return rows;
}

std::vector<double> drawn_values(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  std::vector<double> drawn;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // A pair of rows spans all between them; a row whose follower is the next row stands for itself.
    const bool pair = i + 1 < rows.size() && rows[i + 1] > rows[i] + 1;
    if (!pair) {
      drawn.push_back(values[rows[i]]);
      continue;
    }
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(rows[i]);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(rows[i + 1] + 1);
    const auto [low, high] = std::minmax_element(begin, end);
    drawn.push_back(low < high ? *low : *high);
    drawn.push_back(low < high ? *high : *low);
    ++i;
  }
  return drawn;
}

}  // namespace footfall

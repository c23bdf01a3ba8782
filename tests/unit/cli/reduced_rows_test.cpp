#include "mbd_solver/cli/analysis/reduced_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace footfall {
namespace {

TEST(ReducedRows, FewRowsStayAsTheyAre) {
  const std::vector<double> time = {0.0, 1.0, 2.0, 3.0}, values = {4.0, -1.0, 7.0, 2.0};
  const std::vector<std::size_t> rows = rows_to_draw(time, 2);
  EXPECT_EQ(rows, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(drawn_values(values, rows), values);
}

TEST(ReducedRows, NoPeakIsLost) {
  std::vector<double> time, values;
  for (int k = 0; k < 100000; ++k) {
    time.push_back(1e-3 * k);
    values.push_back(std::sin(0.01 * k));
  }
  values[31234] = 50.0;
  values[77777] = -60.0;
  const std::vector<std::size_t> rows = rows_to_draw(time, 500);
  EXPECT_LE(rows.size(), 1000u);
  EXPECT_EQ(rows.front(), 0u);
  EXPECT_EQ(rows.back(), time.size() - 1);
  const std::vector<double> drawn = drawn_values(values, rows);
  ASSERT_EQ(drawn.size(), rows.size());
  // Each pair is the lowest and the highest of its span, where its rows say.
  for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(rows[i]);
    const auto [low, high] = std::minmax_element(from, values.begin() + static_cast<std::ptrdiff_t>(rows[i + 1] + 1));
    EXPECT_EQ(std::min(drawn[i], drawn[i + 1]), *low);
    EXPECT_EQ(std::max(drawn[i], drawn[i + 1]), *high);
  }
  EXPECT_EQ(*std::max_element(drawn.begin(), drawn.end()), 50.0);
  EXPECT_EQ(*std::min_element(drawn.begin(), drawn.end()), -60.0);
}

// Rows come closer together where samples and windows end: spans of one row stand for themselves.
TEST(ReducedRows, SpansMayHoldOneRowOrMany) {
  const std::vector<double> time = {0.0, 0.1, 0.11, 0.12, 0.5, 0.9, 0.91, 1.0}, values = {1, 2, 9, 3, 4, 5, -6, 7};
  const std::vector<std::size_t> rows = rows_to_draw(time, 3);
  const std::vector<double> drawn = drawn_values(values, rows);
  ASSERT_EQ(drawn.size(), rows.size());
  EXPECT_EQ(*std::max_element(drawn.begin(), drawn.end()), 9.0);
  EXPECT_EQ(*std::min_element(drawn.begin(), drawn.end()), -6.0);
}

}  // namespace
}  // namespace footfall

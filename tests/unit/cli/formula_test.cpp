#include "mbd_solver/cli/analysis/formula.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

const History kHistory{{"a", "b", "c"}, {"m", "m", "m"}, {{3.0, 0.0}, {4.0, -1.0}, {12.0, 0.0}}};

TEST(Formula, SumsAndNorms) {
  const Formula sum{{{1.0, "a"}, {-2.0, "b"}}, 5.0, 0.5};
  EXPECT_EQ(sum.values(kHistory), (std::vector<double>{0.0, 3.5}));
  EXPECT_EQ(sum.gnuplot(), "(0.5*(5+column('a')-2*column('b')))");
  const Formula norm{{{1.0, "a"}, {1.0, "b"}, {1.0, "c"}}, 0.0, 2.0, true};
  EXPECT_EQ(norm.values(kHistory), (std::vector<double>{26.0, 2.0}));
  EXPECT_EQ(norm.gnuplot(), "(2*sqrt(column('a')**2+column('b')**2+column('c')**2))");
}

}  // namespace
}  // namespace footfall

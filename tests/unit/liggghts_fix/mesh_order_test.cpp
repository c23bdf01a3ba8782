#include "liggghts_fix/mesh_order.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace footfall {
namespace {

using Order = std::vector<int>;

TEST(MeshOrder, OfTheFirstRankStays) { EXPECT_EQ(order_after_restart(0, 3, 4), (Order{0, 1, 2})); }

TEST(MeshOrder, OfTheLastRankIsFilledFromItsEnd) {
  EXPECT_EQ(order_after_restart(2, 4, 0), (Order{3, 2, 0, 1}));
  EXPECT_EQ(order_after_restart(5, 3, 0), (Order{2, 1, 0}));
}

TEST(MeshOrder, HoldsEachElementOnce) {
  Order order = order_after_restart(7, 5, 3);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, (Order{0, 1, 2, 3, 4}));
  EXPECT_TRUE(order_after_restart(3, 0, 2).empty());
}

}  // namespace
}  // namespace footfall

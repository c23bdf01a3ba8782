// A slab of a bed that follows a body: which grains go, and where those come that are in the way.
#include "liggghts_fix/link/bed_exchange.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

// A row of grains of radius 0.01 m and 1 kg along x on a box of 1 m; the slab from 0 to 0.1 m, passed at 0.1 m.
SlabChange row() {
  SlabChange change;
  change.end = 0.1;
  change.room = 0.1;
  change.period = {1.0, 0.0};
  change.allowed_overlap = 0.1;
  for (int k = 0; k < 5; ++k) {
    const BedGrain grain = {1 + k, {0.01 + 0.02 * k, 0.0, 0.01}, 0.01, 1.0};
    change.in_slab.push_back(grain);
    change.coming.push_back(grain);
    change.beside.push_back({11 + k, {0.11 + 0.02 * k, 0.0, 0.01}, 0.01, 1.0});
  }
  return change;
}

TEST(BedExchange, TakesTheSlabWhereNothingIsInTheWay) {
  const BedExchange exchange = bed_exchange(row());
  EXPECT_EQ(exchange.removed, (std::vector<int>{1, 2, 3, 4, 5}));
  EXPECT_TRUE(exchange.lifted.empty());
}

// It comes to the middle of the room behind, at a height at which it touches the next grain there.
TEST(BedExchange, LaysAGrainThatWouldBePressedOnTopOfTheBed) {
  SlabChange change = row();
  change.beside[0].x.x() = 0.104;
  const BedExchange exchange = bed_exchange(change);
  EXPECT_EQ(exchange.removed.size(), 5u);
  ASSERT_EQ(exchange.lifted.count(11), 1u);
  EXPECT_NEAR(exchange.lifted.at(11).x(), 0.1 + 0.5 * (0.1 + 0.004), 1e-12);
  EXPECT_NEAR((exchange.lifted.at(11) - change.beside[2].x).norm(), 0.02, 2e-8);  // a millionth of a radius above it
}

// Across the side of a periodic box, and backwards.
TEST(BedExchange, SeesGrainsAcrossASide) {
  SlabChange change = row();
  change.way = -1;
  change.end = 0.0;
  for (BedGrain& grain : change.beside) grain.x.x() = 1.0 - 0.01 - 0.02 * (grain.tag - 11);
  change.beside[0].x.x() = 0.996;
  const BedExchange exchange = bed_exchange(change);
  EXPECT_EQ(exchange.removed.size(), 5u);
  ASSERT_EQ(exchange.lifted.count(11), 1u);
  EXPECT_NEAR(exchange.lifted.at(11).x(), 1.0 - 0.052, 1e-12);
  EXPECT_NEAR((exchange.lifted.at(11) - change.beside[2].x).norm(), 0.02, 2e-8);  // a millionth of a radius above it
}

// Two more are in the slab than come: one lies above, one is pushed in.
TEST(BedExchange, LaysBehindWhatWasPushedAcrossTheEnd) {
  SlabChange change = row();
  change.in_slab.push_back({6, {0.09, 0.0, 0.05}, 0.01, 1.0});
  change.in_slab.push_back({7, {0.07, 0.0, 0.03}, 0.01, 1.0});
  const BedExchange exchange = bed_exchange(change);
  EXPECT_EQ(exchange.removed, (std::vector<int>{1, 2, 3, 4, 5}));
  ASSERT_EQ(exchange.lifted.size(), 2u);
  EXPECT_NEAR(exchange.lifted.at(6).x(), 0.155, 1e-12);
  EXPECT_NEAR(exchange.lifted.at(7).x(), 0.165, 1e-12);
}

TEST(BedExchange, TakesFromBehindWhatWasPushedAlong) {
  SlabChange change = row();
  change.in_slab.pop_back();
  change.beside[2].x.z() = 0.03;
  EXPECT_EQ(bed_exchange(change).removed, (std::vector<int>{1, 2, 3, 4, 13}));
  change.excess = 1.0;  // one too many has gone before
  EXPECT_EQ(bed_exchange(change).removed, (std::vector<int>{1, 2, 3, 4}));
}

// Next to a body nothing is laid down: what would be pressed goes, what is missing is made up for later.
TEST(BedExchange, KeepsAwayFromABody) {
  SlabChange change = row();
  change.room = 0.01;
  change.beside[0].x.x() = 0.104;
  const BedExchange exchange = bed_exchange(change);
  EXPECT_EQ(exchange.removed, (std::vector<int>{1, 2, 3, 4, 5, 11}));
  EXPECT_TRUE(exchange.lifted.empty());
}

// To half of the lightest grain: of a heavy one and three light ones.
TEST(BedExchange, BalancesMassNotNumber) {
  SlabChange change = row();
  change.in_slab.push_back({6, {0.05, 0.0, 0.05}, 0.02, 2.0});
  change.in_slab.push_back({7, {0.07, 0.0, 0.03}, 0.005, 0.25});
  const BedExchange exchange = bed_exchange(change);
  ASSERT_EQ(exchange.lifted.size(), 2u);
  EXPECT_EQ(exchange.removed.size(), 5u);
}

}  // namespace
}  // namespace footfall

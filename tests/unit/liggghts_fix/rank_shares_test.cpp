#include "liggghts_fix/rank_shares.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/unit/coupler/message_content.h"

namespace footfall {
namespace {

using Names = std::vector<std::string>;

BodyLoad empty_load(int modes, std::size_t tangents) {
  BodyLoad load;
  load.mean = MeanLoad(modes);
  load.tangent.resize(tangents);
  return load;
}

BodyLoad random_load(unsigned seed) {
  test::Random random(seed);
  BodyLoad load;
  test::randomize(load, random, 2);
  return load;
}

TEST(RankShares, ShareOfTheOnlyRankIsTheLoad) {
  BodyLoad share = random_load(5), load = empty_load(2, share.tangent.size());
  share.max_overlap_over_radius = 0.03;
  share.max_patch_over_facet = 0.3;
  std::vector<double> row;
  append_share(share, row);
  EXPECT_EQ(row.size(), share_size(share));
  EXPECT_EQ(add_share(row.data(), load), row.data() + row.size());
  EXPECT_EQ(test::differences(share, load), Names());
}

// Every number of the row alone: it arrives twice as large from two ranks with the same share, but those of which the
// largest counts.
TEST(RankShares, RanksAddUpAndTheLargestOverlapCounts) {
  BodyLoad load = empty_load(2, 2);
  std::vector<double> row(share_size(load));
  std::iota(row.begin(), row.end(), 1.0);
  add_share(row.data(), load);
  const BodyLoad one = load;
  add_share(row.data(), load);
  EXPECT_EQ(load.max_overlap_over_radius, one.max_overlap_over_radius);
  EXPECT_EQ(load.max_patch_over_facet, one.max_patch_over_facet);
  std::vector<double> once, twice;
  append_share(one, once);
  append_share(load, twice);
  EXPECT_EQ(once, row);
  int doubled = 0;
  for (std::size_t i = 0; i < row.size(); ++i) doubled += twice[i] == 2.0 * row[i] ? 1 : 0;
  EXPECT_EQ(doubled, static_cast<int>(row.size()) - 2);
}

TEST(RankShares, EveryFieldOfTheLoadHasItsPlaceInTheRow) {
  BodyLoad load = random_load(6);
  std::vector<double> before;
  append_share(load, before);
  test::for_each_changed(load, [&](const std::string& path, const BodyLoad& changed) {
    std::vector<double> row;
    append_share(changed, row);
    EXPECT_NE(row, before) << path << " is not in the row";
  });
}

TEST(RankShares, ClearedLoadIsEmptyAndKeepsItsShape) {
  BodyLoad load = random_load(7);
  const std::size_t size = share_size(load);
  clear(load);
  EXPECT_EQ(share_size(load), size);
  EXPECT_EQ(test::differences(load, empty_load(2, 2)), Names());
}

}  // namespace
}  // namespace footfall

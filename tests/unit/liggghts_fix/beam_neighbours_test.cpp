// The list of near pairs misses no touch while grains and nodes move, and costs what it touches.
#include "liggghts_fix/beam_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/unit/liggghts_fix/random_beams.h"

namespace footfall {
namespace {

using test::random_chain;
using test::RandomBeams;

// Grains in the layout LIGGGHTS has: a pointer per grain.
struct Bed {
  std::vector<Eigen::Vector3d> x;
  std::vector<double> radius;
  std::vector<int> mask;
  std::vector<double*> rows;

  void add(const Eigen::Vector3d& place, double r, int groups = 1) {
    x.push_back(place);
    radius.push_back(r);
    mask.push_back(groups);
  }
  GrainView view() {
    rows.clear();
    for (Eigen::Vector3d& place : x) rows.push_back(place.data());
    return {static_cast<int>(x.size()), rows.data(), radius.data(), mask.data(), 1};
  }
};

// For each grain its gap to the chain, over all segments.
std::vector<double> all_gaps(const BeamChain& chain, const Bed& bed) {
  std::vector<double> gaps;
  for (std::size_t i = 0; i < bed.x.size(); ++i) {
    double gap = 1e300;
    for (int s = 0; s < chain.segment_count(); ++s) gap = std::min(gap, chain.touch(s, bed.x[i], bed.radius[i]).gap);
    gaps.push_back(gap);
  }
  return gaps;
}

// Every grain that touches is on the list exactly once, and with the same gap.
int expect_all_touches(const BeamChain& chain, const Bed& bed, const BeamNeighbours& list, double reach = 0.0) {
  const std::vector<double> gaps = all_gaps(chain, bed);
  std::vector<int> seen(bed.x.size(), 0);
  for (int k = 0; k < list.size(); ++k) {
    const std::size_t i = static_cast<std::size_t>(list.grain(k));
    ++seen[i];
    const BeamTouch touch = list.closest(chain, k, bed.x[i], bed.radius[i]);
    if (gaps[i] <= reach * bed.radius[i]) {
      EXPECT_EQ(touch.gap, gaps[i]);
    }
    EXPECT_GE(touch.gap, gaps[i]);
  }
  int touching = 0;
  for (std::size_t i = 0; i < bed.x.size(); ++i) {
    EXPECT_LE(seen[i], 1);
    const bool takes_part = (bed.mask[i] & 1) != 0;
    if (gaps[i] <= reach * bed.radius[i] && takes_part) {
      ++touching;
      EXPECT_EQ(seen[i], 1) << "grain " << i << " touches and is not on the list";
    }
    if (!takes_part) {
      EXPECT_EQ(seen[i], 0);
    }
  }
  return touching;
}

TEST(BeamNeighbours, ThousandSpheresAgainstFiftyBeamsAsByBruteForce) {
  RandomBeams random(11);
  Bed bed;
  for (int i = 0; i < 1000; ++i) bed.add(random.vector(1.0), random.between(0.05, 0.25), i % 7 == 0 ? 2 : 1);
  int touching = 0;
  for (int k = 0; k < 50; ++k) {
    const BeamChain chain(random_chain(random, 1 + k % 12), 0);
    const double reach = k % 3 == 0 ? 0.1 : 0.0;
    BeamNeighbours list(0.02, reach);
    list.grains_renumbered(bed.view());
    list.update(chain, bed.view());
    touching += expect_all_touches(chain, bed, list, reach);
  }
  EXPECT_GT(touching, 500);  // the comparison compared something
}

// LIGGGHTS makes new lists when a grain went skin/2 from its place of the last time. Between two such moments
// the grains here wander as far as they may, back and forth, while the chain turns, sways and moves through
// them.
TEST(BeamNeighbours, MovingBeamsAndGrainsMissNoTouch) {
  RandomBeams random(12);
  const double skin = 0.03;
  Bed bed;
  for (int i = 0; i < 400; ++i) bed.add(random.vector(1.0), random.between(0.02, 0.1));
  const ModalBoundary boundary = random_chain(random, 10);
  BeamChain chain(boundary, 0);
  BeamNeighbours list(skin);
  list.grains_renumbered(bed.view());
  std::vector<Eigen::Vector3d> home = bed.x;
  int touching = 0;
  for (int step = 0; step < 300; ++step) {
    if (step % 40 == 0) {
      home = bed.x;
      list.grains_renumbered(bed.view());
    }
    for (std::size_t i = 0; i < bed.x.size(); ++i) {
      const Eigen::Vector3d next = bed.x[i] + random.vector(0.008);
      if ((next - home[i]).norm() < 0.5 * skin) bed.x[i] = next;
    }
    for (int node = 0; node < chain.node_count(); ++node)
      chain.x().col(node) += Eigen::Vector3d(0.004, -0.002, 0.001 * node) + random.vector(0.001);
    list.update(chain, bed.view());
    touching += expect_all_touches(chain, bed, list);
    if (HasFailure()) FAIL() << "seed " << random.seed() << " step " << step;
  }
  EXPECT_GT(touching, 1000);
  EXPECT_LT(list.builds(), 200);  // lists lived for more than one step
}

TEST(BeamNeighbours, AChainAtRestKeepsItsList) {
  RandomBeams random(13);
  Bed bed;
  for (int i = 0; i < 100; ++i) bed.add(random.vector(1.0), 0.05);
  const BeamChain chain(random_chain(random, 5), 0);
  BeamNeighbours list(0.01);
  list.grains_renumbered(bed.view());
  for (int step = 0; step < 10; ++step) list.update(chain, bed.view());
  EXPECT_EQ(list.builds(), 1);
}

TEST(BeamNeighbours, AChainFarFromTheGrainsLooksAtNoGrain) {
  RandomBeams random(14);
  Bed bed;
  for (int i = 0; i < 1000; ++i) bed.add(random.vector(1.0), 0.05);
  BeamChain chain(random_chain(random, 20), 0);
  chain.x().row(2).array() += 20.0;
  BeamNeighbours list(0.01);
  list.grains_renumbered(bed.view());
  for (int step = 0; step < 100; ++step) {
    chain.x().row(2).array() -= 0.02;  // comes down, further than its skin every step, and stays above
    list.update(chain, bed.view());
  }
  EXPECT_EQ(list.builds(), 100);
  EXPECT_EQ(list.box_tests(), 0);
  EXPECT_EQ(list.size(), 0);
}

// Until some node has come nearer by the clearance, brute force finds no touch either.
TEST(BeamNeighbours, WithinItsClearanceAFarChainTouchesNothing) {
  RandomBeams random(17);
  Bed bed;
  for (int i = 0; i < 300; ++i) bed.add(random.vector(1.0), random.between(0.02, 0.1));
  BeamChain chain(random_chain(random, 8), 0);
  chain.x().row(0).array() += 1.0 - chain.x().row(0).minCoeff() + 0.5;  // half a metre beside the grains
  BeamNeighbours list(0.03);
  EXPECT_EQ(list.clearance(), 0.0);  // not known yet
  list.grains_renumbered(bed.view());
  EXPECT_TRUE(list.update(chain, bed.view()));
  const double clearance = list.clearance();
  EXPECT_GT(clearance, 0.2);
  EXPECT_LT(clearance, 0.5);
  chain.x().row(0).array() -= clearance;
  for (std::size_t i = 0; i < bed.x.size(); ++i)
    bed.x[i].x() += 0.015;  // as far as grains go before they are renumbered
  for (const double gap : all_gaps(chain, bed)) EXPECT_GT(gap, 0.0);
  list.grains_renumbered(bed.view());
  EXPECT_EQ(list.clearance(), 0.0);  // has to be found anew
  chain.x().row(0).array() -= 0.3;
  list.update(chain, bed.view());
  EXPECT_EQ(list.clearance(), 0.0);  // near
}

// Grains around one end of a beam of 32 and of 1024 segments of the same size: the same pairs, and a search
// that grows only with the depth of the tree of boxes.
TEST(BeamNeighbours, CostGrowsWithWhatIsTouchedNotWithTheNumberOfSegments) {
  RandomBeams random(15);
  Bed bed;
  for (int i = 0; i < 500; ++i) bed.add(random.vector(0.3), 0.03);
  const auto straight = [](int segments) {
    Eigen::Matrix3Xd nodes = Eigen::Matrix3Xd::Zero(3, segments + 1);
    std::vector<BeamSegment> list;
    for (int i = 1; i <= segments; ++i) {
      nodes(0, i) = 0.1 * i;
      list.push_back({i - 1, i, 0.05, 0});
    }
    return ModalBoundary("beam", nodes, {}, list);
  };
  const BeamChain few(straight(32), 0), many(straight(1024), 0);
  BeamNeighbours near_few(0.01), near_many(0.01);
  near_few.grains_renumbered(bed.view());
  near_few.update(few, bed.view());
  near_many.grains_renumbered(bed.view());
  near_many.update(many, bed.view());
  EXPECT_GT(near_few.size(), 10);
  EXPECT_EQ(near_many.pair_count(), near_few.pair_count());
  // two boxes for each of the five more levels
  EXPECT_LE(near_many.box_tests() - near_few.box_tests(), 500 * 2 * 5);
}

// A grain at x + n L touches what a grain at x touches: here n is any, and the chain longer or shorter than the box.
TEST(BeamNeighbours, InAPeriodicBoxTheNearestImageIsTouched) {
  RandomBeams random(907);
  const Eigen::Vector3d periods(0.7, 0.0, 1.1);
  int touching = 0, elsewhere = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const ModalBoundary boundary = random_chain(random, 12);
    const BeamChain chain(boundary, 0);
    Bed bed;
    for (int i = 0; i < 60; ++i) bed.add(chain.x().col(i % 13) + random.vector(0.2), 0.04);
    for (Eigen::Vector3d& x : bed.x)  // into the box
      for (const int d : {0, 2}) x[d] -= periods[d] * std::floor(x[d] / periods[d]);
    BeamNeighbours list(0.02, 0.0, periods);
    list.grains_renumbered(GrainExtent(bed.view()));
    ASSERT_TRUE(list.update(chain, bed.view()));
    std::vector<double> gaps(bed.x.size(), 1e300), found(bed.x.size(), 1e300);
    for (std::size_t i = 0; i < bed.x.size(); ++i)
      for (int a = -6; a <= 6; ++a)
        for (int c = -6; c <= 6; ++c)
          for (int s = 0; s < chain.segment_count(); ++s)
            gaps[i] = std::min(gaps[i], chain.touch(s, bed.x[i] - Eigen::Vector3d(0.7 * a, 0, 1.1 * c), 0.04).gap);
    for (int k = 0; k < list.size(); ++k) {
      const auto i = static_cast<std::size_t>(list.grain(k));
      EXPECT_EQ(found[i], 1e300);  // once
      const BeamTouch touch = list.closest(chain, k, bed.x[i], 0.04);
      found[i] = touch.gap;
      EXPECT_NEAR((bed.x[i] - touch.image - touch.p).norm() - touch.radius - 0.04, touch.gap, 1e-14);
      if (touch.gap <= 0.0 && !touch.image.isZero(0.0)) ++elsewhere;
    }
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (gaps[i] > 0.0) continue;
      ++touching;
      EXPECT_NEAR(found[i], gaps[i], 1e-14);
    }
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(elsewhere, 30);
}

TEST(BeamNeighbours, NoGrainsNoList) {
  RandomBeams random(16);
  Bed bed;
  const BeamChain chain(random_chain(random, 3), 0);
  BeamNeighbours list(0.01);
  list.grains_renumbered(bed.view());
  list.update(chain, bed.view());
  EXPECT_EQ(list.size(), 0);
}

}  // namespace
}  // namespace footfall

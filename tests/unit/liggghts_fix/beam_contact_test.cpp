// A sphere against a chain of capsules: against an independent search for the closest point, at joints, and
// virtual work.
#include "liggghts_fix/beam_contact.h"
#include "coupler/base/pi.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "tests/unit/liggghts_fix/random_beams.h"

namespace footfall {
namespace {

using test::closest;
using test::random_chain;
using test::RandomBeams;

// Lengths here are of order 1 m and take a few dozen operations.
constexpr double kRoundOff = 1e-14;

ModalBoundary boundary_of(Eigen::Matrix3Xd nodes, std::vector<BeamSegment> segments) {
  return ModalBoundary("tine", std::move(nodes), {}, std::move(segments));
}

// Nodes on the x axis.
ModalBoundary straight(const std::vector<double>& stations, double radius) {
  Eigen::Matrix3Xd nodes = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(stations.size()));
  std::vector<BeamSegment> segments;
  for (int i = 0; i < nodes.cols(); ++i) {
    nodes(0, i) = stations[static_cast<std::size_t>(i)];
    if (i > 0) segments.push_back({i - 1, i, radius, 0});
  }
  return boundary_of(nodes, segments);
}

TEST(BeamContact, GapOfAKnownSphereAtTheSideAndBeyondTheEnds) {
  const BeamChain chain(straight({0.0, 2.0}, 0.25), 0);
  const BeamTouch side = chain.touch(0, {0.5, 0.0, 1.0}, 0.5);
  EXPECT_DOUBLE_EQ(side.mu, 0.25);
  EXPECT_DOUBLE_EQ(side.gap, 0.25);
  EXPECT_EQ(side.normal, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(side.contact_point(), Eigen::Vector3d(0.5, 0.0, 0.25));
  const BeamTouch pressed = chain.touch(0, {0.5, 0.0, 0.625}, 0.5);  // overlap 0.125
  EXPECT_EQ(pressed.contact_point(), Eigen::Vector3d(0.5, 0.0, 0.1875));
  const BeamTouch end = chain.touch(0, {5.0, 4.0, 0.0}, 0.5);
  EXPECT_DOUBLE_EQ(end.mu, 1.0);
  EXPECT_DOUBLE_EQ(end.gap, 5.0 - 0.75);
  EXPECT_TRUE(end.normal.isApprox(Eigen::Vector3d(0.6, 0.8, 0.0), kRoundOff));
}

// |x - p(mu)| is convex in mu: a golden-section search finds its minimum without the projection formula.
double gap_by_search(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius, const Eigen::Vector3d& x,
                     double r) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  const auto distance = [&](double mu) { return ((1.0 - mu) * a + mu * b - x).norm(); };
  double low = 0.0, high = 1.0;
  while (high - low > 1e-9) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (distance(left) < distance(right) ? high : low) = distance(left) < distance(right) ? right : left;
  }
  return std::min({distance(0.0), distance(1.0), distance(0.5 * (low + high))}) - radius - r;
}

TEST(BeamContact, ClosestPointIsTheOneASearchFinds) {
  RandomBeams random(1);
  for (int k = 0; k < 50; ++k) {
    const BeamChain chain(random_chain(random, 1 + k % 9), 0);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d x = random.vector(1.5);
      const double r = random.between(0.01, 0.3);
      double expected = 1e300;
      for (const BeamSegment& s : chain.segments())
        expected = std::min(expected, gap_by_search(chain.x().col(s.start), chain.x().col(s.end), s.radius, x, r));
      const BeamTouch touch = closest(chain, x, r);
      // The search stops 1e-9 from the minimum in mu, where a distance above 1e-3 is flat to the square of
      // that.
      EXPECT_NEAR(touch.gap, expected, 1e-13) << "seed " << random.seed() << " chain " << k << " sphere " << i;
      EXPECT_NEAR((x - touch.p).norm() - touch.radius - r, touch.gap, kRoundOff);
      EXPECT_NEAR((touch.p + touch.normal * (touch.gap + touch.radius + r) - x).norm(), 0.0, 1e-13);
    }
  }
}

TEST(BeamContact, AJointInAStraightBeamCannotBeSeen) {
  const BeamChain one(straight({-1.0, 1.0}, 0.1), 0);
  const BeamChain many(straight({-1.0, -0.37, 0.0, 0.11, 0.625, 1.0}, 0.1), 0);
  for (int i = -1200; i <= 1200; ++i) {
    const Eigen::Vector3d x(0.001 * i, 0.03, 0.12);  // passes every node to the last digit of its station
    const BeamTouch a = closest(one, x, 0.05), b = closest(many, x, 0.05);
    EXPECT_NEAR(a.gap, b.gap, kRoundOff);
    EXPECT_NEAR((a.p - b.p).norm(), 0.0, kRoundOff);
    EXPECT_NEAR((a.normal - b.normal).norm(), 0.0, 10 * kRoundOff);  // of a distance of 0.12
  }
}

TEST(BeamContact, AroundTheOuterSideOfABendGapAndNormalAreContinuous) {
  Eigen::Matrix3Xd nodes(3, 3);
  nodes << -1.0, 0.0, 0.0,  //
      0.0, 0.0, -1.0,       //
      0.0, 0.0, 0.0;
  const BeamChain chain(boundary_of(nodes, {{0, 1, 0.1, 0}, {1, 2, 0.1, 0}}), 0);
  // Rolls around the corner with its centre on the surface of a larger tube: over one leg, a quarter turn,
  // down the other.
  const double distance = 0.25, r = 0.15;
  const auto path = [&](double s) -> Eigen::Vector3d {
    const double arc = 0.5 * kPi * distance;
    if (s < 0.0) return {s, distance, 0.0};
    if (s > arc) return {distance, -(s - arc), 0.0};
    return {distance * std::sin(s / distance), distance * std::cos(s / distance), 0.0};
  };
  const double ds = 1e-3;
  BeamTouch before = closest(chain, path(-0.5), r);
  for (double s = -0.5 + ds; s < 0.9; s += ds) {
    const BeamTouch touch = closest(chain, path(s), r);
    EXPECT_NEAR(touch.gap, 0.0, kRoundOff);
    EXPECT_LE((touch.normal - before.normal).norm(), ds / distance * (1 + 1e-9));
    EXPECT_LE((touch.p - before.p).norm(), ds * (1 + 1e-9));
    before = touch;
  }
}

TEST(BeamContact, InTheInnerSideOfABendTheGapIsContinuous) {
  Eigen::Matrix3Xd nodes(3, 3);
  nodes << -1.0, 0.0, 0.0,  //
      0.0, 0.0, 1.0,        //
      0.0, 0.0, 0.0;
  const BeamChain chain(boundary_of(nodes, {{0, 1, 0.1, 0}, {1, 2, 0.1, 0}}), 0);
  double before = closest(chain, {-0.5, 0.2, 0.0}, 0.1).gap;
  const double ds = 1e-3;
  for (double s = ds; s < 0.6; s += ds) {  // crosses the bisector of the corner
    const double gap = closest(chain, {-0.5 + s, 0.2 + 0.3 * s, 0.0}, 0.1).gap;
    // a distance changes no faster than the sphere moves
    EXPECT_LE(std::abs(gap - before), ds * std::sqrt(1.09) * (1 + 1e-9));
    before = gap;
  }
}

TEST(BeamContact, WhereTheRadiusStepsTheThickerSegmentIsTouched) {
  const ModalBoundary boundary("tine", (Eigen::Matrix3Xd(3, 3) << 0, 1, 2, 0, 0, 0, 0, 0, 0).finished(), {},
                               {{0, 1, 0.1, 0}, {1, 2, 0.2, 0}});
  const BeamChain chain(boundary, 0);
  const BeamTouch touch = closest(chain, {1.0, 0.0, 0.5}, 0.1);
  EXPECT_EQ(touch.segment, 1);
  EXPECT_DOUBLE_EQ(touch.gap, 0.2);
}

TEST(BeamContact, ACentreOnTheAxisIsPushedSideways) {
  const BeamChain chain(straight({0.0, 1.0}, 0.1), 0);
  const BeamTouch touch = chain.touch(0, {0.5, 0.0, 0.0}, 0.05);
  EXPECT_DOUBLE_EQ(touch.gap, -0.15);
  EXPECT_DOUBLE_EQ(touch.normal.norm(), 1.0);
  EXPECT_DOUBLE_EQ(touch.normal.x(), 0.0);
}

TEST(BeamContact, AChainIsPickedFromItsBoundaryByNumber) {
  Eigen::Matrix3Xd nodes = Eigen::Matrix3Xd::Random(3, 7);
  const ModalBoundary boundary("rake", nodes, {}, {{1, 5, 0.1, 0}, {2, 3, 0.3, 4}, {3, 6, 0.2, 4}});
  const BeamChain chain(boundary, 4);
  ASSERT_EQ(chain.segment_count(), 2);
  EXPECT_EQ(chain.node_count(), 3);
  EXPECT_EQ(chain.boundary_point(chain.segments()[1].end).nodes[0], 6);
  EXPECT_EQ(chain.segments()[1].radius, 0.2);
  EXPECT_EQ(chain.x().col(chain.segments()[0].start), nodes.col(2));
  EXPECT_DOUBLE_EQ(chain.largest_radius(), 0.3);
  EXPECT_THROW(BeamChain(boundary, 1), InputError);
}

}  // namespace
}  // namespace footfall

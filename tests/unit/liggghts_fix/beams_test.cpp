// Beams among grains: distance, neighbours, motion, contact law.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

#include "coupler/base/errors.h"
#include "liggghts_fix/link/beam_arguments.h"
#include "liggghts_fix/link/beam_chain.h"
#include "liggghts_fix/link/beam_neighbours.h"
#include "mbd_solver/base/pi.h"
#include "tests/support/refused.h"
#include "tests/unit/liggghts_fix/random_beams.h"

namespace footfall {
namespace {

BeamArguments parsed(const std::string& after_style) {
  std::istringstream in("strut all wall/gran/beam " + after_style);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return {static_cast<int>(pointers.size()), pointers.data()};
}

TEST(BeamArguments, GiveTheStockWallItsWordsAndKeepTheirOwn) {
  const BeamArguments all =
      parsed("model hertz tangential history type 2 body leg_1 chain 3 body leg_2 store_force yes");
  EXPECT_EQ(all.type, "2");
  ASSERT_EQ(all.beams.size(), 2U);
  EXPECT_EQ(all.beams[0].body, "leg_1");
  EXPECT_EQ(all.beams[0].chain, 3);
  EXPECT_EQ(all.beams[1].body, "leg_2");
  EXPECT_EQ(all.beams[1].chain, -1);
  const std::vector<std::string> stock = {"strut",   "all",       "wall/gran/beam", "model", "hertz",     "tangential",
                                          "history", "primitive", "type",           "2",     "zcylinder", "0",
                                          "0",       "0",         "store_force",    "yes"};
  EXPECT_EQ(all.stock, stock);
}

TEST(BeamArguments, NameTheWordThatIsWrong) {
  const std::pair<const char*, const char*> wrong[] = {
      {"model hertz mesh n_meshes 1 type 2 body leg", "\"mesh\""},
      {"model hertz type 2 body", "\"body\""},
      {"model hertz type 2 type 1 body leg", "\"type\""},
      {"model hertz type 2 chain 1 body leg", "\"chain 1\""},
      {"model hertz type 2 body leg chain 1 chain 2", "\"chain 2\""},
      {"model hertz type 2 body leg chain one", "\"chain one\""},
      {"model hertz type 2 body leg chain -1", "\"chain -1\""},
      {"model hertz body leg", "\"type\""},
      {"model hertz type 2", "\"body\""},
      {"model hertz type 2 body leg chain 1 body leg", "\"leg\""},
      {"model hertz type 2 body leg chain 1 body leg chain 1", "\"leg\""}};
  for (const auto& row : wrong)
    EXPECT_TRUE(test::names(test::error_of([&] { parsed(row.first); }), {"fix strut wall/gran/beam", row.second}))
        << row.first;
}

ModalBoundary two_beams() {
  Eigen::Matrix3Xd rho0(3, 4);
  rho0 << 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0;
  return ModalBoundary("leg", rho0, {}, {{2, 3, 0.1, 7}, {0, 1, 0.1, 4}});
}

TEST(BeamArguments, ChooseAllBeamsOrTheOneWithTheNumber) {
  EXPECT_EQ(chosen_chains("fix f", {"leg", -1}, two_beams()), (std::vector<int>{4, 7}));
  EXPECT_EQ(chosen_chains("fix f", {"leg", 7}, two_beams()), std::vector<int>{7});
}

TEST(BeamArguments, NameTheBeamsThereAreWhenTheNumberIsWrong) {
  EXPECT_TRUE(test::names(test::error_of([] { chosen_chains("fix f", {"leg", 5}, two_beams()); }), {"leg", "4, 7"}));
  const ModalBoundary bare("plate", Eigen::Matrix3Xd::Zero(3, 1), {});
  EXPECT_THROW(chosen_chains("fix f", {"plate", -1}, bare), InputError);
}

// A sphere against a chain of capsules: against an independent search for the closest point, at joints, and
// virtual work.

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
    nodes(0, i) = stations[i];
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
  for (int k = 0; k < 18; ++k) {
    const BeamChain chain(random_chain(random, 1 + k % 9), 0);
    for (int i = 0; i < 100; ++i) {
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

// Hertz' elliptic contact [Johnson 1985, 4.2], exact: semi-axes a > b of the patch, e^2 = 1 - (b/a)^2, curvatures 1/r
// along the beam and 1/rho across, K and E complete elliptic integrals, P = 3 F / (4 pi E*):
//   r / rho = ((a/b)^2 E - K) / (K - E),   a^3 = 4 r P (K - E) / e^2,   overlap = 2 P K / a
double exact(double r, double R) {
  const double wanted = 1.0 + r / R;  // r / rho
  const auto ratio = [](double k) {   // k = b / a
    const double e = std::sqrt(1.0 - k * k), K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
    return (E / (k * k) - K) / (K - E);
  };
  double low = 1e-4, high = 1.0 - 1e-6;
  for (int i = 0; i < 200; ++i) {
    const double k = 0.5 * (low + high);
    (ratio(k) > wanted ? low : high) = k;
  }
  const double k = low, e = std::sqrt(1.0 - k * k), K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
  const double a = std::cbrt(4.0 * r * (K - E) / (e * e)), overlap = 2.0 * K / a;  // at P = 1
  const double F = 4.0 * M_PI / 3.0;                                               // of E* = 1
  return F / (4.0 / 3.0 * std::sqrt(r) * std::pow(overlap, 1.5));
}

TEST(BeamHertz, IsHertzOnAPlaneForAThickBeam) {
  EXPECT_NEAR(hertz_on_side(0.02, 1e6), 1.0, 1e-6);
  EXPECT_NEAR(hertz_on_end(0.02, 1e6), 1.0, 1e-6);
}

TEST(BeamHertz, IsHertzEllipticContactOnTheSide) {
  double worst = 0.0;
  for (const double R : {50.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.02}) {
    const double error = hertz_on_side(1.0, R) / exact(1.0, R) - 1.0;
    std::printf("R / r %g: share %.5f, error %.2g\n", R, exact(1.0, R), error);
    worst = std::max(worst, std::abs(error));
  }
  EXPECT_LT(worst, 0.006);  // of the closed form
}

TEST(BeamHertz, IsTwoSpheresAtTheEnd) { EXPECT_NEAR(hertz_on_end(0.02, 0.02), std::sqrt(0.5), 1e-15); }

// How a body carries a beam, and what contacts on the beam do to the body: partners in virtual work.

// Sum of force times velocity at the contact points = generalized force times generalized velocity, for any
// motion and modes, and for bodies whose nodal rotations are not known.
TEST(BeamMotion, ForcesAtContactPointsDoTheWorkThatTheBodyReceives) {
  for (const bool with_rotations : {true, false}) {
    RandomBeams random(with_rotations ? 2 : 3);
    const int nodes = 6, modes = 4;
    std::vector<BeamSegment> segments;
    for (int i = 1; i < nodes; ++i) segments.push_back({i - 1, i, 0.07, 0});
    const ModalBoundary boundary(
        "tine", Eigen::Matrix3Xd::Random(3, nodes), {}, segments, Eigen::MatrixXd::Random(3 * nodes, modes),
        with_rotations ? Eigen::MatrixXd(Eigen::MatrixXd::Random(3 * nodes, modes)) : Eigen::MatrixXd());
    BodyMotion motion(modes);
    motion.r = random.vector(1.0);
    motion.L = Eigen::Vector4d::Random().normalized();
    motion.a = Eigen::VectorXd::Random(modes);
    motion.dr = random.vector(1.0);
    motion.w = random.vector(1.0);
    motion.da = Eigen::VectorXd::Random(modes);
    BeamChain chain(boundary, 0);
    chain.follow(motion);

    BeamMotion beam(boundary, chain);
    beam.begin_step(motion);
    double expected = 0.0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // about Bo
    for (int i = 0; i < 30; ++i) {
      const BeamTouch touch = closest(chain, random.vector(2.0), 0.1);
      const Eigen::Vector3d f = random.vector(10.0);
      beam.add_force(touch, f, touch.arm().cross(f));
      expected += f.dot(beam.velocity(touch));
      moment += (touch.contact_point() - motion.r).cross(f);
    }
    GeneralizedForce Q(modes);
    beam.project(motion, Q);
    // terms of order 10, thirty of them
    EXPECT_NEAR(power(Q, motion), expected, 1e-12 * std::abs(expected) + 1e-11);
    EXPECT_TRUE(Q.T_W.isApprox(moment, 1e-13));
  }
}

// Nodes of a chain go with the body's boundary, no further than largest_travel() says; for a mere shift it
// says exactly how far.
TEST(BeamMotion, NodesFollowTheBodyAndTravelNoFurtherThanTheirBound) {
  RandomBeams random(5);
  const int nodes = 7, modes = 3;
  std::vector<BeamSegment> segments;
  for (int i = 2; i < nodes; ++i) segments.push_back({i - 1, i, 0.07, 4});  // node 0 is not of the chain
  const ModalBoundary boundary("tine", Eigen::Matrix3Xd::Random(3, nodes), {}, segments,
                               Eigen::MatrixXd::Random(3 * nodes, modes));
  BeamChain chain(boundary, 4);
  const auto motion_near = [&](const BodyMotion& other, double size) {
    BodyMotion motion = other;
    motion.r += random.vector(size);
    motion.L = turned(other.L, random.vector(size));
    for (int m = 0; m < modes; ++m) motion.a[m] += random.between(-size, size);
    return motion;
  };
  for (int k = 0; k < 200; ++k) {
    const BodyMotion from = motion_near(BodyMotion(modes), 1.0), to = motion_near(from, k % 2 == 0 ? 1.0 : 0.01);
    chain.follow(from);
    const Eigen::Matrix3Xd before = chain.x();
    chain.follow(to);
    for (int node = 0; node < chain.node_count(); ++node)
      EXPECT_NEAR((chain.x().col(node) - boundary.position(to, chain.boundary_point(node))).norm(), 0.0, 1e-14);
    const double travel = (chain.x() - before).colwise().norm().maxCoeff();
    EXPECT_LE(travel, chain.largest_travel(from, to));
    BodyMotion shifted = from;
    shifted.r += Eigen::Vector3d(0.3, 0.0, 0.4);
    EXPECT_DOUBLE_EQ(chain.largest_travel(from, shifted), 0.5);
  }
}

// The velocity of the contact point is the rate at which the material point there moves: against a small
// rotation of a rigid body.
TEST(BeamMotion, VelocityOfTheContactPointIsThatOfTheMaterial) {
  RandomBeams random(4);
  const ModalBoundary boundary = random_chain(random, 3);
  BodyMotion motion;
  motion.r = random.vector(1.0);
  motion.L = Eigen::Vector4d::Random().normalized();
  motion.dr = random.vector(1.0);
  motion.w = random.vector(3.0);
  BeamChain chain(boundary, 0);
  chain.follow(motion);
  const BeamTouch touch = closest(chain, motion.r + random.vector(0.5), 0.1);
  BeamMotion beam(boundary, chain);
  beam.begin_step(motion);
  const Eigen::Vector3d c_B = motion.rotation().transpose() * (touch.contact_point() - motion.r);
  const double h = 1e-5;  // central difference: error of order |w|^3 h^2 / 6 = 3e-9 here
  BodyMotion later = motion, earlier = motion;
  later.r += h * motion.dr;
  later.L = turned(motion.L, h * motion.w);
  earlier.r -= h * motion.dr;
  earlier.L = turned(motion.L, -h * motion.w);
  const Eigen::Vector3d difference =
      ((later.r + later.rotation() * c_B) - (earlier.r + earlier.rotation() * c_B)) / (2.0 * h);
  EXPECT_NEAR((beam.velocity(touch) - difference).norm(), 0.0, 1e-8);
}

// The list of near pairs misses no touch while grains and nodes move, and costs what it touches.

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
  chain.x().row(0).array() += 1.0 - chain.x().row(0).minCoeff() + 0.5;  // half a metre from the grains
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

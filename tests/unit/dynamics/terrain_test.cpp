// Uneven ground: the field against differences and exact distances, bodies that roll and slide on it against fine integrations
// along the way, and the plane as the other route.

#include "mbd_solver/model/terrain.h"

#include <cmath>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/elements/terrain_contact.h"
#include "tests/unit/dynamics/jacobian_check.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

constexpr double kEarth = 9.81;

template <class F>
std::shared_ptr<const HeightGrid> map_of(int columns, int rows, double step, const F& height) {
  auto grid = std::make_shared<HeightGrid>();
  grid->columns = columns;
  grid->rows = rows;
  grid->step = {step, step};
  grid->first = {-0.5 * step * (columns - 1), -0.5 * step * (rows - 1)};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      grid->heights.push_back(height(grid->first.x() + i * step, grid->first.y() + j * step));
  return grid;
}

// At a random state, velocities and rates.
void expect_exact_jacobian(Model& model, test::Random& random, double bound) {
  const Assembly given = test::as_given(model);
  Equations equations(model, given);
  const Layout& layout = equations.layout();
  Eigen::VectorXd y(layout.size());
  equations.layout().pack(given.state, random.vector_x(layout.row_count), y);
  y.segment(layout.z0(), layout.z_size) = random.vector_x(layout.z_size, 0.05);
  const Eigen::VectorXd ydot = random.vector_x(layout.size(), 3.0);
  std::string where;
  Inputs inputs;
  inputs.values = Eigen::VectorXd::Zero(4);
  EXPECT_LT(test::jacobian_error(equations, y, ydot, 20.0, inputs, &where), bound) << where;
}

// Everything at once, smooth on a scale of 1 m.
TerrainParts hills() {
  TerrainParts parts;
  parts.origin = {0.3, -0.2, 0.1};
  parts.slope = {0.2, -0.1};
  parts.map =
      map_of(21, 17, 0.5, [](double x, double y) { return 0.05 * x * x - 0.04 * y * y + 0.2 * std::sin(x + 2 * y); });
  parts.craters = {{{1.0, 0.5}, 1.2, 0.2, 0.05}, {{-2.0, 0.0}, 1.5, 0.3, 0.1}};
  parts.waves = {{{1.5, 0.7}, 0.05, 0.4}, {{-0.4, 2.0}, 0.03, 1.0}};
  return parts;
}

std::shared_ptr<Terrain> terrain_of(TerrainParts parts) { return std::make_shared<Terrain>(std::move(parts)); }

TEST(Terrain, SlopesAndBendsAreDerivativesOfTheHeight) {
  Terrain ground(hills());
  constexpr double d = 1e-5;  // error of differences: d^2 and 1e-16 / d, both below 1e-9
  test::Random random(3);
  for (int k = 0; k < 200; ++k) {
    const double x = random.number(-6.0, 6.0), y = random.number(-5.0, 5.0);  // also beyond the map
    const Terrain::Height here = ground.at(x, y), e = ground.at(x + d, y), w = ground.at(x - d, y),
                          n = ground.at(x, y + d), s = ground.at(x, y - d);
    EXPECT_NEAR(here.slope.x(), (e.h - w.h) / (2 * d), 1e-7);
    EXPECT_NEAR(here.slope.y(), (n.h - s.h) / (2 * d), 1e-7);
    EXPECT_NEAR(here.bend[0], (e.slope.x() - w.slope.x()) / (2 * d), 2e-4) << x << " " << y;  // bends have corners
    EXPECT_NEAR(here.bend[1], (n.slope.y() - s.slope.y()) / (2 * d), 2e-4);
    EXPECT_NEAR(here.bend[2], (n.slope.x() - s.slope.x()) / (2 * d), 2e-4);
  }
}

TEST(Terrain, MapGoesThroughItsSamplesAndKeepsSiteCoordinates) {
  // Samples with 1e-4 m at coordinates of 1e6 m: nothing of them is lost, as the origin is subtracted first.
  TerrainParts parts;
  parts.map = map_of(9, 7, 0.25,
                     [](double x, double y) { return 0.0001 * std::round(1e3 * std::sin(3 * x) * std::cos(2 * y)); });
  Terrain ground(parts);
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 9; ++i)
      EXPECT_NEAR(ground.at(-1.0 + 0.25 * i, -0.75 + 0.25 * j).h, parts.map->at(i, j), 1e-15) << i << " " << j;
  // Beyond the edge along its tangent.
  const Terrain::Height edge = ground.at(1.0, 0.1), beyond = ground.at(4.0, 0.1);
  EXPECT_NEAR(beyond.h, edge.h + 3.0 * edge.slope.x(), 1e-12);
  EXPECT_TRUE(ground.inside_map(1.0, 0.75));
  EXPECT_FALSE(ground.inside_map(1.01, 0.0));
}

TEST(Terrain, DistanceIsThatOfTheNearestPoint) {
  Terrain ground(hills());
  test::Random random(5);
  for (int k = 0; k < 100; ++k) {
    const double x = random.number(-3.0, 3.0), y = random.number(-3.0, 3.0);
    const Eigen::Vector3d c(x, y, ground.at(x, y).h);
    const Terrain::Height h = ground.at(x, y);
    const Eigen::Vector3d n = Eigen::Vector3d(-h.slope.x(), -h.slope.y(), 1.0).normalized();
    const double phi = random.number(-0.1, 0.15);  // within the radii of curvature
    const Terrain::Foot foot = ground.foot(c + phi * n);
    EXPECT_NEAR(foot.distance, phi, 1e-12);
    EXPECT_LT((foot.normal - n).norm(), 1e-11);
    constexpr double d = 1e-6;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = d * Eigen::Vector3d::Unit(i), p = c + phi * n;
      const Terrain::Foot plus = ground.foot(p + step), minus = ground.foot(p - step);
      EXPECT_NEAR((plus.distance - minus.distance) / (2 * d), n[i], 1e-8);
      EXPECT_LT(((plus.normal - minus.normal) / (2 * d) - foot.bend.col(i)).norm(), 2e-3);  // bends have corners
    }
  }
}

// A map alone is searched cell by cell, four points at once; with a crater far away, point by point over the whole field.
TEST(Terrain, FeetInTheCellsOfAMapAreThoseOfTheWholeField) {
  TerrainParts parts;
  parts.origin = {3.0, -2.0, 0.4};
  parts.slope = {0.1, -0.2};
  parts.map = map_of(41, 31, 0.05, [](double x, double y) { return 0.02 * std::sin(7.0 * x + y) * std::cos(5.0 * y); });
  TerrainParts more = parts;
  more.craters = {{{100.0, 0.0}, 1.0, 0.1, 0.0}};
  Terrain cells(parts), whole(more);
  test::Random random(11);
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < 403; ++k) {  // some beyond the edges, some across cells, some above; not a number of fours
    const double x = 3.0 + random.number(-1.1, 1.1), y = -2.0 + random.number(-0.9, 0.9);
    points.emplace_back(x, y, cells.at(x, y).h + random.number(-0.03, 0.01));
  }
  Terrain::Feet feet, other, one;
  for (const Eigen::Vector3d& point : points) {
    feet.add(point);
    other.add(point);
  }
  cells.below(feet, Terrain::With::kBend);
  whole.below(other, Terrain::With::kBend);
  for (int k = 0; k < feet.count; ++k) {
    ASSERT_EQ(feet.near[k], other.near[k]) << k;
    if (feet.near[k] != Terrain::Near::kFoot) continue;
    const Terrain::Foot foot = feet.of(k, Terrain::With::kBend), expected = other.of(k, Terrain::With::kBend);
    // Both are exact to round-off of 1e-16 of numbers of 3 m, with bends of up to 2 per metre.
    EXPECT_NEAR(foot.distance, expected.distance, 1e-14) << k;
    EXPECT_LT((foot.normal - expected.normal).norm(), 1e-13) << k;
    EXPECT_LT((foot.place - expected.place).norm(), 1e-13) << k;
    EXPECT_LT((foot.bend - expected.bend).norm(), 1e-10) << k;
    one.clear();
    one.add(points[k]);
    cells.below(one, Terrain::With::kBend);  // alone it is the same to the bit
    EXPECT_EQ(one.distance[0], foot.distance) << k;
    EXPECT_EQ(one.bend[0], foot.bend) << k;
  }
}

// Roughness alone is searched cell by cell within its period, which the points go beyond.
TEST(Terrain, FeetOnARoughnessAreThoseOfTheWholeField) {
  TerrainParts parts;
  parts.origin = {0.2, 0.1, -0.3};
  parts.slope = {0.0, 0.05};
  parts.waves = {{{2.0 * kPi / 0.7, 0.0}, 0.0, 0.0},
                 {{2.0 * kPi / 0.35, 2.0 * kPi / 0.7}, 0.005, 0.3},
                 {{-2.0 * kPi / 0.7, 4.0 * kPi / 0.7}, 0.004, 1.1}};  // the first has the period of 0.7 m
  TerrainParts more = parts;
  more.craters = {{{100.0, 0.0}, 1.0, 0.1, 0.0}};
  Terrain cells(parts), whole(more);
  test::Random random(12);
  Terrain::Feet feet, other;
  for (int k = 0; k < 203; ++k) {
    const double x = random.number(-2.0, 2.0), y = random.number(-2.0, 2.0);
    for (Terrain::Feet* to : {&feet, &other}) to->add({x, y, cells.at(x, y).h + random.number(-0.02, 0.005)});
    other.points.row(k) = feet.points.row(k);
  }
  cells.below(feet, Terrain::With::kNormal);
  whole.below(other, Terrain::With::kNormal);
  int found = 0;
  for (int k = 0; k < feet.count; ++k) {
    ASSERT_EQ(feet.near[k], other.near[k]) << k;
    if (feet.near[k] != Terrain::Near::kFoot) continue;
    ++found;
    EXPECT_NEAR(feet.distance[k], other.distance[k], 1e-14) << k;  // round-off of 1e-16 of 3 m, as on a map
    EXPECT_LT((feet.normal.row(k) - other.normal.row(k)).matrix().norm(), 1e-13) << k;
    EXPECT_LT((feet.place.row(k) - other.place.row(k)).matrix().norm(), 1e-13) << k;
  }
  EXPECT_GT(found, 100);
}

TEST(Terrain, BallInAGrooveHasTwoFeet) {
  // h = |x| rounded off within 0.1 m: a ball of 0.5 m touches both sides.
  TerrainParts parts;
  parts.map = map_of(201, 5, 0.02, [](double x, double) { return std::sqrt(x * x + 0.01); });
  Terrain ground(parts);
  std::vector<Terrain::Foot> feet;
  ground.feet({0.0, 0.0, 0.71}, 0.55, feet);
  ASSERT_EQ(feet.size(), 2u);
  EXPECT_NEAR(feet[0].distance, feet[1].distance, 1e-9);
  EXPECT_NEAR(feet[0].normal.x(), -feet[1].normal.x(), 1e-9);
  double least = 1.0;  // by looking at all places
  for (int i = 0; i <= 40000; ++i) {
    const double x = -1.0 + 5e-5 * i;
    least = std::min(least, std::hypot(x, 0.71 - ground.at(x, 0.0).h));
  }
  EXPECT_NEAR(feet[0].distance, least, 1e-6);
}

TEST(Terrain, NothingTouchesAboveTheLid) {
  TerrainParts parts = hills();
  parts.rocks = {{{1.0, 1.0}, 0.3, 0.5}, {{-1.0, 0.5}, 0.2, 0.2}};
  Terrain ground(parts);
  test::Random random(9);
  int clear = 0;
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector3d c(random.number(-3.0, 3.0), random.number(-3.0, 3.0), random.number(0.0, 3.0));
    const double reach = random.number(0.1, 1.0);
    const Terrain::Lid lid = ground.lid(c, reach);
    for (int i = 0; i < 20; ++i) {
      const double angle = random.number(0.0, 6.3), away = random.number(0.0, reach);
      EXPECT_LT(ground.at(c.x() + away * std::cos(angle), c.y() + away * std::sin(angle)).h, lid.top);
    }
    if (!lid.above(c, reach) || !lid.rocks.empty()) continue;
    ++clear;
    EXPECT_GE(ground.distance(c), reach) << c.transpose();
  }
  EXPECT_GT(clear, 50);
  EXPECT_NEAR(ground.top(1.3, 0.8), ground.rocks()[0].centre.z() + 0.3, 1e-12);

  TerrainParts map;  // ripples of 1 mm on a slope: a plane is known above them, where bends only tell of 70 mm
  map.origin = {0.4, 0.3, 2.0};
  map.slope = {0.1, -0.3};
  map.map = map_of(161, 161, 0.02, [](double x, double y) { return 0.2 * x + 1e-3 * std::sin(40.0 * x + 30.0 * y); });
  Terrain rippled(map);
  for (int k = 0; k < 100; ++k) {
    const Eigen::Vector2d c(random.number(-0.5, 1.3), random.number(-0.6, 1.2)), slope(0.3, -0.3);
    const double reach = random.number(0.05, 0.3), height = rippled.plane_above(c, reach, slope);
    const double mean = 2.0 + slope.dot(c - map.origin.head<2>());
    EXPECT_NEAR(height, mean, 2e-3) << k;  // the coefficients of waves of 6 samples are a fifth larger than these
    for (int i = 0; i < 20; ++i) {
      const double angle = random.number(0.0, 6.3), away = random.number(0.0, reach);
      const Eigen::Vector2d d(away * std::cos(angle), away * std::sin(angle));
      EXPECT_LE(rippled.at(c.x() + d.x(), c.y() + d.y()).h, height + slope.dot(d) + 1e-14) << k;
    }
  }
  EXPECT_TRUE(std::isinf(rippled.plane_above({2.0, 0.0}, 0.1, {0.0, 0.0})));  // beyond the edge
  EXPECT_TRUE(std::isinf(ground.plane_above({0.0, 0.0}, 0.1, {0.0, 0.0})));   // not a map alone
}

// ---- contact ----

ContactLaw hard(double friction) {
  ContactLaw law;
  law.stiffness = 1e9;
  law.damping = 1.0;
  law.friction = friction;
  return law;
}

// The way of the foot u of a rolling or sliding body along y = 0, in the frame of a profile h(u): the centre is above the foot
// by R along the normal, and `inertia` is (1 + I / m R^2). Friction mu of a body that slides without turning.
struct Profile {
  std::function<double(double)> h, h1, h2;
  double R = 0.0, inertia = 1.0, mu = 0.0;

  Eigen::Vector2d centre(double u) const {
    const double L = std::sqrt(1.0 + h1(u) * h1(u));
    return {u - R * h1(u) / L, h(u) + R / L};
  }
  // dc/du = (1 - R kappa) (1, h'), kappa = h'' / L^3
  double stretch(double u) const {
    const double L2 = 1.0 + h1(u) * h1(u);
    return 1.0 - R * h2(u) / (L2 * std::sqrt(L2));
  }
  // Speed s' of the centre along its way; s'' = -g sin(a) / inertia - mu sign(s') (g cos(a) + kappa_c s'^2).
  Eigen::Vector2d rate(const Eigen::Vector2d& state) const {
    const double u = state[0], v = state[1], L = std::sqrt(1.0 + h1(u) * h1(u)), one = stretch(u);
    const double kappa = h2(u) / (L * L * L) / one;
    const double push = mu * std::max(0.0, kEarth / L + kappa * v * v) * (v > 0.0 ? 1.0 : -1.0);
    return {v / (L * one), -kEarth * h1(u) / L / inertia - (mu > 0.0 ? push : 0.0)};
  }
  Eigen::Vector2d after(double u, double v, double time, bool stops = false) const {
    Eigen::Vector2d y(u, v);
    const int steps = 20000;
    const double dt = time / steps;
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d k1 = rate(y), k2 = rate(y + 0.5 * dt * k1), k3 = rate(y + 0.5 * dt * k2),
                            k4 = rate(y + dt * k3);
      const Eigen::Vector2d next = y + dt / 6.0 * (k1 + 2 * k2 + 2 * k3 + k4);
      if (stops && next[1] <= 0.0) return y;
      y = next;
    }
    return y;
  }
};

Profile profile_of(std::function<double(double)> h, std::function<double(double)> h1,
                   std::function<double(double)> h2) {
  return {std::move(h), std::move(h1), std::move(h2)};
}

// A round body on the profile at u with the speed v of its centre, at the depth at which it stands still on a level.
struct Rolling {
  Rolling(const Profile& profile, std::shared_ptr<const Terrain> terrain, double u, double v, bool wheel,
          double friction = 0.6)
      : model({0.0, 0.0, -kEarth}) {
    const double R = profile.R, m = 2.0, I = (profile.inertia - 1.0) * m * R * R;
    const double slope = profile.h1(u), L = std::sqrt(1.0 + slope * slope);
    BodyState state;
    const double sunk = std::pow(m * kEarth / L / hard(0.0).stiffness, 2.0 / 3.0);
    const Eigen::Vector2d c = profile.centre(u) - sunk * Eigen::Vector2d(-slope, 1.0) / L;
    state.r = {c.x(), 0.0, c.y()};
    state.dr = v * Eigen::Vector3d(1.0, 0.0, slope) / L;
    if (R > 0.0) state.w = {0.0, v / R, 0.0};
    const double i = std::max(I, 1e-3);
    model.add_body(Body("round", m, Eigen::Vector3d(i, i, i).asDiagonal()), state);
    std::vector<ContactPoint> points;
    std::vector<ContactRim> rims;
    if (wheel) {
      Eigen::Matrix3d axes;
      axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // z along -y
      rims.push_back({body_marker(0, model.body(0), Eigen::Vector3d::Zero(), axes), R});
    } else {
      points.push_back({body_marker(0, model.body(0), Eigen::Vector3d::Zero()), R});
    }
    model.add_force(std::make_unique<TerrainContact>("ground", points, hard(friction), std::move(terrain), rims));
  }
  Model model;
};

// Where the integration along the way has it.
void expect_on_its_way(const Profile& profile, std::shared_ptr<const Terrain> terrain, double u, double v, double time,
                       bool wheel) {
  Rolling body(profile, std::move(terrain), u, v, wheel);
  test::Run run(body.model, "one_step", test::precise(1e-9));
  for (int k = 1; k <= 4; ++k) {
    run.to(0.25 * k * time);
    const Eigen::Vector2d y = profile.after(u, v, 0.25 * k * time);
    const Eigen::Vector2d c = profile.centre(y[0]);
    const double way = std::abs(c.x() - profile.centre(u).x()) + 0.1;
    EXPECT_NEAR(run.body(0).r.x(), c.x(), 1e-4 * way) << k;
    EXPECT_NEAR(run.body(0).r.z(), c.y(), 1e-4 * way) << k;  // it sinks in by some 1e-5 m
    EXPECT_NEAR(run.body(0).dr.norm(), std::abs(y[1]), 1e-4 * (std::abs(y[1]) + 1.0)) << k;
    EXPECT_LT(std::abs(run.body(0).r.y()), 1e-9);
  }
}

TEST(TerrainContact, BallAndWheelRollDownATiltedPlane) {
  // Closed form: (5/7) g sin(a) t^2 / 2 of a ball, (2/3) of a disc; the integration is that.
  TerrainParts parts;
  parts.slope = {-0.3, 0.0};
  for (const bool wheel : {false, true}) {
    Profile plane =
        profile_of([](double u) { return -0.3 * u; }, [](double) { return -0.3; }, [](double) { return 0.0; });
    plane.R = 0.2;
    plane.inertia = wheel ? 1.5 : 1.4;
    const double a = kEarth * 0.3 / std::sqrt(1.09) / plane.inertia;
    EXPECT_NEAR(plane.after(0.0, 0.0, 1.0)[1], a, 1e-9);
    expect_on_its_way(plane, terrain_of(parts), 0.0, 0.0, 1.0, wheel);
  }
}

// Closed forms, at an azimuth of 37 degrees: (5/7) g sin(a) t^2 / 2 of a ball, (2/3) of a cylinder on its two edges. The first 0.1 mm are
// the loads of a body that finds its depth.
TEST(TerrainContact, BallAndCylinderRollDownAMapAtAnAzimuth) {
  constexpr double slope = 0.2, azimuth = 37.0 * kPi / 180.0, R = 0.2, m = 2.0;
  const Eigen::Vector3d down(std::cos(azimuth), std::sin(azimuth), -slope),
      axis(-std::sin(azimuth), std::cos(azimuth), 0.0),
      n = Eigen::Vector3d(slope * down.x(), slope * down.y(), 1.0).normalized();
  TerrainParts parts;
  parts.map = map_of(81, 81, 0.05, [&](double x, double y) { return -slope * (down.x() * x + down.y() * y); });
  for (const bool ball : {true, false}) {
    Model model({0.0, 0.0, -kEarth});
    BodyState state;
    state.r = (R - std::pow(m * kEarth * n.z() / (ball ? 1.0 : 2.0) / hard(0.0).stiffness, 2.0 / 3.0)) * n;
    const double I = (ball ? 0.4 : 0.5) * m * R * R;
    model.add_body(Body("round", m, Eigen::Vector3d(I, I, I).asDiagonal()), state);
    std::vector<ContactPoint> points;
    std::vector<ContactRim> rims;
    Eigen::Matrix3d axes;
    axes << n.cross(axis), n, axis;
    if (ball) points.push_back({body_marker(0, model.body(0), Eigen::Vector3d::Zero()), R});
    for (const double side : {-0.15, 0.15})
      if (!ball) rims.push_back({body_marker(0, model.body(0), side * axis, axes), R});
    model.add_force(std::make_unique<TerrainContact>("ground", points, hard(0.6), terrain_of(parts), rims));
    test::Run run(model, "one_step", test::precise(1e-9));
    run.to(1.0);
    const double way = 0.5 * kEarth * slope / std::sqrt(1.0 + slope * slope) / (ball ? 1.4 : 1.5);
    EXPECT_LT((run.body(0).r - state.r - way * down.normalized()).norm(), 1e-4 * way) << ball;
    EXPECT_LT(std::abs(run.imbalance()), 1e-6 * m * kEarth * way) << ball;
  }
}

TEST(TerrainContact, BallAndWheelRollInAParaboloidMap) {
  TerrainParts parts;
  parts.map = map_of(81, 81, 0.1, [](double x, double y) { return 0.2 * (x * x + y * y); });
  for (const bool wheel : {false, true}) {
    Profile bowl =
        profile_of([](double u) { return 0.2 * u * u; }, [](double u) { return 0.4 * u; }, [](double) { return 0.4; });
    bowl.R = 0.25;
    bowl.inertia = wheel ? 1.5 : 1.4;
    expect_on_its_way(bowl, terrain_of(parts), 1.2, 0.0, 3.0, wheel);
  }
}

TEST(TerrainContact, BallAndWheelRollOverASineMap) {
  // Samples 1/40 of the wave apart: the spline errs by (k step)^4 / 384 = 2e-6 of the height.
  TerrainParts parts;
  const double k = 2.0 * kPi / 2.0, A = 0.08;
  parts.map = map_of(241, 21, 0.05, [=](double x, double) { return A * std::sin(k * x); });
  for (const bool wheel : {false, true}) {
    Profile sine =
        profile_of([=](double u) { return A * std::sin(k * u); }, [=](double u) { return A * k * std::cos(k * u); },
                   [=](double u) { return -A * k * k * std::sin(k * u); });
    sine.R = 0.3;
    sine.inertia = wheel ? 1.5 : 1.4;
    expect_on_its_way(sine, terrain_of(parts), -4.0, 2.0, 3.0, wheel);
  }
}

TEST(TerrainContact, BlockStopsWhereItsEnergySays) {
  // A point that slides over a hollow and up again, pressed on by the curvature of its way, with friction 0.3; it stays.
  TerrainParts parts;
  parts.map = map_of(161, 21, 0.05, [](double x, double) { return 0.04 * x * x; });
  Profile hollow =
      profile_of([](double u) { return 0.04 * u * u; }, [](double u) { return 0.08 * u; }, [](double) { return 0.08; });
  hollow.mu = 0.3;
  const Eigen::Vector2d stop = hollow.after(-1.5, 4.0, 3.0, true);
  Rolling block(hollow, terrain_of(parts), -1.5, 4.0, false, 0.3);
  test::Run run(block.model, "one_step", test::precise(1e-9));
  run.to(2.5);
  EXPECT_NEAR(run.body(0).r.x(), stop[0],
              1e-4 * (stop[0] + 1.5) + 1e-3 * 4e-3);  // friction is 0.5 % less in the last mm/s
  const double there = run.body(0).r.x();
  run.to(6.0);
  EXPECT_NEAR(run.body(0).r.x(), there, 1e-6);
  EXPECT_LT(std::abs(run.imbalance()), 1e-5 * run.start_energy());
}

TEST(TerrainContact, WheelRollsOverAStep) {
  // A rise by 0.12 m whose foot and head are arcs larger and smaller than the wheel's radius: the way of the centre is smooth.
  TerrainParts parts;
  const double H = 0.12, w = 0.25;
  const auto h = [=](double u) { return 0.5 * H * std::erf(u / w); };
  const auto h1 = [=](double u) { return H / (w * std::sqrt(kPi)) * std::exp(-u * u / (w * w)); };
  const auto h2 = [=](double u) { return -2.0 * u / (w * w) * h1(u); };
  parts.map = map_of(401, 21, 0.01, [=](double x, double) { return h(x); });
  Profile step = profile_of(h, h1, h2);
  step.R = 0.2;
  step.inertia = 1.5;
  expect_on_its_way(step, terrain_of(parts), -0.8, 1.6, 1.2, true);
}

TEST(TerrainContact, OnASlopeAloneItMovesAsOnTheTiltedPlane) {
  // Corners, a ball and round edges in one body that tumbles and slides; the terrain has a slope and nothing else.
  constexpr double kSlope = 0.35;
  Model models[2] = {Model({0.0, 0.0, -kEarth}), Model({0.0, 0.0, -kEarth})};
  TerrainParts parts;
  parts.slope = {-kSlope, 0.1};
  parts.origin = {0.2, 0.1, 0.05};
  ContactLaw law = hard(0.5);
  law.stiffness = 1e6;
  for (int i = 0; i < 2; ++i) {
    BodyState state;
    state.r = {0.0, 0.0, 0.5};
    state.dr = {0.6, 0.2, -0.5};
    state.w = {1.0, 2.0, 0.5};
    models[i].add_body(Body("block", 2.0, Eigen::Vector3d(0.02, 0.03, 0.04).asDiagonal()), state);
    std::vector<ContactPoint> points;
    for (const double x : {-0.15, 0.15})
      for (const double y : {-0.1, 0.1})
        for (const double z : {-0.08, 0.08}) points.push_back({body_marker(0, models[i].body(0), {x, y, z}), 0.0});
    points.push_back({body_marker(0, models[i].body(0), {0.05, 0.0, -0.1}), 0.12});
    if (i == 0) {
      models[i].add_force(std::make_unique<TerrainContact>("ground", points, law, terrain_of(parts)));
    } else {
      RigidPlane::Parameters plane;
      static_cast<ContactLaw&>(plane) = law;
      plane.point = parts.origin;
      plane.normal = Eigen::Vector3d(-parts.slope.x(), -parts.slope.y(), 1.0);
      models[i].add_force(std::make_unique<RigidPlane>("ground", points, plane));
    }
  }
  IntegratorOptions options = test::tight(1e-11);
  options.error_control = false;
  options.max_step = 5e-5;
  test::Run uneven(models[0], "one_step", options), flat(models[1], "one_step", options);
  for (int k = 1; k <= 8; ++k) {
    uneven.to(0.03 * k);
    flat.to(0.03 * k);
    EXPECT_LT((uneven.body(0).r - flat.body(0).r).norm(), 1e-9) << k;
    EXPECT_LT((uneven.body(0).w - flat.body(0).w).norm(), 1e-6) << k;
  }
}

TEST(TerrainContact, DerivativesAreExact) {
  // Points, balls, edges that stand and lie, and rocks, with slip, springs and spin; a flexible body as well.
  test::Random random(17);
  Model model({0.3, 0.2, -9.0});
  TerrainParts parts = hills();
  parts.rocks = {{{0.2, 0.4}, 0.8, 0.5}};
  const auto ground = terrain_of(parts);
  ContactLaw law;
  law.stiffness = 90.0;
  law.damping = 0.4;
  law.friction = 0.3;
  law.slip_speed = 0.2;
  law.stick_time = 0.5;
  for (int i = 0; i < 4; ++i) {
    const std::string name = "body_" + std::to_string(i);
    const Body body =
        i == 3 ? Body(name, test::hand_made_body(random, 4, 2, 500.0, 0.05)) : test::random_rigid_body(random, name);
    BodyState state = test::random_state(random, body);
    const double x = random.number(-1.5, 1.5), y = random.number(-1.5, 1.5);
    state.r = {x, y, ground->at(x, y).h + (i == 1 || i == 2 ? 0.35 : -0.1)};
    state.a *= 0.3;
    if (i == 1 || i == 2) {  // an edge that is upright, and another that lies
      state.L = quaternion_about(Eigen::Vector3d::UnitX(), i == 1 ? 1.3 : 0.1);
      model.add_body(body, state);
      const ContactRim rim{body_marker(i, body, {0.0, 0.0, i == 1 ? 0.05 : -0.4}), i == 1 ? 0.5 : 0.4};
      std::vector<ContactPoint> face;
      for (const Eigen::Vector2d& d :
           {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.2, -0.1), Eigen::Vector2d(-0.05, 0.25)})
        face.push_back({body_marker(i, body, rim.marker.s0 + Eigen::Vector3d(d.x(), d.y(), 0.0)), 0.0});
      model.add_force(
          std::make_unique<TerrainContact>(name + "_edge", face, law, ground, std::vector<ContactRim>{rim}));
      continue;
    }
    model.add_body(body, state);
    std::vector<ContactPoint> points;
    for (int k = 0; k < 3; ++k) points.push_back({test::random_marker(random, model, i), 0.0});
    points.push_back({body_marker(i, body, {0.0, 0.0, 0.1}), 0.25});
    model.add_force(std::make_unique<TerrainContact>(name + "_points", points, law, ground));
  }
  expect_exact_jacobian(model, random, 1e-7);
}

// What an element has computed for one state is used again for it; what it was asked before leaves no trace.
TEST(TerrainContact, ResultsDoNotDependOnWhatWasAskedBefore) {
  test::Random random(23);
  Model model({0.0, 0.0, -1.62});
  const auto ground = terrain_of(hills());
  const Body body("pad", test::hand_made_body(random, 4, 2, 500.0, 0.05));
  BodyState state = test::random_state(random, body);
  state.r = {0.4, -0.3, ground->at(0.4, -0.3).h - 0.1};
  state.a *= 0.3;
  model.add_body(body, state);
  std::vector<ContactPoint> points;
  for (int k = 0; k < 4; ++k) points.push_back({test::random_marker(random, model, 0), 0.0});
  ContactLaw law;
  law.stiffness = 90.0;
  law.damping = 0.4;
  law.stick_time = 0.5;
  const Assembly given = test::as_given(model);
  Kinematics here(model), there(model);
  here.load(Layout(model), given.state.q, given.state.v, Eigen::VectorXd());
  there.load(Layout(model), given.state.q, 1.5 * given.state.v, Eigen::VectorXd());
  const Eigen::VectorXd z = random.vector_x(8, 0.05), inputs;
  const TerrainContact contact("ground", points, law, ground);
  const test::OwnScratch fresh(contact), used(contact), last(contact);
  const ElementInput in{here.pair(0, kGround), z, inputs}, other{there.pair(0, kGround), z, inputs};
  const int n = in.size();
  const auto derivatives = [&](const test::OwnScratch& own) {
    ElementDerivatives out;
    for (Eigen::MatrixXd* m : {&out.dQ_dx, &out.dQ_dv}) m->setZero(n, n);
    out.dQ_dz.setZero(n, 8);
    for (Eigen::MatrixXd* m : {&out.ddz_dx, &out.ddz_dv}) m->setZero(8, n);
    out.ddz_dz.setZero(8, 2);
    EXPECT_TRUE(contact.add_derivatives(own.with(in), out));
    return out.dQ_dx;
  };
  const auto force = [&](const test::OwnScratch& own, const ElementInput& of) {
    Eigen::VectorXd Q = Eigen::VectorXd::Zero(n), dz(8);
    contact.add_force(own.with(of), Q, dz);
    return Q;
  };
  const Eigen::VectorXd Q = force(fresh, in);
  EXPECT_GT(Q.norm(), 0.0);
  EXPECT_NE(force(used, other), Q);
  EXPECT_EQ(contact.wrench(used.with(other)).head<3>(), force(used, other).head<3>());
  EXPECT_EQ(force(used, in), Q);
  const Eigen::MatrixXd K = derivatives(used);  // asks for more than the force did
  EXPECT_EQ(force(used, in), Q);
  EXPECT_EQ(derivatives(last), K);
}

// Contacts are computed side by side; one by one where a rock is near, also if it touches nothing.
TEST(TerrainContact, SideBySideTheyAreWhatTheyAreOneByOne) {
  TerrainParts alone;
  alone.map = map_of(41, 41, 0.05, [](double x, double y) { return 2e-3 * std::sin(9.0 * x + y) * std::cos(7.0 * y); });
  TerrainParts beside = alone;
  beside.rocks = {{{0.3, 0.0}, 0.04, 0.0}};
  const Body body("pad", 2.0, Eigen::Vector3d(0.1, 0.1, 0.2).asDiagonal());
  Model model({0.0, 0.0, -1.62});
  BodyState state;
  state.r = {0.01, 0.02, -0.001};
  state.L = quaternion_about(Eigen::Vector3d::UnitX(), 2e-3);
  state.dr = {0.02, -0.01, -0.05};
  state.w = {0.1, -0.2, 0.3};
  model.add_body(body, state);
  std::vector<ContactPoint> face;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) face.push_back({body_marker(0, body, 0.07 * Eigen::Vector3d(i, j, 0.0)), 0.0});
  const std::vector<ContactRim> rims = {{body_marker(0, body, Eigen::Vector3d::Zero()), 0.25}};
  ContactLaw law;
  law.stiffness = 1e6;
  law.damping = 0.4;
  law.slip_speed = 1e-2;
  const Assembly given = test::as_given(model);
  Kinematics kinematics(model);
  kinematics.load(Layout(model), given.state.q, given.state.v, Eigen::VectorXd());
  test::Random random(29);
  const Eigen::VectorXd z = random.vector_x(24, 1e-4), inputs;
  std::vector<Eigen::VectorXd> results;
  for (const TerrainParts& parts : {alone, beside}) {
    const TerrainContact contact("ground", face, law, terrain_of(parts), rims);
    const test::OwnScratch own(contact);
    const ElementInput in = own.with({kinematics.pair(0, kGround), z, inputs});
    Eigen::VectorXd Q = Eigen::VectorXd::Zero(6), dz(24), all(6 + 24 + 6 + 4);
    contact.add_force(in, Q, dz);
    StoredEnergy stored;
    Dissipated power;
    contact.add_energy(in, stored, power);
    all << Q, dz, contact.wrench(in), stored[Stored::kContact], power[Dissipation::kContact],
        power[Dissipation::kFriction], contact.largest_overlap(in);
    EXPECT_FALSE(contact.touches_rock(in));
    results.push_back(all);
  }
  EXPECT_GT(results[0].norm(), 100.0);
  for (Eigen::Index k = 0; k < results[0].size(); ++k)  // sums of 37 contacts in another order
    EXPECT_NEAR(results[0][k], results[1][k], 1e-12 * (std::abs(results[0][k]) + 1e-3)) << k;
}

TEST(TerrainContact, EnergyIsKeptOverRocks) {
  // A wheel and a ball without damping or friction hop among hills and rocks: what they have stays.
  TerrainParts parts = hills();
  parts.rocks = {{{0.8, 0.1}, 0.3, 0.6}, {{1.6, -0.2}, 0.25, 0.4}};
  Model model({0.0, 0.0, -kEarth});
  ContactLaw law;
  law.stiffness = 1e6;
  law.friction = 0.0;
  const auto ground = terrain_of(parts);
  for (int i = 0; i < 2; ++i) {
    BodyState state;
    state.r = {-0.4, 0.1 + 0.3 * i, 1.2};
    state.dr = {1.0, -0.2, 0.0};
    state.w = {0.2, 3.0, 0.1};
    model.add_body(Body("body_" + std::to_string(i), 2.0, Eigen::Vector3d(0.02, 0.03, 0.025).asDiagonal()), state);
    Eigen::Matrix3d axes;
    axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    const Marker centre = body_marker(i, model.body(i), Eigen::Vector3d::Zero(), axes);
    std::vector<ContactPoint> points;
    std::vector<ContactRim> rims;
    if (i == 0)
      points.push_back({centre, 0.2});
    else
      rims.push_back({centre, 0.2});
    model.add_force(std::make_unique<TerrainContact>("ground_" + std::to_string(i), points, law, ground, rims));
  }
  test::Run run(model, "one_step", test::precise(1e-8));
  run.to(2.0);
  EXPECT_LT(std::abs(run.imbalance()), 1e-5 * run.start_energy());
}

// Of a disc (radius 0.25 m, a face of 37 points) that is 2 mm deep in the ground of this terrain, level or tilted a little.
Eigen::Vector3d push_on_a_disc(const TerrainParts& parts, double tilt, bool plane) {
  Model model({0.0, 0.0, -1.62});
  const Body body("pad", 2.0, Eigen::Vector3d(0.1, 0.1, 0.2).asDiagonal());
  BodyState state;
  state.r = {0.0, 0.0, -0.002};
  state.L = quaternion_about(Eigen::Vector3d::UnitX(), tilt);
  model.add_body(body, state);
  ContactLaw law;
  law.stiffness = 1e6;
  std::vector<ContactPoint> face;
  for (int ring = 0; ring < 4; ++ring)
    for (int k = 0; k < std::max(1, 6 * ring); ++k)
      face.push_back({body_marker(0, body,
                                  0.075 * ring *
                                      Eigen::Vector3d(std::cos(k * kPi / (3 * std::max(1, ring))),
                                                      std::sin(k * kPi / (3 * std::max(1, ring))), 0.0)),
                      0.0});
  const std::vector<ContactRim> rims = {{body_marker(0, body, Eigen::Vector3d::Zero()), 0.25}};
  const Assembly given = test::as_given(model);
  Kinematics kinematics(model);
  kinematics.load(Layout(model), given.state.q, given.state.v, Eigen::VectorXd());
  const auto push = [&](const auto& ground) -> Eigen::Vector3d {
    const Eigen::VectorXd springs = ground.initial_state();
    const test::OwnScratch own(ground);
    const auto wrench = ground.wrench(own.with({kinematics.pair(0, kGround), springs, Eigen::VectorXd()}));
    return {wrench[2], wrench[3], wrench[4]};
  };
  if (!plane) return push(TerrainContact("ground", face, law, terrain_of(parts), rims));
  RigidPlane::Parameters flat;
  static_cast<ContactLaw&>(flat) = law;
  return push(RigidPlane("ground", {}, flat, rims));
}

TEST(TerrainContact, DiscIsAsStiffOnALevelMapAsOnThePlane) {
  TerrainParts level, rough;
  level.map = map_of(101, 101, 0.01, [](double, double) { return 0.0; });
  // Ripples of 1 um: the points of the face touch as well, with the edge as stiff as the plane.
  rough.map = map_of(101, 101, 0.01, [](double x, double y) { return 1e-6 * std::sin(40.0 * x) * std::cos(30.0 * y); });
  for (const double tilt : {0.0, 2e-3}) {
    const Eigen::Vector3d plane = push_on_a_disc({}, tilt, true);
    EXPECT_LT((push_on_a_disc(level, tilt, false) - plane).norm(), 1e-9 * plane.norm());
    // 1 um of 2 mm; at a tilt points near the middle are as deep as it, and forces on both sides grow as the overlap^1.5.
    EXPECT_NEAR(push_on_a_disc(rough, tilt, false)[0], plane[0], (tilt == 0.0 ? 2e-3 : 0.02) * plane[0]);
  }
}

// Degrees taken for metres: the whole map is smaller than a grain of dust, and a ball has no foot on it.
TEST(Terrain, MapSmallerThanABallIsGroundThatGoesOn) {
  TerrainParts parts;
  parts.map = map_of(4, 3, 8.3e-6, [](double x, double y) { return x > 0.0 && y > 0.0 ? 2.0 : 0.0; });
  Terrain ground(parts);
  std::vector<Terrain::Foot> feet;
  for (const double z : {-5.0, 0.0, 0.2, 5.0}) ground.feet({0.0, 0.0, z}, 0.3, feet);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(std::isfinite(ground.at(infinite, 0.0).h));
  ground.at(std::nan(""), -infinite);
}

TEST(Terrain, SketchIsTheFieldAtTheNearestSamples) {
  TerrainParts parts = hills();
  Terrain ground(parts);
  const std::vector<double> fine =
      ground.sketch({-6.0, -5.0}, {0.3, 0.4}, {40, 25});  // closer than the samples: the field
  for (std::size_t k = 0; k < fine.size(); ++k)
    EXPECT_EQ(fine[k], ground.at(-6.0 + 0.3 * static_cast<double>(k % 40), -5.0 + 0.4 * static_cast<double>(k / 40)).h);
  const std::vector<double> coarse = ground.sketch({-8.0, -6.0}, {0.7, 0.6}, {24, 20});
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    const double x = -8.0 + 0.7 * static_cast<double>(k % 24), y = -6.0 + 0.6 * static_cast<double>(k / 24);
    EXPECT_NEAR(coarse[k], ground.at(x, y).h,
                ground.inside_map(x, y) ? 0.3 : 1e-12);  // slopes up to 0.8, half a sample away
  }
}

// ---- steep steps ----

// Samples 5 mm apart jump by 0.05 m: what a sharp kerb is in a map.
std::shared_ptr<Terrain> kerb(double rise = 0.05) {
  TerrainParts parts;
  parts.map = map_of(201, 41, 0.005, [rise](double x, double) { return x < 0.0 ? 0.0 : rise; });
  return terrain_of(parts);
}

// The place of the profile at y = 0 nearest to (x, z), by looking at all of them.
Eigen::Vector2d nearest_on(Terrain& ground, double x, double z) {
  Eigen::Vector2d best(0.0, -1.0);
  double least = 1e9;
  const auto look = [&](double from, double to, double apart) {
    for (double u = from; u <= to; u += apart) {
      const double h = ground.at(u, 0.0).h, square = (u - x) * (u - x) + (h - z) * (h - z);
      if (square < least) {
        least = square;
        best = {u, h};
      }
    }
  };
  look(-0.45, 0.45, 1e-4);
  for (double apart = 1e-5; apart > 1e-9; apart *= 0.1) look(best.x() - 20.0 * apart, best.x() + 20.0 * apart, apart);
  return best;
}

// At the start of its climb a wheel touches the edge of the kerb alone. Force and direction belong to the nearest place: along
// (centre - c), so that F_x / F_z = tan(phi), cos(phi) = (R + lift - h_c) / R.
TEST(SteepSteps, PushAWheelAndABallFromTheirEdge) {
  constexpr double R = 0.3, k = 1e7;
  ContactLaw law;
  law.stiffness = k;
  law.friction = 0.0;
  law.stick_time = 0.0;
  for (const bool wheel : {true, false}) {
    for (const double lift : {0.002, 0.01, 0.03, 0.045, 0.05}) {
      const bool wall = lift == 0.05;  // higher than the centre: the nearest place is on its flank
      const auto ground = kerb(wall ? 0.6 : 0.05);
      // Towards the kerb until the nearest place is 0.2 mm inside.
      const double z = R + lift;
      double x = -R - 0.05;
      for (double step = 0.01; step > 1e-10; step *= 0.1)
        while ((nearest_on(*ground, x + step, z) - Eigen::Vector2d(x + step, z)).norm() > R - 2e-4 && x < 0.0)
          x += step;
      const Eigen::Vector2d c = nearest_on(*ground, x, z), centre(x, z), n = (centre - c).normalized();
      const double overlap = R - (centre - c).norm();
      Model model({0.0, 0.0, -kEarth});
      BodyState state;
      state.r = {x, 0.0, z};
      state.L = quaternion_about(Eigen::Vector3d::UnitY(), 0.7);
      model.add_body(Body("round", 2.0, Eigen::Vector3d(0.1, 0.1, 0.1).asDiagonal()), state);
      Eigen::Matrix3d axes;
      axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;
      std::vector<ContactPoint> points;
      std::vector<ContactRim> rims;
      if (wheel)
        rims.push_back({body_marker(0, model.body(0), Eigen::Vector3d::Zero(), axes), R});
      else
        points.push_back({body_marker(0, model.body(0), Eigen::Vector3d::Zero()), R});
      const TerrainContact contact("ground", points, law, ground, rims);
      const Assembly given = test::as_given(model);
      Kinematics kinematics(model);
      kinematics.load(Layout(model), given.state.q, given.state.v, Eigen::VectorXd());
      const Eigen::VectorXd none;
      const Eigen::Matrix<double, 6, 1> wrench =
          contact.wrench(test::OwnScratch(contact).with({kinematics.pair(0, kGround), none, none}));
      const double force = k * std::pow(overlap, 1.5);  // to the 1e-9 m of the search
      EXPECT_NEAR(wrench[0], force * n.x(), 1e-4 * force) << wheel << " " << lift;
      EXPECT_NEAR(wrench[2], force * n.y(), 1e-4 * force) << wheel << " " << lift;
      EXPECT_NEAR(wrench[1], 0.0, 1e-6 * force);
      if (wall) continue;
      const double cosine = (z - c.y()) / R;  // to 2e-4 m / R
      EXPECT_NEAR(-wrench[0] / wrench[2], std::sqrt(1.0 - cosine * cosine) / cosine, 3e-3);
    }
  }
}

// Without friction and damping what it has stays, also where the edge is far sharper than the overlap is deep; on top it has given
// m g h of its motion.
TEST(SteepSteps, AreClimbedByWheelAndBallForMgh) {
  constexpr double R = 0.3, rise = 0.05, m = 2.0;
  for (const bool wheel : {true, false}) {
    Model model({0.0, 0.0, -kEarth});
    BodyState state;
    ContactLaw law;
    law.stiffness = 1e5;
    law.friction = 0.0;
    law.stick_time = 0.0;
    const double sunk = std::pow(m * kEarth / law.stiffness, 2.0 / 3.0);  // 3 mm
    state.r = {-0.4, 0.0, R - sunk};
    state.dr = {2.0, 0.0, 0.0};
    model.add_body(Body("round", m, Eigen::Vector3d(0.1, 0.1, 0.1).asDiagonal()), state);
    Eigen::Matrix3d axes;
    axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    std::vector<ContactPoint> points;
    std::vector<ContactRim> rims;
    if (wheel)
      rims.push_back({body_marker(0, model.body(0), Eigen::Vector3d::Zero(), axes), R});
    else
      points.push_back({body_marker(0, model.body(0), Eigen::Vector3d::Zero()), R});
    model.add_force(std::make_unique<TerrainContact>("ground", points, law, kerb(rise), rims));
    test::Run run(model, "one_step", test::precise(1e-8));
    double highest = 0.0;
    for (int i = 1; i <= 80 && run.body(0).r.x() < 0.3; ++i) {
      run.to(0.01 * i);
      highest = std::max(highest, run.body(0).r.z());
    }
    EXPECT_GT(run.body(0).r.x(), 0.2) << wheel;  // m g h is a quarter of m v^2 / 2
    EXPECT_GT(highest, R + rise - sunk);
    EXPECT_LT(std::abs(run.imbalance()), 3e-4 * run.start_energy()) << wheel;
  }
}

// A kerb that crosses the samples at an angle has an edge of bumps. A ball without friction and damping keeps what it has, at any angle and
// however deep the bumps press into it (5 % of its radius); an edge with one bump per contact gains or loses percents.
TEST(SteepSteps, KeepTheEnergyOfABallAtAnyAngle) {
  constexpr double R = 0.3, rise = 0.06, m = 2.0;
  for (const double degrees : {20.0, 33.0, 45.0}) {
    const double c = std::cos(degrees * kPi / 180.0), s = std::sin(degrees * kPi / 180.0);
    TerrainParts parts;
    parts.map = map_of(61, 61, 0.05, [&](double x, double y) { return c * x + s * y < 0.0 ? 0.0 : rise; });
    Model model({0.0, 0.0, -kEarth});
    BodyState state;
    ContactLaw law;
    law.stiffness = 1e4;
    law.friction = 0.0;
    law.stick_time = 0.0;
    state.r = {-0.5, 0.0, R - std::pow(m * kEarth / law.stiffness, 2.0 / 3.0)};
    state.dr = {2.5, 0.0, 0.0};
    model.add_body(Body("ball", m, Eigen::Vector3d(0.1, 0.1, 0.1).asDiagonal()), state);
    std::vector<ContactPoint> points = {{body_marker(0, model.body(0), Eigen::Vector3d::Zero()), R}};
    model.add_force(
        std::make_unique<TerrainContact>("ground", points, law, terrain_of(parts), std::vector<ContactRim>()));
    test::Run run(model, "one_step", test::precise(1e-8));
    run.to(0.4);
    EXPECT_GT(run.body(0).r.z(), R + 0.5 * rise) << degrees;  // it has met the edge
    EXPECT_LT(std::abs(run.imbalance()), 1e-4 * run.start_energy()) << degrees;
  }
}

// A wheel across a kerb at an angle, of one sample or of three, 20 mm apart.
std::shared_ptr<Terrain> oblique_kerb(double degrees, double rise, int samples) {
  const double c = std::cos(degrees * kPi / 180.0), s = std::sin(degrees * kPi / 180.0);
  TerrainParts parts;
  parts.map = map_of(101, 101, 0.02, [&](double x, double y) {
    const double q = c * x + s * y;
    return samples == 1 ? (q < 0.0 ? 0.0 : rise) : rise * std::clamp(0.5 + q / (0.02 * samples), 0.0, 1.0);
  });
  return terrain_of(parts);
}

struct ObliqueWheel {
  static constexpr double R = 0.3, m = 2.0, stiffness = 1e5;
  ObliqueWheel(double friction, double speed, double lean) : model({0.0, 0.0, -kEarth}) {
    law.stiffness = stiffness;
    law.friction = friction;
    law.stick_time = 0.0;
    BodyState state;
    state.r = {-0.45, 0.0, R - std::pow(m * kEarth / stiffness, 2.0 / 3.0)};
    state.dr = {speed, 0.0, 0.0};
    state.w = {0.0, speed / R, 0.0};
    state.L = quaternion_about(Eigen::Vector3d::UnitX(), lean);
    const double I = 0.5 * m * R * R;
    model.add_body(Body("wheel", m, Eigen::Vector3d(0.5 * I, I, 0.5 * I).asDiagonal()), state);
    Eigen::Matrix3d axes;
    axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    rims.push_back({body_marker(0, model.body(0), Eigen::Vector3d::Zero(), axes), R});
  }
  Model model;
  ContactLaw law;
  std::vector<ContactRim> rims;
};

// Moved along a given way through the kerb, upright and leaning to both sides, up to 40 mm deep: at each step the work of its force is
// what its energy loses. The trapezoid errs by some (step^2 / 12) F'' = 1e-4 J; a place that comes or goes alone makes 0.01 to 1 J.
TEST(SteepSteps, PushAWheelAlongTheSlopeOfItsEnergy) {
  for (const double degrees : {15.0, 30.0, 45.0, 70.0}) {
    for (const double lean : {-0.37, 0.0, 0.26}) {
      ObliqueWheel wheel(0.0, 0.0, lean);
      const TerrainContact contact("ground", {}, wheel.law, oblique_kerb(degrees, 0.05, 1), wheel.rims);
      const test::OwnScratch own(contact);
      const Assembly given = test::as_given(wheel.model);
      Kinematics kinematics(wheel.model);
      const Eigen::VectorXd none;
      constexpr int kSteps = 1500;
      double energy = 0.0, most = 0.0;
      Eigen::Vector3d r, force;
      for (int i = 0; i <= kSteps; ++i) {
        const double x = -0.45 + 0.9 * i / kSteps;
        const Eigen::Vector3d to(x, 0.0, ObliqueWheel::R * std::cos(lean) + 0.025 * std::tanh((x + 0.08) / 0.1) + 0.02);
        Eigen::VectorXd q = given.state.q;
        q.head<3>() = to;
        kinematics.load(Layout(wheel.model), q, given.state.v, Eigen::VectorXd());
        const ElementInput in = own.with({kinematics.pair(0, kGround), none, none});
        StoredEnergy stored{};
        Dissipated power{};
        contact.add_energy(in, stored, power);
        const Eigen::Vector3d now = contact.wrench(in).head<3>();
        if (i > 0) {
          EXPECT_NEAR(stored.total() - energy, -0.5 * (now + force).dot(to - r), 2e-3)
              << degrees << " " << lean << " " << x;
        }
        energy = stored.total();
        EXPECT_GT(energy, -1e-9);  // it never pulls the wheel in
        most = std::max(most, energy);
        r = to;
        force = now;
      }
      EXPECT_GT(most, 0.05) << degrees << " " << lean;
    }
  }
}

// A free wheel, without friction and damping or with friction alone: what it has and gave to friction stays. Steps of one sample and of
// three. What is lost is the error of the integration: it falls with its tolerance.
TEST(SteepSteps, KeepTheEnergyOfAWheelAtAnyAngle) {
  const auto lost = [](double degrees, double friction, int samples, double tolerance) {
    ObliqueWheel wheel(friction, 2.5, 0.0);
    wheel.model.add_force(std::make_unique<TerrainContact>("ground", std::vector<ContactPoint>(), wheel.law,
                                                           oblique_kerb(degrees, 0.03, samples), wheel.rims));
    test::Run run(wheel.model, "one_step", test::precise(tolerance));
    const double moving = 0.75 * ObliqueWheel::m * 2.5 * 2.5, start = run.body(0).r.z();
    double highest = 0.0;
    for (int i = 1; i <= 10; ++i) {
      run.to(0.03 * i);
      highest = std::max(highest, run.body(0).r.z());
    }
    EXPECT_GT(highest, start + 1e-3) << degrees;  // it has met the step
    return std::abs(run.imbalance()) / moving;
  };
  for (const double degrees : {15.0, 30.0, 45.0, 70.0})
    for (const double friction : {0.0, 0.5})
      for (const int samples : {1, 3})
        EXPECT_LT(lost(degrees, friction, samples, 1e-7), 1e-5) << degrees << " " << friction << " " << samples;
  double coarse = 0.0, fine = 0.0;
  for (const double degrees : {15.0, 30.0, 45.0}) {
    coarse += lost(degrees, 0.0, 1, 1e-4) / 3.0;
    fine += lost(degrees, 0.0, 1, 1e-8) / 3.0;
  }
  EXPECT_LT(fine, 0.05 * coarse);  // 1.4e-7 and 2.3e-4
}

// With slip, springs and spin, leaning and oblique to the edge.
TEST(SteepSteps, HaveExactDerivatives) {
  test::Random random(5);
  const auto ground = kerb();
  Model model({0.3, 0.2, -9.0});
  ContactLaw law;
  law.stiffness = 90.0;
  law.damping = 0.4;
  law.friction = 0.3;
  law.slip_speed = 0.2;
  law.stick_time = 0.5;
  for (int i = 0; i < 2; ++i) {
    const Body body = test::random_rigid_body(random, "body_" + std::to_string(i));
    BodyState state = test::random_state(random, body);
    state.r = {-0.15, 0.01 * i, 0.29};
    state.L = quaternion_about(Eigen::Vector3d::UnitX(), 1.45);
    model.add_body(body, state);
    std::vector<ContactPoint> points;
    std::vector<ContactRim> rims;
    if (i == 0)
      rims.push_back({body_marker(i, body, {0.01, 0.0, 0.02}), 0.3});
    else
      points.push_back({body_marker(i, body, {0.01, 0.0, 0.02}), 0.3});
    model.add_force(std::make_unique<TerrainContact>("ground_" + std::to_string(i), points, law, ground, rims));
  }
  expect_exact_jacobian(model, random, 1e-6);  // differences see the corners of bends
}

// ---- soil ----

TEST(SoilOnTerrain, SlopeAloneIsTheTiltedPlane) {
  TerrainParts parts;
  parts.slope = {-0.2, 0.1};
  parts.origin = {0.1, 0.0, 0.05};
  Model models[2] = {Model({0.0, 0.0, -kEarth}), Model({0.0, 0.0, -kEarth})};
  RftParameters sand;
  sand.density = 1600.0;
  sand.friction = 0.5;
  sand.resistance = 8e5;
  sand.rebound = 1e-3;
  for (int i = 0; i < 2; ++i) {
    BodyState state;
    state.r = {0.0, 0.0, 0.3};
    state.dr = {0.4, 0.1, -1.0};
    state.w = {0.3, -0.5, 0.2};
    models[i].add_body(Body("plate", 20.0, Eigen::Matrix3d::Identity()), state);
    std::vector<SoilFacet> facets;
    for (const double x : {-0.1, 0.1}) {
      for (const double y : {-0.1, 0.1}) {
        SoilFacet facet;
        facet.marker = body_marker(0, models[i].body(0), {x, y, -0.05});
        facet.normal = -Eigen::Vector3d::UnitZ();
        facet.area = 0.01;
        facet.start = state.r + Eigen::Vector3d(x, y, -0.05);
        facets.push_back(facet);
      }
    }
    SoilContact::Surface place;
    place.point = parts.origin;
    place.normal = {-parts.slope.x(), -parts.slope.y(), 1.0};
    if (i == 0) place.terrain = terrain_of(parts);
    models[i].add_force(std::make_unique<SoilContact>("soil", facets, false, place, make_rft(sand, ""),
                                                      std::make_shared<const SoilGround>(0.1), true));
  }
  test::Run uneven(models[0]), flat(models[1]);
  for (int k = 1; k <= 8; ++k) {
    uneven.to(0.05 * k, 10);
    flat.to(0.05 * k, 10);
    // Prints are found by x and y of W instead of the plane's, which no facet here needs.
    EXPECT_LT((uneven.body(0).r - flat.body(0).r).norm(), 1e-8) << k;
    EXPECT_LT((uneven.body(0).w - flat.body(0).w).norm(), 1e-6) << k;
  }
  EXPECT_LT(flat.body(0).r.z(), 0.2);
}

}  // namespace
}  // namespace footfall

// Surfaces among grains: which mesh is which body, round facets, contact laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "coupler/base/errors.h"
#include "coupler/schemes/registry.h"
#include "liggghts_fix/link/contact_slope.h"
#include "liggghts_fix/link/dem_body.h"
#include "liggghts_fix/link/mesh_match.h"
#include "liggghts_fix/link/round_surface.h"
#include "liggghts_fix/link/surface_pieces.h"
#include "tests/coupled/stl.h"
#include "tests/support/refused.h"

namespace footfall {
namespace {

struct Mesh {
  Mesh() : surface(test::box({0.4, 0.3, 0.1}, 6)), boundary("pad", surface.nodes, surface.triangles) {
    pose.r = {1.0, -2.0, 0.5};
    pose.L = turned(pose.L, {0.3, -0.7, 1.1});
    x.resize(3, surface.nodes.cols());
    boundary.node_positions(pose, x);
    std::vector<int> order(surface.triangles.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::mt19937 random(51);
    std::shuffle(order.begin(), order.end(), random);
    for (const int t : order) {
      MeshTriangle one;
      one.id = t;
      const auto shift = static_cast<int>(random() % 3);
      for (int k = 0; k < 3; ++k) {
        const int node = surface.triangles[t][(k + shift) % 3];
        one.corners[k] = x.col(node);
        expected.push_back(node);
      }
      triangles.push_back(one);
    }
  }
  test::Surface surface;
  ModalBoundary boundary;
  BodyMotion pose;
  Eigen::Matrix3Xd x;
  std::vector<MeshTriangle> triangles;
  std::vector<int> expected;
};

TEST(MeshMatch, FindsEveryCornerWhateverTheOrder) {
  Mesh mesh;
  const std::vector<CornerNodes> found = match_mesh("m", mesh.boundary, mesh.pose, mesh.triangles);
  ASSERT_EQ(found.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found[i][k], mesh.expected[3 * i + k]);
}

TEST(MeshMatch, AllowsTheRoundingOfAFileWithSixDigits) {
  Mesh mesh;
  for (MeshTriangle& t : mesh.triangles)
    for (Eigen::Vector3d& c : t.corners) c = (c * 1e6).array().round() / 1e6;
  EXPECT_NO_THROW(match_mesh("m", mesh.boundary, mesh.pose, mesh.triangles));
}

TEST(MeshMatch, NamesTheCornerThatIsElsewhere) {
  Mesh mesh;
  mesh.triangles[3].corners[1] += Eigen::Vector3d(0, 0, 1e-4);
  EXPECT_TRUE(test::names(test::error_of([&] { match_mesh("pad1", mesh.boundary, mesh.pose, mesh.triangles); }),
                          {"pad1", "triangle " + std::to_string(mesh.triangles[3].id), "\"pad\""}));
}

TEST(MeshMatch, RefusesATriangleThatTheBodyDoesNotHave) {
  Mesh mesh;
  mesh.triangles[0].corners = {mesh.x.col(0), mesh.x.col(1), mesh.x.col(mesh.x.cols() - 1)};
  EXPECT_THROW(match_mesh("m", mesh.boundary, mesh.pose, mesh.triangles), InputError);
}

TEST(MeshMatch, TrianglesThatShareAPlaceButNoNodeKeepTheirOwnNodes) {
  // Every triangle with nodes of its own, as in an STL file that nobody has welded.
  const test::Surface welded = test::box({0.2, 0.2, 0.2}, 2);
  Eigen::Matrix3Xd nodes(3, static_cast<Eigen::Index>(3 * welded.triangles.size()));
  std::vector<Eigen::Vector3i> triangles;
  std::vector<MeshTriangle> mesh;
  for (std::size_t t = 0; t < welded.triangles.size(); ++t) {
    const int first = static_cast<int>(3 * t);
    triangles.emplace_back(first, first + 1, first + 2);
    MeshTriangle one;
    one.id = static_cast<int>(t);
    for (int k = 0; k < 3; ++k) {
      nodes.col(first + k) = welded.nodes.col(welded.triangles[t][k]);
      one.corners[k] = nodes.col(first + k);
    }
    mesh.push_back(one);
  }
  const ModalBoundary boundary("pad", nodes, triangles);
  const std::vector<CornerNodes> found = match_mesh("m", boundary, BodyMotion(), mesh);
  for (std::size_t t = 0; t < found.size(); ++t)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(found[t][k], static_cast<int>(3 * t) + k);
}

TEST(MeshMatch, RefusesABodyWithoutTriangles) {
  Eigen::Matrix3Xd rho0(3, 2);
  rho0 << 0, 1, 0, 0, 0, 0;
  const ModalBoundary boundary("rod", rho0, {}, {{0, 1, 0.1, 0}});
  EXPECT_THROW(match_mesh("m", boundary, BodyMotion(), {}), InputError);
}

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

// Two right triangles with a common edge of 2 m on the y axis, 1 m wide; the second one folded up by an angle.
std::vector<double> widths(double angle) {
  Eigen::Matrix3Xd nodes(3, 4);
  nodes << 0.0, 0.0, -1.0, std::cos(angle),  //
      0.0, 2.0, 0.0, 0.0,                    //
      0.0, 0.0, 0.0, std::sin(angle);
  return curved_facet_widths(nodes, {{0, 1, 2}, {0, 3, 1}});
}

TEST(FacetWidth, IsTheSmallestHeightWhereTheSurfaceIsCurved) {
  for (const double angle : {0.01, 0.1, -0.3, 1.0})
    for (const double width : widths(angle)) EXPECT_NEAR(width, 2.0 / std::sqrt(5.0), 1e-15);  // 2 area / longest edge
}

TEST(FacetWidth, OfFlatFacetsAndOfSharpEdgesDoesNotMatter) {
  for (const double angle : {0.0, 0.004, 0.5 * M_PI})
    for (const double width : widths(angle)) EXPECT_TRUE(std::isinf(width)) << angle;
}

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A triangle on the unit sphere, about w [rad] wide.
Matrix3d on_sphere(double w) {
  Matrix3d x;
  x.col(0) = Vector3d(0.4 * w, -0.5 * w, 1.0).normalized();
  x.col(1) = Vector3d(0.3 * w, 0.5 * w, 1.0).normalized();
  x.col(2) = Vector3d(-0.6 * w, 0.1 * w, 1.0).normalized();
  return x;
}

// Largest distance from the sphere over the facet [m].
double error(double w) {
  const RoundFacet facet(on_sphere(w), on_sphere(w));
  double worst = 0.0;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; i + j <= 20; ++j) worst = std::max(worst, std::abs(facet.at(i / 20.0, j / 20.0).norm() - 1.0));
  return worst;
}

TEST(RoundFacet, IsASphereToFourthOrder) {
  const double coarse = error(0.4), fine = error(0.2);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3);
  EXPECT_LT(coarse, std::pow(0.4, 4) / 64.0);
}

TEST(RoundFacet, NoPointIsNearerThanTheNearestInsideAndOutsideOfTheBall) {
  const RoundFacet facet(on_sphere(0.5), on_sphere(0.5));
  for (const double height : {0.2, 0.7, 1.2, 3.0}) {
    const Vector3d inner = height * Vector3d(0.03, 0.02, 1.0).normalized();
    const RoundFacet::Nearest found = facet.nearest(inner);
    // No point of a fine grid is closer.
    double least = 1e300;
    for (int i = 0; i <= 200; ++i)
      for (int j = 0; i + j <= 200; ++j) least = std::min(least, (facet.at(i / 200.0, j / 200.0) - inner).norm());
    EXPECT_LE((found.point - inner).norm(), least + 1e-12) << height;
  }
  const Vector3d aside(2.0, 0.1, 1.0);
  double least = 1e300;
  for (int i = 0; i <= 200; ++i)
    for (int j = 0; i + j <= 200; ++j) least = std::min(least, (facet.at(i / 200.0, j / 200.0) - aside).norm());
  EXPECT_LE((facet.nearest(aside).point - aside).norm(), least + 1e-12);
}

// A plate 10 m long whose end is rounded by facets of 0.1 m.
TEST(RoundSurface, ALargeFlatFaceStaysFlatBesideANarrowRounding) {
  Eigen::Matrix3Xd nodes(3, 6);
  nodes << 0, 10, 10.099, 0, 10, 10.099,  //
      0, 0, 0, 10, 10, 10,                //
      0, 0, -0.02, 0, 0, -0.02;
  const SurfacePieces pieces(nodes, {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}, 0.5);
  const RoundSurface surface(pieces, nodes);
  Matrix3d corners;
  corners << nodes.col(0), nodes.col(1), nodes.col(4);
  EXPECT_LT(surface.facet(0, corners).largest_bulge(), 0.1 * 0.2);
  EXPECT_TRUE(surface.is_flat(1) || surface.facet(1, corners).largest_bulge() < 0.02);
}

constexpr double kEdge = 30.0 * M_PI / 180.0;

// A strip of squares of 1 m along y, each of two triangles (2 i and 2 i + 1), that turns by an angle at each of its lines.
SurfacePieces strip(const std::vector<double>& turns) {
  const std::size_t squares = turns.size() + 1;
  Eigen::Matrix3Xd nodes(3, 2 * static_cast<Eigen::Index>(squares) + 2);
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  double angle = 0.0;
  std::vector<CornerNodes> corners;
  for (std::size_t i = 0; i <= squares; ++i) {
    const int a = 2 * static_cast<int>(i);
    nodes.col(a) = at;
    nodes.col(a + 1) = at + Eigen::Vector3d::UnitY();
    if (i == squares) break;
    corners.push_back({a, a + 2, a + 3});
    corners.push_back({a, a + 3, a + 1});
    at += Eigen::Vector3d(std::cos(angle), 0.0, std::sin(angle));
    if (i < turns.size()) angle += turns[i];
  }
  return {nodes, corners, kEdge};
}

TEST(SurfacePieces, EndAtSharpEdges) {
  const SurfacePieces pieces = strip({0.2, 0.9, -0.4});
  EXPECT_TRUE(pieces.curved());
  EXPECT_EQ(pieces.piece(0), pieces.piece(3));
  EXPECT_NE(pieces.piece(3), pieces.piece(4));
  EXPECT_EQ(pieces.piece(4), pieces.piece(7));
  EXPECT_TRUE(pieces.are_neighbours(0, 2));
  EXPECT_FALSE(pieces.are_neighbours(0, 4)) << "two squares on";
  EXPECT_FALSE(pieces.are_neighbours(2, 4)) << "across the sharp edge";
}

TEST(SurfacePieces, OfFlatFacesAreNotCurved) {
  EXPECT_FALSE(strip({0.0, 0.5 * M_PI, 0.0}).curved());
  EXPECT_FALSE(strip({M_PI}).curved()) << "folded back on itself";
  EXPECT_TRUE(strip({1e-3}).curved()) << "fine facets turn by little";
}

TEST(SurfacePieces, KnowTheirBorders) {
  const SurfacePieces pieces = strip({0.2, 0.9});
  EXPECT_TRUE(pieces.inside_piece(0, {0.2, 0.3, 0.5}));
  EXPECT_TRUE(pieces.inside_piece(0, {0.0, 0.5, 0.5})) << "a smooth edge";
  EXPECT_TRUE(pieces.inside_piece(0, {0.5, 0.0, 0.5})) << "the diagonal";
  EXPECT_FALSE(pieces.inside_piece(0, {0.5, 0.5, 0.0})) << "the border of the mesh";
  EXPECT_FALSE(pieces.inside_piece(0, {0.0, 1.0, 0.0})) << "a corner on the border";
  EXPECT_FALSE(pieces.inside_piece(2, {0.0, 0.5, 0.5})) << "the sharp edge";
}

FacetTouch touch(int facet, double gap) {
  FacetTouch touch;
  touch.facet = facet;
  touch.gap = gap;
  return touch;
}

TEST(SurfacePieces, TheNearestOfNeighboursIsTouched) {
  const SurfacePieces pieces = strip({0.2, 0.9});
  const FacetTouch near = touch(0, -2e-3), far = touch(2, -1e-3), beyond = touch(4, -3e-3);
  EXPECT_TRUE(yields_to(far, near, pieces));
  EXPECT_FALSE(yields_to(near, far, pieces));
  EXPECT_FALSE(yields_to(far, beyond, pieces)) << "another piece";
  const FacetTouch same = touch(2, near.gap);
  EXPECT_TRUE(yields_to(same, near, pieces)) << "the smaller number of two";
  EXPECT_FALSE(yields_to(near, same, pieces));
  FacetTouch silent = near;
  silent.acts = false;
  EXPECT_TRUE(yields_to(silent, same, pieces)) << "of two that are equally close, LIGGGHTS' choice";
}

TEST(SurfacePieces, OfFlatFacesLeaveSharpEdgesToLiggghts) {
  FacetTouch near = touch(0, -2e-3);
  const FacetTouch far = touch(2, -1e-3);
  near.on_border = true;
  EXPECT_TRUE(yields_to(far, near, strip({0.2})));
  EXPECT_FALSE(yields_to(far, near, strip({0.0})));
  near.on_border = false;
  EXPECT_TRUE(yields_to(far, near, strip({0.0}))) << "a crease may open";
}

constexpr double kWallRoundOff = 1e-14;  // of a few products and roots

// Equal materials: E* = E / (2 (1 - nu^2)), G* = G / (2 (2 - nu)) with G = E / (2 (1 + nu)).
TEST(WallContact, EqualMaterialsGiveTheKnownModuli) {
  const ElasticConstants m{6e6, 0.3};
  const WallContact contact = hertz_mindlin(m, m);
  EXPECT_NEAR(contact.young, 6e6 / (2.0 * (1.0 - 0.09)), kWallRoundOff * 6e6);
  EXPECT_NEAR(contact.shear, 6e6 / (2.0 * 1.3) / (2.0 * 1.7), kWallRoundOff * 6e6);
}

TEST(WallContact, GrainAndWallMayChangePlaces) {
  const ElasticConstants grain{6e6, 0.3}, wall{1e9, 0.25};
  EXPECT_NEAR(hertz_mindlin(grain, wall).young, hertz_mindlin(wall, grain).young, kWallRoundOff * 6e6);
  EXPECT_NEAR(hertz_mindlin(grain, wall).shear, hertz_mindlin(wall, grain).shear, kWallRoundOff * 6e6);
}

// F = 4/3 E* sqrt(R) delta^(3/2), so dF/ddelta = 2 E* sqrt(R delta).
TEST(WallContact, StiffnessIsTheDerivativeOfHertzForce) {
  const WallContact contact = hertz_mindlin({6e6, 0.3}, {1e9, 0.25});
  const double radius = 0.004, overlap = 1e-5, step = 1e-9;
  const auto force = [&](double delta) { return 4.0 / 3.0 * contact.young * std::sqrt(radius) * std::pow(delta, 1.5); };
  const double difference = (force(overlap + step) - force(overlap - step)) / (2.0 * step);
  const double kDifference = 1e-8;  // (step / overlap)^2 / 24, and round-off over step
  EXPECT_NEAR(contact.stiffness(std::sqrt(radius * overlap)), difference, kDifference * difference);
}

TEST(WallContact, PerfectBounceIsNotDamped) {
  EXPECT_EQ(damping_of_restitution(1.0), 0.0);
  EXPECT_GT(damping_of_restitution(0.5), damping_of_restitution(0.8));
}

TEST(WallContact, SlidesAtTheCoulombLimitAndSticksBelow) {
  WallContact contact = hertz_mindlin({6e6, 0.3}, {1e9, 0.25});
  contact.friction = 0.5;
  contact.damping = damping_of_restitution(0.6);
  const double s = 2e-4, mass = 1e-3;
  const Eigen::Vector3d n(0.0, 0.0, 1.0);
  const ContactSlope sticks = contact.slope(n, {0.4, 0.0, -1.0}, s, mass);
  EXPECT_EQ(sticks.stiffness, contact.stiffness(s));
  EXPECT_EQ(sticks.shear_stiffness, 8.0 * contact.shear * s);
  EXPECT_EQ(sticks.damping, contact.damping * std::sqrt(sticks.stiffness * mass));
  EXPECT_EQ(sticks.shear_damping, contact.damping * std::sqrt(sticks.shear_stiffness * mass));
  const ContactSlope slides = contact.slope(n, {0.5, 0.0, -1.0}, s, mass);
  EXPECT_EQ(slides.stiffness, sticks.stiffness);
  EXPECT_EQ(slides.shear_stiffness, 0.0);
  EXPECT_EQ(slides.shear_damping, 0.0);
}

TEST(WallContact, LinearSpringHasTheScriptsConstantsAtAnyOverlap) {
  WallContact contact;
  contact.linear = 1000.0;
  contact.linear_shear = 300.0;
  contact.linear_damping = 20.0;
  contact.linear_shear_damping = 5.0;
  contact.friction = 1.0;
  const ContactSlope slope = contact.slope(Eigen::Vector3d::UnitZ(), {0.0, 0.0, -1.0}, 1e-3, 0.5);
  EXPECT_EQ(slope.stiffness, 1000.0);
  EXPECT_EQ(slope.shear_stiffness, 300.0);
  EXPECT_EQ(slope.damping, 10.0);  // per mass of the grain
  EXPECT_EQ(slope.shear_damping, 2.5);
}

// Slopes of contacts, projected on a body: liggghts_fix/link/dem_body.h.

CoupledBody triangle() {
  Eigen::Matrix3Xd rho0(3, 3);
  rho0 << 0, 1, 0, 0, 0, 1, 0, 0, 0;
  BodyMotion initial;
  initial.r = {0.3, -0.2, 0.5};
  return {ModalBoundary("body", rho0, {{0, 1, 2}}), initial};
}

// The window's mean slopes of one contact that lasts all the time.
ContactTangent slopes_of(const CoupledBody& body, const Eigen::Vector3d& point, const ContactSlope& slope) {
  const std::unique_ptr<Scheme> scheme = make_scheme("tangent");
  DemBody dem(body, *scheme);
  dem.begin_window(body.initial, 2, 1e-3);
  for (int i = 0; i < 2; ++i) {
    dem.advance();
    dem.clear_contacts();
    dem.add_slope(point, slope);
    dem.end_substep(1e-3);
  }
  std::vector<double> row;
  dem.append_share(row);
  dem.clear_load();
  dem.add_share(row.data());
  return dem.load().tangent.at(0);
}

TEST(ContactSlope, IsTheDerivativeOfTheWrenchOfASpringAtThePoint) {
  const CoupledBody body = triangle();
  const Eigen::Vector3d point(0.5, 0.1, 0.6);
  ContactSlope slope;
  slope.normal_W = Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0;
  slope.stiffness = 1000.0;
  slope.shear_stiffness = 300.0;
  slope.damping = 5.0;
  slope.shear_damping = 1.0;
  const ContactTangent tangent = slopes_of(body, point, slope);

  const Eigen::Vector3d rho = point - body.initial.r;
  const Eigen::Matrix3d along = slope.normal_W * slope.normal_W.transpose();
  const Eigen::Matrix3d k = 1000.0 * along + 300.0 * (Eigen::Matrix3d::Identity() - along);
  const Eigen::Matrix3d c = 5.0 * along + 1.0 * (Eigen::Matrix3d::Identity() - along);
  for (int j = 0; j < 6; ++j) {
    // A small motion of the body moves the point by dr + dtheta x rho; the springs answer there.
    const Eigen::Matrix<double, 6, 1> unit = Eigen::Matrix<double, 6, 1>::Unit(j);
    const Eigen::Vector3d moved = unit.head<3>() + unit.tail<3>().cross(rho);
    Eigen::Matrix<double, 6, 1> by_k, by_c;
    by_k << k * moved, rho.cross(k * moved);
    by_c << c * moved, rho.cross(c * moved);
    EXPECT_LT((tangent.K.col(j) - by_k).norm(), 1e-10 * tangent.K.norm());
    EXPECT_LT((tangent.C.col(j) - by_c).norm(), 1e-10 * tangent.C.norm());
  }
}

TEST(ContactSlope, IsNotCollectedForSchemesThatDoNotAsk) {
  const CoupledBody body = triangle();
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  const DemBody dem(body, *scheme);
  EXPECT_FALSE(dem.samples_slopes());
  EXPECT_TRUE(dem.load().tangent.empty());
  // F, T, impulse: 3 each; two works, two contacts, stiffness, overlap, patch, and what else DemBody::write_share names
  EXPECT_EQ(dem.share_size(), 22U);
}

}  // namespace
}  // namespace footfall

// Bodies on meshes, on each other: closed forms, conservation, and the plane as the other route.

#include "mbd_solver/model/elements/surface_contact.h"

#include <cmath>

#include "mbd_solver/model/mass_properties.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

constexpr double kRadius = 0.1;

int add_ball(Model& model, const std::string& name, const BodyState& state, double mass = 2.0) {
  const MassProperties sphere = with_mass(sphere_properties(kRadius, 1.0), mass);
  return model.add_body(Body(name, sphere.mass, sphere.inertia), state);
}

ContactPoint centre(const Model& model, int body) {
  return {body_marker(body, model.body(body), Eigen::Vector3d::Zero()), kRadius};
}

ContactLaw law() {
  ContactLaw law;
  law.stiffness = 1e6;
  law.damping = 0.2;
  law.friction = 0.4;
  return law;
}

std::shared_ptr<const SurfaceSeen> seen(ContactSurface surface, const Eigen::Vector3d& from) {
  auto out = std::make_shared<SurfaceSeen>();
  double across = 0.0;
  out->sides = surface.sides_of({from}, across);
  out->surface = std::make_shared<ContactSurface>(std::move(surface));
  return out;
}

// A flat floor z = 0 of many triangles, turned this way and that.
ContactSurface floor_mesh() {
  constexpr int kCells = 20;
  constexpr double kCell = 0.05;
  Eigen::Matrix3Xd vertices(3, (kCells + 1) * (kCells + 1));
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j)
      vertices.col(i * (kCells + 1) + j) << (i - kCells / 2) * kCell, (j - kCells / 2) * kCell, 0.0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const int a = i * (kCells + 1) + j, b = a + kCells + 1;
      triangles.emplace_back(a, b, b + 1);
      if ((i + j) % 3 == 0)
        triangles.emplace_back(a, a + 1, b + 1);
      else
        triangles.emplace_back(a, b + 1, a + 1);
    }
  }
  ContactSurface surface;
  surface.add_triangles(vertices, triangles);
  return surface;
}

// Steps that do not ask how many inner states there are: two routes then differ by round-off and what Newton leaves.
IntegratorOptions even_steps() {
  IntegratorOptions options = test::tight(1e-11);
  options.error_control = false;
  options.max_step = 5e-5;
  return options;
}

BodyState thrown() {
  BodyState state;
  state.r = {-0.31, -0.17, kRadius + 0.02};
  state.dr = {0.9, 0.4, -0.5};
  state.w = {1.0, -2.0, 3.0};
  return state;
}

TEST(SurfaceContact, BallOnAMeshFloorMovesAsOnThePlane) {
  Model on_mesh({0.0, 0.0, -9.81}), on_plane({0.0, 0.0, -9.81});
  for (Model* model : {&on_mesh, &on_plane}) add_ball(*model, "ball", thrown());
  RigidPlane::Parameters plane;
  static_cast<ContactLaw&>(plane) = law();
  on_plane.add_force(std::make_unique<RigidPlane>("plane", std::vector<ContactPoint>{centre(on_plane, 0)}, plane));
  SurfaceContact::Side side{0, {centre(on_mesh, 0)}, seen(floor_mesh(), thrown().r), 0.01};
  on_mesh.add_force(
      std::make_unique<SurfaceContact>("floor", 0, kGround, std::vector<SurfaceContact::Side>{side}, law()));
  test::Run mesh(on_mesh, "one_step", even_steps()), flat(on_plane, "one_step", even_steps());
  for (int k = 1; k <= 20; ++k) {  // it hops, slides, and rolls over some eight edges
    mesh.to(0.03 * k);
    flat.to(0.03 * k);
    EXPECT_LT((mesh.body(0).r - flat.body(0).r).norm(), 1e-9) << k;
    EXPECT_LT((mesh.body(0).dr - flat.body(0).dr).norm(), 1e-9) << k;
    EXPECT_LT((mesh.body(0).w - flat.body(0).w).norm(), 1e-8) << k;
  }
  EXPECT_GT((flat.body(0).r - thrown().r).head<2>().norm(), 0.35);
  EXPECT_LT(std::abs(mesh.imbalance()), 1e-4 * mesh.start_energy());  // of the steps
}

TEST(SurfaceContact, CornerOfABodyOnAMeshFloorMovesAsOnThePlane) {
  // Points without radius, from below the mesh's own idea of its upper side.
  Model on_mesh({0.0, 0.0, -9.81}), on_plane({0.0, 0.0, -9.81});
  std::vector<ContactPoint> points[2];
  Model* const models[2] = {&on_mesh, &on_plane};
  for (int i = 0; i < 2; ++i) {
    BodyState state = thrown();
    state.w *= 0.3;
    models[i]->add_body(Body("block", 2.0, 0.01 * Eigen::Matrix3d::Identity()), state);
    for (const double x : {-0.08, 0.08})
      for (const double y : {-0.08, 0.08})
        points[i].push_back({body_marker(0, models[i]->body(0), {x, y, -kRadius}), 0.0});
  }
  RigidPlane::Parameters plane;
  static_cast<ContactLaw&>(plane) = law();
  on_plane.add_force(std::make_unique<RigidPlane>("plane", points[1], plane));
  SurfaceContact::Side side{0, points[0], seen(floor_mesh(), thrown().r), 0.01};
  on_mesh.add_force(
      std::make_unique<SurfaceContact>("floor", 0, kGround, std::vector<SurfaceContact::Side>{side}, law()));
  test::Run mesh(on_mesh, "one_step", even_steps()), flat(on_plane, "one_step", even_steps());
  for (int k = 1; k <= 10; ++k) {
    mesh.to(0.03 * k);
    flat.to(0.03 * k);
    EXPECT_LT((mesh.body(0).r - flat.body(0).r).norm(), 1e-9) << k;
    EXPECT_LT((mesh.body(0).w - flat.body(0).w).norm(), 1e-7) << k;
  }
}

// Two balls, the second as the surface of a ball.
struct TwoBalls {
  TwoBalls(const BodyState& first, const BodyState& second, const ContactLaw& contact_law) {
    add_ball(model, "a", first, 2.0);
    add_ball(model, "b", second, 3.0);
    ContactSurface ball;
    ball.add_capsule(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), kRadius);
    SurfaceContact::Side side{0, {centre(model, 0)}, seen(std::move(ball), Eigen::Vector3d::UnitX()), 0.01};
    model.add_force(
        std::make_unique<SurfaceContact>("pair", 0, 1, std::vector<SurfaceContact::Side>{side}, contact_law));
  }
  Eigen::Vector3d momentum(test::Run& run) const { return 2.0 * run.body(0).dr + 3.0 * run.body(1).dr; }
  // About the origin.
  Eigen::Vector3d turning(test::Run& run) const {
    Eigen::Vector3d L = Eigen::Vector3d::Zero();
    for (int i = 0; i < 2; ++i) {
      const BodyKinematics body = run.body(i);
      const Body& inertia = model.body(i);
      L += inertia.mass() * body.r.cross(body.dr) + body.A * inertia.rigid_inertia() * body.A.transpose() * body.w;
    }
    return L;
  }
  Model model;
};

TEST(SurfaceContact, TwoBallsPartWithTheirRestitutionAndTheMomentumTheyHad) {
  for (const double e : {1.0, 0.7, 0.4}) {
    BodyState first, second;
    second.r = {2.0 * kRadius + 0.01, 0.0, 0.0};
    first.dr = {1.3, 0.0, 0.0};
    second.dr = {-0.2, 0.0, 0.0};
    ContactLaw contact = law();
    contact.damping = contact_damping_for_restitution(e, 1.5);
    TwoBalls balls(first, second, contact);
    test::Run run(balls.model, "one_step", test::tight(1e-9));
    run.to(0.03, 3);
    EXPECT_NEAR(run.body(1).dr.x() - run.body(0).dr.x(), 1.5 * e, 1e-5) << e;  // tolerance over the impact
    EXPECT_LT((balls.momentum(run) - Eigen::Vector3d(2.0, 0.0, 0.0)).norm(), 1e-13) << e;
    EXPECT_LT(std::abs(run.imbalance()), 1e-5 * run.start_energy());  // of the method
  }
}

TEST(SurfaceContact, ObliqueImpactConservesBothMomenta) {
  BodyState first, second;
  second.r = {2.0 * kRadius, 0.09, 0.05};
  second.L = quaternion_about({1.0, 2.0, 3.0}, 0.8);
  first.dr = {1.3, 0.2, -0.1};
  first.w = {3.0, -20.0, 5.0};
  second.w = {-10.0, 2.0, 1.0};
  TwoBalls balls(first, second, law());
  test::Run run(balls.model, "one_step", test::tight(1e-10));
  const Eigen::Vector3d P = balls.momentum(run), L = balls.turning(run);
  run.to(0.3, 3);
  EXPECT_GT((run.body(1).dr - second.dr).norm(), 0.5);
  EXPECT_LT((balls.momentum(run) - P).norm(), 1e-13);
  EXPECT_LT((balls.turning(run) - L).norm(), 1e-7);  // of the method; the forces have no moment
  EXPECT_LT(std::abs(run.imbalance()), 1e-6 * run.start_energy());
}

TEST(SurfaceContact, ForceHasNoJumpWhereFacesMeet) {
  // A ball over a roof of two faces, 40 degrees apart, along a way across the ridge.
  for (const double side_of_roof : {1.0, -1.0}) {  // from outside: a ridge; from below: a groove
    ContactSurface roof;
    Eigen::Matrix3Xd vertices(3, 4);
    vertices << 0.0, 0.0, -1.0, 1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0, -0.36, -0.36;
    roof.add_triangles(vertices, {{0, 1, 2}, {0, 1, 3}});
    std::vector<NearTriangle> near;
    std::vector<SurfaceTouch> touches;
    Eigen::Vector3d last = Eigen::Vector3d::Zero();
    for (int k = -400; k <= 400; ++k) {
      const double x = 1e-4 * k;
      const Eigen::Vector3d p(x, 0.01, side_of_roof > 0.0 ? 0.095 : -0.105 - 0.1 * std::abs(x));
      roof.touches(p, kRadius, 0.01, {1.0}, near, touches);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const SurfaceTouch& touch : touches) sum += (kRadius - touch.distance) * touch.normal;
      if (k > -400) {
        EXPECT_LT((sum - last).norm(), 2e-4) << "x = " << x;
      }
      last = sum;
    }
  }
}

}  // namespace
}  // namespace footfall

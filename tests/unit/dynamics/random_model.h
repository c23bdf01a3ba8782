#pragma once
// Bodies and models for tests: seeded random numbers, a flexible body made by hand, and one model that holds
// a specimen of every joint and every force element between rigid and flexible bodies.

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/model/elements/bushing.h"
#include "mbd_solver/model/elements/cable.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/gear.h"
#include "mbd_solver/model/elements/rigid_plane.h"
#include "mbd_solver/model/elements/soil_contact.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/elements/surface_contact.h"
#include "mbd_solver/model/elements/terrain_contact.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/model.h"
#include "tests/support/linear_algebra.h"

namespace footfall::test {

// What is drawn for the arguments of one call is drawn before it, the last one first: compilers differ in the order in
// which they evaluate arguments, and every one of them shall test the same models.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) { ::testing::Test::RecordProperty("seed", static_cast<int>(seed)); }
  double number(double low = -1.0, double high = 1.0) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Eigen::Vector3d vector(double size = 1.0) {
    const double z = number(), y = number(), x = number();
    return size * Eigen::Vector3d(x, y, z);
  }
  Eigen::VectorXd vector_x(Eigen::Index n, double size = 1.0) {
    Eigen::VectorXd x(n);
    for (Eigen::Index i = 0; i < n; ++i) x[i] = size * number();
    return x;
  }
  Eigen::Vector4d quaternion() {
    const double z = number() + 1.5, y = number(), x = number(), w = number();
    return Eigen::Vector4d(w, x, y, z).normalized();
  }
  Eigen::Matrix3d axes() { return rotation_matrix(quaternion()); }
  Eigen::Matrix3d inertia(double size = 1.0) {
    const Eigen::Matrix3d A = axes();
    const double z = number(1.7, 2.0), y = number(1.4, 1.6), x = number(1.0, 1.3);
    return size * A * Eigen::Vector3d(x, y, z).asDiagonal() * A.transpose();
  }

 private:
  std::mt19937 engine_;
};

// A few masses with rotary inertia held together by a random elastic law that knows no rigid-body strain.
// Exact in all properties a ModalBody promises: mean axes, mass-orthonormal modes, Bo at the mass centre.
inline std::shared_ptr<ModalBody> hand_made_body(Random& random, int nodes, int modes, double stiffness = 500.0,
                                                 double damping_ratio = 0.0) {
  auto body = std::make_shared<ModalBody>();
  body->name = "hand made";
  body->rho0.resize(3, nodes);
  body->node_mass.resize(nodes);
  for (int j = 0; j < nodes; ++j) {
    body->rho0.col(j) = random.vector();
    body->node_mass[j] = random.number(0.5, 2.0);
    body->node_inertia.push_back(random.inertia(0.05));
  }
  const Eigen::Vector3d centre = body->rho0 * body->node_mass / body->node_mass.sum();
  body->rho0.colwise() -= centre;

  // M, the six rigid motions R, and K = P^T X P with P the projection along R.
  const int n = 6 * nodes;
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n), R = Eigen::MatrixXd::Zero(n, 6);
  for (int j = 0; j < nodes; ++j) {
    M.block<3, 3>(6 * j, 6 * j) = body->node_mass[j] * Eigen::Matrix3d::Identity();
    M.block<3, 3>(6 * j + 3, 6 * j + 3) = body->node_inertia[static_cast<std::size_t>(j)];
    R.block<3, 3>(6 * j, 0).setIdentity();
    R.block<3, 3>(6 * j, 3) = -skew(body->rho0.col(j));
    R.block<3, 3>(6 * j + 3, 3).setIdentity();
  }
  const Eigen::MatrixXd P = Eigen::MatrixXd::Identity(n, n) - R * solve(R.transpose() * M * R, R.transpose() * M);
  Eigen::MatrixXd X(n, n);
  for (int i = 0; i < n; ++i) X.col(i) = random.vector_x(n);
  const Eigen::MatrixXd K = stiffness * P.transpose() * (X * X.transpose() + Eigen::MatrixXd::Identity(n, n)) * P;
  const EigenPairs eigen = symmetric_modes(0.5 * (K + K.transpose()), M);
  const Eigen::MatrixXd shapes = eigen.vectors.middleCols(6, modes);  // the six zero frequencies come first
  body->stiffness = eigen.values.segment(6, modes);
  body->damping = 2.0 * damping_ratio * body->stiffness.cwiseSqrt();
  body->Phi.resize(3 * nodes, modes);
  body->Psi.resize(3 * nodes, modes);
  for (int j = 0; j < nodes; ++j) {
    body->Phi.middleRows(3 * j, 3) = shapes.middleRows(6 * j, 3);
    body->Psi.middleRows(3 * j, 3) = shapes.middleRows(6 * j + 3, 3);
  }
  return body;
}

// A law with an inner state and every partial derivative different from zero: F = k x^3 + c v + b z U, dz = x
// - 2 v z.
class CoupledLaw : public StrutLaw {
 public:
  std::string_view kind() const override { return "coupled"; }
  int state_count() const override { return 1; }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Constant(1, 0.3); }
  void evaluate(const StrutInput& in, StrutOutput& out) const override {
    const double x = in.stroke, v = in.rate, z = in.z[0];
    out.force = 40.0 * x * x * x + 3.0 * v + 5.0 * z * in.voltage;
    out.dforce_dstroke = 120.0 * x * x;
    out.dforce_drate = 3.0;
    out.dforce_dz[0] = 5.0 * in.voltage;
    out.dz[0] = x - 2.0 * v * z;
    out.ddz_dstroke[0] = 1.0;
    out.ddz_drate[0] = -2.0 * z;
    out.ddz_dz(0, 0) = -2.0 * v;
  }
  double stored_energy(const StrutInput& in) const override { return 10.0 * std::pow(in.stroke, 4); }
  void dissipated_power(const StrutInput&, std::vector<StrutPower>&) const override {}
};

inline BodyState random_state(Random& random, const Body& body) {
  BodyState state;
  state.r = random.vector();
  state.L = random.quaternion();
  state.dr = random.vector();
  state.w = random.vector(2.0);
  state.a = random.vector_x(body.mode_count(), 0.1);
  state.da = random.vector_x(body.mode_count());
  return state;
}

inline Body random_rigid_body(Random& random, const std::string& name) {
  const Eigen::Matrix3d inertia = random.inertia();
  return Body(name, random.number(1.0, 3.0), inertia);
}

// Four bodies, two of them flexible.
inline Model random_bodies(Random& random, const Eigen::Vector3d& gravity = {0.3, -0.4, -9.0}) {
  Model model(gravity);
  const int modes[4] = {0, 3, 0, 2};
  for (int i = 0; i < 4; ++i) {
    const std::string name = "body_" + std::to_string(i);
    const Body body =
        modes[i] == 0 ? random_rigid_body(random, name) : Body(name, hand_made_body(random, 4, modes[i], 500.0, 0.05));
    model.add_body(body, random_state(random, body));
  }
  return model;
}

// A marker anywhere: at a node with an offset on flexible bodies.
inline Marker random_marker(Random& random, const Model& model, int body) {
  const Eigen::Matrix3d axes = random.axes();
  const bool flexible = body != kGround && model.body(body).mode_count() > 0;
  const Eigen::Vector3d place = random.vector(flexible ? 0.3 : 1.0);
  if (body == kGround) return ground_marker(place, axes);
  if (!flexible) return body_marker(body, model.body(body), place, axes);
  return node_marker(body, model.body(body), static_cast<int>(random.number(0.0, 3.99)), place, axes);
}

struct MarkerPair {
  Marker m1, m2;
};
inline MarkerPair random_markers(Random& random, const Model& model, int body_1, int body_2) {
  const Marker m2 = random_marker(random, model, body_2);
  return {random_marker(random, model, body_1), m2};
}

// One of each kind of joint between the given bodies; far from closed, which derivatives do not mind.
inline std::vector<Joint> all_joints(Random& random, const Model& model, int body_1, int body_2) {
  PrescribedMotion driven;
  driven.translation = {polynomial({0.1, 0.2, -0.3}), nullptr, sine(0.3, 0.7, 0.2)};
  driven.rotation = sum({sine(1.2, 0.4, 0.1), polynomial({0.2, 1.5, 0.4})});
  driven.rotation_axis = 1;
  driven.hold_other_rotations = true;
  const std::string tail = "_" + std::to_string(body_1) + "_" + std::to_string(body_2);
  const auto joint = [&](auto make, const std::string& name, auto... more) {
    const MarkerPair markers = random_markers(random, model, body_1, body_2);
    return make(name + tail, markers.m1, markers.m2, more...);
  };
  return {joint(fixed_joint, "fixed"),
          joint(spherical_joint, "spherical"),
          joint(universal_joint, "universal"),
          joint(revolute_joint, "revolute"),
          joint(prismatic_joint, "prismatic"),
          joint(cylindrical_joint, "cylindrical"),
          joint(distance_joint, "distance", 1.3),
          joint(point_on_plane_joint, "plane", 0.2),
          joint(planar_joint, "planar"),
          joint(constant_velocity_joint, "constant_velocity"),
          joint(rolling_joint, "rolling", 0.4, true),
          joint(prescribed_joint, "driven", driven)};
}

// Places of one body that touch each kind of surface, on a rigid body or standing still: a capsule (side and end), and the
// face, an edge and a corner of triangles, from outside and from within.
inline std::unique_ptr<ForceElement> surface_contact(const Model& model, const std::string& name, int body_1,
                                                     int body_2, const ContactLaw& law) {
  Random random(41);  // of its own: what others draw stays
  const bool turned = body_1 == kGround;
  const int with_places = turned ? body_2 : body_1;
  int with_surface = turned ? body_1 : body_2;
  int places_on = with_places;
  if (with_surface != kGround && model.body(with_surface).mode_count() > 0) {
    places_on = model.body(with_places).mode_count() > 0 ? with_places : with_surface;
    with_surface = places_on == with_surface ? with_places : kGround;
  }
  ContactSurface surface;
  SurfaceContact::Side side;
  std::vector<Eigen::Vector3d> corners;
  std::vector<Eigen::Vector3i> triangles;
  for (int k = 0; k < 6; ++k) {
    const double radius = k == 5 ? 0.0 : 0.3;
    const Marker marker = random_marker(random, model, places_on);
    side.points.push_back({marker, radius});
    Eigen::Vector3d p = model.initial_position(marker);
    if (with_surface != kGround) {
      const BodyState& state = model.initial(with_surface);
      p = rotation_matrix(state.L).transpose() * (p - state.r);
    }
    const Eigen::Matrix3d R = random.axes();
    if (k < 2) {
      const Eigen::Vector3d middle = p + 0.25 * R.col(0);
      surface.add_capsule(middle - (k == 0 ? 0.4 : 0.0) * R.col(1), middle + 0.5 * R.col(1) + 0.1 * k * R.col(0), 0.1);
      continue;
    }
    // A triangle 0.15 below p: under its middle, its edge, its corner; or 0.05 above it.
    const int first = static_cast<int>(corners.size());
    const Eigen::Vector3d foot = p + (k == 5 ? 0.05 : -0.15) * R.col(2);
    const Eigen::Vector3d shift = k == 3   ? Eigen::Vector3d(0.0, 0.35, 0.0)
                                  : k == 4 ? Eigen::Vector3d(0.55, 0.35, 0.0)
                                           : Eigen::Vector3d(0.0, 0.0, 0.0);
    for (const Eigen::Vector3d& corner :
         {Eigen::Vector3d(-0.5, -0.3, 0.0), Eigen::Vector3d(0.5, -0.3, 0.0), Eigen::Vector3d(0.0, 0.6, 0.0)})
      corners.push_back(foot + R * (corner + shift));
    triangles.emplace_back(first, first + 1, first + 2);
  }
  Eigen::Matrix3Xd vertices(3, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) vertices.col(static_cast<Eigen::Index>(i)) = corners[i];
  surface.add_triangles(vertices, triangles);
  auto seen = std::make_shared<SurfaceSeen>();
  seen->sides.assign(triangles.size(), 1.0);
  seen->surface = std::make_shared<ContactSurface>(std::move(surface));
  side.seen = seen;
  side.depth = 0.2;
  side.slot = 0;
  return std::make_unique<SurfaceContact>(name, places_on, with_surface, std::vector<SurfaceContact::Side>{side}, law);
}

// A soil under three facets of a body, deep in it.
inline std::unique_ptr<SoilContact> soil_contact(Random& random, const Model& model, const std::string& name, int body,
                                                 bool is_rft) {
  std::vector<SoilFacet> facets(3);
  for (SoilFacet& facet : facets) {
    facet.marker = random_marker(random, model, body);
    facet.normal = (random.vector() - Eigen::Vector3d(0.0, 0.0, 1.0)).normalized();
    facet.area = 0.5 + random.number() * 0.1;
  }
  SoilContact::Surface place;
  place.normal = random.vector() + Eigen::Vector3d(0.0, 0.0, 3.0);
  place.point = model.initial(body).r + 3.0 * place.normal.normalized();
  // Pressed in from a print a little higher and to the side: in elastic ground.
  for (SoilFacet& facet : facets)
    facet.start = model.initial_position(facet.marker) + 0.2 * place.normal.normalized() + 0.05 * random.vector();
  // Faces that reach out of the ground, however the body is turned.
  for (SoilFacet& facet : facets)
    for (int k = 0; is_rft && k < 6; ++k)
      facet.corners.push_back((k % 2 == 0 ? 8.0 : -8.0) * Eigen::Vector3d::Unit(k / 2));
  RftParameters rft;
  rft.density = 2.0;
  rft.resistance = 20.0;
  rft.cohesion = 0.5;
  rft.surface_friction = 0.4;
  rft.rebound = 0.3;
  SinkageParameters sinkage;
  sinkage.density = 1.5;
  sinkage.cohesion = 2.0;
  sinkage.stiffness = 9.0;
  sinkage.exponent = 1.3;
  sinkage.friction = 0.5;
  sinkage.shear_length = 0.8;
  sinkage.rebound = 0.3;
  std::shared_ptr<const SoilLaw> law = is_rft ? make_rft(rft, "") : make_pressure_sinkage(sinkage, "");
  return std::make_unique<SoilContact>(name, std::move(facets), is_rft, place, std::move(law),
                                       std::make_shared<const SoilGround>(1.0), true);
}

// The scratch of an element that is evaluated alone.
class OwnScratch {
 public:
  explicit OwnScratch(const ForceElement& element) : scratch_(element.scratch(shared_)) {}
  ElementScratch& operator*() const { return *scratch_; }
  // The same input with it.
  ElementInput with(const ElementInput& in) const {
    ElementInput out = in;
    out.scratch = scratch_.get();
    return out;
  }

 private:
  SharedCopies shared_;
  std::unique_ptr<ElementScratch> scratch_;
};

// One of each kind of force element between the given bodies (a plane under the first of them that is a
// body).
inline std::vector<std::unique_ptr<ForceElement>> all_forces(Random& random, const Model& model, int body_1,
                                                             int body_2) {
  const auto m = [&](int body) { return random_marker(random, model, body); };
  const auto pair = [&] { return random_markers(random, model, body_1, body_2); };
  const std::string tail = "_" + std::to_string(body_1) + "_" + std::to_string(body_2);
  std::vector<std::unique_ptr<ForceElement>> out;
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{50.0, 4.0, 0.1, 2.0}));
  laws.push_back(std::make_unique<CoupledLaw>());
  laws.push_back(std::make_unique<CoupledLaw>());
  MarkerPair ends = pair();
  out.push_back(std::make_unique<Strut>("strut" + tail, ends.m1, ends.m2, std::move(laws), 1.1, 1));
  LinearSpringDamperParameters torsion;
  torsion.stiffness = 7.0;
  torsion.damping = 1.5;
  torsion.free_stroke = 0.2;
  ends = pair();
  out.push_back(torsional_spring("torsion" + tail, ends.m1, ends.m2, torsion));
  Bushing::Parameters bushing;
  bushing.stiffness = {30.0, 20.0, 10.0};
  bushing.damping = {2.0, 3.0, 1.0};
  bushing.rotational_stiffness = {5.0, 6.0, 8.0};
  bushing.rotational_damping = {1.2, 0.4, 0.8};
  ends = pair();
  out.push_back(std::make_unique<Bushing>("bushing" + tail, ends.m1, ends.m2, bushing));
  const auto coupled = [] {
    std::vector<std::unique_ptr<StrutLaw>> law;
    law.push_back(std::make_unique<CoupledLaw>());
    return law;
  };
  for (const Coordinate coordinate : {Coordinate::kAngle, Coordinate::kDisplacement}) {
    ends = pair();
    out.push_back(std::make_unique<JointForce>("coordinate_" + std::string(name_of(coordinate)) + tail, ends.m1,
                                               ends.m2, coordinate, coupled()));
  }
  const int standing = body_1 == kGround ? body_2 : body_1;
  out.push_back(std::make_unique<AppliedForce>("turning" + tail, m(standing), std::nullopt, polynomial({3.0, 1.0}),
                                               polynomial({2.0, -1.0})));
  const Eigen::Vector3d direction = random.vector().normalized();
  out.push_back(std::make_unique<AppliedForce>("fixed" + tail, m(standing), direction, polynomial({3.0, 1.0}),
                                               polynomial({2.0, -1.0})));
  RigidPlane::Parameters plane;
  plane.normal = random.vector() + Eigen::Vector3d(0.0, 0.0, 3.0);
  plane.point = model.initial(standing).r + 2.0 * plane.normal.normalized();  // deep: all points touch
  plane.stiffness = 90.0;
  plane.damping = 0.4;
  plane.friction = 0.3;
  plane.slip_speed = 0.2;
  plane.stick_time = 0.5;
  out.push_back(std::make_unique<RigidPlane>(
      "plane" + tail, std::vector<ContactPoint>{{m(standing), 0.0}, {m(standing), 0.25}, {m(standing), 0.1}}, plane));
  out.push_back(surface_contact(model, "surface" + tail, body_1, body_2, plane));
  Random apart(static_cast<unsigned>(100 + 10 * body_1 + body_2));  // what comes after keeps its numbers
  for (const Coordinate coordinate : {Coordinate::kDisplacementX, Coordinate::kDisplacementY}) {
    ends = random_markers(apart, model, body_1, body_2);
    out.push_back(std::make_unique<JointForce>("coordinate_" + std::string(name_of(coordinate)) + tail, ends.m1,
                                               ends.m2, coordinate, coupled()));
  }
  out.push_back(soil_contact(apart, model, "rft" + tail, standing, true));
  out.push_back(soil_contact(apart, model, "sinkage" + tail, standing, false));
  ends = random_markers(apart, model, body_1, body_2);  // from a drum to a point
  out.push_back(std::make_unique<Cable>("cable" + tail,
                                        std::vector<CableGuide>{{ends.m1, 0.1, 0.3}, {ends.m2, 0.0, 0.0}},
                                        CableParameters{60.0, 0.0, 2.0, 0.2}));
  TerrainParts hills;
  hills.origin = model.initial(standing).r + Eigen::Vector3d(0.0, 0.0, 2.0);  // all points touch
  hills.slope = {0.1, -0.2};
  hills.waves = {{{0.8, 0.3}, 0.1, 0.4}};
  const std::vector<ContactPoint> places{{random_marker(apart, model, standing), 0.0},
                                         {random_marker(apart, model, standing), 0.2}};
  out.push_back(std::make_unique<TerrainContact>("terrain" + tail, places, plane, std::make_shared<Terrain>(hills)));
  return out;
}

// Everything at once: each kind of joint and element rigid-rigid, rigid-flexible, flexible-flexible, and to
// the ground.
inline Model everything(Random& random) {  // rotors of every coordinate, rolling spheres, gears, too
  Model model = random_bodies(random);
  const int pairs[5][2] = {{0, 1}, {1, 3}, {0, 2}, {kGround, 1}, {2, kGround}};
  for (const auto& pair : pairs) {
    for (Joint& joint : all_joints(random, model, pair[0], pair[1])) model.add_joint(std::move(joint));
    for (std::unique_ptr<ForceElement>& force : all_forces(random, model, pair[0], pair[1]))
      model.add_force(std::move(force));
    Random apart(static_cast<unsigned>(200 + 10 * pair[0] + pair[1]));
    for (const Coordinate coordinate : every<Coordinate>()) {
      Random& from = axis_of(coordinate) == 2 ? random : apart;
      const MarkerPair at = random_markers(from, model, pair[0], pair[1]);
      model.add_joint(rotor("rotor_" + std::to_string(model.joint_count()), at.m1, at.m2, coordinate, 0.7));
    }
    const MarkerPair at = random_markers(random, model, pair[0], pair[1]);
    model.add_joint(rolling_joint("sphere_" + std::to_string(model.joint_count()), at.m1, at.m2, 0.6, false));
  }
  const int joints = model.joint_count() / 5;  // per pair
  add_gear(model, "gear", {{3, Coordinate::kAngle, 1.3}, {joints + 3, Coordinate::kAngle, -2.6}});
  add_gear(model, "differential",
           {{2 * joints + 4, Coordinate::kDisplacement, -0.4},
            {joints + 5, Coordinate::kAngle, 0.7},
            {3 * joints + 5, Coordinate::kAngle, 1.9},
            {4 * joints + 4, Coordinate::kDisplacement, 2.2}});
  const auto lift = std::make_shared<CubicSpline>("lift", std::vector<double>{-3.0, -1.0, 0.5, 2.0, 3.0},
                                                  std::vector<double>{0.3, -0.2, 0.6, 0.1, 0.8});
  add_gear(model, "cam",
           {{joints + 4, Coordinate::kDisplacement, 1.0}, {2 * joints + 3, Coordinate::kAngle, -0.8, lift}});
  add_gear(model, "slope", {{3, Coordinate::kAngle, 1.0}, {3 * joints + 4, Coordinate::kDisplacement, 1.7, lift}});
  return model;
}

// The initial state as it is: no joint closed, no row taken for redundant.
inline Assembly as_given(const Model& model) {
  const Layout layout(model);
  Assembly out;
  out.rank = layout.row_count;
  out.state.q.resize(layout.q_size);
  out.state.v.resize(layout.v_size);
  out.state.z = Eigen::VectorXd::Zero(layout.z_size);  // as assembly.cpp has it: signals count turns from zero
  for (int i = 0; i < model.body_count(); ++i) {
    const BodyState& body = model.initial(i);
    out.state.q.segment(layout.body_q[static_cast<std::size_t>(i)], 7 + model.body(i).mode_count()) << body.r, body.L,
        body.a;
    out.state.v.segment(layout.body_v[static_cast<std::size_t>(i)], 6 + model.body(i).mode_count()) << body.dr, body.w,
        body.da;
  }
  for (int i = 0; i < model.force_count(); ++i)
    out.state.z.segment(layout.force_z[static_cast<std::size_t>(i)], model.force(i).state_count()) =
        model.force(i).initial_state();
  out.state.load_work = Eigen::VectorXd::Zero(model.body_count());
  return out;
}

// Random loads with tangent parts on all bodies, and two voltages.
inline Inputs random_inputs(Random& random, const Model& model) {
  Inputs inputs;
  inputs.values = Eigen::Vector2d(0.3, 0.8);
  for (int i = 0; i < model.body_count(); ++i) {
    ExternalLoad load;
    load.F_W = random.vector(5.0);
    load.T_B = random.vector(3.0);
    load.Q_a = random.vector_x(model.body(i).mode_count(), 2.0);
    TangentLoad tangent;
    for (int k = 0; k < 6; ++k) {
      tangent.K.col(k) = random.vector_x(6, 20.0);
      tangent.C.col(k) = random.vector_x(6, 2.0);
    }
    tangent.r_mean = model.initial(i).r + random.vector(0.1);
    tangent.L_mean = rotated(model.initial(i).L, random.vector(0.2));
    tangent.v_mean = random.vector_x(6);
    load.tangent = tangent;
    inputs.loads.push_back(load);
  }
  return inputs;
}

}  // namespace footfall::test

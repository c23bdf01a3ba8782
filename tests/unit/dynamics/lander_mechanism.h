#pragma once
// A lander of 29 rigid bodies on four legs over a rigid plane, for tests of accuracy and speed: cabin, and
// per leg the primary strut (outer tube, rod), the pad, and two auxiliary struts (outer and inner tube).
// Dimensions of a lunar lander of 1250 kg.

#include <cmath>
#include <memory>
#include <string>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/elements/bushing.h"
#include "mbd_solver/model/elements/rigid_plane.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/laws/honeycomb.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/rotation.h"

namespace footfall::test {

struct LanderStart {
  double clearance = 0.005;                  // of the pads above the plane [m]
  Eigen::Vector3d velocity{0.0, 0.0, -3.8};  // [m/s]
  double slope = 0.0;                        // of the plane, about y [rad]
};

inline int add_solid(Model& model, const std::string& name, const MassProperties& solid, const LanderStart& start) {
  BodyState state;
  state.r = solid.centre;
  state.dr = start.velocity;
  return model.add_body(Body(name, solid.mass, solid.inertia), state);
}

inline std::unique_ptr<ForceElement> pad_on_plane(const Model& model, const std::string& name, int pad,
                                                  const LanderStart& start) {
  RigidPlane::Parameters plane;
  plane.normal = {std::sin(start.slope), 0.0, std::cos(start.slope)};
  plane.point = {0.0, 0.0, -start.clearance};
  plane.stiffness = 2.0e6;
  plane.damping = 1.0;
  plane.friction = 0.4;
  plane.slip_speed = 0.01;
  plane.stick_time = 0.0;
  std::vector<ContactPoint> points;
  for (int i = 0; i < 8; ++i) {
    const double angle = i * kPi / 4.0;
    points.push_back({model.marker_at(pad, model.initial(pad).r +
                                               Eigen::Vector3d(0.2 * std::cos(angle), 0.2 * std::sin(angle), -0.004)),
                      0.0});
  }
  return std::make_unique<RigidPlane>(name, points, plane);
}

inline Model lander(const LanderStart& start = {}) {
  Model model({0.0, 0.0, -1.63});
  MassProperties legs;
  const auto part = [&](const std::string& name, const MassProperties& solid) {
    legs = legs.mass > 0.0 ? legs + solid : solid;
    return add_solid(model, name, solid, start);
  };
  // Cabin first, with what the legs leave of 1250 kg.
  const double steel = 7850.0, leg_mass = 62.0;
  MassProperties cabin_solid = with_mass(box_properties({1.8, 1.8, 1.4}, 1.0), 1250.0 - 4.0 * leg_mass);
  cabin_solid.centre = {0.0, 0.0, 1.5};
  const int cabin = add_solid(model, "cabin", cabin_solid, start);

  for (int leg = 0; leg < 4; ++leg) {
    const std::string tail = "_" + std::to_string(leg + 1);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(0.5 * kPi * leg, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const auto at = [&](double x, double y, double z) { return Eigen::Vector3d(R * Eigen::Vector3d(x, y, z)); };
    const Eigen::Vector3d up = at(1.0, 0.0, 1.35), pivot = at(1.75, 0.0, 0.08), side = at(0.0, 1.0, 0.0);
    const Eigen::Vector3d e = (pivot - up).normalized(), lower = up + 0.9 * e;
    const Eigen::Matrix3d along = axes_with_z(e, side);

    const int outer = part("outer" + tail, tube_properties(up, lower, 0.09, 0.005, steel));
    const int rod = part("rod" + tail, tube_properties(pivot - 0.9 * e, pivot, 0.05, 0.008, steel));
    MassProperties disc = disc_properties(0.2, 0.008, steel);
    disc.centre = at(1.75, 0.0, 0.004);
    const int pad = part("pad" + tail, disc);

    // Universal at the cabin: first axis sideways on the cabin, second one across on the strut.
    model.add_joint(universal_joint("hip" + tail, model.marker_at(cabin, up, axes_with_z(e, side)),
                                    model.marker_at(outer, up, along)));
    model.add_joint(
        prismatic_joint("slide" + tail, model.marker_at(outer, up, along), model.marker_at(rod, pivot, along)));
    model.add_joint(spherical_joint("ankle" + tail, model.marker_at(rod, pivot), model.marker_at(pad, pivot)));
    Bushing::Parameters centring;
    centring.rotational_stiffness = Eigen::Vector3d::Constant(200.0);
    centring.rotational_damping = Eigen::Vector3d::Constant(10.0);
    model.add_force(std::make_unique<Bushing>("centring" + tail, model.marker_at(rod, pivot),
                                              model.marker_at(pad, pivot), centring));
    std::vector<std::unique_ptr<StrutLaw>> primary;
    primary.push_back(std::make_unique<GasSpring>(GasSpringParameters{}));
    primary.push_back(std::make_unique<MrDamper>(MrDamperParameters{}));
    EndStopParameters stops;
    stops.smallest_stroke = 0.0;
    stops.largest_stroke = 0.32;
    primary.push_back(std::make_unique<EndStop>(stops));
    model.add_force(std::make_unique<Strut>("primary" + tail, model.marker_at(outer, up), model.marker_at(rod, pivot),
                                            std::move(primary), (pivot - up).norm(), leg));
    model.add_force(pad_on_plane(model, "ground" + tail, pad, start));

    for (int s = -1; s <= 1; s += 2) {
      const std::string name = (s < 0 ? "_left" : "_right") + tail;
      const Eigen::Vector3d hip = at(0.85, 0.55 * s, 0.55), d = (lower - hip).normalized();
      const double length = (lower - hip).norm();
      const Eigen::Matrix3d axes = axes_with_z(d, Eigen::Vector3d::UnitZ());
      const int aux_outer = part("aux_outer" + name, tube_properties(hip, hip + 0.6 * length * d, 0.06, 0.004, steel));
      const int aux_inner =
          part("aux_inner" + name, tube_properties(lower - 0.6 * length * d, lower, 0.05, 0.004, steel));
      model.add_joint(
          universal_joint("aux_hip" + name, model.marker_at(cabin, hip, axes), model.marker_at(aux_outer, hip, axes)));
      model.add_joint(prismatic_joint("aux_slide" + name, model.marker_at(aux_outer, hip, axes),
                                      model.marker_at(aux_inner, lower, axes)));
      model.add_joint(
          spherical_joint("aux_knee" + name, model.marker_at(aux_inner, lower), model.marker_at(outer, lower)));
      std::vector<std::unique_ptr<StrutLaw>> crush;
      crush.push_back(std::make_unique<Honeycomb>(HoneycombParameters{}));
      model.add_force(std::make_unique<Strut>("aux" + name, model.marker_at(aux_outer, hip),
                                              model.marker_at(aux_inner, lower), std::move(crush), length));
    }
  }
  return model;
}

}  // namespace footfall::test

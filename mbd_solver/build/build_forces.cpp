// Struts, springs and forces of the scene. Their parameters are those of the laws; what depends on the strut is added here.

#include <cmath>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/build/time_functions.h"
#include "mbd_solver/model/elements/bushing.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/laws/table_law.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {
namespace {

// build(spec, strut, length): the law of one section, in a strut of undeformed length `length` [m].

std::unique_ptr<StrutLaw> build(const GasSpringParameters& spec, const StrutSpec& strut, double) {
  GasSpringParameters p = spec;
  if (strut.stops) p.largest_stroke = strut.stops->largest_stroke;
  return std::make_unique<GasSpring>(p);
}

std::unique_ptr<StrutLaw> build(const MrSpec& spec, const StrutSpec&, double) {
  MrDamperParameters p = spec;
  if (spec.controller.empty() && spec.signal.empty()) p.initial_voltage = spec.voltage;
  if (spec.geometry) p = mr_damper_from_geometry(*spec.geometry, p);
  return std::make_unique<MrDamper>(p);
}

std::unique_ptr<StrutLaw> build(const HoneycombSpec& spec, const StrutSpec&, double) {
  HoneycombParameters p;
  p.compression = spec.compression ? std::optional<HoneycombCartridge>(spec) : std::nullopt;
  p.tension = spec.tension ? std::optional<HoneycombCartridge>(spec) : std::nullopt;
  return std::make_unique<Honeycomb>(p);
}

std::unique_ptr<StrutLaw> build(const EndStopParameters& spec, const StrutSpec& strut, double) {
  EndStopParameters p = spec;
  // A gas strut rests on its extended end under the preload, which compresses the stop: the stop is set back by as much.
  if (strut.gas && p.smallest_stroke) {
    const double area = 0.25 * kPi * strut.gas->piston_diameter * strut.gas->piston_diameter;
    p.smallest_stroke = *p.smallest_stroke + EndStop(p).penetration(strut.gas->initial_pressure * area);
  }
  return std::make_unique<EndStop>(p);
}

std::unique_ptr<StrutLaw> build(const LinearSpringSpec& spec, const StrutSpec&, double length) {
  LinearSpringDamperParameters p = spec;
  if (spec.free_length) p.free_stroke = length - *spec.free_length;
  return std::make_unique<LinearSpringDamper>(p);
}

std::unique_ptr<StrutLaw> build(const TableSpec& spec, const StrutSpec&, double) {
  return std::make_unique<TableLaw>(read_table_law(spec.file));
}

std::vector<std::unique_ptr<StrutLaw>> laws_of(const StrutSpec& strut, double length) {
  std::vector<std::unique_ptr<StrutLaw>> laws;
  each_law(strut, [&](const char*, const auto& law) {
    if (law) laws.push_back(build(*law, strut, length));
  });
  return laws;
}

// Where the voltage of the strut is among the inputs: an output of its controller, a signal, or a constant of its own;
// -1 without a damper.
int voltage_place(const StrutSpec& spec, Mechanism& mechanism) {
  if (!spec.mr) return -1;
  if (!spec.mr->controller.empty()) {
    for (const ControllerEntry& controller : mechanism.controllers)
      for (std::size_t k = 0; k < controller.outputs.size(); ++k)
        if (controller.name + "." + controller.outputs[k] == spec.mr->controller)
          return controller.first_input + static_cast<int>(k);
    FOOTFALL_DEMAND(false);
  }
  if (!spec.mr->signal.empty()) return signal_place(mechanism, spec.mr->signal);
  return add_input(mechanism, spec.mr->voltage);
}

}  // namespace

void add_struts(const Scene& scene, Mechanism& mechanism) {
  for (const StrutSpec& spec : scene.struts) {
    const int voltage = voltage_place(spec, mechanism);
    const double length = spec.length.value_or((spec.points[1] - spec.points[0]).norm());
    const auto marker = [&](std::size_t end) {
      return mechanism.model.marker_at(scene.body_index(spec.bodies[end]), mechanism.placement.point(spec.points[end]));
    };
    try {
      auto strut = std::make_unique<Strut>(spec.name, marker(0), marker(1), laws_of(spec, length), length, voltage);
      mechanism.struts.push_back({spec.name, mechanism.model.add_force(std::move(strut))});
    } catch (const InputError& error) {
      throw InputError(place_of(scene.file, spec.source) + error.what());
    }
  }
}

namespace {

std::unique_ptr<ForceElement> build(const SpringSpec& spec, const Scene& scene, const Mechanism& mechanism) {
  const Placement& placement = mechanism.placement;
  const Model& model = mechanism.model;
  const int a = scene.body_index(spec.bodies[0]), b = scene.body_index(spec.bodies[1]);
  const auto bushing = [&](const Eigen::Vector3d& p_W, const Bushing::Parameters& p) {
    const Eigen::Matrix3d axes_W = placement.R_WD * axes_with_z(spec.axis, spec.axis2);
    return std::make_unique<Bushing>(spec.name, model.marker_at(a, p_W, axes_W), model.marker_at(b, p_W, axes_W), p);
  };
  switch (spec.kind) {
    case SpringKind::kTorsion: {
      const Eigen::Matrix3d axes = placement.R_WD * axes_with_z(spec.axis);
      LinearSpringDamperParameters p;
      p.stiffness = spec.stiffness.x();
      p.damping = spec.damping.x();
      p.free_stroke = spec.rest_angle;
      return torsional_spring(spec.name, model.marker_at(a, placement.point(spec.point), axes),
                              model.marker_at(b, placement.point(spec.point), axes), p);
    }
    case SpringKind::kCentring: {
      Bushing::Parameters p;
      p.rotational_stiffness = spec.stiffness;
      p.rotational_damping = spec.damping;
      // It only turns: its point is where it measures the attitude, by default the mass centre of b.
      return bushing(b == kGround || spec.source.given("point") ? placement.point(spec.point) : model.initial(b).r, p);
    }
    case SpringKind::kBushing: return bushing(placement.point(spec.point), spec);
  }
  FOOTFALL_DEMAND(false);
}

}  // namespace

void add_springs(const Scene& scene, Mechanism& mechanism) {
  for (const SpringSpec& spec : scene.springs) mechanism.model.add_force(build(spec, scene, mechanism));
}

void add_forces(const Scene& scene, Mechanism& mechanism) {
  const Placement& placement = mechanism.placement;
  Model& model = mechanism.model;
  const auto magnitude = [&](const std::optional<TimeFunctionSpec>& spec) {
    return Magnitude(time_function(spec, TableShape::kLines), spec ? signal_place(mechanism, spec->signal) : -1);
  };
  for (const ForceSpec& spec : scene.forces) {
    const int body = scene.body_index(spec.body);
    const Eigen::Vector3d p_W = spec.point ? placement.point(*spec.point) : model.initial(body).r;
    const bool turns = spec.frame == ForceFrame::kBody;
    const Eigen::Matrix3d axes_W = turns ? Eigen::Matrix3d(placement.R_WD * axes_with_z(spec.direction))
                                         : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    model.add_force(std::make_unique<AppliedForce>("force/" + spec.name, model.marker_at(body, p_W, axes_W),
                                                   turns ? std::nullopt : std::optional(spec.direction),
                                                   magnitude(spec.force), magnitude(spec.torque)));
  }
}

}  // namespace footfall

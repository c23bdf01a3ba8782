// Struts, springs, forces and the rigid plane of the scene.

#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/build/time_functions.h"
#include "mbd_solver/model/elements/bushing.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/laws/gas_spring.h"
#include "mbd_solver/model/laws/honeycomb.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/laws/table_law.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {
namespace {

// build(spec, strut, length): the law of one section, within its strut of undeformed length `length` [m].

std::unique_ptr<StrutLaw> build(const GasSpec& spec, const StrutSpec& strut, double) {
  GasSpringParameters p;
  p.piston_diameter = spec.piston_diameter;
  p.initial_pressure = spec.pressure;
  p.initial_volume = spec.volume;
  p.exponent = spec.exponent;
  if (strut.stops) p.largest_stroke = strut.stops->max;
  return std::make_unique<GasSpring>(p);
}

std::unique_ptr<StrutLaw> build(const MrSpec& spec, const StrutSpec&, double) {
  MrDamperParameters p;
  p.yield_force = spec.yield_force;
  p.viscous_coefficient = spec.viscous;
  p.regularisation_speed = spec.regularisation_speed;
  p.coil_lag = spec.coil_lag;
  p.initial_voltage = spec.controller.empty() && spec.signal.empty() ? spec.voltage : spec.initial_voltage;
  for (const Eigen::Vector2d& row : spec.yield_table) p.yield_table.push_back({row.x(), row.y()});
  if (spec.geometry) {
    const MrGeometrySpec& g = *spec.geometry;
    MrGeometry geometry{g.D1, g.d1, g.D2, g.D3, g.D4, g.d, g.L1, g.L2, g.L3, g.L4, g.viscosity, {}};
    for (const Eigen::Vector2d& row : g.yield_stress) geometry.tau_y.push_back({row.x(), row.y()});
    p = mr_damper_from_geometry(geometry, p);
  }
  return std::make_unique<MrDamper>(p);
}

std::unique_ptr<StrutLaw> build(const HoneycombSpec& spec, const StrutSpec&, double) {
  HoneycombCartridge cartridge;
  cartridge.stages.clear();
  for (const CrushStageSpec& stage : spec.stages) cartridge.stages.push_back({stage.force, stage.length});
  cartridge.elastic_stiffness = spec.elastic_stiffness;
  cartridge.bottom_out_stiffness = spec.bottom_out_stiffness;
  cartridge.transition_length = spec.transition_length;
  cartridge.toe = spec.toe;
  HoneycombParameters p;
  p.compression = spec.compression ? std::optional(cartridge) : std::nullopt;
  p.tension = spec.tension ? std::optional(cartridge) : std::nullopt;
  return std::make_unique<Honeycomb>(p);
}

std::unique_ptr<StrutLaw> build(const StopsSpec& spec, const StrutSpec& strut, double) {
  EndStopParameters p;
  p.smallest_stroke = spec.min;
  p.largest_stroke = spec.max;
  p.stiffness = spec.stiffness;
  p.dissipation = spec.dissipation;
  p.toe = spec.toe;
  // A gas strut rests on its extended end under the preload: the stop yields by its penetration there, so it sits that
  // much higher.
  if (strut.gas && p.smallest_stroke) {
    const double area = 0.25 * kPi * strut.gas->piston_diameter * strut.gas->piston_diameter;
    p.smallest_stroke = *p.smallest_stroke + EndStop(p).penetration(strut.gas->pressure * area);
  }
  return std::make_unique<EndStop>(p);
}

std::unique_ptr<StrutLaw> build(const LinearSpringSpec& spec, const StrutSpec&, double length) {
  LinearSpringDamperParameters p;
  p.stiffness = spec.stiffness;
  p.damping = spec.damping;
  p.preload = spec.preload;
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

}  // namespace

void add_struts(const Scene& scene, Mechanism& mechanism) {
  for (std::size_t i = 0; i < scene.struts.size(); ++i) {
    const StrutSpec& spec = scene.struts[i];
    // The voltage of the strut: an output of its controller, or a constant of its own.
    int voltage = -1;
    if (spec.mr && !spec.mr->controller.empty()) {
      for (const ControllerEntry& controller : mechanism.controllers)
        for (std::size_t k = 0; k < controller.outputs.size(); ++k)
          if (controller.name + "." + controller.outputs[k] == spec.mr->controller)
            voltage = controller.first_voltage + static_cast<int>(k);
      FOOTFALL_DEMAND(voltage >= 0);
    } else if (spec.mr && !spec.mr->signal.empty()) {
      voltage = signal_place(mechanism, spec.mr->signal);
    } else if (spec.mr) {
      voltage = static_cast<int>(mechanism.voltages.size());
      mechanism.voltages.conservativeResize(voltage + 1);
      mechanism.voltages(voltage) = spec.mr->voltage;
    }
    const double length = spec.length.value_or((spec.points[1] - spec.points[0]).norm());
    const Model& model = mechanism.model;
    try {
      auto strut = std::make_unique<Strut>(
          spec.name, model.marker_at(scene.body_index(spec.bodies[0]), mechanism.placement.point(spec.points[0])),
          model.marker_at(scene.body_index(spec.bodies[1]), mechanism.placement.point(spec.points[1])),
          laws_of(spec, length), length, voltage);
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
      // It turns only: its point is where it reads the attitude, the mass centre of b where the scene gives none.
      return bushing(b == kGround || spec.source.given("point") ? placement.point(spec.point) : model.initial(b).r, p);
    }
    case SpringKind::kBushing: {
      Bushing::Parameters p;
      p.stiffness = spec.stiffness;
      p.damping = spec.damping;
      p.rotational_stiffness = spec.turning_stiffness;
      p.rotational_damping = spec.turning_damping;
      return bushing(placement.point(spec.point), p);
    }
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

// Struts, springs, forces and contacts of the scene. Parameters come from the laws; parts that depend on the strut are added.

#include <algorithm>
#include <cmath>

#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/assemble/law_files.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/assemble/time_functions.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/elements/bushing.h"
#include "mbd_solver/model/elements/cable.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/resolve.h"

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
  // A constant voltage has been on before the start, unless another is given for it.
  if (spec.controller.empty() && spec.signal.empty() && !p.initial_voltage) p.initial_voltage = spec.voltage;
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

// The placement of bodies that [initial] places, or the reference configuration.
Placement placement_of(const Scene& scene, const Mechanism& mechanism, const std::array<std::string, 2>& bodies) {
  return stands_still(scene, bodies[0]) || stands_still(scene, bodies[1]) ? Placement() : mechanism.placement;
}

// The angle from direction `from` to `to` about the axis, as a wrap: from -90 to 270 degrees.
double wrap_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& axis) {
  const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
  return angle < -0.5 * kPi ? angle + 2.0 * kPi : angle;
}

// One part of a cable in the reference configuration: its guides without markers, and the length of its way.
struct CablePart {
  std::vector<CablePlace> places;
  std::vector<CableTouch> touches;
  std::vector<double> wraps;  // of the pulleys between the ends [rad]
  double length = 0.0;        // [m]
};

CablePart cable_part(const std::vector<CablePlace>& places, const std::vector<int>& turns) {
  CablePart out{places, {}, std::vector<double>(places.size(), 0.0), 0.0};
  double spans = 0.0;
  out.touches = touch(places, spans);
  std::vector<std::size_t> touched;
  for (std::size_t i = 0; i < places.size(); ++i) touched.push_back(i);
  for (bool again = true; again;) {  // the pulley with the most negative wrap is not touched
    again = false;
    std::vector<CablePlace> seen;
    for (const std::size_t i : touched) seen.push_back(places[i]);
    const std::vector<CableTouch> at = touch(seen, spans);
    out.length = spans;
    std::size_t leaves = 0;
    for (std::size_t k = 1; k + 1 < touched.size(); ++k) {
      const std::size_t i = touched[k];
      if (!(places[i].radius > 0.0)) continue;
      out.wraps[i] = wrap_between(at[k].in, at[k].out, places[i].axis) + 2.0 * kPi * turns[i];
      out.length += places[i].radius * out.wraps[i];
      if (out.wraps[i] < 0.0 && (leaves == 0 || out.wraps[i] < out.wraps[touched[leaves]])) leaves = k;
    }
    if (leaves == 0) continue;
    touched.erase(touched.begin() + leaves);
    again = true;
  }
  return out;
}

struct BuiltCable {
  std::unique_ptr<Cable> cable;
  Eigen::Vector3d out_of_first, in_of_last;  // directions of the contact points at its ends, in W
};

BuiltCable build(const CableSpec& spec, const std::string& name, std::size_t first, std::size_t last,
                 const Placement& placement, const Scene& scene, const Model& model) {
  std::vector<CablePlace> places;
  std::vector<int> turns;
  for (std::size_t i = first; i <= last; ++i) {
    const CableGuideSpec& guide = spec.path[i];
    places.push_back(
        {placement.point(guide.point), placement.R_WD * guide.axis.value_or(Eigen::Vector3d::UnitZ()), guide.radius});
    turns.push_back(guide.turns);
  }
  const CablePart part = cable_part(places, turns);
  std::vector<CableGuide> guides;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const CablePlace& place = places[k];
    const Eigen::Vector3d from = k == 0 ? part.touches[k].out : part.touches[k].in;
    const Eigen::Matrix3d axes = place.radius > 0.0 ? axes_with_z(place.axis, from) : Eigen::Matrix3d::Identity();
    guides.push_back({model.marker_at(scene.body_index(spec.path[first + k].body), place.centre, axes), place.radius,
                      part.wraps[k]});
  }
  CableParameters parameters;
  parameters.stiffness = spec.stiffness.value_or(0.0);
  parameters.axial_stiffness = spec.EA.value_or(0.0);
  parameters.damping = spec.damping;
  const double tension = spec.tension.value_or(0.0);
  parameters.length = spec.length.value_or(part.length + spec.slack.value_or(0.0));
  if (spec.stiffness) parameters.length -= tension / *spec.stiffness;
  if (spec.EA) parameters.length *= *spec.EA / (*spec.EA + tension);
  if (!(parameters.length > 0.0))
    throw InputError(code::kNoLength, "tension: stretches the cable by more than its way of ", part.length,
                     " m; make it smaller, or the cable stiffer");
  return {std::make_unique<Cable>(name, std::move(guides), parameters), part.touches.front().out,
          part.touches.back().in};
}

// A pulley between the last two cables of the mechanism, which it divides.
void add_grip(const Scene& scene, const CableSpec& spec, std::size_t guide, const Eigen::Vector3d& in,
              const Eigen::Vector3d& out, const Placement& placement, Mechanism& mechanism) {
  const CableGuideSpec& round = spec.path[guide];
  GripEntry grip;
  grip.name = concat("cable \"", spec.name, "\": guide ", guide + 1, " of its path, on body \"", round.body, "\"");
  grip.after = mechanism.cables.back().force;
  grip.before = mechanism.cables[mechanism.cables.size() - 2].force;
  grip.wrap =
      wrap_between(in, out, placement.R_WD * round.axis.value_or(Eigen::Vector3d::UnitZ())) + 2.0 * kPi * round.turns;
  if (grip.wrap < -kLeastWrap)
    mechanism.warnings.push_back(
        with_code(code::kGripWithoutWrap, place_of(scene.file, spec.source), grip.name,
                  ": the cable passes this pulley on the other side and holds it all the same, because grip = true; "
                  "give axis the opposite sign, or turns, or remove grip if the cable may leave the pulley"));
  mechanism.grips.push_back(std::move(grip));
}

std::unique_ptr<ForceElement> build(const SpringSpec& spec, const Scene& scene, const Mechanism& mechanism) {
  const Placement placement = placement_of(scene, mechanism, spec.bodies);
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

// Contacts with planes, with the walls of the script, and of bodies with each other.

// Points deeper than this share of the smaller body have passed through and are not pushed back.
constexpr double kDepth = 0.1;
// So many points decide on which side of a surface a body is.
constexpr std::size_t kSamples = 32;

// Speed and time of friction that sticks follow the size L of the mechanism and gravity g, so that a mechanism and its model in
// another scale move alike (theory 6.4): v_s = 4e-4 sqrt(g L), tau = 6.4e-3 sqrt(L / g). A lander of 4 m on the moon has 1 mm/s
// and 10 ms. Without gravity the initial speed v replaces sqrt(g L); without both, 1 m/s.
constexpr double kSlipSpeed = 4e-4, kStickTime = 6.4e-3;

// The largest distance of the boundaries from the mass centre, all bodies in the reference configuration [m].
double size_of(const Scene& scene, const Mechanism& mechanism) {
  const Eigen::Vector3d p_WC = mechanism.placement.point(mass_centre(scene));
  double size = 0.0;
  for (const BodyBoundary& entry : mechanism.boundaries) {
    const BodyState& body = mechanism.model.initial(entry.body);
    const Eigen::Matrix3Xd nodes = (rotation_matrix(body.L) * entry.boundary.rho0()).colwise() + (body.r - p_WC);
    double thickness = 0.0;
    for (const ContactPoint& point : entry.points) thickness = std::max(thickness, point.radius);
    for (const ContactRim& rim : entry.rims) thickness = std::max(thickness, rim.radius);
    size = std::max(size, nodes.colwise().norm().maxCoeff() + thickness);
  }
  return size > 0.0 ? size : 1.0;
}

ContactLaw contact_law(const ContactLawSpec& spec, const Scene& scene, const Mechanism& mechanism) {
  ContactLaw law;
  law.friction = spec.friction;
  const double L = size_of(scene, mechanism), g = scene.gravity.norm(), v = scene.initial.velocity.norm();
  const double V = g > 0.0 ? std::sqrt(g * L) : v > 0.0 ? v : 1.0;
  law.slip_speed = kSlipSpeed * V;
  law.stick_time = kStickTime * L / V;
  if (spec.friction_speed) {
    law.slip_speed = *spec.friction_speed;
    law.stick_time = 0.0;
  }
  // Hertz on a flat: k = 4/3 E* sqrt(R), E* = E / (1 - nu^2).
  law.stiffness = spec.stiffness ? *spec.stiffness
                                 : 4.0 / 3.0 * spec.young.value_or(0.0) / (1.0 - spec.poisson * spec.poisson) *
                                       std::sqrt(spec.contact_radius);
  const double speed = spec.impact_speed.value_or(scene.initial.velocity.norm());
  law.damping = spec.damping       ? *spec.damping
                : spec.restitution ? contact_damping_for_restitution(*spec.restitution, speed > 0.0 ? speed : 1.0)
                                   : 0.0;
  return law;
}

RigidPlane::Parameters plane_parameters(const ContactLaw& law, const Eigen::Vector3d& point,
                                        const Eigen::Vector3d& normal) {
  RigidPlane::Parameters p;
  static_cast<ContactLaw&>(p) = law;
  p.point = point;
  p.normal = normal;
  return p;
}

const BodyBoundary& boundary_of(const Mechanism& mechanism, int body) {
  for (const BodyBoundary& entry : mechanism.boundaries)
    if (entry.body == body) return entry;
  FOOTFALL_DEMAND(false);
}

double reach(const BodyBoundary& entry) { return entry.boundary.rho0().colwise().norm().maxCoeff(); }

bool is_ball(const Scene& scene, const BodyBoundary& entry) {
  const BodySpec& body = scene.bodies[entry.body];
  return body.shape && body.shape->kind == ShapeKind::kSphere && entry.boundary.segments().empty() &&
         entry.boundary.mode_count() == 0;
}

// In the frame of the body; null for a flexible one.
std::shared_ptr<const ContactSurface> surface_of(const Scene& scene, const Mechanism& mechanism,
                                                 const BodyBoundary& entry) {
  const ModalBoundary& boundary = entry.boundary;
  if (boundary.mode_count() > 0) return nullptr;
  auto surface = std::make_shared<ContactSurface>();
  for (const BeamSegment& segment : boundary.segments())
    surface->add_capsule(boundary.rho0().col(segment.start), boundary.rho0().col(segment.end), segment.radius);
  if (boundary.triangles().empty()) return surface;
  const ShapeSpec* const shape = round_shape(scene, entry);
  const std::vector<ContactPoint> places = contact_places(scene, mechanism.model.body(entry.body), entry);
  if (shape != nullptr) {
    surface->add_capsule(places.front().marker.s0,
                         shape->kind == ShapeKind::kSphere ? places.front().marker.s0 : places[1].marker.s0,
                         places.front().radius);
  } else {
    surface->add_triangles(boundary.rho0(), boundary.triangles());
  }
  return surface;
}

// Some of the points, in the frame of a body (or of the walls, kGround), at the start.
std::vector<Eigen::Vector3d> places_at_start(const Model& model, const std::vector<ContactPoint>& places, int frame) {
  std::vector<Eigen::Vector3d> out;
  const std::size_t stride = std::max<std::size_t>(1, places.size() / kSamples);
  for (std::size_t i = 0; i < places.size(); i += stride) {
    const Eigen::Vector3d p = model.initial_position(places[i].marker);
    if (frame == kGround) {
      out.push_back(p);
      continue;
    }
    const BodyState& body = model.initial(frame);
    out.push_back(rotation_matrix(body.L).transpose() * (p - body.r));
  }
  return out;
}

// The points of A against the surface of B; nothing where B has none.
void add_side(const Scene& scene, const Mechanism& mechanism, const BodyBoundary& A, const BodyBoundary& B, int slot,
              std::vector<SurfaceContact::Side>& sides) {
  auto seen = std::make_shared<SurfaceSeen>();
  seen->surface = surface_of(scene, mechanism, B);
  if (seen->surface == nullptr) return;
  SurfaceContact::Side side;
  side.slot = slot;
  side.points = contact_places(scene, mechanism.model.body(A.body), A);
  double across = 0.0;
  seen->sides = seen->surface->sides_of(places_at_start(mechanism.model, side.points, B.body), across);
  side.seen = seen;
  side.depth = kDepth * std::min(reach(A), reach(B));
  sides.push_back(std::move(side));
}

void add_pair(const Scene& scene, const ContactSpec& spec, Mechanism& mechanism) {
  const BodyBoundary& A = boundary_of(mechanism, scene.body_index(spec.between[0]));
  const BodyBoundary& B = boundary_of(mechanism, scene.body_index(spec.between[1]));
  std::vector<SurfaceContact::Side> sides;
  // A ball touches a surface exactly: then the points of the other body need not be tested against the ball.
  const bool a_is_ball = is_ball(scene, A), b_is_ball = is_ball(scene, B);
  const bool a_bends = A.boundary.mode_count() > 0, b_bends = B.boundary.mode_count() > 0;  // without surface
  if (a_is_ball || !b_is_ball || a_bends) add_side(scene, mechanism, A, B, 0, sides);
  if (!a_is_ball || b_bends) add_side(scene, mechanism, B, A, 1, sides);
  add_contact(std::make_unique<SurfaceContact>("contact/" + spec.between[0] + "/" + spec.between[1], A.body, B.body,
                                               std::move(sides), contact_law(spec, scene, mechanism)),
              mechanism);
}

void add_walls(const Scene& scene, const ContactSpec& spec, Mechanism& mechanism) {
  const ContactLaw law = contact_law(spec, scene, mechanism);
  for (const BodyBoundary& A : mechanism.boundaries) {
    const std::vector<std::string>& wanted = spec.bodies;
    if (!wanted.empty() && std::count(wanted.begin(), wanted.end(), A.boundary.name()) == 0) continue;
    const auto walls = std::make_shared<SurfaceSeen>();
    SurfaceContact::Side side;
    side.points = contact_places(scene, mechanism.model.body(A.body), A);
    side.seen = walls;
    side.depth = kDepth * reach(A);
    add_contact(std::make_unique<SurfaceContact>("walls/" + A.boundary.name(), A.body, kGround,
                                                 std::vector<SurfaceContact::Side>{side}, law),
                mechanism, walls, side.points);
  }
}

}  // namespace

void add_struts(const Scene& scene, Mechanism& mechanism) {
  for (const StrutSpec& spec : scene.struts) {
    const int voltage = voltage_place(spec, mechanism);
    const double length = spec.length.value_or((spec.points[1] - spec.points[0]).norm());
    const Placement placement = placement_of(scene, mechanism, spec.bodies);
    const auto marker = [&](std::size_t end) {
      return mechanism.model.marker_at(scene.body_index(spec.bodies[end]), placement.point(spec.points[end]));
    };
    try {
      auto strut = std::make_unique<Strut>(spec.name, marker(0), marker(1), laws_of(spec, length), length, voltage);
      mechanism.struts.push_back({spec.name, mechanism.model.add_force(std::move(strut))});
    } catch (const InputError& error) {
      throw InputError(place_of(scene.file, spec.source) + error.what());
    }
  }
}

void add_cables(const Scene& scene, Mechanism& mechanism) {
  for (const CableSpec& spec : scene.cables) {
    bool still = false;
    for (const CableGuideSpec& guide : spec.path) still = still || stands_still(scene, guide.body);
    const Placement placement = still ? Placement() : mechanism.placement;
    const std::vector<std::size_t> ends = spec.ends();
    Eigen::Vector3d in = Eigen::Vector3d::Zero();  // of the part before
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const std::string name = ends.size() == 2 ? spec.name : concat(spec.name, ".", k + 1);
      try {
        BuiltCable built = build(spec, name, ends[k], ends[k + 1], placement, scene, mechanism.model);
        mechanism.cables.push_back({name, mechanism.model.add_force(std::move(built.cable))});
        if (k > 0) add_grip(scene, spec, ends[k], in, built.out_of_first, placement, mechanism);
        in = built.in_of_last;
      } catch (const InputError& error) {
        throw InputError(place_of(scene.file, spec.source) + error.what());
      }
    }
  }
}

void add_springs(const Scene& scene, Mechanism& mechanism) {
  for (const SpringSpec& spec : scene.springs) mechanism.model.add_force(build(spec, scene, mechanism));
}

void add_forces(const Scene& scene, Mechanism& mechanism) {
  Model& model = mechanism.model;
  const auto magnitude = [&](const std::optional<TimeFunctionSpec>& spec) {
    return Magnitude(time_function(spec, TableShape::kLines), spec ? signal_place(mechanism, spec->signal) : -1);
  };
  for (const ForceSpec& spec : scene.forces) {
    const int body = scene.body_index(spec.body);
    const Placement placement = placement_of(scene, mechanism, {spec.body, spec.body});
    const Eigen::Vector3d p_W = spec.point ? placement.point(*spec.point) : model.initial(body).r;
    const bool turns = spec.frame == ForceFrame::kBody;
    const Eigen::Matrix3d axes_W = turns ? Eigen::Matrix3d(placement.R_WD * axes_with_z(spec.direction))
                                         : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    mechanism.forces.push_back(model.add_force(std::make_unique<AppliedForce>(
        "force/" + spec.name, model.marker_at(body, p_W, axes_W), turns ? std::nullopt : std::optional(spec.direction),
        magnitude(spec.force), magnitude(spec.torque))));
  }
}

void add_plane_contact(const Scene& scene, const BodyBoundary& entry, const std::string& prefix, double below,
                       std::shared_ptr<const Terrain> terrain, Mechanism& mechanism) {
  const bool rocks = scene.ground.kind == GroundKind::kSoil && terrain && !terrain->rocks().empty();
  if (scene.ground.kind != GroundKind::kPlane && !rocks) return;
  if (entry.points.empty() && entry.rims.empty()) return;
  const PlaneSpec& spec = *scene.ground.plane;
  ContactLaw law = contact_law(spec, scene, mechanism);
  if (below > 0.0) law.stick_time = 0.0;
  const std::string& name = entry.boundary.name();
  if (terrain) {
    const auto touches = rocks ? TerrainContact::Touches::kRocks : TerrainContact::Touches::kAll;
    add_contact(std::make_unique<TerrainContact>((rocks ? "rocks/" : prefix) + name, entry.points, law,
                                                 std::move(terrain), entry.rims, touches),
                mechanism);
    return;
  }
  add_contact(
      std::make_unique<RigidPlane>(prefix + name, entry.points,
                                   plane_parameters(law, spec.point - below * spec.normal, spec.normal), entry.rims),
      mechanism);
}

void add_plane(const Scene& scene, Mechanism& mechanism) {
  for (const BodyBoundary& entry : mechanism.boundaries)
    add_plane_contact(scene, entry, "ground/", 0.0, mechanism.terrain, mechanism);
}

void add_contacts(const Scene& scene, Mechanism& mechanism) {
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const ContactSpec& spec = scene.contacts[i];
    if (spec.ignore) continue;
    if (spec.walls) {
      add_walls(scene, spec, mechanism);
    } else if (spec.with_plane()) {
      const int body = scene.body_index(spec.between[0]);
      BodyBoundary touching{body, boundary_of(mechanism, body).boundary, {}, {}};
      add_plane_places(scene, mechanism.model.body(body), touching);
      add_contact(std::make_unique<RigidPlane>(
                      concat("plane_", i + 1, "/", spec.between[0]), touching.points,
                      plane_parameters(contact_law(spec, scene, mechanism), spec.point, spec.normal), touching.rims),
                  mechanism);
    } else {
      add_pair(scene, spec, mechanism);
    }
  }
}

void set_walls(const std::vector<StaticWall>& walls, Mechanism& mechanism) {
  std::shared_ptr<ContactSurface> surface;
  for (const ContactEntry& entry : mechanism.contacts) {
    if (entry.walls == nullptr) continue;
    entry.walls->surface = nullptr;
    if (surface == nullptr) {
      surface = std::make_shared<ContactSurface>();
      for (const StaticWall& wall : walls)
        if (wall.corners.empty()) surface->add_plane(wall.point, wall.normal);
      for (const StaticWall& wall : walls) {
        if (wall.corners.empty()) continue;
        const auto count = static_cast<Eigen::Index>(wall.corners.size());
        const Eigen::Matrix3Xd vertices = Eigen::Map<const Eigen::Matrix3Xd>(wall.corners.front().data(), 3, count);
        std::vector<Eigen::Vector3i> triangles;
        for (int i = 0; i < static_cast<int>(count); i += 3) triangles.emplace_back(i, i + 1, i + 2);
        try {
          surface->add_triangles(vertices, triangles);
        } catch (const InputError& error) {
          throw InputError("wall " + wall.name + ": " + error.what());
        }
      }
    }
    if (surface->empty()) continue;
    double across = 0.0;
    entry.walls->sides = surface->sides_of(places_at_start(mechanism.model, entry.places, kGround), across);
    const int body = entry.force.of(mechanism.model).bodies()[0];
    const std::string& name = mechanism.model.body(body).name();
    if (across > kDepth * reach(boundary_of(mechanism, body)))
      throw InputError(
          code::kAcrossWall, "contacts: body \"", name, "\" is on both sides of a wall at the start, by ", across,
          " m, so the wall cannot hold it; move it, or exclude it from the entry with walls = true (bodies)");
    entry.walls->surface = surface;
  }
}

}  // namespace footfall

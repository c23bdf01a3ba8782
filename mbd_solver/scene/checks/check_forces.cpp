// The checks of struts, springs, forces, controllers, signals and drives.

#include <algorithm>
#include <cmath>
#include <set>

#include "coupler/base/concat.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/model/elements/cable.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {
using namespace code;

namespace {

// U rising from 0 to 1, the second column not negative and never falling.
void check_voltage_table(const EntryFindings& at, const std::string& key, const std::vector<Eigen::Vector2d>& table) {
  if (table.empty()) return;
  at.error_if(table.front()[0] != 0.0 || table.back()[0] != 1.0, kVoltageTable, key, "covers U from ", table.front()[0],
              " to ", table.back()[0], ", expected from 0 to 1");
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double before = i ? table[i - 1][1] : 0.0;
    if (table[i][1] >= before) continue;
    at.error(kVoltageTable, key, "falls to ", table[i][1], " at U = ", table[i][0],
             ", expected values that never fall as U rises");
    return;
  }
}

// An output of a controller, "CONTROLLER.OUTPUT".
struct OutputName {
  std::string name;
};

std::vector<OutputName> outputs_of(const Scene& scene) {
  std::vector<OutputName> outputs;
  for (const ControllerSpec& c : scene.controllers)
    for (const std::string& output : c.outputs) outputs.push_back({c.name + "." + output});
  return outputs;
}

void check_mr(const Scene& scene, const MrSpec& mr, const std::vector<OutputName>& outputs, const NameIndex& index,
              const EntryFindings& at) {
  if (mr.geometry) {
    at.error_if(at.given("mr.yield_force") || at.given("mr.yield_table") || at.given("mr.viscous"), kConflictingKeys,
                "mr.geometry", "gives the forces, as do yield_force, yield_table and viscous; keep one of the two");
    check_voltage_table(at, "mr.geometry.yield_stress", mr.geometry->tau_y);
    at.error_if(mr.geometry->d1 >= mr.geometry->D1, kOutOfRange, "mr.geometry.d1",
                "is not less than D1; the core must fit into the bypass cylinder");
  } else {
    at.missing_if(!at.given("mr.yield_force") && mr.yield_table.empty(), "mr.yield_force",
                  "give it [N], a yield_table, or geometry");
    at.missing_if(!at.given("mr.viscous"), "mr.viscous", "give it [N s/m], or geometry");
  }
  check_voltage_table(at, "mr.yield_table", mr.yield_table);
  check_signal_name(scene, at, "mr.signal", mr.signal);
  at.error_if(!mr.signal.empty() && (at.given("mr.voltage") || !mr.controller.empty()), kConflictingKeys, "mr.signal",
              "gives the voltage, as does a controller or voltage; keep one of them");
  if (mr.controller.empty()) return;
  at.given_twice_if(at.given("mr.voltage"), "mr.voltage", "the controller");
  check_known(at, kUnknownOutput, "mr.controller", "controller output", "outputs", mr.controller, outputs, index);
}

void check_honeycomb(const HoneycombSpec& h, const EntryFindings& at) {
  at.missing_if(h.stages.empty(), "honeycomb.stages", "expected at least one { force, length }");
  at.error_if(!h.compression && !h.tension, kEmptyEntry, "honeycomb",
              "acts neither in compression nor in tension; allow one of them");
  for (std::size_t i = 1; i < h.stages.size(); ++i)
    at.error_if(h.stages[i].crush_force < h.stages[i - 1].crush_force, kHoneycomb, "honeycomb.stages", "stage ", i + 1,
                " is softer than the one before; the softest crushes first, so list it first");
  at.error_if(h.bottom_out_stiffness >= h.elastic_stiffness, kHoneycomb, "honeycomb.bottom_out_stiffness", "is ",
              h.bottom_out_stiffness, " N/m, expected less than elastic_stiffness, ", h.elastic_stiffness, " N/m");
  for (const HoneycombStage& stage : h.stages)
    at.error_if(stage.crush_length > 0.0 && stage.crush_length < h.transition_length, kHoneycomb,
                "honeycomb.transition_length", "is ", h.transition_length,
                " m, expected at most the length of the shortest stage");
}

void check_stops(const StrutSpec& strut, const EntryFindings& at) {
  if (strut.stops) {
    const std::optional<double>&min = strut.stops->smallest_stroke, &max = strut.stops->largest_stroke;
    at.error_if(!min && !max, kEmptyEntry, "stops",
                "limit nothing; give min, max or both (strokes, compression positive)");
    if (min && max) check_min_below_max(at, "stops.", *min, *max, Unit::kLength);
  }
  if (!strut.gas || !at.source().good("gas.piston_diameter") || !at.source().good("gas.volume")) return;
  const double diameter = strut.gas->piston_diameter;
  const double limit = strut.gas->initial_volume / (0.25 * kPi * diameter * diameter);
  const std::string text =
      concat("the gas is compressed to nothing at a stroke of ", limit, " m (volume / piston area)");
  if (!strut.stops || !strut.stops->largest_stroke) {
    at.error(kGasVolume, "stops.max", "is missing; ", text, ", so the strut needs a stop before it");
  } else if (*strut.stops->largest_stroke >= limit) {
    at.error(kGasVolume, "stops.max", "is ", *strut.stops->largest_stroke, " m, but ", text);
  }
}

bool is_flexible(const Scene& scene, const std::string& name) {
  const BodySpec* body = scene.body(name);
  return body != nullptr && body->flexible && body->flexible->enabled;
}

constexpr double kMostFleet = 0.5;  // rad, between a span and the plane of its pulley

// What keeps guide i from being one; empty if nothing does.
std::string fault_of_guide(const CableSpec& cable, std::size_t i) {
  const CableGuideSpec& guide = cable.path[i];
  if (guide.radius > 0.0 && !guide.axis)
    return "has a radius, but no axis about which the cable runs by the right hand";
  if (guide.radius == 0.0 && (guide.axis || guide.grip || guide.turns > 0))
    return "is a point; axis, grip and turns belong to a pulley, which has a radius";
  for (const std::size_t other : {i - 1, i + 1}) {  // i - 1 of the first is beyond the end
    if (other >= cable.path.size()) continue;
    const Eigen::Vector3d d = cable.path[other].point - guide.point;
    if (d.isZero(0.0)) return concat("is at the same place as guide ", other + 1);
    if (!guide.axis) continue;
    const double fleet = std::asin(std::min(1.0, std::abs(d.normalized().dot(*guide.axis))));
    if (fleet > kMostFleet)
      return concat("has its centre ", number_text(fleet * 180.0 / kPi, 3), " degrees out of the line to guide ",
                    other + 1, ", seen in the plane of the pulley; expected at most ",
                    number_text(kMostFleet * 180.0 / kPi, 2), ": turn its axis, or add a guide between them");
  }
  return "";
}

// Boundaries, contacts, ground and particles.

bool is_flexible(const BodySpec& body) { return body.flexible && body.flexible->enabled; }

void check_surface(const BodySpec& body, const SurfaceSpec& surface, const EntryFindings& at) {
  const bool own_mesh =
      has_model_mesh(body) || (is_flexible(body) && (!body.flexible->mesh.empty() || !body.flexible->file.empty()));
  const bool from_file = !surface.file.empty();
  at.error_if(!from_file && !own_mesh && (!body.shape || body.shape->kind == ShapeKind::kPoints), kNoSurface, "surface",
              "cannot be generated: body \"", body.name,
              "\" has no shape with a surface; give surface.file or a shape");
  const bool shape_is_mesh = body.shape && body.shape->kind == ShapeKind::kMesh && !own_mesh;
  at.no_effect_if((from_file || shape_is_mesh) && at.given("surface.element_size") && surface.from_script.empty(),
                  "surface.element_size", "a mesh from a file");
  at.error_if(!from_file && !shape_is_mesh && at.given("surface.triangles"), kKeyWithoutEffect, "surface.triangles",
              "belongs to a mesh from a file, which the surface of \"", body.name,
              "\" is not; give element_size, or remove it");
  for (const char* key : {"surface.scale", "surface.position", "surface.orientation"})
    at.error_if(!from_file && at.given(key), kKeyWithoutEffect, key, "belongs to a surface from a file; remove it");
  if (!at.given("surface.faces")) return;
  const bool drawn = !from_file && body.shape && !own_mesh;
  const bool disc = drawn && body.shape->kind == ShapeKind::kDisc, dish = drawn && body.shape->kind == ShapeKind::kDish;
  at.error_if(!disc && !dish, kKeyWithoutEffect, "surface.faces", "belongs to a disc or dish, which the surface of \"",
              body.name, "\" is not; remove it");
  at.error_if(dish && surface.faces == SurfaceFaces::kBoth, kUnknownChoice, "surface.faces",
              "is \"both\", but a dish has its mid-surface only; expected \"middle\"");
}

void check_beams(const BodySpec& body, const BeamsSpec& beams, const EntryFindings& at) {
  const bool round = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod);
  const bool frame = is_flexible(body) && !body.flexible->nodes.empty();
  at.missing_if(!round && !frame && beams.points.empty(), "beams.points", "only a tube or rod has an axis to follow");
  at.error_if(beams.points.size() == 1, kWrongCount, "beams.points", "is one point, expected two or more");
  at.missing_if(!round && !(beams.radius > 0.0), "beams.radius", "only a tube or rod has a diameter");
}

// Longest edge of the generated triangles of a round shape [m], and the key that sets it.
struct EdgeOfFace {
  double length = 0.0;
  std::string key;
};

EdgeOfFace edge_of_face(const Scene& scene, const BodySpec& body, const SurfaceSpec& surface) {
  constexpr double kOfSize = 0.1,
                   kOfPlate = 0.25;  // defaults: of the largest size; of the radius of a plate that bends
  const ShapeSpec& shape = *body.shape;
  const bool plate =
      scene.flexible && is_flexible(body) && shape.kind != ShapeKind::kCylinder && surface.faces != SurfaceFaces::kBoth;
  if (plate) {
    const double size = body.flexible->mesh_size;
    return {size > 0.0 ? size : kOfPlate * shape.radius, "bodies." + body.name + ".flexible.mesh_size"};
  }
  const double largest = std::max(2.0 * shape.radius, shape.kind == ShapeKind::kCylinder ? shape.length : 0.0);
  return {surface.element_size > 0.0 ? surface.element_size : kOfSize * largest, "surface.element_size"};
}

// Grains touch the polygon of n corners on the circle of a face, with n / (2 pi) sin(2 pi / n) of its area.
void check_area_of_face(const Scene& scene, const BodySpec& body, const SurfaceSpec& surface, const EntryFindings& at) {
  constexpr double kLostArea = 0.025;      // share of the circle that is reported
  constexpr double kFaceDown = 0.7;        // cosine of the axis and gravity; else it touches with its rim
  constexpr int kPerRing = 6, kRings = 4;  // corners of each ring; rings that are proposed
  if (!scene.touches_particles() || !body.shape || !surface.file.empty() || !surface.from_script.empty()) return;
  const ShapeSpec& shape = *body.shape;
  const bool round =
      shape.kind == ShapeKind::kDisc || shape.kind == ShapeKind::kDish || shape.kind == ShapeKind::kCylinder;
  const bool own_mesh = body.flexible && (!body.flexible->mesh.empty() || !body.flexible->file.empty());
  if (!round || own_mesh || has_model_mesh(body)) return;
  if (std::abs(shape.axis.normalized().dot(up_direction(scene.gravity))) < kFaceDown) return;
  const EdgeOfFace edge = edge_of_face(scene, body, surface);
  double way = shape.radius;  // from the centre of the face to its rim, along a dish
  if (shape.kind == ShapeKind::kDish) {
    const double sphere = (shape.radius * shape.radius + shape.depth * shape.depth) / (2.0 * shape.depth);
    way = sphere * std::atan2(shape.radius, sphere - shape.depth);
  }
  if (!(edge.length > 0.0) || !(way > 0.0)) return;  // reported elsewhere
  const auto share = [](int corners) { return corners / (2.0 * kPi) * std::sin(2.0 * kPi / corners); };
  const int corners = kPerRing * std::max(1, static_cast<int>(std::ceil(way / edge.length - 1e-9)));
  if (share(corners) >= 1.0 - kLostArea) return;
  at.warning(kPolygonArea, "surface", "makes the round face of \"", body.name, "\" a polygon of ", corners,
             " corners, with ", number_text(100.0 * share(corners), 3),
             " % of the area of the circle, and grains carry it by so much less; give ", edge.key, " = ",
             number_text(way / kRings, 3), " (", kPerRing * kRings, " corners, ",
             number_text(100.0 * share(kPerRing * kRings), 3), " %) or less");
}

void check_boundary(const Scene& scene, const BoundarySpec& boundary, const EntryFindings& at) {
  at.error_if(!boundary.surface && !boundary.beams, kEmptyEntry, "",
              "has neither a surface nor beams; give surface = {} or beams = {}");
  const BodySpec* body = scene.body(boundary.body);
  if (body == nullptr) return;
  if (boundary.surface) check_surface(*body, *boundary.surface, at);
  if (boundary.surface) check_area_of_face(scene, *body, *boundary.surface, at);
  if (boundary.beams) check_beams(*body, *boundary.beams, at);
}

// prefix: before the keys in a message.
void check_law(const Scene& scene, const std::string& prefix, const ContactLawSpec& law, const EntryFindings& at) {
  at.error_if(law.young && law.stiffness, kConflictingKeys, prefix + "stiffness",
              "follows from young, which is given as well; keep one of the two");
  at.missing_if(!law.young && !law.stiffness, prefix + "young", "give young [Pa] or stiffness [N/m^1.5]");
  at.error_if(law.restitution && law.damping, kConflictingKeys, prefix + "damping",
              "follows from restitution, which is given as well; keep one of the two");
  at.error_if(law.restitution && *law.restitution <= 0.0, kOutOfRange, prefix + "restitution",
              "is 0, expected more than 0, at most 1");
  at.missing_if(law.restitution && *law.restitution < 1.0 && !law.impact_speed && scene.initial.velocity.isZero(),
                prefix + "impact_speed",
                "the coefficient of restitution holds at one impact speed, and initial.velocity does not give it");
  at.error_if(!(law.poisson > -1.0 && law.poisson < 0.5), kOutOfRange, prefix + "poisson", "is ", law.poisson,
              ", expected more than -1 and less than 0.5");
}

void check_has_boundary(const Scene& scene, const EntryFindings& at, const char* key, const std::string& name) {
  if (scene.boundary_of(name) == nullptr)
    at.error(kUnknownBoundary, key, "\"", name, "\" has no entry in [[boundaries]].",
             known_names("boundaries", name, boundary_names(scene)));
}

// A flexible body in a scene that is not rigid as a whole.
bool deforms(const Scene& scene, const std::string& name) {
  const BodySpec* body = scene.body(name);
  return scene.flexible && body != nullptr && is_flexible(*body);
}

void check_between(const Scene& scene, const ContactSpec& contact, const EntryFindings& at) {
  if (contact.between.size() != 2) {
    at.error(kWrongCount, "between", "contains ", contact.between.size(),
             " names, expected two bodies, or a body and \"plane\" (or walls = true instead)");
    return;
  }
  const std::string &first = contact.between[0], &second = contact.between[1];
  check_has_boundary(scene, at, "between", first);
  if (!contact.with_plane()) check_has_boundary(scene, at, "between", second);
  at.error_if(first == second, kListedTwice, "between", "contains \"", first, "\" twice");
  at.error_if(contact.ignore && contact.with_plane(), kConflictingKeys, "ignore",
              "is for two bodies; a body without contact with a plane needs no entry");
  at.error_if(!contact.ignore && deforms(scene, first) && deforms(scene, second), kFlexibleContact, "between",
              "names two flexible bodies; expected at most one, whose nodes touch the surface of the rigid one");
}

void check_contacts(const Scene& scene, Findings& findings) {
  std::set<std::pair<std::string, std::string>> pairs;  // of the entries so far
  std::set<std::string> at_walls;
  bool all_at_walls = false;
  for (const ContactSpec& contact : scene.contacts) {
    const EntryFindings at(findings, contact.source);
    if (contact.walls) {
      at.error_if(!contact.between.empty(), kConflictingKeys, "walls", "excludes between; give each of them an entry");
      at.error_if(contact.ignore, kConflictingKeys, "ignore", "is for two bodies, not for walls");
      at.error_if(!scene.touches_particles(), kGroundIncomplete, "walls",
                  "belong to a LIGGGHTS script, but ground.kind is not \"particles\"");
      at.error_if(scene.boundaries.empty(), kGroundIncomplete, "walls", "touch [[boundaries]], but the scene has none");
      for (const std::string& name : contact.bodies) check_has_boundary(scene, at, "bodies", name);
    } else {
      check_between(scene, contact, at);
      at.error_if(!contact.bodies.empty(), kConflictingKeys, "bodies",
                  "belongs to walls = true; between names its bodies");
    }
    for (const char* key : {"point", "normal"})
      at.error_if(at.given(key) && !contact.with_plane(), kKeyWithoutEffect, key,
                  "belongs to a plane: between = [\"BODY\", \"plane\"]");
    if (!contact.ignore) check_law(scene, "", contact, at);
    bool again = contact.between.size() == 2 && !contact.with_plane() &&
                 !pairs.insert(std::minmax(contact.between[0], contact.between[1])).second;
    if (contact.walls) {
      again = again || all_at_walls || (contact.bodies.empty() && !at_walls.empty());
      for (const std::string& body : contact.bodies) again = again || at_walls.count(body) > 0;
      all_at_walls = all_at_walls || contact.bodies.empty();
      at_walls.insert(contact.bodies.begin(), contact.bodies.end());
    }
    at.error_if(again, kListedTwice, contact.walls ? "walls" : "between",
                "are in an earlier entry already: the contact would count twice");
  }
}

// Signals, states and events.

// "signal.pitch" with the prefix "signal.": "pitch".
bool cut_prefix(const std::string& text, const std::string& prefix, std::string& rest) {
  if (text.rfind(prefix, 0) != 0) return false;
  rest = text.substr(prefix.size());
  return true;
}

void check_state_name(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& name) {
  check_known(at, kUnknownState, key, "state", "states", name, scene.states, scene.indices.states);
}

// It can be read, and the signals and states that it names exist. Columns are known when the mechanism is built.
void check_expression(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& text) {
  if (text.empty()) return;
  try {
    for (const std::string& name : Expression::names_in(text)) {
      std::string rest;
      if (cut_prefix(name, "signal.", rest)) check_signal_name(scene, at, key, rest);
      if (name == "state.since") {
        at.error_if(scene.states.empty(), kUnknownState, key,
                    "uses state.since, but there are no [[states]]; add them");
      } else if (cut_prefix(name, "state.", rest)) {
        check_state_name(scene, at, key, rest);
      }
    }
  } catch (const InputError& error) {
    at.all().coded_error(at.source(), key, error.what());
  }
}

bool is_filter(SignalKind kind) {
  return kind == SignalKind::kLowpass || kind == SignalKind::kLowpass2 || kind == SignalKind::kNotch;
}

void check_rising(const EntryFindings& at, const std::string& key, const std::vector<double>& x) {
  at.error_if(x.size() < 2, kWrongCount, key, "has fewer than two values, expected at least two, rising");
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] > x[i - 1]) continue;
    at.error(kNotRising, key, "has ", x[i], " after ", x[i - 1], ", expected rising values");
    return;
  }
}

void check_limits_of(const SignalSpec& s, const EntryFindings& at) {
  if (s.min && s.max) check_min_below_max(at, "", *s.min, *s.max, Unit::kNone);
  at.error_if(s.kind == SignalKind::kSaturation && !s.min && !s.max, kEmptyEntry, "",
              "limits nothing; give min, max or both");
  if (s.kind != SignalKind::kPid) return;
  at.missing_if(s.kp == 0.0 && s.ki == 0.0 && s.kd == 0.0, "kp", "give at least one of kp, ki, kd");
  at.error_if((s.min || s.max) && s.ki > 0.0 && s.kp == 0.0, kNeedsOtherKey, "kp",
              "is missing; a limited pid with ki needs kp > 0, which scales the correction of its integral");
  at.error_if(s.kd > 0.0 && s.rate.empty() && s.derivative_frequency == 0.0 && s.period == 0.0, kNeedsOtherKey,
              "derivative_frequency",
              "is missing; a continuous pid with kd needs it (Hz), or rate = \"...\", the input's derivative");
  at.error_if(!s.rate.empty() && s.kd == 0.0, kNeedsOtherKey, "rate", "has no effect without kd; add kd");
}

void check_table(const SignalSpec& s, const EntryFindings& at) {
  const auto refused = [&](const char* key) { return s.source.refused.count(key) > 0; };
  if (s.kind == SignalKind::kTable && !refused("points")) {
    std::vector<double> x;
    for (const Eigen::Vector2d& point : s.points) x.push_back(point.x());
    check_rising(at, "points", x);
  }
  if (s.kind != SignalKind::kTable2 || refused("x") || refused("x2") || refused("input2") || refused("values")) return;
  check_rising(at, "x", s.x);
  check_rising(at, "x2", s.x2);
  at.missing_if(s.input2.empty(), "input2", "this kind of signal has two inputs");
  at.error_if(s.values.size() != s.x.size() * s.x2.size(), kWrongCount, "values", "contains ", s.values.size(),
              " numbers, expected one for each pair of x and x2 (", s.x.size() * s.x2.size(), ")");
}

void check_signal(const Scene& scene, const SignalSpec& s, const EntryFindings& at) {
  check_kind_keys(at, s.kind, "signal");
  for (const auto& [key, text] : {std::pair("input", &s.input), {"input2", &s.input2}, {"rate", &s.rate}})
    check_expression(scene, at, key, *text);
  for (const std::string& input : s.inputs) check_expression(scene, at, "inputs", input);
  for (const std::string& state : s.states) check_state_name(scene, at, "states", state);
  check_limits_of(s, at);
  check_table(s, at);
  // needs(condition, key, why): a key that this kind cannot do without; refused values are reported already.
  const auto needs = [&](bool missing, const std::string& key, const std::string& why) {
    if (missing && s.source.refused.count(key) == 0)
      at.error(kMissingKey, key, (at.given(key) ? "is 0; " : "is missing; ") + why);
  };
  const bool foreign = s.is_foreign(), fuzzy = s.kind == SignalKind::kFuzzy, host = s.kind == SignalKind::kHost,
             rate_limit = s.kind == SignalKind::kRateLimit;
  at.no_effect_if(host && at.given("period"), "period", "a signal that the leading program sets");
  at.no_effect_if(host && at.given("states"), "states", "a signal that the leading program sets");
  needs(!fuzzy && !foreign && !host && s.input.empty(), "input", "expected an expression such as \"0.3 - knee.angle\"");
  needs(is_filter(s.kind) && !(s.frequency > 0.0), "frequency", "a filter needs it (Hz), expected more than 0");
  needs(rate_limit && !(s.max_rate > 0.0), "max_rate", "expected more than 0, per second");
  needs(rate_limit && s.period == 0.0, "period", "a rate limit is sampled, for example period_ms = 1");
  needs(fuzzy && s.file.empty(), "file", "a fuzzy signal is read from an .fll file");
  needs(fuzzy && s.inputs.empty(), "inputs", "expected one expression per input variable of the file");
  at.error_if(fuzzy && !s.input_names.empty(), kWrongType, "inputs", "is a table, expected a list of expressions");
  if (foreign) check_foreign(scene, s, at);
}

void check_states(const Scene& scene, Findings& findings) {
  check_unique_names(scene.states, "state", findings);
  check_unique_names(scene.events, "event", findings);
  for (const StateSpec& state : scene.states)
    if (state.name == "since")
      findings.error(kReservedName, state.source, "name",
                     "\"since\" is the time in the present state; choose another name");
  if (scene.states.size() == 1)
    findings.error(kWrongCount, scene.states[0].source, "",
                   "is the only state, expected a second state to which an event changes");
  for (const EventSpec& event : scene.events) {
    const EntryFindings at(findings, event.source);
    check_expression(scene, at, "when", event.when);
    if (!event.to.empty() && scene.states.empty()) {
      at.error(kUnknownState, "to", "names a state, but there are no [[states]]; list them, the initial one first");
      continue;
    }
    check_state_name(scene, at, "to", event.to);
    for (const std::string& state : event.from) check_state_name(scene, at, "from", state);
    at.error_if(is_in(event.from, event.to), kListedTwice, "from", "contains \"", event.to,
                "\", to which the event changes; remove it");
  }
}

}  // namespace

void check_struts(const Scene& scene, Findings& findings) {
  check_unique_names(scene.struts, "strut", findings);
  const std::vector<OutputName> outputs = outputs_of(scene);
  const NameIndex index;
  for (const StrutSpec& strut : scene.struts) {
    const EntryFindings at(findings, strut.source);
    check_pair(scene, at, strut.bodies);
    at.error_if(at.given("points") && !((strut.points[1] - strut.points[0]).norm() > 0.0), kShape, "points",
                "are the same; a strut needs two different ones");
    bool any = false;
    std::vector<std::string> sections;
    each_law(strut, [&](const char* key, const auto& law) {
      any = any || law;
      sections.emplace_back(key);
    });
    at.error_if(!any, kEmptyEntry, "", "has no force law; give at least one of ", joined(sections));
    if (strut.mr) check_mr(scene, *strut.mr, outputs, index, at);
    if (strut.honeycomb) check_honeycomb(*strut.honeycomb, at);
    check_stops(strut, at);
  }
}

void check_cables(const Scene& scene, Findings& findings) {
  check_unique_names(scene.cables, "cable", findings);
  for (const CableSpec& cable : scene.cables) {
    const EntryFindings at(findings, cable.source);
    at.missing_if(cable.path.size() < 2, "path", "expected two guides or more, each with body and point");
    at.missing_if(!cable.stiffness && !cable.EA, "stiffness", "give stiffness [N/m] or EA [N]");
    at.error_if(cable.stiffness && cable.EA, kConflictingKeys, "EA",
                "gives the stiffness of the cable, as does stiffness; keep one of the two");
    at.error_if((cable.length ? 1 : 0) + (cable.slack ? 1 : 0) + (cable.tension ? 1 : 0) > 1, kConflictingKeys,
                cable.tension ? "tension" : "slack", "follows from another of length, slack and tension; keep one");
    if (cable.path.size() < 2) continue;
    at.error_if(cable.length && cable.ends().size() > 2, kConflictingKeys, "length",
                "belongs to a single cable, but a pulley with grip = true divides it; give slack or tension");
    bool known = true, moves = false;
    for (const CableGuideSpec& guide : cable.path) {
      if (guide.body != "ground") check_body_name(scene, at, "path", guide.body);
      moves = moves || guide.body != "ground";
    }
    at.error_if(!moves, kCablePath, "path", "names the ground alone; a cable acts on one body at least");
    for (std::size_t i = 0; i < cable.path.size(); ++i) {
      const std::string fault = fault_of_guide(cable, i);
      if (fault.empty()) continue;
      known = false;
      at.error(kCablePath, "path", "guide ", i + 1, " ", fault);
    }
    if (!known) continue;
    std::vector<CablePlace> places;
    for (const CableGuideSpec& guide : cable.path)
      places.push_back({guide.point, guide.axis.value_or(Eigen::Vector3d::UnitZ()), guide.radius});
    double spans = 0.0;
    try {
      touch(places, spans);
    } catch (const NumericalError& error) {
      at.error(kCablePath, "path", error.what());
    }
  }
}

void check_springs(const Scene& scene, Findings& findings) {
  check_unique_names(scene.springs, "spring", findings);
  for (const SpringSpec& spring : scene.springs) {
    if (!spring.source.good("kind")) continue;
    const EntryFindings at(findings, spring.source);
    check_pair(scene, at, spring.bodies);
    const bool torsion = spring.kind == SpringKind::kTorsion, bushing = spring.kind == SpringKind::kBushing;
    const auto flexible = std::find_if(spring.bodies.begin(), spring.bodies.end(),
                                       [&](const std::string& name) { return is_flexible(scene, name); });
    if (torsion && !at.given("point") && flexible != spring.bodies.end())
      at.error(kPointOfAction, "point", "is missing; \"", *flexible, "\" is flexible and is turned at a point");
    at.missing_if(torsion && !at.given("axis"), "axis", "a torsion spring turns about it");
    at.missing_if(bushing && !at.given("point"), "point", "a bushing acts there");
    check_kind_keys(at, spring.kind, "spring");
    const auto uniform = [](const Eigen::Vector3d& k) { return k.x() == k.y() && k.y() == k.z(); };
    at.error_if(!bushing && !(uniform(spring.stiffness) && uniform(spring.damping)), kWrongCount,
                uniform(spring.damping) ? "stiffness" : "damping",
                "is a list, expected one number; only a bushing has a value for each axis");
    at.error_if(bushing && std::abs(spring.axis.dot(spring.axis2)) > 0.999, kJointGeometry, "axis2",
                "is parallel to axis, expected the x direction of the bushing, perpendicular to its z = axis");
    at.error_if(
        (spring.stiffness + spring.damping + spring.rotational_stiffness + spring.rotational_damping).isZero(0.0),
        kEmptyEntry, "", "has neither stiffness nor damping; give one of them");
  }
}

void check_forces(const Scene& scene, Findings& findings) {
  check_unique_names(scene.forces, "force", findings);
  for (const ForceSpec& force : scene.forces) {
    const EntryFindings at(findings, force.source);
    check_body_name(scene, at, "body", force.body);
    check_function(at, "force", force.force);
    check_function(at, "torque", force.torque);
    if (force.force) check_signal_name(scene, at, "force.signal", force.force->signal);
    if (force.torque) check_signal_name(scene, at, "torque.signal", force.torque->signal);
    at.error_if(!force.force && !force.torque, kEmptyEntry, "",
                "has neither force nor torque; for example force = { polynomial = [10] } [N]");
    at.error_if(!force.point && is_flexible(scene, force.body), kPointOfAction, "point", "is missing; \"", force.body,
                "\" is flexible and is pushed at a point");
  }
}

void check_controllers(const Scene& scene, Findings& findings) {
  check_unique_names(scene.controllers, "controller", findings);
  for (const ControllerSpec& c : scene.controllers) {
    if (!c.source.good("kind")) continue;
    const EntryFindings at(findings, c.source);
    const std::size_t outputs = c.outputs.size();
    check_body_name(scene, at, "body", c.body);
    at.error_if(at.given("outputs") && outputs == 0, kWrongCount, "outputs",
                "is empty; expected names such as [\"U1\", \"U2\"]");
    for (auto it = c.outputs.begin(); it != c.outputs.end(); ++it)
      at.error_if(std::find(c.outputs.begin(), it, *it) != it, kListedTwice, "outputs", "contains \"", *it, "\" twice");
    for (const std::string& key : keys_of_other_kinds(c.kind))
      if (c.source.written_together("kind", key))
        at.warning(kUnusedKey, key, "has no effect on this kind of controller");
    const bool constant = c.kind == ControllerKind::kConstant, fuzzy = c.kind == ControllerKind::kFuzzy;
    at.missing_if(fuzzy && c.file.empty(), "file", "a fuzzy controller is read from an .fll file");
    at.error_if(constant && c.voltages.size() != 1 && c.voltages.size() != outputs, kWrongCount, "voltages",
                "contains ", c.voltages.size(), " numbers, expected one, or one per output (", outputs, ")");
    at.error_if(fuzzy && (c.grid.size() != 4 || *std::min_element(c.grid.begin(), c.grid.end()) < 2), kWrongCount,
                "grid", "is no grid; expected four numbers of at least 2: points along a, da, alpha, beta");
    at.error_if(c.kind == ControllerKind::kSkyhook && c.skyhook.off > c.skyhook.on, kRangeReversed, "off",
                "is more than on, expected at most on");
  }
}

void check_contact(const Scene& scene, Findings& findings) {
  for (const BoundarySpec& boundary : scene.boundaries) {
    const EntryFindings at(findings, boundary.source);
    check_body_name(scene, at, "body", boundary.body);
    at.error_if(!boundary.body.empty() && scene.boundary_of(boundary.body) != &boundary, kListedTwice, "body", "\"",
                boundary.body, "\" already has a boundary; put surface and beams into one entry");
    check_boundary(scene, boundary, at);
  }
  check_contacts(scene, findings);
  const GroundKind kind = scene.ground.kind;
  const EntryFindings at(findings, scene.ground.source);
  if (scene.ground.plane) {
    check_law(scene, "plane.", *scene.ground.plane, at);
    for (const std::string& name : scene.ground.plane->bodies) check_has_boundary(scene, at, "plane.bodies", name);
  }
  check_soil(scene, findings);
  at.error_if(kind == GroundKind::kPlane && !scene.ground.plane, kGroundIncomplete, "plane",
              "is missing; ground.kind = \"plane\" needs [ground.plane]");
  at.error_if(kind == GroundKind::kParticles && !scene.particles, kGroundIncomplete, "kind",
              "is \"particles\", but there is no [particles] section with a script or a box");
  if (kind == GroundKind::kParticles && scene.particles && scene.particles->script.empty() && !scene.particles->box)
    findings.error(kMissingKey, scene.particles->source, "script",
                   "is missing; name a LIGGGHTS script, or give [particles.box] for a simple bed");
  if (kind == GroundKind::kNone && scene.particles && !scene.ground.source.given("kind"))
    findings.warning(kGrainsNotUsed, scene.particles->source, "",
                     "has no effect, because the scene names no ground: the mechanism runs without LIGGGHTS. Add "
                     "[ground] with kind = \"particles\", or with kind = \"none\" if this is intended");
  at.error_if(kind != GroundKind::kNone && scene.boundaries.empty(), kGroundIncomplete, "kind",
              "gives a ground that nothing touches; add [[boundaries]], or set kind = \"none\"");
  if (scene.initial.clearance && kind == GroundKind::kNone)
    findings.error(kGroundIncomplete, scene.initial.source, "clearance",
                   "is measured from the ground, but ground.kind is \"none\"; remove it, or give a ground");
}

void check_signals(const Scene& scene, Findings& findings) {
  check_unique_names(scene.signals, "signal", findings);
  for (const SignalSpec& signal : scene.signals)
    if (signal.source.good("kind")) check_signal(scene, signal, {findings, signal.source});
  check_states(scene, findings);
}

void for_each_function(const Scene& scene,
                       const std::function<void(const Source&, const std::string&, const TimeFunctionSpec&)>& visit) {
  const auto give = [&](const Source& source, const char* key, const std::optional<TimeFunctionSpec>& f) {
    if (f) visit(source, key, *f);
  };
  for (const JointSpec& joint : scene.joints) {
    if (!joint.motion) continue;
    give(joint.source, "motion.x", joint.motion->x);
    give(joint.source, "motion.y", joint.motion->y);
    give(joint.source, "motion.z", joint.motion->z);
    give(joint.source, "motion.rotation", joint.motion->rotation);
  }
  for (const DriveSpec& drive : scene.drives) give(drive.source, "command", drive.command);
  for (const ForceSpec& force : scene.forces) {
    give(force.source, "force", force.force);
    give(force.source, "torque", force.torque);
  }
}

}  // namespace footfall

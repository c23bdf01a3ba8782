// Struts, springs, forces and controllers.
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

namespace {

// U rising from 0 to 1, the second column not negative and never falling.
void check_voltage_table(const EntryFindings& at, const std::string& key, const std::vector<Eigen::Vector2d>& table) {
  if (table.empty()) return;
  at.error_if(table.front()[0] != 0.0 || table.back()[0] != 1.0, kVoltageTable, key,
              "covers U from " + number_text(table.front()[0]) + " to " + number_text(table.back()[0]) +
                  ", expected from 0 to 1");
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double before = i ? table[i - 1][1] : 0.0;
    if (table[i][1] >= before) continue;
    at.error(kVoltageTable, key,
             "falls to " + number_text(table[i][1]) + " at U = " + number_text(table[i][0]) +
                 ", expected values that never fall as U rises");
    return;
  }
}

void check_mr(const Scene& scene, const MrSpec& mr, const EntryFindings& at) {
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
  std::vector<std::string> outputs;
  for (const ControllerSpec& c : scene.controllers)
    for (const std::string& output : c.outputs) outputs.push_back(c.name + "." + output);
  check_known(at, kUnknownOutput, "mr.controller", "controller output", "outputs", mr.controller, outputs);
}

void check_honeycomb(const HoneycombSpec& h, const EntryFindings& at) {
  at.missing_if(h.stages.empty(), "honeycomb.stages", "expected at least one { force, length }");
  at.error_if(!h.compression && !h.tension, kEmptyEntry, "honeycomb",
              "acts neither in compression nor in tension; allow one of them");
  for (std::size_t i = 1; i < h.stages.size(); ++i)
    at.error_if(h.stages[i].crush_force < h.stages[i - 1].crush_force, kHoneycomb, "honeycomb.stages",
                "stage " + std::to_string(i + 1) +
                    " is softer than the one before; the softest crushes first, so list it first");
  at.error_if(h.bottom_out_stiffness >= h.elastic_stiffness, kHoneycomb, "honeycomb.bottom_out_stiffness",
              "is " + number_text(h.bottom_out_stiffness) + " N/m, expected less than elastic_stiffness, " +
                  number_text(h.elastic_stiffness) + " N/m");
  for (const HoneycombStage& stage : h.stages)
    at.error_if(stage.crush_length > 0.0 && stage.crush_length < h.transition_length, kHoneycomb,
                "honeycomb.transition_length",
                "is " + number_text(h.transition_length) + " m, expected at most the length of the shortest stage");
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
      "the gas is compressed to nothing at a stroke of " + number_text(limit) + " m (volume / piston area)";
  if (!strut.stops || !strut.stops->largest_stroke) {
    at.error(kGasVolume, "stops.max", "is missing; " + text + ", so the strut needs a stop before it");
  } else if (*strut.stops->largest_stroke >= limit) {
    at.error(kGasVolume, "stops.max", "is " + number_text(*strut.stops->largest_stroke) + " m, but " + text);
  }
}

bool is_flexible(const Scene& scene, const std::string& name) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const BodySpec& body) {
    return body.name == name && body.flexible && body.flexible->enabled;
  });
}

}  // namespace

void check_struts(const Scene& scene, Findings& findings) {
  check_unique_names(scene.struts, "strut", findings);
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
    at.error_if(!any, kEmptyEntry, "", "has no force law; give at least one of " + joined(sections));
    if (strut.mr) check_mr(scene, *strut.mr, at);
    if (strut.honeycomb) check_honeycomb(*strut.honeycomb, at);
    check_stops(strut, at);
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
      at.error(kPointOfAction, "point", "is missing; \"" + *flexible + "\" is flexible and is turned at a point");
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
    at.error_if(!force.point && is_flexible(scene, force.body), kPointOfAction, "point",
                "is missing; \"" + force.body + "\" is flexible and is pushed at a point");
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
      at.error_if(std::find(c.outputs.begin(), it, *it) != it, kListedTwice, "outputs",
                  "contains \"" + *it + "\" twice");
    for (const std::string& key : foreign_keys(c.kind))
      if (c.source.written_together("kind", key))
        at.warning(kUnusedKey, key, "has no effect on this kind of controller");
    const bool constant = c.kind == ControllerKind::kConstant, fuzzy = c.kind == ControllerKind::kFuzzy;
    at.missing_if(fuzzy && c.file.empty(), "file", "a fuzzy controller is read from an .fll file");
    at.error_if(constant && c.voltages.size() != 1 && c.voltages.size() != outputs, kWrongCount, "voltages",
                "contains " + std::to_string(c.voltages.size()) + " numbers, expected one, or one per output (" +
                    std::to_string(outputs) + ")");
    at.error_if(fuzzy && (c.grid.size() != 4 || *std::min_element(c.grid.begin(), c.grid.end()) < 2), kWrongCount,
                "grid", "is no grid; expected four numbers of at least 2: points along a, da, alpha, beta");
    at.error_if(c.kind == ControllerKind::kSkyhook && c.skyhook.off > c.skyhook.on, kRangeReversed, "off",
                "is more than on, expected at most on");
  }
}

}  // namespace footfall

// Struts, springs, forces and controllers.
#include <algorithm>
#include <cmath>

#include "coupler/base/nearest_name.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/kind_keys.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

namespace {

// U rising from 0 to 1, the second column not negative and never falling.
void check_voltage_table(const Source& source, const std::string& key, const std::vector<Eigen::Vector2d>& table,
                         Findings& findings) {
  if (table.empty()) return;
  if (table.front()[0] != 0.0 || table.back()[0] != 1.0)
    findings.error(source, key,
                   "runs from U = " + number_text(table.front()[0]) + " to " + number_text(table.back()[0]) +
                       ", expected from 0 to 1");
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double before = i ? table[i - 1][1] : 0.0;
    if (table[i][1] >= before) continue;
    findings.error(source, key,
                   "falls to " + number_text(table[i][1]) + " at U = " + number_text(table[i][0]) +
                       ", expected values that never fall as U rises");
    return;
  }
}

void check_mr(const Scene& scene, const StrutSpec& strut, Findings& findings) {
  const MrSpec& mr = *strut.mr;
  const Source& source = strut.source;
  const bool force = source.given("mr.yield_force") || source.given("mr.yield_table") || source.given("mr.viscous");
  if (mr.geometry && force)
    findings.error(source, "mr.geometry",
                   "stands beside yield_force, yield_table or viscous, which follow from it; keep one");
  if (!mr.geometry) {
    if (!source.given("mr.yield_force") && mr.yield_table.empty())
      findings.error(source, "mr.yield_force", "is missing; give it, a yield_table, or geometry (unit N)");
    if (!source.given("mr.viscous"))
      findings.error(source, "mr.viscous", "is missing; give it, or geometry (unit N s/m)");
  }
  check_voltage_table(source, "mr.yield_table", mr.yield_table, findings);
  if (mr.geometry) {
    check_voltage_table(source, "mr.geometry.yield_stress", mr.geometry->yield_stress, findings);
    if (mr.geometry->d1 >= mr.geometry->D1)
      findings.error(source, "mr.geometry.d1", "is not less than D1; the core must fit into the bypass cylinder");
  }
  check_signal_name(scene, source, "mr.signal", mr.signal, findings);
  if (!mr.signal.empty() && (source.given("mr.voltage") || !mr.controller.empty()))
    findings.error(source, "mr.signal", "stands beside a controller or a voltage; a signal is the voltage, keep one");
  if (mr.controller.empty()) return;
  if (source.given("mr.voltage"))
    findings.error(source, "mr.voltage", "stands beside a controller, which gives the voltage; keep one");
  std::vector<std::string> outputs;
  for (const ControllerSpec& c : scene.controllers) {
    for (const std::string& output : c.outputs) outputs.push_back(c.name + "." + output);
  }
  if (std::find(outputs.begin(), outputs.end(), mr.controller) == outputs.end())
    findings.error(
        source, "mr.controller",
        "there is no controller output \"" + mr.controller + "\"." + known_names("outputs", mr.controller, outputs));
}

void check_honeycomb(const StrutSpec& strut, Findings& findings) {
  const HoneycombSpec& h = *strut.honeycomb;
  if (h.stages.empty())
    findings.error(strut.source, "honeycomb.stages", "are missing; expected at least one { force, length }");
  if (!h.compression && !h.tension)
    findings.error(strut.source, "honeycomb", "works neither in compression nor in tension");
  for (std::size_t i = 1; i < h.stages.size(); ++i) {
    if (h.stages[i].force < h.stages[i - 1].force)
      findings.error(strut.source, "honeycomb.stages",
                     "stage " + std::to_string(i + 1) +
                         " is softer than the one before; the softest crushes first, so list it first");
  }
  if (h.bottom_out_stiffness >= h.elastic_stiffness)
    findings.error(strut.source, "honeycomb.bottom_out_stiffness",
                   "is " + number_text(h.bottom_out_stiffness) + " N/m, expected less than elastic_stiffness, " +
                       number_text(h.elastic_stiffness) + " N/m");
  for (const CrushStageSpec& stage : h.stages) {
    if (stage.length > 0.0 && stage.length < h.transition_length)
      findings.error(strut.source, "honeycomb.transition_length",
                     "is " + number_text(h.transition_length) + " m, expected no more than the shortest stage");
  }
}

void check_stops(const StrutSpec& strut, Findings& findings) {
  if (strut.stops) {
    const StopsSpec& s = *strut.stops;
    if (!s.min && !s.max)
      findings.error(strut.source, "stops", "limit nothing; give min, max or both (strokes, compression positive)");
    if (s.min && s.max) check_min_below_max(strut.source, "stops.", *s.min, *s.max, Unit::kLength, findings);
  }
  if (!strut.gas || !(strut.gas->piston_diameter > 0.0)) return;
  const double limit = strut.gas->volume / (0.25 * kPi * strut.gas->piston_diameter * strut.gas->piston_diameter);
  const std::string text = "the gas is used up at a stroke of " + number_text(limit) + " m (volume / piston area)";
  if (!strut.stops || !strut.stops->max) {
    findings.error(strut.source, "stops.max", "is missing; " + text + ", so the strut needs a stop before it");
  } else if (*strut.stops->max >= limit) {
    findings.error(strut.source, "stops.max", "is " + number_text(*strut.stops->max) + " m, but " + text);
  }
}

bool bends(const Scene& scene, const std::string& name) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const BodySpec& body) {
    return body.name == name && body.flexible && body.flexible->enabled;
  });
}

}  // namespace

void check_struts(const Scene& scene, Findings& findings) {
  check_unique_names(scene.struts, "strut", findings);
  for (const StrutSpec& strut : scene.struts) {
    check_pair(scene, strut.source, strut.bodies, findings);
    if (strut.source.given("points") && !((strut.points[1] - strut.points[0]).norm() > 0.0))
      findings.error(strut.source, "points", "are the same; a strut needs two, some way apart");
    bool any = false;
    std::string sections;
    each_law(strut, [&](const char* key, const auto& law) {
      any = any || law;
      sections += (sections.empty() ? "" : ", ") + std::string(key);
    });
    if (!any) findings.error(strut.source, "", "has no force law; give at least one of " + sections);
    if (strut.mr) check_mr(scene, strut, findings);
    if (strut.honeycomb) check_honeycomb(strut, findings);
    check_stops(strut, findings);
  }
}

void check_springs(const Scene& scene, Findings& findings) {
  check_unique_names(scene.springs, "spring", findings);
  for (const SpringSpec& spring : scene.springs) {
    if (!spring.source.good("kind")) continue;
    check_pair(scene, spring.source, spring.bodies, findings);
    const bool torsion = spring.kind == SpringKind::kTorsion, bushing = spring.kind == SpringKind::kBushing;
    for (const std::string& name : spring.bodies) {
      if (!torsion || spring.source.given("point") || !bends(scene, name)) continue;
      findings.error(spring.source, "point",
                     "is missing; \"" + name + "\" is flexible, and is turned at a point of the drawing");
      break;
    }
    if (torsion && !spring.source.given("axis"))
      findings.error(spring.source, "axis", "is missing; a torsion spring turns about it");
    if (bushing && !spring.source.given("point"))
      findings.error(spring.source, "point", "is missing; a bushing sits at it");
    for (const std::string& key : foreign_keys(spring.kind))
      if (spring.source.written_together("kind", key))
        findings.error(spring.source, key, "means nothing for this kind of spring; leave it out");
    const auto alike = [](const Eigen::Vector3d& k) { return k.x() == k.y() && k.y() == k.z(); };
    if (!bushing && !(alike(spring.stiffness) && alike(spring.damping)))
      findings.error(spring.source, alike(spring.damping) ? "stiffness" : "damping",
                     "is a list; only a bushing has a value for each of its axes, expected one number");
    if (bushing && std::abs(spring.axis.dot(spring.axis2)) > 0.999)
      findings.error(spring.source, "axis2",
                     "is parallel to axis; expected the x direction of the bushing, across its z");
    if ((spring.stiffness + spring.damping + spring.turning_stiffness + spring.turning_damping).isZero(0.0))
      findings.error(spring.source, "", "has neither stiffness nor damping");
  }
}

void check_forces(const Scene& scene, Findings& findings) {
  check_unique_names(scene.forces, "force", findings);
  for (const ForceSpec& force : scene.forces) {
    check_body_name(scene, force.source, "body", force.body, findings);
    check_function(force.source, "force", force.force, findings);
    check_function(force.source, "torque", force.torque, findings);
    if (force.force) check_signal_name(scene, force.source, "force.signal", force.force->signal, findings);
    if (force.torque) check_signal_name(scene, force.source, "torque.signal", force.torque->signal, findings);
    if (!force.force && !force.torque)
      findings.error(force.source, "", "has neither force nor torque, for example force = { polynomial = [10] } (N)");
    if (!force.point && bends(scene, force.body))
      findings.error(force.source, "point",
                     "is missing; \"" + force.body + "\" is flexible, and is pushed at a point of the drawing");
  }
}

void check_controllers(const Scene& scene, Findings& findings) {
  check_unique_names(scene.controllers, "controller", findings);
  for (const ControllerSpec& c : scene.controllers) {
    if (!c.source.good("kind")) continue;
    check_body_name(scene, c.source, "body", c.body, findings);
    if (c.source.given("outputs") && c.outputs.empty())
      findings.error(c.source, "outputs", "are empty; expected names such as [\"U1\", \"U2\"]");
    for (auto it = c.outputs.begin(); it != c.outputs.end(); ++it) {
      if (std::find(c.outputs.begin(), it, *it) != it)
        findings.error(c.source, "outputs", "name \"" + *it + "\" twice");
    }
    for (const std::string& key : foreign_keys(c.kind))
      if (c.source.written_together("kind", key))
        findings.warning(c.source, key, "means nothing for this kind of controller and is not used");
    const bool constant = c.kind == ControllerKind::kConstant, fuzzy = c.kind == ControllerKind::kFuzzy,
               skyhook = c.kind == ControllerKind::kSkyhook;
    if (fuzzy && c.file.empty())
      findings.error(c.source, "file", "is missing; a fuzzy controller is read from an .fll file");
    if (constant && c.voltages.size() != 1 && c.voltages.size() != c.outputs.size())
      findings.error(c.source, "voltages",
                     "are " + std::to_string(c.voltages.size()) + " numbers, expected one, or one per output (" +
                         std::to_string(c.outputs.size()) + ")");
    if (fuzzy && (c.grid.size() != 4 || *std::min_element(c.grid.begin(), c.grid.end()) < 2))
      findings.error(c.source, "grid", "expected four numbers of at least 2: points along a, da, alpha, beta");
    if (skyhook && c.off > c.on) findings.error(c.source, "off", "is above on");
  }
}

}  // namespace footfall

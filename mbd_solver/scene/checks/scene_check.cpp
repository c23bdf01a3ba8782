// The checks of bodies, joints, gears, contacts and limits; what all checks share.

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

#include "coupler/base/concat.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "mbd_solver/model/laws/curves.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {
using namespace code;

namespace {

constexpr double kLeastDensity = 50.0;  // of materials that machines are built of [kg/m3]

std::vector<std::string> missing_of(const std::vector<std::pair<std::string, std::string>>& keys) {
  std::vector<std::string> missing;
  for (const auto& [key, value] : keys)
    if (value.empty()) missing.push_back(key);
  return missing;
}

// The elastic model of a flexible body: exactly one, complete, with the material that it needs.
void check_flexible(const Scene& scene, const BodySpec& body, const EntryFindings& at) {
  const FlexibleSpec& f = *body.flexible;
  const int matrices = !f.stiffness_matrix.empty() + !f.mass_matrix.empty() + !f.node_file.empty();
  at.error_if(
      matrices == 1 || matrices == 2, kNeedsOtherKey, "flexible",
      "needs all of stiffness_matrix, mass_matrix and node_file; add ",
      joined(missing_of(
          {{"stiffness_matrix", f.stiffness_matrix}, {"mass_matrix", f.mass_matrix}, {"node_file", f.node_file}})));
  const bool of_matrices =
      !f.dof_file.empty() || !f.stress_file.empty() || !f.interfaces.empty() || f.units != UnitSystem::kMetre;
  at.error_if(
      of_matrices && matrices == 0, kNeedsOtherKey, "flexible",
      "has keys of a model in matrices (dof_file, stress_file, interfaces, units), which needs stiffness_matrix, "
      "mass_matrix and node_file; add these three, or remove the others");
  const int models = !f.file.empty() + !f.mesh.empty() + !f.nodes.empty() + (matrices > 0);
  at.error_if(models > 1, kElasticModel, "flexible", "has more than one of file, mesh, nodes and matrices; keep one");
  if (models == 0 && !(body.shape && !body.source.good("shape.kind"))) {
    const bool bends = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod ||
                                      body.shape->kind == ShapeKind::kDisc || body.shape->kind == ShapeKind::kDish);
    at.error_if(!bends, kElasticModel, "flexible",
                "this body has no shape that bends; expected a tube, rod, disc or dish, or flexible = { file, mesh, "
                "nodes or matrices }");
  }
  if (f.file.empty() && matrices == 0) {
    if (body.material.empty()) {
      at.error(kMissingKey, "material", "is missing; a flexible body needs density, young and poisson");
    } else if (scene.material_or_null(body.material) && !(scene.material(body.material).young > 0.0)) {
      at.all().error(kMissingKey, scene.material(body.material).source, "young", "is missing; the flexible body \"",
                     body.name, "\" needs it");
    }
  }
  at.missing_if(!f.mesh.empty() && f.thickness <= 0.0 && !(body.shape && body.shape->thickness > 0.0),
                "flexible.thickness", "a plate on a mesh needs it");
  const int nodes = static_cast<int>(f.nodes.size());
  for (const MemberSpec& m : f.members) {
    at.error_if(std::max(m.first, m.second) >= nodes || m.first == m.second, kFrameMember, "flexible.members",
                "joins nodes ", m.first, " and ", m.second, ", expected two different ones from 0 to ", nodes - 1);
    if (std::none_of(f.sections.begin(), f.sections.end(), [&](const auto& s) { return s.name == m.section; }))
      at.error(kUnknownSection, "flexible.members", "unknown section \"", m.section, "\".",
               known_names("sections", m.section, names_in(f.sections)));
  }
  at.missing_if(nodes > 0 && f.members.empty(), "flexible.members", "nodes without members are no frame");
}

void check_bodies(const Scene& scene, Findings& findings) {
  if (scene.bodies.empty())
    findings.error(kNoBodies, scene.source, "bodies", "is missing; a scene needs at least one [[bodies]] entry");
  check_unique_names(scene.bodies, "body", findings);
  for (const MaterialSpec& m : scene.materials) {
    const EntryFindings at(findings, m.source);
    if (m.density > 0.0 && m.density < kLeastDensity)
      at.warning(kLightMaterial, "density", "is ", m.density,
                 " kg/m3, lighter than foam. If it is in g/cm3, write density_g_cm3 = ", m.density);
    at.error_if(!(m.poisson > -1.0 && m.poisson < 0.5), kOutOfRange, "poisson", "is ", m.poisson,
                ", expected more than -1 and less than 0.5");
  }
  for (const BodySpec& body : scene.bodies) {
    const EntryFindings at(findings, body.source);
    at.error_if(body.name == "ground", kReservedName, "name", "\"ground\" is the inertial frame; choose another name");
    check_material_name(scene, body, at);
    if (body.flexible && body.flexible->enabled) check_flexible(scene, body, at);
  }
  std::unordered_map<std::string, int> moving;  // lines of the first entry of each body
  for (const BodyVelocitySpec& v : scene.initial.bodies) {
    const EntryFindings at(findings, v.source);
    check_body_name(scene, at, "body", v.body);
    const auto [same, is_new] = moving.emplace(v.body, v.source.line);
    at.error_if(!v.body.empty() && !is_new, kListedTwice, "body", "\"", v.body, "\" already has a velocity (line ",
                same->second, "); give each body one entry");
  }
  for (const std::string& name : scene.output.bodies)
    check_body_name(scene, {findings, scene.output.source}, "bodies", name);
}

// A body next to a mechanism that nothing connects to it and that touches nothing: mostly a forgotten joint.
void warn_of_loose_bodies(const Scene& scene, Findings& findings) {
  if (scene.joints.empty()) return;
  std::unordered_set<std::string> used;
  for (const BoundarySpec& boundary : scene.boundaries) used.insert(boundary.body);
  const auto use = [&](const auto& entries) {
    for (const auto& entry : entries) used.insert(entry.bodies.begin(), entry.bodies.end());
  };
  use(scene.joints);
  use(scene.struts);
  use(scene.springs);
  for (const CableSpec& cable : scene.cables)
    for (const CableGuideSpec& guide : cable.path) used.insert(guide.body);
  for (const ForceSpec& force : scene.forces) used.insert(force.body);
  for (const BodySpec& body : scene.bodies)
    if (used.count(body.name) == 0)
      findings.warning(kLooseBody, body.source, "name", "body \"", body.name,
                       "\" is connected to nothing: no joint, strut, cable, spring, force or boundary names it; add a "
                       "joint, or remove the body");
}

void warn_of_gravity_upwards(const Scene& scene, Findings& findings) {
  const GroundSpec& ground = scene.ground;
  if (!ground.is_flat() || (ground.kind == GroundKind::kPlane ? !ground.plane : !ground.law)) return;
  const double along = scene.gravity.dot(ground.normal());
  if (along > 1e-9)
    findings.warning(kGravityUpwards, scene.source, "gravity", "points away from the ground, ", along,
                     " m/s2 along its normal, so bodies fall off it; expected the other sign, such as [0, 0, -9.81]");
  else if (along > -1e-6 * scene.gravity.norm() && !scene.gravity.isZero(0.0))
    findings.warning(kGravityUpwards, scene.source, "gravity",
                     "is parallel to the ground, so nothing presses the bodies on it; expected one against its normal, "
                     "such as [0, 0, -9.81]");
}

// A scene that starts from the end of a run is placed as that was.
void check_from(const Scene& scene, Findings& findings) {
  if (scene.initial.from.empty()) return;
  const EntryFindings at(findings, scene.initial.source);
  for (const char* key : {"position", "roll", "pitch", "yaw", "clearance", "settle"})
    at.error_if(at.given(key), kConflictingKeys, key,
                "excludes from: the scene starts from the end of that run, placed as it was; remove one of the two");
  at.error_if(!scene.initial.joints.empty(), kConflictingKeys, "joints",
              "exclude from: the joints start at their coordinates at the end of that run");
}

// Sizes and counts that would need memory or time beyond reason: mostly mistakes in a unit, reported before they cost it.

constexpr double kMostRows = 1e7;            // of history.csv
constexpr double kMostFiles = 1e5;           // pictures, checkpoints
constexpr double kMostSamples = 1e8;         // of a controller, signal or event
constexpr double kMostSteps = 1e9;           // of the integrator
constexpr double kMostPeriods = 1e8;         // of a function of time, each of which takes ten steps or more
constexpr double kLargestRtol = 0.1;         // [-]
constexpr double kMostGenerated = 1e5;       // triangles of a generated or decimated surface
constexpr double kMostPlateTriangles = 2e4;  // finite elements
constexpr int kMostElements = 2000;          // of a beam
constexpr int kMostSegments = 10000, kMostRanks = 4096;

// About so many triangles of this edge length cover the shape.
double triangles_on(const ShapeSpec& s, double edge) {
  const auto squared = [&](double length) { return (length / edge) * (length / edge); };
  switch (s.kind) {
    case ShapeKind::kBox:
      return 4.0 * (s.size.x() * s.size.y() + s.size.y() * s.size.z() + s.size.z() * s.size.x()) / (edge * edge);
    case ShapeKind::kTube:
    case ShapeKind::kRod: return 2.0 * (1.0 + (s.to - s.from).norm() / edge) * (6.0 + kPi * s.diameter / edge);
    case ShapeKind::kDisc: return 12.0 * squared(s.radius);
    case ShapeKind::kDish: return 6.0 * squared(s.radius + s.depth);
    case ShapeKind::kSphere: return 60.0 * squared(s.radius);
    case ShapeKind::kCylinder: return 12.0 * squared(s.radius) + 4.0 * kPi * s.radius * s.length / (edge * edge);
    case ShapeKind::kCapsule:
      return 30.0 * squared(0.5 * s.diameter) + 2.0 * kPi * s.diameter * (s.to - s.from).norm() / (edge * edge);
    case ShapeKind::kMesh:
    case ShapeKind::kPoints: return 0.0;
  }
  return 0.0;
}

void check_edge(const EntryFindings& at, const std::string& key, const ShapeSpec& shape, double edge, double most) {
  const double triangles = edge > 0.0 ? triangles_on(shape, edge) : 0.0;
  at.error_if(triangles > most, kTooLarge, key, "is ", edge, " m, which makes about ", number_text(triangles, 2),
              " triangles of this shape, expected at most ", most, "; give a longer edge, in m");
}

void check_int(const EntryFindings& at, const std::string& key, long value, int most) {
  at.error_if(value > most, kTooLarge, key, "is ", value, ", expected at most ", most);
}

void check_limits(const Scene& scene, Findings& findings) {
  const auto check_count = [&](const Source& source, const char* key, double interval, double most, const char* what) {
    if (interval > 0.0 && scene.end_time / interval > most)
      findings.error(kTooLarge, source, key, "is ", interval, " s: ", number_text(scene.end_time / interval, 3), " ",
                     what, " until end_time, expected at most ", most, "; give a longer interval");
  };
  const OutputSpec& output = scene.output;
  check_count(output.source, "interval", output.interval, kMostRows, "rows");
  if (output.vtk) check_count(output.source, "vtk_interval", output.vtk_interval, kMostFiles, "pictures");
  check_count(output.source, "checkpoint_interval", output.checkpoint_interval, kMostFiles, "checkpoints");
  for (const ControllerSpec& controller : scene.controllers)
    check_count(controller.source, "period", controller.period, kMostSamples, "samples");
  for (const SignalSpec& signal : scene.signals)
    check_count(signal.source, "period", signal.period, kMostSamples, "samples");
  for (const EventSpec& event : scene.events)
    check_count(event.source, "period", event.period, kMostSamples, "samples");
  for_each_function(scene, [&](const Source& source, const std::string& key, const TimeFunctionSpec& f) {
    if (f.amplitude != 0.0 && f.frequency * scene.end_time > kMostPeriods)
      findings.error(kTooLarge, source, key + ".frequency", "is ", f.frequency,
                     " Hz: ", number_text(f.frequency * scene.end_time, 3),
                     " periods until end_time, expected at most ", kMostPeriods, "; give a lower frequency, in Hz");
  });
  const SolverSpec& solver = scene.solver;
  if (solver.source.given("max_step")) check_count(solver.source, "max_step", solver.max_step, kMostSteps, "steps");
  if (!(solver.rtol < kLargestRtol))
    findings.error(kTolerance, solver.source, "rtol", "is ", solver.rtol, ", expected less than ", kLargestRtol,
                   ", such as 1e-6: the relative error of a step");
  if (scene.particles) check_int({findings, scene.particles->source}, "ranks", scene.particles->ranks, kMostRanks);
  for (const BodySpec& body : scene.bodies) {
    if (!body.flexible) continue;
    const EntryFindings at(findings, body.source);
    check_int(at, "flexible.elements", body.flexible->elements, kMostElements);
    long elements = 0;
    for (const MemberSpec& member : body.flexible->members) elements += member.elements;
    at.error_if(elements > kMostElements, kTooLarge, "flexible.members", "have ", elements,
                " elements together, expected at most ", kMostElements);
    if (body.shape) check_edge(at, "flexible.mesh_size", *body.shape, body.flexible->mesh_size, kMostPlateTriangles);
  }
  for (const BoundarySpec& boundary : scene.boundaries) {
    const EntryFindings at(findings, boundary.source);
    if (boundary.surface)
      check_int(at, "surface.triangles", boundary.surface->triangles, static_cast<int>(kMostGenerated));
    if (boundary.beams) check_int(at, "beams.segments", boundary.beams->segments, kMostSegments);
    const BodySpec* body = scene.body(boundary.body);
    if (boundary.surface && body != nullptr && body->shape)
      check_edge(at, "surface.element_size", *body->shape, boundary.surface->element_size, kMostGenerated);
  }
}

// Joints: two bodies, the points and axes that their type needs, no gap, and motions that can be followed.

constexpr double kLargestGap = 1e-6;      // between points that should coincide in D [m]
constexpr double kLargestCosine = 1e-3;   // of the two axes of a universal joint, given by numbers of four digits
constexpr double kSameDirection = 0.999;  // cosine of two axes that count as parallel
constexpr double kOvershoot = 0.05;       // of a spline beyond the range of its values
// Shafts that a constant-velocity joint connects [rad]: bent by less they count as straight, by more as no shafts.
constexpr double kStraight = 2e-3, kLargestBend = 80.0 * kPi / 180.0;

double degrees(double angle) { return angle * 180.0 / kPi; }

void check_points(const JointSpec& joint, double largest_gap, const EntryFindings& at) {
  const bool both = at.given("point_a") && at.given("point_b");
  const bool may_differ = traits_of(joint.type).points_may_differ;
  if (!at.given("point") && !both) {
    at.error(kMissingKey, "point",
             may_differ ? "is missing; give point_a and point_b"
                        : "is missing; give the joint's point (or point_a and point_b)");
    return;
  }
  const double gap = (joint.point_b - joint.point_a).norm();
  at.error_if(!may_differ && gap > largest_gap, kJointOpen, "point_b", "is ", gap,
              " m from point_a: the joint between \"", joint.bodies[0], "\" and \"", joint.bodies[1],
              "\" is open; expected points within ", largest_gap, " m (initial.largest_gap closes larger gaps)");
  if (joint.type == JointType::kRolling && joint.radius) {
    // The centre of a disc on its edge is lower when the disc leans.
    const double lean = at.given("axis2") ? joint.axis.cross(joint.axis2).norm() : 1.0;
    const double height = joint.axis.dot(joint.point_b - joint.point_a);
    at.error_if(std::abs(height - *joint.radius * lean) > largest_gap, kJointGeometry, "point_b", "is ", height,
                " m above the plane, expected ", *joint.radius * lean, " m",
                lean < 1.0 ? ", radius times the sine of the angle between axis and axis2" : ", the radius");
  }
  if (joint.type != JointType::kDistance) return;
  if (gap == 0.0) {
    at.error(kJointGeometry, "point_b", "is the same point as point_a; a distance joint needs two different ones");
  } else if (joint.length && std::abs(*joint.length - gap) > kLargestGap) {
    at.error(kJointGeometry, "length", "is ", *joint.length, " m, but the points are ", gap,
             " m apart; remove it, or move them");
  }
}

// f(0) [rad], against the reference configuration.
double initial_value(const TimeFunctionSpec& f) {
  double value = f.amplitude * std::sin(f.phase);
  if (!f.polynomial.empty()) value += f.polynomial.front();
  // A spline is continued before its first point: its value is known here only where it passes through t = 0.
  for (const Eigen::Vector2d& row : f.table)
    if (row.x() == 0.0) value += row.y();
  return value;
}

// A spline through points that are not smooth overshoots between them, and continues beyond its last point.
void check_spline(const EntryFindings& at, const std::string& key, const TimeFunctionSpec& f, double end_time) {
  if (f.table.size() < 2) return;
  std::vector<double> times, values;
  for (const Eigen::Vector2d& row : f.table) {
    if (!times.empty() && !(row.x() > times.back())) return;  // reported by check_function
    times.push_back(row.x());
    values.push_back(row.y());
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double range = *most - *least;
  const CubicSpline spline("a table over time", times, values);
  double overshoot = 0.0, when = 0.0;
  constexpr int kSamples = 16;  // of each piece
  for (std::size_t i = 1; i < times.size(); ++i)
    for (int k = 1; k < kSamples; ++k) {
      const double t = times[i - 1] + (times[i] - times[i - 1]) * k / kSamples;
      const double value = spline.at(t).value;
      const double out = std::max({*least - value, value - *most, 0.0});
      if (out <= overshoot) continue;
      overshoot = out;
      when = t;
    }
  if (overshoot > kOvershoot * range && range > 0.0)
    at.warning(kSplineOvershoot, key + ".table", "the smooth curve through the points leaves their range by ",
               number_text(overshoot, 3), " at ", number_text(when, 3),
               " s; give more points where the motion begins and ends");
  const double speed = spline.at(times.back()).slope;
  const double beyond = std::abs(speed) * (end_time - times.back());
  if (end_time > times.back() && beyond > kOvershoot * range)
    at.warning(kMotionContinues, key + ".table", "ends at ", number_text(times.back(), 4), " s; until ",
               number_text(end_time, 4), " s the motion continues at its last speed, ", number_text(speed, 3),
               " per s; give more points, the last ones equal where the motion should rest");
}

void check_motion(const JointSpec& joint, double end_time, const EntryFindings& at) {
  if (traits_of(joint.type).motion == KeyUse::kUnused) {
    at.error_if(joint.motion.has_value(), kMotion, "motion", "belongs to joints of type \"prescribed\"; remove it");
  } else {
    const bool any = joint.motion && (joint.motion->x || joint.motion->y || joint.motion->z || joint.motion->rotation);
    at.error_if(!any, kMotion, "motion",
                "prescribes nothing; expected at least one of x, y, z, rotation, for example motion = { z = { "
                "polynomial = [0, -0.1] } }");
    at.error_if(joint.motion && joint.motion->hold_other_rotations && !joint.motion->rotation, kNeedsOtherKey,
                "motion.hold_other_rotations",
                "needs a prescribed rotation, for example rotation = { polynomial = [0] }");
  }
  if (!joint.motion) return;
  const MotionSpec& m = *joint.motion;
  for (const auto& [name, function] : {std::pair("x", &m.x), {"y", &m.y}, {"z", &m.z}, {"rotation", &m.rotation}}) {
    const std::string key = std::string("motion.") + name;
    check_function(at, key, *function);
    if (!*function) continue;
    check_spline(at, key, **function, end_time);
    at.error_if(!(*function)->signal.empty(), kMotion, key + ".signal",
                "has no two derivatives, which a motion needs; use a [[drives]] entry of kind \"position\"");
  }
  // sin(angle - f) = 0 is also fulfilled half a turn away.
  if (m.rotation && !(std::cos(initial_value(*m.rotation)) > 0.0))
    at.error(kMotionStart, "motion.rotation", "begins at ", number_text(degrees(initial_value(*m.rotation)), 4),
             " degrees from the reference configuration, expected less than 90; draw the bodies as they start, and "
             "count the rotation from there");
}

// The directions that a joint prescribes, with their names.
std::vector<std::pair<std::string, Eigen::Vector3d>> displacements(const JointSpec& joint) {
  const Eigen::Vector3d z = joint.axis;
  const Eigen::Vector3d x = (joint.axis2 - joint.axis2.dot(z) * z).normalized();
  std::vector<std::pair<std::string, Eigen::Vector3d>> out;
  if (joint.motion->x) out.emplace_back("x", x);
  if (joint.motion->y) out.emplace_back("y", z.cross(x));
  if (joint.motion->z) out.emplace_back("z", z);
  return out;
}

// Two motions of the same coordinate of the same two bodies: one of them would be dropped as redundant.
void check_motion_twice(const JointSpec& first, const JointSpec& second, Findings& findings) {
  const auto report = [&](const std::string& key) {
    findings.error(kMotionTwice, second.source, "motion." + key, "is already prescribed by joint \"", first.name,
                   "\" (line ", first.source.line, ") between the same two bodies; keep one of them");
  };
  if (first.motion->rotation && second.motion->rotation && std::abs(first.axis.dot(second.axis)) > kSameDirection)
    report("rotation");
  if ((first.point_b - second.point_b).norm() > kLargestGap) return;
  for (const auto& [name_1, direction_1] : displacements(first))
    for (const auto& [name_2, direction_2] : displacements(second))
      if (std::abs(direction_1.dot(direction_2)) > kSameDirection) report(name_2);
}

void check_axes(const JointSpec& joint, const EntryFindings& at) {
  const JointTraits traits = traits_of(joint.type);
  const double cosine = std::abs(joint.axis.dot(joint.axis2));
  at.missing_if(traits.axis == KeyUse::kRequired && !at.given("axis"), "axis", "this type of joint needs it");
  at.missing_if(traits.axis2 == KeyUse::kRequired && !at.given("axis2"), "axis2", "a ", traits.name,
                " joint has a second axis, fixed in \"", joint.bodies[1], "\"");
  at.error_if(joint.type == JointType::kUniversal && cosine > kLargestCosine, kJointGeometry, "axis2", "makes ",
              degrees(std::acos(std::min(1.0, cosine))), " degrees with axis, expected 90");
  const bool has_x = joint.type == JointType::kPrescribed || (joint.type == JointType::kPlanar && at.given("axis2"));
  at.error_if(has_x && cosine > kSameDirection, kJointGeometry, "axis2",
              "is parallel to axis, expected the x direction of the joint, perpendicular to its z = axis");
  at.error_if(joint.type == JointType::kConstantVelocity && at.given("axis2") && cosine < std::cos(kLargestBend),
              kJointGeometry, "axis2", "makes ", number_text(degrees(std::acos(cosine)), 3),
              " degrees with axis, expected less than ", number_text(degrees(kLargestBend), 3),
              ": the axes of two shafts");
  at.error_if(joint.type == JointType::kRolling && at.given("axis2") && cosine > kSameDirection, kJointGeometry,
              "axis2", "is parallel to axis, so the disc lies flat; expected a disc on its edge");
  at.missing_if(traits.radius == KeyUse::kRequired && !joint.radius, "radius", "the radius of the wheel [m]");
  for (const auto& [key, use] :
       {std::pair("radius", traits.radius), {"axis2", traits.axis2}, {"length", traits.length}})
    at.no_effect_if(use == KeyUse::kUnused && at.source().good(key), key, "this type of joint");
}

// The axis of the shaft that joint `cv` turns in a body, as another joint of the body shows it: a bearing whose axis passes
// through the point of `cv`, or a second joint of shafts at the other end. None if it shows no shaft.
std::optional<Eigen::Vector3d> shaft_axis(const JointSpec& cv, const JointSpec& other, const std::string& body) {
  if (&cv == &other || (other.bodies[0] != body && other.bodies[1] != body)) return std::nullopt;
  const Eigen::Vector3d way = other.point_a - cv.point_a;
  const double distance = way.norm();
  if (other.type == JointType::kRevolute || other.type == JointType::kCylindrical) {
    if (way.cross(other.axis).norm() > kStraight * distance + kLargestGap) return std::nullopt;
    return other.axis;
  }
  const bool shafts = other.type == JointType::kConstantVelocity || other.type == JointType::kUniversal;
  if (!shafts || distance <= kLargestGap) return std::nullopt;
  return way / distance;
}

// With one axis for both bodies a joint that is drawn bent would turn unevenly.
void check_shafts(const Scene& scene, const JointSpec& cv, const EntryFindings& at) {
  if (cv.type != JointType::kConstantVelocity || !at.given("axis") || at.given("axis2")) return;
  for (const JointSpec& other : scene.joints) {
    for (const std::size_t side : {1u, 0u}) {
      const std::optional<Eigen::Vector3d> shaft = shaft_axis(cv, other, cv.bodies[side]);
      if (!shaft) continue;
      const double cosine = std::min(1.0, std::abs(cv.axis.dot(*shaft))), bend = std::acos(cosine);
      if (bend < kStraight || bend > kLargestBend) continue;
      const auto component = [&](int k) { return number_text((*shaft)[k], 9); };
      at.error(kJointGeometry, side == 0 ? "axis" : "axis2", side == 0 ? "is " : "is missing: axis is ",
               number_text(degrees(bend), 4), " degrees from the shaft of body \"", cv.bodies[side],
               "\", which joint \"", other.name, "\" shows along [", component(0), ", ", component(1), ", ",
               component(2), "]. Shafts turn evenly about axis (in a) and axis2 (in b): give both along their shafts");
      return;
    }
  }
}

void check_joints(const Scene& scene, Findings& findings) {
  check_unique_names(scene.joints, "joint", findings);
  std::map<std::pair<std::string, std::string>, std::vector<const JointSpec*>> motions;  // of each pair of bodies
  for (const JointSpec& joint : scene.joints) {
    if (!joint.source.good("kind")) {
      if (joint.motion) motions[std::minmax(joint.bodies[0], joint.bodies[1])].push_back(&joint);
      continue;
    }
    const EntryFindings at(findings, joint.source);
    check_pair(scene, at, joint.bodies);
    check_points(joint, scene.initial.largest_gap, at);
    check_motion(joint, scene.end_time, at);
    if (joint.motion) {
      std::vector<const JointSpec*>& others = motions[std::minmax(joint.bodies[0], joint.bodies[1])];
      for (const JointSpec* before : others) check_motion_twice(*before, joint, findings);
      others.push_back(&joint);
    }
    check_axes(joint, at);
    check_shafts(scene, joint, at);
  }
}

// Gears: joints that exist and have the coordinate, a factor for each, and the curve of a cam.

// The joint of this name; null, with a finding, where there is none.
const JointSpec* find_joint(const Scene& scene, const EntryFindings& at, const std::string& key,
                            const std::string& name) {
  if (const JointSpec* joint = scene.joint(name)) return joint;
  at.error(kUnknownJoint, key, "unknown joint \"", name, "\".", known_names("joints", name, names_in(scene.joints)));
  return nullptr;
}

// The joint of this index exists and leaves its coordinate free.
void check_member(const Scene& scene, const GearSpec& gear, std::size_t i, const EntryFindings& at) {
  const JointSpec* joint = find_joint(scene, at, "joints", gear.joints[i]);
  if (!joint) return;
  const std::vector<Coordinate> has = coordinates_of(joint->type);
  const std::string type(name_of(joint->type)), name = "\"" + joint->name + "\"";
  if (has.empty()) {
    at.error(kUnknownCoordinate, "joints", name, " is ", type,
             "; a gear connects angles and displacements of revolute, prismatic, cylindrical or planar joints");
    return;
  }
  const std::string choice = i < gear.coordinates.size() ? gear.coordinates[i] : "auto";
  const std::string expected = "; expected " + coordinate_names(joint->type);
  if (choice != "auto" && !is_in(names_of<Coordinate>(), choice)) {
    at.error(kUnknownCoordinate, "coordinates", "contains \"", choice, "\"", expected,
             has.size() == 1 ? " or \"auto\"" : "", " for ", name);
  } else if (choice == "auto" && has.size() > 1) {
    at.error(kAmbiguousCoordinate, "coordinates", name, " is ", type, " and has ", has.size() == 2 ? "two" : "three",
             expected, " for it, for example [\"", i == 0 ? "angle\", \"auto" : "auto\", \"angle", "\"]");
  } else if (choice != "auto" &&
             std::none_of(has.begin(), has.end(), [&](Coordinate c) { return name_of(c) == choice; })) {
    at.error(kUnknownCoordinate, "coordinates", "contains \"", choice, "\" for ", name, ", which a ", type,
             " joint does not have", expected);
  }
  for (std::size_t k = 0; k < i; ++k) {
    const std::string before = k < gear.coordinates.size() ? gear.coordinates[k] : "auto";
    at.error_if(gear.joints[k] == gear.joints[i] && before == choice, kListedTwice, "joints", name,
                " is listed twice with the same coordinate; list it once with the sum of its factors");
  }
}

// The last joint moves the cam.
void check_cam(const Scene& scene, const GearSpec& gear, const EntryFindings& at) {
  const std::vector<Eigen::Vector2d>& curve = gear.curve;
  if (curve.empty()) {
    at.error_if(at.given("closed"), kNeedsOtherKey, "closed",
                "needs a curve, which it closes; add curve, or remove closed");
    return;
  }
  if (gear.closed && curve.size() < 3) {
    at.error(kWrongCount, "curve", "is closed and has 2 points, expected at least 3");
    return;
  }
  at.error_if(gear.closed && curve.front()[1] != curve.back()[1], kCamCurve, "curve",
              "is closed, but begins with the value ", curve.front()[1], " and ends with ", curve.back()[1],
              "; expected the same value at both ends");
  if (gear.joints.empty() || !find_joint(scene, at, "joints", gear.joints.back())) return;
  if (scene.coordinate_of(gear, gear.joints.size() - 1) != Coordinate::kAngle) return;
  const double span = curve.back()[0] - curve.front()[0];
  at.error_if(gear.closed ? std::abs(span - 2.0 * kPi) > 1e-3 : span > 2.0 * kPi + 1e-3, kCamCurve, "curve", "spans ",
              span, " rad; expected ",
              gear.closed ? "one turn of a closed curve, 2 pi" : "at most one turn, 2 pi, of an angle");
}

void check_gears(const Scene& scene, Findings& findings) {
  check_unique_names(scene.gears, "gear", findings);
  for (const GearSpec& gear : scene.gears) {
    const EntryFindings at(findings, gear.source);
    const std::size_t joints = gear.joints.size();
    const auto one_for_each = [&](std::size_t count) {
      return concat("has ", count, " entries for ", joints, " joints; expected one for each");
    };
    if (const JointSpec* joint = scene.joint(gear.name); joint != nullptr && !gear.name.empty())
      at.error(kDuplicateName, "name", "is also the name of a joint (line ", joint->source.line,
               "); names must differ");
    if (at.given("joints")) {
      at.error_if(joints < 2, kWrongCount, "joints", "contains ", joints, " names, expected two or more");
      for (std::size_t i = 0; i < joints; ++i) check_member(scene, gear, i, at);
    }
    at.error_if(at.given("joints") && at.given("factors") && gear.factors.size() != joints, kWrongCount, "factors",
                one_for_each(gear.factors.size()), ": the sum of factor times coordinate stays zero");
    at.error_if(!gear.coordinates.empty() && gear.coordinates.size() != joints, kWrongCount, "coordinates",
                one_for_each(gear.coordinates.size()));
    check_cam(scene, gear, at);
    for (const double factor : gear.factors)
      at.error_if(factor == 0.0, kGearFactor, "factors",
                  "contains 0; remove that joint, or give its radius or number of teeth");
  }
}

// What acts on the coordinates of joints: stops, friction, springs, drives; and where the coordinates start.

// "is no coordinate of a spherical joint; expected a joint of type revolute or cylindrical".
std::string no_coordinate(Coordinate coordinate, JointType type) {
  std::vector<std::string> types;
  for (const JointType other : every<JointType>())
    if (has_coordinate(other, coordinate)) types.emplace_back(name_of(other));
  const std::string names = coordinate_names(type);
  return concat("is no coordinate of a ", name_of(type), " joint; expected ",
                names.empty() ? "" : names + " of it, or ", "a joint of type ", joined(types, " or "));
}

Unit unit_of(Coordinate coordinate) { return coordinate == Coordinate::kAngle ? Unit::kAngle : Unit::kLength; }

// "20 degrees", "0.01 m".
std::string value_text(double value, Unit unit) {
  if (unit == Unit::kAngle) return concat(value * 180.0 / kPi, " degrees");
  return number_text(value) + (unit == Unit::kLength ? " m" : "");
}

void check_coordinate(const JointSpec& joint, Coordinate coordinate, const EntryFindings& at) {
  const std::optional<CoordinateSpec>& c = joint.acting_on(coordinate);
  if (!c) return;
  const std::string key(name_of(coordinate));
  if (!has_coordinate(joint.type, coordinate)) at.error(kUnknownCoordinate, key, no_coordinate(coordinate, joint.type));
  at.error_if(!c->stops && !c->friction && !c->spring, kEmptyEntry, key,
              "has no force law; give at least one of stops, friction, spring");
  if (c->stops) {
    const std::optional<double>&min = c->stops->smallest_stroke, &max = c->stops->largest_stroke;
    at.error_if(!min && !max, kEmptyEntry, key + ".stops", "limit nothing; give min, max or both");
    if (min && max) check_min_below_max(at, key + ".stops.", *min, *max, unit_of(coordinate));
  }
  if (c->friction && c->friction->breakaway && *c->friction->breakaway < c->friction->coulomb)
    at.error(kRangeReversed, key + ".friction.breakaway", "is ", *c->friction->breakaway,
             ", expected at least coulomb, ", c->friction->coulomb);
  at.error_if(c->spring && c->spring->stiffness == 0.0 && c->spring->damping == 0.0, kEmptyEntry, key + ".spring",
              "has neither stiffness nor damping; give one of them");
}

void warn_of_start_beyond_stops(const JointSpec& joint, const InitialJointSpec& given, Coordinate coordinate,
                                const EntryFindings& at) {
  const std::optional<CoordinateSpec>& c = joint.acting_on(coordinate);
  if (!c || !c->stops) return;
  const double value = *given.value(coordinate);
  const std::optional<double>&min = c->stops->smallest_stroke, &max = c->stops->largest_stroke;
  const bool below = min && value < *min;
  if (!below && !(max && value > *max)) return;
  const Unit unit = unit_of(coordinate);
  at.warning(kStartBeyondStop, std::string(name_of(coordinate)), "starts joint \"", joint.name, "\" at ",
             value_text(value, unit), ", beyond its stop at ", value_text(below ? *min : *max, unit),
             ", which throws it back at once; start it within its stops, or move the stop");
}

// The joint exists and leaves the coordinate free.
void check_coordinate_of(const Scene& scene, const DriveSpec& drive, const EntryFindings& at) {
  if (drive.joint.empty()) return;
  const JointSpec* joint = find_joint(scene, at, "joint", drive.joint);
  if (!joint) return;
  const std::string type(name_of(joint->type)), expected = "; expected " + coordinate_names(joint->type);
  const std::size_t count = coordinates_of(joint->type).size();
  if (count == 0) {
    at.error(kUnknownCoordinate, "joint", "\"", drive.joint, "\" is ", type,
             "; a drive moves an angle or displacement of a revolute, prismatic, cylindrical or planar joint");
  } else if (!drive.coordinate) {
    at.error_if(count > 1, kAmbiguousCoordinate, "coordinate", "is missing; a ", type, " joint has ",
                count == 2 ? "two" : "three", expected);
  } else if (!has_coordinate(joint->type, *drive.coordinate)) {
    at.error(kUnknownCoordinate, "coordinate", "is \"", name_of(*drive.coordinate), "\", which a ", type,
             " joint does not have", expected);
  }
}

void check_initial_joints(const Scene& scene, Findings& findings) {
  const InitialSpec& initial = scene.initial;
  for (const InitialJointSpec& given : initial.joints) {
    const EntryFindings at(findings, given.source);
    const JointSpec* joint = find_joint(scene, at, "", given.name);
    if (!joint) continue;
    bool empty = true;
    for (const Coordinate coordinate : every<Coordinate>()) {
      if (!given.value(coordinate)) continue;
      empty = false;
      if (!has_coordinate(joint->type, coordinate))
        at.error(kInitialJoint, std::string(name_of(coordinate)), no_coordinate(coordinate, joint->type));
      warn_of_start_beyond_stops(*joint, given, coordinate, at);
    }
    if (given.angle && std::abs(*given.angle) > kPi)
      at.error(kInitialJoint, "angle", "is ", number_text(*given.angle * 180.0 / kPi, 6),
               " degrees, expected at most half a turn: the laws of this angle count turns from there");
    at.error_if(empty && given.source.refused.empty(), kEmptyEntry, "",
                "is empty; expected angle or displacement, for example angle_deg = 30");
  }
  const EntryFindings at(findings, initial.source);
  if (initial.settle) {
    at.error_if(scene.touches_particles(), kSettle, "settle",
                "is not possible with grains; settle the mechanism on a plane, or remove it");
    const bool moves =
        !initial.velocity.isZero(0.0) || !initial.angular_velocity.isZero(0.0) || !initial.bodies.empty();
    at.error_if(moves, kSettle, "settle", "starts from rest, but velocities are given; remove one of the two");
  }
  if (!initial.joints.empty() && initial.clearance)
    at.warning(kClearance, "clearance",
               "is measured in the reference configuration, before [initial.joints] moves the bodies: the gap at the "
               "start differs from it");
}

// max_torque [N m] of an angle, max_force [N] of a displacement.
void check_largest_effort(const Scene& scene, const DriveSpec& drive, const EntryFindings& at) {
  const bool torque = at.given("max_torque"), force = at.given("max_force");
  at.error_if(torque && force, kConflictingKeys, "max_force", "is given with max_torque; keep one of the two");
  const JointSpec* const joint = scene.joint(drive.joint);
  if (joint == nullptr || !joint->source.good("kind")) return;
  const std::vector<Coordinate> has = coordinates_of(joint->type);
  if (!drive.coordinate && has.size() != 1) return;
  const bool turns = drive.coordinate.value_or(has.front()) == Coordinate::kAngle;
  at.error_if(force && turns, kKeyWithoutEffect, "max_force", "has no effect on an angle; write max_torque [N m]");
  if (torque && !force && !turns)
    at.warning(kSecondSpelling, "max_torque",
               "is read as \"max_force\" [N], because the drive moves a displacement; write that");
}

void check_drives(const Scene& scene, Findings& findings) {
  for (const JointSpec& joint : scene.joints)
    if (joint.source.good("kind"))
      for (const Coordinate coordinate : every<Coordinate>())
        check_coordinate(joint, coordinate, {findings, joint.source});
  check_unique_names(scene.drives, "drive", findings);
  for (const DriveSpec& drive : scene.drives) {
    if (!drive.source.good("kind")) continue;
    const EntryFindings at(findings, drive.source);
    const MotorParameters& motor = drive.motor;
    check_coordinate_of(scene, drive, at);
    check_function(at, "command", drive.command);
    if (drive.command) check_signal_name(scene, at, "command.signal", drive.command->signal);
    at.missing_if(!drive.command, "command", "for example command = { polynomial = [0, 0.5] }");
    check_kind_keys(at, motor.kind, "drive");
    check_largest_effort(scene, drive, at);
    at.missing_if(motor.kind == MotorKind::kBrake && !motor.largest_torque, "max_torque",
                  "the torque at which a brake slides [N m], or max_force on a displacement [N]");
    at.missing_if((motor.kind == MotorKind::kSpeed || motor.kind == MotorKind::kPosition) && !(motor.kp > 0.0), "kp",
                  "a drive that holds a speed or a position needs it");
    at.error_if(!(motor.efficiency > 0.0), kOutOfRange, "efficiency", "is 0, expected more than 0, at most 1");
    at.error_if(motor.no_load_speed && !motor.largest_torque, kNeedsOtherKey, "max_torque",
                "is missing; the torque falls from it at rest to 0 at max_speed");
  }
}

}  // namespace

std::vector<std::string> boundary_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const BoundarySpec& boundary : scene.boundaries) names.push_back(boundary.body);
  return names;
}

void check_material_name(const Scene& scene, const BodySpec& body, const EntryFindings& at) {
  check_known(at, kUnknownMaterial, "material", "material", "materials", body.material, scene.materials,
              scene.indices.materials);
}

void check_body_name(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& name) {
  check_known(at, kUnknownBody, key, "body", "bodies", name, scene.bodies, scene.indices.bodies);
}

void check_signal_name(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& name) {
  for (const SignalSpec& signal : scene.signals)
    if (signal.is_foreign() && is_in(signal.output_signals(), name)) return;
  check_known(at, kUnknownSignal, key, "signal", "signals", name, scene.signals, scene.indices.signals);
}

void check_pair(const Scene& scene, const EntryFindings& at, const std::array<std::string, 2>& bodies) {
  for (const std::string& name : bodies)
    if (name != "ground") check_body_name(scene, at, "bodies", name);
  at.error_if(!bodies[0].empty() && bodies[0] == bodies[1], kListedTwice, "bodies", "are both \"", bodies[0],
              "\"; expected two different ones");
}

void check_scene(const Scene& scene, Findings& findings) {
  check_bodies(scene, findings);
  warn_of_loose_bodies(scene, findings);
  warn_of_gravity_upwards(scene, findings);
  check_joints(scene, findings);
  check_drives(scene, findings);
  check_gears(scene, findings);
  check_initial_joints(scene, findings);
  check_controllers(scene, findings);
  check_signals(scene, findings);
  check_struts(scene, findings);
  check_cables(scene, findings);
  check_springs(scene, findings);
  check_forces(scene, findings);
  check_contact(scene, findings);
  check_from(scene, findings);
  check_groups(scene, findings);
  check_landing(scene, findings);
  check_requirements(scene, findings);
  check_accepted(scene, findings);
  check_limits(scene, findings);
  if (!findings.has_errors()) check_plausible(scene, findings);
  if (scene.particles && scene.touches_particles()) check_script(scene, findings);
}

void check_function(const EntryFindings& at, const std::string& key, const std::optional<TimeFunctionSpec>& f) {
  if (!f) return;
  at.missing_if(f->amplitude != 0.0 && f->frequency == 0.0, key + ".frequency",
                "an amplitude needs it (Hz). For a constant use polynomial = [value]");
  for (std::size_t i = 1; i < f->table.size(); ++i) {
    if (f->table[i].x() > f->table[i - 1].x()) continue;
    at.error(kNotRising, key + ".table", "has time ", f->table[i].x(), " s after ", f->table[i - 1].x(),
             " s, expected rising times");
    break;
  }
}

void check_min_below_max(const EntryFindings& at, const std::string& within, double min, double max, Unit unit) {
  if (min < max) return;
  // The finding is about the value from --set.
  const Source& source = at.source();
  const bool of_min = source.line_of(within + "min") == Source::kFromSet && source.line_of(within + "max") > 0;
  const double mine = of_min ? min : max, other = of_min ? max : min;
  at.error(kRangeReversed, within + (of_min ? "min" : "max"), "is ", value_text(mine, unit), ", expected ",
           of_min ? "less than max, " : "more than min, ", value_text(other, unit));
}

}  // namespace footfall

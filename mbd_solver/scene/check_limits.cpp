// What would take memory or time beyond reason is told before it does: sizes and counts that are mistakes in a unit.
#include <cmath>

#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

namespace {

constexpr double kMostRows = 1e7;            // of history.csv
constexpr double kMostFiles = 1e5;           // pictures, checkpoints
constexpr double kMostSamples = 1e8;         // of a controller
constexpr double kMostSteps = 1e9;           // of the integrator
constexpr double kLargestRtol = 0.1;         // an error of that much is no answer
constexpr double kMostGenerated = 1e5;       // of a generated surface
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

void check_edge(const Source& source, const std::string& key, const ShapeSpec& shape, double edge, double most,
                Findings& findings) {
  const double triangles = edge > 0.0 ? triangles_on(shape, edge) : 0.0;
  if (triangles > most)
    findings.error(source, key,
                   "is " + number_text(edge) + " m, which makes about " + number_text(triangles, 2) +
                       " triangles of this shape, expected at most " + number_text(most) +
                       "; give a longer edge, in m");
}

// `events` over the run, one every `interval`.
void check_count(const Scene& scene, const Source& source, const std::string& key, double interval, double most,
                 const std::string& what, Findings& findings) {
  if (interval > 0.0 && scene.end_time / interval > most)
    findings.error(source, key,
                   "is " + number_text(interval) + " s: " + number_text(scene.end_time / interval, 3) + " " + what +
                       " until end_time, expected at most " + number_text(most) + "; give a longer one");
}

void check_int(const Source& source, const std::string& key, int value, int most, Findings& findings) {
  if (value > most)
    findings.error(source, key, "is " + std::to_string(value) + ", expected at most " + std::to_string(most));
}

}  // namespace

void check_limits(const Scene& scene, Findings& findings) {
  const OutputSpec& output = scene.output;
  check_count(scene, output.source, "interval", output.interval, kMostRows, "rows", findings);
  if (output.vtk)
    check_count(scene, output.source, "vtk_interval", output.vtk_interval, kMostFiles, "pictures", findings);
  check_count(scene, output.source, "checkpoint_interval", output.checkpoint_interval, kMostFiles, "checkpoints",
              findings);
  for (const ControllerSpec& controller : scene.controllers)
    check_count(scene, controller.source, "period", controller.period, kMostSamples, "samples", findings);
  const SolverSpec& solver = scene.solver;
  if (solver.source.given("max_step"))
    check_count(scene, solver.source, "max_step", solver.max_step, kMostSteps, "steps", findings);
  if (!(solver.rtol < kLargestRtol))
    findings.error(solver.source, "rtol",
                   "is " + number_text(solver.rtol) + ", expected less than " + number_text(kLargestRtol) +
                       ", such as 1e-6: it is the error of a step, relative to what moves");
  if (scene.particles) check_int(scene.particles->source, "ranks", scene.particles->ranks, kMostRanks, findings);
  for (const BodySpec& body : scene.bodies) {
    if (!body.flexible) continue;
    check_int(body.source, "flexible.elements", body.flexible->elements, kMostElements, findings);
    long elements = 0;
    for (const MemberSpec& member : body.flexible->members) elements += member.elements;
    if (elements > kMostElements)
      findings.error(
          body.source, "flexible.members",
          "have " + std::to_string(elements) + " elements together, expected at most " + std::to_string(kMostElements));
    if (body.shape)
      check_edge(body.source, "flexible.mesh_size", *body.shape, body.flexible->mesh_size, kMostPlateTriangles,
                 findings);
  }
  for (const BoundarySpec& boundary : scene.boundaries) {
    if (boundary.beams) check_int(boundary.source, "beams.segments", boundary.beams->segments, kMostSegments, findings);
    for (const BodySpec& body : scene.bodies)
      if (boundary.surface && body.name == boundary.body && body.shape)
        check_edge(boundary.source, "surface.element_size", *body.shape, boundary.surface->element_size, kMostGenerated,
                   findings);
  }
}

}  // namespace footfall

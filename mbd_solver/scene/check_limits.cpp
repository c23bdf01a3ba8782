// Sizes and counts that would need memory or time beyond reason: mostly mistakes in a unit, reported before they cost it.
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

namespace {

constexpr double kMostRows = 1e7;            // of history.csv
constexpr double kMostFiles = 1e5;           // pictures, checkpoints
constexpr double kMostSamples = 1e8;         // of a controller
constexpr double kMostSteps = 1e9;           // of the integrator
constexpr double kLargestRtol = 0.1;         // [-]
constexpr double kMostGenerated = 1e5;       // triangles of a generated surface
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
  at.error_if(triangles > most, kTooLarge, key,
              "is " + number_text(edge) + " m, which makes about " + number_text(triangles, 2) +
                  " triangles of this shape, expected at most " + number_text(most) + "; give a longer edge, in m");
}

void check_int(const EntryFindings& at, const std::string& key, long value, int most) {
  at.error_if(value > most, kTooLarge, key,
              "is " + std::to_string(value) + ", expected at most " + std::to_string(most));
}

}  // namespace

void check_limits(const Scene& scene, Findings& findings) {
  const auto check_count = [&](const Source& source, const char* key, double interval, double most, const char* what) {
    if (interval > 0.0 && scene.end_time / interval > most)
      findings.error(kTooLarge, source, key,
                     "is " + number_text(interval) + " s: " + number_text(scene.end_time / interval, 3) + " " + what +
                         " until end_time, expected at most " + number_text(most) + "; give a longer interval");
  };
  const OutputSpec& output = scene.output;
  check_count(output.source, "interval", output.interval, kMostRows, "rows");
  if (output.vtk) check_count(output.source, "vtk_interval", output.vtk_interval, kMostFiles, "pictures");
  check_count(output.source, "checkpoint_interval", output.checkpoint_interval, kMostFiles, "checkpoints");
  for (const ControllerSpec& controller : scene.controllers)
    check_count(controller.source, "period", controller.period, kMostSamples, "samples");
  const SolverSpec& solver = scene.solver;
  if (solver.source.given("max_step")) check_count(solver.source, "max_step", solver.max_step, kMostSteps, "steps");
  if (!(solver.rtol < kLargestRtol))
    findings.error(kTolerance, solver.source, "rtol",
                   "is " + number_text(solver.rtol) + ", expected less than " + number_text(kLargestRtol) +
                       ", such as 1e-6: the relative error of a step");
  if (scene.particles) check_int({findings, scene.particles->source}, "ranks", scene.particles->ranks, kMostRanks);
  for (const BodySpec& body : scene.bodies) {
    if (!body.flexible) continue;
    const EntryFindings at(findings, body.source);
    check_int(at, "flexible.elements", body.flexible->elements, kMostElements);
    long elements = 0;
    for (const MemberSpec& member : body.flexible->members) elements += member.elements;
    at.error_if(
        elements > kMostElements, kTooLarge, "flexible.members",
        "have " + std::to_string(elements) + " elements together, expected at most " + std::to_string(kMostElements));
    if (body.shape) check_edge(at, "flexible.mesh_size", *body.shape, body.flexible->mesh_size, kMostPlateTriangles);
  }
  for (const BoundarySpec& boundary : scene.boundaries) {
    const EntryFindings at(findings, boundary.source);
    if (boundary.beams) check_int(at, "beams.segments", boundary.beams->segments, kMostSegments);
    for (const BodySpec& body : scene.bodies)
      if (boundary.surface && body.name == boundary.body && body.shape)
        check_edge(at, "surface.element_size", *body.shape, boundary.surface->element_size, kMostGenerated);
  }
}

}  // namespace footfall

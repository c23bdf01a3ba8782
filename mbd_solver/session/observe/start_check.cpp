// Builds the mechanism as a run does, and evaluates what a run would refuse or warn of.

#include "mbd_solver/session/observe/start_check.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/coupling/codes.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/elements/surface_model.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/shape_outline.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/observe/attached_damping.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/observe/requirements.h"
#include "mbd_solver/session/observe/start_values.h"

namespace footfall {
namespace {

// Overlaps of bodies by the distances of their surfaces, as during a run; of grains by the distance of each centre near a body
// to its triangles and beams.

// Deeper than a grain at rest on the body would be [of the grain's radius].
constexpr double kDeep = 0.3;
constexpr double kAway = 0.5;  // of a surface from its body [sizes of both]

struct Placed {
  const BodyBoundary* entry;
  Eigen::Matrix3Xd nodes;  // in W [m]
};

std::vector<SurfaceModel> surfaces_of(const Placed& body) {
  const ModalBoundary& boundary = body.entry->boundary;
  std::vector<SurfaceModel> parts;
  if (!boundary.triangles().empty()) parts.emplace_back(body.nodes, boundary.triangles());
  for (const BeamSegment& segment : boundary.segments())
    parts.emplace_back(body.nodes, std::vector<Eigen::Vector3i>{{segment.start, segment.start, segment.end}},
                       segment.radius);
  return parts;
}

bool may_overlap(const Scene& scene, const Mechanism& mechanism, const Placed& a, const Placed& b) {
  const int body_a = a.entry->body, body_b = b.entry->body;
  for (int i = 0; i < mechanism.model.joint_count(); ++i) {
    const int one = mechanism.model.joint(i).m1.body, other = mechanism.model.joint(i).m2.body;
    if ((one == body_a && other == body_b) || (one == body_b && other == body_a)) return true;
  }
  const std::string name_a = a.entry->boundary.name(), name_b = b.entry->boundary.name();
  return std::any_of(scene.contacts.begin(), scene.contacts.end(), [&](const ContactSpec& spec) {
    return std::count(spec.between.begin(), spec.between.end(), name_a) > 0 &&
           std::count(spec.between.begin(), spec.between.end(), name_b) > 0;
  });
}

bool cross(const Placed& a, const Placed& b) {
  const Eigen::Array3d a_low = a.nodes.rowwise().minCoeff(), a_high = a.nodes.rowwise().maxCoeff();
  const Eigen::Array3d b_low = b.nodes.rowwise().minCoeff(), b_high = b.nodes.rowwise().maxCoeff();
  double thickest = 0.0;
  for (const Placed* body : {&a, &b})
    for (const BeamSegment& segment : body->entry->boundary.segments()) thickest += segment.radius;
  if ((a_low > b_high + thickest).any() || (b_low > a_high + thickest).any()) return false;
  std::vector<SurfaceModel> parts_a = surfaces_of(a), parts_b = surfaces_of(b);
  for (SurfaceModel& part_a : parts_a)
    for (SurfaceModel& part_b : parts_b)
      if (gap_between(part_a, part_b, {}).distance <= 0.0) return true;
  return false;
}

Eigen::Vector3d nearest_on_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& x) {
  const Eigen::Vector3d axis = b - a;
  const double length = axis.squaredNorm();
  return a + (length > 0.0 ? std::clamp(axis.dot(x - a) / length, 0.0, 1.0) : 0.0) * axis;
}

double distance_to_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                            const Eigen::Vector3d& x) {
  const Eigen::Vector3d weights = barycentric_weights(a, b, c, x);
  if (weights.minCoeff() >= 0.0) return (weights[0] * a + weights[1] * b + weights[2] * c - x).norm();
  return std::min({(nearest_on_line(a, b, x) - x).norm(), (nearest_on_line(b, c, x) - x).norm(),
                   (nearest_on_line(c, a, x) - x).norm()});
}

// From a point to the surface of the body [m].
double distance(const Placed& body, const Eigen::Vector3d& x) {
  const ModalBoundary& boundary = body.entry->boundary;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3i& t : boundary.triangles())
    least = std::min(least, distance_to_triangle(body.nodes.col(t[0]), body.nodes.col(t[1]), body.nodes.col(t[2]), x));
  for (const BeamSegment& segment : boundary.segments())
    least =
        std::min(least, (nearest_on_line(body.nodes.col(segment.start), body.nodes.col(segment.end), x) - x).norm() -
                            segment.radius);
  return least;
}

std::vector<std::string> overlaps_with(const std::vector<GrainPlace>& grains, const std::vector<Placed>& bodies) {
  std::vector<std::string> warnings;
  for (const Placed& body : bodies) {
    double thickest = 0.0;
    for (const BeamSegment& segment : body.entry->boundary.segments()) thickest = std::max(thickest, segment.radius);
    const Eigen::Array3d low = body.nodes.rowwise().minCoeff(), high = body.nodes.rowwise().maxCoeff();
    int count = 0;
    double deepest = 0.0;
    for (const GrainPlace& grain : grains) {
      const double reach = grain.radius + thickest;
      if ((grain.centre.array() < low - reach).any() || (grain.centre.array() > high + reach).any()) continue;
      const double overlap = 1.0 - std::max(0.0, distance(body, grain.centre)) / grain.radius;
      if (overlap > 0.0) ++count;
      deepest = std::max(deepest, overlap);
    }
    if (deepest <= kDeep) continue;
    warnings.push_back(
        with_code(code::kStartsInBed, "body \"" + body.entry->boundary.name() + "\" overlaps " + std::to_string(count) +
                                          " grains of the bed at the start, by up to " + share_text(deepest) +
                                          " of their radius: raise it (initial.clearance, positions of bodies, "
                                          "[initial.joints])"));
  }
  return warnings;
}

// Floor and sides of [particles.box], which act in the run.
std::vector<std::string> through_box(const Scene& scene, const std::vector<Placed>& bodies) {
  if (!scene.touches_particles() || !scene.particles->box || !scene.particles->box->walls || scene.ground.terrain)
    return {};
  const BoxSpec& box = *scene.particles->box;
  std::vector<std::string> warnings;
  const auto warn = [&](const Placed& body, double by, const std::string& what, const std::string& remedy) {
    warnings.push_back(with_code(code::kThroughBox, "body \"" + body.entry->boundary.name() + "\" reaches " +
                                                        number_text(by, 3) + " m " + what + " at the start; " +
                                                        remedy));
  };
  for (const Placed& body : bodies) {
    double deepest = 0.0, left = 0.0;      // below the floor [m]
    double out[4] = {0.0, 0.0, 0.0, 0.0};  // beyond -x, +x, -y, +y, of what is below the surface
    bool within = false;
    for (Eigen::Index k = 0; k < body.nodes.cols(); ++k) {
      const Eigen::Vector3d p = body.nodes.col(k);
      if (!(p.z() < 0.0)) continue;
      bool inside = true;
      for (int axis = 0; axis < 2; ++axis) {
        const double x = p[axis] - box.centre[axis], half = 0.5 * box.size[axis];
        out[2 * axis] = std::max(out[2 * axis], -x - half);
        out[2 * axis + 1] = std::max(out[2 * axis + 1], x - half);
        inside = inside && std::abs(x) <= half;
      }
      within = within || inside;
      if (inside) deepest = std::max(deepest, -box.depth - p.z());
    }
    left = *std::max_element(out, out + 4);
    if (!within) continue;
    if (deepest > 0.0)
      warn(body, deepest, "through the floor of the bed, z = " + number_text(-box.depth) + " m,",
           "raise it (initial.clearance, initial.position), or increase particles.box.depth");
    if (left > 0.0 && !box.periodic && box.follow.empty()) {
      const char* const sides[4] = {"-x", "+x", "-y", "+y"};
      warn(body, left,
           std::string("through the side of the bed towards ") + sides[std::max_element(out, out + 4) - out],
           "move it (initial.position, particles.box.centre), or increase particles.box.size");
    }
  }
  return warnings;
}

}  // namespace

std::vector<std::string> surfaces_away(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const BoundarySpec& boundary : scene.boundaries) {
    if (!boundary.surface || boundary.surface->file.empty()) continue;
    Eigen::AlignedBox3d surface, body;
    for (const Eigen::Vector3d& x : boundary_surface(scene, boundary).vertices) surface.extend(x);
    const BodySpec& spec = *scene.body(boundary.body);
    body.extend(spec.position);
    for (const Eigen::Vector3d& x : shape_outline(spec)) body.extend(x);
    const auto take = [&](const auto& entry, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      if (entry.bodies[0] == spec.name) body.extend(a);
      if (entry.bodies[1] == spec.name) body.extend(b);
    };
    for (const JointSpec& joint : scene.joints) take(joint, joint.point_a, joint.point_b);
    for (const StrutSpec& strut : scene.struts) take(strut, strut.points[0], strut.points[1]);
    const double gap = surface.exteriorDistance(body), size = surface.diagonal().norm() + body.diagonal().norm();
    if (surface.isEmpty() || !(gap > kAway * size)) continue;
    warnings.push_back(
        with_code(code::kSurfaceAway,
                  place_of(scene.file, boundary.source, "surface.file") + "the surface of \"" + spec.name + "\" is " +
                      number_text(gap, 3) + " m away from the body, which has its mass centre at [" +
                      number_text(spec.position.x(), 3) + ", " + number_text(spec.position.y(), 3) + ", " +
                      number_text(spec.position.z(), 3) +
                      "] m; place it in the reference configuration by surface.position, scale and orientation"));
  }
  return warnings;
}

std::vector<std::string> overlaps_at_start(const Scene& scene, const Mechanism& mechanism,
                                           const std::vector<GrainPlace>& grains) {
  if (mechanism.boundaries.empty() || scene.initial.settle) return {};
  std::vector<Placed> bodies;
  try {
    const Assembly assembly = assemble(mechanism.model, assembly_options(scene, mechanism.model));
    const Layout layout(mechanism.model);
    Kinematics start(mechanism.model);
    start.load(layout, assembly.state.q, assembly.state.v, Eigen::VectorXd());
    for (const BodyBoundary& entry : mechanism.boundaries) {
      BodyMotion motion(entry.boundary.mode_count());
      fill_motion(start.of(entry.body), motion);
      bodies.push_back({&entry, Eigen::Matrix3Xd(3, entry.boundary.node_count())});
      entry.boundary.node_positions(motion, bodies.back().nodes);
    }
  } catch (const std::exception&) {  // the run reports it
    return {};
  }
  std::vector<std::string> warnings = overlaps_with(grains, bodies);
  for (const std::string& warning : through_box(scene, bodies)) warnings.push_back(warning);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!may_overlap(scene, mechanism, bodies[i], bodies[j]) && cross(bodies[i], bodies[j]))
        warnings.push_back(with_code(code::kOverlapAtStart,
                                     "bodies \"" + bodies[j].entry->boundary.name() + "\" and \"" +
                                         bodies[i].entry->boundary.name() +
                                         "\" overlap at the start: collisions between them will not be detected. Move "
                                         "them apart unless this is intended"));
  return warnings;
}

void check_by_building(Scene scene, bool judges, const std::function<void(const std::string&)>& warn,
                       const std::function<void(const Scene&, const Mechanism&)>& with_grains) {
  // The bed may not be made yet: whether the mechanism can be built does not depend on its height.
  const bool unknown_height =
      scene.touches_particles() && scene.particles->grains.empty() && !scene.particles->surface_height;
  if (unknown_height) scene.particles->surface_height = 0.0;
  try {
    for (const BoundarySpec& boundary : scene.boundaries) {
      if (boundary.surface && !boundary.surface->file.empty()) boundary_surface(scene, boundary);
    }
    Mechanism mechanism = build_mechanism(scene);
    for (const std::string& warning : mechanism.warnings) warn(warning);
    if (with_grains) with_grains(scene, mechanism);
    require_values_at_start(scene, !unknown_height, mechanism);
    if (!judges) return;
    std::vector<GrainPlace> grains;
    if (scene.touches_particles() && !scene.particles->grains.empty()) grains = read_grains(scene.particles->grains);
    for (const std::string& warning : surfaces_away(scene)) warn(warning);
    for (const std::string& warning : overlaps_at_start(scene, mechanism, grains)) warn(warning);
    for (const std::string& warning : warnings_of_held_bodies(scene, mechanism)) warn(warning);
    const Layout layout(mechanism.model);
    const Observation observation({scene, mechanism, layout});
    for (const std::string& warning : requirement_unit_warnings(scene, observation.names(), observation.units()))
      warn(warning);
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.front() == '/' || names_a_place(scene.file, what) ? what : scene.file + ": " + what);
  }
}

}  // namespace footfall

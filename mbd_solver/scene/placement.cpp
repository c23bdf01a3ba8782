#include "mbd_solver/scene/placement.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "coupler/errors.h"
#include "mbd_solver/scene/boundary_surface.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

double gap_to_plane(const PlaneSpec& plane, const Placement& at, const std::vector<TouchingPoints>& touching) {
  double gap = kFar;
  for (const TouchingPoints& boundary : touching) {
    for (const Eigen::Vector3d& x : boundary.x_D) gap = std::min(gap, plane.normal.dot(at(x) - plane.point) - boundary.radius);
  }
  return gap;
}

double lowest_height(const Placement& at, const TouchingPoints& boundary) {
  double lowest = kFar;
  for (const Eigen::Vector3d& x : boundary.x_D) lowest = std::min(lowest, at(x).z() - boundary.radius);
  return lowest;
}

// Grains count for a boundary when they lie under the upright box around it.
double gap_to_grains(const std::vector<Grain>& grains, const Placement& at, const std::vector<TouchingPoints>& touching) {
  double gap = kFar;
  for (const TouchingPoints& boundary : touching) {
    Eigen::AlignedBox2d footprint;
    for (const Eigen::Vector3d& x : boundary.x_D) footprint.extend(Eigen::Vector2d(at(x).head<2>()));
    double highest = -kFar;
    for (const Grain& g : grains) {
      const bool under = footprint.exteriorDistance(Eigen::Vector2d(g.x.head<2>())) <= g.radius + boundary.radius;
      if (under) highest = std::max(highest, g.x.z() + g.radius);
    }
    if (highest > -kFar) gap = std::min(gap, lowest_height(at, boundary) - highest);
  }
  if (gap == kFar) throw InputError("initial.clearance: no grain lies under any boundary; move the mechanism or the bed");
  return gap;
}

// What moves the mechanism to the wanted clearance [m].
Eigen::Vector3d move_to_clearance(const Scene& scene, const Placement& at, const std::vector<TouchingPoints>& touching) {
  const double clearance = *scene.initial.clearance;
  if (scene.ground.kind == GroundKind::kPlane) {
    const PlaneSpec& plane = *scene.ground.plane;
    return (clearance - gap_to_plane(plane, at, touching)) * plane.normal;
  }
  const ParticlesSpec& particles = *scene.particles;
  double gap = 0.0;
  if (!particles.grains.empty()) {
    gap = gap_to_grains(read_grains(particles.grains), at, touching);
  } else if (particles.surface_height) {
    gap = kFar;
    for (const TouchingPoints& boundary : touching) gap = std::min(gap, lowest_height(at, boundary) - *particles.surface_height);
  } else {
    throw InputError(scene.file + ":" + std::to_string(scene.initial.source.line_of("clearance")) +
                     ": initial.clearance: the height of the grains is not known; start with `footfall run`, or give particles.grains (the bed's "
                     "text dump) or particles.surface_height");
  }
  return (clearance - gap) * Eigen::Vector3d::UnitZ();
}

}  // namespace

std::vector<TouchingPoints> touching_points(const Scene& scene) {
  std::vector<TouchingPoints> result;
  for (const BoundarySpec& boundary : scene.boundaries) {
    if (boundary.surface) result.push_back({boundary_surface(scene, boundary).vertices, 0.0});
    if (boundary.beams) {
      const BeamChain chain = boundary_chain(scene, boundary);
      result.push_back({chain.points, chain.radius});
    }
  }
  return result;
}

Placement place(const Scene& scene, const std::vector<TouchingPoints>& touching) {
  const InitialSpec& initial = scene.initial;
  Placement at;
  at.R = (Eigen::AngleAxisd(initial.yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(initial.pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(initial.roll, Eigen::Vector3d::UnitX()))
             .toRotationMatrix();
  const Eigen::Vector3d centre_D = mass_centre(scene);
  at.p = centre_D - at.R * centre_D + initial.position;
  if (initial.clearance) at.p += move_to_clearance(scene, at, touching);
  at.centre = at(centre_D);
  return at;
}

InitialMotion initial_motion(const Scene& scene, const Placement& placement, int index) {
  const BodySpec& body = scene.bodies[static_cast<std::size_t>(index)];
  InitialMotion motion;
  motion.position = placement(body.position);
  motion.orientation = Eigen::Quaterniond(placement.R) * body.orientation;
  motion.angular_velocity = scene.initial.angular_velocity;
  motion.velocity = scene.initial.velocity + motion.angular_velocity.cross(motion.position - placement.centre);
  for (const BodyVelocitySpec& own : scene.initial.bodies) {
    if (own.body != body.name) continue;
    if (own.velocity) motion.velocity = *own.velocity;
    if (own.angular_velocity) motion.angular_velocity = *own.angular_velocity;
  }
  return motion;
}

// A dump has "ITEM: ATOMS x y z radius" before its numbers; of several frames the last counts.
std::vector<Grain> read_grains(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file + ": cannot be read; expected a text dump of the grains (columns x y z radius)");
  std::vector<Grain> grains;
  std::string line;
  bool in_atoms = false;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.rfind("ITEM:", 0) == 0) {
      in_atoms = line.rfind("ITEM: ATOMS", 0) == 0;
      if (!in_atoms) continue;
      grains.clear();
      if (line.find("x y z radius") == std::string::npos)
        throw InputError(file + ":" + std::to_string(number) + ": expected the columns x y z radius (dump ID all custom N FILE x y z radius)");
      continue;
    }
    if (!in_atoms) continue;
    std::istringstream numbers(line);
    Grain g;
    if (!(numbers >> g.x[0] >> g.x[1] >> g.x[2] >> g.radius)) throw InputError(file + ":" + std::to_string(number) + ": expected four numbers x y z radius");
    grains.push_back(g);
  }
  if (grains.empty()) throw InputError(file + ": holds no grains");
  return grains;
}

}  // namespace footfall

// Flexible bodies of the scene: a finite-element model from shape, mesh, frame or file, reduced to modes. Its interface nodes
// are those at which joints, struts, springs and forces act.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/assemble/end_state.h"
#include "mbd_solver/assemble/grain_dump.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/fe/matrix_model.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/fe/modal_body_file.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/fe/turned_model.h"
#include "mbd_solver/model/body.h"
#include "mbd_solver/model/marker.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {
namespace {

constexpr std::size_t kMostElements = 20000;  // of a plate; the reduction then takes minutes
constexpr double kLargeSag = 0.1;             // of a body's size: linear modes are then wrong by per cents
constexpr double kSameMass = 0.01;            // relative: masses in scenes are rounded
constexpr double kUnitRange = 5.0;            // around a factor of 1000 between lengths

// A point of D at which an element acts on the body. Joints that hold an attitude need the rotations of their node.
struct Attachment {
  Eigen::Vector3d point;  // in D [m]
  bool turns;             // transmits moments
};

// By the names of bodies.
std::unordered_map<std::string, std::vector<Attachment>> attachments(const Scene& scene) {
  std::unordered_map<std::string, std::vector<Attachment>> points;
  for (const JointSpec& joint : scene.joints) {
    points[joint.bodies[0]].push_back({joint.point_a, traits_of(joint.type).holds_attitude});
    points[joint.bodies[1]].push_back({joint.point_b, traits_of(joint.type).holds_attitude});
  }
  for (const StrutSpec& strut : scene.struts)
    for (std::size_t end = 0; end < 2; ++end) points[strut.bodies[end]].push_back({strut.points[end], false});
  for (const CableSpec& cable : scene.cables)
    for (const CableGuideSpec& guide : cable.path) points[guide.body].push_back({guide.point, guide.radius > 0.0});
  for (const SpringSpec& spring : scene.springs)
    if (spring.source.given("point"))
      for (const std::string& body : spring.bodies) points[body].push_back({spring.point, true});
  for (const ForceSpec& force : scene.forces)
    if (force.point) points[force.body].push_back({*force.point, force.torque.has_value()});
  return points;
}

// A point farther from every node than the nodes are from each other is no point of the body.
double reach(const Eigen::Matrix3Xd& nodes) { return (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).norm(); }

// The nodes nearest to the attachments become the interface: with all six motions where one of them turns, else with
// displacements only.
void set_interface(const FeModel& model, const std::vector<Attachment>& attached, BasisOptions& options) {
  std::map<int, bool> turns;
  for (const Attachment& a : attached) turns[joint_node(model, a.point, reach(model.nodes), a.turns)] |= a.turns;
  for (const auto& [node, turning] : turns) (turning ? options.interface_nodes : options.pinned_nodes).push_back(node);
}

// A beam from `from` to `to` whose nodes include the feet of all attachments, in about `elements` elements of
// near-equal length.
FeModel beam_along_shape(const ShapeSpec& shape, int elements, const std::vector<Attachment>& attached,
                         const Material& material) {
  const Eigen::Vector3d axis = shape.to - shape.from;
  const double length = axis.norm();
  std::vector<double> stations = {0.0, 1.0};
  for (const Attachment& a : attached)
    stations.push_back(std::clamp((a.point - shape.from).dot(axis) / (length * length), 0.0, 1.0));
  std::sort(stations.begin(), stations.end());
  const double shortest = 0.05 / elements;  // stations nearer than this share a node
  std::vector<double> kept = {0.0};
  for (const double station : stations)
    if (station - kept.back() > shortest) kept.push_back(station);
  kept.back() = 1.0;

  std::vector<Eigen::Vector3d> nodes = {shape.from};
  std::vector<BeamMember> members;
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const double span = kept[i] - kept[i - 1];
    const int pieces = std::max(1, static_cast<int>(std::lround(span * elements)));
    for (int k = 1; k <= pieces; ++k) {
      nodes.push_back(shape.from + (kept[i - 1] + span * k / pieces) * axis);
      members.push_back({static_cast<int>(nodes.size()) - 2, static_cast<int>(nodes.size()) - 1});
    }
  }
  const BeamSection section =
      shape.kind == ShapeKind::kTube ? tube_section(shape.diameter, shape.wall) : rod_section(shape.diameter);
  return beam_model(nodes, members, {section}, material);
}

FeModel frame(const FlexibleSpec& spec, const Material& material) {
  std::vector<BeamSection> sections;
  for (const SectionSpec& s : spec.sections) {
    if (s.diameter > 0.0) {
      sections.push_back(s.wall > 0.0 ? tube_section(s.diameter, s.wall) : rod_section(s.diameter));
    } else {
      sections.push_back(general_section(s.area, s.bending_y, s.bending_z, s.torsion, std::sqrt(s.area / kPi)));
    }
  }
  std::vector<Eigen::Vector3d> nodes = spec.nodes;
  std::vector<BeamMember> members;
  for (const MemberSpec& m : spec.members) {
    int section = 0;
    while (spec.sections[section].name != m.section) ++section;
    const Eigen::Vector3d from = spec.nodes[m.first], to = spec.nodes[m.second];
    int last = m.first;
    for (int k = 1; k <= m.elements; ++k) {
      int next = m.second;
      if (k < m.elements) {
        next = static_cast<int>(nodes.size());
        nodes.push_back(from + (to - from) * k / m.elements);
      }
      members.push_back({last, next, section});
      last = next;
    }
  }
  return beam_model(nodes, members, sections, material);
}

void add_notes(const TriangleMesh& mesh, std::vector<std::string>& warnings) {
  for (const std::string& note : mesh.notes) warnings.push_back(with_code(code::kMeshFewDigits, note));
}

FeModel plate(const BodySpec& body, const FlexibleSpec& spec, const Material& material,
              std::vector<std::string>& warnings) {
  const ShapeSpec shape = body.shape.value_or(ShapeSpec{});
  const double thickness = spec.thickness > 0.0 ? spec.thickness : shape.thickness;
  if (!spec.mesh.empty()) {
    const TriangleMesh mesh = read_mesh(spec.mesh, spec.mesh_scale);
    add_notes(mesh, warnings);
    if (mesh.triangles.size() > kMostElements)
      throw InputError(code::kTooManyElements, spec.mesh, ": has ", mesh.triangles.size(),
                       " triangles, expected at most ", kMostElements, " finite elements; use a coarser mesh");
    return plate_model(mesh, thickness, material, spec.mesh);
  }
  const double edge = spec.mesh_size > 0.0 ? spec.mesh_size : shape.radius / 4.0;
  const TriangleMesh flat =
      shape.kind == ShapeKind::kDish ? dish_mesh(shape.radius, shape.depth, edge) : disc_mesh(shape.radius, edge);
  return plate_model(moved(flat, axes_with_z(shape.axis), shape.centre), thickness, material,
                     "body \"" + body.name + "\"");
}

// A model of another code has its own mass, which shows wrong units: those with which it would be right are named.
void check_mass(const BodySpec& body, double mass, const std::string& file, UnitSystem units) {
  if (std::abs(mass - body.mass) <= kSameMass * body.mass) return;
  const bool spec_has_units = !body.flexible->stiffness_matrix.empty();
  std::string remedy = concat("; check that the units of the model are ", name_of(units));
  for (const UnitSystem other :
       {UnitSystem::kMetre, UnitSystem::kMillimetreTonne, UnitSystem::kMillimetreMillisecond, UnitSystem::kInchPound}) {
    const double in_other = mass * mass_unit(other) / mass_unit(units);
    if (spec_has_units && other != units && std::abs(in_other - body.mass) <= kSameMass * body.mass)
      remedy += concat(", or write units = \"", name_of(other), "\", with which it would weigh the same");
  }
  throw InputError(code::kModelMass, "the model in ", file, " weighs ", mass, " kg, the scene states ", body.mass,
                   " kg, expected the same to 1 %", remedy);
}

std::string list(const Eigen::Vector3d& x) { return concat("[", x[0], ", ", x[1], ", ", x[2], "]"); }

// Centre and inertia of a model of another code, in D, against those that the scene states.
void check_centre_and_inertia(const BodySpec& body, const MassProperties& model, double size, const std::string& file) {
  const Eigen::Matrix3d R = body.orientation.toRotationMatrix(), J = R.transpose() * model.inertia * R;
  const double lengths = std::sqrt(J.trace() / body.inertia.trace() * body.mass / model.mass);
  const auto is_unit = [&](double factor) { return lengths > factor / kUnitRange && lengths < factor * kUnitRange; };
  const std::string unit = is_unit(1e3)    ? "; its nodes seem to be in mm, expected m"
                           : is_unit(1e-3) ? "; its nodes seem to be in km, expected m"
                                           : "";
  const std::string remedy = unit + "; correct the units of the nodes, or give the values of the model in the scene";
  const double off = (model.centre - body.position).norm();
  if (body.source.given("position") && off > kSameMass * size)
    throw InputError(code::kModelInertia, "the model in ", file, " has its mass centre at ", list(model.centre),
                     " m, the scene states position = ", list(body.position),
                     ", expected the same to 1 % of the size of ", size, " m", remedy);
  if (!body.source.given("inertia")) return;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k <= i; ++k)
      if (std::abs(J(i, k) - body.inertia(i, k)) > kSameMass * std::sqrt(body.inertia(i, i) * body.inertia(k, k)))
        throw InputError(code::kModelInertia, "the model in ", file,
                         " has the inertia [Ixx, Iyy, Izz, Ixy, Ixz, Iyz] = [", J(0, 0), ", ", J(1, 1), ", ", J(2, 2),
                         ", ", J(0, 1), ", ", J(0, 2), ", ", J(1, 2), "] kg m2, the scene states I", "xyz"[k], "xyz"[i],
                         " = ", body.inertia(k, i), ", expected the same to 1 %", remedy);
}

// Reduced bodies, for their copies in an array or elsewhere in the scene.
class Reductions {
 public:
  ReducedBody reduce(const BodySpec& body, FeModel model, const BasisOptions& options) {
    for (const Entry& entry : entries_) {
      if (!same(entry.options, options)) continue;
      const Eigen::Matrix3d R = (body.orientation * entry.orientation.conjugate()).toRotationMatrix();
      for (const Eigen::Matrix3d& turn : {R, Eigen::Matrix3d(Eigen::Matrix3d::Identity())})
        if (const auto p = place_of_copy(entry.model, model, turn)) return turned(entry.reduced, turn, *p, body.name);
    }
    ReducedBody reduced = footfall::reduce(model, options, body.name);
    if (reduced.warnings.empty()) entries_.push_back({std::move(model), options, body.orientation, reduced});
    return reduced;
  }

 private:
  struct Entry {
    FeModel model;
    BasisOptions options;
    Eigen::Quaterniond orientation;
    ReducedBody reduced;
  };
  static bool same(const BasisOptions& a, const BasisOptions& b) {
    return a.kind == b.kind && a.mode_count == b.mode_count && a.max_frequency == b.max_frequency &&
           a.damping_ratio == b.damping_ratio && a.interface_nodes == b.interface_nodes &&
           a.pinned_nodes == b.pinned_nodes;
  }
  std::vector<Entry> entries_;
};

// Free modes deflect by at least g / omega^2, held ones by more.
void warn_of_sag(const BodySpec& body, const ModalBody& modal, double gravity, std::vector<std::string>& warnings) {
  if (modal.stiffness.size() == 0 || !(modal.stiffness.minCoeff() > 0.0)) return;
  const double sag = gravity / modal.stiffness.minCoeff(), size = reach(modal.rho0);
  if (sag > kLargeSag * size)
    warnings.push_back(with_code(code::kBendsUnderWeight, "body \"", body.name, "\": bends by at least ",
                                 number_text(sag, 2), " m under its own weight, and is ", number_text(size, 3),
                                 " m large; linear modes fail there. Check young (_GPa), density and dimensions."));
}

FlexibleBody build(const Scene& scene, const BodySpec& body, const std::vector<Attachment>& attached,
                   Reductions& reductions, std::vector<std::string>& warnings) {
  const FlexibleSpec& spec = *body.flexible;
  BasisOptions options;
  options.kind = spec.basis;
  options.mode_count = spec.modes;
  options.max_frequency = spec.max_frequency;
  options.damping_ratio = {spec.damping};

  ReducedBody reduced;
  if (!spec.file.empty()) {
    reduced = read_modal_body(spec.file, options, body.name);
    for (const Attachment& a : attached)
      joint_node(reduced.body, a.point - reduced.p_DBo, reach(reduced.body.rho0), a.turns);
    const double size = reach(reduced.body.rho0);
    check_mass(body, reduced.body.node_mass.sum(), spec.file, spec.units);
    const Body model(body.name, std::make_shared<const ModalBody>(reduced.body));
    check_centre_and_inertia(body, {model.mass(), reduced.p_DBo, model.rigid_inertia()}, size, spec.file);
  } else if (!spec.stiffness_matrix.empty()) {
    FeModel model = read_matrix_model(matrix_files(spec));
    const MassProperties given = mass_properties(model);
    check_mass(body, given.mass, spec.mass_matrix, spec.units);
    check_centre_and_inertia(body, given, reach(model.nodes), spec.mass_matrix + " and " + spec.node_file);
    set_interface(model, attached, options);
    reduced = reductions.reduce(body, std::move(model), options);
  } else {
    const MaterialSpec& material = scene.material(body.material);
    const bool beam = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod);
    FeModel model = !spec.nodes.empty()         ? frame(spec, material)
                    : spec.mesh.empty() && beam ? beam_along_shape(*body.shape, spec.elements, attached, material)
                                                : plate(body, spec, material, warnings);
    model = with_mass(std::move(model), body.mass);
    set_interface(model, attached, options);
    reduced = reductions.reduce(body, std::move(model), options);
  }
  warnings.insert(warnings.end(), reduced.warnings.begin(), reduced.warnings.end());
  if (reduced.warnings.empty()) warn_of_sag(body, reduced.body, scene.gravity.norm(), warnings);
  return {std::make_shared<const ModalBody>(std::move(reduced.body)), reduced.p_DBo};
}

// The parts of each body that may touch the ground: triangles and beams, in the body's own frame, moving with its modes.

// Nodes collected in B with their mode shapes.
struct Nodes {
  std::vector<Eigen::Vector3d> rho0;
  std::vector<Marker> markers;  // of a flexible body: carries S = Phi - off~ Psi and Psi
};

ModalBoundary assemble(const std::string& name, const Nodes& nodes, std::vector<Eigen::Vector3i> triangles,
                       std::vector<BeamSegment> segments, int modes) {
  const auto count = static_cast<Eigen::Index>(nodes.rho0.size());
  Eigen::Matrix3Xd rho0(3, count);
  Eigen::MatrixXd Phi, Psi;
  if (modes > 0) {
    Phi.resize(3 * count, modes);
    Psi.resize(3 * count, modes);
  }
  for (Eigen::Index j = 0; j < count; ++j) {
    const std::size_t i = j;
    rho0.col(j) = nodes.rho0[i];
    if (modes > 0) {
      Phi.middleRows(3 * j, 3) = nodes.markers[i].S;
      Psi.middleRows(3 * j, 3) = nodes.markers[i].Psi;
    }
  }
  return ModalBoundary(name, std::move(rho0), std::move(triangles), std::move(segments), std::move(Phi),
                       std::move(Psi));
}

ModalBoundary build(const Scene& scene, const BodySpec& body, const BoundarySpec& spec, const FlexibleBody& flexible,
                    std::vector<std::string>& warnings) {
  const Eigen::Matrix3d R_BD = axes_D(body, flexible).transpose();
  const Eigen::Vector3d p_DBo = origin_D(body, flexible);
  const int modes = flexible.modal ? flexible.modal->mode_count() : 0;
  Nodes nodes;
  std::vector<Eigen::Vector3i> triangles;
  std::vector<BeamSegment> segments;
  const std::unique_ptr<Body> carrier = modes > 0 ? std::make_unique<Body>(body.name, flexible.modal) : nullptr;
  const auto add_node = [&](const Eigen::Vector3d& rho0) {
    nodes.rho0.push_back(rho0);
    if (carrier) nodes.markers.push_back(body_marker(0, *carrier, rho0));
    return static_cast<int>(nodes.rho0.size()) - 1;
  };

  if (spec.surface) {
    // A flexible plate is its own surface; anything else is generated or read, and rides on the nearest nodes.
    if (flexible.modal && spec.surface->file.empty() && !flexible.modal->triangles.empty() &&
        spec.surface->faces != SurfaceFaces::kBoth) {
      triangles = flexible.modal->triangles;
      for (Eigen::Index j = 0; j < flexible.modal->rho0.cols(); ++j) add_node(flexible.modal->rho0.col(j));
    } else {
      const TriangleMesh mesh = boundary_surface(scene, spec);
      if (!spec.surface->file.empty()) add_notes(mesh, warnings);  // remarks on a shape are reported with its mass
      if (!mesh.decimation.empty()) warnings.push_back(with_code(code::kMeshDecimated, mesh.decimation));
      triangles = mesh.triangles;
      for (const Eigen::Vector3d& vertex : mesh.vertices) add_node(R_BD * (vertex - p_DBo));
    }
  }
  if (spec.beams) {
    std::vector<Eigen::Vector3d> chain = spec.beams->points;
    if (chain.empty())
      for (int k = 0; k <= spec.beams->segments; ++k)
        chain.push_back(body.shape->from + (body.shape->to - body.shape->from) * k / spec.beams->segments);
    const double radius = spec.beams->radius > 0.0 ? spec.beams->radius : 0.5 * body.shape->diameter;
    int last = add_node(R_BD * (chain.front() - p_DBo));
    for (std::size_t k = 1; k < chain.size(); ++k) {
      const int next = add_node(R_BD * (chain[k] - p_DBo));
      segments.push_back({last, next, radius, 0});
      last = next;
    }
  }
  return assemble(body.name, nodes, std::move(triangles), std::move(segments), modes);
}

// The nodes as they meet a plane: each a ball as thick as the beams that end there.
std::vector<ContactPoint> contact_points(int index, const Body& body, const ModalBoundary& boundary) {
  Eigen::VectorXd radius = Eigen::VectorXd::Zero(boundary.node_count());
  for (const BeamSegment& segment : boundary.segments())
    for (const int end : {segment.start, segment.end}) radius(end) = std::max(radius(end), segment.radius);
  std::vector<ContactPoint> points;
  for (int j = 0; j < boundary.node_count(); ++j)
    points.push_back({body_marker(index, body, boundary.rho0().col(j)), radius(j)});
  return points;
}

Marker rigid_marker(int index, const Eigen::Vector3d& s0, const Eigen::Vector3d& axis = Eigen::Vector3d::UnitZ()) {
  Marker marker;
  marker.body = index;
  marker.s0 = s0;
  marker.axes = axes_with_z(axis);
  return marker;
}

// The surface of a rigid round body on a plane, in place of its nodes; false where the nodes are the surface.
bool add_round_shape(const BodySpec& body, const BoundarySpec& spec, BodyBoundary& entry) {
  if (!spec.surface || !spec.surface->file.empty()) return false;
  if (spec.surface->faces == SurfaceFaces::kMiddle) return false;
  const ShapeSpec& shape = *body.shape;
  const Eigen::Matrix3d R_BD = body.orientation.toRotationMatrix().transpose();
  const auto add_rim = [&](const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double radius) {
    entry.rims.push_back({rigid_marker(entry.body, R_BD * (centre - body.position), R_BD * axis), radius});
  };
  switch (shape.kind) {
    case ShapeKind::kSphere:
      entry.points.push_back({rigid_marker(entry.body, R_BD * (shape.centre - body.position)), shape.radius});
      return true;
    case ShapeKind::kTube:
    case ShapeKind::kRod:
      for (const Eigen::Vector3d& end : {shape.from, shape.to})
        add_rim(end, shape.to - shape.from, 0.5 * shape.diameter);
      return true;
    case ShapeKind::kDisc:
    case ShapeKind::kCylinder: {
      const double length = shape.kind == ShapeKind::kDisc ? shape.thickness : shape.length;
      for (const double side : {-0.5, 0.5})
        add_rim(shape.centre + side * length * shape.axis.normalized(), shape.axis, shape.radius);
      return true;
    }
    case ShapeKind::kCapsule:
      for (const Eigen::Vector3d& end : {shape.from, shape.to})
        entry.points.push_back({rigid_marker(entry.body, R_BD * (end - body.position)), 0.5 * shape.diameter});
      return true;
    case ShapeKind::kBox:
    case ShapeKind::kDish:
    case ShapeKind::kMesh:
    case ShapeKind::kPoints: return false;
  }
  FOOTFALL_DEMAND(false);
}

// The bodies that the plane touches; empty: all.
std::unordered_set<std::string> bodies_on_the_plane(const GroundSpec& ground) {
  if (!ground.is_flat()) return {};
  return {ground.bodies().begin(), ground.bodies().end()};
}

const BoundarySpec& spec_of(const Scene& scene, const BodyBoundary& entry) {
  const BoundarySpec* spec = scene.boundary_of(entry.boundary.name());
  FOOTFALL_DEMAND(spec != nullptr);
  return *spec;
}

// For a body with circular edges also the nodes within its faces: uneven ground may touch there first. Nodes on the
// edges and between them are omitted, so that the edges roll without facets.
void add_face_places(const Body& body, BodyBoundary& entry) {
  constexpr double kWithin = 0.95;  // of the radius of the edge
  if (entry.rims.empty()) return;
  for (ContactPoint& point : contact_points(entry.body, body, entry.boundary)) {
    const bool within = std::any_of(entry.rims.begin(), entry.rims.end(), [&](const ContactRim& rim) {
      const Eigen::Vector3d axis = rim.marker.axes.col(2), d = point.marker.s0 - rim.marker.s0;
      const double along = axis.dot(d);
      return std::abs(along) < 1e-6 * rim.radius && (d - along * axis).norm() < kWithin * rim.radius;
    });
    if (within && point.radius == 0.0) entry.points.push_back(std::move(point));
  }
}

// Where the mechanism starts: attitude about its mass centre, then moved, then set to its clearance above the ground.

// Height of the highest grain (its top) whose footprint overlaps the circle around one boundary, along `up`.
double highest_under(const std::vector<GrainPlace>& grains, const Eigen::Vector3d& up, const Eigen::Vector3d& centre,
                     double reach) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const GrainPlace& grain : grains) {
    const Eigen::Vector3d d = grain.centre - centre;
    const double across = (d - up * up.dot(d)).norm();
    if (across < reach + grain.radius) highest = std::max(highest, up.dot(grain.centre) + grain.radius);
  }
  return highest;
}

// Largest height of grains under a body above the field of a terrain; negative: they are below [m].
double highest_over(const std::vector<GrainPlace>& grains, Terrain& field, const Eigen::Vector3d& centre,
                    double reach) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const GrainPlace& grain : grains) {
    if ((grain.centre - centre).head<2>().norm() >= reach + grain.radius) continue;
    const Terrain::Height here = field.at(grain.centre.x(), grain.centre.y());
    highest = std::max(highest, grain.centre.z() + grain.radius * std::hypot(1.0, here.slope.norm()) - here.h);
  }
  return highest;
}

constexpr double kTilted = 1e-9;  // gravity from an axis: more than round-off
constexpr double kStray = 0.1;    // of the radius of a boundary's footprint

}  // namespace

std::vector<FlexibleBody> build_flexible_bodies(const Scene& scene, std::vector<std::string>& warnings) {
  std::vector<FlexibleBody> bodies(scene.bodies.size());
  if (!scene.flexible) return bodies;
  Reductions reductions;
  const auto attached = attachments(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto& flexible = scene.bodies[i].flexible;
    const bool rigid = !flexible || !flexible->enabled || (flexible->modes && *flexible->modes == 0);
    if (rigid) continue;
    const std::string who = "body \"" + scene.bodies[i].name + "\"";
    try {
      const auto own = attached.find(scene.bodies[i].name);
      bodies[i] = build(scene, scene.bodies[i], own == attached.end() ? std::vector<Attachment>() : own->second,
                        reductions, warnings);
    } catch (const InputError& error) {
      const std::string what = error.what();
      throw InputError(what.find(who) == std::string::npos ? who + ": " + what : what);
    }
  }
  return bodies;
}

void add_plane_places(const Scene& scene, const Body& body, BodyBoundary& entry, const BoundarySpec* spec) {
  const bool round = body.modal() == nullptr &&
                     add_round_shape(scene.bodies[entry.body], spec != nullptr ? *spec : spec_of(scene, entry), entry);
  for (ContactPoint& point : contact_points(entry.body, body, entry.boundary))
    if (!round || point.radius > 0.0) entry.points.push_back(std::move(point));  // of beams
}

const ShapeSpec* round_shape(const Scene& scene, const BodyBoundary& entry) {
  const BodySpec& body = scene.bodies[entry.body];
  const BoundarySpec& spec = spec_of(scene, entry);
  if (entry.boundary.mode_count() > 0 || !spec.surface || !spec.surface->file.empty() || !body.shape) return nullptr;
  const bool ball = body.shape->kind == ShapeKind::kSphere || body.shape->kind == ShapeKind::kCapsule;
  return ball ? &*body.shape : nullptr;
}

std::vector<ContactPoint> contact_places(const Scene& scene, const Body& body, const BodyBoundary& entry) {
  if (round_shape(scene, entry) == nullptr) return contact_points(entry.body, body, entry.boundary);
  BodyBoundary round{entry.body, entry.boundary, {}, {}};
  add_plane_places(scene, body, round);
  return round.points;
}

double lowest_place(const BodyBoundary& entry, const Eigen::Vector3d& n_B, const Eigen::VectorXd& a) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const ContactPoint& point : entry.points) {
    double height = n_B.dot(point.marker.s0) - point.radius;
    if (a.size() > 0) height += n_B.dot(point.marker.S * a);
    lowest = std::min(lowest, height);
  }
  for (const ContactRim& rim : entry.rims)  // n.c - R |n x axis|
    lowest = std::min(lowest, n_B.dot(rim.marker.s0) - rim.radius * n_B.cross(rim.marker.axes.col(2)).norm());
  return lowest;
}

BodyBoundary build_boundary(const Scene& scene, const BoundarySpec& spec, const FlexibleBody& flexible,
                            std::vector<std::string>& warnings) {
  const int index = scene.body_index(spec.body);
  const BodySpec& body = scene.bodies[index];
  BodyBoundary entry{index, build(scene, body, spec, flexible, warnings), {}, {}};
  const std::unordered_set<std::string> touching = bodies_on_the_plane(scene.ground);
  if (!touching.empty() && touching.count(body.name) == 0) return entry;
  const Body carrier = flexible.modal ? Body(body.name, flexible.modal) : Body(body.name, body.mass, body.inertia);
  if (scene.ground.is_flat()) {
    add_plane_places(scene, carrier, entry, &spec);
    if (scene.ground.is_uneven()) add_face_places(carrier, entry);
  } else {
    entry.points = contact_points(index, carrier, entry.boundary);
  }
  return entry;
}

std::vector<BodyBoundary> build_boundaries(const Scene& scene, const std::vector<FlexibleBody>& flexible,
                                           std::vector<std::string>& warnings) {
  std::vector<BodyBoundary> boundaries;
  for (const BoundarySpec& spec : scene.boundaries)
    boundaries.push_back(build_boundary(scene, spec, flexible[scene.body_index(spec.body)], warnings));
  return boundaries;
}

Placement place(const Scene& scene, const std::vector<BodyBoundary>& boundaries,
                const std::vector<FlexibleBody>& flexible, Terrain* terrain) {
  const InitialSpec& initial = scene.initial;
  if (!initial.from.empty()) return read_end_state(scene).placement;
  Placement placement;
  placement.R_WD = rotation_from_rpy(initial.roll, initial.pitch, initial.yaw);
  const Eigen::Vector3d centre = mass_centre(scene);
  placement.p_WD = centre - placement.R_WD * centre + initial.position;

  const Eigen::Vector3d up = up_direction(scene.gravity), level = axis_towards(up);  // out of a bed of grains
  const bool plane = scene.ground.is_flat(), tilted = (up - level).norm() > kTilted;
  std::vector<GrainPlace> grains;
  const bool particles = scene.touches_particles();
  if (particles && !scene.particles->grains.empty()) grains = read_grains(scene.particles->grains);
  if (plane) placement.ground_height = up.dot(scene.ground.point());
  if (plane && terrain) {  // below the mass centre
    const Eigen::Vector3d c = placement.point(centre);
    placement.ground_height = up.dot(Eigen::Vector3d(c.x(), c.y(), terrain->at(c.x(), c.y()).h));
  }
  if (particles && scene.particles->surface_height) placement.ground_height = *scene.particles->surface_height;

  placement.ground_known = plane || !grains.empty() || (particles && scene.particles->surface_height);

  // Per boundary: how far its lowest point is above the ground under it.
  double smallest = std::numeric_limits<double>::infinity();
  double highest_ground = -std::numeric_limits<double>::infinity(), highest_bed = highest_ground;
  const Placement as_drawn;
  const std::shared_ptr<Terrain> field = build_bed_surface(scene);
  const std::optional<TerrainBed> bed = terrain_bed(scene);
  for (const BodyBoundary& entry : boundaries) {
    const std::size_t i = entry.body;
    const bool still = stands_still(scene, scene.bodies[i].name);
    const Placement& placed = still ? as_drawn : placement;
    const Eigen::Matrix3d R_WB = placed.R_WD * axes_D(scene.bodies[i], flexible[i]);
    const Eigen::Vector3d r = placed.point(origin_D(scene.bodies[i], flexible[i]));
    const auto take = [&](double gap) {
      if (still) return;
      if (gap < smallest) placement.lowest = static_cast<int>(&entry - boundaries.data());
      smallest = std::min(smallest, gap);
    };
    const auto lowest_along = [&](const Eigen::Vector3d& n) {
      return n.dot(r) + lowest_place(entry, R_WB.transpose() * n, Eigen::VectorXd());
    };
    if (plane && terrain) {
      take(fall_to(*terrain, entry, r, R_WB) / std::max(0.1, up.z()));
      continue;
    }
    if (plane) {  // a sloping plane: the point of the boundary nearest to it counts
      const Eigen::Vector3d& normal = scene.ground.normal();
      const double gap = lowest_along(normal) - normal.dot(scene.ground.point());
      take(gap / std::max(1e-6, normal.dot(up)));
      continue;
    }
    double ground = placement.ground_height, bed_height = ground, out = 0.0;
    if (grains.empty() && tilted && !field)  // of a level bed below Bo, along up
      ground = up.dot(r) - (level.dot(r) - bed_height) / level.dot(up);
    if (!grains.empty()) {
      double reach = 0.0;
      for (const ContactPoint& point : entry.points) {
        const Eigen::Vector3d offset = R_WB * point.marker.s0;
        reach = std::max(reach, (offset - up * up.dot(offset)).norm() + point.radius);
      }
      ground = highest_under(grains, up, r, reach);
      bed_height = tilted ? highest_under(grains, level, r, reach) : ground;
      if (field && !still) out = highest_over(grains, *field, r, reach);
      placement.sites.push_back({highest_under(grains, up, r, (1.0 + kStray) * reach), kStray * reach, r, R_WB});
    }
    if (std::isfinite(bed_height) && !still) highest_bed = std::max(highest_bed, bed_height);
    if (!std::isfinite(ground) || still) continue;  // no grain under this boundary
    highest_ground = std::max(highest_ground, ground);
    if (!field) {
      const bool sloping = grains.empty() && tilted;  // as a plane
      take(sloping ? (lowest_along(level) - bed_height) / level.dot(up) : lowest_along(up) - ground);
      continue;
    }
    // The body falls along -z, and is lifted along up.
    const double way = fall_to(*field, entry, r, R_WB) - out;
    take(std::min(way, fall_to_rocks(bed->rocks, entry, r, R_WB)) / std::max(0.1, up.z()));
  }
  if (particles && std::isfinite(highest_ground)) placement.ground_height = highest_ground;
  placement.bed_height = tilted && std::isfinite(highest_bed) ? highest_bed : placement.ground_height;

  if (initial.clearance) {
    if (particles && grains.empty() && !scene.particles->surface_height)
      throw InputError(code::kNoGroundHeight,
                       "initial.clearance: the height of the grains is unknown; give particles.grains (a dump of x y z "
                       "radius) or particles.surface_height, or use initial.position instead");
    if (!std::isfinite(smallest))
      throw InputError(code::kNoGroundHeight,
                       std::string("initial.clearance: ") +
                           (boundaries.empty() ? "the scene has no boundary; add [[boundaries]]"
                                               : "no grain is under any boundary; check initial.position and the bed"));
    const Eigen::Vector3d lift = (*initial.clearance - smallest) * up;
    placement.p_WD += lift;
    for (std::size_t k = 0; k < placement.sites.size(); ++k)
      if (!stands_still(scene, scene.bodies[boundaries[k].body].name)) placement.sites[k].r += lift;
  }
  return placement;
}

}  // namespace footfall

// Flexible bodies of the scene: a finite-element model from shape, mesh, frame or file, reduced to modes. Its interface nodes
// are those at which joints, struts, springs and forces act.

#include <algorithm>
#include <cmath>
#include <map>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/build/codes.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/fe/modal_body_file.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/fe/turned_model.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/mesh_reader.h"

namespace footfall {
namespace {

constexpr std::size_t kMostElements = 20000;  // of a plate; the reduction then takes minutes
constexpr double kSameMass = 0.01;            // relative: masses in scenes are rounded

// A point of D at which an element acts on the body. Joints that hold an attitude need the rotations of their node.
struct Attachment {
  Eigen::Vector3d point;  // in D [m]
  bool turns;             // transmits moments
};

std::vector<Attachment> attachments(const Scene& scene, const std::string& body) {
  std::vector<Attachment> points;
  for (const JointSpec& joint : scene.joints) {
    if (joint.bodies[0] == body) points.push_back({joint.point_a, traits_of(joint.type).holds_attitude});
    if (joint.bodies[1] == body) points.push_back({joint.point_b, traits_of(joint.type).holds_attitude});
  }
  for (const StrutSpec& strut : scene.struts)
    for (std::size_t end = 0; end < 2; ++end)
      if (strut.bodies[end] == body) points.push_back({strut.points[end], false});
  for (const SpringSpec& spring : scene.springs)
    if (spring.source.given("point") && (spring.bodies[0] == body || spring.bodies[1] == body))
      points.push_back({spring.point, true});
  for (const ForceSpec& force : scene.forces)
    if (force.body == body && force.point) points.push_back({*force.point, force.torque.has_value()});
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
    while (spec.sections[static_cast<std::size_t>(section)].name != m.section) ++section;
    const Eigen::Vector3d from = spec.nodes[static_cast<std::size_t>(m.first)],
                          to = spec.nodes[static_cast<std::size_t>(m.second)];
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

FeModel plate(const BodySpec& body, const FlexibleSpec& spec, const Material& material) {
  const ShapeSpec shape = body.shape.value_or(ShapeSpec{});
  const double thickness = spec.thickness > 0.0 ? spec.thickness : shape.thickness;
  if (!spec.mesh.empty()) {
    const TriangleMesh mesh = read_mesh(spec.mesh, spec.mesh_scale);
    if (mesh.triangles.size() > kMostElements)
      throw InputError(code::kTooManyElements, spec.mesh + ": has " + std::to_string(mesh.triangles.size()) +
                                                   " triangles, expected at most " + std::to_string(kMostElements) +
                                                   " finite elements; use a coarser mesh");
    return plate_model(mesh, thickness, material, spec.mesh);
  }
  const double edge = spec.mesh_size > 0.0 ? spec.mesh_size : shape.radius / 4.0;
  const TriangleMesh flat =
      shape.kind == ShapeKind::kDish ? dish_mesh(shape.radius, shape.depth, edge) : disc_mesh(shape.radius, edge);
  return plate_model(moved(flat, axes_with_z(shape.axis), shape.centre), thickness, material,
                     "body \"" + body.name + "\"");
}

// A model of another code has a mass of its own, which shows wrong units such as grams or tonnes.
void check_mass(const BodySpec& body, double mass, const std::string& file) {
  if (std::abs(mass - body.mass) <= kSameMass * body.mass) return;
  throw InputError(code::kModelMass,
                   "the model in " + file + " weighs " + number_text(mass) + " kg, the scene states " +
                       number_text(body.mass) +
                       " kg, expected the same to 1 %; check that the units of the model are m, kg and N");
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

FlexibleBody build(const Scene& scene, const BodySpec& body, Reductions& reductions,
                   std::vector<std::string>& warnings) {
  const FlexibleSpec& spec = *body.flexible;
  BasisOptions options;
  options.kind = spec.basis;
  options.mode_count = spec.modes;
  options.max_frequency = spec.max_frequency;
  options.damping_ratio = {spec.damping};

  const std::vector<Attachment> attached = attachments(scene, body.name);
  ReducedBody reduced;
  if (!spec.file.empty()) {
    reduced = read_modal_body(spec.file, options, body.name);
    for (const Attachment& a : attached)
      joint_node(reduced.body, a.point - reduced.p_DBo, reach(reduced.body.rho0), a.turns);
    check_mass(body, reduced.body.node_mass.sum(), spec.file);
  } else if (!spec.stiffness_matrix.empty()) {
    FeModel model = read_matrix_market(spec.stiffness_matrix, spec.mass_matrix, spec.node_file);
    check_mass(body, model.node_mass.sum(), spec.mass_matrix);
    set_interface(model, attached, options);
    reduced = reductions.reduce(body, std::move(model), options);
  } else {
    const MaterialSpec& material = scene.material(body.material);
    const bool beam = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod);
    FeModel model = !spec.nodes.empty()         ? frame(spec, material)
                    : spec.mesh.empty() && beam ? beam_along_shape(*body.shape, spec.elements, attached, material)
                                                : plate(body, spec, material);
    model = with_mass(std::move(model), body.mass);
    set_interface(model, attached, options);
    reduced = reductions.reduce(body, std::move(model), options);
  }
  warnings.insert(warnings.end(), reduced.warnings.begin(), reduced.warnings.end());
  return {std::make_shared<const ModalBody>(std::move(reduced.body)), reduced.p_DBo};
}

}  // namespace

std::vector<FlexibleBody> build_flexible_bodies(const Scene& scene, std::vector<std::string>& warnings) {
  std::vector<FlexibleBody> bodies(scene.bodies.size());
  if (!scene.flexible) return bodies;
  Reductions reductions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto& flexible = scene.bodies[i].flexible;
    const bool rigid = !flexible || !flexible->enabled || (flexible->modes && *flexible->modes == 0);
    if (rigid) continue;
    const std::string who = "body \"" + scene.bodies[i].name + "\"";
    try {
      bodies[i] = build(scene, scene.bodies[i], reductions, warnings);
    } catch (const InputError& error) {
      const std::string what = error.what();
      throw InputError(what.find(who) == std::string::npos ? who + ": " + what : what);
    }
  }
  return bodies;
}

}  // namespace footfall

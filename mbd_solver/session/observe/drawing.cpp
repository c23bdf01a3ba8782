// A flexible body is drawn with the nodes of its modes, a rigid one with its boundary or else its shape. Triangles of all
// bodies come first, then lines.

#include "mbd_solver/session/observe/drawing.h"

#include <optional>

#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/model/modal_body.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/mesh_reader.h"

namespace footfall {
namespace {

ModalBoundary from_modes(const std::string& name, const ModalBody& modal) {
  std::vector<BeamSegment> segments;
  for (const Eigen::Vector2i& s : modal.segments) segments.push_back({s(0), s(1), 1e-3, 0});
  return ModalBoundary(name, modal.rho0, modal.triangles, std::move(segments), modal.Phi,
                       modal.Psi.topRows(modal.Phi.rows()));
}

ModalBoundary rigid(const std::string& name, const std::vector<Eigen::Vector3d>& points_D,
                    std::vector<Eigen::Vector3i> triangles, std::vector<BeamSegment> segments, const BodySpec& body) {
  Eigen::Matrix3Xd rho0(3, static_cast<Eigen::Index>(points_D.size()));
  const Eigen::Matrix3d R_BD = body.orientation.toRotationMatrix().transpose();
  for (std::size_t j = 0; j < points_D.size(); ++j)
    rho0.col(static_cast<Eigen::Index>(j)) = R_BD * (points_D[j] - body.position);
  return ModalBoundary(name, std::move(rho0), std::move(triangles), std::move(segments));
}

// Nothing without a shape that can be drawn.
std::optional<ModalBoundary> from_shape(const BodySpec& body) {
  if (!body.shape) return std::nullopt;
  const ShapeSpec& shape = *body.shape;
  if (shape.kind == ShapeKind::kTube || shape.kind == ShapeKind::kRod)
    return rigid(body.name, {shape.from, shape.to}, {}, {{0, 1, 0.5 * shape.diameter, 0}}, body);
  TriangleMesh mesh;
  if (shape.kind == ShapeKind::kBox)
    mesh = moved(box_mesh(shape.size, shape.size.maxCoeff()), body.orientation.toRotationMatrix(), shape.centre);
  if (shape.kind == ShapeKind::kDisc)
    mesh = moved(disc_mesh(shape.radius, shape.radius / 3.0), axes_with_z(shape.axis), shape.centre);
  if (shape.kind == ShapeKind::kDish)
    mesh = moved(dish_mesh(shape.radius, shape.depth, shape.radius / 3.0), axes_with_z(shape.axis), shape.centre);
  if (shape.kind == ShapeKind::kCylinder || shape.kind == ShapeKind::kCapsule || shape.kind == ShapeKind::kMesh)
    mesh = shape_surface(body, {});
  if (mesh.triangles.empty()) return std::nullopt;
  return rigid(body.name, mesh.vertices, mesh.triangles, {}, body);
}

}  // namespace

Drawing::Drawing(const Subject& subject) : model_(subject.mechanism.model), layout_(subject.layout), marks_(subject) {
  const Mechanism& mechanism = subject.mechanism;
  int points = 0;
  for (int i = 0; i < model_.body_count(); ++i) {
    const Body& body = model_.body(i);
    std::optional<ModalBoundary> shape;
    const bool connected = body.modal() && !(body.modal()->triangles.empty() && body.modal()->segments.empty());
    if (connected) shape = from_modes(body.name(), *body.modal());
    for (const BodyBoundary& entry : mechanism.boundaries)
      if (!shape && entry.body == i) shape = entry.boundary;
    if (!shape) shape = from_shape(subject.scene.bodies[i]);
    if (!shape) continue;
    for (const Eigen::Vector3i& t : shape->triangles()) frame_.triangles.emplace_back(t.array() + points);
    parts_.push_back({i, std::move(*shape), points});
    points += parts_.back().shape.node_count();
  }
  for (const Part& part : parts_)
    for (const BeamSegment& s : part.shape.segments())
      frame_.lines.emplace_back(s.start + part.first_point, s.end + part.first_point);
  frame_.points.resize(3, points);
  frame_.point_vectors = {{"displacement", Eigen::Matrix3Xd::Zero(3, points)},
                          {"velocity", Eigen::Matrix3Xd::Zero(3, points)}};
  const auto cells = static_cast<Eigen::Index>(frame_.triangles.size() + frame_.lines.size());
  frame_.cell_numbers = {{"von_mises_Pa", Eigen::VectorXd::Zero(cells)}, {"body", Eigen::VectorXd::Zero(cells)}};
  std::vector<std::string> names;
  for (int i = 0; i < model_.body_count(); ++i) names.push_back(model_.body(i).name());
  frame_.texts = {{"body_names", names}, {"mark_names", marks_.texts()}};  // body_names: indexed by "body" of the cells
  frame_.field_vectors.resize(1);
}

const VtkFrame& Drawing::reference_frame() {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(layout_.q_size), v = Eigen::VectorXd::Zero(layout_.v_size);
  for (int i = 0; i < model_.body_count(); ++i) {
    const BodyState& state = model_.initial(i);
    const int first = layout_.body_q[i];
    q.segment<3>(first) = state.r;
    q.segment<4>(first + 3) = state.L;
    q.segment(first + 7, state.a.size()) = state.a;
  }
  Kinematics kinematics(model_);
  kinematics.load(layout_, q, v, Eigen::VectorXd());
  return frame(kinematics, nullptr);
}

const VtkFrame& Drawing::frame(const Kinematics& kinematics, const Sample* sample) {
  frame_.field_vectors[0] = {"marks", marks_.vectors(kinematics, sample)};

  auto triangle = Eigen::Index{0};
  auto line = static_cast<Eigen::Index>(frame_.triangles.size());
  for (const Part& part : parts_) {
    const Eigen::Index s = part.shape.mode_count();
    BodyMotion motion(static_cast<int>(s));
    fill_motion(kinematics.of(part.body), motion);
    Eigen::Matrix3Xd x(3, part.shape.node_count());
    part.shape.node_positions(motion, x);
    frame_.points.middleCols(part.first_point, x.cols()) = x;
    part.shape.node_velocities(motion, x);
    frame_.point_vectors[1].second.middleCols(part.first_point, x.cols()) = x;
    if (s > 0) {
      const Eigen::VectorXd u_B = part.shape.Phi() * motion.a;
      frame_.point_vectors[0].second.middleCols(part.first_point, x.cols()) =
          motion.rotation() * Eigen::Map<const Eigen::Matrix3Xd>(u_B.data(), 3, x.cols());
    }
    const auto triangles = static_cast<Eigen::Index>(part.shape.triangles().size());
    const auto lines = static_cast<Eigen::Index>(part.shape.segments().size());
    const ModalBody* modal = model_.body(part.body).modal();
    if (s > 0 && modal) {
      const Eigen::VectorXd stress = von_mises_of_cells(*modal, motion.a);
      if (stress.size() == triangles + lines) {
        frame_.cell_numbers[0].second.segment(triangle, triangles) = stress.head(triangles);
        frame_.cell_numbers[0].second.segment(line, lines) = stress.tail(lines);
      }
    }
    frame_.cell_numbers[1].second.segment(triangle, triangles).setConstant(part.body);
    frame_.cell_numbers[1].second.segment(line, lines).setConstant(part.body);
    triangle += triangles;
    line += lines;
  }
  return frame_;
}

}  // namespace footfall

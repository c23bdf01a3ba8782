// Markers are made anew from the scene's points, as the builder makes them; loads come from the force elements.

#include "mbd_solver/session/observe/marks.h"

#include <optional>
#include <set>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/elements/cable.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/box_bed.h"

namespace footfall {
namespace {

std::string laws_of_strut(const StrutSpec& spec) {
  std::string names;
  each_law(spec, [&](const char* name, const auto& law) {
    if (law) names += (names.empty() ? "" : "+") + std::string(name);
  });
  return names;
}

}  // namespace

Marks::Marks(const Subject& subject) : subject_(subject) {
  const Model& model = subject_.mechanism.model;
  for (int i = 0; i < model.body_count(); ++i) {
    const BodySpec& spec = subject_.scene.bodies[i];
    const Marker origin = model.marker_at(i, model.initial(i).r);
    Mark mark{origin, origin, {}, FromGround{i}};
    mark.m1.s0.setZero();  // Bo itself, whatever node is nearest
    mark.m1.S.setZero();
    mark.m2 = mark.m1;
    add("body", spec.shape ? std::string(name_of(spec.shape->kind)) : "none", spec.name, mark);
  }
  add_joints();
  add_elements();
  add_cables();
  vectors_ = Eigen::Matrix3Xd::Zero(3, 4 * static_cast<Eigen::Index>(marks_.size()));
}

void Marks::add(const std::string& kind, const std::string& type, const std::string& name, Mark mark) {
  const auto body = [&](int i) { return i == kGround ? "ground" : subject_.mechanism.model.body(i).name(); };
  texts_.push_back(kind + "\t" + type + "\t" + name + "\t" + body(mark.m1.body) + "\t" + body(mark.m2.body));
  marks_.push_back(std::move(mark));
}

void Marks::add_joints() {
  const Scene& scene = subject_.scene;
  const Model& model = subject_.mechanism.model;
  const auto joint_mark = [&](int joint) { return Mark{model.joint(joint).m1, model.joint(joint).m2, {}}; };
  std::set<std::string> of_rocks;  // a stone lies in the ground: no symbol
  if (const std::optional<TerrainBed> bed = terrain_bed(scene))
    for (std::size_t k = 0; k < bed->rocks.size(); ++k) of_rocks.insert(rock_joint_name(k));
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const JointSpec& spec = scene.joints[i];
    if (of_rocks.count(spec.name) > 0) continue;
    Mark mark = joint_mark(static_cast<int>(i));
    mark.axes[1] = {0, 0, 1.0};
    if (spec.type == JointType::kUniversal) {  // x of a and y of b lie along its two axes
      mark.axes[0] = {0, 0, 1.0};
      mark.axes[1] = {1, 1, 1.0};
    }
    if (spec.type == JointType::kConstantVelocity) mark.axes[1] = {1, 2, 1.0};
    if (spec.type == JointType::kRolling) mark.axes[1] = {1, 2, *spec.radius};
    const bool ball = spec.type == JointType::kRolling && !spec.source.given("axis2");
    add("joint", ball ? "rolling_ball" : std::string(name_of(spec.type)), spec.name, mark);
  }
  for (const GearSpec& spec : scene.gears)
    for (std::size_t i = 0; i < spec.joints.size(); ++i) {
      const Coordinate coordinate = scene.coordinate_of(spec, i);
      Mark mark = joint_mark(scene.joint_index(spec.joints[i]));
      mark.m2 = joint_mark(scene.joint_index(spec.joints[(i + 1) % spec.joints.size()])).m2;
      mark.axes[0].k = axis_of(coordinate);
      mark.has_numbers = true;
      mark.numbers = {spec.factors[i], coordinate == Coordinate::kAngle ? 1.0 : 0.0, 0.0};
      add("gear", spec.curve.empty() ? "gear" : "cam", spec.name, mark);
    }
  for (std::size_t i = 0; i < scene.drives.size(); ++i) {
    const DriveSpec& spec = scene.drives[i];
    const Coordinate coordinate = scene.coordinate_of(spec);
    Mark mark = joint_mark(scene.joint_index(spec.joint));
    mark.axes[0].k = mark.axes[1].k = axis_of(coordinate);
    mark.load = subject_.mechanism.drives[i].force;
    add("drive", coordinate == Coordinate::kAngle ? "turns" : "slides", spec.name, mark);
  }
}

void Marks::add_elements() {
  const Scene& scene = subject_.scene;
  const Mechanism& mechanism = subject_.mechanism;
  const Model& model = mechanism.model;
  const auto marker = [&](const std::string& body, const Eigen::Vector3d& p_W, const Eigen::Matrix3d& axes_W) {
    return model.marker_at(scene.body_index(body), p_W, axes_W);
  };
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < scene.struts.size(); ++i) {
    const StrutSpec& spec = scene.struts[i];
    Mark mark{marker(spec.bodies[0], mechanism.placement.point(spec.points[0]), I),
              marker(spec.bodies[1], mechanism.placement.point(spec.points[1]), I),
              {},
              mechanism.struts[i].force};
    add("strut", laws_of_strut(spec), spec.name, mark);
  }
  for (const SpringSpec& spec : scene.springs) {
    const Eigen::Matrix3d axes = mechanism.placement.R_WD * axes_with_z(spec.axis, spec.axis2);
    const int b = scene.body_index(spec.bodies[1]);
    const bool at_point = spec.kind != SpringKind::kCentring || b == kGround || spec.source.given("point");
    const Eigen::Vector3d p_W = at_point ? mechanism.placement.point(spec.point) : model.initial(b).r;
    Mark mark{marker(spec.bodies[0], p_W, axes), marker(spec.bodies[1], p_W, axes), {}};
    mark.axes[1] = {0, 0, 1.0};
    add("spring", std::string(name_of(spec.kind)), spec.name, mark);
  }
  for (std::size_t i = 0; i < scene.forces.size(); ++i) {
    const ForceSpec& spec = scene.forces[i];
    const int body = scene.body_index(spec.body);
    const Eigen::Vector3d p_W = spec.point ? mechanism.placement.point(*spec.point) : model.initial(body).r;
    Mark mark{model.marker_at(body, p_W), model.marker_at(body, p_W), {}, mechanism.forces[i]};
    add("force", spec.torque && !spec.force ? "torque" : "force", spec.name, mark);
  }
}

namespace {

constexpr int kArc = 12;  // pieces along a round

// Pieces of the polygon from end to end, whether all rounds are touched or not.
int pieces_of(const Cable& cable) {
  int points = 0;
  for (const CableGuide& guide : cable.guides()) points += guide.radius > 0.0 ? kArc + 1 : 1;
  return points - 1;
}

// Its corners. An end that is a drum begins a turn before its point of contact; a round that is not touched has its corners
// along the span that passes it.
std::vector<Eigen::Vector3d> corners_of(const Cable& cable, const std::vector<CablePoint>& points) {
  std::vector<Eigen::Vector3d> out;
  const std::vector<CableGuide>& guides = cable.guides();
  std::size_t span = 0;  // the next one
  for (std::size_t i = 0; i < guides.size(); ++i) {
    const int corners = guides[i].radius > 0.0 ? kArc : 0;
    const bool comes = span > 0 && points[2 * span - 1].guide == static_cast<int>(i),
               goes = 2 * span < points.size() && points[2 * span].guide == static_cast<int>(i);
    if (!comes && !goes) {
      const Eigen::Vector3d from = points[2 * span - 2].p, to = points[2 * span - 1].p;
      for (int k = 0; k <= corners; ++k) out.push_back(from + (k + 1.0) / (corners + 2.0) * (to - from));
      continue;
    }
    const CablePoint& known = goes ? points[2 * span] : points[2 * span - 1];
    if (goes) ++span;
    if (corners == 0) {
      out.push_back(known.p);
      continue;
    }
    const Eigen::Vector3d a = known.axis;
    Eigen::Vector3d start = known.p - known.centre;
    double wrap = 2.0 * kPi;
    if (comes && goes) {
      const Eigen::Vector3d end = start;
      start = points[2 * span - 3].p - known.centre;
      wrap = std::atan2(a.dot(start.cross(end)), start.dot(end));
      if (wrap < 0.0) wrap += 2.0 * kPi;
    }
    for (int k = 0; k <= corners; ++k) out.push_back(known.centre + Eigen::AngleAxisd(wrap * k / corners, a) * start);
  }
  return out;
}

}  // namespace

// Nothing holds a cable to bodies in a picture; its name is at the first span.
void Marks::add_cables() {
  for (const CableEntry& entry : subject_.mechanism.cables) {
    const Cable& cable = entry.force.of(subject_.mechanism.model);
    const int pieces = pieces_of(cable), span = cable.guides().front().radius > 0.0 ? kArc : 0;
    for (int k = 0; k < pieces; ++k) {
      marks_.push_back(
          {cable.guides().front().marker, cable.guides().back().marker, {}, entry.force, k == 0 ? pieces : 0});
      texts_.push_back("cable\tcable\t" + (k == span ? entry.name : " ") + "\t-\t-");
    }
  }
}

void Marks::put_cable(std::size_t first, Handle<Cable> force, const Kinematics& kinematics, const Sample* sample) {
  const Cable& cable = force.of(subject_.mechanism.model);
  const Eigen::VectorXd start = cable.initial_state(), none;
  const ElementInput in = sample != nullptr ? element_input(subject_, *sample, force.index())
                                            : element_input(cable, kinematics, start, none, 0.0, nullptr);
  const std::vector<Eigen::Vector3d> corners = corners_of(cable, cable.points(in));
  const double tension = sample != nullptr ? cable.sample(in).force : 0.0;
  for (int k = 0; k < marks_[first].pieces; ++k) {
    const std::size_t at = k;
    const auto column = 4 * static_cast<Eigen::Index>(first + at);
    vectors_.col(column) = corners[at];
    vectors_.col(column + 1) = corners[at + 1];
    vectors_.col(column + 2) = tension * (corners[at] - corners[at + 1]).normalized();
    vectors_.col(column + 3).setZero();
  }
}

const Eigen::Matrix3Xd& Marks::vectors(const Kinematics& kinematics, const Sample* sample) {
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const Mark& mark = marks_[i];
    if (const auto* cable = std::get_if<Handle<Cable>>(&mark.load)) {
      if (mark.pieces > 0) put_cable(i, *cable, kinematics, sample);
      continue;
    }
    const PairMotion pair = kinematics.pair(mark.m1.body, mark.m2.body);
    const auto column = 4 * static_cast<Eigen::Index>(i);
    vectors_.col(column) = KinematicVector::point(pair, 0, mark.m1).value();
    vectors_.col(column + 1) = KinematicVector::point(pair, 1, mark.m2).value();
    for (Eigen::Index k = 0; k < 2; ++k) {
      const Axis& axis = mark.axes[k];
      const Marker& on = axis.on == 0 ? mark.m1 : mark.m2;
      vectors_.col(column + 2 + k) = axis.length * KinematicVector::axis(pair, axis.on, on, axis.k).value();
    }
    if (mark.has_numbers) vectors_.col(column + 3) = mark.numbers;
    if (std::holds_alternative<std::monostate>(mark.load)) continue;
    if (sample == nullptr) {
      vectors_.col(column + 2).setZero();
      if (!std::holds_alternative<Handle<JointForce>>(mark.load)) vectors_.col(column + 3).setZero();
    } else {
      put_load(mark, *sample, column);
    }
  }
  return vectors_;
}

void Marks::put_load(const Mark& mark, const Sample& sample, Eigen::Index column) {
  Eigen::Ref<Eigen::Vector3d> first = vectors_.col(column + 2), second = vectors_.col(column + 3);
  if (const auto* ground = std::get_if<FromGround>(&mark.load)) {
    const GeneralizedForce& contact = sample.contact[ground->body];
    first = contact.F_W;
    second = contact.T_W;
  } else if (const auto* strut = std::get_if<Handle<Strut>>(&mark.load)) {
    const Eigen::Vector3d d = vectors_.col(column + 1) - vectors_.col(column);
    first = sample_of(*strut, subject_, sample).force * d.normalized();
    second.setZero();
  } else if (const auto* drive = std::get_if<Handle<JointForce>>(&mark.load)) {
    first *= sample_of(*drive, subject_, sample).force;
  } else if (const auto* push = std::get_if<Handle<AppliedForce>>(&mark.load)) {
    const AppliedForce& force = push->of(subject_.mechanism.model);
    const ElementInput in = element_input(subject_, sample, push->index());
    Eigen::VectorXd Q = Eigen::VectorXd::Zero(in.pair.size()), dz = Eigen::VectorXd::Zero(force.state_count());
    force.add_force(in, Q, dz);
    const int slot = force.bodies()[0] == mark.m1.body ? 0 : 1;
    const Eigen::Vector3d arm = vectors_.col(column) - in.pair.body[slot]->r;
    first = Q.segment<3>(in.pair.offset(slot));
    second = Q.segment<3>(in.pair.offset(slot) + 3) - arm.cross(first);
  }
}

}  // namespace footfall

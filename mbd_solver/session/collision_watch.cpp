// Pairs of surfaces, their motion bounds and distances, and bisection of the motion between two samples where both may
// have met on it. Distances: SurfaceModel. Equations: collision_watch.h.

#include "mbd_solver/session/collision_watch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

// Motions shorter than this are not halved [of the radius].
constexpr double kShortest = 1e-9;
// A long motion between two samples, for bodies with a contact [of the smaller radius].
constexpr double kLongMotion = 0.1;
// From here on the distance of the spheres suffices [of the smaller radius].
constexpr double kFarApart = 0.1;

using Bodies = std::array<int, 2>;

bool are_same(const Bodies& a, const Bodies& b) { return a == b || (a[0] == b[1] && a[1] == b[0]); }

bool are_joined(const Model& model, const Bodies& bodies) {
  for (int i = 0; i < model.joint_count(); ++i)
    if (are_same({model.joint(i).m1.body, model.joint(i).m2.body}, bodies)) return true;
  return false;
}

// Half the way of a body whose point c (in its frame) moves on a straight line.
FramePose between(const FramePose& from, const FramePose& to, const Eigen::Vector3d& c) {
  const Eigen::Matrix3d R = Eigen::Quaterniond(from.R).slerp(0.5, Eigen::Quaterniond(to.R)).toRotationMatrix();
  return {R, 0.5 * (from.p + from.R * c + to.p + to.R * c) - R * c};
}

double angle_between(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  return 2.0 * std::asin(std::min(1.0, (to - from).norm() / (2.0 * std::sqrt(2.0))));
}

}  // namespace

CollisionWatch::CollisionWatch(const Scene& scene, const Mechanism& mechanism, const std::vector<StaticWall>& walls,
                               const Kinematics& start) {
  const bool meshes = std::any_of(walls.begin(), walls.end(), [](const StaticWall& w) { return !w.corners.empty(); });
  if (mechanism.boundaries.size() + (meshes ? 1 : 0) < 2) return;
  for (const BodyBoundary& entry : mechanism.boundaries) add_body(entry);
  const std::size_t bodies = surfaces_.size();
  for (const StaticWall& wall : walls)
    if (!wall.corners.empty()) add_wall(wall);
  const auto allowed = [&](int body_1, int body_2) {
    for (const ContactSpec& spec : scene.contacts)
      if (spec.ignore && std::count(spec.between.begin(), spec.between.end(), mechanism.model.body(body_1).name()) &&
          std::count(spec.between.begin(), spec.between.end(), mechanism.model.body(body_2).name()))
        return true;
    return false;
  };
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    for (std::size_t j = 0; j < std::min(i, bodies); ++j) {
      Pair pair;
      pair.first = i;
      pair.second = j;
      const int body_1 = surfaces_[i].body, body_2 = surfaces_[j].body;
      if (body_1 != kGround && (are_joined(mechanism.model, {body_1, body_2}) || allowed(body_1, body_2))) continue;
      for (const ContactEntry& entry : mechanism.contacts) {
        const ContactElement& contact = entry.force.of(mechanism.model);
        if (contact.kind() == ContactKind::kSurface && are_same(contact.bodies(), {body_1, body_2}))
          pair.contact = entry.force;
      }
      pair.measured = pair.last = place(pair, start);
      pair.gap = gap(pair, pair.measured).distance;
      if (pair.gap <= 0.0 && !pair.contact) {
        const bool wall = body_1 == kGround;
        const std::string both = wall ? "body \"" + surfaces_[j].name + "\" and the wall " + surfaces_[i].name
                                      : "bodies \"" + surfaces_[j].name + "\" and \"" + surfaces_[i].name + "\"";
        notes_.push_back(with_code(code::kOverlapAtStart,
                                   both + " overlap at the start: collisions between them are not detected."));
        continue;
      }
      pairs_.push_back(std::move(pair));
    }
  }
}

void CollisionWatch::add_body(const BodyBoundary& entry) {
  const ModalBoundary& boundary = entry.boundary;
  Surface surface;
  surface.name = boundary.name();
  surface.body = entry.body;
  surface.boundary = &boundary;
  surface.modes = Eigen::VectorXd::Zero(boundary.mode_count());
  if (!boundary.triangles().empty()) surface.parts.emplace_back(boundary.rho0(), boundary.triangles());
  std::map<double, std::vector<Eigen::Vector3i>> beams;  // by radius
  for (const BeamSegment& segment : boundary.segments())
    beams[segment.radius].emplace_back(segment.start, segment.start, segment.end);
  for (const auto& [radius, lines] : beams) surface.parts.emplace_back(boundary.rho0(), lines, radius);
  if (surface.parts.empty()) return;
  enclose(surface);
  for (int j = 0; j < boundary.node_count() && boundary.mode_count() > 0; ++j)
    surface.modal_reach = std::max(surface.modal_reach, boundary.Phi().middleRows(3 * j, 3).norm());
  surfaces_.push_back(std::move(surface));
}

void CollisionWatch::add_wall(const StaticWall& wall) {
  Surface surface;
  surface.name = wall.name;
  surface.boundary = nullptr;
  const auto count = static_cast<Eigen::Index>(wall.corners.size());
  Eigen::Matrix3Xd vertices(3, count);
  std::vector<Eigen::Vector3i> triangles;
  for (Eigen::Index i = 0; i < count; ++i) vertices.col(i) = wall.corners[i];
  for (int i = 0; i < static_cast<int>(count); i += 3) triangles.emplace_back(i, i + 1, i + 2);
  surface.parts.emplace_back(vertices, std::move(triangles));
  enclose(surface);
  surfaces_.push_back(std::move(surface));
}

void CollisionWatch::enclose(Surface& surface) {
  surface.centre.setZero();
  for (const SurfaceModel& part : surface.parts) surface.centre += part.centre();
  surface.centre /= static_cast<double>(surface.parts.size());
  for (const SurfaceModel& part : surface.parts)
    surface.radius = std::max(surface.radius, (part.centre() - surface.centre).norm() + part.radius());
}

void CollisionWatch::remove_walls(const std::vector<std::string>& names) {
  pairs_.erase(std::remove_if(pairs_.begin(), pairs_.end(),
                              [&](const Pair& pair) {
                                const Surface& first = surfaces_[pair.first];
                                return first.body == kGround && std::count(names.begin(), names.end(), first.name) > 0;
                              }),
               pairs_.end());
}

void CollisionWatch::deform(Surface& surface, const Eigen::VectorXd& a) {
  if (a.size() == 0 || surface.modes == a) return;
  Eigen::Matrix3Xd rho = surface.boundary->rho0();
  Eigen::Map<Eigen::VectorXd>(rho.data(), rho.size()) += surface.boundary->Phi() * a;
  for (SurfaceModel& part : surface.parts) part.move(rho);
  surface.modes = a;
}

FramePose CollisionWatch::PairPose::pose() const {
  return {first.R.transpose() * second.R, first.R.transpose() * (second.p - first.p)};
}

CollisionWatch::PairPose CollisionWatch::place(const Pair& pair, const Kinematics& kinematics) const {
  const BodyKinematics& first = kinematics.of(surfaces_[pair.first].body);
  const BodyKinematics& second = kinematics.of(surfaces_[pair.second].body);
  return {{first.A, first.r}, {second.A, second.r}, first.a, second.a};
}

double CollisionWatch::travel(const Pair& pair, const PairPose& from, const PairPose& to) const {
  const Surface &first = surfaces_[pair.first], &second = surfaces_[pair.second];
  const auto apart = [&](const PairPose& at) -> Eigen::Vector3d {
    return at.second.p + at.second.R * second.centre - at.first.p - at.first.R * first.centre;
  };
  double way = (apart(to) - apart(from)).norm() + first.radius * angle_between(from.first.R, to.first.R) +
               second.radius * angle_between(from.second.R, to.second.R);
  if (first.modal_reach > 0.0) way += first.modal_reach * (to.a_1 - from.a_1).norm();
  if (second.modal_reach > 0.0) way += second.modal_reach * (to.a_2 - from.a_2).norm();
  return way;
}

// Negative where the spheres intersect.
double CollisionWatch::sphere_distance(const Pair& pair, const PairPose& at) const {
  const Surface &first = surfaces_[pair.first], &second = surfaces_[pair.second];
  double distance = (at.second.p + at.second.R * second.centre - at.first.p - at.first.R * first.centre).norm() -
                    first.radius - second.radius;
  if (first.modal_reach > 0.0) distance -= first.modal_reach * at.a_1.norm();
  if (second.modal_reach > 0.0) distance -= second.modal_reach * at.a_2.norm();
  return distance;
}

SurfaceGap CollisionWatch::gap(const Pair& pair, const PairPose& at) {
  Surface &first = surfaces_[pair.first], &second = surfaces_[pair.second];
  if (const double apart = sphere_distance(pair, at); apart > kFarApart * std::min(first.radius, second.radius))
    return {apart, Eigen::Vector3d::Zero()};
  if (first.boundary != nullptr) deform(first, at.a_1);
  deform(second, at.a_2);
  const FramePose pose = at.pose();
  SurfaceGap least;
  bool any = false;
  for (SurfaceModel& a : first.parts) {
    for (SurfaceModel& b : second.parts) {
      const SurfaceGap one = gap_between(a, b, pose);
      if (!any || one.distance < least.distance) least = one;
      any = true;
    }
  }
  return least;
}

// Neither end touches.
bool CollisionWatch::met_between(const Pair& pair, const PairPose& from, double gap_from, const PairPose& to,
                                 double gap_to, SurfaceGap& met) {
  const double way = travel(pair, from, to);
  if (way < gap_from + gap_to || way < kShortest * surfaces_[pair.second].radius) return false;
  const PairPose middle{between(from.first, to.first, surfaces_[pair.first].centre),
                        between(from.second, to.second, surfaces_[pair.second].centre), 0.5 * (from.a_1 + to.a_1),
                        0.5 * (from.a_2 + to.a_2)};
  met = gap(pair, middle);
  const double gap_middle = met.distance;
  return gap_middle <= 0.0 || met_between(pair, from, gap_from, middle, gap_middle, met) ||
         met_between(pair, middle, gap_middle, to, gap_to, met);
}

void CollisionWatch::begin(const Kinematics& kinematics) {
  for (Pair& pair : pairs_) {
    pair.measured = pair.last = place(pair, kinematics);
    pair.gap = 0.0;
    pair.touched = static_cast<bool>(pair.contact);  // unknown
  }
}

// Bodies with a contact may bounce between two samples; only on a long motion can they pass through unnoticed.
bool CollisionWatch::may_have_passed(const Pair& pair, const PairPose& now) const {
  const Surface &first = surfaces_[pair.first], &second = surfaces_[pair.second];
  const double smaller = first.body == kGround ? second.radius : std::min(first.radius, second.radius);
  return !pair.contact || (!pair.touched && travel(pair, pair.last, now) > kLongMotion * smaller);
}

void CollisionWatch::check(const Subject& subject, const Sample& sample) {
  for (Pair& pair : pairs_) {
    PairPose now = place(pair, sample.kinematics);
    const bool far = travel(pair, pair.measured, now) < pair.gap;
    if (far) {
      pair.touched = false;
    } else {
      const auto touches = [&] {
        if (!pair.contact) return false;
        const ContactElement& contact = pair.contact.of(subject.mechanism.model);
        return contact.largest_overlap(element_input(subject, sample, pair.contact.index())) > 0.0;
      };
      const bool touched = touches();
      if (touched) {  // a contact acts: checked again when it opens
        pair.gap = 0.0;
        pair.measured = now;
      } else {
        SurfaceGap found = gap(pair, now);
        const double gap_now = found.distance;
        const double gap_last = std::max(0.0, pair.gap - travel(pair, pair.measured, pair.last));
        const bool met = gap_now <= 0.0 ||
                         (may_have_passed(pair, now) && met_between(pair, pair.last, gap_last, now, gap_now, found));
        if (met) report(pair, sample, found.place);
        pair.gap = gap_now;
        pair.measured = now;
      }
      pair.touched = touched;
    }
    pair.last = std::move(now);
  }
}

void CollisionWatch::report(const Pair& pair, const Sample& sample, const Eigen::Vector3d& place) const {
  const Surface &first = surfaces_[pair.first], &second = surfaces_[pair.second];
  const BodyKinematics& frame = sample.kinematics.of(first.body);
  const Eigen::Vector3d p_W = frame.r + frame.A * place;
  const bool wall = first.body == kGround;
  std::string what = "t = " + number_text(sample.state.time) + " s: body \"" + second.name + "\" passes through " +
                     (wall ? "the wall " + first.name : "body \"" + first.name + "\"") + " at (" + number_text(p_W[0]) +
                     ", " + number_text(p_W[1]) + ", " + number_text(p_W[2]) + ") m";
  if (pair.contact) {
    what +=
        " between the points of their contact, where edges cross or a thin part passes: refine the surfaces, or "
        "increase the stiffness of the contact";
  } else if (wall) {
    what +=
        ": walls of LIGGGHTS act on grains only. Add [[contacts]] with walls = true for the body, or end the scene "
        "earlier";
  } else {
    what += ": they have no contact. Add [[contacts]] with between = [\"" + first.name + "\", \"" + second.name +
            "\"], or allow it with ignore = true";
  }
  throw NumericalError(code::kCollision, what);
}

}  // namespace footfall

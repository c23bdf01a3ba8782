// Numbers that a scene may have, but hardly means. Limits are far from anything that is built, so that a finding is mostly a
// mistake in a unit.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;
namespace {

using Eigen::Vector3d;

constexpr double kDensest = 23000.0;     // osmium has 22600 [kg/m3]
constexpr double kOfItsSurface = 10.0;   // a shape may be the surface alone of what the body is [kDensest]
constexpr double kLightest = 0.5;        // air has 1.2 [kg/m3]
constexpr double kThinnest = 0.1;        // a thinner plate may stand for more than its volume [radius]
constexpr double kMostGravity = 5000.0;  // of centrifuges [m/s2]
constexpr double kUsualSound = 1000.0;   // where a body has no modulus [m/s]
constexpr double kFarOutside = 10.0;     // radius of gyration of a shape [its reach]
constexpr double kFarFromPoints = 30.0;  // the same where points alone are known [size of the mechanism]
constexpr double kFewPoints = 10.0;  // a body without shape may be larger than where it is held [size of the mechanism]
constexpr double kTouching = 1e-6;   // [of the size of a body]

// Any two unit vectors that are perpendicular to the axis and to each other.
std::array<Vector3d, 2> across(const Vector3d& axis) {
  const Vector3d x = axis.unitOrthogonal();
  return {x, axis.normalized().cross(x)};
}

// The outermost points of a shape in D, whose hull it fills but for round edges; empty: unknown.
std::vector<Vector3d> outline(const BodySpec& body) {
  std::vector<Vector3d> out;
  const ShapeSpec& s = *body.shape;
  const auto ring = [&](const Vector3d& centre, const Vector3d& axis, double radius) {
    for (const Vector3d& e : across(axis))
      for (const double side : {-radius, radius}) out.push_back(centre + side * e);
  };
  switch (s.kind) {
    case ShapeKind::kBox:
      for (int k = 0; k < 8; ++k) {
        const Vector3d corner(k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5);
        out.push_back(s.centre + body.orientation * corner.cwiseProduct(s.size));
      }
      break;
    case ShapeKind::kCapsule: {
      const Vector3d end = 0.5 * s.diameter * (s.to - s.from).normalized();
      out = {s.from - end, s.to + end};
    }
      [[fallthrough]];
    case ShapeKind::kTube:
    case ShapeKind::kRod:
      for (const Vector3d& end : {s.from, s.to}) ring(end, s.to - s.from, 0.5 * s.diameter);
      break;
    case ShapeKind::kDisc:
    case ShapeKind::kCylinder: {
      const double half = 0.5 * (s.kind == ShapeKind::kDisc ? s.thickness : s.length);
      for (const double side : {-half, half}) ring(s.centre + side * s.axis.normalized(), s.axis, s.radius);
      break;
    }
    case ShapeKind::kDish:
      out.push_back(s.centre);
      ring(s.centre + s.depth * s.axis.normalized(), s.axis, s.radius);
      break;
    case ShapeKind::kSphere:
      for (int k = 0; k < 3; ++k)
        for (const double side : {-s.radius, s.radius}) out.push_back(s.centre + side * Vector3d::Unit(k));
      break;
    case ShapeKind::kPoints: out = s.points; break;
    case ShapeKind::kMesh: break;  // its file was read for the mass, and is not kept
  }
  return out;
}

// Of what the shape encloses, a thin plate or wall taken as thick [m3]; 0: unknown.
double volume_within(const ShapeSpec& s) {
  switch (s.kind) {
    case ShapeKind::kBox: return s.size.prod();
    case ShapeKind::kTube:
    case ShapeKind::kRod: return 0.25 * kPi * s.diameter * s.diameter * (s.to - s.from).norm();
    case ShapeKind::kCapsule: return kPi * s.diameter * s.diameter * (0.25 * (s.to - s.from).norm() + s.diameter / 6.0);
    case ShapeKind::kDisc: return kPi * s.radius * s.radius * std::max(s.thickness, kThinnest * s.radius);
    case ShapeKind::kCylinder: return kPi * s.radius * s.radius * s.length;
    case ShapeKind::kSphere: return 4.0 / 3.0 * kPi * std::pow(s.radius, 3);
    case ShapeKind::kDish:
    case ShapeKind::kMesh:
    case ShapeKind::kPoints: break;
  }
  return 0.0;
}

// Whether a point is inside of a solid shape, or within `margin` of its surface.
bool is_inside(const BodySpec& body, const Vector3d& p, double margin) {
  const ShapeSpec& s = *body.shape;
  const auto in_cylinder = [&](const Vector3d& centre, const Vector3d& axis, double radius, double half) {
    const double along = (p - centre).dot(axis.normalized());
    return std::abs(along) <= half + margin && (p - centre - along * axis.normalized()).norm() <= radius + margin;
  };
  const Vector3d middle = 0.5 * (s.from + s.to);
  switch (s.kind) {
    case ShapeKind::kBox: {
      const Vector3d local = body.orientation.inverse() * (p - s.centre);
      return (local.cwiseAbs() - 0.5 * s.size).maxCoeff() <= margin;
    }
    case ShapeKind::kRod: return in_cylinder(middle, s.to - s.from, 0.5 * s.diameter, 0.5 * (s.to - s.from).norm());
    case ShapeKind::kCapsule: {
      const Vector3d axis = s.to - s.from;
      const double share = std::clamp((p - s.from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
      return (p - s.from - share * axis).norm() <= 0.5 * s.diameter + margin;
    }
    case ShapeKind::kDisc: return in_cylinder(s.centre, s.axis, s.radius, 0.5 * s.thickness);
    case ShapeKind::kCylinder: return in_cylinder(s.centre, s.axis, s.radius, 0.5 * s.length);
    case ShapeKind::kSphere: return (p - s.centre).norm() <= s.radius + margin;
    case ShapeKind::kTube:  // hollow
    case ShapeKind::kDish:
    case ShapeKind::kMesh:
    case ShapeKind::kPoints: break;
  }
  return false;
}

// Sets of bodies that joints connect, the ground among them.
class Parts {
 public:
  explicit Parts(const Scene& scene) : parent_(scene.bodies.size() + 1) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const JointSpec& joint : scene.joints)
      parent_[of(scene.body_index(joint.bodies[0]))] = of(scene.body_index(joint.bodies[1]));
  }
  // The set of a body; -1: of the ground.
  std::size_t of(int body) {
    std::size_t i = static_cast<std::size_t>(body + 1);
    for (; parent_[i] != i; i = parent_[i]) parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  std::vector<std::size_t> parent_;
};

class Plausibility {
 public:
  Plausibility(const Scene& scene, Findings& findings) : scene_(scene), findings_(findings) {
    for (const BodySpec& body : scene.bodies) {
      outlines_.push_back(body.shape ? outline(body) : std::vector<Vector3d>());
      box_.extend(body.position);
      for (const Vector3d& point : outlines_.back()) box_.extend(point);
    }
    for (const JointSpec& joint : scene.joints) {
      box_.extend(joint.point_a);
      box_.extend(joint.point_b);
    }
    for (const StrutSpec& strut : scene.struts)
      for (const Vector3d& point : strut.points) box_.extend(point);
    for (const CableSpec& cable : scene.cables)
      for (const CableGuideSpec& guide : cable.path) box_.extend(guide.point);
    size_ = box_.isEmpty() ? 0.0 : box_.diagonal().norm();
  }

  void check() {
    check_gravity();
    for (const MaterialSpec& material : scene_.materials) check_density(material);
    if (scene_.particles && scene_.particles->box) check_box(*scene_.particles->box);
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      check_mass(scene_.bodies[i]);
      check_inertia(scene_.bodies[i], outlines_[i]);
    }
    check_angles();
    check_speeds();
    check_springs_that_carry();
    check_inside();
  }

 private:
  void check_gravity() {
    const double g = scene_.gravity.norm();
    if (g > kMostGravity)
      findings_.warning(kImplausibleGravity, scene_.source, "gravity",
                        "is " + number_text(g) + " m/s2, " + number_text(g / 9.81, 3) +
                            " times that of the Earth; if it is in mm/s2, divide it by 1000");
  }

  void check_density(const MaterialSpec& material) {
    if (material.density > kDensest)
      findings_.warning(kImplausibleMass, material.source, "density",
                        "is " + number_text(material.density) + " kg/m3, more than that of any solid, " +
                            number_text(kDensest) + " kg/m3; write kg/m3, or use the suffix _g_cm3");
  }

  void check_box(const BoxSpec& box) {
    const double density = box.material.density;
    if (density > kDensest || density < kLightest)
      findings_.warning(kImplausibleMass, scene_.particles->source, "box.material.density",
                        "is " + number_text(density) + " kg/m3, " +
                            (density < kLightest ? "lighter than air" : "more than that of any solid") +
                            "; it is that of a grain, not of the bed, in kg/m3");
    const double interval = box.every.value_or(0) * box_numbers(scene_).time_step;
    if (interval > scene_.end_time)
      findings_.error(
          kOutOfRange, scene_.particles->source, "box.exchange_steps",
          "is " + std::to_string(box.every.value_or(0)) + " steps of the grains, " + number_text(interval, 3) +
              " s, longer than the scene, " + number_text(scene_.end_time, 3) +
              " s: the mechanism would never meet the grains. Remove it: the interval is then chosen during "
              "the run");
  }

  void check_mass(const BodySpec& body) {
    if (!body.source.given("mass") || body.mass_is_remainder) return;
    const double volume = body.shape ? volume_within(*body.shape) : 0.0;
    if (volume == 0.0) {
      const double most = kDensest * std::pow(kFewPoints * size_, 3);
      if (most > 0.0 && body.mass > most)
        findings_.warning(kImplausibleMass, body.source, "mass",
                          "is " + number_text(body.mass) + " kg in a mechanism of " + number_text(size_, 3) +
                              " m; check the unit (_g, _t), and that lengths are in m");
      return;
    }
    const double density = body.mass / volume;
    if (density >= kLightest && density <= kOfItsSurface * kDensest) return;
    findings_.warning(kImplausibleMass, body.source, "mass",
                      "is " + number_text(body.mass) + " kg for a shape of " + number_text(volume, 3) +
                          " m3, which is " + (density < kLightest ? "lighter than air" : "far denser than any solid") +
                          " (" + number_text(density, 3) + " kg/m3); check the units of mass (_g, _t) and shape (_mm)");
  }

  void check_inertia(const BodySpec& body, const std::vector<Vector3d>& points) {
    if (!body.source.given("inertia")) return;
    double reach = 0.0;  // [m]
    for (const Vector3d& point : points) reach = std::max(reach, (point - body.position).norm());
    const double limit = reach > 0.0 ? kFarOutside * reach : kFarFromPoints * size_;
    const double gyration = std::sqrt(0.5 * body.inertia.trace() / body.mass);
    if (limit > 0.0 && gyration > limit)
      findings_.warning(kImplausibleInertia, body.source, "inertia",
                        "has a radius of gyration of " + number_text(gyration, 3) + " m, but " +
                            (reach > 0.0 ? "the body reaches no farther than " + number_text(reach, 3)
                                         : "the mechanism is not larger than " + number_text(size_, 3)) +
                            " m; write it in kg m2 (1 kg mm2 = 1e-6 kg m2)");
  }

  void check_angle(const Source& source, const std::string& key, double value) {
    if (std::abs(value) <= 2.0 * kPi || source.in_other_units.count(key) > 0) return;
    const std::size_t dot = key.rfind('.');
    findings_.warning(kAngleInDegrees, source, key,
                      "is " + number_text(value) + " rad, " + number_text(value / (2.0 * kPi), 3) +
                          " turns; if degrees are meant, write " + key.substr(dot == std::string::npos ? 0 : dot + 1) +
                          "_deg, which also ends this warning for so many turns");
  }

  void check_angles() {
    const InitialSpec& initial = scene_.initial;
    for (const auto& [key, value] : {std::pair("roll", initial.roll), {"pitch", initial.pitch}, {"yaw", initial.yaw}})
      check_angle(initial.source, key, value);
    for (const SpringSpec& spring : scene_.springs) check_angle(spring.source, "rest_angle", spring.rest_angle);
    for (const JointSpec& joint : scene_.joints) {
      if (joint.angle && joint.angle->stops) {
        check_angle(joint.source, "angle.stops.min", joint.angle->stops->smallest_stroke.value_or(0.0));
        check_angle(joint.source, "angle.stops.max", joint.angle->stops->largest_stroke.value_or(0.0));
      }
      if (joint.angle && joint.angle->spring)
        check_angle(joint.source, "angle.spring.rest", joint.angle->spring->free_stroke);
      if (!joint.motion || !joint.motion->rotation) continue;
      check_angle(joint.source, "motion.rotation.amplitude", joint.motion->rotation->amplitude);
      check_angle(joint.source, "motion.rotation.phase", joint.motion->rotation->phase);
    }
  }

  // of sound in a rod of its material [m/s]
  double sound_in(const BodySpec& body) const {
    const MaterialSpec* material = scene_.material_or_null(body.material);
    return material != nullptr && material->young > 0.0 && material->density > 0.0
               ? std::sqrt(material->young / material->density)
               : kUsualSound;
  }

  void check_speed(const Source& source, const std::string& key, double speed, double sound,
                   const std::string& remedy) {
    if (speed > sound)
      findings_.warning(kImplausibleSpeed, source, key,
                        "moves bodies at " + number_text(speed, 3) + " m/s" +
                            (size_ > 0.0 ? ", " + number_text(speed / size_, 3) + " times their size per second" : "") +
                            ": faster than sound in them, about " + number_text(sound, 3) + " m/s; " + remedy);
  }

  void check_speeds() {
    const std::string in_mm = "if it is in mm/s, write velocity_mm_s",
                      in_rpm = "for degrees or turns use the suffix _deg (per second) or _rpm";
    double slowest = HUGE_VAL;
    for (const BodySpec& body : scene_.bodies) slowest = std::min(slowest, sound_in(body));
    const InitialSpec& initial = scene_.initial;
    check_speed(initial.source, "velocity", initial.velocity.norm(), slowest, in_mm);
    check_speed(initial.source, "angular_velocity", initial.angular_velocity.norm() * 0.5 * size_, slowest, in_rpm);
    for (const BodyVelocitySpec& own : initial.bodies) {
      const BodySpec* body = scene_.body(own.body);
      if (own.velocity) check_speed(own.source, "velocity", own.velocity->norm(), sound_in(*body), in_mm);
      double reach = 0.0;
      for (const Vector3d& point : outlines_[static_cast<std::size_t>(body - scene_.bodies.data())])
        reach = std::max(reach, (point - body->position).norm());
      if (own.angular_velocity)
        check_speed(own.source, "angular_velocity", own.angular_velocity->norm() * reach, sound_in(*body), in_rpm);
    }
    for (const JointSpec& joint : scene_.joints) {
      if (!joint.motion) continue;
      for (const auto& [key, f] :
           {std::pair("x", &joint.motion->x), {"y", &joint.motion->y}, {"z", &joint.motion->z}}) {
        if (!*f) continue;
        const double linear = (*f)->polynomial.size() > 1 ? std::abs((*f)->polynomial[1]) : 0.0;
        check_speed(joint.source, std::string("motion.") + key,
                    linear + std::abs((*f)->amplitude) * 2.0 * kPi * (*f)->frequency, slowest,
                    "check that it is in m, and its frequency in Hz");
      }
    }
  }

  // Bodies that hang on springs alone: under their weight the springs yield by m g / k.
  void check_springs_that_carry() {
    struct Hung {
      double mass = 0.0, stiffness = 0.0, stiffest = 0.0;  // [kg], [N/m]
      bool held = false;                                   // by something else as well
      const Source* source = nullptr;                      // of the stiffest spring, and its key
      const char* key = "";
    };
    const double g = scene_.gravity.norm();
    Parts parts(scene_);
    std::vector<Hung> hung(scene_.bodies.size() + 1);
    hung[parts.of(-1)].held = true;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
      hung[parts.of(static_cast<int>(i))].mass += scene_.bodies[i].mass;
    const auto hold = [&](const std::string& body) { hung[parts.of(scene_.body_index(body))].held = true; };
    if (scene_.ground.kind != GroundKind::kNone || !scene_.contacts.empty())
      for (const BoundarySpec& boundary : scene_.boundaries) hold(boundary.body);
    for (const ForceSpec& force : scene_.forces) hold(force.body);
    for (const CableSpec& cable : scene_.cables)
      for (const CableGuideSpec& guide : cable.path) hold(guide.body);
    const auto hang = [&](const auto& entry, double stiffness, bool held, const char* key) {
      const std::size_t ends[2] = {parts.of(scene_.body_index(entry.bodies[0])),
                                   parts.of(scene_.body_index(entry.bodies[1]))};
      if (ends[0] == ends[1]) return;
      for (const std::size_t end : ends) {
        Hung& part = hung[end];
        part.held = part.held || held;
        part.stiffness += stiffness;
        if (stiffness <= part.stiffest) continue;
        part.stiffest = stiffness;
        part.source = &entry.source;
        part.key = key;
      }
    };
    for (const StrutSpec& strut : scene_.struts)
      hang(strut, strut.spring ? strut.spring->stiffness : 0.0,
           strut.gas || strut.honeycomb || strut.stops || strut.table || (strut.spring && strut.spring->preload != 0.0),
           "spring.stiffness");
    for (const SpringSpec& spring : scene_.springs)
      hang(spring, spring.kind == SpringKind::kBushing ? spring.stiffness.maxCoeff() : 0.0, false, "stiffness");
    for (const Hung& part : hung) {
      if (part.held || part.source == nullptr || !(part.mass * g > size_ * part.stiffness)) continue;
      findings_.warning(kSoftSpring, *part.source, part.key,
                        "is so small that " + number_text(part.mass, 3) + " kg on " +
                            (part.stiffest < part.stiffness ? "such springs sink" : "the spring sinks") + " by " +
                            number_text(part.mass * g / part.stiffness, 3) + " m, in a mechanism of " +
                            number_text(size_, 3) + " m; write it in N/m, or use the suffix _N_mm");
    }
  }

  // A body whose outline is inside of another one that nothing connects to it.
  void check_inside() {
    std::set<std::pair<std::size_t, std::size_t>> connected;
    const auto connect = [&](const std::string& a, const std::string& b) {
      const std::optional<std::size_t> i = scene_.indices.bodies.find(scene_.bodies, a),
                                       j = scene_.indices.bodies.find(scene_.bodies, b);
      if (i && j) connected.insert(std::minmax(*i, *j));
    };
    for (const JointSpec& joint : scene_.joints) connect(joint.bodies[0], joint.bodies[1]);
    for (const StrutSpec& strut : scene_.struts) connect(strut.bodies[0], strut.bodies[1]);
    for (const SpringSpec& spring : scene_.springs) connect(spring.bodies[0], spring.bodies[1]);
    for (const CableSpec& cable : scene_.cables)
      for (const CableGuideSpec& a : cable.path)
        for (const CableGuideSpec& b : cable.path) connect(a.body, b.body);
    for (const ContactSpec& contact : scene_.contacts)
      if (contact.between.size() == 2) connect(contact.between[0], contact.between[1]);

    std::vector<std::pair<Eigen::AlignedBox3d, std::size_t>> boxes;  // around outlines, by rising x
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      if (outlines_[i].empty()) continue;
      Eigen::AlignedBox3d box;
      for (const Vector3d& point : outlines_[i]) box.extend(point);
      boxes.emplace_back(box, i);
    }
    std::sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) {
      return a.first.min().x() != b.first.min().x() ? a.first.min().x() < b.first.min().x() : a.second < b.second;
    });
    for (std::size_t m = 0; m < boxes.size(); ++m) {
      const auto& [outer, i] = boxes[m];
      const double margin = kTouching * outer.diagonal().norm();
      std::size_t first = m;
      while (first > 0 && boxes[first - 1].first.min().x() >= outer.min().x() - margin) --first;
      for (std::size_t n = first; n < boxes.size() && boxes[n].first.min().x() <= outer.max().x(); ++n) {
        const auto& [inner, j] = boxes[n];
        if (i == j || (inner.max() - outer.max()).maxCoeff() > margin ||
            (outer.min() - inner.min()).maxCoeff() > margin)
          continue;
        if (connected.count(std::minmax(i, j)) > 0) continue;  // or reported the other way round
        const std::vector<Vector3d>& points = outlines_[j];
        const BodySpec& around = scene_.bodies[i];
        if (!std::all_of(points.begin(), points.end(), [&](const Vector3d& p) { return is_inside(around, p, margin); }))
          continue;
        connected.insert(std::minmax(i, j));
        findings_.warning(kBodyInside, scene_.bodies[j].source, "name",
                          "body \"" + scene_.bodies[j].name + "\" is inside of body \"" + around.name + "\" (line " +
                              std::to_string(around.source.line) +
                              "), and nothing connects the two; move one of them, or add a joint");
      }
    }
  }

  const Scene& scene_;
  Findings& findings_;
  std::vector<std::vector<Vector3d>> outlines_;  // of each body
  Eigen::AlignedBox3d box_;                      // around all points
  double size_ = 0.0;                            // its diagonal [m]
};

}  // namespace

void check_plausible(const Scene& scene, Findings& findings) { Plausibility(scene, findings).check(); }

}  // namespace footfall

// Numbers that a scene may have, but hardly means. Limits are far from anything that is built, so that a finding is mostly a
// mistake in a unit.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include "coupler/base/concat.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/scene_check.h"
#include "mbd_solver/scene/shape_outline.h"

namespace footfall {

using namespace code;
namespace {

using Eigen::Vector3d;

constexpr double kDensest = 23000.0;     // osmium has 22600 [kg/m3]
constexpr double kOfItsSurface = 10.0;   // a shape may be the surface alone of what the body is [kDensest]
constexpr double kLightest = 0.5;        // air has 1.2 [kg/m3]
constexpr double kLightestGrain = 10.0;  // [kg/m3]; beads of foam have 15
constexpr double kFastImpact = 100.0;  // [m/s]; a mechanism that meets a ground faster is mostly written in other units
constexpr double kWeakestCrush = 0.01;    // of a honeycomb [weight of the mechanism]
constexpr double kFarRequirement = 20.0;  // [size of the mechanism]
constexpr double kThinnest = 0.1;         // a thinner plate may stand for more than its volume [radius]
constexpr double kMostGravity = 5000.0;   // of centrifuges [m/s2]
constexpr double kUsualSound = 1000.0;    // where a body has no modulus [m/s]
constexpr double kFarOutside = 10.0;      // radius of gyration of a shape [its reach]
constexpr double kFarFromPoints = 30.0;   // the same where points alone are known [size of the mechanism]
constexpr double kFewPoints = 10.0;  // a body without shape may be larger than where it is held [size of the mechanism]
constexpr double kTouching = 1e-6;   // [of the size of a body]
constexpr double kThinnestBody = 1e-3;                          // [kg/m3] in the ball of its radius of gyration
constexpr double kRoughest = 5.0;                               // rubber has 1 to 2; 30 are degrees or per cent
constexpr double kLeastPressure = 2000.0, kMostPressure = 2e8;  // of gas in a strut [Pa]
constexpr double kFarAway = 500.0;                              // of a point of a body [its reach]
constexpr double kPlaces = 100.0;                               // of a boundary that bear it on a plane
constexpr double kOpenMotion = 1e-3;                            // largest gap that the start closes [m]
constexpr double kLongRun = 1e6;                                // steps, of minutes to hours
constexpr double kStepsOfPeriod = 10.0;                         // of a sine, at least
constexpr double kSunk = 0.1;                                   // on a plane, at rest [size of the mechanism]

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
      outlines_.push_back(shape_outline(body));
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
    if (scene_.ground.kind == GroundKind::kSoil && scene_.ground.law)
      check_ground_density(scene_.ground.source, "law.density", scene_.ground.law->density,
                           "expected the density of the soil with its pores, in kg/m3");
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      check_mass(scene_.bodies[i]);
      check_inertia(scene_.bodies[i], outlines_[i]);
    }
    check_angles();
    check_speeds();
    check_springs_that_carry();
    check_sliders();
    check_plane();
    check_map();
    check_ratios();
    check_gas();
    check_honeycombs();
    check_requirement_lengths();
    check_points();
    if (starts_as_drawn()) {
      check_stops();
      check_motion_starts();
    }
    check_periods();
    check_inside();
  }

 private:
  void check_gravity() {
    const double g = scene_.gravity.norm();
    if (g > kMostGravity)
      findings_.warning(kImplausibleGravity, scene_.source, "gravity", "is ", g, " m/s2, ", number_text(g / 9.81, 3),
                        " times Earth's gravity; if it is in mm/s2, divide it by 1000");
  }

  void check_density(const MaterialSpec& material) {
    if (material.density > kDensest)
      findings_.warning(kImplausibleMass, material.source, "density", "is ", material.density,
                        " kg/m3, denser than any solid, ", kDensest, " kg/m3; write kg/m3, or use the suffix _g_cm3");
  }

  void check_ground_density(const Source& source, const std::string& key, double density, const std::string& what) {
    if (density <= kDensest && density >= kLightestGrain) return;
    findings_.warning(kImplausibleMass, source, key, "is ", density, " kg/m3, ",
                      density < kLightestGrain ? "lighter than any grains" : "denser than any solid", "; ", what,
                      ", or use the suffix _g_cm3");
  }

  void check_box(const BoxSpec& box) {
    check_ground_density(scene_.particles->source, "box.material.density", box.material.density,
                         "expected the density of a grain, not of the bed, in kg/m3");
    const double interval = box.every.value_or(0) * box_numbers(scene_).time_step;
    if (interval > scene_.end_time)
      findings_.error(
          kOutOfRange, scene_.particles->source, "box.exchange_steps", "is ", box.every.value_or(0),
          " steps of the grains, ", number_text(interval, 3), " s, longer than the scene, ",
          number_text(scene_.end_time, 3),
          " s: the mechanism would never meet the grains. Remove it: the interval is then chosen during the run");
  }

  void check_mass(const BodySpec& body) {
    if (!body.source.given("mass")) return;
    const double volume = body.shape ? volume_within(*body.shape) : 0.0;
    const std::string of_total = body.mass_is_remainder ? ", the remainder of total_mass," : "";
    if (volume == 0.0) {
      const double most = kDensest * std::pow(kFewPoints * size_, 3);
      if (most > 0.0 && body.mass > most)
        findings_.warning(kImplausibleMass, body.source, "mass", "is ", body.mass, " kg", of_total,
                          " in a mechanism of ", number_text(size_, 3),
                          " m; check the unit (_g, _t), and that lengths are in m");
      return;
    }
    const double density = body.mass / volume;
    if (density >= kLightest && density <= kOfItsSurface * kDensest) return;
    findings_.warning(
        kImplausibleMass, body.source, "mass", "is ", body.mass, " kg", of_total, " for a shape of ",
        number_text(volume, 3), " m3, which is ",
        density < kLightest ? "lighter than air" : "far denser than any solid", " (", number_text(density, 3),
        " kg/m3); check ",
        body.mass_is_remainder ? "total_mass and the masses of the other bodies" : "the units of mass (_g, _t)",
        " and shape (_mm)");
  }

  void check_inertia(const BodySpec& body, const std::vector<Vector3d>& points) {
    if (!body.source.given("inertia")) return;
    double reach = 0.0;  // [m]
    for (const Vector3d& point : points) reach = std::max(reach, (point - body.position).norm());
    const double limit = reach > 0.0 ? kFarOutside * reach : kFarFromPoints * size_;
    const double gyration = std::sqrt(0.5 * body.inertia.trace() / body.mass);
    if (limit == 0.0 && body.mass < kThinnestBody * 4.0 / 3.0 * kPi * std::pow(gyration, 3)) {
      findings_.warning(kImplausibleInertia, body.source, "inertia", "has a radius of gyration of ",
                        number_text(gyration, 3), " m for ", number_text(body.mass, 3),
                        " kg; write it in kg m2 (1 kg mm2 = 1e-6 kg m2)");
      return;
    }
    if (limit > 0.0 && gyration > limit)
      findings_.warning(kImplausibleInertia, body.source, "inertia", "has a radius of gyration of ",
                        number_text(gyration, 3), " m, but ",
                        reach > 0.0 ? "the body reaches no farther than " + number_text(reach, 3)
                                    : "the mechanism is not larger than " + number_text(size_, 3),
                        " m; write it in kg m2 (1 kg mm2 = 1e-6 kg m2)");
  }

  // A position that a motor or a prescribed rotation reaches: in whole numbers beyond a turn it is mostly meant in degrees.
  void check_turns(const Source& source, const std::string& key, const TimeFunctionSpec& f) {
    double largest = 0.0;  // [rad]
    bool whole = true;
    const auto take = [&](double value) {
      largest = std::max(largest, std::abs(value));
      whole = whole && value == std::round(value);
    };
    for (const Eigen::Vector2d& point : f.table) take(point.y());
    if (!f.polynomial.empty()) take(f.polynomial.front());
    const bool swings = std::abs(f.amplitude) > 2.0 * kPi;
    if (!swings && !(whole && largest > 2.0 * kPi)) return;
    const double value = swings ? f.amplitude : largest;
    findings_.warning(kAngleInDegrees, source, key, "reaches ", value, " rad, ", number_text(value / (2.0 * kPi), 3),
                      " turns; if degrees are meant, multiply them by pi / 180");
  }

  void check_angles() {
    const InitialSpec& initial = scene_.initial;
    for (const auto& [key, angle] : {std::pair("roll", initial.roll), {"pitch", initial.pitch}, {"yaw", initial.yaw}})
      if (std::abs(angle) > kPi * (1.0 + 1e-9) && std::abs(angle) <= 2.0 * kPi &&  // the reader warns of more
          initial.source.in_other_units.count(key) == 0)
        findings_.warning(kAngleInDegrees, initial.source, key, "is ", angle, " rad, ",
                          number_text(angle * 180.0 / kPi, 3),
                          " degrees: more than half a turn; if degrees are meant, write ", key, "_deg");
    for (const JointSpec& joint : scene_.joints)
      if (joint.motion && joint.motion->rotation && joint.source.in_other_units.count("motion.rotation.table") == 0 &&
          joint.motion->rotation->amplitude == 0.0)  // reported by the reader
        check_turns(joint.source, "motion.rotation", *joint.motion->rotation);
    for (const DriveSpec& drive : scene_.drives)
      if (drive.motor.kind == MotorKind::kPosition && drive.command && turns(drive))
        check_turns(drive.source, "command", *drive.command);
  }

  // Whether a drive moves an angle.
  bool turns(const DriveSpec& drive) const {
    const JointSpec* joint = scene_.joint(drive.joint);
    const Coordinate coordinate = drive.coordinate.value_or(coordinates_of(joint->type).front());
    return coordinate == Coordinate::kAngle;
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
      findings_.warning(kImplausibleSpeed, source, key, "moves bodies at ", number_text(speed, 3), " m/s",
                        size_ > 0.0 ? ", " + number_text(speed / size_, 3) + " times their size per second" : "",
                        ": faster than sound in them, about ", number_text(sound, 3), " m/s; ", remedy);
  }

  void check_speeds() {
    const std::string in_mm = "if it is in mm/s, write velocity_mm_s",
                      in_rpm = "for degrees or turns use the suffix _deg (per second) or _rpm";
    double slowest = HUGE_VAL;
    for (const BodySpec& body : scene_.bodies) slowest = std::min(slowest, sound_in(body));
    const InitialSpec& initial = scene_.initial;
    const double fall = initial.velocity.norm();
    check_speed(initial.source, "velocity", fall, slowest, in_mm);
    if (scene_.ground.kind != GroundKind::kNone && !scene_.boundaries.empty() && fall > kFastImpact && fall <= slowest)
      findings_.warning(kImplausibleSpeed, initial.source, "velocity", "is ", number_text(fall, 3), " m/s, ",
                        number_text(3.6 * fall, 3),
                        " km/h: laws of contact hold for some tens of m/s; if it is in mm/s, write velocity_mm_s");
    check_speed(initial.source, "angular_velocity", initial.angular_velocity.norm() * 0.5 * size_, slowest, in_rpm);
    for (const BodyVelocitySpec& own : initial.bodies) {
      const BodySpec* body = scene_.body(own.body);
      if (own.velocity) check_speed(own.source, "velocity", own.velocity->norm(), sound_in(*body), in_mm);
      double reach = 0.0;
      for (const Vector3d& point : outlines_[body - scene_.bodies.data()])
        reach = std::max(reach, (point - body->position).norm());
      if (own.angular_velocity)
        check_speed(own.source, "angular_velocity", own.angular_velocity->norm() * reach, sound_in(*body), in_rpm);
    }
    const std::string in_hz = "check that it is in m, and its frequency in Hz";
    for (const JointSpec& joint : scene_.joints) {
      if (!joint.motion) continue;
      for (const auto& [key, f] : {std::pair("x", &joint.motion->x), {"y", &joint.motion->y}, {"z", &joint.motion->z}})
        if (*f) check_speed(joint.source, std::string("motion.") + key, largest_rate(**f), slowest, in_hz);
      if (joint.motion->rotation)
        check_speed(joint.source, "motion.rotation", largest_rate(*joint.motion->rotation) * 0.5 * size_, slowest,
                    "check that it is in rad, and its frequency in Hz");
    }
    for (const DriveSpec& drive : scene_.drives) {
      if (!drive.command || (drive.motor.kind != MotorKind::kSpeed && drive.motor.kind != MotorKind::kPosition))
        continue;
      const double rate =
          drive.motor.kind == MotorKind::kSpeed ? largest_value(*drive.command) : largest_rate(*drive.command);
      check_speed(drive.source, "command", turns(drive) ? rate * 0.5 * size_ : rate, slowest,
                  turns(drive) ? "write it in rad/s (1000 rpm are 105 rad/s)" : "write it in m/s");
    }
  }

  // Of a function of time, without its signal [unit]
  double largest_value(const TimeFunctionSpec& f) const {
    double largest = 0.0, power = 1.0, sum = 0.0;
    for (const double c : f.polynomial) {
      sum += c * power;
      largest = std::max(largest, std::abs(sum));  // at the start, and at the end
      power *= scene_.end_time;
    }
    double of_table = 0.0;
    for (const Eigen::Vector2d& point : f.table) of_table = std::max(of_table, std::abs(point.y()));
    return largest + std::abs(f.amplitude) + of_table;
  }

  // Of its rate at the start, at the end and within its table [unit/s]
  double largest_rate(const TimeFunctionSpec& f) const {
    double at_end = 0.0, power = 1.0;
    for (std::size_t k = 1; k < f.polynomial.size(); ++k, power *= scene_.end_time)
      at_end += static_cast<double>(k) * f.polynomial[k] * power;
    const double at_start = f.polynomial.size() > 1 ? f.polynomial[1] : 0.0;
    double of_table = 0.0;
    for (std::size_t i = 1; i < f.table.size() && f.table[i - 1].x() < scene_.end_time; ++i)
      of_table =
          std::max(of_table, std::abs((f.table[i].y() - f.table[i - 1].y()) / (f.table[i].x() - f.table[i - 1].x())));
    return std::max(std::abs(at_start), std::abs(at_end)) + std::abs(f.amplitude) * 2.0 * kPi * f.frequency + of_table;
  }

  // Bodies that hang on springs alone: under their weight the springs yield by m g / k.
  void check_springs_that_carry() {
    if (size_ == 0.0) return;  // all in one point
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
      for (std::size_t i = 1; i + 1 < cable.path.size(); ++i) hold(cable.path[i].body);
    const auto hang = [&](const auto& entry, double stiffness, bool held, const char* key) {
      const std::size_t ends[2] = {parts.of(scene_.body_index(entry.bodies[0])),
                                   parts.of(scene_.body_index(entry.bodies[1]))};
      if (ends[0] == ends[1] && !held) return;
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
    for (const CableSpec& cable : scene_.cables) {
      struct {
        const Source& source;
        std::array<std::string, 2> bodies;
      } const between{cable.source, {cable.path.front().body, cable.path.back().body}};
      double length = 0.0;
      for (std::size_t i = 1; i < cable.path.size(); ++i)
        length += (cable.path[i].point - cable.path[i - 1].point).norm();
      hang(between, cable.stiffness.value_or(cable.EA.value_or(0.0) / std::max(length, 1e-9)),
           cable.tension.value_or(0.0) > 0.0, cable.stiffness ? "stiffness" : "EA");
    }
    for (const Hung& part : hung) {
      if (part.held || part.source == nullptr || !(part.mass * g > size_ * part.stiffness)) continue;
      findings_.warning(kSoftSpring, *part.source, part.key, "is so small that ", number_text(part.mass, 3), " kg on ",
                        part.stiffest < part.stiffness ? "such springs sink" : "the spring sinks", " by ",
                        number_text(part.mass * g / part.stiffness, 3), " m, in a mechanism of ", number_text(size_, 3),
                        " m; write it in ", part.key == std::string("EA") ? "N" : "N/m, or use the suffix _N_mm");
    }
  }

  // A part that slides along gravity on one prismatic or cylindrical joint, carried by springs alone: they yield by m g / k.
  void check_sliders() {
    if (scene_.gravity.norm() == 0.0 || size_ == 0.0) return;
    for (const JointSpec& joint : scene_.joints) {
      if (joint.type != JointType::kPrismatic && joint.type != JointType::kCylindrical) continue;
      const Vector3d along = joint.axis.normalized();
      const double pull = std::abs(along.dot(scene_.gravity));  // [m/s2]
      if (pull < 0.1 * scene_.gravity.norm()) continue;
      const std::vector<bool> slides = part_beyond(joint);
      if (slides.empty()) continue;
      const auto moves = [&](const std::string& body) {
        const int i = scene_.body_index(body);
        return i >= 0 && slides[i];
      };
      bool held = joint.displacement && joint.displacement->stops;
      double mass = 0.0, stiffness = 0.0, stiffest = 0.0;  // [kg], [N/m]
      for (std::size_t i = 0; i < slides.size(); ++i) mass += slides[i] ? scene_.bodies[i].mass : 0.0;
      const Source* source = nullptr;
      std::string key;
      const auto carry = [&](double k, const Source& of, const std::string& named) {
        stiffness += k;
        if (k <= stiffest) return;
        stiffest = k;
        source = &of;
        key = named;
      };
      if (joint.displacement && joint.displacement->spring)
        carry(joint.displacement->spring->stiffness, joint.source, "displacement.spring.stiffness");
      const auto crosses = [&](const std::array<std::string, 2>& bodies) {
        return moves(bodies[0]) != moves(bodies[1]);
      };
      for (const StrutSpec& strut : scene_.struts) {
        if (!crosses(strut.bodies)) continue;
        held = held || strut.gas || strut.honeycomb || strut.stops || strut.table || !strut.spring ||
               strut.spring->preload != 0.0;
        const double cosine = (strut.points[1] - strut.points[0]).normalized().dot(along);
        if (strut.spring) carry(strut.spring->stiffness * cosine * cosine, strut.source, "spring.stiffness");
      }
      for (const SpringSpec& spring : scene_.springs)
        if (crosses(spring.bodies) && spring.kind == SpringKind::kBushing)
          carry(spring.stiffness.maxCoeff(), spring.source, "stiffness");
      for (const DriveSpec& drive : scene_.drives) held = held || drive.joint == joint.name;
      for (const GearSpec& gear : scene_.gears)
        held = held || std::count(gear.joints.begin(), gear.joints.end(), joint.name) > 0;
      for (const ForceSpec& force : scene_.forces) held = held || moves(force.body);
      for (const CableSpec& cable : scene_.cables)
        for (const CableGuideSpec& guide : cable.path) held = held || moves(guide.body);
      if (scene_.ground.kind != GroundKind::kNone || !scene_.contacts.empty())
        for (const BoundarySpec& boundary : scene_.boundaries) held = held || moves(boundary.body);
      if (held || source == nullptr || !(mass * pull > size_ * stiffness)) continue;
      findings_.warning(kSoftSpring, *source, key, "is so small that ", number_text(mass, 3), " kg on joint \"",
                        joint.name, "\" sink by ", number_text(mass * pull / stiffness, 3), " m, in a mechanism of ",
                        number_text(size_, 3), " m; write it in N/m, or use the suffix _N_mm");
    }
  }

  // The bodies that one joint alone connects to the ground; empty: they are on both of its sides.
  std::vector<bool> part_beyond(const JointSpec& joint) {
    if (neighbours_.empty()) {
      neighbours_.resize(scene_.bodies.size() + 1);
      for (const JointSpec& other : scene_.joints) {
        const int a = scene_.body_index(other.bodies[0]) + 1, b = scene_.body_index(other.bodies[1]) + 1;
        neighbours_[a].push_back({b, &other});
        neighbours_[b].push_back({a, &other});
      }
    }
    std::vector<bool> rests(scene_.bodies.size() + 1, false);
    std::vector<int> next = {0};
    rests[0] = true;
    while (!next.empty()) {
      const int from = next.back();
      next.pop_back();
      for (const auto& [to, by] : neighbours_[from]) {
        if (by == &joint || rests[to]) continue;
        rests[to] = true;
        next.push_back(to);
      }
    }
    const std::size_t a = static_cast<std::size_t>(scene_.body_index(joint.bodies[0]) + 1),
                      b = static_cast<std::size_t>(scene_.body_index(joint.bodies[1]) + 1);
    if (rests[a] == rests[b]) return {};
    std::vector<bool> slides(scene_.bodies.size(), false);
    next = {static_cast<int>(rests[a] ? b : a)};
    while (!next.empty()) {
      const int from = next.back();
      next.pop_back();
      if (slides[from - 1]) continue;
      slides[from - 1] = true;
      for (const auto& [to, by] : neighbours_[from])
        if (by != &joint) next.push_back(to);
    }
    return slides;
  }

  // On a hundred places m g = 100 k delta^1.5.
  void check_plane() {
    if (scene_.ground.kind != GroundKind::kPlane || !scene_.ground.plane) return;
    const PlaneSpec& plane = *scene_.ground.plane;
    const double mass = total_mass(scene_);
    const double k = plane.stiffness.value_or(4.0 / 3.0 * plane.young.value_or(0.0) /
                                              (1.0 - plane.poisson * plane.poisson) * std::sqrt(plane.contact_radius));
    const double sunk = k > 0.0 ? std::pow(mass * scene_.gravity.norm() / (kPlaces * k), 2.0 / 3.0) : 0.0;
    if (sunk > kSunk * size_ && size_ > 0.0)
      findings_.warning(kSoftSpring, scene_.ground.source, plane.stiffness ? "plane.stiffness" : "plane.young",
                        "is so small that ", number_text(mass, 3), " kg at rest sink by ", number_text(sunk, 3),
                        " m into the plane, in a mechanism of ", number_text(size_, 3), " m; write ",
                        plane.stiffness ? "it in N/m^1.5" : "it in Pa, or use the suffix _MPa");
  }

  // Degrees of longitude and latitude, or kilometres, taken for metres.
  void check_map() {
    constexpr double kSteepMap = 2.0;  // mean slope, of 63 degrees
    const std::string kProject =
        "; if its coordinates are degrees, project them to metres (gdalwarp -t_srs), if they "
        "are kilometres, scale them";
    if (!scene_.ground.terrain || !scene_.ground.terrain->map || !scene_.ground.terrain->map->grid) return;
    const HeightGrid& grid = *scene_.ground.terrain->map->grid;
    const double x = grid.step.x() * (grid.columns - 1), y = grid.step.y() * (grid.rows - 1);
    if (std::max(x, y) < size_) {
      findings_.warning(kImplausibleNumber, scene_.ground.source, "terrain.map.file", "covers ", number_text(x, 3),
                        " by ", number_text(y, 3), " m, less than the ", number_text(size_, 3), " m of the mechanism",
                        kProject);
      return;
    }
    // Of some rows, since a large map is read where bodies come.
    constexpr int kRows = 40;
    double rise = 0.0;
    int count = 0;
    std::vector<double> row(grid.columns);
    for (int k = 0; k < kRows; ++k) {
      if (k > 0 && k * (grid.rows - 1) / (kRows - 1) == (k - 1) * (grid.rows - 1) / (kRows - 1)) continue;
      grid.read(0, k * (grid.rows - 1) / (kRows - 1), grid.columns, row.data());
      for (std::size_t i = 1; i < row.size(); ++i) rise += std::abs(row[i] - row[i - 1]);
      count += grid.columns - 1;
    }
    const double slope = rise / (count * grid.step.x());
    if (slope > kSteepMap)
      findings_.warning(kImplausibleNumber, scene_.ground.source, "terrain.map.file", "rises or falls by ",
                        number_text(slope, 2), " m on each metre along x, in the mean of its samples", kProject);
  }

  void check_ratio(const Source& source, const std::string& key, double value, double most, const std::string& remedy) {
    if (value >= most) findings_.warning(kImplausibleNumber, source, key, "is ", value, ", ", remedy);
  }

  void check_ratios() {
    const std::string friction =
        "more than any material has; it is the tangent of an angle (0.36 for 20 degrees), not the "
        "angle, and no percentage";
    if (scene_.ground.plane)
      check_ratio(scene_.ground.source, "plane.friction", scene_.ground.plane->friction, kRoughest, friction);
    if (scene_.ground.law)
      check_ratio(scene_.ground.source, "law.friction", scene_.ground.law->friction, kRoughest, friction);
    for (const ContactSpec& contact : scene_.contacts)
      check_ratio(contact.source, "friction", contact.friction, kRoughest, friction);
    if (scene_.particles && scene_.particles->box) {
      const BoxSpec& box = *scene_.particles->box;
      for (const auto& [key, value] : {std::pair("box.material.friction", box.material.friction),
                                       {"box.material.rolling_friction", box.material.rolling_friction},
                                       {"box.bodies.friction", box.bodies.friction.value_or(0.0)},
                                       {"box.bodies.rolling_friction", box.bodies.rolling_friction.value_or(0.0)}})
        check_ratio(scene_.particles->source, key, value, kRoughest, friction);
    }
    for (const BodySpec& body : scene_.bodies)
      if (body.flexible && body.flexible->enabled)
        check_ratio(body.source, "flexible.damping", body.flexible->damping, 1.0,
                    "at which no mode vibrates; it is a ratio: 2 per cent are 0.02");
  }

  void check_gas() {
    for (const StrutSpec& strut : scene_.struts) {
      if (!strut.gas) continue;
      const double pressure = strut.gas->initial_pressure;
      if (pressure < kLeastPressure || pressure > kMostPressure)
        findings_.warning(kImplausibleNumber, strut.source, "gas.pressure", "is ", pressure, " Pa, ",
                          number_text(pressure / 1e5, 3),
                          " bar; write it in Pa, or use the suffix _kPa or _MPa (1 bar = 100 kPa)");
      if (size_ > 0.0 && strut.gas->piston_diameter > size_)
        findings_.warning(kImplausibleNumber, strut.source, "gas.piston_diameter", "is ", strut.gas->piston_diameter,
                          " m in a mechanism of ", number_text(size_, 3), " m; write it in m, or use the suffix _mm");
    }
    for (const BodySpec& body : scene_.bodies)
      if (body.shape && body.shape->kind == ShapeKind::kDisc && body.shape->thickness > 2.0 * body.shape->radius)
        findings_.warning(kImplausibleNumber, body.source, "shape.thickness", "is ", body.shape->thickness,
                          " m for a disc of radius ", body.shape->radius,
                          " m; write it in m, or use the suffix _mm; a long one is a \"cylinder\"");
  }

  // The softest stage is crushed by a hundredth of the weight.
  void check_honeycombs() {
    const double weight = total_mass(scene_) * scene_.gravity.norm();
    for (const StrutSpec& strut : scene_.struts) {
      if (!strut.honeycomb || strut.honeycomb->stages.empty()) continue;
      const double force = strut.honeycomb->stages.front().crush_force;
      if (force < kWeakestCrush * weight)
        findings_.warning(kImplausibleNumber, strut.source, "honeycomb.stages", "begins to crush at ", force, " N, ",
                          share_text(force / weight), " of the weight of the mechanism, ", number_text(weight, 3),
                          " N: it bears nothing; write force in N");
    }
  }

  // A bound in m that no body of this mechanism can come near.
  void check_requirement_lengths() {
    if (scene_.ground.kind == GroundKind::kNone || size_ == 0.0) return;
    const double t = scene_.end_time;
    const double reach =
        kFarRequirement * size_ + scene_.initial.velocity.norm() * t + 0.5 * scene_.gravity.norm() * t * t;
    for (const RequirementSpec& r : scene_.requirements) {
      const bool metres = r.unit.empty() && r.value.size() > 2 && r.value.substr(r.value.size() - 2) == "_m";
      for (const auto& [key, bound] : {std::pair("least", r.least), {"most", r.most}})
        if ((r.unit == "m" || metres) && bound && std::abs(*bound) > reach)
          findings_.warning(kImplausibleNumber, r.source, key, "is ", *bound, " m, in a mechanism of ",
                            number_text(size_, 3), " m: nothing comes near it; write it in m (1 mm = 0.001 m)");
    }
  }

  // A point of a body that is hundreds of times farther from it than the body reaches.
  void check_point(const Source& source, const std::string& key, const std::string& name, const Vector3d& point) {
    const int i = scene_.body_index(name);
    if (i < 0) return;
    const BodySpec& body = scene_.bodies[i];
    double reach = 0.0;
    for (const Vector3d& p : outlines_[i]) reach = std::max(reach, (p - body.position).norm());
    const double distance = (point - body.position).norm();
    if (reach > 0.0 && distance > kFarAway * reach)
      findings_.warning(kImplausibleNumber, source, key, "is ", number_text(distance, 3),
                        " m from the mass centre of body \"", name, "\", which reaches no farther than ",
                        number_text(reach, 3), " m; write points in m, or use the suffix _mm");
  }

  void check_points() {
    for (const JointSpec& joint : scene_.joints) {
      check_point(joint.source, joint.source.given("point") ? "point" : "point_a", joint.bodies[0], joint.point_a);
      check_point(joint.source, joint.source.given("point") ? "point" : "point_b", joint.bodies[1], joint.point_b);
    }
    for (const StrutSpec& strut : scene_.struts)
      for (std::size_t k = 0; k < 2; ++k) check_point(strut.source, "points", strut.bodies[k], strut.points[k]);
    for (const ForceSpec& force : scene_.forces)
      if (force.point) check_point(force.source, "point", force.body, *force.point);
  }

  // Nothing moves bodies relative to each other before the start.
  bool starts_as_drawn() const {
    const InitialSpec& initial = scene_.initial;
    return initial.joints.empty() && !initial.settle && initial.from.empty();
  }

  // A prescribed displacement begins where the points are drawn.
  void check_motion_starts() {
    const InitialSpec& initial = scene_.initial;
    const bool moved = !initial.position.isZero(0.0) || initial.roll != 0.0 || initial.pitch != 0.0 ||
                       initial.yaw != 0.0 || initial.clearance || initial.groups;
    for (const JointSpec& joint : scene_.joints) {
      if (!joint.motion || moved) continue;
      const Vector3d z = joint.axis.normalized(), x = (joint.axis2 - joint.axis2.dot(z) * z).normalized();
      const std::tuple<const char*, const std::optional<TimeFunctionSpec>&, Vector3d> ways[] = {
          {"motion.x", joint.motion->x, x},
          {"motion.y", joint.motion->y, z.cross(x)},
          {"motion.z", joint.motion->z, z}};
      for (const auto& [key, f, along] : ways) {
        if (!f || (!f->table.empty() && f->table.front().x() > 0.0)) continue;
        double begins = f->amplitude * std::sin(f->phase) + (f->polynomial.empty() ? 0.0 : f->polynomial.front());
        for (const Eigen::Vector2d& row : f->table)
          if (row.x() == 0.0) begins += row.y();
        const double drawn = along.dot(joint.point_b - joint.point_a);
        if (!(std::abs(begins - drawn) > kOpenMotion)) continue;
        findings_.error(kMotionStart, joint.source, key, "begins at ", begins, " m, but the bodies are drawn at ",
                        drawn, " m; draw them as they start, or count the motion from the drawing");
      }
    }
  }

  void check_stops() {
    const auto check = [&](const Source& source, const std::string& key, const EndStopParameters& stops, double at,
                           const std::string& unit) {
      const bool below = stops.smallest_stroke && at < *stops.smallest_stroke - 1e-9;
      if (!below && !(stops.largest_stroke && at > *stops.largest_stroke + 1e-9)) return;
      findings_.warning(kStartBeyondStop, source, key + (below ? "min" : "max"), "is ",
                        below ? *stops.smallest_stroke : *stops.largest_stroke, unit, ", but the drawing starts at ",
                        at, unit,
                        ", beyond this stop, which throws it back at once; start it within its stops "
                        "([initial.joints]), or move the stop");
    };
    for (const JointSpec& joint : scene_.joints)
      for (const Coordinate coordinate : coordinates_of(joint.type))
        if (const std::optional<CoordinateSpec>& c = joint.acting_on(coordinate); c && c->stops)
          check(joint.source, concat(name_of(coordinate), ".stops."), *c->stops, 0.0,
                coordinate == Coordinate::kAngle ? " rad" : " m");
    for (const StrutSpec& strut : scene_.struts)
      if (strut.stops && strut.length)
        check(strut.source, "stops.", *strut.stops, *strut.length - (strut.points[1] - strut.points[0]).norm(), " m");
      else if (strut.stops)
        check(strut.source, "stops.", *strut.stops, 0.0, " m");
  }

  // Sampled at the start alone.
  void check_periods() {
    const auto check = [&](const Source& source, double period) {
      if (period > scene_.end_time)
        findings_.warning(kImplausibleNumber, source, "period", "is ", period, " s, longer than the scene, ",
                          scene_.end_time,
                          " s: it is computed at the start alone; use the suffix _ms for milliseconds");
      if (period > 0.0 && scene_.end_time / period > kLongRun)
        findings_.warning(kImplausibleNumber, source, "period", "is ", period, " s: the run takes at least ",
                          number_text(scene_.end_time / period, 2), " steps until end_time, one for each sample, ",
                          "and may take hours; give a longer period if it need not be so short");
    };
    for (const ControllerSpec& controller : scene_.controllers) check(controller.source, controller.period);
    for (const SignalSpec& signal : scene_.signals) check(signal.source, signal.period);
    for (const EventSpec& event : scene_.events) check(event.source, event.period);
    for_each_function(scene_, [&](const Source& source, const std::string& key, const TimeFunctionSpec& f) {
      const double steps = f.amplitude != 0.0 ? kStepsOfPeriod * f.frequency * scene_.end_time : 0.0;
      if (steps > kLongRun)
        findings_.warning(kImplausibleNumber, source, key + ".frequency", "is ", f.frequency,
                          " Hz: the run takes about ", number_text(steps, 2), " steps until end_time, ", kStepsOfPeriod,
                          " for each period, and may ", "take hours; check that it is in Hz");
    });
  }

  // A body whose outline is inside a second body to which nothing connects it.
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
        findings_.warning(kBodyInside, scene_.bodies[j].source, "name", "body \"", scene_.bodies[j].name,
                          "\" is inside of body \"", around.name, "\" (line ", around.source.line,
                          "), and nothing connects the two; move one of them, or add a joint");
      }
    }
  }

  const Scene& scene_;
  Findings& findings_;
  std::vector<std::vector<Vector3d>> outlines_;  // of each body
  Eigen::AlignedBox3d box_;                      // around all points
  std::vector<std::vector<std::pair<int, const JointSpec*>>>
      neighbours_;     // by joints, of the ground (0) and each body + 1
  double size_ = 0.0;  // its diagonal [m]
};

}  // namespace

void check_plausible(const Scene& scene, Findings& findings) { Plausibility(scene, findings).check(); }

}  // namespace footfall

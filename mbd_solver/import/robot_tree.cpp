// Makes bodies of links: links without mass join a neighbour or get a small mass, inertias become possible for real
// bodies, names become names of a scene. Inertias about a joint, for the stiffness of its stops.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cctype>
#include <list>
#include <map>
#include <set>

#include "coupler/base/concat.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/import/codes.h"
#include "mbd_solver/import/robot.h"

namespace footfall {
namespace {

// Mass of a body between two joints that has none in the file, over the mass beyond it: below the tolerances of a run.
constexpr double kSmallMass = 1e-7;
// A link whose inertia is zero: radius of gyration [m].
constexpr double kPointRadius = 1e-3;
constexpr double kNoRadius = 1e-6;  // below this it is zero [m]

Eigen::Matrix3d steiner(double mass, const Eigen::Vector3d& d) {
  return mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
}

// Adds mass, centre and inertia of `from`, at rest relative to `into`, to `into`.
void add_mass(RobotLink& into, const RobotLink& from) {
  if (!(from.mass > 0.0)) return;
  const RigidFrame X = into.X_DL.inverse() * from.X_DL;
  const Eigen::Vector3d centre = X * from.centre;
  const Eigen::Matrix3d inertia = X.R * from.inertia * X.R.transpose();
  if (!(into.mass > 0.0)) {
    into.mass = from.mass;
    into.centre = centre;
    into.inertia = inertia;
    return;
  }
  const double mass = into.mass + from.mass;
  const Eigen::Vector3d common = (into.mass * into.centre + from.mass * centre) / mass;
  into.inertia += steiner(into.mass, into.centre - common) + inertia + steiner(from.mass, centre - common);
  into.mass = mass;
  into.centre = common;
}

// Links and joints keep their numbers until renumber(): a link that joins another one is marked, and so is a joint that goes. Each step
// touches its neighbours only, so that a chain of any length takes time in proportion.
class Tidy {
 public:
  Tidy(Robot& robot, const ImportOptions& options) : robot_(robot), options_(options) {}

  void carry_out() {
    dropped_.assign(robot_.joints.size(), false);
    for (std::size_t k = 0; k < robot_.joints.size(); ++k) hold_without_range(static_cast<int>(k));
    if (options_.fix_base) fix_base();
    dropped_.resize(robot_.joints.size(), false);
    gone_.assign(robot_.joints.size(), false);
    joints_of_.resize(robot_.links.size());
    for (std::size_t k = 0; k < robot_.joints.size(); ++k)
      for (const int end : {robot_.joints[k].parent, robot_.joints[k].child})
        if (end >= 0) joints_of_[end].insert(static_cast<int>(k));
    for (std::size_t k = 0; k < robot_.links.size(); ++k) {
      into_.push_back(static_cast<int>(k));
      parts_.push_back({static_cast<int>(k)});
      const std::string& remark = robot_.links[k].remark;
      remarks_.push_back(remark.empty() ? std::list<std::string>() : std::list<std::string>{remark});
    }
    // From the last one: links without anything below first, so that remarks follow the tree. No join makes a later one due.
    for (std::size_t k = robot_.joints.size(); k-- > 0;)
      if (is_to_join(static_cast<int>(k))) join(static_cast<int>(k));
    join_massless();
    renumber();
    give_small_masses();
    for (RobotLink& link : robot_.links) mend_inertia(link);
  }

 private:
  static constexpr int kGround = -1;

  RobotLink& link(int index) { return robot_.links[index]; }
  RobotJoint& joint(int index) { return robot_.joints[index]; }
  bool is_empty(int index) { return !(link(index).mass > 0.0); }

  // The link that this one has become part of.
  int body(int index) {
    int whole = index;
    while (whole >= 0 && into_[whole] != whole) whole = into_[whole];
    while (index != whole) {
      const int next = into_[index];
      into_[index] = whole;
      index = next;
    }
    return whole;
  }

  // Limits that leave no room.
  void hold_without_range(int index) {
    RobotJoint& joint = robot_.joints[index];
    if (joint.coordinates.size() != 1) return;
    const RobotCoordinate& q = joint.coordinates[0];
    if (!q.lower || !q.upper || *q.upper - *q.lower > 1e-9) return;
    robot_.leave_out(joint.origin, "joint \"" + joint.name + "\"",
                     concat("its limits are both ", *q.lower, ": it is held where it is drawn"));
    joint.kind = RobotJointKind::kFixed;
    drop_uses(index);
  }

  // The first root.
  void fix_base() {
    std::vector<bool> below(robot_.links.size(), false);
    for (const RobotJoint& joint : robot_.joints)
      if (!joint.loop && joint.child >= 0) below[joint.child] = true;
    const auto root = std::find(below.begin(), below.end(), false);
    if (root == below.end()) return;
    RobotJoint mount;
    mount.child = static_cast<int>(root - below.begin());
    mount.origin = link(mount.child).origin;
    mount.name = link(mount.child).name + "_mount";
    mount.point = link(mount.child).X_DL.p;
    mount.remark = "of --fix-base";
    robot_.joints.push_back(mount);
  }

  // A fixed joint whose links become one: because one of them has no mass, or by --merge-fixed.
  bool is_to_join(int index) {
    const RobotJoint& of = joint(index);
    const int parent = body(of.parent), child = body(of.child);
    if (gone_[index] || of.kind != RobotJointKind::kFixed || of.loop || child < 0) return false;
    if (parent < 0) return is_empty(child);  // a body on the ground stays
    return options_.merge_fixed || is_empty(child) || is_empty(parent);
  }

  void join(int index) {
    const int parent = body(joint(index).parent), child = body(joint(index).child);
    const bool up = parent < 0 || is_empty(child) || !is_empty(parent);
    const int from = up ? child : parent, into = up ? parent : child;
    remove_joint(index);
    if (into < 0) return stand_on_ground(from);
    add_mass(link(into), link(from));
    parts_[into].splice(parts_[into].end(), parts_[from]);
    std::list<std::string>&remark = remarks_[into], &other_remark = remarks_[from];
    remark.push_back((remark.empty() ? "with \"" : "; with \"") + link(from).name + "\"");
    if (!other_remark.empty()) {
      remark.push_back(" (");
      remark.splice(remark.end(), other_remark);
      remark.push_back(")");
    }
    if (!link(into).friction) link(into).friction = link(from).friction;
    into_[from] = into;
    std::set<int>&joints = joints_of_[into], &others = joints_of_[from];
    if (joints.size() < others.size()) joints.swap(others);
    std::vector<int> within;
    for (const int other : others)
      if (!joints.insert(other).second) within.push_back(other);
    for (const int other : within) remove_within(other);
  }

  // A link without mass becomes the ground.
  void stand_on_ground(int index) {
    if (std::any_of(parts_[index].begin(), parts_[index].end(),
                    [&](int part) { return !link(part).collisions.empty(); }))
      robot_.leave_out(link(index).origin, "link \"" + link(index).name + "\": its surface",
                       "it is fixed to the ground without mass; a scene has bodies with mass only");
    into_[index] = kGround;
    const std::set<int> joints = joints_of_[index];
    for (const int other : joints)
      if (body(joint(other).parent) == body(joint(other).child)) remove_within(other);
  }

  void remove_within(int index) {
    robot_.leave_out(joint(index).origin, "joint \"" + joint(index).name + "\"", "both of its links are one body");
    remove_joint(index);
  }

  void remove_joint(int index) {
    drop_uses(index);
    gone_[index] = true;
    for (const int end : {body(joint(index).parent), body(joint(index).child)})
      if (end >= 0) joints_of_[end].erase(index);
  }

  // The joint has no coordinates any more; gears and drives of it go.
  void drop_uses(int index) {
    joint(index).coordinates.clear();
    dropped_[index] = true;
  }

  // Links without mass that only moving joints hold: roots are the ground, leaves are held.
  void join_massless() {
    std::set<int> open;
    for (std::size_t k = 0; k < robot_.links.size(); ++k) open.insert(static_cast<int>(k));
    while (!open.empty()) {
      const int index = *open.begin();
      open.erase(open.begin());
      if (body(index) != index || !is_empty(index)) continue;
      const std::set<int>& joints = joints_of_[index];
      const bool root =
          std::none_of(joints.begin(), joints.end(), [&](int j) { return body(joint(j).child) == index; });
      const bool leaf =
          std::none_of(joints.begin(), joints.end(), [&](int j) { return body(joint(j).parent) == index; });
      if (!root && !leaf) continue;
      for (const int j : joints)  // their ends have other joints after this
        for (const int end : {body(joint(j).parent), body(joint(j).child)})
          if (end >= 0 && end != index) open.insert(end);
      if (joints.empty()) {
        robot_.leave_out(link(index).origin, "link \"" + link(index).name + "\"", "it has no mass");
        into_[index] = kGround;
      } else if (root) {
        robot_.leave_out(link(index).origin, "link \"" + link(index).name + "\" without mass",
                         "no joint holds it and it has no mass: it is the ground");
        stand_on_ground(index);
      } else {
        const int first = *joints.begin();
        robot_.leave_out(joint(first).origin, "joint \"" + joint(first).name + "\"",
                         "its link \"" + link(index).name + "\" has no mass and cannot move by itself: it is held");
        joint(first).kind = RobotJointKind::kFixed;
        while (joints.size() > 1) remove_joint(*joints.rbegin());
        join(first);
      }
    }
  }

  // The remaining links and joints, and references to them.
  void renumber() {
    std::vector<RobotLink> links;
    std::vector<int> link_places(robot_.links.size(), kGround);
    for (std::size_t k = 0; k < robot_.links.size(); ++k) {
      if (into_[k] != static_cast<int>(k)) continue;
      RobotLink& whole = robot_.links[k];
      for (const int part : parts_[k]) {
        if (part == static_cast<int>(k)) continue;
        const RigidFrame X = whole.X_DL.inverse() * link(part).X_DL;
        for (auto list : {&RobotLink::collisions, &RobotLink::visuals})
          for (RobotGeometry& geometry : link(part).*list) {
            geometry.X_LG = X * geometry.X_LG;
            (whole.*list).push_back(std::move(geometry));
          }
      }
      whole.remark.clear();
      for (const std::string& piece : remarks_[k]) whole.remark += piece;
      link_places[k] = static_cast<int>(links.size());
      links.push_back(std::move(whole));
    }
    const auto place_of_link = [&](int old) {
      const int whole = body(old);
      return whole < 0 ? kGround : link_places[whole];
    };
    std::vector<RobotJoint> joints;
    std::vector<int> joint_places(robot_.joints.size(), -1);
    for (std::size_t k = 0; k < robot_.joints.size(); ++k) {
      if (gone_[k]) continue;
      joint_places[k] = static_cast<int>(joints.size());
      joints.push_back(std::move(robot_.joints[k]));
      joints.back().parent = place_of_link(joints.back().parent);
      joints.back().child = place_of_link(joints.back().child);
    }
    robot_.links = std::move(links);
    robot_.joints = std::move(joints);
    auto& gears = robot_.gears;
    const auto is_dropped = [&](int joint) { return dropped_[joint]; };
    gears.erase(std::remove_if(gears.begin(), gears.end(),
                               [&](const RobotGear& gear) {
                                 return std::any_of(gear.joints.begin(), gear.joints.end(), is_dropped);
                               }),
                gears.end());
    for (RobotGear& gear : gears)
      for (int& number : gear.joints) number = joint_places[number];
    auto& drives = robot_.drives;
    drives.erase(std::remove_if(drives.begin(), drives.end(), [&](const RobotDrive& d) { return is_dropped(d.joint); }),
                 drives.end());
    for (RobotDrive& drive : drives) drive.joint = joint_places[drive.joint];
    auto& apart = robot_.apart;
    for (auto& [first, second] : apart) {
      first = place_of_link(first);
      second = place_of_link(second);
    }
    apart.erase(std::remove_if(apart.begin(), apart.end(), [](const auto& p) { return p.first < 0 || p.second < 0; }),
                apart.end());
  }

  void give_small_masses() {
    const MovedInertias moved(robot_);
    std::vector<double> mass(robot_.links.size(), 0.0), inertia(robot_.links.size(), 0.0);  // that each link carries
    for (const RobotJoint& joint : robot_.joints) {
      if (joint.parent < 0 || joint.child < 0 || joint.loop) continue;
      mass[joint.parent] += moved.beyond(joint, true);
      inertia[joint.parent] += moved.beyond(joint, false);
    }
    for (std::size_t k = 0; k < robot_.links.size(); ++k)
      if (!(robot_.links[k].mass > 0.0)) give_small_mass(robot_.links[k], mass[k], inertia[k]);
  }

  void give_small_mass(RobotLink& made, double mass, double inertia) {
    if (!(mass > 0.0))
      throw InputError(code::kRobotMass, made.origin.place() + ": link \"" + made.name +
                                             "\" has no mass, nor has what it carries; give it an inertia");
    made.mass = kSmallMass * mass;
    const double least = made.mass * 1e-4;
    made.inertia = Eigen::Matrix3d::Identity() * std::max(kSmallMass * inertia, least);
    robot_.leave_out(
        made.origin, "link \"" + made.name + "\" without mass",
        "between moving joints a body needs one: it has " + number_text(made.mass, 3) + " kg, 1e-7 of what it carries");
  }

  // Principal moments above zero, none above the sum of the other two.
  void mend_inertia(RobotLink& of) {
    const std::string name = "link \"" + of.name + "\": its inertia";
    if (of.inertia.norm() < kNoRadius * kNoRadius * of.mass) {
      of.inertia = of.mass * kPointRadius * kPointRadius * Eigen::Matrix3d::Identity();
      robot_.leave_out(of.origin, name, "is zero; the scene has the inertia of a ball with 1 mm radius of gyration");
      return;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(of.inertia);
    Eigen::Vector3d e = solver.eigenvalues();
    if (!(e[2] > 0.0) || e[0] < -1e-3 * e[2])
      throw InputError(code::kRobotMass, of.origin.place(), ": ", name, " has the principal moments ", e[0], ", ", e[1],
                       ", ", e[2], " kg m2, expected all above zero; correct ixx ... izz");
    const Eigen::Vector3d given = e;
    e = e.cwiseMax(1e-9 * e[2]);
    const double lack = e[2] - e[0] - e[1];
    if (lack > 0.0) e += Eigen::Vector3d(0.5 * lack, 0.5 * lack, 0.0);
    if (lack > 1e-9 * e[2] || given[0] < 1e-9 * given[2]) {
      const double margin = 1.0 + 1e-12;
      e[0] *= margin;
      e[1] *= margin;
      of.inertia = solver.eigenvectors() * e.asDiagonal() * solver.eigenvectors().transpose();
      of.inertia = (0.5 * (of.inertia + of.inertia.transpose())).eval();
      robot_.leave_out(of.origin, name,
                       concat("no body has the principal moments ", given[0], ", ", given[1], ", ", given[2],
                              " kg m2 (one above the sum of the others): they are ", e[0], ", ", e[1], ", ", e[2]));
    }
  }

  Robot& robot_;
  const ImportOptions& options_;
  std::vector<int> into_;                        // of a link: itself, the link that it has joined, or kGround
  std::vector<std::list<int>> parts_;            // links that a link consists of
  std::vector<std::list<std::string>> remarks_;  // pieces of the remark of a link
  std::vector<std::set<int>> joints_of_;         // at either end of a link
  std::vector<bool> gone_, dropped_;             // joints; those whose gears and drives go
};

// used: names, with the last number that was put behind each.
std::string plain_name(const std::string& name, const std::string& otherwise, std::map<std::string, int>& used) {
  std::string plain;
  for (const char c : name.substr(0, kLongestName - 8))
    plain += std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128 ? c : '_';
  if (plain.find_first_not_of('_') == std::string::npos) plain = otherwise;
  if (std::isdigit(static_cast<unsigned char>(plain[0])) != 0) plain = otherwise + "_" + plain;
  std::string result = plain;
  for (int& k = used.try_emplace(" " + plain, 1).first->second;  // no name has a blank
       result == "ground" || result == "plane" || result == "world" || !used.try_emplace(result, 1).second;)
    result = concat(plain, "_", ++k);
  return result;
}

void give_plain_names(Robot& robot) {
  std::map<std::string, int> used;
  const auto give = [&](auto& entries, const std::string& otherwise) {
    for (auto& entry : entries) {
      entry.label = entry.name;
      entry.name = plain_name(entry.label, otherwise, used);
    }
  };
  // Columns of the history are named after all of them: names of bodies, joints, drives and gears differ.
  give(robot.links, "link");
  give(robot.joints, "joint");
  give(robot.drives, "motor");
  give(robot.gears, "gear");
}

}  // namespace

void add_solid(RobotLink& link, const RobotGeometry& g, double density) {
  const Eigen::Vector3d half(0.0, 0.0, 0.5 * g.length);
  MassProperties solid;
  switch (g.kind) {
    case GeometryKind::kBox: solid = box_properties(g.size, density); break;
    case GeometryKind::kSphere: solid = sphere_properties(g.radius, density); break;
    case GeometryKind::kCylinder: solid = rod_properties(-half, half, 2.0 * g.radius, density); break;
    case GeometryKind::kCapsule: solid = capsule_properties(-half, half, 2.0 * g.radius, density); break;
    case GeometryKind::kMesh:
      if (g.size.minCoeff() > 0.0) {  // an ellipsoid: m (b2 + c2) / 20 of its axes
        const Eigen::Vector3d squares = g.size.cwiseAbs2();
        solid.mass = density * kPi / 6.0 * g.size.prod();
        solid.inertia = (solid.mass / 20.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares)).asDiagonal();
      } else {
        solid = polyhedron_properties(geometry_mesh(g), density, g.file);
      }
  }
  RobotLink part;
  part.X_DL = link.X_DL * g.X_LG;
  part.mass = solid.mass;
  part.centre = solid.centre;
  part.inertia = solid.inertia;
  add_mass(link, part);
}

bool is_empty(const RobotGeometry& g) {
  switch (g.kind) {
    case GeometryKind::kBox: return !(g.size.minCoeff() > 0.0);
    case GeometryKind::kSphere: return !(g.radius > 0.0);
    case GeometryKind::kCylinder:
    case GeometryKind::kCapsule: return !(g.radius > 0.0) || !(g.length > 0.0);
    case GeometryKind::kMesh: return g.scale.isZero(0.0);
  }
  return false;
}

void Robot::add_geometry(RobotLink& link, RobotGeometry geometry, bool collides) {
  if (is_empty(geometry)) {
    leave_out(geometry.origin, concat(collides ? "a collision" : "a visual", " geometry of link \"", link.name, "\""),
              "has a size of 0: it is left out", !collides);
    return;
  }
  (collides ? link.collisions : link.visuals).push_back(std::move(geometry));
}

// Masses are added from the leaves to the roots. In a circle of joints each one moves all.
MovedInertias::MovedInertias(const Robot& robot) : beyond_(robot.links.size()) {
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    const RobotLink& link = robot.links[k];
    const Eigen::Vector3d centre = link.X_DL * link.centre;
    beyond_[k] = {link.mass, link.mass * centre,
                  link.X_DL.R * link.inertia * link.X_DL.R.transpose() + steiner(link.mass, centre)};
  }
  std::vector<int> above(robot.links.size(), -1),
      open(robot.links.size(), 0);  // open: links below that are not added yet
  for (const RobotJoint& joint : robot.joints)
    if (!joint.loop && joint.parent >= 0 && joint.child >= 0 && above[joint.child] < 0) {
      above[joint.child] = joint.parent;
      ++open[joint.parent];
    }
  std::vector<int> ready;
  for (std::size_t k = 0; k < open.size(); ++k)
    if (open[k] == 0) ready.push_back(static_cast<int>(k));
  while (!ready.empty()) {
    const int link = ready.back(), parent = above[link];
    ready.pop_back();
    if (parent < 0) continue;
    beyond_[parent] += beyond_[link];
    if (--open[parent] == 0) ready.push_back(parent);
  }
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (open[k] == 0) continue;
    Sum all;
    std::vector<int> circle;
    for (int link = static_cast<int>(k); circle.empty() || link != circle.front(); link = above[link]) {
      circle.push_back(link);
      all += beyond_[link];
    }
    for (const int link : circle) {
      beyond_[link] = all;
      open[link] = 0;
    }
  }
}

// About the point p: I_p = I_D - 2 p.h + p h^T + h p^T + m (p.p - p p^T), where h is the first moment about the origin of D.
double MovedInertias::beyond(const RobotJoint& joint, bool slides) const {
  if (joint.child < 0) return 0.0;
  const Sum& sum = beyond_[joint.child];
  if (slides) return sum.mass;
  const Eigen::Vector3d &a = joint.axis, &p = joint.point, &h = sum.moment;
  const double along = a.dot(p);
  return a.dot(sum.inertia * a) + (sum.mass * p.squaredNorm() - 2.0 * p.dot(h)) * a.squaredNorm() +
         2.0 * along * a.dot(h) - sum.mass * along * along;
}

void tidy_robot(Robot& robot, const ImportOptions& options) {
  Tidy(robot, options).carry_out();
  give_plain_names(robot);
}

}  // namespace footfall

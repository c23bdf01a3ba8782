// Makes bodies of links: what has no mass joins its neighbour or gets a small mass, inertias become those of real bodies, names
// become those of a scene. Inertias about a joint, for the stiffness of its stops.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "coupler/base/text.h"
#include "mbd_solver/import/codes.h"
#include "mbd_solver/import/robot.h"

namespace footfall {
namespace {

// Mass of a body between two joints that has none in the file, over the mass beyond it: below the tolerances of a run.
constexpr double kSmallMass = 1e-7;
// A link whose inertia is zero: radius of gyration [m].
constexpr double kPointRadius = 1e-3;
constexpr double kNoRadius = 1e-6;  // below this it is zero [m]

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Eigen::Matrix3d steiner(double mass, const Eigen::Vector3d& d) {
  return mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
}

// Mass, centre and inertia of `from`, at rest relative to `into`, are added to those of `into`.
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

class Tidy {
 public:
  Tidy(Robot& robot, const ImportOptions& options) : robot_(robot), options_(options) {}

  void carry_out() {
    for (std::size_t k = 0; k < robot_.joints.size(); ++k) hold_without_range(static_cast<int>(k));
    if (options_.fix_base) fix_base();
    for (int joint = fixed_to_join(); joint >= 0; joint = fixed_to_join()) join(joint);
    give_masses();
    for (RobotLink& link : robot_.links) mend_inertia(link);
  }

 private:
  RobotLink& link(int index) { return robot_.links[at(index)]; }

  std::vector<int> joints_of(int of) const {
    std::vector<int> result;
    for (std::size_t k = 0; k < robot_.joints.size(); ++k)
      if (robot_.joints[k].parent == of || robot_.joints[k].child == of) result.push_back(static_cast<int>(k));
    return result;
  }

  // Limits that leave no room.
  void hold_without_range(int index) {
    RobotJoint& joint = robot_.joints[at(index)];
    if (joint.coordinates.size() != 1) return;
    const RobotCoordinate& q = joint.coordinates[0];
    if (!q.lower || !q.upper || *q.upper - *q.lower > 1e-9) return;
    robot_.leave_out(joint.origin, "joint \"" + joint.name + "\"",
                     "its limits are both " + number_text(*q.lower) + ": it is held where it is drawn");
    joint.kind = RobotJointKind::kFixed;
    drop_uses(index);
  }

  void fix_base() {
    for (std::size_t k = 0; k < robot_.links.size(); ++k) {
      const int index = static_cast<int>(k);
      const bool below = std::any_of(robot_.joints.begin(), robot_.joints.end(),
                                     [&](const RobotJoint& joint) { return !joint.loop && joint.child == index; });
      if (below) continue;
      RobotJoint mount;
      mount.origin = link(index).origin;
      mount.name = link(index).name + "_mount";
      mount.child = index;
      mount.point = link(index).X_DL.p;
      mount.remark = "of --fix-base";
      robot_.joints.push_back(mount);
      return;  // the first root
    }
  }

  // A fixed joint whose links become one: because one of them has no mass, or by --merge-fixed.
  int fixed_to_join() {
    int found = -1;
    for (std::size_t k = 0; k < robot_.joints.size(); ++k) {
      const RobotJoint& joint = robot_.joints[k];
      if (joint.kind != RobotJointKind::kFixed || joint.loop || joint.child < 0) continue;
      const bool child_empty = !(link(joint.child).mass > 0.0);
      const bool parent_empty = joint.parent >= 0 && !(link(joint.parent).mass > 0.0);
      if (joint.parent < 0 && !child_empty) continue;  // a body on the ground stays
      // Links without anything below first, so that remarks follow the tree.
      if (child_empty || parent_empty || options_.merge_fixed) found = static_cast<int>(k);
    }
    return found;
  }

  void join(int index) {
    const RobotJoint joint = robot_.joints[at(index)];
    const bool child_empty = !(link(joint.child).mass > 0.0);
    const bool up = joint.parent < 0 || child_empty || link(joint.parent).mass > 0.0;
    const int from = up ? joint.child : joint.parent, into = up ? joint.parent : joint.child;
    if (into >= 0) {
      const RigidFrame X = link(into).X_DL.inverse() * link(from).X_DL;
      add_mass(link(into), link(from));
      for (auto list : {&RobotLink::collisions, &RobotLink::visuals})
        for (RobotGeometry geometry : link(from).*list) {
          geometry.X_LG = X * geometry.X_LG;
          (link(into).*list).push_back(geometry);
        }
      std::string& remark = link(into).remark;
      remark += (remark.empty() ? "with " : "; with ") + ("\"" + link(from).name + "\"");
      if (!link(from).remark.empty()) remark += " (" + link(from).remark + ")";
      if (!link(into).friction) link(into).friction = link(from).friction;
    } else if (!link(from).collisions.empty()) {
      robot_.leave_out(link(from).origin, "link \"" + link(from).name + "\": its surface",
                       "it stands on the ground without mass; a scene has bodies with mass only");
    }
    remove_joint(index);
    for (RobotJoint& other : robot_.joints) {
      if (other.parent == from) other.parent = into;
      if (other.child == from) other.child = into;
    }
    for (auto& [first, second] : robot_.apart) {
      if (first == from) first = into;
      if (second == from) second = into;
    }
    remove_link(from);
    for (std::size_t k = robot_.joints.size(); k-- > 0;) {
      if (robot_.joints[k].parent != robot_.joints[k].child) continue;
      robot_.leave_out(robot_.joints[k].origin, "joint \"" + robot_.joints[k].name + "\"",
                       "both of its links are one body");
      remove_joint(static_cast<int>(k));
    }
  }

  void remove_link(int index) {
    robot_.links.erase(robot_.links.begin() + index);
    const auto renumber = [&](int& number) {
      if (number > index) --number;
    };
    for (RobotJoint& joint : robot_.joints) {
      renumber(joint.parent);
      renumber(joint.child);
    }
    auto& apart = robot_.apart;
    apart.erase(std::remove_if(apart.begin(), apart.end(),
                               [&](const auto& p) {
                                 return p.first == index || p.second == index || p.first < 0 || p.second < 0;
                               }),
                apart.end());
    for (auto& [first, second] : apart) {
      renumber(first);
      renumber(second);
    }
  }

  // Links without mass that only moving joints hold.
  void give_masses() {
    bool again = true;
    while (again) {
      again = false;
      for (std::size_t k = 0; k < robot_.links.size() && !again; ++k) {
        const int index = static_cast<int>(k);
        if (link(index).mass > 0.0) continue;
        const std::vector<int> joints = joints_of(index);
        if (joints.empty()) {
          robot_.leave_out(link(index).origin, "link \"" + link(index).name + "\"", "it has no mass");
          remove_link(index);
          again = true;
          continue;
        }
        const bool root =
            std::none_of(joints.begin(), joints.end(), [&](int j) { return robot_.joints[at(j)].child == index; });
        const bool leaf =
            std::none_of(joints.begin(), joints.end(), [&](int j) { return robot_.joints[at(j)].parent == index; });
        if (root) {
          robot_.leave_out(link(index).origin, "link \"" + link(index).name + "\" without mass",
                           "no joint holds it and it has no mass: it is the ground");
          ground(index);
          again = true;
        } else if (leaf) {
          const int joint = joints.front();
          robot_.leave_out(robot_.joints[at(joint)].origin, "joint \"" + robot_.joints[at(joint)].name + "\"",
                           "its link \"" + link(index).name + "\" has no mass and cannot move by itself: it is held");
          drop_uses(joint);
          robot_.joints[at(joint)].kind = RobotJointKind::kFixed;
          for (std::size_t other = joints.size(); other-- > 1;) {
            remove_joint(joints[other]);
          }
          join(joint);
          again = true;
        }
      }
    }
    for (std::size_t k = 0; k < robot_.links.size(); ++k)
      if (!(robot_.links[k].mass > 0.0)) give_small_mass(static_cast<int>(k));
  }

  void remove_joint(int index) {
    drop_uses(index);
    robot_.joints.erase(robot_.joints.begin() + index);
    const auto renumber = [&](int& number) {
      if (number > index) --number;
    };
    for (RobotGear& gear : robot_.gears)
      for (int& number : gear.joints) renumber(number);
    for (RobotDrive& drive : robot_.drives) renumber(drive.joint);
  }

  // The joint has no coordinates any more; gears and drives of it go.
  void drop_uses(int joint) {
    robot_.joints[at(joint)].coordinates.clear();
    auto& gears = robot_.gears;
    gears.erase(std::remove_if(gears.begin(), gears.end(),
                               [&](const RobotGear& gear) {
                                 return std::find(gear.joints.begin(), gear.joints.end(), joint) != gear.joints.end();
                               }),
                gears.end());
    auto& drives = robot_.drives;
    drives.erase(std::remove_if(drives.begin(), drives.end(), [&](const RobotDrive& d) { return d.joint == joint; }),
                 drives.end());
  }

  void ground(int index) {
    for (RobotJoint& joint : robot_.joints) {
      if (joint.parent == index) joint.parent = -1;
      if (joint.child == index) joint.child = -1;
    }
    if (!link(index).collisions.empty())
      robot_.leave_out(link(index).origin, "link \"" + link(index).name + "\": its surface",
                       "it stands on the ground without mass; a scene has bodies with mass only");
    auto& apart = robot_.apart;
    apart.erase(std::remove_if(apart.begin(), apart.end(),
                               [&](const auto& p) { return p.first == index || p.second == index; }),
                apart.end());
    remove_link(index);
  }

  void give_small_mass(int index) {
    double mass = 0.0, inertia = 0.0;
    for (const RobotJoint& joint : robot_.joints) {
      if (joint.parent != index || joint.child < 0 || joint.loop) continue;
      mass += moved_inertia(robot_, joint, true);
      inertia += moved_inertia(robot_, joint, false);
    }
    if (!(mass > 0.0))
      throw InputError(code::kRobotMass, link(index).origin.place() + ": link \"" + link(index).name +
                                             "\" has no mass, nor has what it carries; give it an inertia");
    RobotLink& made = link(index);
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
      robot_.leave_out(of.origin, name, "is zero; it is that of a ball with 1 mm radius of gyration");
      return;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(of.inertia);
    Eigen::Vector3d e = solver.eigenvalues();
    if (!(e[2] > 0.0) || e[0] < -1e-3 * e[2])
      throw InputError(code::kRobotMass, of.origin.place() + ": " + name + " has the principal moments " +
                                             number_text(e[0]) + ", " + number_text(e[1]) + ", " + number_text(e[2]) +
                                             " kg m2, expected all above zero; correct ixx ... izz");
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
                       "no body has the principal moments " + number_text(given[0]) + ", " + number_text(given[1]) +
                           ", " + number_text(given[2]) + " kg m2 (one above the sum of the others): they are " +
                           number_text(e[0]) + ", " + number_text(e[1]) + ", " + number_text(e[2]));
    }
  }

  Robot& robot_;
  const ImportOptions& options_;
};

std::string plain_name(const std::string& name, const std::string& otherwise, std::set<std::string>& used) {
  std::string plain;
  for (const char c : name.substr(0, kLongestName - 8))
    plain += std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128 ? c : '_';
  if (plain.find_first_not_of('_') == std::string::npos) plain = otherwise;
  if (std::isdigit(static_cast<unsigned char>(plain[0])) != 0) plain = otherwise + "_" + plain;
  std::string result = plain;
  for (int k = 2; result == "ground" || result == "plane" || result == "world" || !used.insert(result).second; ++k)
    result = plain + "_" + std::to_string(k);
  return result;
}

void give_plain_names(Robot& robot) {
  std::set<std::string> used;
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

double moved_inertia(const Robot& robot, const RobotJoint& joint, bool slides) {
  std::set<int> moved{joint.child};
  bool grown = true;
  while (grown) {
    grown = false;
    for (const RobotJoint& other : robot.joints)
      if (!other.loop && moved.count(other.parent) > 0 && moved.insert(other.child).second) grown = true;
  }
  double sum = 0.0;
  for (const int index : moved) {
    if (index < 0) continue;
    const RobotLink& link = robot.links[at(index)];
    if (slides) {
      sum += link.mass;
      continue;
    }
    const Eigen::Vector3d axis = link.X_DL.R.transpose() * joint.axis;
    const Eigen::Vector3d arm = (link.X_DL * link.centre - joint.point).cross(joint.axis);
    sum += axis.dot(link.inertia * axis) + link.mass * arm.squaredNorm();
  }
  return sum;
}

void tidy_robot(Robot& robot, const ImportOptions& options) {
  Tidy(robot, options).carry_out();
  give_plain_names(robot);
}

}  // namespace footfall

// URDF. Links and joints are checked first, each with its line, so that the robot can be made of them without further checks; parts that
// no scene can represent are listed. In the reference configuration all joints are zero, except that joints that mimic another have their offset.
#include <algorithm>
#include <cmath>
#include <set>

#include "coupler/base/concat.h"
#include "mbd_solver/import/codes.h"
#include "mbd_solver/import/xml_source.h"

namespace footfall {
namespace {

// Elements that are read (wiki.ros.org/urdf/XML)
const std::map<std::string, KnownElement>& urdf_elements() {
  static const std::map<std::string, KnownElement> known = {
      {"robot", {{"name", "version"}, {"link", "joint"}, {"material"}}},
      {"link", {{"name"}, {"inertial", "visual", "collision"}, {}}},
      {"inertial", {{}, {"origin", "mass", "inertia"}, {}}},
      {"origin", {{"xyz", "rpy", "quat_xyzw"}, {}, {}}},
      {"mass", {{"value"}, {}, {}}},
      {"inertia", {{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}, {}, {}}},
      {"visual", {{"name"}, {"origin", "geometry"}, {"material"}}},
      {"collision", {{"name"}, {"origin", "geometry"}, {"material"}}},
      {"geometry", {{}, {"box", "sphere", "cylinder", "capsule", "mesh"}, {}}},
      {"box", {{"size"}, {}, {}}},
      {"sphere", {{"radius"}, {}, {}}},
      {"cylinder", {{"radius", "length"}, {}, {}}},
      {"capsule", {{"radius", "length"}, {}, {}}},
      {"mesh", {{"filename", "scale"}, {}, {}}},
      {"joint", {{"name", "type"}, {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"}, {}}},
      {"parent", {{"link"}, {}, {}}},
      {"child", {{"link"}, {}, {}}},
      {"axis", {{"xyz"}, {}, {}}},
      {"limit", {{"lower", "upper", "effort", "velocity"}, {}, {}}},
      {"dynamics", {{"damping", "friction"}, {}, {}}},
      {"mimic", {{"joint", "multiplier", "offset"}, {}, {}}},
  };
  return known;
}

void check_origin(const XmlSource& xml, pugi::xml_node origin) {
  if (!origin) return;
  xml.numbers(origin, "xyz", 3, {0, 0, 0});
  xml.numbers(origin, "rpy", 3, {0, 0, 0});
  if (!origin.attribute("quat_xyzw")) return;
  const std::vector<double> q = xml.numbers(origin, "quat_xyzw", 4);
  const Eigen::Quaterniond turn(q[3], q[0], q[1], q[2]);
  if (origin.attribute("rpy")) xml.fail(code::kRobotElement, origin, "has rpy and quat_xyzw; keep one of the two");
  if (!(turn.norm() > 0.0)) xml.fail(code::kRobotNumber, origin, "quat_xyzw is zero, expected a rotation");
}

// R = Rz(yaw) Ry(pitch) Rx(roll) about fixed axes.
Eigen::Quaterniond turn_of(const std::vector<double>& rpy) {
  const Eigen::Vector3d half = 0.5 * Eigen::Vector3d(rpy[0], rpy[1], rpy[2]);
  const Eigen::Array3d s = half.array().sin(), c = half.array().cos();
  const Eigen::Quaterniond q(c[0] * c[1] * c[2] + s[0] * s[1] * s[2], s[0] * c[1] * c[2] - c[0] * s[1] * s[2],
                             c[0] * s[1] * c[2] + s[0] * c[1] * s[2], c[0] * c[1] * s[2] - s[0] * s[1] * c[2]);
  return q.normalized();
}

RigidFrame placement(const XmlSource& xml, const pugi::xml_node& origin) {
  const std::vector<double> p = xml.numbers(origin, "xyz", 3, {0, 0, 0});
  Eigen::Quaterniond turn = turn_of(xml.numbers(origin, "rpy", 3, {0, 0, 0}));
  if (origin.attribute("quat_xyzw")) {
    const std::vector<double> q = xml.numbers(origin, "quat_xyzw", 4);
    turn = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized();
  }
  return {{p[0], p[1], p[2]}, turn.toRotationMatrix()};
}

pugi::xml_node shape_of(const pugi::xml_node& geometry) {
  return geometry.find_child([](const pugi::xml_node& n) {
    const std::string name = n.name();
    return name == "box" || name == "sphere" || name == "cylinder" || name == "capsule" || name == "mesh";
  });
}

void check_geometry(const XmlSource& xml, const pugi::xml_node& of) {
  const pugi::xml_node geometry = of.child("geometry");
  if (!geometry) xml.fail(code::kRobotElement, of, "has no <geometry>, expected one");
  const pugi::xml_node shape = shape_of(geometry);
  if (!shape)
    xml.fail(code::kRobotElement, geometry, "has no box, sphere, cylinder, capsule or mesh; expected one of them");
  const auto not_negative = [&](const char* attribute, std::size_t count) {
    for (const double value : xml.numbers(shape, attribute, count))
      if (value < 0.0) xml.fail(code::kRobotNumber, shape, attribute, " is negative [m]");
  };
  const std::string name = shape.name();
  if (name == "box") not_negative("size", 3);
  if (name == "sphere" || name == "cylinder" || name == "capsule") not_negative("radius", 1);
  if (name == "cylinder" || name == "capsule") not_negative("length", 1);
  if (name != "mesh") return;
  if (*shape.attribute("filename").value() == 0) xml.fail(code::kRobotElement, shape, "has no filename");
  for (const double value : xml.numbers(shape, "scale", 3, {1, 1, 1}))
    if (value == 0.0) xml.fail(code::kRobotNumber, shape, "scale is zero");
}

void check_link(const XmlSource& xml, const pugi::xml_node& link) {
  if (const pugi::xml_node inertial = link.child("inertial")) {
    check_origin(xml, inertial.child("origin"));
    const pugi::xml_node mass = inertial.child("mass"), inertia = inertial.child("inertia");
    if (!mass) xml.fail(code::kRobotElement, inertial, "has no <mass>, expected mass and inertia");
    if (!inertia) xml.fail(code::kRobotElement, inertial, "has no <inertia>, expected mass and inertia");
    if (xml.numbers(mass, "value", 1)[0] < 0.0) xml.fail(code::kRobotMass, mass, "is negative [kg]");
    for (const char* name : {"ixx", "iyy", "izz"}) xml.numbers(inertia, name, 1);
    for (const char* name : {"ixy", "ixz", "iyz"}) xml.numbers(inertia, name, 1, {0.0});
  }
  for (const char* kind : {"visual", "collision"})
    for (const pugi::xml_node& of : link.children(kind)) {
      check_origin(xml, of.child("origin"));
      check_geometry(xml, of);
    }
}

constexpr const char* kTypes[] = {"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};

void check_joint(const XmlSource& xml, const pugi::xml_node& joint) {
  const std::string type = joint.attribute("type").value();
  if (std::find(std::begin(kTypes), std::end(kTypes), type) == std::end(kTypes))
    xml.fail(code::kRobotElement, joint, "has the type \"", type.substr(0, 40),
             "\", expected revolute, continuous, prismatic, fixed, floating or planar");
  check_origin(xml, joint.child("origin"));
  if (const pugi::xml_node axis = joint.child("axis")) {
    const std::vector<double> v = xml.numbers(axis, "xyz", 3);
    if (type != "fixed" && type != "floating" && !(Eigen::Vector3d(v[0], v[1], v[2]).norm() > 1e-9))
      xml.fail(code::kRobotNumber, axis, "xyz is zero, expected a direction");
  }
  const pugi::xml_node limit = joint.child("limit");
  if (!limit && (type == "revolute" || type == "prismatic"))
    xml.fail(code::kRobotElement, joint, "has no <limit>, which this type requires",
             type == "revolute" ? "; without limits it is of type continuous" : "");
  if (limit) {
    const double lower = xml.numbers(limit, "lower", 1, {0.0})[0], upper = xml.numbers(limit, "upper", 1, {0.0})[0];
    if (lower > upper) xml.fail(code::kRobotNumber, limit, "has lower above upper");
    for (const char* name : {"effort", "velocity"}) xml.numbers(limit, name, 1, {0.0});
  }
  if (const pugi::xml_node dynamics = joint.child("dynamics"))
    for (const char* name : {"damping", "friction"})
      if (xml.numbers(dynamics, name, 1, {0.0})[0] < 0.0) xml.fail(code::kRobotNumber, dynamics, name, " is negative");
  if (const pugi::xml_node mimic = joint.child("mimic"))
    for (const char* name : {"multiplier", "offset"}) xml.numbers(mimic, name, 1, {0.0});
}

using NodesByName = std::map<std::string, pugi::xml_node>;

NodesByName by_name(const XmlSource& xml, const char* element) {
  NodesByName nodes;
  for (const pugi::xml_node& node : xml.root().children(element)) {
    const std::string name = node.attribute("name").value();
    if (name.empty()) xml.fail(code::kRobotName, node, "has no name, expected name = \"...\"");
    const auto [before, added] = nodes.emplace(name, node);
    if (!added)
      xml.fail(code::kRobotName, node, "has the name of the element in line ", xml.origin(before->second).line,
               "; give each its own");
  }
  return nodes;
}

// Every joint names two links, and following the parents from any link ends at one root, whose name is returned.
std::string check_tree(const XmlSource& xml, const NodesByName& links, const NodesByName& joints) {
  NodesByName joint_above;
  for (const auto& [name, joint] : joints) {
    for (const char* end : {"parent", "child"}) {
      const pugi::xml_node node = joint.child(end);
      const std::string link = node.attribute("link").value();
      if (link.empty()) xml.fail(code::kRobotName, joint, "names no ", end, " link");
      if (links.count(link) == 0)
        xml.fail(code::kRobotName, node, "link = \"", link.substr(0, 60), "\" is no link of this robot");
    }
    const std::string child = joint.child("child").attribute("link").value();
    const auto [before, added] = joint_above.emplace(child, joint);
    if (!added)
      xml.fail(code::kRobotTree, joint, "has the child \"", child, "\", as has the joint in line ",
               xml.origin(before->second).line, "; a URDF is a tree (SDF and MJCF can have loops)");
  }
  std::string root;
  std::set<std::string> passed;  // they lead to the root
  for (const auto& [name, link] : links) {
    std::string at = name;
    std::set<std::string> way;
    for (auto above = joint_above.find(at); above != joint_above.end(); above = joint_above.find(at)) {
      if (!way.insert(at).second)
        xml.fail(code::kRobotTree, link, "is below itself: its joints go round in a circle; a URDF is a tree");
      if (passed.count(at) > 0) break;
      at = above->second.child("parent").attribute("link").value();
    }
    const bool known = passed.count(at) > 0;
    passed.merge(way);
    if (known) continue;
    if (root.empty()) root = at;
    if (at != root)
      xml.fail(code::kRobotTree, links.at(at), "is a second root in addition to \"", root,
               "\"; add a joint that connects it");
  }
  return root;
}

class UrdfRobot {
 public:
  UrdfRobot(const XmlSource& xml, const NodesByName& links, const NodesByName& joints, const ImportOptions& options)
      : xml_(xml), links_(links), joints_(joints), options_(options) {
    for (const pugi::xml_node& joint : xml.root().children("joint"))
      joints_below_[joint.child("parent").attribute("link").value()].push_back(joint);
  }

  Robot made(const std::string& root) {
    robot_.format = "URDF";
    robot_.file = xml_.file();
    robot_.name = xml_.root().attribute("name").value();
    list_unread(xml_, urdf_elements(), robot_);
    const pugi::xml_node link = links_.at(root);
    if (root == "world" && !link.child("inertial")) {
      open_children(link, -1, {});
      if (link.child("collision"))
        robot_.leave_out(xml_.origin(link), "link \"world\": its surface",
                         "it is the ground; give the scene a [ground], or --ground");
    } else {
      open_.push_back({link, {}, -1, {}});
    }
    while (!open_.empty()) {  // depth first, in the order of the file
      const OpenLink next = open_.back();
      open_.pop_back();
      add_link(next);
    }
    for (const auto& [follower, mimic] : mimics_) add_gear(follower, mimic);
    return std::move(robot_);
  }

 private:
  struct OpenLink {
    pugi::xml_node link, joint;  // and the joint above it
    int parent;
    RigidFrame X_DL;
  };

  void add_link(const OpenLink& open) {
    const pugi::xml_node node = open.link;
    const int index = static_cast<int>(robot_.links.size());
    RobotLink& made = robot_.links.emplace_back();
    made.origin = xml_.origin(node);
    made.name = node.attribute("name").value();
    made.X_DL = open.X_DL;
    if (const pugi::xml_node inertial = node.child("inertial")) {
      const RigidFrame X_LI = placement(xml_, inertial.child("origin"));
      const auto entry = [&](const char* name) { return xml_.numbers(inertial.child("inertia"), name, 1, {0.0})[0]; };
      const double xy = entry("ixy"), xz = entry("ixz"), yz = entry("iyz");
      Eigen::Matrix3d I;
      I << entry("ixx"), xy, xz, xy, entry("iyy"), yz, xz, yz, entry("izz");
      made.mass = xml_.numbers(inertial.child("mass"), "value", 1)[0];
      made.centre = X_LI.p;
      made.inertia = X_LI.R * I * X_LI.R.transpose();
    }
    for (const pugi::xml_node& of : node.children("collision")) robot_.add_geometry(made, geometry(of), true);
    for (const pugi::xml_node& of : node.children("visual")) robot_.add_geometry(made, geometry(of), false);
    if (open.joint) add_joint(open.joint, open.parent, index);
    open_children(node, index, open.X_DL);
  }

  // The first one is the last of the open ones.
  void open_children(const pugi::xml_node& link, int index, const RigidFrame& X_DL) {
    const std::vector<pugi::xml_node>& below = joints_below_[link.attribute("name").value()];
    for (auto joint = below.rbegin(); joint != below.rend(); ++joint) {
      RigidFrame X = X_DL * placement(xml_, joint->child("origin"));
      if (joint->child("mimic")) X = X * displaced(*joint, drawn(*joint));
      open_.push_back({links_.at(joint->child("child").attribute("link").value()), *joint, index, X});
    }
  }

  static bool is_of(const pugi::xml_node& joint, const char* type) {
    return std::string(joint.attribute("type").value()) == type;
  }
  static bool turns(const pugi::xml_node& joint) { return is_of(joint, "revolute") || is_of(joint, "continuous"); }
  double number(const pugi::xml_node& node, const char* attribute, double otherwise) const {
    return xml_.numbers(node, attribute, 1, {otherwise})[0];
  }

  // Coordinate in the reference configuration: zero for joints that follow no other joint.
  double drawn(const pugi::xml_node& joint) {
    double value = 0.0;
    std::vector<pugi::xml_node> followers;
    std::set<std::string> followed;
    for (pugi::xml_node at = joint; at.child("mimic");) {
      const std::string name = at.attribute("name").value();
      if (const auto known = drawn_.find(name); known != drawn_.end()) {
        value = known->second;
        break;
      }
      if (!followed.insert(name).second)
        xml_.fail(code::kRobotTree, joint.child("mimic"),
                  "joints follow each other in a circle; one of them must move by itself");
      followers.push_back(at);
      const auto leader = joints_.find(at.child("mimic").attribute("joint").value());
      at = leader == joints_.end() ? pugi::xml_node() : leader->second;
    }
    for (auto at = followers.rbegin(); at != followers.rend(); ++at) {
      const pugi::xml_node mimic = at->child("mimic");
      drawn_[at->attribute("name").value()] = value =
          number(mimic, "offset", 0.0) + number(mimic, "multiplier", 1.0) * value;
    }
    return value;
  }

  Eigen::Vector3d axis_of(const pugi::xml_node& joint) const {
    const std::vector<double> v = xml_.numbers(joint.child("axis"), "xyz", 3, {1, 0, 0});
    return Eigen::Vector3d(v[0], v[1], v[2]).normalized();
  }

  RigidFrame displaced(const pugi::xml_node& joint, double by) const {
    if (is_of(joint, "prismatic")) return {by * axis_of(joint), Eigen::Matrix3d::Identity()};
    if (turns(joint)) return {Eigen::Vector3d::Zero(), Eigen::AngleAxisd(by, axis_of(joint)).toRotationMatrix()};
    return {};
  }

  void add_joint(const pugi::xml_node& node, int parent, int child) {
    RobotJoint made;
    made.origin = xml_.origin(node);
    made.name = node.attribute("name").value();
    if (is_of(node, "floating")) {
      robot_.links[child].remark = "moves freely (floating joint \"" + made.name + "\")";
      return;
    }
    made.parent = parent;
    made.child = child;
    const RigidFrame& X_DL = robot_.links[child].X_DL;
    made.point = X_DL.p;
    made.kind = turns(node)                ? RobotJointKind::kRevolute
                : is_of(node, "prismatic") ? RobotJointKind::kPrismatic
                : is_of(node, "planar")    ? RobotJointKind::kPlanar
                                           : RobotJointKind::kFixed;
    if (made.kind != RobotJointKind::kFixed) made.axis = X_DL.R * axis_of(node);
    if (made.kind == RobotJointKind::kPlanar) made.axis2 = made.axis.unitOrthogonal();
    if (turns(node) || is_of(node, "prismatic")) {
      made.coordinates.push_back(coordinate(node));
      if (const pugi::xml_node mimic = node.child("mimic"))
        mimics_.emplace_back(static_cast<int>(robot_.joints.size()), mimic);
    } else {
      for (const char* name : {"limit", "dynamics", "mimic"})
        if (const pugi::xml_node of = node.child(name); of && made.kind != RobotJointKind::kFixed)
          robot_.leave_out(xml_.origin(of), concat("<", name, "> of ", title_of(node)),
                           "has no meaning for a planar joint");
    }
    joint_places_[made.name] = static_cast<int>(robot_.joints.size());
    robot_.joints.push_back(made);
  }

  RobotCoordinate coordinate(const pugi::xml_node& joint) {
    RobotCoordinate q;
    q.name = turns(joint) ? "angle" : "displacement";
    const pugi::xml_node limit = joint.child("limit"), dynamics = joint.child("dynamics");
    const bool bounded = limit.attribute("lower") || limit.attribute("upper"), endless = is_of(joint, "continuous");
    if (!endless && !bounded)
      robot_.leave_out(xml_.origin(limit), "<limit> of " + title_of(joint),
                       "has neither lower nor upper: the joint has no stops");
    if (bounded && !endless) {
      q.lower = number(limit, "lower", 0.0);
      q.upper = number(limit, "upper", 0.0);
    }
    if (limit) {
      const double effort = number(limit, "effort", 0.0);
      q.effort = std::max(0.0, effort);
      q.speed = std::max(0.0, number(limit, "velocity", 0.0));
      q.without_effort = limit.attribute("effort") && !(effort > 0.0);
      if (options_.hold && q.without_effort && !joint.child("mimic"))
        robot_.leave_out(xml_.origin(limit), "<limit> of " + title_of(joint), kWithoutEffort);
    }
    q.damping = number(dynamics, "damping", 0.0);
    q.friction = number(dynamics, "friction", 0.0);
    if (joint.child("mimic")) q.zero = drawn(joint);
    return q;
  }

  void add_gear(int follower, const pugi::xml_node& mimic) {
    const RobotJoint& driven = robot_.joints[follower];
    const std::string name = mimic.attribute("joint").value();
    const double multiplier = number(mimic, "multiplier", 1.0);
    const auto found = joint_places_.find(name);
    const int leader = found == joint_places_.end() ? -1 : found->second;
    if (leader < 0 || leader == follower)
      xml_.fail(code::kRobotName, mimic, "joint = \"", name.substr(0, 60), "\" is no other joint that moves");
    const RobotJoint& leading = robot_.joints[leader];
    if (leading.coordinates.size() != 1)
      xml_.fail(code::kRobotName, mimic, "joint = \"", name, "\" has no single coordinate to follow");
    if (multiplier == 0.0) {
      robot_.joints[follower].kind = RobotJointKind::kFixed;
      robot_.joints[follower].coordinates.clear();
      robot_.joints[follower].remark = "mimics another joint with the factor 0: it is held";
      return;
    }
    RobotGear gear;
    gear.origin = xml_.origin(mimic);
    gear.name = driven.name + "_mimic";
    gear.joints = {follower, leader};
    gear.coordinates = {driven.coordinates[0].name, leading.coordinates[0].name};
    gear.factors = {1.0, -multiplier};
    robot_.gears.push_back(gear);
  }

  RobotGeometry geometry(const pugi::xml_node& node) const {
    RobotGeometry made;
    made.origin = xml_.origin(node);
    made.name = node.attribute("name").value();
    made.X_LG = placement(xml_, node.child("origin"));
    const pugi::xml_node shape = shape_of(node.child("geometry"));
    const std::string kind = shape.name();
    if (kind == "box") {
      made.kind = GeometryKind::kBox;
      made.size = Eigen::Vector3d(xml_.numbers(shape, "size", 3).data());
    } else if (kind == "mesh") {
      const std::string file = shape.attribute("filename").value();
      made.kind = GeometryKind::kMesh;
      made.scale = Eigen::Vector3d(xml_.numbers(shape, "scale", 3, {1, 1, 1}).data());
      made.file = find_mesh(file, xml_.file(), options_);
      if (made.file.empty()) made.name = file;
    } else {
      made.kind = kind == "sphere"    ? GeometryKind::kSphere
                  : kind == "capsule" ? GeometryKind::kCapsule
                                      : GeometryKind::kCylinder;
      made.radius = number(shape, "radius", 0.0);
      made.length = number(shape, "length", 0.0);
    }
    return made;
  }

  const XmlSource& xml_;
  const NodesByName &links_, &joints_;
  const ImportOptions& options_;
  Robot robot_;
  std::map<std::string, std::vector<pugi::xml_node>> joints_below_;  // a link, in the order of the file
  std::vector<std::pair<int, pugi::xml_node>> mimics_;
  std::map<std::string, int> joint_places_;
  std::map<std::string, double> drawn_;  // coordinates of joints that follow others
  std::vector<OpenLink> open_;           // links that are not added yet
};

void refuse_xacro(const XmlSource& xml) {
  const pugi::xml_node found = xml.root().find_node([](const pugi::xml_node& node) {
    bool macro = std::string(node.name()).rfind("xacro:", 0) == 0;
    for (const pugi::xml_attribute& a : node.attributes())
      macro = macro || std::string(a.value()).find("${") != std::string::npos ||
              std::string(a.value()).find("$(") != std::string::npos;
    return macro;
  });
  if (found)
    xml.fail(code::kRobotXacro, found, "is a macro of xacro; expand the file first: xacro ", xml.file(),
             " > robot.urdf");
}

}  // namespace

Robot read_urdf(const std::string& file, const ImportOptions& options) {
  const XmlSource xml(file);
  refuse_xacro(xml);
  const NodesByName links = by_name(xml, "link"), joints = by_name(xml, "joint");
  if (links.empty()) xml.fail(code::kRobotElement, xml.root(), "has no <link>, expected a robot");
  for (const auto& [name, link] : links) check_link(xml, link);
  for (const auto& [name, joint] : joints) check_joint(xml, joint);
  if (*xml.root().attribute("name").value() == 0) xml.fail(code::kRobotName, xml.root(), "has no name");
  const std::string root = check_tree(xml, links, joints);
  return UrdfRobot(xml, links, joints, options).made(root);
}

}  // namespace footfall

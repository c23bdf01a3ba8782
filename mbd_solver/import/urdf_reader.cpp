// URDF. The file is checked with its lines, parts that no scene can represent are listed, and urdfdom reads links, joints and
// placements. In the reference configuration all joints are zero, except that joints that mimic another have their offset.
#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "mbd_solver/base/pi.h"
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
Eigen::Vector3d rpy_of(const Eigen::Matrix3d& R) {
  const double across = std::hypot(R(0, 0), R(1, 0));
  if (across > 1e-12) return {std::atan2(R(2, 1), R(2, 2)), std::atan2(-R(2, 0), across), std::atan2(R(1, 0), R(0, 0))};
  return {0.0, std::atan2(-R(2, 0), across), std::atan2(-R(0, 1), R(1, 1))};
}

void check_geometry(const XmlSource& xml, const pugi::xml_node& of) {
  const pugi::xml_node geometry = of.child("geometry");
  if (!geometry) xml.fail(code::kRobotElement, of, "has no <geometry>, expected one");
  const pugi::xml_node shape = geometry.find_child([](const pugi::xml_node& n) {
    const std::string name = n.name();
    return name == "box" || name == "sphere" || name == "cylinder" || name == "capsule" || name == "mesh";
  });
  if (!shape)
    xml.fail(code::kRobotElement, geometry, "has no box, sphere, cylinder, capsule or mesh; expected one of them");
  const auto not_negative = [&](const char* attribute, std::size_t count) {
    for (const double value : xml.numbers(shape, attribute, count))
      if (value < 0.0) xml.fail(code::kRobotNumber, shape, std::string(attribute) + " is negative [m]");
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
    xml.fail(code::kRobotElement, joint,
             "has the type \"" + type.substr(0, 40) +
                 "\", expected revolute, continuous, prismatic, fixed, floating or planar");
  check_origin(xml, joint.child("origin"));
  if (const pugi::xml_node axis = joint.child("axis")) {
    const std::vector<double> v = xml.numbers(axis, "xyz", 3);
    if (type != "fixed" && type != "floating" && !(Eigen::Vector3d(v[0], v[1], v[2]).norm() > 1e-9))
      xml.fail(code::kRobotNumber, axis, "xyz is zero, expected a direction");
  }
  const pugi::xml_node limit = joint.child("limit");
  if (!limit && (type == "revolute" || type == "prismatic"))
    xml.fail(code::kRobotElement, joint,
             "has no <limit>, which this type requires" +
                 std::string(type == "revolute" ? "; without limits it is of type continuous" : ""));
  if (limit) {
    const double lower = xml.numbers(limit, "lower", 1, {0.0})[0], upper = xml.numbers(limit, "upper", 1, {0.0})[0];
    if (lower > upper) xml.fail(code::kRobotNumber, limit, "has lower above upper");
    for (const char* name : {"effort", "velocity"}) xml.numbers(limit, name, 1, {0.0});
  }
  if (const pugi::xml_node dynamics = joint.child("dynamics"))
    for (const char* name : {"damping", "friction"})
      if (xml.numbers(dynamics, name, 1, {0.0})[0] < 0.0)
        xml.fail(code::kRobotNumber, dynamics, std::string(name) + " is negative");
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
      xml.fail(code::kRobotName, node,
               "has the name of the element in line " + std::to_string(xml.origin(before->second).line) +
                   "; give each its own");
  }
  return nodes;
}

// Every joint names two links, and following the parents from any link ends at one root.
void check_tree(const XmlSource& xml, const NodesByName& links, const NodesByName& joints) {
  NodesByName joint_above;
  for (const auto& [name, joint] : joints) {
    for (const char* end : {"parent", "child"}) {
      const pugi::xml_node node = joint.child(end);
      const std::string link = node.attribute("link").value();
      if (link.empty()) xml.fail(code::kRobotName, joint, "names no " + std::string(end) + " link");
      if (links.count(link) == 0)
        xml.fail(code::kRobotName, node, "link = \"" + link.substr(0, 60) + "\" is no link of this robot");
    }
    const std::string child = joint.child("child").attribute("link").value();
    const auto [before, added] = joint_above.emplace(child, joint);
    if (!added)
      xml.fail(code::kRobotTree, joint,
               "has the child \"" + child + "\", as has the joint in line " +
                   std::to_string(xml.origin(before->second).line) +
                   "; a URDF is a tree (SDF and MJCF can have loops)");
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
      xml.fail(code::kRobotTree, links.at(at),
               "is a second root in addition to \"" + root + "\"; add a joint that connects it");
  }
}

RigidFrame placement(const urdf::Pose& pose) {
  Eigen::Quaterniond q(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  return {{pose.position.x, pose.position.y, pose.position.z}, q.normalized().toRotationMatrix()};
}

// Messages of urdfdom.
class Messages final : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) texts += (texts.empty() ? "" : "; ") + text;
  }
  std::string texts;
};

// The text for urdfdom: without elements that it does not read, or refuses without need (colours, capsules, missing efforts).
std::string text_for_urdfdom(const XmlSource& xml) {
  pugi::xml_document copy;
  pugi::xml_node robot = copy.append_copy(xml.root());
  robot.remove_attribute("version");
  const auto remove_all = [](pugi::xml_node node, const char* name) {
    while (node.remove_child(name)) {
    }
  };
  const auto turn_quaternion = [](pugi::xml_node origin) {
    const pugi::xml_attribute given = origin.attribute("quat_xyzw");
    if (!given) return;
    const std::vector<double> q = *numbers_of(given.value());
    const Eigen::Vector3d rpy = rpy_of(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix());
    std::ostringstream text;
    text.precision(17);
    text << rpy[0] << ' ' << rpy[1] << ' ' << rpy[2];
    origin.append_attribute("rpy") = text.str().c_str();
  };
  remove_all(robot, "material");
  for (pugi::xml_node child = robot.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    const std::string name = child.name();
    if (name != "link" && name != "joint") robot.remove_child(child);
    child = next;
  }
  for (pugi::xml_node link : robot.children("link")) {
    turn_quaternion(link.child("inertial").child("origin"));
    if (pugi::xml_node inertia = link.child("inertial").child("inertia"))
      for (const char* name : {"ixy", "ixz", "iyz"})
        if (!inertia.attribute(name)) inertia.append_attribute(name) = "0";
    for (const char* kind : {"visual", "collision"})
      for (pugi::xml_node of : link.children(kind)) {
        remove_all(of, "material");
        turn_quaternion(of.child("origin"));
        if (pugi::xml_node capsule = of.child("geometry").child("capsule")) capsule.set_name("cylinder");
      }
  }
  for (pugi::xml_node joint : robot.children("joint")) {
    turn_quaternion(joint.child("origin"));
    remove_all(joint, "safety_controller");
    remove_all(joint, "calibration");
    if (pugi::xml_node dynamics = joint.child("dynamics"))
      if (!dynamics.attribute("damping") && !dynamics.attribute("friction")) joint.remove_child(dynamics);
    if (pugi::xml_node limit = joint.child("limit"))
      for (const char* name : {"effort", "velocity"})
        if (!limit.attribute(name)) limit.append_attribute(name) = "0";
  }
  std::ostringstream text;
  copy.save(text, "", pugi::format_raw);
  return text.str();
}

class UrdfRobot {
 public:
  UrdfRobot(const XmlSource& xml, const NodesByName& links, const NodesByName& joints, const ImportOptions& options)
      : xml_(xml), link_nodes_(links), joint_nodes_(joints), options_(options) {}

  Robot made(const urdf::ModelInterface& model) {
    robot_.format = "URDF";
    robot_.file = xml_.file();
    robot_.name = model.getName();
    list_unread(xml_, urdf_elements(), robot_);
    model_ = &model;
    const urdf::Link& root = *model.getRoot();
    if (root.name == "world" && !root.inertial) {
      open_children(root, -1, {});
      if (!root.collision_array.empty())
        robot_.leave_out(xml_.origin(link_nodes_.at(root.name)), "link \"world\": its surface",
                         "it is the ground; give the scene a [ground], or --ground");
    } else {
      open_.push_back({&root, -1, {}});
    }
    while (!open_.empty()) {  // depth first, in the order of the file
      const OpenLink next = open_.back();
      open_.pop_back();
      add_link(*next.link, next.parent, next.X_DL);
    }
    for (const auto& [follower, mimic] : mimics_) add_gear(follower, *mimic);
    return std::move(robot_);
  }

 private:
  void add_link(const urdf::Link& link, int parent, const RigidFrame& X_DL) {
    const pugi::xml_node node = link_nodes_.at(link.name);
    const int index = static_cast<int>(robot_.links.size());
    RobotLink& made = robot_.links.emplace_back();
    made.origin = xml_.origin(node);
    made.name = link.name;
    made.X_DL = X_DL;
    if (link.inertial) {
      const urdf::Inertial& i = *link.inertial;
      const RigidFrame X_LI = placement(i.origin);
      Eigen::Matrix3d I;
      I << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
      made.mass = i.mass;
      made.centre = X_LI.p;
      made.inertia = X_LI.R * I * X_LI.R.transpose();
    }
    auto collision = node.children("collision").begin();
    for (const auto& of : link.collision_array)
      robot_.add_geometry(made, geometry(*of->geometry, of->origin, *collision++), true);
    auto visual = node.children("visual").begin();
    for (const auto& of : link.visual_array)
      robot_.add_geometry(made, geometry(*of->geometry, of->origin, *visual++), false);
    if (link.parent_joint) add_joint(*link.parent_joint, parent, index);
    open_children(link, index, X_DL);
  }

  // In the order of the file, not of names; the first one is the last of the open ones.
  void open_children(const urdf::Link& link, int index, const RigidFrame& X_DL) {
    std::vector<urdf::LinkSharedPtr> children = link.child_links;
    std::sort(children.begin(), children.end(), [&](const auto& a, const auto& b) {
      return joint_nodes_.at(a->parent_joint->name).offset_debug() >
             joint_nodes_.at(b->parent_joint->name).offset_debug();
    });
    for (const auto& child : children) {
      const urdf::Joint& joint = *child->parent_joint;
      RigidFrame X = X_DL * placement(joint.parent_to_joint_origin_transform);
      if (joint.mimic) X = X * displaced(joint, drawn(joint));
      open_.push_back({child.get(), index, X});
    }
  }

  // Coordinate in the reference configuration: zero for joints that follow no other joint.
  double drawn(const urdf::Joint& joint) {
    double value = 0.0;
    std::vector<const urdf::Joint*> followers;
    std::set<std::string> followed;
    for (const urdf::Joint* at = &joint; at != nullptr && at->mimic;
         at = model_->getJoint(at->mimic->joint_name).get()) {
      if (const auto known = drawn_.find(at->name); known != drawn_.end()) {
        value = known->second;
        break;
      }
      if (!followed.insert(at->name).second)
        xml_.fail(code::kRobotTree, joint_nodes_.at(joint.name).child("mimic"),
                  "joints follow each other in a circle; one of them must move by itself");
      followers.push_back(at);
    }
    for (auto at = followers.rbegin(); at != followers.rend(); ++at)
      drawn_[(*at)->name] = value = (*at)->mimic->offset + (*at)->mimic->multiplier * value;
    return value;
  }

  static Eigen::Vector3d axis_of(const urdf::Joint& joint) {
    return Eigen::Vector3d(joint.axis.x, joint.axis.y, joint.axis.z).normalized();
  }

  static RigidFrame displaced(const urdf::Joint& joint, double by) {
    if (joint.type == urdf::Joint::PRISMATIC) return {by * axis_of(joint), Eigen::Matrix3d::Identity()};
    if (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS)
      return {Eigen::Vector3d::Zero(), Eigen::AngleAxisd(by, axis_of(joint)).toRotationMatrix()};
    return {};
  }

  void add_joint(const urdf::Joint& joint, int parent, int child) {
    const pugi::xml_node node = joint_nodes_.at(joint.name);
    if (joint.type == urdf::Joint::FLOATING) {
      robot_.links[child].remark = "moves freely (floating joint \"" + joint.name + "\")";
      return;
    }
    RobotJoint made;
    made.origin = xml_.origin(node);
    made.name = joint.name;
    made.parent = parent;
    made.child = child;
    const RigidFrame& X_DL = robot_.links[child].X_DL;
    made.point = X_DL.p;
    if (joint.type != urdf::Joint::FIXED) made.axis = X_DL.R * axis_of(joint);
    switch (joint.type) {
      case urdf::Joint::REVOLUTE:
      case urdf::Joint::CONTINUOUS: made.kind = RobotJointKind::kRevolute; break;
      case urdf::Joint::PRISMATIC: made.kind = RobotJointKind::kPrismatic; break;
      case urdf::Joint::PLANAR:
        made.kind = RobotJointKind::kPlanar;
        made.axis2 = made.axis.unitOrthogonal();
        break;
      default: made.kind = RobotJointKind::kFixed;
    }
    if (made.kind == RobotJointKind::kRevolute || made.kind == RobotJointKind::kPrismatic) {
      RobotCoordinate q;
      q.name = made.kind == RobotJointKind::kRevolute ? "angle" : "displacement";
      const pugi::xml_node limit = node.child("limit");
      const bool bounded = limit.attribute("lower") || limit.attribute("upper");
      if (joint.type != urdf::Joint::CONTINUOUS && !bounded)
        robot_.leave_out(xml_.origin(limit), "<limit> of " + title_of(node),
                         "has neither lower nor upper: the joint has no stops");
      if (joint.limits && bounded && joint.type != urdf::Joint::CONTINUOUS) {
        q.lower = joint.limits->lower;
        q.upper = joint.limits->upper;
      }
      if (joint.limits) {
        q.effort = std::max(0.0, joint.limits->effort);
        q.speed = std::max(0.0, joint.limits->velocity);
        if (options_.hold && limit.attribute("effort") && !(joint.limits->effort > 0.0) && !joint.mimic)
          robot_.leave_out(xml_.origin(limit), "<limit> of " + title_of(node), kWithoutEffort);
      }
      if (joint.dynamics) {
        q.damping = joint.dynamics->damping;
        q.friction = joint.dynamics->friction;
      }
      if (joint.mimic) {
        q.zero = drawn(joint);
        mimics_.emplace_back(static_cast<int>(robot_.joints.size()), joint.mimic.get());
      }
      made.coordinates.push_back(q);
    } else {
      for (const char* name : {"limit", "dynamics", "mimic"})
        if (const pugi::xml_node of = node.child(name); of && made.kind != RobotJointKind::kFixed)
          robot_.leave_out(xml_.origin(of), "<" + std::string(name) + "> of " + title_of(node),
                           "has no meaning for a planar joint");
    }
    joint_places_[made.name] = static_cast<int>(robot_.joints.size());
    robot_.joints.push_back(made);
  }

  void add_gear(int follower, const urdf::JointMimic& mimic) {
    const RobotJoint& driven = robot_.joints[follower];
    const pugi::xml_node node = joint_nodes_.at(driven.name).child("mimic");
    const auto found = joint_places_.find(mimic.joint_name);
    const int leader = found == joint_places_.end() ? -1 : found->second;
    if (leader < 0 || leader == follower)
      xml_.fail(code::kRobotName, node,
                "joint = \"" + mimic.joint_name.substr(0, 60) + "\" is no other joint that moves");
    const RobotJoint& leading = robot_.joints[leader];
    if (leading.coordinates.size() != 1)
      xml_.fail(code::kRobotName, node, "joint = \"" + mimic.joint_name + "\" has no single coordinate to follow");
    if (mimic.multiplier == 0.0) {
      robot_.joints[follower].kind = RobotJointKind::kFixed;
      robot_.joints[follower].coordinates.clear();
      robot_.joints[follower].remark = "mimics another joint with the factor 0: it is held";
      return;
    }
    RobotGear gear;
    gear.origin = xml_.origin(node);
    gear.name = driven.name + "_mimic";
    gear.joints = {follower, leader};
    gear.coordinates = {driven.coordinates[0].name, leading.coordinates[0].name};
    gear.factors = {1.0, -mimic.multiplier};
    robot_.gears.push_back(gear);
  }

  RobotGeometry geometry(const urdf::Geometry& shape, const urdf::Pose& pose, const pugi::xml_node& node) {
    RobotGeometry made;
    made.origin = xml_.origin(node);
    made.name = node.attribute("name").value();
    made.X_LG = placement(pose);
    switch (shape.type) {
      case urdf::Geometry::BOX: {
        const auto& box = static_cast<const urdf::Box&>(shape);
        made.kind = GeometryKind::kBox;
        made.size = {box.dim.x, box.dim.y, box.dim.z};
        break;
      }
      case urdf::Geometry::SPHERE:
        made.kind = GeometryKind::kSphere;
        made.radius = static_cast<const urdf::Sphere&>(shape).radius;
        break;
      case urdf::Geometry::CYLINDER: {
        const auto& cylinder = static_cast<const urdf::Cylinder&>(shape);
        made.kind = node.child("geometry").child("capsule") ? GeometryKind::kCapsule : GeometryKind::kCylinder;
        made.radius = cylinder.radius;
        made.length = cylinder.length;
        break;
      }
      default: {
        const auto& mesh = static_cast<const urdf::Mesh&>(shape);
        made.kind = GeometryKind::kMesh;
        made.scale = {mesh.scale.x, mesh.scale.y, mesh.scale.z};
        made.file = find_mesh(mesh.filename, xml_.file(), options_);
        if (made.file.empty()) made.name = mesh.filename;
      }
    }
    return made;
  }

  const XmlSource& xml_;
  const NodesByName &link_nodes_, &joint_nodes_;
  const ImportOptions& options_;
  Robot robot_;
  const urdf::ModelInterface* model_ = nullptr;
  std::vector<std::pair<int, const urdf::JointMimic*>> mimics_;
  std::map<std::string, int> joint_places_;
  std::map<std::string, double> drawn_;  // coordinates of joints that follow others
  struct OpenLink {
    const urdf::Link* link;
    int parent;
    RigidFrame X_DL;
  };
  std::vector<OpenLink> open_;  // links that are not added yet
};

void refuse_xacro(const XmlSource& xml) {
  struct Walker : pugi::xml_tree_walker {
    pugi::xml_node found;
    bool for_each(pugi::xml_node& node) override {
      bool macro = std::string(node.name()).rfind("xacro:", 0) == 0;
      for (const pugi::xml_attribute& a : node.attributes())
        macro = macro || std::string(a.value()).find("${") != std::string::npos ||
                std::string(a.value()).find("$(") != std::string::npos;
      if (macro) found = node;
      return !macro;
    }
  } walker;
  pugi::xml_node root = xml.root();
  root.traverse(walker);
  if (walker.found)
    xml.fail(code::kRobotXacro, walker.found,
             "is a macro of xacro; expand the file first: xacro " + xml.file() + " > robot.urdf");
}

}  // namespace

Robot read_urdf(const std::string& file, const ImportOptions& options) {
  const XmlSource xml(file);
  refuse_xacro(xml);
  const NodesByName links = by_name(xml, "link"), joints = by_name(xml, "joint");
  if (links.empty()) xml.fail(code::kRobotElement, xml.root(), "has no <link>, expected a robot");
  for (const auto& [name, link] : links) check_link(xml, link);
  for (const auto& [name, joint] : joints) check_joint(xml, joint);
  check_tree(xml, links, joints);
  Messages messages;
  console_bridge::useOutputHandler(&messages);
  urdf::ModelInterfaceSharedPtr model;
  std::string thrown;
  try {
    model = urdf::parseURDF(text_for_urdfdom(xml));
  } catch (const std::exception& error) {
    thrown = error.what();
  }
  console_bridge::restorePreviousOutputHandler();
  if (!model || !model->getRoot())
    throw InputError(code::kRobotRefused, xml.origin(xml.root()).place() + ": urdfdom refuses the file: " +
                                              (messages.texts.empty() ? thrown : messages.texts) +
                                              "; `check_urdf` of the Debian package liburdfdom-tools prints details");
  return UrdfRobot(xml, links, joints, options).made(*model);
}

}  // namespace footfall

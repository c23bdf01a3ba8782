// From the innermost frame outwards: a child's placement in its frame becomes a placement in the frame's parent, also if a
// class of defaults gives it; a replicate holds several such frames, and references to its parts are replicated as often.
#include "mbd_solver/import/mjcf_source.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/import/codes.h"

namespace footfall {
namespace {

constexpr std::size_t kMostCopied = 20000;  // elements that replicates may make

bool holds_parts(const std::string& name) { return name == "frame" || name == "replicate"; }

// Attributes by which elements outside of the tree refer to its parts, and the kind of these.
const std::map<std::string, std::string>& references() {
  static const std::map<std::string, std::string> kinds = {
      {"joint", "joint"},  {"joint1", "joint"},  {"joint2", "joint"},    {"jointinparent", "joint"},
      {"body", "body"},    {"body1", "body"},    {"body2", "body"},      {"geom", "geom"},
      {"geom1", "geom"},   {"geom2", "geom"},    {"site", "site"},       {"site1", "site"},
      {"site2", "site"},   {"sidesite", "site"}, {"slidersite", "site"}, {"cranksite", "site"},
      {"refsite", "site"}, {"tendon", "tendon"}, {"tendon1", "tendon"},  {"tendon2", "tendon"},
  };
  return kinds;
}

std::string kind_of_part(const pugi::xml_node& node) {
  const std::string name = node.name();
  return name == "freejoint" ? "joint" : name == "spatial" || name == "fixed" ? "tendon" : name;
}

using NamesByKind = std::map<std::string, std::set<std::string>>;

std::vector<pugi::xml_node> elements_of(const pugi::xml_node& node) {
  std::vector<pugi::xml_node> elements;
  for (const pugi::xml_node& child : node.children())
    if (child.type() == pugi::node_element) elements.push_back(child);
  return elements;
}

class Frames {
 public:
  Frames(pugi::xml_node mujoco, const std::function<Origin(const pugi::xml_node&)>& origin,
         const std::function<void(const pugi::xml_node&, const pugi::xml_node&)>& copied)
      : mujoco_(mujoco), origin_(origin), copied_(copied) {}

  void resolve() {
    if (!mujoco_.find_node([](const pugi::xml_node& node) { return holds_parts(node.name()); })) return;
    for (const pugi::xml_node& compiler : mujoco_.children("compiler")) {
      if (compiler.attribute("angle")) degrees_ = std::string(compiler.attribute("angle").value()) != "radian";
      if (compiler.attribute("eulerseq")) sequence_ = compiler.attribute("eulerseq").value();
      if (std::string(compiler.attribute("coordinate").value()) == "global")
        fail(code::kRobotElement, compiler, "has global coordinates, with which MJCF has no frames; write local ones");
      if (sequence_.size() != 3 || sequence_.find_first_not_of("xyzXYZ") != std::string::npos)
        fail(code::kRobotElement, compiler, "eulerseq has other letters than three of xyzXYZ");
    }
    for (const pugi::xml_node& top : mujoco_.children("default")) {
      read_class(top);
      tops_.push_back(top);
    }
    for (const pugi::xml_node& world : mujoco_.children("worldbody")) resolve_in(world);
  }

 private:
  template <class... Pieces>
  [[noreturn]] void fail(const MessageCode& code, const pugi::xml_node& node, const Pieces&... what) const {
    throw InputError(code, origin_(node).place(), ": ", title_of(node), " ", what...);
  }

  std::vector<double> numbers(const pugi::xml_node& node, const std::string& attribute, const std::string& text,
                              std::size_t least, std::size_t most) const {
    const std::optional<std::vector<double>> values = numbers_of(text);
    if (!values || values->size() < least || values->size() > most)
      fail(code::kRobotNumber, node, attribute, " is \"", trimmed(text).substr(0, 60), "\", expected ", most,
           " finite numbers separated by blanks");
    return *values;
  }
  Eigen::Vector3d vector(const pugi::xml_node& node, const char* attribute) const {
    const std::vector<double> v = numbers(node, attribute, effective(node, attribute), 3, 3);
    return {v[0], v[1], v[2]};
  }

  // --- Classes of defaults.

  // Orientations of classes become quaternions: of an element with one of its own, no other spelling may remain.
  void read_class(const pugi::xml_node& one) {
    for (const pugi::xml_node& child : elements_of(one))
      if (std::string(child.name()) == "default") {
        classes_[child.attribute("class").value()] = child;
        read_class(child);
      } else if (const std::string kind = child.name(); kind == "geom" || kind == "site") {
        if (!spelling(child, false).empty()) set(child, "quat", rotation(child, false));
      }
  }

  // The class of an element, within the general class: its own, or the class of the nearest body or frame around it.
  pugi::xml_node class_of(const pugi::xml_node& node) const {
    std::string name = node.attribute("class").value();
    for (pugi::xml_node at = node.parent(); at && name.empty(); at = at.parent())
      name = at.attribute("childclass").value();
    const auto found = classes_.find(name);
    return found == classes_.end() ? pugi::xml_node() : found->second;
  }

  // The text of its attribute, or of its class, or of the class that this one is part of; or nothing.
  std::string effective(const pugi::xml_node& node, const std::string& attribute) const {
    if (const pugi::xml_attribute own = node.attribute(attribute.c_str())) return own.value();
    const std::string kind = node.name();
    if (kind == "body" || holds_parts(kind)) return "";
    std::vector<pugi::xml_node> ones;
    for (pugi::xml_node one = class_of(node); one && one.parent() != mujoco_; one = one.parent()) ones.push_back(one);
    ones.insert(ones.end(), tops_.rbegin(), tops_.rend());
    for (const pugi::xml_node& one : ones)
      if (const pugi::xml_attribute given = one.child(kind.c_str()).attribute(attribute.c_str())) return given.value();
    return "";
  }

  // --- Placements.

  double angle(double value) const { return degrees_ ? value * kPi / 180.0 : value; }

  // Letter by letter: small ones turn about axes that move with the frame, capitals about fixed ones.
  Eigen::Quaterniond euler(const Eigen::Vector3d& angles) const {
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    for (int k = 0; k < 3; ++k) {
      const char letter = sequence_[k];
      const bool moves = letter >= 'x';
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(letter - (moves ? 'x' : 'X'));
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle(angles[k]), axis));
      q = moves ? q * turn : turn * q;
    }
    return q;
  }

  // The shortest turn of z to v; about x where v = -z.
  static Eigen::Quaterniond from_z(const Eigen::Vector3d& v) {
    const Eigen::Vector3d across = Eigen::Vector3d::UnitZ().cross(v);
    const double sine = across.norm();
    const Eigen::Vector3d axis = sine < 1e-10 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d(across / sine);
    return Eigen::Quaterniond(Eigen::AngleAxisd(std::atan2(sine, v[2]), axis));
  }

  Eigen::Vector3d direction(const pugi::xml_node& node, const char* what, const Eigen::Vector3d& v) const {
    if (!(v.norm() > 1e-10)) fail(code::kRobotNumber, node, what, " is zero, expected a direction");
    return v.normalized();
  }

  std::string spelling(const pugi::xml_node& node, bool with_class) const {
    std::string found;
    for (const char* one : {"quat", "axisangle", "xyaxes", "zaxis", "euler"})
      if (node.attribute(one)) found = one;
    return found.empty() && with_class && !effective(node, "quat").empty() ? "quat" : found;
  }

  Eigen::Quaterniond rotation(const pugi::xml_node& node, bool with_class) const {
    const std::string how = spelling(node, with_class);
    if (how.empty()) return Eigen::Quaterniond::Identity();
    const std::size_t count = how == "xyaxes" ? 6 : how == "quat" || how == "axisangle" ? 4 : 3;
    const std::vector<double> v = numbers(node, how, effective(node, how), count, count);
    if (how == "quat") {
      const Eigen::Quaterniond q(v[0], v[1], v[2], v[3]);
      if (!(q.norm() > 1e-10)) fail(code::kRobotNumber, node, "quat is zero, expected a rotation");
      return q.normalized();
    }
    const Eigen::Vector3d first(v[0], v[1], v[2]);
    if (how == "euler") return euler(first);
    const Eigen::Vector3d x = direction(node, how.c_str(), first);
    if (how == "zaxis") return from_z(x);
    if (how == "axisangle") return Eigen::Quaterniond(Eigen::AngleAxisd(angle(v[3]), x));
    Eigen::Matrix3d R;
    R.col(0) = x;
    const Eigen::Vector3d second(v[3], v[4], v[5]);
    R.col(1) = direction(node, "the second of xyaxes, normal to the first,", second - x * x.dot(second));
    R.col(2) = R.col(0).cross(R.col(1));
    return Eigen::Quaterniond(R);
  }

  struct Pose {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  };
  Pose pose_of(const pugi::xml_node& node) const {
    Pose X;
    if (!effective(node, "pos").empty()) X.p = vector(node, "pos");
    X.q = rotation(node, true);
    return X;
  }

  static void set(pugi::xml_node node, const char* attribute, std::initializer_list<double> values) {
    std::string text;
    for (const double v : values) text += (text.empty() ? "" : " ") + number_text(v, 17);
    node.remove_attribute(attribute);
    node.append_attribute(attribute) = text.c_str();
  }
  static void set(pugi::xml_node node, const char* attribute, const Eigen::Vector3d& v) {
    set(node, attribute, {v[0], v[1], v[2]});
  }
  static void set(pugi::xml_node node, const char* attribute, const Eigen::Quaterniond& q) {
    for (const char* other : {"axisangle", "xyaxes", "zaxis", "euler"}) node.remove_attribute(other);
    set(node, attribute, {q.w(), q.x(), q.y(), q.z()});
  }

  // The placement of a child of a frame at X of its parent, in this parent.
  void place(pugi::xml_node node, const Pose& X) const {
    const std::string kind = node.name();
    if (kind == "joint") {
      const std::string type = effective(node, "type");
      if (type == "free") return;
      const Eigen::Vector3d axis =
          effective(node, "axis").empty() ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : vector(node, "axis");
      set(node, "pos", X.p + X.q * pose_of(node).p);
      if (type != "ball") set(node, "axis", X.q * axis);
    } else if (kind == "body" || kind == "geom" || kind == "site") {
      if (kind != "body" && !effective(node, "fromto").empty()) {
        place_line(node, X);
        return;
      }
      const Pose own = pose_of(node);
      set(node, "pos", X.p + X.q * own.p);
      set(node, "quat", (X.q * own.q).normalized());
    }
  }

  // Between two points; a box or ellipsoid keeps its turn about this line, so it gets a placement instead.
  void place_line(pugi::xml_node node, const Pose& X) const {
    const std::vector<double> v = numbers(node, "fromto", effective(node, "fromto"), 6, 6);
    const Eigen::Vector3d from(v[0], v[1], v[2]), to(v[3], v[4], v[5]);
    const std::string type = effective(node, "type");
    if (type != "box" && type != "ellipsoid") {
      const Eigen::Vector3d a = X.p + X.q * from, b = X.p + X.q * to;
      set(node, "fromto", {a[0], a[1], a[2], b[0], b[1], b[2]});
      return;
    }
    if (!node.attribute("fromto"))
      fail(code::kRobotElement, node, "takes fromto from its class, in a frame; give the element its own");
    const double width = numbers(node, "size", effective(node, "size"), 1, 3)[0];
    node.remove_attribute("fromto");
    set(node, "size", {width, width, 0.5 * (to - from).norm()});
    set(node, "pos", X.p + X.q * (0.5 * (from + to)));
    set(node, "quat", (X.q * from_z(direction(node, "fromto", from - to))).normalized());
  }

  // --- The tree.

  void resolve_in(pugi::xml_node node) {
    for (pugi::xml_node child : elements_of(node)) {
      const std::string name = child.name();
      if (name != "body" && !holds_parts(name)) continue;
      resolve_in(child);
      if (name == "frame") put(child, child, pose_of(child), "");
      if (name == "replicate") replicate(child);
      if (holds_parts(name)) node.remove_child(child);
    }
  }

  // Copies of the children of `of` before it, in its parent.
  void put(pugi::xml_node before, const pugi::xml_node& of, const Pose& X, const std::string& suffix) {
    const std::string childclass = of.attribute("childclass").value();
    for (const pugi::xml_node& child : elements_of(of)) {
      if (++made_ > kMostCopied) fail(code::kRobotElement, of, "makes more than ", kMostCopied, " elements");
      place_in(child, X, before, suffix, childclass);
    }
  }

  void place_in(const pugi::xml_node& child, const Pose& X, pugi::xml_node before, const std::string& suffix,
                const std::string& childclass) {
    const std::string kind = child.name();
    // A copy next to the original still finds the classes around it.
    pugi::xml_node copy = child.parent().insert_copy_after(child, child);
    tell(copy, child);
    place(copy, X);
    if (!childclass.empty() && (kind == "geom" || kind == "joint" || kind == "site") && !copy.attribute("class"))
      copy.append_attribute("class") = childclass.c_str();
    if (!childclass.empty() && kind == "body" && !copy.attribute("childclass"))
      copy.append_attribute("childclass") = childclass.c_str();
    if (!suffix.empty()) rename(copy, suffix);
    before.parent().insert_move_before(copy, before);
  }

  void tell(const pugi::xml_node& copy, const pugi::xml_node& of) {
    copied_(copy, of);
    const std::vector<pugi::xml_node> copies = elements_of(copy), originals = elements_of(of);
    for (std::size_t k = 0; k < copies.size(); ++k) tell(copies[k], originals[k]);
  }

  void rename(const pugi::xml_node& node, const std::string& suffix) {
    ++made_;
    if (pugi::xml_attribute name = node.attribute("name")) name = (name.value() + suffix).c_str();
    for (const pugi::xml_node& child : elements_of(node)) rename(child, suffix);
  }

  static void collect(const pugi::xml_node& node, NamesByKind& names) {
    for (const pugi::xml_node& child : elements_of(node)) {
      if (child.attribute("name")) names[kind_of_part(child)].insert(child.attribute("name").value());
      collect(child, names);
    }
  }

  // Copy i is turned by i euler, and placed where the one before and its offset, turned with that one, lead.
  void replicate(pugi::xml_node node) {
    const std::vector<double> given = numbers(node, "count", node.attribute("count").value(), 1, 1);
    const double count = given[0];
    if (!(count >= 1.0 && count <= static_cast<double>(kMostCopied) && count == std::floor(count)))
      fail(code::kRobotNumber, node, "count is no whole number from 1 to ", kMostCopied);
    const Eigen::Vector3d offset = node.attribute("offset") ? vector(node, "offset") : Eigen::Vector3d(0, 0, 0);
    const Eigen::Vector3d turn = node.attribute("euler") ? vector(node, "euler") : Eigen::Vector3d(0, 0, 0);
    std::vector<std::string> suffixes;
    const std::string digits = std::to_string(static_cast<int>(count));
    Pose X;
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const std::string number = std::to_string(i);
      suffixes.push_back(node.attribute("sep").value() + std::string(digits.size() - number.size(), '0') + number);
      X.q = euler(i * turn);
      put(node, node, X, suffixes.back());
      X.p += X.q * offset;
    }
    NamesByKind names;
    collect(node, names);
    for (const char* section : {"tendon", "contact", "equality", "actuator"})
      for (const pugi::xml_node& one : mujoco_.children(section)) replicate_references(one, names, suffixes);
  }

  static bool refers(const pugi::xml_node& node, const NamesByKind& names) {
    for (const pugi::xml_attribute& a : node.attributes())
      if (is_reference(a, names)) return true;
    const std::vector<pugi::xml_node> parts = elements_of(node);
    return std::any_of(parts.begin(), parts.end(), [&](const pugi::xml_node& part) { return refers(part, names); });
  }
  static bool is_reference(const pugi::xml_attribute& a, const NamesByKind& names) {
    const auto kind = references().find(a.name());
    if (kind == references().end()) return false;
    const auto found = names.find(kind->second);
    return found != names.end() && found->second.count(a.value()) > 0;
  }
  static void redirect(const pugi::xml_node& node, const NamesByKind& names, const std::string& suffix) {
    for (pugi::xml_attribute a : node.attributes())
      if (is_reference(a, names)) a = (a.value() + suffix).c_str();
    for (const pugi::xml_node& part : elements_of(node)) redirect(part, names, suffix);
  }

  // Tendons come first: elements that refer to a replicated element are replicated as often.
  void replicate_references(pugi::xml_node section, NamesByKind& names, const std::vector<std::string>& suffixes) {
    for (const pugi::xml_node& node : elements_of(section)) {
      if (!refers(node, names)) continue;
      const std::string name = node.attribute("name").value();
      for (const std::string& suffix : suffixes) {
        if (++made_ > kMostCopied)
          fail(code::kRobotElement, node, "is there more than ", kMostCopied, " times by <replicate>");
        pugi::xml_node copy = section.insert_copy_before(node, node);
        tell(copy, node);
        redirect(copy, names, suffix);
        if (!name.empty()) copy.attribute("name") = (name + suffix).c_str();
      }
      if (std::string(section.name()) == "tendon" && !name.empty()) names["tendon"].insert(name);
      section.remove_child(node);
    }
  }

  pugi::xml_node mujoco_;
  const std::function<Origin(const pugi::xml_node&)>& origin_;
  const std::function<void(const pugi::xml_node&, const pugi::xml_node&)>& copied_;
  bool degrees_ = true;
  std::string sequence_ = "xyz";
  std::map<std::string, pugi::xml_node> classes_;
  std::vector<pugi::xml_node> tops_;  // the class that contains all others; the last one with a value counts
  std::size_t made_ = 0;
};

}  // namespace

void resolve_frames(pugi::xml_node mujoco, const std::function<Origin(const pugi::xml_node&)>& origin,
                    const std::function<void(const pugi::xml_node&, const pugi::xml_node&)>& copied) {
  Frames(mujoco, origin, copied).resolve();
}

}  // namespace footfall

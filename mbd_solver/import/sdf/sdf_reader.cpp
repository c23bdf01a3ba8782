// SDF, by sdformat: it converts old versions, resolves frames (relative_to, expressed_in) and included models. Lines come from
// the XML. All joints are zero in the reference configuration.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <sdf/sdf.hh>
#include <set>

#include "coupler/base/text.h"
#include "mbd_solver/base/budget.h"
#include "mbd_solver/import/codes.h"
#include "mbd_solver/import/xml_source.h"
#include "mbd_solver/scene/mesh_reader.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestMessage = 300;  // of sdformat [bytes]
constexpr double kNoLimit = 1e15;             // limits beyond it are none

// Elements that are read: sdformat.org/spec. Elements for special simulators are not.
const std::map<std::string, KnownElement>& sdf_elements() {
  static const std::vector<std::string> pose = {"pose"};
  static const std::map<std::string, KnownElement> known = {
      {"sdf", {{"version"}, {"model", "world", "include"}, {"light"}}},
      {"world",
       {{"name"},
        {"model", "gravity", "include", "frame"},
        {"light", "scene", "gui", "physics", "spherical_coordinates", "magnetic_field", "atmosphere"}}},
      {"include", {{"merge"}, {"uri", "name", "pose", "static", "placement_frame"}, {}}},
      {"model",
       {{"name", "canonical_link", "placement_frame"},
        {"static", "self_collide", "pose", "link", "joint", "frame", "model", "include"},
        {"allow_auto_disable", "enable_wind"}}},
      {"frame", {{"name", "attached_to"}, {"pose"}, {}}},
      {"link",
       {{"name"},
        {"inertial", "collision", "visual", "pose"},
        {"light", "enable_wind", "velocity_decay", "must_be_base_link"}}},
      {"inertial", {{"auto"}, {"mass", "pose", "inertia", "density"}, {}}},
      {"collision", {{"name"}, {"pose", "geometry", "surface", "density"}, {"max_contacts", "laser_retro"}}},
      {"visual",
       {{"name"},
        {"pose", "geometry"},
        {"material", "cast_shadows", "transparency", "laser_retro", "meta", "visibility_flags"}}},
      {"geometry", {{}, {"box", "sphere", "cylinder", "capsule", "ellipsoid", "mesh", "plane", "empty"}, {}}},
      {"mesh", {{}, {"uri", "scale"}, {}}},
      {"surface", {{}, {"friction"}, {}}},
      {"friction", {{}, {"ode"}, {}}},
      {"ode", {{}, {"mu"}, {}}},
      {"joint",
       {{"name", "type"},
        {"parent", "child", "pose", "axis", "axis2", "thread_pitch", "gearbox_ratio", "gearbox_reference_body"},
        {}}},
      {"axis", {{}, {"xyz", "limit", "dynamics", "use_parent_model_frame"}, {}}},
      {"axis2", {{}, {"xyz", "limit", "dynamics", "use_parent_model_frame"}, {}}},
      {"limit", {{}, {"lower", "upper", "effort", "velocity"}, {}}},
      {"axis/dynamics", {{}, {"damping", "friction", "spring_reference", "spring_stiffness"}, {}}},
      {"axis2/dynamics", {{}, {"damping", "friction", "spring_reference", "spring_stiffness"}, {}}},
  };
  return known;
}

Eigen::Vector3d vector(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }
RigidFrame placement(const ignition::math::Pose3d& pose) {
  const ignition::math::Quaterniond& q = pose.Rot();
  return {vector(pose.Pos()), Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized().toRotationMatrix()};
}

// Silences the output of sdformat in addition to the errors that it returns.
class Hush {
 public:
  Hush() : kept_(dup(STDERR_FILENO)) {
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nothing >= 0) dup2(nothing, STDERR_FILENO);
    if (nothing >= 0) close(nothing);
  }
  ~Hush() {
    if (kept_ >= 0) dup2(kept_, STDERR_FILENO);
    if (kept_ >= 0) close(kept_);
  }
  Hush(const Hush&) = delete;
  Hush& operator=(const Hush&) = delete;

 private:
  int kept_;
};

class SdfRobot {
 public:
  SdfRobot(const XmlSource& xml, const ImportOptions& options)
      : xml_(xml),
        options_(options),
        files_(limit::kIncludedFiles, xml.file()),
        bytes_(limit::kIncludedText, xml.file()) {
    robot_.format = "SDF";
    robot_.file = xml.file();
  }

  Robot made() {
    const std::string text = text_for_sdformat();
    list_unread(xml_, sdf_elements(), robot_);
    sdf::Console::Instance()->SetQuiet(true);
    sdf::ParserConfig config;
    config.SetFindCallback([this](const std::string& uri) { return found_model(uri); });
    sdf::Root root;
    sdf::Errors errors;
    try {
      const Hush hush;
      errors = root.LoadSdfString(text, config);
    } catch (const std::exception& error) {
      throw InputError(code::kRobotRefused, xml_.origin(xml_.root()).place() + ": sdformat refuses the file: " +
                                                error.what() + "; correct it, or export it again");
    }
    report(errors);
    std::vector<std::pair<const sdf::Model*, RigidFrame>> models;
    if (root.Model() != nullptr) {  // the pose of its placement frame
      const sdf::Model& model = *root.Model();
      RigidFrame X = placement(model.RawPose());
      if (const std::string& frame = model.PlacementFrameName(); !frame.empty())
        X = X * frame_in_model(model, frame).inverse();
      models.emplace_back(&model, X);
    }
    for (std::uint64_t w = 0; w < root.WorldCount(); ++w) {
      const sdf::World& world = *root.WorldByIndex(w);
      if (w > 0) {
        robot_.leave_out({xml_.file(), 1}, "world \"" + world.Name() + "\"",
                         "a scene is one world: the first one counts");
        continue;
      }
      robot_.gravity = vector(world.Gravity());
      robot_.name = world.Name();
      for (std::uint64_t k = 0; k < world.ModelCount(); ++k) {
        const sdf::Model* model = world.ModelByIndex(k);
        ignition::math::Pose3d pose = model->RawPose();
        report(model->SemanticPose().Resolve(pose));
        models.emplace_back(model, placement(pose));
      }
    }
    if (models.empty()) xml_.fail(code::kRobotElement, xml_.root(), "has no <model>, expected a robot");
    if (models.size() == 1) robot_.name = models[0].first->Name();
    for (const auto& [model, X] : models) robot_.touches_itself = robot_.touches_itself || collides_with_itself(*model);
    for (const auto& [model, X] : models) add_model(*model, X, models.size() > 1 ? model->Name() + "::" : "", false);
    return std::move(robot_);
  }

 private:
  // Throws InputError for the first error that is not about an inertia: tidy_robot() judges these.
  void report(const sdf::Errors& errors) const {
    for (const sdf::Error& error : errors) {
      if (error.Code() == sdf::ErrorCode::LINK_INERTIA_INVALID) continue;
      std::string text = error.Message();
      std::replace(text.begin(), text.end(), '\n', ' ');
      if (text.size() > kLongestMessage)
        text = text.substr(0, kLongestMessage) + " ...";  // it may quote the whole file
      const std::string place = xml_.file() + ":" + std::to_string(error.LineNumber().value_or(line_of_name_in(text)));
      throw InputError(code::kRobotRefused, place + ": sdformat refuses the file: " + trimmed(text) +
                                                "; correct it there (sdformat.org/spec)");
    }
  }

  // Line of the element whose name the message quotes.
  int line_of_name_in(const std::string& message) const {
    pugi::xml_node found = xml_.root();
    for_each_below(xml_.root(), [&](const pugi::xml_node& node) {
      const std::string name = node.attribute("name").value();
      if (!name.empty() && message.find("[" + name + "]") != std::string::npos) found = node;
    });
    return xml_.origin(found).line;
  }

  std::string found_model(const std::string& uri) const { return find_model(uri, xml_.file(), options_); }

  // sdformat reads models within models without end: they are counted before.
  void count_model(const std::string& found) {
    files_.take();
    fs::path file = found;
    if (fs::is_directory(file)) {
      const fs::path config = file / "model.config";
      const std::string name = fs::exists(config) ? XmlSource(config.string()).root().child("sdf").text().get() : "";
      file /= name.empty() ? "model.sdf" : name;
    }
    if (!fs::is_regular_file(file)) return;
    std::vector<std::string> uris;
    {
      const XmlSource xml(file.string());
      bytes_.take(xml.text().size());
      for_each_below(xml.root(), [&](const pugi::xml_node& node) {
        if (std::string(node.name()) == "include") uris.push_back(trimmed(node.child("uri").text().get()));
      });
    }
    for (const std::string& uri : uris)
      if (const std::string inner = find_model(uri, file.string(), options_); !inner.empty()) count_model(inner);
  }

  // The text with blanks in the place of: a declaration behind a comment, which sdformat refuses; elements that it
  // would judge and no scene has; includes of missing files.
  std::string text_for_sdformat() {
    std::string text = xml_.text();
    const auto blank = [&](std::size_t from, std::size_t to) {
      for (std::size_t k = from; k < std::min(to, text.size()); ++k)
        if (text[k] != '\n') text[k] = ' ';
    };
    if (const std::size_t from = text.find("<?xml"); from != std::string::npos && from > 0)
      blank(from, text.find("?>", from) + 2);
    std::vector<pugi::xml_node> includes, others, frictions;
    for_each_below(xml_.root(), [&](const pugi::xml_node& node) {
      const std::string name = node.name();
      if (name == "include") includes.push_back(node);
      if (name == "material" || name == "plugin" || name == "sensor") others.push_back(node);
      if (name == "mu" || name == "mu2") frictions.push_back(node);
    });
    // From the element's first character to the end of its tag, which follows its last descendant.
    const auto blank_element = [&](const pugi::xml_node& node) {
      const auto begin = [](const pugi::xml_node& of) {
        return static_cast<std::size_t>(std::max<std::ptrdiff_t>(of.offset_debug(), 1)) - 1;
      };
      pugi::xml_node last = node;
      while (last.last_child()) last = last.last_child();
      const std::size_t open = text.find('>', begin(node));
      if (open == std::string::npos || text[begin(node)] != '<') return;
      const bool empty = text[open - 1] == '/';
      const std::string end = std::string("</") + node.name();
      const std::size_t close = empty ? open : text.find('>', text.find(end, std::max(begin(last), begin(node))));
      if (close != std::string::npos) blank(begin(node), close + 1);
    };
    for (const pugi::xml_node& node : others) blank_element(node);
    for (const pugi::xml_node& node : frictions) {  // old exports have -1 for a friction without limit
      const std::optional<std::vector<double>> mu = numbers_of(node.text().get());
      if (!mu || mu->size() != 1 || !((*mu)[0] < 0.0)) continue;
      if (std::string(node.name()) == "mu")
        robot_.leave_out(xml_.origin(node), "<mu> below zero",
                         "means friction without limit; give the ground or contact its own coefficient");
      blank_element(node);
    }
    for (const pugi::xml_node& include : includes) {
      const std::string uri = trimmed(include.child("uri").text().get());
      const bool plane = uri.find("ground_plane") != std::string::npos;
      const bool sun = uri.size() >= 3 && uri.compare(uri.size() - 3, 3, "sun") == 0;
      if (const std::string found = found_model(uri); !plane && !sun && !found.empty()) {
        count_model(found);
        continue;
      }
      if (plane)
        robot_.plane = true;
      else
        robot_.leave_out(xml_.origin(include), "<include> of \"" + uri + "\"",
                         sun ? "is for pictures" : "there is no such model; give its folder with --package", sun);
      blank_element(include);
    }
    return text;
  }

  // The element of this kind and name; of several, in nested models, the one of sdformat's line. The root where it comes from an
  // included file.
  pugi::xml_node node_of(const char* kind, const std::string& name, const sdf::ElementPtr& element) {
    if (nodes_.empty())
      for_each_below(xml_.root(), [&](const pugi::xml_node& node) {
        nodes_[{node.name(), node.attribute("name").value()}].push_back(node);
      });
    const std::vector<pugi::xml_node>& found = nodes_[{kind, name}];
    for (const pugi::xml_node& node : found)
      if (element && xml_.origin(node).line == element->LineNumber().value_or(0)) return node;
    return found.size() == 1 ? found[0] : xml_.root();
  }

  // The value of an element within others, where the file gives it.
  static std::optional<double> given(sdf::ElementPtr element, std::initializer_list<const char*> path) {
    for (const char* name : path) {
      if (!element || !element->HasElement(name)) return std::nullopt;
      element = element->GetElement(name);
    }
    return element->Get<double>();
  }

  int link_index(const std::string& name) const {
    const auto found = link_places_.find(name);
    return found == link_places_.end() ? -1 : found->second;
  }

  // The frame of a link, joint, frame or nested model; "inner::link" for a part of a nested model.
  RigidFrame frame_in_model(const sdf::Model& model, const std::string& name) const {
    ignition::math::Pose3d pose;
    const std::size_t scope = name.find("::");
    if (const sdf::Model* inner = model.ModelByName(name.substr(0, scope))) {
      report(inner->SemanticPose().Resolve(pose, "__model__"));
      return scope == std::string::npos ? placement(pose)
                                        : placement(pose) * frame_in_model(*inner, name.substr(scope + 2));
    }
    if (const sdf::Link* link = model.LinkByName(name)) report(link->SemanticPose().Resolve(pose, "__model__"));
    if (const sdf::Joint* joint = model.JointByName(name)) report(joint->SemanticPose().Resolve(pose, "__model__"));
    if (const sdf::Frame* frame = model.FrameByName(name)) report(frame->SemanticPose().Resolve(pose, "__model__"));
    return placement(pose);
  }

  static bool collides_with_itself(const sdf::Model& model) {
    bool does = model.SelfCollide();
    for (std::uint64_t k = 0; k < model.ModelCount(); ++k) does = does || collides_with_itself(*model.ModelByIndex(k));
    return does;
  }

  void add_model(const sdf::Model& model, const RigidFrame& X_DM, const std::string& prefix, bool still) {
    still = still || model.Static();
    const std::size_t first = robot_.links.size();
    for (std::uint64_t k = 0; k < model.LinkCount(); ++k) add_link(*model.LinkByIndex(k), X_DM, prefix, still);
    for (std::uint64_t k = 0; k < model.ModelCount(); ++k) {
      const sdf::Model& inner = *model.ModelByIndex(k);
      ignition::math::Pose3d pose = inner.RawPose();
      report(inner.SemanticPose().Resolve(pose, "__model__"));
      add_model(inner, X_DM * placement(pose), prefix + inner.Name() + "::", still);
    }
    if (still) return;
    for (std::uint64_t k = 0; k < model.JointCount(); ++k) add_joint(*model.JointByIndex(k), X_DM, prefix);
    if (robot_.touches_itself && !model.SelfCollide())  // else no two links touch
      for (std::size_t i = first; i < robot_.links.size(); ++i)
        for (std::size_t j = i + 1; j < robot_.links.size(); ++j)
          robot_.apart.emplace_back(static_cast<int>(i), static_cast<int>(j));
  }

  void add_link(const sdf::Link& link, const RigidFrame& X_DM, const std::string& prefix, bool still) {
    const pugi::xml_node node = node_of("link", link.Name(), link.Element());
    ignition::math::Pose3d pose;
    report(link.SemanticPose().Resolve(pose, "__model__"));
    RobotLink made;
    made.origin = xml_.origin(node);
    made.name = prefix + link.Name();
    made.X_DL = X_DM * placement(pose);
    const auto add = [&](const auto& of, const char* kind, bool collides) {
      ignition::math::Pose3d in_link = of.RawPose();
      report(of.SemanticPose().Resolve(in_link, link.Name()));
      add_geometry(made, *of.Geom(), placement(in_link), node.find_child_by_attribute(kind, "name", of.Name().c_str()),
                   collides);
    };
    for (std::uint64_t k = 0; k < link.CollisionCount(); ++k) {
      const sdf::Collision& of = *link.CollisionByIndex(k);
      add(of, "collision", true);
      if (const std::optional<double> mu = given(of.Element(), {"surface", "friction", "ode", "mu"}))
        made.friction = mu;
    }
    for (std::uint64_t k = 0; k < link.VisualCount(); ++k) add(*link.VisualByIndex(k), "visual", false);
    if (still) {
      if (!made.collisions.empty())
        robot_.leave_out(made.origin, "link \"" + made.name + "\" of a static model",
                         "is fixed; the ground of a scene is one level plane, or grains");
      return;
    }
    if (const pugi::xml_node inertial = node.child("inertial"); inertial.attribute("auto").as_bool()) {
      add_solids(made, node, inertial);
    } else {
      take_inertial(made, link);
    }
    if (!std::isfinite(made.mass) || !made.inertia.allFinite() || !made.X_DL.p.allFinite() || !made.X_DL.R.allFinite())
      throw InputError(code::kRobotNumber,
                       made.origin.place() + ": link \"" + made.name + "\" has a number that is not finite");
    link_places_.emplace(made.name, static_cast<int>(robot_.links.size()));
    robot_.links.push_back(made);
  }

  // <inertial auto="true"> of SDF 1.11, which the library does not read: inertia of the collisions, by their densities.
  void add_solids(RobotLink& made, const pugi::xml_node& link, const pugi::xml_node& inertial) {
    constexpr double kUsualDensity = 1000.0;  // of SDF [kg/m3]
    const auto density_of = [&](const pugi::xml_node& of, double otherwise) {
      const pugi::xml_node given = of.child("density");
      if (!given) return otherwise;
      const std::optional<std::vector<double>> density = numbers_of(given.text().get());
      if (!density || density->size() != 1 || !((*density)[0] > 0.0))
        xml_.fail(code::kRobotNumber, given, "is no number above zero [kg/m3]");
      return (*density)[0];
    };
    const double usual = density_of(inertial, kUsualDensity);
    const std::vector<RobotGeometry> all = made.collisions;
    for (const RobotGeometry& solid : all) {
      double density = usual;
      for (const pugi::xml_node& collision : link.children("collision"))
        if (xml_.origin(collision).line == solid.origin.line && collision.attribute("name").value() == solid.name)
          density = density_of(collision, usual);
      try {
        add_solid(made, solid, density);
      } catch (const InputError& error) {
        robot_.leave_out(solid.origin, "the mass of a collision of link \"" + made.name + "\"", error.what());
      }
    }
    if (!(made.mass > 0.0))
      robot_.leave_out(made.origin, "link \"" + made.name + "\" with inertial auto",
                       "has no collision of which a mass follows");
  }

  void take_inertial(RobotLink& made, const sdf::Link& link) {
    const ignition::math::Inertiald& inertial = link.Inertial();
    const RigidFrame X_LI = placement(inertial.Pose());
    const ignition::math::Matrix3d I = inertial.MassMatrix().Moi();
    Eigen::Matrix3d moments;
    for (unsigned r = 0; r < 3; ++r)
      for (unsigned c = 0; c < 3; ++c) moments(r, c) = I(r, c);
    made.mass = inertial.MassMatrix().Mass();
    made.centre = X_LI.p;
    made.inertia = X_LI.R * moments * X_LI.R.transpose();
    if (!link.Element()->HasElement("inertial"))
      robot_.leave_out(made.origin, "link \"" + made.name + "\" without inertial",
                       "has the 1 kg and 1 kg m2 that SDF gives it");
  }

  void add_geometry(RobotLink& link, const sdf::Geometry& geometry, const RigidFrame& X_LG, const pugi::xml_node& node,
                    bool collides) {
    RobotGeometry made;
    made.origin = node ? xml_.origin(node) : link.origin;
    made.name = node.attribute("name").value();
    made.X_LG = X_LG;
    switch (geometry.Type()) {
      case sdf::GeometryType::BOX:
        made.kind = GeometryKind::kBox;
        made.size = vector(geometry.BoxShape()->Size());
        break;
      case sdf::GeometryType::SPHERE:
        made.kind = GeometryKind::kSphere;
        made.radius = geometry.SphereShape()->Radius();
        break;
      case sdf::GeometryType::CYLINDER:
        made.kind = GeometryKind::kCylinder;
        made.radius = geometry.CylinderShape()->Radius();
        made.length = geometry.CylinderShape()->Length();
        break;
      case sdf::GeometryType::CAPSULE:
        made.kind = GeometryKind::kCapsule;
        made.radius = geometry.CapsuleShape()->Radius();
        made.length = geometry.CapsuleShape()->Length();
        break;
      case sdf::GeometryType::ELLIPSOID:
        made.kind = GeometryKind::kMesh;
        made.size = 2.0 * vector(geometry.EllipsoidShape()->Radii());
        made.mesh = sphere_mesh(1.0, 0.5);
        for (Eigen::Vector3d& x : made.mesh.vertices) x = x.cwiseProduct(vector(geometry.EllipsoidShape()->Radii()));
        break;
      case sdf::GeometryType::MESH:
        made.kind = GeometryKind::kMesh;
        made.scale = vector(geometry.MeshShape()->Scale());
        made.file = find_mesh(geometry.MeshShape()->Uri(), xml_.file(), options_);
        if (made.file.empty()) made.name = geometry.MeshShape()->Uri();
        if (!geometry.MeshShape()->Submesh().empty())
          robot_.leave_out(made.origin, "submesh \"" + geometry.MeshShape()->Submesh() + "\"",
                           "the whole mesh is taken");
        break;
      case sdf::GeometryType::PLANE:
        if (collides) robot_.plane = true;
        return;
      default:
        if (node && collides)
          robot_.leave_out(made.origin, title_of(node), "has no surface of a kind that a scene knows");
        return;
    }
    if (made.size.minCoeff() < 0.0 || made.radius < 0.0 || made.length < 0.0)
      throw InputError(code::kRobotNumber,
                       made.origin.place() + ": a geometry of link \"" + link.name + "\" has a negative size [m]");
    robot_.add_geometry(link, made, collides);
  }

  RobotCoordinate coordinate(const sdf::JointAxis& axis, const char* name, const RobotJoint& of) {
    RobotCoordinate q;
    q.name = name;
    if (axis.Lower() > -kNoLimit) q.lower = axis.Lower();
    if (axis.Upper() < kNoLimit) q.upper = axis.Upper();
    q.damping = std::max(0.0, axis.Damping());
    q.friction = std::max(0.0, axis.Friction());
    q.stiffness = std::max(0.0, axis.SpringStiffness());
    q.rest = axis.SpringReference();
    if (axis.Effort() > 0.0 && axis.Effort() < kNoLimit) q.effort = axis.Effort();
    q.without_effort = axis.Effort() == 0.0;
    if (options_.hold && q.without_effort)
      robot_.leave_out(of.origin, "<effort> of joint \"" + of.name + "\"", kWithoutEffort);
    if (axis.MaxVelocity() > 0.0 && axis.MaxVelocity() < kNoLimit) q.speed = axis.MaxVelocity();
    return q;
  }

  Eigen::Vector3d axis_in_D(const sdf::JointAxis& axis, const RigidFrame& X_DM) const {
    ignition::math::Vector3d xyz;
    report(axis.ResolveXyz(xyz, "__model__"));
    return (X_DM.R * vector(xyz)).normalized();
  }

  bool has_laws(const RobotCoordinate& q) const {
    return q.lower || q.upper || q.damping > 0.0 || q.friction > 0.0 || q.stiffness > 0.0;
  }

  void add_joint(const sdf::Joint& joint, const RigidFrame& X_DM, const std::string& prefix) {
    const pugi::xml_node node = node_of("joint", joint.Name(), joint.Element());
    std::string parent, child;
    report(joint.ResolveParentLink(parent));
    report(joint.ResolveChildLink(child));
    ignition::math::Pose3d pose;
    report(joint.SemanticPose().Resolve(pose, "__model__"));
    RobotJoint made;
    made.origin = xml_.origin(node);
    made.name = prefix + joint.Name();
    made.parent = parent == "world" ? -1 : link_index(prefix + parent);
    made.child = link_index(prefix + child);
    made.point = X_DM * placement(pose).p;
    if (made.child < 0 || (made.parent < 0 && parent != "world"))
      throw InputError(code::kRobotName,
                       made.origin.place() + ": " + title_of(node) + " names a link that moves with no model here");
    made.loop = held_.count(made.child) > 0;
    const sdf::JointType type = joint.Type();
    const bool two = type == sdf::JointType::UNIVERSAL || type == sdf::JointType::REVOLUTE2;
    const bool one = two || type == sdf::JointType::REVOLUTE || type == sdf::JointType::CONTINUOUS ||
                     type == sdf::JointType::PRISMATIC || type == sdf::JointType::SCREW ||
                     type == sdf::JointType::GEARBOX;
    if ((one && joint.Axis(0) == nullptr) || (two && joint.Axis(1) == nullptr))
      throw InputError(code::kRobotElement, made.origin.place() + ": " + title_of(node) + " has no <" +
                                                (joint.Axis(0) == nullptr ? "axis" : "axis2") + ">, expected one");
    if (joint.Axis(0) != nullptr) made.axis = axis_in_D(*joint.Axis(0), X_DM);
    switch (type) {
      case sdf::JointType::FIXED: break;
      case sdf::JointType::BALL: made.kind = RobotJointKind::kSpherical; break;
      case sdf::JointType::REVOLUTE:
      case sdf::JointType::CONTINUOUS:
        made.kind = RobotJointKind::kRevolute;
        made.coordinates.push_back(coordinate(*joint.Axis(0), "angle", made));
        if (joint.Type() == sdf::JointType::CONTINUOUS) {
          made.coordinates[0].lower.reset();
          made.coordinates[0].upper.reset();
        }
        break;
      case sdf::JointType::PRISMATIC:
        made.kind = RobotJointKind::kPrismatic;
        made.coordinates.push_back(coordinate(*joint.Axis(0), "displacement", made));
        break;
      case sdf::JointType::SCREW: add_screw(made, joint); return;
      case sdf::JointType::UNIVERSAL:
      case sdf::JointType::REVOLUTE2: add_two_axes(made, joint, X_DM); return;
      case sdf::JointType::GEARBOX: add_gearbox(made, joint, node, X_DM); return;
      default: robot_.leave_out(made.origin, title_of(node), "a scene has no such joint"); return;
    }
    push(made);
  }

  void push(const RobotJoint& joint) {
    held_.insert(joint.child);
    robot_.joints.push_back(joint);
  }

  // angle = -thread_pitch displacement, thread_pitch in rad/m.
  void add_screw(RobotJoint made, const sdf::Joint& joint) {
    made.kind = RobotJointKind::kCylindrical;
    made.coordinates.push_back(coordinate(*joint.Axis(0), "angle", made));
    made.coordinates.push_back({});
    made.coordinates.back().name = "displacement";
    const double pitch = joint.ThreadPitch();
    if (!(std::abs(pitch) > 0.0 && std::isfinite(pitch)))
      throw InputError(code::kRobotNumber,
                       made.origin.place() + ": joint \"" + made.name + "\" has a thread_pitch of zero [rad/m]");
    RobotGear gear;
    gear.origin = made.origin;
    gear.name = made.name + "_thread";
    const int index = static_cast<int>(robot_.joints.size());
    gear.joints = {index, index};
    gear.coordinates = {"angle", "displacement"};
    gear.factors = {1.0, pitch};
    push(made);
    robot_.gears.push_back(gear);
  }

  // An axis in the parent, then one in the child. A universal joint has no coordinates for laws: these need a link between.
  void add_two_axes(RobotJoint made, const sdf::Joint& joint, const RigidFrame& X_DM) {
    const Eigen::Vector3d axis2 = axis_in_D(*joint.Axis(1), X_DM);
    const RobotCoordinate q1 = coordinate(*joint.Axis(0), "angle", made),
                          q2 = coordinate(*joint.Axis(1), "angle", made);
    const bool right = std::abs(made.axis.dot(axis2)) < 1e-9;
    if (right && !has_laws(q1) && !has_laws(q2)) {
      made.kind = RobotJointKind::kUniversal;
      made.axis2 = axis2;
      push(made);
      return;
    }
    RobotLink between;
    between.origin = made.origin;
    between.name = made.name + "_between";
    between.X_DL = robot_.links[made.child].X_DL;
    const int middle = static_cast<int>(robot_.links.size());
    link_places_.emplace(between.name, middle);
    robot_.links.push_back(between);
    RobotJoint first = made, second = made;
    first.kind = second.kind = RobotJointKind::kRevolute;
    first.child = second.parent = middle;
    first.loop = false;
    first.coordinates = {q1};
    second.axis = axis2;
    second.coordinates = {q2};
    second.name += "_axis2";
    push(first);
    push(second);
  }

  // angle of the child = -ratio times angle of the parent, both about the reference body.
  void add_gearbox(const RobotJoint& made, const sdf::Joint& joint, const pugi::xml_node& node,
                   const RigidFrame& X_DM) {
    const std::string reference = trimmed(node.child("gearbox_reference_body").text().get());
    const double ratio = node.child("gearbox_ratio").text().as_double(1.0);
    const int about = link_index(reference);
    const auto find = [&](int link, const Eigen::Vector3d& axis) -> std::pair<int, double> {
      for (std::size_t k = 0; k < robot_.joints.size(); ++k) {
        const RobotJoint& other = robot_.joints[k];
        if (other.kind != RobotJointKind::kRevolute) continue;
        const bool along = other.parent == about && other.child == link,
                   against = other.parent == link && other.child == about;
        if (along || against)
          return {static_cast<int>(k), (along ? 1.0 : -1.0) * (other.axis.dot(axis) > 0.0 ? 1.0 : -1.0)};
      }
      return {-1, 0.0};
    };
    const Eigen::Vector3d axis2 = joint.Axis(1) != nullptr ? axis_in_D(*joint.Axis(1), X_DM) : made.axis;
    const auto [first, sign1] = find(made.parent, made.axis);
    const auto [second, sign2] = find(made.child, axis2);
    if (about < 0 || first < 0 || second < 0 || ratio == 0.0) {
      robot_.leave_out(made.origin, title_of(node),
                       "its parent and child have no revolute joints at its gearbox_reference_body above it");
      return;
    }
    RobotGear gear;
    gear.origin = made.origin;
    gear.name = made.name;
    gear.joints = {first, second};
    gear.coordinates = {"angle", "angle"};
    gear.factors = {sign1 * ratio, sign2};
    robot_.gears.push_back(gear);
  }

  const XmlSource& xml_;
  const ImportOptions& options_;
  Robot robot_;
  ReadBudget files_, bytes_;                                                          // of all models that are included
  std::map<std::pair<std::string, std::string>, std::vector<pugi::xml_node>> nodes_;  // by element and name
  std::map<std::string, int> link_places_;
  std::set<int> held_;  // links that are the child of a joint
};

}  // namespace

Robot read_sdf(const std::string& file, const ImportOptions& options) {
  const XmlSource xml(file);
  return SdfRobot(xml, options).made();
}

}  // namespace footfall

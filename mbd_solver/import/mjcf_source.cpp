// Prepares MJCF for the library, which reads the schema of its own version alone: a message about an unknown attribute takes
// this attribute out, and the library tries again.
#include "mbd_solver/import/mjcf_source.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>

#include "coupler/base/concat.h"
#include "coupler/base/text.h"
#include "mbd_solver/import/codes.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestInclude = 20;
constexpr int kMostTakenOut = 300;

void for_each(pugi::xml_node node, const std::function<void(pugi::xml_node)>& action) {
  for (pugi::xml_node child = node.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child.type() == pugi::node_element) {
      for_each(child, action);
      action(child);
    }
    child = next;
  }
}

bool is_one_of(const std::string& word, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* one) { return word == one; });
}

// After "key": the text in quotes.
std::string quoted_after(const std::string& message, const std::string& key) {
  const std::size_t at = message.find(key);
  if (at == std::string::npos) return "";
  const std::size_t open = message.find('\'', at + key.size());
  if (open == std::string::npos) return "";
  return message.substr(open + 1, message.find('\'', open + 1) - open - 1);
}

}  // namespace

MjcfSource::MjcfSource(const std::string& file, const ImportOptions& options, Robot& robot)
    : options_(options),
      robot_(robot),
      folder_(fs::absolute(file).parent_path().string()),
      files_(limit::kIncludedFiles, file),
      bytes_(limit::kIncludedText, file),
      parts_(limit::kXmlParts, file) {
  sources_.push_back(std::make_unique<XmlSource>(file));
  copy(merged_, sources_.front()->root(), *sources_.front(), 0);
  take_what_is_for_looks();
  take_option();
  resolve_frames(
      merged_.document_element(), [this](const pugi::xml_node& node) { return origin(node); },
      [this](const pugi::xml_node& made, const pugi::xml_node& of) { origins_[made.hash_value()] = origin(of); });
  name_assets();
  rewrite_actuators();
}

void MjcfSource::copy(pugi::xml_node into, const pugi::xml_node& node, const XmlSource& xml, int depth) {
  pugi::xml_node made = into.append_child(node.name());
  for (const pugi::xml_attribute& a : node.attributes()) made.append_attribute(a.name()) = a.value();
  origins_[made.hash_value()] = xml.origin(node);
  add_children(made, node, xml, depth);
}

void MjcfSource::add_children(pugi::xml_node into, const pugi::xml_node& of, const XmlSource& xml, int depth) {
  for (const pugi::xml_node& child : of.children()) {
    if (child.type() != pugi::node_element) continue;
    if (std::string(child.name()) != "include") {
      copy(into, child, xml, depth);
      continue;
    }
    const std::string name = child.attribute("file").value();
    const fs::path path = fs::path(name).is_absolute() ? fs::path(name) : fs::path(folder_) / name;
    std::error_code error;
    if (name.empty() || !fs::is_regular_file(path, error))
      xml.fail(code::kRobotName, child, "includes \"", name.substr(0, 100),
               "\", which is no file; expected a file relative to the folder of this file");
    if (depth >= kDeepestInclude)
      xml.fail(code::kRobotTree, child, "includes files more than ", kDeepestInclude, " deep; they include each other");
    files_.take();
    sources_.push_back(std::make_unique<XmlSource>(path.lexically_relative(fs::current_path()).string()));
    const XmlSource& included = *sources_.back();
    bytes_.take(included.text().size());
    parts_.take(xml_parts(included.text()));
    add_children(into, included.root(), included, depth + 1);
  }
}

Origin MjcfSource::origin(const pugi::xml_node& node) const {
  for (pugi::xml_node at = node; at; at = at.parent())
    if (const auto found = origins_.find(at.hash_value()); found != origins_.end()) return found->second;
  return {robot_.file, 1};
}

void MjcfSource::leave_out(const pugi::xml_node& node, const std::string& why, bool looks) {
  robot_.leave_out(origin(node), title_of(node), why, looks);
}

std::vector<pugi::xml_node> MjcfSource::children_of(const char* section) const {
  std::vector<pugi::xml_node> nodes;
  for (const pugi::xml_node& one : root().children(section))
    for (const pugi::xml_node& child : one.children())
      if (child.type() == pugi::node_element) nodes.push_back(child);
  return nodes;
}

std::vector<pugi::xml_node> MjcfSource::bodies() const {
  std::vector<pugi::xml_node> nodes{root().child("worldbody")};
  const std::function<void(const pugi::xml_node&)> walk = [&](const pugi::xml_node& of) {
    for (const pugi::xml_node& body : of.children("body")) {
      nodes.push_back(body);
      walk(body);
    }
  };
  for (const pugi::xml_node& world : root().children("worldbody")) walk(world);
  return nodes;
}

void MjcfSource::take_what_is_for_looks() {
  pugi::xml_node mujoco = merged_.document_element();
  for (pugi::xml_node section = mujoco.first_child(); section;) {
    const pugi::xml_node next = section.next_sibling();
    const std::string name = section.name();
    if (is_one_of(name, {"visual", "statistic", "size"})) {
      leave_out(section, "is for the pictures and the memory of MuJoCo", true);
      mujoco.remove_child(section);
    } else if (name == "sensor") {
      for (const pugi::xml_node& sensor : section.children())
        robot_.leave_out(origin(sensor), title_of(sensor) + " of <sensor>",
                         "a scene has signals of its history instead");
      mujoco.remove_child(section);
    } else if (is_one_of(name, {"custom", "deformable", "extension"})) {
      for (const pugi::xml_node& one : section.children())
        robot_.leave_out(origin(one), title_of(one) + " of <" + name + ">",
                         name == "custom" ? "is for other programs" : "a scene has no such part", name == "custom");
      mujoco.remove_child(section);
    }
    section = next;
  }
  for_each(mujoco, [&](pugi::xml_node node) {
    const std::string name = node.name(), above = node.parent().name();
    for (const char* attribute : {"material", "rgba", "texture"})
      if (is_one_of(name, {"geom", "site", "mesh", "tendon", "spatial", "fixed"})) node.remove_attribute(attribute);
    const bool skin = name == "skin";
    if (above == "asset" && is_one_of(name, {"texture", "material"})) {
      leave_out(node, "a scene has no colours and textures", true);
      node.parent().remove_child(node);
    } else if (above == "default" && is_one_of(name, {"material", "camera", "light"})) {
      node.parent().remove_child(node);
    } else if (is_one_of(name, {"camera", "light"}) && is_one_of(above, {"body", "worldbody", "frame", "replicate"})) {
      leave_out(node, "is for pictures", true);
      node.parent().remove_child(node);
    } else if (is_one_of(name, {"composite", "flexcomp", "flex"}) || skin) {
      leave_out(node, "a scene has no soft bodies of many parts; see flexible bodies", skin);
      node.parent().remove_child(node);
    } else if (name == "attach" || (name == "model" && above == "asset")) {
      throw InputError(code::kRobotRefused, origin(node).place(), ": ", title_of(node),
                       " is of later versions than MuJoCo 2.2.2, which reads the file; load it there, save it by "
                       "mj_saveLastXML, which resolves such elements, and import that file");
    } else if (name == "adhesion" && above == "actuator" && !node.attribute("ctrlrange")) {
      node.append_attribute("ctrlrange") = "0 1";  // MuJoCo 2.2.2 requires it here, later versions use the class
    } else if (name == "plugin") {
      leave_out(node, "is code of MuJoCo");
      node.parent().remove_child(node);
    }
  });
  for (pugi::xml_node keyframe : mujoco.children("keyframe")) {
    int count = 0;
    for (pugi::xml_node key : keyframe.children("key"))
      if (++count > 1) leave_out(key, "a scene starts once: the first keyframe counts");
  }
}

// The part of <option> that changes the motion of a mechanism without contacts.
void MjcfSource::take_option() {
  for (pugi::xml_node option : merged_.document_element().children("option")) {
    std::vector<std::string> gone;
    for (const pugi::xml_attribute& a : option.attributes())
      if (!is_one_of(a.name(), {"gravity", "wind", "density", "viscosity"})) gone.emplace_back(a.name());
    if (!gone.empty()) {
      leave_out(option, "numerical options of MuJoCo: " + joined(gone), true);
      for (const std::string& name : gone) option.remove_attribute(name.c_str());
    }
    for (pugi::xml_node flag : option.children("flag")) {
      gone.clear();
      for (const pugi::xml_attribute& a : flag.attributes())
        if (!is_one_of(a.name(), {"gravity", "contact", "constraint", "equality", "limit", "actuation", "passive"}))
          gone.emplace_back(a.name());
      if (!gone.empty()) leave_out(flag, "numerical options of MuJoCo: " + joined(gone), true);
      for (const std::string& name : gone) flag.remove_attribute(name.c_str());
    }
  }
}

// Meshes and height fields get the whole path of their file; those that are not there go, with the geoms that are made of them.
void MjcfSource::name_assets() {
  pugi::xml_node mujoco = merged_.document_element();
  std::string folder;
  bool strip = false;
  for (pugi::xml_node one : mujoco.children("compiler")) {
    for (const char* name : {"assetdir", "meshdir"})
      if (const pugi::xml_attribute a = one.attribute(name)) folder = a.value();
    strip = strip || std::string(one.attribute("strippath").value()) == "true";
    for (const char* name : {"assetdir", "meshdir", "texturedir", "strippath"}) one.remove_attribute(name);
  }
  // A range alone is a limit, as in all later versions; earlier versions also required `limited`.
  pugi::xml_node compiler = mujoco.child("compiler");
  if (!compiler) compiler = mujoco.prepend_child("compiler");
  bool said = false;
  for (const pugi::xml_node& one : mujoco.children("compiler")) said = said || one.attribute("autolimits");
  if (!said) compiler.append_attribute("autolimits") = "true";
  read_height_fields(folder, strip);
  std::vector<std::string> missing;
  for (pugi::xml_node asset : mujoco.children("asset"))
    for (pugi::xml_node mesh = asset.child("mesh"); mesh;) {
      pugi::xml_node next = mesh.next_sibling("mesh");
      const std::string file = mesh.attribute("file").value();
      if (!file.empty()) {
        fs::path path(file);
        if (strip) path = path.filename();
        if (!mesh.attribute("name")) mesh.append_attribute("name") = path.stem().string().c_str();
        const std::string found = asset_file(folder, path.string());
        if (found.empty()) {
          leave_out(mesh, "there is no file \"" + file + "\"; give its folder with --package");
          missing.emplace_back(mesh.attribute("name").value());
          asset.remove_child(mesh);
        } else {
          mesh.attribute("file").set_value(fs::absolute(found).string().c_str());
        }
      }
      mesh = next;
    }
  if (!missing.empty()) without_meshes(missing);
}

std::string MjcfSource::asset_file(const std::string& folder, const std::string& path) const {
  std::vector<fs::path> places = {fs::path(folder_) / folder / path, fs::path(folder) / path, fs::path(folder_) / path};
  for (const std::string& package : options_.packages) places.push_back(fs::path(package) / path);
  for (const fs::path& place : places)
    if (std::string found = find_mesh(place.string(), robot_.file, options_); !found.empty()) return found;
  return "";
}

// Height fields whose heights are numbers of the file, which the library does not read, are read here: from the row of largest y
// on, made to go from 0 to 1.
void MjcfSource::read_height_fields(const std::string& folder, bool strip) {
  pugi::xml_node mujoco = merged_.document_element();
  for (pugi::xml_node asset : mujoco.children("asset"))
    for (pugi::xml_node field = asset.child("hfield"); field;) {
      const pugi::xml_node next = field.next_sibling("hfield");
      fs::path path(field.attribute("file").value());
      if (strip) path = path.filename();
      if (!field.attribute("name")) field.append_attribute("name") = path.stem().string().c_str();
      const std::string name = field.attribute("name").value();
      std::string why;
      if (!path.empty()) {
        const std::string found = asset_file(folder, path.string());
        if (found.empty())
          why = "there is no file \"" + path.string() + "\"; give its folder with --package";
        else
          field.attribute("file").set_value(fs::absolute(found).string().c_str());
      } else if (const pugi::xml_attribute given = field.attribute("elevation")) {
        const int rows = field.attribute("nrow").as_int(), columns = field.attribute("ncol").as_int();
        const std::optional<std::vector<double>> z = numbers_of(given.value());
        if (!z || rows < 1 || columns < 1 ||
            z->size() != static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns))
          throw InputError(code::kRobotNumber, origin(field).place(), ": ", title_of(field),
                           " elevation has other than nrow times ncol finite numbers");
        using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        const Eigen::MatrixXd h = Eigen::Map<const Rows>(z->data(), rows, columns).colwise().reverse();
        const double range = h.maxCoeff() - h.minCoeff();
        elevations_[name] = (h.array() - h.minCoeff()) / (range > 0.0 ? range : 1.0);
        field.remove_attribute("elevation");
      } else {
        why = "the file has no heights of it: a program sets them";
      }
      if (!why.empty()) {
        leave_out(field, why);
        asset.remove_child(field);
        for_each(mujoco, [&](pugi::xml_node geom) {
          if (name != geom.attribute("hfield").value() || name.empty()) return;
          leave_out(geom, "its height field is not there");
          geom.parent().remove_child(geom);
        });
      }
      field = next;
    }
}

Eigen::MatrixXd MjcfSource::elevation(const std::string& field) const {
  const auto found = elevations_.find(field);
  return found == elevations_.end() ? Eigen::MatrixXd() : found->second;
}

void MjcfSource::without_meshes(const std::vector<std::string>& missing) {
  for_each(merged_.document_element(), [&](pugi::xml_node node) {
    const std::string mesh = node.attribute("mesh").value();
    if (mesh.empty() || std::find(missing.begin(), missing.end(), mesh) == missing.end()) return;
    const std::string above = node.parent().name();
    if (above == "default") {
      node.remove_attribute("mesh");
      return;
    }
    leave_out(node, "its mesh \"" + mesh + "\" is not there");
    // A geom without mass may be removed; if it gives the mass of its body, MuJoCo reports what is missing.
    if (std::string(node.name()) == "geom" || std::string(node.name()) == "site") node.parent().remove_child(node);
  });
}

// Gains of motors as later versions write them, for the version of the library: <position kp kv> is a general actuator.
void MjcfSource::rewrite_actuators() {
  for (pugi::xml_node actuator : merged_.document_element().children("actuator"))
    for (pugi::xml_node position : actuator.children("position")) {
      const pugi::xml_attribute kv = position.attribute("kv");
      if (!kv) continue;
      const double gain = position.attribute("kp").as_double(1.0);
      std::ostringstream bias;
      bias.precision(17);
      bias << "0 " << -gain << ' ' << -kv.as_double();
      position.remove_attribute("kv");
      position.remove_attribute("kp");
      position.set_name("general");
      for (const auto& [name, value] : {std::pair{"gaintype", std::string("fixed")},
                                        {"biastype", "affine"},
                                        {"gainprm", number_text(gain, 17)},
                                        {"biasprm", bias.str()}}) {
        position.remove_attribute(name);
        position.append_attribute(name) = value.c_str();
      }
    }
}

std::string MjcfSource::text() {
  std::ostringstream text;
  merged_.document_element().print(text, " ");
  return text.str();
}

// print() writes each element on a separate line, and its end on another one if it has children.
pugi::xml_node MjcfSource::at_printed_line(int line) const {
  int at = 0;
  pugi::xml_node found;
  const std::function<void(const pugi::xml_node&)> walk = [&](const pugi::xml_node& node) {
    if (++at == line) found = node;
    if (!node.first_child()) return;
    for (const pugi::xml_node& child : node.children()) walk(child);
    if (++at == line && !found) found = node;
  };
  walk(merged_.document_element());
  return found;
}

void MjcfSource::take_out(const std::string& message) {
  const std::size_t at = message.find("line ");  // "line 12, column 3", "line = 12, column = -1"
  const std::size_t digit = at == std::string::npos ? at : message.find_first_not_of(" =", at + 5);
  const int line = digit == std::string::npos ? 0 : std::atoi(message.c_str() + digit);
  pugi::xml_node node = line > 0 ? at_printed_line(line) : pugi::xml_node();
  std::string plain = message;
  std::replace(plain.begin(), plain.end(), '\n', ' ');
  const std::string attribute = quoted_after(message, "unrecognized attribute");
  if (node && !attribute.empty() && node.attribute(attribute.c_str()) && ++taken_out_ <= kMostTakenOut) {
    robot_.leave_out(origin(node),
                     title_of(node) + " " + attribute + " = \"" + node.attribute(attribute.c_str()).value() + "\"",
                     "is not known to MuJoCo 2.2.2, which reads the file");
    node.remove_attribute(attribute.c_str());
    return;
  }
  if (!node) {  // "body name 'x' at line n" of later checks, or a name alone
    const std::string name = quoted_after(message, "name");
    for_each(merged_.document_element(), [&](pugi::xml_node one) {
      if (!node && !name.empty() && name == one.attribute("name").value()) node = one;
    });
  }
  throw InputError(code::kRobotRefused, origin(node ? node : root()).place(), ": ", title_of(node ? node : root()),
                   ": MuJoCo 2.2.2 refuses the file: ", trimmed(plain), "; correct it there");
}

}  // namespace footfall

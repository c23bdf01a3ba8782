#pragma once
// The XML of an MJCF file for MuJoCo: included files in their places, without parts that only later versions read,
// parts that no scene can use, and missing meshes. Every element keeps the line that it comes from.

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "mbd_solver/base/budget.h"
#include "mbd_solver/import/xml_source.h"

namespace footfall {

class MjcfSource {
 public:
  // Omitted parts go to robot.not_taken. Throws InputError.
  MjcfSource(const std::string& file, const ImportOptions& options, Robot& robot);

  // The text for the library.
  std::string text();
  // After the library has refused the text: takes out the attribute or element that its message names, and lists it. Throws
  // InputError where the message is about something else.
  void take_out(const std::string& message);

  Origin origin(const pugi::xml_node& node) const;
  // In the order of the compiled model. `section`: of the root, such as "actuator"; all of the same name follow each other.
  std::vector<pugi::xml_node> children_of(const char* section) const;
  std::vector<pugi::xml_node> bodies() const;  // depth first; the first is the worldbody
  // Heights that the file gives as numbers, from 0 to 1, row k at the k-th place along y; empty for other height fields.
  Eigen::MatrixXd elevation(const std::string& field) const;
  pugi::xml_node root() const { return merged_.document_element(); }

 private:
  void copy(pugi::xml_node into, const pugi::xml_node& node, const XmlSource& xml, int depth);
  void add_children(pugi::xml_node into, const pugi::xml_node& of, const XmlSource& xml, int depth);
  void leave_out(const pugi::xml_node& node, const std::string& why, bool looks = false);
  void take_what_is_for_looks();
  void take_option();
  void name_assets();
  void read_height_fields(const std::string& folder, bool strip);
  std::string asset_file(const std::string& folder, const std::string& path) const;
  void without_meshes(const std::vector<std::string>& missing);
  void rewrite_actuators();
  pugi::xml_node at_printed_line(int line) const;

  const ImportOptions& options_;
  Robot& robot_;
  std::string folder_;
  ReadBudget files_, bytes_, parts_;  // of all that are included
  std::vector<std::unique_ptr<XmlSource>> sources_;
  pugi::xml_document merged_;
  std::unordered_map<std::size_t, Origin> origins_;  // by hash of the node
  std::map<std::string, Eigen::MatrixXd> elevations_;
  int taken_out_ = 0;
};

// The elements <frame> and <replicate> of later versions of MJCF than the library's: their contents are put into their
// body, with the placement, names and classes that they define. mujoco.readthedocs.io, XML Reference: frame, replicate.
// mujoco: the root. origin: of an element; copied(copy, of): called for every new element. Throws InputError.
void resolve_frames(pugi::xml_node mujoco, const std::function<Origin(const pugi::xml_node&)>& origin,
                    const std::function<void(const pugi::xml_node&, const pugi::xml_node&)>& copied);

}  // namespace footfall

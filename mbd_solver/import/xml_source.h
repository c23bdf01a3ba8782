#pragma once
// The XML of a robot's file: the place of each element, and elements and attributes that a reader does not know. The only
// file of this folder that includes pugixml.

#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/import/robot.h"

namespace footfall {

// "link "wheel"", or "link" without a name.
std::string title_of(const pugi::xml_node& node);

class XmlSource {
 public:
  // Reads the file. Throws InputError: no file, no well-formed XML, with its line, or more than base/budget.h allows.
  explicit XmlSource(const std::string& file);
  XmlSource(const std::string& file, std::string text);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& file() const { return file_; }
  const std::string& text() const { return text_; }
  Origin origin(const pugi::xml_node& node) const;
  // Throws InputError "file:line: <element "name">: what".
  template <class... Pieces>
  [[noreturn]] void fail(const MessageCode& code, const pugi::xml_node& node, const Pieces&... what) const {
    throw InputError(code, origin(node).place(), ": ", title_of(node), " ", what...);
  }

  // Numbers of an attribute. Throws InputError unless there are `count` finite ones; `otherwise` where it is missing (empty:
  // required).
  std::vector<double> numbers(const pugi::xml_node& node, const char* attribute, std::size_t count,
                              const std::vector<double>& otherwise = {}) const;

 private:
  int line_at(std::ptrdiff_t offset) const;

  std::string file_;
  std::string text_;
  std::vector<std::size_t> line_starts_;
  pugi::xml_document document_;
};

// The parts of an element that a reader knows: its attributes, its children, and the children that serve pictures alone.
struct KnownElement {
  std::vector<std::string> attributes, children, looks;
};
// Adds unknown parts to robot.not_taken. `known`: by name, or by "parent/name" where names are used twice.
void list_unread(const XmlSource& xml, const std::map<std::string, KnownElement>& known, Robot& robot);

// Calls visit(node) for every node below this one, depth first.
template <class Visit>
void for_each_below(const pugi::xml_node& root, const Visit& visit) {
  root.find_node([&](const pugi::xml_node& node) {
    visit(node);
    return false;
  });
}
// Numbers of a text; nothing where one of its words is none, or is not finite.
std::optional<std::vector<double>> numbers_of(const std::string& text);

}  // namespace footfall

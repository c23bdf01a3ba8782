// Reads XML with pugixml, which knows the offset of each element in the text; lines are counted once. Whatever a reader does
// not know is found by walking all elements.
#include "mbd_solver/import/xml_source.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include "coupler/base/concat.h"
#include "coupler/base/files.h"
#include "coupler/base/input_file.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/budget.h"
#include "mbd_solver/base/named_file.h"
#include "mbd_solver/import/codes.h"

namespace footfall {
namespace {

std::string text_of_file(const std::string& file) {
  require_file(file, "a robot: URDF, SDF or MJCF");
  require_regular_file(file, kLargestText);
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) throw InputError(code::kRobotXml, file + ": cannot be read; make it readable");
  return *text;
}

int depth_of(const pugi::xml_node& node) {
  struct Depth : pugi::xml_tree_walker {
    int most = 0;
    bool for_each(pugi::xml_node&) override {
      most = std::max(most, depth());
      return most <= static_cast<int>(limit::kXmlDepth.most);
    }
  } walker;
  pugi::xml_node start = node;
  start.traverse(walker);
  return walker.most;
}

bool is_in(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

XmlSource::XmlSource(const std::string& file) : XmlSource(file, text_of_file(file)) {}

XmlSource::XmlSource(const std::string& file, std::string text) : file_(file), text_(std::move(text)) {
  line_starts_.push_back(0);
  for (std::size_t k = 0; k < text_.size(); ++k)
    if (text_[k] == '\n') line_starts_.push_back(k + 1);
  const auto place = [&](std::ptrdiff_t offset) { return concat(file_, ":", line_at(offset)); };
  ReadBudget parts(limit::kXmlParts, file_), levels(limit::kXmlDepth, file_);
  parts.take(xml_parts(text_));
  const std::size_t zero = text_.find('\0');
  if (zero != std::string::npos)
    throw InputError(code::kRobotXml, place(static_cast<std::ptrdiff_t>(zero)) +
                                          ": a character of value 0, expected XML text; the file is damaged");
  const pugi::xml_parse_result result =
      document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result)
    throw InputError(code::kRobotXml, place(result.offset) + ": is no well-formed XML: " + result.description() +
                                          "; expected a whole URDF, SDF or MJCF file");
  if (!root()) throw InputError(code::kRobotXml, file_ + ":1: has no element, expected a URDF, SDF or MJCF file");
  levels.take(static_cast<std::uint64_t>(depth_of(document_)));
}

int XmlSource::line_at(std::ptrdiff_t offset) const {
  const std::size_t at = std::max<std::ptrdiff_t>(offset, 0);
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), at);
  return static_cast<int>(after - line_starts_.begin());
}

Origin XmlSource::origin(const pugi::xml_node& node) const { return {file_, line_at(node.offset_debug())}; }

std::vector<double> XmlSource::numbers(const pugi::xml_node& node, const char* attribute, std::size_t count,
                                       const std::vector<double>& otherwise) const {
  const pugi::xml_attribute given = node.attribute(attribute);
  if (!given) {
    if (otherwise.empty())
      fail(code::kRobotNumber, node, "has no \"", attribute, "\", expected ", count,
           count == 1 ? " number" : " numbers");
    return otherwise;
  }
  const std::optional<std::vector<double>> values = numbers_of(given.value());
  if (!values || values->size() != count)
    fail(code::kRobotNumber, node, attribute, " is \"", trimmed(given.value()).substr(0, 60), "\", expected ", count,
         count == 1 ? " finite number" : " finite numbers separated by blanks");
  return *values;
}

std::optional<std::vector<double>> numbers_of(const std::string& text) {
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  while (true) {
    while (at != end && blank(*at)) ++at;
    if (at == end) return values;
    if (*at == '+') ++at;
    double value = 0.0;
    std::from_chars_result result = std::from_chars(at, end, value);
    if (result.ec == std::errc::result_out_of_range) {  // 1e-320 is as good as 0
      value = read_number(std::string(at, result.ptr).c_str(), nullptr);
      result.ec = std::errc();
    }
    if (result.ec != std::errc() || !std::isfinite(value) || (result.ptr != end && !blank(*result.ptr)))
      return std::nullopt;
    values.push_back(value);
    at = result.ptr;
  }
}

std::string title_of(const pugi::xml_node& node) {
  const std::string name = node.attribute("name").value();
  return concat("<", node.name(), name.empty() ? "" : " \"" + name.substr(0, 60) + "\"", ">");
}

void list_unread(const XmlSource& xml, const std::map<std::string, KnownElement>& known, Robot& robot) {
  const std::function<void(const pugi::xml_node&, const KnownElement&)> walk = [&](const pugi::xml_node& node,
                                                                                   const KnownElement& element) {
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      const std::string name = attribute.name();
      if (!is_in(element.attributes, name) && name.rfind("xmlns", 0) != 0 && name.find(':') == std::string::npos)
        robot.leave_out(xml.origin(node), title_of(node) + " " + name + " = \"" + attribute.value() + "\"",
                        "the attribute is not read");
    }
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      const std::string name = child.name();
      const bool looks = is_in(element.looks, name);
      if (looks || !is_in(element.children, name)) {
        robot.leave_out(xml.origin(child), title_of(child) + " of " + title_of(node),
                        looks ? "a scene has no colours and textures" : "a scene has no such element", looks);
        continue;
      }
      auto found = known.find(concat(node.name(), "/", name));
      if (found == known.end()) found = known.find(name);
      if (found != known.end()) walk(child, found->second);
    }
  };
  walk(xml.root(), known.at(xml.root().name()));
}

}  // namespace footfall

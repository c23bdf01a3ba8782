// One parser per format.

#include "mbd_solver/fe/fe_mesh.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/fe/model_text.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

using Eigen::Vector3d;

constexpr long kLargestId = 2000000000;
constexpr int kMostIncludes = 8;  // files within files

// --- Elements.

// Corners of an element with so many nodes; 0: there is none.
int corners_of(int dimension, int nodes) {
  if (dimension == 1) return nodes == 2 || nodes == 3 ? 2 : 0;
  if (dimension == 2) return nodes == 3 || nodes == 6 ? 3 : nodes == 4 || nodes == 8 || nodes == 9 ? 4 : 0;
  switch (nodes) {
    case 4:
    case 10: return 4;
    case 5:
    case 13:
    case 14: return 5;
    case 6:
    case 15:
    case 18: return 6;
    case 8:
    case 20:
    case 27: return 8;
    default: return 0;
  }
}

// A mesh that grows by what a parser finds. Names of sets keep the order of their nodes.
class MeshBuilder {
 public:
  template <class Fail>
  void add_node(long id, const Vector3d& x, const Fail& fail) {
    if (!mesh_.index.emplace(id, static_cast<int>(mesh_.ids.size())).second) {
      const Vector3d& before = mesh_.points[static_cast<std::size_t>(mesh_.index.at(id))];
      if (before == x) return;
      fail("node " + std::to_string(id) + " has two places, expected each number once.");
    }
    mesh_.ids.push_back(id);
    mesh_.points.push_back(x);
  }
  // Numbers of nodes; 0 is a node on an edge that is left out. Returns the index of the element, -1 without one.
  template <class Fail>
  int add_element(int dimension, const std::vector<long>& ids, EdgeOrder order, const Fail& fail) {
    MeshElement element;
    element.dimension = dimension;
    element.corners = corners_of(dimension, static_cast<int>(ids.size()));
    element.order = order;
    if (element.corners == 0)
      fail("an element of " + std::to_string(ids.size()) + " nodes in " + std::to_string(dimension) +
           " dimensions, expected a linear or quadratic one.");
    for (std::size_t i = 0; i < ids.size(); ++i)
      element.nodes.push_back(ids[i] == 0 && i >= static_cast<std::size_t>(element.corners) ? -1 : node(ids[i], fail));
    mesh_.elements.push_back(std::move(element));
    return static_cast<int>(mesh_.elements.size()) - 1;
  }
  template <class Fail>
  int node(long id, const Fail& fail) const {
    const auto found = mesh_.index.find(id);
    if (found == mesh_.index.end()) fail("unknown node " + std::to_string(id) + ", expected one that the file lists.");
    return found->second;
  }
  void add_to_set(const std::string& name, int node) {
    if (node >= 0 && seen_[name].insert(node).second) mesh_.sets[name].push_back(node);
  }
  void add_element_to_set(const std::string& name, int element) {
    if (element < 0) return;
    for (const int n : mesh_.elements[static_cast<std::size_t>(element)].nodes) add_to_set(name, n);
  }
  FeMesh& mesh() { return mesh_; }

 private:
  FeMesh mesh_;
  std::map<std::string, std::set<int>> seen_;
};

// --- Abaqus and CalculiX.

// "C3D20R" -> 3 dimensions and 20 nodes. False: a type without a surface, such as springs and masses.
bool type_of(const std::string& name, int& dimension, int& nodes) {
  if (name.rfind("STRI65", 0) == 0) {
    dimension = 2;
    nodes = 6;
    return true;
  }
  static const std::pair<const char*, int> kPrefixes[] = {
      {"C3D", 3}, {"DC3D", 3}, {"SC", 3},  {"AC3D", 3}, {"STRI", 2}, {"SFM3D", 2}, {"M3D", 2}, {"R3D", 2},
      {"CPS", 2}, {"CPE", 2},  {"CAX", 2}, {"DS", 2},   {"S", 2},    {"T3D", 1},   {"T2D", 1}};
  if (name.size() >= 3 && name[0] == 'B' && (name[1] == '2' || name[1] == '3') && std::isdigit(name[2]) != 0) {
    dimension = 1;
    nodes = name[2] == '2' ? 3 : 2;  // B32 is quadratic, B31 and B33 are not
    return true;
  }
  for (const auto& [prefix, d] : kPrefixes) {
    const std::size_t length = std::strlen(prefix);
    if (name.compare(0, length, prefix) != 0 || name.size() == length || std::isdigit(name[length]) == 0) continue;
    dimension = d;
    nodes = std::atoi(name.substr(length, 3).c_str());
    return corners_of(dimension, nodes) > 0;
  }
  return false;
}

struct InpState {
  MeshBuilder mesh;
  std::unordered_map<long, int> elements;  // number -> index
  std::map<std::string, std::vector<int>> element_sets;
  bool in_part = false, part_had_nodes = false;
};

struct InpKeyword {
  std::string name;                           // "NODE"
  std::map<std::string, std::string> values;  // upper-case keys
  std::string value(const std::string& key) const {
    const auto found = values.find(key);
    return found == values.end() ? "" : found->second;
  }
};

InpKeyword keyword_of(ModelText& text) {
  std::string line = trimmed(text.line());
  while (!line.empty() && line.back() == ',' && text.next()) line += trimmed(text.line());
  InpKeyword keyword;
  const std::vector<std::string> cells = split(line, ',');
  keyword.name = upper_case(trimmed(cells[0].substr(1)));
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const std::size_t equals = std::min(cells[i].find('='), cells[i].size());
    std::string value = equals < cells[i].size() ? trimmed(cells[i].substr(equals + 1)) : "";
    if (value.size() > 1 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
    keyword.values[upper_case(trimmed(cells[i].substr(0, equals)))] = value;
  }
  return keyword;
}

bool is_inp_data(const ModelText& text) { return !(!text.line().empty() && text.line()[0] == '*'); }

// Calls `use` with the cells of each data line up to the next keyword.
template <class Use>
void each_data_line(ModelText& text, const Use& use) {
  while (text.next()) {
    if (text.line().compare(0, 2, "**") == 0) continue;
    if (!is_inp_data(text)) return text.back();
    if (!text.blank()) use(text.cells());
  }
}

void inp_elements(ModelText& text, const InpKeyword& keyword, InpState& state) {
  const auto fail = [&](const std::string& what) { text.fail(what); };
  const std::string type = upper_case(keyword.value("TYPE")), set = keyword.value("ELSET");
  int dimension = 0, nodes = 0;
  const bool known = type_of(type, dimension, nodes);
  if (type.empty()) fail("*ELEMENT without TYPE.");
  std::vector<long> numbers;
  each_data_line(text, [&](const std::vector<std::string>& cells) {
    for (const std::string& cell : cells)
      if (!cell.empty()) numbers.push_back(text.whole(cell, 0, kLargestId));
    if (!known) {
      numbers.clear();
      return;
    }
    if (numbers.size() <= static_cast<std::size_t>(nodes)) return;  // goes on in the next line
    if (numbers.size() != static_cast<std::size_t>(nodes) + 1)
      fail("an element of type " + type + " has " + std::to_string(numbers.size() - 1) + " nodes, expected " +
           std::to_string(nodes) + ".");
    const int element = state.mesh.add_element(dimension, {numbers.begin() + 1, numbers.end()}, kAbaqus, fail);
    state.elements[numbers[0]] = element;
    if (!set.empty()) state.element_sets[set].push_back(element);
    numbers.clear();
  });
  if (!numbers.empty())
    fail("the last element of type " + type + " lacks nodes, expected " + std::to_string(nodes) + ".");
}

// NSET or ELSET: numbers, ranges (GENERATE), names of other sets. `numbers`: index by number.
std::vector<int> inp_set(ModelText& text, const InpKeyword& keyword, const std::string& name,
                         const std::unordered_map<long, int>& numbers,
                         const std::map<std::string, std::vector<int>>& sets) {
  if (name.empty()) text.fail("a set without a name.");
  const bool ranges = keyword.values.count("GENERATE") > 0;
  std::vector<int> found;
  each_data_line(text, [&](const std::vector<std::string>& cells) {
    if (ranges) {
      if (cells.size() < 2) text.fail("expected first, last and step of a range.");
      const long first = text.whole(cells[0], 0, kLargestId), last = text.whole(cells[1], 0, kLargestId);
      const long step = cells.size() > 2 && !cells[2].empty() ? text.whole(cells[2], 1, kLargestId) : 1;
      std::vector<std::pair<long, int>> within;
      for (const auto& [id, index] : numbers)
        if (id >= first && id <= last && (id - first) % step == 0) within.emplace_back(id, index);
      std::sort(within.begin(), within.end());
      for (const auto& entry : within) found.push_back(entry.second);
      return;
    }
    for (const std::string& cell : cells) {
      if (cell.empty()) continue;
      if (std::isdigit(static_cast<unsigned char>(cell[0])) == 0) {
        const auto other = std::find_if(sets.begin(), sets.end(),
                                        [&](const auto& s) { return upper_case(s.first) == upper_case(cell); });
        if (other == sets.end()) text.fail("unknown set \"" + cell + "\", expected one that is defined above.");
        found.insert(found.end(), other->second.begin(), other->second.end());
        continue;
      }
      const auto entry = numbers.find(text.whole(cell, 0, kLargestId));
      if (entry != numbers.end()) found.push_back(entry->second);
    }
  });
  return found;
}

void parse_inp(ModelText& text, InpState& state, int depth) {
  const auto fail = [&](const std::string& what) { text.fail(what); };
  while (text.next()) {
    if (text.line().compare(0, 2, "**") == 0 || is_inp_data(text)) continue;
    const InpKeyword keyword = keyword_of(text);
    if (keyword.name == "NODE") {
      const std::string set = keyword.value("NSET");
      if (!upper_case(keyword.value("SYSTEM")).empty() && upper_case(keyword.value("SYSTEM")) != "R")
        fail("nodes in a cylindrical or spherical system, expected x, y, z. Export Cartesian coordinates.");
      if (state.in_part && state.part_had_nodes)
        fail("nodes of a second part, expected one. Export a flat input file (without parts), or merge the parts.");
      each_data_line(text, [&](const std::vector<std::string>& cells) {
        if (cells.size() < 2 || cells.size() > 7) fail("expected a node's number and x, y, z.");
        Vector3d x = Vector3d::Zero();
        for (std::size_t i = 1; i < std::min<std::size_t>(cells.size(), 4); ++i)
          x(static_cast<Eigen::Index>(i) - 1) = cells[i].empty() ? 0.0 : text.number(cells[i]);
        const long id = text.whole(cells[0], 1, kLargestId);
        state.mesh.add_node(id, x, fail);
        if (!set.empty()) state.mesh.add_to_set(set, state.mesh.node(id, fail));
      });
    } else if (keyword.name == "ELEMENT") {
      inp_elements(text, keyword, state);
    } else if (keyword.name == "NSET") {
      const std::string name = keyword.value("NSET");
      if (!keyword.value("ELSET").empty()) {
        for (const int e : state.element_sets[keyword.value("ELSET")]) state.mesh.add_element_to_set(name, e);
        continue;
      }
      for (const int n : inp_set(text, keyword, name, state.mesh.mesh().index, state.mesh.mesh().sets))
        state.mesh.add_to_set(name, n);
    } else if (keyword.name == "ELSET") {
      const std::string name = keyword.value("ELSET");
      const std::vector<int> found = inp_set(text, keyword, name, state.elements, state.element_sets);
      state.element_sets[name].insert(state.element_sets[name].end(), found.begin(), found.end());
    } else if (keyword.name == "PART") {
      state.part_had_nodes = !state.mesh.mesh().ids.empty();
      state.in_part = true;
    } else if (keyword.name == "INSTANCE") {
      each_data_line(text, [&](const std::vector<std::string>&) {
        fail("an instance that is moved, expected a part in its place. Export a flat input file (without parts).");
      });
    } else if (keyword.name == "TRANSFORM") {
      state.mesh.mesh().turned = text.name() + ": *TRANSFORM turns the axes of displacements";
    } else if (keyword.name == "SYSTEM") {
      each_data_line(text, [&](const std::vector<std::string>&) {
        fail("*SYSTEM moves the nodes that follow, expected global coordinates.");
      });
    } else if (keyword.name == "INCLUDE") {
      const std::string name = keyword.value("INPUT");
      if (name.empty()) fail("*INCLUDE without INPUT.");
      if (depth >= kMostIncludes)
        fail("more than " + std::to_string(kMostIncludes) +
             " files within files, expected fewer. Does one name itself?");
      const std::string path = (std::filesystem::path(text.name()).parent_path() / name).string();
      ModelText included(bytes_of_model(path), path);
      parse_inp(included, state, depth + 1);
    }
  }
}

FeMesh inp_mesh(const std::string& bytes, const std::string& file) {
  ModelText text(bytes, file);
  InpState state;
  parse_inp(text, state, 0);
  for (const auto& [name, elements] : state.element_sets)
    for (const int e : elements) state.mesh.add_element_to_set(name, e);
  return std::move(state.mesh.mesh());
}

// --- Nastran.

FeMesh bdf_mesh(const std::string& bytes, const std::string& file) {
  ModelText text(bytes, file);
  NastranCards cards(text);
  MeshBuilder mesh;
  const auto fail = [&](const std::string& what) { text.fail(what); };
  struct Card {
    const char* name;
    int dimension, corners, most;
    std::size_t first;  // field of the first node
  };
  static const Card kCards[] = {{"CTETRA", 3, 4, 10, 3}, {"CPYRAM", 3, 5, 13, 3}, {"CPENTA", 3, 6, 15, 3},
                                {"CHEXA", 3, 8, 20, 3},  {"CTRIA3", 2, 3, 3, 3},  {"CTRIAR", 2, 3, 3, 3},
                                {"CTRIA6", 2, 3, 6, 3},  {"CQUAD4", 2, 4, 4, 3},  {"CQUADR", 2, 4, 4, 3},
                                {"CQUAD8", 2, 4, 8, 3},  {"CBAR", 1, 2, 2, 3},    {"CBEAM", 1, 2, 2, 3},
                                {"CROD", 1, 2, 2, 3}};
  struct Pending {
    const Card* card;
    std::vector<long> ids;
  };
  std::vector<Pending> elements;  // cards have no order
  std::vector<std::pair<std::string, std::vector<long>>> sets;
  while (cards.next()) {
    const std::string& name = cards.fields()[0];
    if (name == "GRID") {
      const long id = cards.whole(1, 1, kLargestId);
      if (cards.number(2, 0.0) != 0.0)
        fail("node " + std::to_string(id) + " is given in coordinate system " + cards.fields()[2] +
             ", expected the basic one (0 or empty). Export global coordinates.");
      if (cards.number(6, 0.0) != 0.0)
        mesh.mesh().turned =
            file + ": node " + std::to_string(id) + " has displacements in coordinate system " + cards.fields()[6];
      mesh.add_node(id, {cards.number(3, 0.0), cards.number(4, 0.0), cards.number(5, 0.0)}, fail);
    } else if (name == "SET1") {
      std::vector<long> ids;
      for (std::size_t i = 2; i < cards.fields().size(); ++i) {
        if (!cards.given(i)) continue;
        if (upper_case(cards.fields()[i]) == "THRU") {
          if (ids.empty()) fail("THRU without a first number.");
          const long last = cards.whole(++i, 1, kLargestId), first = ids.back();
          ids.push_back(-first);  // a range
          ids.push_back(last);
        } else {
          ids.push_back(cards.whole(i, 1, kLargestId));
        }
      }
      sets.emplace_back(std::to_string(cards.whole(1, 1, kLargestId)), ids);
    } else {
      const auto card =
          std::find_if(std::begin(kCards), std::end(kCards), [&](const Card& c) { return name == c.name; });
      if (card == std::end(kCards)) continue;
      Pending pending{card, {}};
      for (int i = 0; i < card->most; ++i) {
        const std::size_t field = card->first + static_cast<std::size_t>(i);
        if (i >= card->corners && !cards.given(field)) {
          pending.ids.push_back(0);
        } else {
          pending.ids.push_back(cards.whole(field, 1, kLargestId));
        }
      }
      const bool linear =
          std::all_of(pending.ids.begin() + card->corners, pending.ids.end(), [](long n) { return n == 0; });
      if (linear) pending.ids.resize(static_cast<std::size_t>(card->corners));
      elements.push_back(std::move(pending));
    }
  }
  for (const Pending& p : elements) mesh.add_element(p.card->dimension, p.ids, kNastran, fail);
  for (const auto& [name, ids] : sets)
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] > 0) {
        const auto node = mesh.mesh().index.find(ids[i]);
        if (node != mesh.mesh().index.end()) mesh.add_to_set(name, node->second);
        continue;
      }
      for (std::size_t n = 0; n < mesh.mesh().ids.size(); ++n)
        if (mesh.mesh().ids[n] > -ids[i] && mesh.mesh().ids[n] < ids[i + 1]) mesh.add_to_set(name, static_cast<int>(n));
    }
  return std::move(mesh.mesh());
}

// --- gmsh.

// Numbers of a file that is text, or binary with the byte order of this machine.
class MshBytes {
 public:
  MshBytes(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  bool binary = false;

  [[noreturn]] void fail(const std::string& what) const {
    const auto lines =
        std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, bytes_.size())), '\n');
    throw InputError(code::kModelFile, file_ + ":" + std::to_string(lines + 1) + ": " + what);
  }
  // The next word, also within binary files.
  std::string word() {
    while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) ++at_;
    const std::size_t from = at_;
    while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_])) == 0) ++at_;
    if (from == at_) fail("the file ends here: it is cut off. Export it again.");
    return bytes_.substr(from, at_ - from);
  }
  std::string rest_of_line() {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string rest = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    return trimmed(rest);
  }
  bool at_end() {
    while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) ++at_;
    return at_ == bytes_.size();
  }
  long integer() { return binary ? raw<std::int32_t>() : whole_word(); }                  // int
  long size() { return binary ? static_cast<long>(raw<std::int64_t>()) : whole_word(); }  // size_t of version 4
  double real() { return binary ? finite(raw<double>()) : real_word(); }
  long whole_word() {
    const std::string text = word();
    char* end = nullptr;
    errno = 0;
    const long value = std::strtol(text.c_str(), &end, 10);
    if (*end != '\0' || errno != 0) fail("\"" + text.substr(0, 40) + "\" is no whole number. Export the mesh again.");
    return value;
  }
  // A number of things of at least `bytes` bytes each.
  long count(long value, std::size_t bytes) {
    if (value < 0 || static_cast<std::size_t>(value) > (bytes_.size() - std::min(at_, bytes_.size())) / bytes + 1)
      fail("announces " + std::to_string(value) +
           " entries, more than the file holds: it is cut off. Export it again.");
    return value;
  }
  // The line break before binary data.
  void begin_data() {
    if (binary && at_ < bytes_.size() && bytes_[at_] == '\r') ++at_;
    if (binary && at_ < bytes_.size() && bytes_[at_] == '\n') ++at_;
  }
  void skip_section(const std::string& name) {
    const std::size_t end = bytes_.find("$End" + name.substr(1), at_);
    if (end == std::string::npos) fail("no \"$End" + name.substr(1) + "\": the file is cut off. Export it again.");
    at_ = end + name.size() + 3;
  }
  void require_end(const std::string& name) {
    const std::string found = word();
    if (found != "$End" + name)
      fail("is \"" + found.substr(0, 40) + "\", expected \"$End" + name + "\". Export the mesh again.");
  }
  template <class Number>
  Number raw() {
    Number value;
    if (bytes_.size() - std::min(at_, bytes_.size()) < sizeof value)
      fail("the file ends here: it is cut off. Export it again.");
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

 private:
  double finite(double value) const {
    if (!std::isfinite(value)) fail("a coordinate is not a finite number. Export the mesh again.");
    return value;
  }
  double real_word() {
    const std::string text = word();
    char* end = nullptr;
    const double value = read_number(text.c_str(), &end);
    if (*end != '\0') fail("\"" + text.substr(0, 40) + "\" is no number. Export the mesh again.");
    return finite(value);
  }

  const std::string& bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
};

// Dimension and number of nodes of an element type of gmsh; nodes 0: unknown.
std::pair<int, int> gmsh_type(long type) {
  static const std::map<long, std::pair<int, int>> kTypes = {
      {1, {1, 2}},  {2, {2, 3}},  {3, {2, 4}},   {4, {3, 4}},   {5, {3, 8}},   {6, {3, 6}},   {7, {3, 5}},
      {8, {1, 3}},  {9, {2, 6}},  {10, {2, 9}},  {11, {3, 10}}, {12, {3, 27}}, {13, {3, 18}}, {14, {3, 14}},
      {15, {0, 1}}, {16, {2, 8}}, {17, {3, 20}}, {18, {3, 15}}, {19, {3, 13}}};
  const auto found = kTypes.find(type);
  return found == kTypes.end() ? std::pair{0, 0} : found->second;
}

class MshFile {
 public:
  MshFile(const std::string& bytes, const std::string& file) : in_(bytes, file) {}

  FeMesh read() {
    if (in_.at_end() || in_.word() != "$MeshFormat") in_.fail("no mesh of gmsh, expected \"$MeshFormat\".");
    const std::string version = in_.word();
    const long type = in_.whole_word(), size = in_.whole_word();
    old_ = version.rfind("2", 0) == 0;
    if (!(old_ || version == "4.1"))
      in_.fail("version " + version.substr(0, 20) +
               " of the format, expected 2.2 or 4.1. Save it with Mesh.MshFileVersion = 4.1.");
    if (size != 8) in_.fail("numbers of " + std::to_string(size) + " bytes, expected 8.");
    in_.binary = type == 1;
    if (in_.binary) {
      in_.begin_data();
      if (in_.raw<std::int32_t>() != 1) in_.fail("written on a machine of the other byte order. Save it as text.");
    }
    in_.require_end("MeshFormat");
    while (!in_.at_end()) {
      const std::string section = in_.word();
      in_.begin_data();
      if (section == "$PhysicalNames") {
        names();
      } else if (section == "$Entities" && !old_) {
        entities();
      } else if (section == "$Nodes") {
        old_ ? old_nodes() : nodes();
      } else if (section == "$Elements") {
        old_ ? old_elements() : elements();
      } else if (section[0] == '$') {
        in_.skip_section(section);
      } else {
        in_.fail("is \"" + section.substr(0, 40) + "\", expected a section that begins with $. Export the mesh again.");
      }
    }
    return std::move(mesh_.mesh());
  }

 private:
  void names() {
    const long count = in_.count(in_.whole_word(), 4);
    for (long i = 0; i < count; ++i) {
      const long dimension = in_.whole_word(), tag = in_.whole_word();
      std::string name = in_.rest_of_line();
      if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
      names_[{dimension, tag}] = name;
    }
    in_.require_end("PhysicalNames");
  }
  void entities() {
    std::array<long, 4> counts{};
    for (long& count : counts) count = in_.count(in_.size(), 8);
    for (long dimension = 0; dimension < 4; ++dimension)
      for (long i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
        const long tag = in_.integer();
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) in_.real();
        const long groups = in_.count(in_.size(), 2);
        for (long k = 0; k < groups; ++k) groups_[{dimension, tag}].push_back(in_.integer());
        if (dimension == 0) continue;
        const long bounding = in_.count(in_.size(), 2);
        for (long k = 0; k < bounding; ++k) in_.integer();
      }
    in_.require_end("Entities");
  }
  void nodes() {
    const auto fail = [&](const std::string& what) { in_.fail(what); };
    const long blocks = in_.count(in_.size(), 2);
    for (int i = 0; i < 3; ++i) in_.size();
    for (long b = 0; b < blocks; ++b) {
      const long dimension = in_.integer();
      in_.integer();
      const long parametric = in_.integer(), count = in_.count(in_.size(), 6);
      if (dimension < 0 || dimension > 3) in_.fail("an entity of " + std::to_string(dimension) + " dimensions.");
      std::vector<long> tags;
      for (long i = 0; i < count; ++i) tags.push_back(in_.size());
      for (const long tag : tags) {
        Vector3d x;
        for (int k = 0; k < 3; ++k) x(k) = in_.real();
        for (long k = 0; parametric != 0 && k < dimension; ++k) in_.real();
        mesh_.add_node(tag, x, fail);
      }
    }
    in_.require_end("Nodes");
  }
  void old_nodes() {
    const auto fail = [&](const std::string& what) { in_.fail(what); };
    const long count = in_.count(in_.whole_word(), 6);
    in_.begin_data();
    for (long i = 0; i < count; ++i) {
      const long tag = in_.integer();
      Vector3d x;
      for (int k = 0; k < 3; ++k) x(k) = in_.real();
      mesh_.add_node(tag, x, fail);
    }
    in_.require_end("Nodes");
  }
  void elements() {
    const long blocks = in_.count(in_.size(), 2);
    for (int i = 0; i < 3; ++i) in_.size();
    for (long b = 0; b < blocks; ++b) {
      const long dimension = in_.integer(), entity = in_.integer(), type = in_.integer();
      const long count = in_.count(in_.size(), 2);
      for (long i = 0; i < count; ++i) {
        in_.size();
        element(
            type, [&] { return in_.size(); }, groups_[{dimension, entity}]);
      }
    }
    in_.require_end("Elements");
  }
  void old_elements() {
    const long count = in_.count(in_.whole_word(), 4);
    in_.begin_data();
    const auto one = [&](long type, long tags) {
      std::vector<long> groups;
      for (long t = 0; t < tags; ++t) {
        const long tag = in_.integer();
        if (t == 0 && tag != 0) groups.push_back(tag);
      }
      element(
          type, [&] { return in_.integer(); }, groups);
    };
    for (long i = 0; i < count;) {
      if (!in_.binary) {
        in_.integer();
        const long type = in_.integer();
        one(type, in_.count(in_.integer(), 1));
        ++i;
        continue;
      }
      const long type = in_.integer(), block = in_.count(in_.integer(), 8), tags = in_.count(in_.integer(), 4);
      if (block < 1) in_.fail("a block of " + std::to_string(block) + " elements. Export the mesh again.");
      for (long k = 0; k < block; ++k, ++i) {
        in_.integer();
        one(type, tags);
      }
    }
    in_.require_end("Elements");
  }
  template <class Next>
  void element(long type, const Next& next, const std::vector<long>& groups) {
    const auto fail = [&](const std::string& what) { in_.fail(what); };
    const auto [dimension, count] = gmsh_type(type);
    if (count == 0)
      in_.fail("element type " + std::to_string(type) +
               " of gmsh, expected one of order 1 or 2. Mesh with order 1 or 2.");
    std::vector<long> ids;
    for (int k = 0; k < count; ++k) ids.push_back(next());
    const int index = dimension == 0 ? -1 : mesh_.add_element(dimension, ids, kGmsh, fail);
    for (const long group : groups) {
      const auto name = names_.find({dimension, group});
      const std::string set = name == names_.end() ? std::to_string(group) : name->second;
      if (dimension == 0) mesh_.add_to_set(set, mesh_.node(ids[0], fail));
      mesh_.add_element_to_set(set, index);
    }
  }

  MshBytes in_;
  MeshBuilder mesh_;
  bool old_ = false;
  std::map<std::pair<long, long>, std::string> names_;         // by dimension and physical group
  std::map<std::pair<long, long>, std::vector<long>> groups_;  // by dimension and entity
};

// --- CalculiX results.

// Fixed columns: mark, number, then values of 12 characters.
long frd_id(const ModelText& text, bool wide) {
  return text.whole(trimmed(text.line().substr(std::min<std::size_t>(3, text.line().size()), wide ? 10 : 5)), 1,
                    kLargestId);
}
std::vector<double> frd_values(const ModelText& text, bool wide) {
  std::vector<double> values;
  for (std::size_t at = wide ? 13 : 8; at + 1 < text.line().size(); at += 12) {
    const std::string cell = trimmed(text.line().substr(at, 12));
    if (!cell.empty()) values.push_back(text.number(cell));
  }
  return values;
}
bool frd_mark(const ModelText& text, const char* mark) { return text.line().compare(0, 3, mark) == 0; }
// The last number of a block's first line: 0 short, 1 long, others are binary.
bool frd_wide(const ModelText& text) {
  const std::vector<std::string> words = text.words();
  if (words.empty() || words.size() < 2) text.fail("the first line of a block lacks numbers.");
  const std::string format = words.back().substr(words.back().size() - 1);
  if (format != "0" && format != "1")
    text.fail("a binary block, expected text. Write the file without *NODE OUTPUT binary.");
  return format == "1";
}

FeMesh frd_mesh(const std::string& bytes, const std::string& file) {
  ModelText text(bytes, file);
  MeshBuilder mesh;
  const auto fail = [&](const std::string& what) { text.fail(what); };
  static const std::map<long, std::pair<int, int>> kTypes = {{1, {3, 8}},  {2, {3, 6}},  {3, {3, 4}},  {4, {3, 20}},
                                                             {5, {3, 15}}, {6, {3, 10}}, {7, {2, 3}},  {8, {2, 6}},
                                                             {9, {2, 4}},  {10, {2, 8}}, {11, {1, 2}}, {12, {1, 3}}};
  while (text.next()) {
    const std::string start = trimmed(text.line().substr(0, 6));
    if (start == "2C") {
      const bool wide = frd_wide(text);
      while (text.next() && frd_mark(text, " -1")) {
        const std::vector<double> x = frd_values(text, wide);
        if (x.size() != 3) fail("expected a node's number and x y z.");
        mesh.add_node(frd_id(text, wide), {x[0], x[1], x[2]}, fail);
      }
      if (!frd_mark(text, " -3")) fail("the list of nodes has no end: the file is cut off.");
    } else if (start == "3C") {
      while (text.next() && frd_mark(text, " -1")) {
        const std::vector<std::string> head = text.words();
        if (head.size() < 3) fail("expected number and type of an element.");
        const auto type = kTypes.find(text.whole(head[2], 0, 1000));
        if (type == kTypes.end()) fail("unknown type " + head[2] + " of an element.");
        std::vector<long> ids;
        while (ids.size() < static_cast<std::size_t>(type->second.second)) {
          if (!text.next() || !frd_mark(text, " -2")) fail("the nodes of an element are missing.");
          const std::vector<std::string> words = text.words();
          for (std::size_t i = 1; i < words.size(); ++i) ids.push_back(text.whole(words[i], 1, kLargestId));
        }
        mesh.add_element(type->second.first, ids, kNastran, fail);
      }
      if (!frd_mark(text, " -3")) fail("the list of elements has no end: the file is cut off.");
    }
  }
  return std::move(mesh.mesh());
}

// --- Lists of nodes: "x y z" or "number x y z" per line, # begins a comment.

FeMesh node_list(const std::string& bytes, const std::string& file) {
  ModelText text(bytes, file);
  MeshBuilder mesh;
  const auto fail = [&](const std::string& what) { text.fail(what); };
  std::size_t columns = 0;
  while (text.next()) {
    std::vector<std::string> cells = text.cells();
    const auto comment =
        std::find_if(cells.begin(), cells.end(), [](const std::string& c) { return c.find('#') != std::string::npos; });
    if (comment != cells.end()) {
      *comment = comment->substr(0, comment->find('#'));
      cells.erase(comment->empty() ? comment : comment + 1, cells.end());
    }
    if (cells.empty()) continue;
    if (columns == 0) columns = cells.size();
    if ((cells.size() != 3 && cells.size() != 4) || cells.size() != columns)
      fail(std::to_string(cells.size()) + " numbers, expected three: x y z, or four: number x y z, in all lines.");
    const long id = columns == 4 ? text.whole(cells[0], 1, kLargestId) : static_cast<long>(mesh.mesh().ids.size()) + 1;
    const std::size_t at = columns - 3;
    mesh.add_node(id, {text.number(cells[at]), text.number(cells[at + 1]), text.number(cells[at + 2])}, fail);
  }
  return std::move(mesh.mesh());
}

std::string mesh_extension(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

bool is_fe_mesh_name(const std::string& file) {
  const std::string end = mesh_extension(file);
  return end == ".msh" || end == ".inp" || end == ".bdf" || end == ".nas" || end == ".dat" || end == ".pch" ||
         end == ".frd";
}

FeMesh parse_fe_mesh(const std::string& bytes, const std::string& file) {
  const std::string end = mesh_extension(file);
  FeMesh mesh = end == ".msh"           ? MshFile(bytes, file).read()
                : end == ".inp"         ? inp_mesh(bytes, file)
                : end == ".frd"         ? frd_mesh(bytes, file)
                : is_fe_mesh_name(file) ? bdf_mesh(bytes, file)
                                        : node_list(bytes, file);
  if (mesh.ids.empty())
    throw InputError(code::kModelFile, file +
                                           ": contains no nodes. Check that its name ends in that of its format: "
                                           ".msh (gmsh), .inp (Abaqus, CalculiX), .bdf (Nastran), .frd (CalculiX); "
                                           "any other is a list with \"x y z\" in each line.");
  return mesh;
}

const std::vector<int>& FeMesh::set(const std::string& name, const std::string& file) const {
  const auto exact = sets.find(name);
  if (exact != sets.end()) return exact->second;
  std::vector<std::string> names;
  for (const auto& [known, nodes] : sets) {
    if (upper_case(known) == upper_case(name)) return nodes;
    names.push_back(known);
  }
  throw InputError(code::kModelFile, file + ": has no node set \"" + name + "\"." + known_names("sets", name, names) +
                                         (names.empty() ? " It has none." : ""));
}

FrdModes parse_frd_modes(const std::string& bytes, const std::string& file, const FeMesh& mesh) {
  ModelText text(bytes, file);
  FrdModes modes;
  const auto fail = [&](const std::string& what) { text.fail(what); };
  bool wide = true;
  const auto n = static_cast<Eigen::Index>(mesh.points.size());
  while (text.next()) {
    if (text.line().find("100C") == 2) wide = frd_wide(text);
    if (!frd_mark(text, " -4")) continue;
    const std::vector<std::string> words = text.words();
    const bool displacements = words.size() > 1 && words[1] == "DISP",
               stress = words.size() > 1 && words[1] == "STRESS";
    if (!displacements && !stress) continue;
    Eigen::MatrixXd values =
        Eigen::MatrixXd::Constant(displacements ? 3 : 6, n, std::numeric_limits<double>::quiet_NaN());
    while (text.next() && !frd_mark(text, " -3")) {
      if (!frd_mark(text, " -1")) continue;
      const auto node = mesh.index.find(frd_id(text, wide));
      if (node == mesh.index.end()) continue;
      const std::vector<double> x = frd_values(text, wide);
      if (static_cast<Eigen::Index>(x.size()) != values.rows())
        fail("expected " + std::to_string(values.rows()) + " values of a node.");
      for (Eigen::Index i = 0; i < values.rows(); ++i) values(i, node->second) = x[static_cast<std::size_t>(i)];
    }
    if (!frd_mark(text, " -3")) fail("the results have no end: the file is cut off.");
    (displacements ? modes.displacements : modes.stresses).push_back(std::move(values));
  }
  if (modes.displacements.empty() || modes.displacements.size() != modes.stresses.size())
    throw InputError(
        code::kModelFile,
        file + ": has " + std::to_string(modes.displacements.size()) + " modes and " +
            std::to_string(modes.stresses.size()) +
            " fields of stress, expected both for each mode. Request *NODE FILE with U and *EL FILE with S.");
  return modes;
}

}  // namespace footfall

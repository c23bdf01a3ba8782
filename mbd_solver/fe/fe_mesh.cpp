// One parser per format.

#include "mbd_solver/fe/fe_mesh.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/fe/mesh_builder.h"
#include "mbd_solver/fe/model_text.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostIncludes = 8;  // files within files

// Files that are being read, the outermost first, and their limit in all.
struct Includes {
  explicit Includes(const std::string& file)
      : open{std::filesystem::path(file).lexically_normal().string()},
        files(limit::kIncludedFiles, file),
        bytes(limit::kIncludedMesh, file) {}
  std::vector<std::string> open;
  ReadBudget files, bytes;
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
  explicit InpState(const std::string& file) : mesh(file), includes(file) {}
  MeshBuilder mesh;
  Includes includes;
  std::unordered_map<long, int> elements;  // number -> index
  std::map<std::string, std::vector<int>> element_sets;
  std::map<std::string, std::string> spellings;  // of names of sets: upper case -> the first one
  bool in_part = false, part_had_nodes = false;
  // Abaqus and CalculiX ignore the case of names.
  const std::string& named(const std::string& set) { return spellings.try_emplace(upper_case(set), set).first->second; }
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
  const std::string type = upper_case(keyword.value("TYPE")), set = state.named(keyword.value("ELSET"));
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
    if (numbers.size() <= static_cast<std::size_t>(nodes)) return;  // continues in the next line
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

// The existing numbers among first, first + step ... last, with their indices, in order. Counts the others.
std::vector<std::pair<long, int>> within(const std::unordered_map<long, int>& numbers, long first, long last, long step,
                                         ReadBudget& entries) {
  std::vector<std::pair<long, int>> found;
  if (last < first) return found;
  const auto asked = static_cast<std::size_t>((last - first) / step + 1);
  entries.take(std::min(asked, numbers.size()));
  if (asked <= numbers.size()) {
    for (long id = first; id <= last; id += step)
      if (const auto entry = numbers.find(id); entry != numbers.end()) found.emplace_back(*entry);
    return found;
  }
  for (const auto& [id, index] : numbers)
    if (id >= first && id <= last && (id - first) % step == 0) found.emplace_back(id, index);
  std::sort(found.begin(), found.end());
  return found;
}

// NSET or ELSET: numbers, ranges (GENERATE), names of other sets. `numbers`: index by number.
std::vector<int> inp_set(ModelText& text, const InpKeyword& keyword, const std::string& name,
                         const std::unordered_map<long, int>& numbers,
                         const std::map<std::string, std::vector<int>>& sets,
                         const std::map<std::string, std::string>& spellings, bool of_nodes, ReadBudget& entries) {
  if (name.empty()) text.fail("a set without a name.");
  const bool ranges = keyword.values.count("GENERATE") > 0;
  std::vector<int> found;
  each_data_line(text, [&](const std::vector<std::string>& cells) {
    if (ranges) {
      if (cells.size() < 2) text.fail("expected first, last and step of a range.");
      const long first = text.whole(cells[0], 0, kLargestId), last = text.whole(cells[1], 0, kLargestId);
      const long step = cells.size() > 2 && !cells[2].empty() ? text.whole(cells[2], 1, kLargestId) : 1;
      for (const auto& entry : within(numbers, first, last, step, entries)) found.push_back(entry.second);
      return;
    }
    for (const std::string& cell : cells) {
      if (cell.empty()) continue;
      if (std::isdigit(static_cast<unsigned char>(cell[0])) == 0) {
        const auto spelling = spellings.find(upper_case(cell));
        const auto other = spelling == spellings.end() ? sets.end() : sets.find(spelling->second);
        if (other == sets.end()) text.fail("unknown set \"" + cell + "\", expected a set defined above.");
        entries.take(other->second.size());
        found.insert(found.end(), other->second.begin(), other->second.end());
        continue;
      }
      const auto entry = numbers.find(text.whole(cell, 0, kLargestId));
      if (entry != numbers.end()) found.push_back(entry->second);
      if (entry == numbers.end() && of_nodes)
        text.fail("the set \"" + name + "\" has the unknown node " + cell + ", expected nodes listed above.");
    }
  });
  return found;
}

// The path of a file within this one, which joins those that are being read. The caller takes it away again.
std::string path_within(const ModelText& text, const std::string& name, Includes& includes) {
  std::vector<std::string>& open = includes.open;
  const std::string path = (std::filesystem::path(text.name()).parent_path() / name).lexically_normal().string();
  if (std::find(open.begin(), open.end(), path) != open.end() || open.size() > kMostIncludes)
    text.fail("includes \"" + name.substr(0, 100) + "\", " +
              (open.size() > kMostIncludes ? "more than " + std::to_string(kMostIncludes) + " files within files."
                                           : std::string("which is being read: files include each other.")));
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none))
    text.fail("includes \"" + name.substr(0, 100) + "\", but there is no file " + path + ".");
  includes.files.take();
  includes.bytes.take(std::filesystem::file_size(path, none));
  open.push_back(path);
  return path;
}

void parse_inp(ModelText& text, InpState& state) {
  const auto fail = [&](const std::string& what) { text.fail(what); };
  while (text.next()) {
    if (text.line().compare(0, 2, "**") == 0 || is_inp_data(text)) continue;
    const InpKeyword keyword = keyword_of(text);
    if (keyword.name == "NODE") {
      const std::string set = state.named(keyword.value("NSET"));
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
      const std::string name = state.named(keyword.value("NSET"));
      if (!keyword.value("ELSET").empty()) {
        const auto of = state.element_sets.find(state.named(keyword.value("ELSET")));
        if (of == state.element_sets.end())
          fail("unknown set \"" + keyword.value("ELSET") + "\" of elements, expected a set defined above.");
        for (const int e : of->second) state.mesh.add_element_to_set(name, e);
        continue;
      }
      for (const int n : inp_set(text, keyword, name, state.mesh.mesh().index, state.mesh.mesh().sets, state.spellings,
                                 true, state.mesh.entries))
        state.mesh.add_to_set(name, n);
    } else if (keyword.name == "ELSET") {
      const std::string name = state.named(keyword.value("ELSET"));
      const std::vector<int> found =
          inp_set(text, keyword, name, state.elements, state.element_sets, state.spellings, false, state.mesh.entries);
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
      const std::string path = path_within(text, name, state.includes);
      ModelText included(bytes_of_model(path), path);
      parse_inp(included, state);
      state.includes.open.pop_back();
    }
  }
}

FeMesh inp_mesh(const std::string& bytes, const std::string& file) {
  ModelText text(bytes, file);
  InpState state(file);
  parse_inp(text, state);
  for (const auto& [name, elements] : state.element_sets) {
    if (state.mesh.mesh().sets.count(name) > 0) continue;  // of two sets with one name the nodes are meant
    for (const int e : elements) state.mesh.add_element_to_set(name, e);
  }
  return std::move(state.mesh.mesh());
}

// --- Nastran.

struct NastranCard {
  const char* name;
  int dimension, corners, most;
  std::size_t first;  // field of the first node
};

// Cards have no order: elements and sets are resolved at the end.
struct BdfState {
  struct Pending {
    const NastranCard* card;
    std::vector<long> ids;
    std::string place;
  };
  explicit BdfState(const std::string& file) : mesh(file), includes(file) {}
  MeshBuilder mesh;
  Includes includes;
  std::vector<Pending> elements;
  struct Set {
    std::string name;
    std::vector<long> ids;  // a range is -first, last
    std::set<long> without;
  };
  std::vector<Set> sets;
};

// From the cell `from` on: numbers, and ranges "first THRU last".
template <class Cells, class Number>
std::vector<long> nastran_ids(const Cells& cells, std::size_t from, const Number& number, const ModelText& text) {
  std::vector<long> ids;
  for (std::size_t i = from; i < cells.size(); ++i) {
    if (cells[i].empty()) continue;
    if (upper_case(cells[i]) != "THRU") {
      ids.push_back(number(i));
      continue;
    }
    if (ids.empty() || i + 1 >= cells.size() || (ids.size() > 1 && ids[ids.size() - 2] < 0))
      text.fail("THRU without numbers before and behind.");
    ids.back() = -ids.back();
    ids.push_back(number(++i));
  }
  return ids;
}

// Sets of the case control: `SET 5 = 1, 2, 7 THRU 20 EXCEPT 9, 10,` which continues in the next line after a comma.
// Sets that contain other things than numbers, such as frequencies, are not sets of nodes.
void case_control_sets(const std::string& bytes, const std::string& file, BdfState& state) {
  ModelText text(bytes, file);
  while (text.next()) {
    std::string line = upper_case(trimmed(text.line()));
    const std::size_t equals = line.find('=');
    if (line.rfind("BEGIN", 0) == 0) return;
    if (line.rfind("SET ", 0) != 0 || equals == std::string::npos) continue;
    const std::string name = trimmed(line.substr(4, equals - 4));
    line = line.substr(equals + 1);
    while (!line.empty() && line.back() == ',' && text.next()) line += upper_case(trimmed(text.line()));
    std::replace(line.begin(), line.end(), ',', ' ');
    std::vector<std::string> words;
    std::vector<long> without;
    bool whole = true, except = false;
    for (const std::string& word : blank_words(line)) {
      const bool number = word.find_first_not_of("0123456789") == std::string::npos;
      if (word == "EXCEPT") {
        except = true;
      } else if (except && number) {  // up to the end of the range before
        const long id = text.whole(word, 1, kLargestId);
        except = !words.empty() && id < text.whole(words.back(), 1, kLargestId);
        except ? without.push_back(id) : words.push_back(word);
      } else {
        whole = whole && (number || word == "THRU" || word == "ALL");
        words.push_back(word);
      }
    }
    if (!whole || words.empty() || name.find_first_not_of("0123456789") != std::string::npos) continue;
    const auto id = [&](std::size_t i) { return text.whole(words[i], 1, kLargestId); };
    std::vector<long> ids = words[0] == "ALL" ? std::vector<long>{-1, kLargestId} : nastran_ids(words, 0, id, text);
    state.sets.push_back({name, std::move(ids), {without.begin(), without.end()}});
  }
}

void parse_bdf(const std::string& bytes, const std::string& file, BdfState& state) {
  case_control_sets(bytes, file, state);
  ModelText text(bytes, file);
  NastranCards cards(text);
  const auto fail = [&](const std::string& what) { text.fail(what); };
  static const NastranCard kCards[] = {{"CTETRA", 3, 4, 10, 3}, {"CPYRAM", 3, 5, 13, 3}, {"CPENTA", 3, 6, 15, 3},
                                       {"CHEXA", 3, 8, 20, 3},  {"CTRIA3", 2, 3, 3, 3},  {"CTRIAR", 2, 3, 3, 3},
                                       {"CTRIA6", 2, 3, 6, 3},  {"CQUAD4", 2, 4, 4, 3},  {"CQUADR", 2, 4, 4, 3},
                                       {"CQUAD8", 2, 4, 8, 3},  {"CBAR", 1, 2, 2, 3},    {"CBEAM", 1, 2, 2, 3},
                                       {"CROD", 1, 2, 2, 3}};
  while (cards.next()) {
    const std::string& name = cards.fields()[0];
    if (name == "GRID") {
      const long id = cards.whole(1, 1, kLargestId);
      if (cards.number(2, 0.0) != 0.0)
        fail("node " + std::to_string(id) + " is given in coordinate system " + cards.fields()[2] +
             ", expected the basic one (0 or empty). Export global coordinates.");
      if (cards.number(6, 0.0) != 0.0)
        state.mesh.mesh().turned =
            file + ": node " + std::to_string(id) + " has displacements in coordinate system " + cards.fields()[6];
      state.mesh.add_node(id, {cards.number(3, 0.0), cards.number(4, 0.0), cards.number(5, 0.0)}, fail);
    } else if (name == "SET1" || name == "SET3") {
      const bool third = name == "SET3";
      const std::string of = third && cards.given(2) ? upper_case(cards.fields()[2]) : "GRID";
      if (of != "GRID" && of != "POINT") continue;
      const auto number = [&](std::size_t i) { return cards.whole(i, 1, kLargestId); };
      state.sets.push_back({std::to_string(cards.whole(1, 1, kLargestId)),
                            nastran_ids(cards.fields(), third ? 3 : 2, number, text),
                            {}});
    } else if (name == "INCLUDE") {
      std::string path;
      for (std::size_t i = std::strlen("INCLUDE"); i < cards.line().size(); ++i)
        if (std::strchr("'\" \t", cards.line()[i]) == nullptr) path += cards.line()[i];
      if (path.empty()) fail("INCLUDE without a file.");
      path = path_within(text, path, state.includes);
      parse_bdf(bytes_of_model(path), path, state);
      state.includes.open.pop_back();
    } else {
      const auto card =
          std::find_if(std::begin(kCards), std::end(kCards), [&](const NastranCard& c) { return name == c.name; });
      if (card == std::end(kCards)) continue;
      BdfState::Pending pending{card, {}, text.place()};
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
      state.elements.push_back(std::move(pending));
    }
  }
}

FeMesh bdf_mesh(const std::string& bytes, const std::string& file) {
  BdfState state(file);
  parse_bdf(bytes, file, state);
  MeshBuilder& mesh = state.mesh;
  const auto& index = mesh.mesh().index;
  for (const BdfState::Pending& p : state.elements)
    mesh.add_element(p.card->dimension, p.ids, kNastran, [&](const std::string& what) {
      throw InputError(code::kModelFile, p.place + ": " + p.card->name + ": " + what);
    });
  for (const auto& [name, ids, without] : state.sets)
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] > 0) {
        const auto node = index.find(ids[i]);
        if (node != index.end()) mesh.add_to_set(name, node->second);
        continue;
      }
      std::vector<int> nodes;
      for (const auto& [id, node] : within(index, -ids[i], ids[i + 1], 1, mesh.entries))
        if (without.count(id) == 0) nodes.push_back(node);
      std::sort(nodes.begin(), nodes.end());  // as in the file
      for (const int node : nodes) mesh.add_to_set(name, node);
      ++i;
    }
  return std::move(mesh.mesh());
}

// --- CalculiX results.

// Fixed columns: mark, number, then values of 12 characters.
long frd_id(const ModelText& text, bool wide) {
  return text.whole(trimmed(text.line().substr(std::min<std::size_t>(3, text.line().size()), wide ? 10 : 5)), 1,
                    kLargestId);
}
std::vector<double> frd_values(const ModelText& text, bool wide) {
  const std::string& line = text.line();
  for (std::size_t at = line.find('E'); at != std::string::npos; at = line.find('E', at + 1)) {
    std::size_t end = at + 2;
    while (end < line.size() && std::isdigit(static_cast<unsigned char>(line[end])) != 0) ++end;
    if (end < line.size() && line[end] == '.') --end;  // the first digit of the next number
    if (end >= at + 5)
      text.fail("\"" + line.substr(at, 5) +
                "\", an exponent of three digits, as programs for Windows write it: numbers of 13 characters do not "
                "fit into the columns of 12. Expected two digits (E-03): write the file by CalculiX for Linux, or by "
                "a later one for Windows.");
  }
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
  MeshBuilder mesh(file);
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
  MeshBuilder mesh(file);
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
  FeMesh mesh = end == ".msh"           ? gmsh_mesh(bytes, file)
                : end == ".inp"         ? inp_mesh(bytes, file)
                : end == ".frd"         ? frd_mesh(bytes, file)
                : is_fe_mesh_name(file) ? bdf_mesh(bytes, file)
                                        : node_list(bytes, file);
  if (mesh.ids.empty())
    throw InputError(code::kModelFile, file +
                                           ": contains no nodes. Check the ending of its name: "
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
      for (Eigen::Index i = 0; i < values.rows(); ++i) values(i, node->second) = x[i];
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

// --- The skin: faces that belong to one solid only; nodes on edges are found by the corners of the edge.

namespace {

using Eigen::Vector3i;

using Edges = std::vector<std::array<int, 2>>;

// Corners of the nodes on edges, in the order of the code.
const Edges& edges_of(int dimension, int corners, EdgeOrder order) {
  static const Edges kTri = {{0, 1}, {1, 2}, {2, 0}}, kQuad = {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, kLine = {{0, 1}};
  static const Edges kTet = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  static const Edges kTetGmsh = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {2, 3}, {1, 3}};
  static const Edges kPyramid = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
  static const Edges kPyramidGmsh = {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}};
  static const Edges kWedge = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
  static const Edges kWedgeNastran = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 4}, {2, 5}, {3, 4}, {4, 5}, {5, 3}};
  static const Edges kWedgeGmsh = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}};
  static const Edges kBrick = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                               {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  static const Edges kBrickNastran = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5},
                                      {2, 6}, {3, 7}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  static const Edges kBrickGmsh = {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3},
                                   {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
  if (dimension == 1) return kLine;
  if (dimension == 2) return corners == 3 ? kTri : kQuad;
  switch (corners) {
    case 4: return order == kGmsh ? kTetGmsh : kTet;
    case 5: return order == kGmsh ? kPyramidGmsh : kPyramid;
    case 6: return order == kGmsh ? kWedgeGmsh : order == kNastran ? kWedgeNastran : kWedge;
    default: return order == kGmsh ? kBrickGmsh : order == kNastran ? kBrickNastran : kBrick;
  }
}

using Faces = std::vector<std::vector<int>>;

const Faces& faces_of(int corners) {
  static const Faces kTet = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  static const Faces kPyramid = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  static const Faces kWedge = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  static const Faces kBrick = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  switch (corners) {
    case 4: return kTet;
    case 5: return kPyramid;
    case 6: return kWedge;
    default: return kBrick;
  }
}

}  // namespace

std::vector<Vector3i> skin_of(const FeMesh& mesh) {
  const bool solid =
      std::any_of(mesh.elements.begin(), mesh.elements.end(), [](const MeshElement& e) { return e.dimension == 3; });
  struct Face {
    const MeshElement* element;
    std::vector<int> corners;  // local numbers
    int uses = 0;
  };
  std::map<std::vector<int>, std::size_t> seen;
  std::vector<Face> faces;
  const auto add = [&](const MeshElement& element, std::vector<int> corners) {
    std::vector<int> key;
    for (const int c : corners) key.push_back(element.nodes[c]);
    std::sort(key.begin(), key.end());
    key.erase(std::unique(key.begin(), key.end()), key.end());
    if (key.size() < 3) return;  // of a collapsed element
    const auto [entry, fresh] = seen.try_emplace(key, faces.size());
    if (fresh) faces.push_back({&element, std::move(corners), 0});
    ++faces[entry->second].uses;
  };
  const auto at = [&](const MeshElement& e, int local) -> const Vector3d& { return mesh.points[e.nodes[local]]; };
  for (const MeshElement& element : mesh.elements) {
    if (element.dimension == 2 && !solid)
      add(element, element.corners == 3 ? std::vector<int>{0, 1, 2} : std::vector<int>{0, 1, 2, 3});
    if (element.dimension != 3) continue;
    double volume = 0.0;  // six times; negative: nodes in the other order
    const Vector3d& o = at(element, 0);
    for (const std::vector<int>& f : faces_of(element.corners))
      for (std::size_t k = 2; k < f.size(); ++k)
        volume += (at(element, f[0]) - o).dot((at(element, f[k - 1]) - o).cross(at(element, f[k]) - o));
    for (std::vector<int> f : faces_of(element.corners)) {
      if (volume < 0.0) std::reverse(f.begin(), f.end());
      add(element, f);
    }
  }
  std::vector<Vector3i> triangles;
  for (const Face& face : faces) {
    if (solid && face.uses != 1) continue;
    const MeshElement& e = *face.element;
    std::vector<int> ring;  // corners and nodes on edges in turn; -1 where there is none
    bool all = true;
    const Edges& edges = edges_of(e.dimension, e.corners, e.order);
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const int a = face.corners[i], b = face.corners[(i + 1) % face.corners.size()];
      const auto edge = std::find_if(edges.begin(), edges.end(), [&](const auto& ab) {
        return (ab[0] == a && ab[1] == b) || (ab[0] == b && ab[1] == a);
      });
      const auto local = static_cast<std::size_t>(e.corners + (edge - edges.begin()));
      const int middle = local < e.nodes.size() ? e.nodes[local] : -1;
      all = all && middle >= 0;
      ring.push_back(e.nodes[a]);
      ring.push_back(middle);
    }
    const auto triangle = [&](int a, int b, int c) {
      if (a != b && b != c && c != a) triangles.emplace_back(a, b, c);
    };
    if (all && ring.size() == 6) {
      triangle(ring[0], ring[1], ring[5]);
      triangle(ring[1], ring[2], ring[3]);
      triangle(ring[3], ring[4], ring[5]);
      triangle(ring[1], ring[3], ring[5]);
    } else if (all) {
      triangle(ring[7], ring[0], ring[1]);
      triangle(ring[1], ring[2], ring[3]);
      triangle(ring[3], ring[4], ring[5]);
      triangle(ring[5], ring[6], ring[7]);
      triangle(ring[1], ring[3], ring[7]);
      triangle(ring[3], ring[5], ring[7]);
    } else {
      for (std::size_t k = 4; k < ring.size(); k += 2) triangle(ring[0], ring[k - 2], ring[k]);
    }
  }
  return triangles;
}

}  // namespace footfall

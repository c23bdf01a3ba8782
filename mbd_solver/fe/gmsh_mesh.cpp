// gmsh .msh: versions 2, 4.0 and 4.1, text and binary. Physical groups become sets.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/fe/mesh_builder.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

using Eigen::Vector3d;

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
  std::string_view word() {
    const std::string_view word = next_word(bytes_, at_);
    if (word.empty()) fail("the file ends here: it is cut off. Export it again.");
    return word;
  }
  std::string rest_of_line() {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string rest = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    return trimmed(rest);
  }
  bool at_end() {
    std::size_t at = at_;
    return next_word(bytes_, at).empty();
  }
  long integer() { return binary ? raw<std::int32_t>() : whole_word(); }                  // int
  long size() { return binary ? static_cast<long>(raw<std::int64_t>()) : whole_word(); }  // size_t of version 4
  double real() { return binary ? finite(raw<double>()) : real_word(); }
  long whole_word() {
    const std::string_view text = word();
    long value = 0;
    if (!read_whole(text, value)) fail(in_quotes(text) + " is no whole number. Export the mesh again.");
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
    const std::string_view found = word();
    if (found != "$End" + name)
      fail("is " + in_quotes(found) + ", expected \"$End" + name + "\". Export the mesh again.");
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
    const std::string_view text = word();
    double value = 0.0;
    if (!read_number(text, value)) fail(in_quotes(text) + " is no number. Export the mesh again.");
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
  MshFile(const std::string& bytes, const std::string& file) : in_(bytes, file), mesh_(file) {}

  FeMesh read() {
    if (in_.at_end() || in_.word() != "$MeshFormat") in_.fail("no mesh of gmsh, expected \"$MeshFormat\".");
    const std::string version(in_.word());
    const long type = in_.whole_word(), size = in_.whole_word();
    old_ = version.rfind("2", 0) == 0;
    first_4_ = version == "4" || version == "4.0";
    if (!(old_ || first_4_ || version == "4.1"))
      in_.fail("version " + version.substr(0, 20) +
               " of the format, expected 2.2, 4.0 or 4.1. Save it with Mesh.MshFileVersion = 4.1.");
    if (size != 8) in_.fail("numbers of " + std::to_string(size) + " bytes, expected 8.");
    in_.binary = type == 1;
    if (in_.binary) {
      in_.begin_data();
      if (in_.raw<std::int32_t>() != 1) in_.fail("written on a machine of the other byte order. Save it as text.");
    }
    in_.require_end("MeshFormat");
    while (!in_.at_end()) {
      const std::string section(in_.word());
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
        in_.fail("is " + in_quotes(section) + ", expected a section that begins with $. Export the mesh again.");
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
      for (long i = 0; i < counts[dimension]; ++i) {
        const long tag = in_.integer();
        for (int k = 0; k < (dimension == 0 && !first_4_ ? 3 : 6); ++k) in_.real();
        const long groups = in_.count(in_.size(), 2);
        for (long k = 0; k < groups; ++k) groups_[{dimension, tag}].push_back(in_.integer());
        if (dimension == 0) continue;
        const long bounding = in_.count(in_.size(), 2);
        for (long k = 0; k < bounding; ++k) in_.integer();
      }
    in_.require_end("Entities");
  }
  // Blocks of nodes or elements. Their total follows, and in 4.1 the least and largest number.
  long blocks_ahead() {
    const long blocks = in_.count(in_.size(), 2);
    for (int i = 0; i < (first_4_ ? 1 : 3); ++i) in_.size();
    return blocks;
  }
  // Dimension and number, in 4.0 the other way round.
  std::pair<long, long> entity() {
    const long a = in_.integer(), b = in_.integer();
    return first_4_ ? std::pair{b, a} : std::pair{a, b};
  }
  void node(long tag) {
    Vector3d x;
    for (int k = 0; k < 3; ++k) x(k) = in_.real();
    mesh_.add_node(tag, x, [&](const std::string& what) { in_.fail(what); });
  }
  void nodes() {
    const long blocks = blocks_ahead();
    for (long b = 0; b < blocks; ++b) {
      const long dimension = entity().first, parametric = in_.integer(), count = in_.count(in_.size(), 6);
      if (dimension < 0 || dimension > 3) in_.fail("an entity of " + std::to_string(dimension) + " dimensions.");
      std::vector<long> tags;
      for (long i = 0; i < count && !first_4_; ++i) tags.push_back(in_.size());
      for (long i = 0; i < count; ++i) {
        node(first_4_ ? in_.integer() : tags[i]);
        for (long k = 0; parametric != 0 && k < dimension; ++k) in_.real();
      }
    }
    in_.require_end("Nodes");
  }
  void old_nodes() {
    const long count = in_.count(in_.whole_word(), 6);
    in_.begin_data();
    for (long i = 0; i < count; ++i) node(in_.integer());
    in_.require_end("Nodes");
  }
  void elements() {
    const long blocks = blocks_ahead();
    const auto number = [&] { return first_4_ ? in_.integer() : in_.size(); };
    for (long b = 0; b < blocks; ++b) {
      const std::pair<long, long> of = entity();
      const long type = in_.integer(), count = in_.count(in_.size(), 2);
      for (long i = 0; i < count; ++i) {
        number();
        element(type, number, groups_[of]);
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
  bool old_ = false, first_4_ = false;                         // 2; 4.0
  std::map<std::pair<long, long>, std::string> names_;         // by dimension and physical group
  std::map<std::pair<long, long>, std::vector<long>> groups_;  // by dimension and entity
};

}  // namespace

FeMesh gmsh_mesh(const std::string& bytes, const std::string& file) { return MshFile(bytes, file).read(); }

}  // namespace footfall

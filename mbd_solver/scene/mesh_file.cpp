// Text is read word by word, binary numbers byte by byte; nothing is reserved that a head announces.

#include "mbd_solver/scene/mesh_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "coupler/base/errors.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/fe/fe_mesh.h"
#include "mbd_solver/scene/codes.h"

namespace footfall {
namespace {

using Eigen::Vector3d;

constexpr double kSingle = 1.1920929e-7;  // spacing of single-precision numbers, relative
constexpr const char* kAgain = "; export the mesh again";

std::string lower(std::string_view given) {
  std::string text(given);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Words and numbers of a mesh; begins in its first line.
class MeshText : public TextReader {
 public:
  MeshText(std::string text, const std::string& file) : TextReader(std::move(text), file, code::kMeshDamaged) {
    next();
  }

  std::string_view require(std::string_view expected) {
    std::string_view word;
    if (!next_word(word)) fail("the file ends here, expected ", expected, ": it is cut off", kAgain);
    return word;
  }
  void require_keyword(std::string_view keyword) {
    const std::string_view word = require(in_quotes(keyword));
    if (word != keyword && lower(word) != keyword)
      fail("is ", in_quotes(word), ", expected ", in_quotes(keyword), kAgain);
  }

  double number(std::string_view word) const {
    double value = 0.0;
    const bool is_number = read_number(word, value);
    if (is_number && std::isfinite(value)) return value;
    if (word.find(',') != std::string_view::npos)
      fail(in_quotes(word),
           " has a comma, expected numbers with a decimal point, between blanks; export the mesh with them");
    fail(in_quotes(word) + (is_number ? " is a coordinate that is no finite number" : " is no number") + kAgain);
  }
  long whole(std::string_view word) const {
    const double value = number(word);
    if (value != std::floor(value) || std::abs(value) > 1e15) fail(in_quotes(word), " is no whole number", kAgain);
    return static_cast<long>(value);
  }
};

// How many digits the coordinates of a text have: far from its origin a mesh needs more than the seven of many programs.
class Digits {
 public:
  void add(int axis, std::string_view word, double value) {
    const std::size_t exponent = std::min(word.find_first_of("eE"), word.size());
    const std::size_t point = std::min(word.find('.'), exponent), first = word.find_first_of("123456789");
    if (value == 0.0 || first >= exponent) return;
    const auto count = [&](std::size_t from) {
      return std::count_if(word.begin() + from, word.begin() + exponent,
                           [](unsigned char c) { return std::isdigit(c) != 0; });
    };
    double power = 0.0;
    if (exponent < word.size()) read_number(word.substr(exponent + 1), power);
    double& last = last_[axis];
    last = std::min(last, std::pow(10.0, power - static_cast<double>(count(point))));
    most_ = std::max(most_, count(first));
    single_ = single_ && value == static_cast<double>(static_cast<float>(value));
  }
  // Of the last digit along axes on which the mesh is a thousand times farther from its origin than it is long, if no
  // coordinate has more than seven digits, or all are numbers of single precision; else 0.
  double spacing(const TriangleMesh& mesh) const {
    if (most_ == 0) return 0.0;  // no text
    Eigen::AlignedBox3d box;
    for (const Vector3d& x : mesh.vertices) box.extend(x);
    double spacing = 0.0;
    for (int i = 0; i < 3 && !box.isEmpty(); ++i) {
      const double extent = box.sizes()[i], farthest = std::max(std::abs(box.min()[i]), std::abs(box.max()[i]));
      if (!(extent > 0.0 && farthest > kFar * extent)) continue;
      if (single_) spacing = std::max(spacing, kSingle * farthest);
      if (most_ <= kFew) spacing = std::max(spacing, last_[i]);
    }
    return spacing;
  }

 private:
  static constexpr double kFar = 1000.0;
  static constexpr std::ptrdiff_t kFew = 7;
  static constexpr double kNone = std::numeric_limits<double>::max();
  std::array<double, 3> last_{kNone, kNone, kNone};  // unit of the last digit, the smallest of the axis
  std::ptrdiff_t most_ = 0;
  bool single_ = true;
};

// --- Polygons.

// Twice the area of a, b, c in the plane, positive if counter-clockwise.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Adds a polygon as triangles: its corners are cut off one by one where no other corner lies within. False: it crosses
// itself.
bool add_polygon(std::vector<int> corners, TriangleMesh& mesh) {
  if (corners.size() == 3) {
    mesh.triangles.emplace_back(corners[0], corners[1], corners[2]);
    return true;
  }
  const auto at = [&](int n) -> const Vector3d& { return mesh.vertices[n]; };
  Vector3d normal = Vector3d::Zero();  // twice the area
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += (at(corners[i]) - at(corners[0])).cross(at(corners[(i + 1) % corners.size()]) - at(corners[0]));
  Eigen::Index axis = 0;
  if (!(normal.cwiseAbs().maxCoeff(&axis) > 0.0)) return false;
  const double sign = normal(axis) > 0.0 ? 1.0 : -1.0;
  const auto flat = [&](int n) {
    const Vector3d x = at(n) - at(corners[0]);
    return Eigen::Vector2d(x((axis + 1) % 3), sign * x((axis + 2) % 3));
  };
  std::vector<Eigen::Vector2d> p;
  for (const int n : corners) p.push_back(flat(n));
  while (corners.size() > 3) {
    const std::size_t n = corners.size();
    std::size_t ear = n;
    for (std::size_t k = 1; k <= n && ear == n; ++k) {
      const std::size_t i = k % n, before = (i + n - 1) % n, after = (i + 1) % n;
      if (!(turn(p[before], p[i], p[after]) > 0.0)) continue;
      bool empty = true;
      for (std::size_t j = 0; j < n && empty; ++j) {
        if (j == before || j == i || j == after) continue;
        empty = !(turn(p[before], p[i], p[j]) >= 0.0 && turn(p[i], p[after], p[j]) >= 0.0 &&
                  turn(p[after], p[before], p[j]) >= 0.0);
      }
      if (empty) ear = i;
    }
    if (ear == n) return false;
    mesh.triangles.emplace_back(corners[(ear + n - 1) % n], corners[ear], corners[(ear + 1) % n]);
    corners.erase(corners.begin() + ear);
    p.erase(p.begin() + ear);
  }
  mesh.triangles.emplace_back(corners[0], corners[1], corners[2]);
  return true;
}

// Corners within 0 ... vertices - 1, at least three of them.
template <class Fail>
void add_face(const std::vector<int>& corners, TriangleMesh& mesh, const Fail& fail) {
  if (corners.size() < 3) fail("a face has ", corners.size(), " corners, expected at least three", kAgain);
  for (const int n : corners)
    if (n < 0 || n >= static_cast<int>(mesh.vertices.size()))
      fail("a face has corner ", n, " (from 0) of ", mesh.vertices.size(), " vertices", kAgain);
  if (!add_polygon(corners, mesh))
    fail("a face of ", corners.size(), " corners has no area or crosses itself; export the mesh in triangles");
}

// --- STL.

// 80 bytes of comment, the number of triangles, 50 bytes for each: normal, three corners, two bytes of attributes.
constexpr std::size_t kStlHead = 84, kStlTriangle = 50;

template <class Number>
Number little_endian(const std::string& bytes, std::size_t at) {
  static_assert(sizeof(Number) == 4, "32-bit numbers");
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[at + i]);
  Number number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

MeshFile binary_stl(const std::string& bytes, const std::string& file) {
  const auto fail = [&](const auto&... what) { throw InputError(code::kMeshDamaged, file, ": ", what..., kAgain); };
  if (bytes.size() < kStlHead)
    fail("has ", bytes.size(),
         " bytes, expected text that begins with \"solid\", or at least 84 bytes of a binary STL");
  const std::size_t count = little_endian<std::uint32_t>(bytes, 80), held = (bytes.size() - kStlHead) / kStlTriangle;
  if (count > held)
    fail("announces ", count, " triangles, but ends after ", held, ": the file is cut off, or its count is wrong");
  if (count < held) fail("announces ", count, " triangles, but has ", held, ": expected the same number");
  MeshFile result;
  result.mesh.vertices.reserve(3 * count);
  double largest = 0.0;
  for (std::size_t t = 0; t < count; ++t) {
    const int first = static_cast<int>(3 * t);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vector3d x;
      for (std::size_t i = 0; i < 3; ++i)
        x(static_cast<Eigen::Index>(i)) =
            little_endian<float>(bytes, kStlHead + kStlTriangle * t + 12 * (corner + 1) + 4 * i);
      if (!x.allFinite()) fail("triangle ", t, " has a coordinate that is no finite number");
      largest = std::max(largest, x.cwiseAbs().maxCoeff());
      result.mesh.vertices.push_back(x);
    }
    result.mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  result.single = true;
  result.spacing = kSingle * largest;
  return result;
}

MeshFile text_stl(const std::string& bytes, const std::string& file) {
  MeshText words(bytes, file);
  MeshFile result;
  TriangleMesh& mesh = result.mesh;
  Digits digits;
  words.require_keyword("solid");
  bool within = true;
  words.next();
  for (std::string_view word; words.next_word(word);) {
    const std::string keyword = lower(word);
    if (!within) {
      if (keyword != "solid")
        words.fail("is ", in_quotes(word), " after \"endsolid\", expected another \"solid\"", kAgain);
      within = true;
      words.next();
    } else if (keyword == "endsolid") {
      within = false;
      words.next();
    } else if (keyword == "facet") {
      words.require_keyword("normal");
      for (int i = 0; i < 3; ++i) words.require("a normal");  // corners tell the side
      words.require_keyword("outer");
      words.require_keyword("loop");
      const int first = static_cast<int>(mesh.vertices.size());
      for (int corner = 0; corner < 3; ++corner) {
        words.require_keyword("vertex");
        Vector3d& x = mesh.vertices.emplace_back();
        for (int i = 0; i < 3; ++i) {
          const std::string_view coordinate = words.require("a coordinate");
          x(i) = words.number(coordinate);
          digits.add(i, coordinate, x(i));
        }
      }
      const std::string_view end = words.require("\"endloop\"");
      if (lower(end) == "vertex") words.fail("a facet has more than three corners, expected triangles", kAgain);
      if (lower(end) != "endloop") words.fail("is ", in_quotes(end), ", expected \"endloop\"", kAgain);
      words.require_keyword("endfacet");
      mesh.triangles.emplace_back(first, first + 1, first + 2);
    } else {
      words.fail("is ", in_quotes(word), ", expected \"facet\" or \"endsolid\"", kAgain);
    }
  }
  if (within) words.fail("the file ends without \"endsolid\": it is cut off", kAgain);
  result.spacing = digits.spacing(mesh);
  return result;
}

// Binary files may begin with "solid", too: their size decides, else a byte that no text has, in head and first triangle.
bool is_text_stl(const std::string& bytes) {
  if (bytes.size() >= kStlHead &&
      bytes.size() == kStlHead + kStlTriangle * std::size_t{little_endian<std::uint32_t>(bytes, 80)})
    return false;
  const std::size_t from = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (from == std::string::npos || lower(bytes.substr(from, 5)) != "solid") return false;
  return std::find(bytes.begin(),
                   bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), kStlHead + kStlTriangle)),
                   '\0') ==
         bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), kStlHead + kStlTriangle));
}

// --- OBJ.

// What says nothing about the shape of polygons.
bool is_ignored_in_obj(std::string_view keyword) {
  static const char* const kIgnored[] = {"vt",       "vn",       "vp",     "p",          "l",         "g",      "s",
                                         "o",        "mg",       "usemtl", "mtllib",     "usemap",    "maplib", "bevel",
                                         "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj", "call"};
  return std::any_of(std::begin(kIgnored), std::end(kIgnored), [&](const char* k) { return keyword == k; });
}

MeshFile obj(const std::string& bytes, const std::string& file) {
  std::string joined;  // without continued lines
  for (TextReader lines(bytes, file, code::kMeshDamaged); lines.next();) {
    joined += lines.line();
    const bool more = !joined.empty() && joined.back() == '\\';
    if (more) joined.back() = ' ';
    if (!more) joined += lines.ending();
  }
  MeshText words(std::move(joined), file);
  MeshFile result;
  TriangleMesh& mesh = result.mesh;
  Digits digits;
  const auto fail = [&](const auto&... what) { words.fail(what...); };
  bool more = true;
  for (std::string_view keyword, word; more; more = words.next()) {
    if (!words.word_in_line(keyword) || keyword[0] == '#') continue;
    if (keyword == "v") {
      std::vector<double> numbers;
      while (words.word_in_line(word) && word[0] != '#') {
        numbers.push_back(words.number(word));
        if (numbers.size() <= 3) digits.add(static_cast<int>(numbers.size()) - 1, word, numbers.back());
      }
      if (numbers.size() != 3 && numbers.size() != 4 && numbers.size() != 6 && numbers.size() != 7)  // weight, colour
        fail("a vertex has ", numbers.size(), " numbers, expected three", kAgain);
      mesh.vertices.emplace_back(numbers[0], numbers[1], numbers[2]);
    } else if (keyword == "f") {
      std::vector<int> corners;
      while (words.word_in_line(word) && word[0] != '#') {
        const long n = words.whole(word.substr(0, word.find('/')));  // from 1, or from the last one backwards
        const long corner = n > 0 ? n - 1 : static_cast<long>(mesh.vertices.size()) + n;
        if (n == 0 || corner < 0 || corner > std::numeric_limits<int>::max())
          fail(in_quotes(word), " is no vertex", kAgain);
        corners.push_back(static_cast<int>(corner));
      }
      add_face(corners, mesh, fail);
    } else if (!is_ignored_in_obj(keyword)) {
      fail("begins with ", in_quotes(keyword), ", expected polygons (v, f); export the mesh in triangles");
    }
  }
  result.spacing = digits.spacing(mesh);
  return result;
}

// --- PLY.

struct PlyProperty {
  std::string name, type, count_type;  // count_type: of a list
};
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

std::size_t size_of_type(const std::string& type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "int" || type == "uint" || type == "int32" || type == "uint32" || type == "float" || type == "float32")
    return 4;
  return type == "double" || type == "float64" ? 8 : 0;
}

bool is_real(const std::string& type) { return type[0] == 'f' || type[0] == 'd'; }

// Numbers of the body of a PLY file, in its order: words of a text, or bytes.
class PlyNumbers {
 public:
  PlyNumbers(const std::string& bytes, const std::string& file, MeshText& words, const std::string& format)
      : bytes_(bytes),
        file_(file),
        words_(words),
        text_(format == "ascii"),
        big_(format == "binary_big_endian"),
        at_(words.position()) {}

  double next(const std::string& type) {
    if (text_) {
      word_ = words_.require("a number, as the head announces");
      return words_.number(word_);
    }
    const std::size_t size = size_of_type(type);
    if (bytes_.size() - at_ < size)
      fail("the file ends within the elements that its head announces: it is cut off", kAgain);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i)
      bits = bits << 8 | static_cast<unsigned char>(bytes_[at_ + (big_ ? i : size - 1 - i)]);
    at_ += size;
    return value_of(type, bits);
  }
  std::string_view word() const { return word_; }  // of a text; until the next number
  bool is_text() const { return text_; }
  // Nothing but blanks follows.
  void require_end() {
    std::string_view word;
    if (text_ ? words_.next_word(word) : bytes_.find_first_not_of(" \r\n", at_) != std::string::npos)
      fail("more elements than the head announces", kAgain);
  }
  template <class... Pieces>
  [[noreturn]] void fail(const Pieces&... what) const {
    if (text_) words_.fail(what...);
    throw InputError(code::kMeshDamaged, file_, ": ", what...);
  }

 private:
  static double value_of(const std::string& type, std::uint64_t bits) {
    const auto as = [&](auto number) {
      // The low bytes of `bits`, as bytes of that number on this machine.
      const auto same_size = [&](auto unsigned_bits) { std::memcpy(&number, &unsigned_bits, sizeof number); };
      if constexpr (sizeof number == 1) same_size(static_cast<std::uint8_t>(bits));
      if constexpr (sizeof number == 2) same_size(static_cast<std::uint16_t>(bits));
      if constexpr (sizeof number == 4) same_size(static_cast<std::uint32_t>(bits));
      if constexpr (sizeof number == 8) same_size(bits);
      return static_cast<double>(number);
    };
    if (type == "char" || type == "int8") return as(std::int8_t{});
    if (type == "uchar" || type == "uint8") return as(std::uint8_t{});
    if (type == "short" || type == "int16") return as(std::int16_t{});
    if (type == "ushort" || type == "uint16") return as(std::uint16_t{});
    if (type == "int" || type == "int32") return as(std::int32_t{});
    if (type == "uint" || type == "uint32") return as(std::uint32_t{});
    if (type == "float" || type == "float32") return as(float{});
    return as(double{});
  }

  const std::string& bytes_;
  const std::string& file_;
  MeshText& words_;
  bool text_, big_;
  std::size_t at_;
  std::string_view word_;
};

// The head, up to the line after "end_header". Returns the format.
std::string ply_head(MeshText& words, std::size_t bytes, std::vector<PlyElement>& elements) {
  std::string_view word;
  std::string format;
  words.require_keyword("ply");
  for (;;) {
    if (!words.next()) words.fail("the file ends without \"end_header\": it is cut off", kAgain);
    if (!words.word_in_line(word) || word == "comment" || word == "obj_info") continue;
    const auto in_line = [&](const std::string& what) {
      std::string_view found;
      if (!words.word_in_line(found)) words.fail("the line ends, expected ", what, kAgain);
      return std::string(found);
    };
    if (word == "end_header") {
      if (format.empty()) words.fail("no line \"format\" in the head", kAgain);
      return format;
    }
    if (word == "format") {
      format = in_line("a format");
      if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
        words.fail("the format is ", in_quotes(format), ", expected ascii or binary", kAgain);
    } else if (word == "element") {
      PlyElement& element = elements.emplace_back();
      element.name = in_line("a name");
      const long count = words.whole(in_line("a number"));
      if (count < 0 || static_cast<std::size_t>(count) > bytes)  // each takes a byte at least
        words.fail("announces ", count, " elements in a file of ", bytes, " bytes", kAgain);
      element.count = static_cast<std::size_t>(count);
    } else if (word == "property" && !elements.empty()) {
      PlyProperty property;
      property.type = in_line("a type");
      if (property.type == "list") {
        property.count_type = in_line("a type");
        property.type = in_line("a type");
      }
      property.name = in_line("a name");
      for (const std::string& type : {property.type, property.count_type})
        if (!type.empty() && size_of_type(type) == 0) words.fail("the type ", in_quotes(type), " is unknown", kAgain);
      elements.back().properties.push_back(property);
    } else {
      words.fail("begins with ", in_quotes(word), ", expected element, property, comment or end_header", kAgain);
    }
  }
}

MeshFile ply(const std::string& bytes, const std::string& file) {
  MeshText words(bytes, file);
  std::vector<PlyElement> elements;
  const std::string format = ply_head(words, bytes.size(), elements);
  PlyNumbers numbers(bytes, file, words, format);
  MeshFile result;
  TriangleMesh& mesh = result.mesh;
  Digits digits;
  double largest = 0.0;
  const auto fail = [&](const auto&... what) { numbers.fail(what...); };
  for (const PlyElement& element : elements) {
    const bool vertices = element.name == "vertex", faces = element.name == "face";
    if (!vertices && !faces && element.count > 0 && element.name == "tristrips")
      fail("has strips of triangles, expected faces; export the mesh in triangles");
    if (element.properties.empty() && element.count > 0)
      fail("element ", in_quotes(element.name), " has no properties", kAgain);
    for (std::size_t e = 0; e < element.count; ++e) {
      Vector3d x = Vector3d::Zero();
      std::vector<int> corners;
      int found = 0;
      for (const PlyProperty& property : element.properties) {
        const bool is_corners = faces && (property.name == "vertex_indices" || property.name == "vertex_index");
        if (property.count_type.empty()) {
          const double value = numbers.next(property.type);
          const int axis = property.name == "x" ? 0 : property.name == "y" ? 1 : property.name == "z" ? 2 : -1;
          if (!vertices || axis < 0) continue;
          if (!std::isfinite(value)) fail("vertex ", e, " has a coordinate that is no finite number", kAgain);
          x(axis) = value;
          ++found;
          result.single =
              result.single || (!numbers.is_text() && is_real(property.type) && size_of_type(property.type) == 4);
          if (numbers.is_text()) digits.add(axis, numbers.word(), value);
          continue;
        }
        const double count = numbers.next(property.count_type);
        if (!(count >= 0.0) || count != std::floor(count)) fail("a list of ", count, " numbers", kAgain);
        for (double i = 0.0; i < count; ++i) {
          const double value = numbers.next(property.type);
          if (!is_corners) continue;
          if (!(std::abs(value) < 1e9) || value != std::floor(value)) fail("a face has corner ", value, kAgain);
          corners.push_back(static_cast<int>(value));
        }
      }
      if (vertices) {
        if (found != 3) fail("vertices have ", found, " of the properties x, y, z", kAgain);
        largest = std::max(largest, x.cwiseAbs().maxCoeff());
        mesh.vertices.push_back(x);
      }
      if (faces) add_face(corners, mesh, fail);
    }
  }
  numbers.require_end();
  result.spacing = result.single ? kSingle * largest : digits.spacing(mesh);
  return result;
}

// --- OFF: counts, vertices, faces, each in a line of its own; colours behind them are left out.

MeshFile off(const std::string& bytes, const std::string& file) {
  MeshText words(bytes, file);
  MeshFile result;
  TriangleMesh& mesh = result.mesh;
  Digits digits;
  const auto fail = [&](const auto&... what) { words.fail(what...); };
  // The first word of the next line that is no comment.
  const auto begin = [&](std::string_view expected) {
    for (;;) {
      const std::string_view word = words.require(expected);
      if (word[0] != '#') return word;
      words.next();
    }
  };
  const auto in_line = [&](const std::string& expected) {
    std::string_view word;
    if (!words.word_in_line(word)) fail("the line ends, expected ", expected, kAgain);
    return word;
  };
  std::string_view word = begin("\"OFF\" and the numbers of vertices and faces");
  const std::string head = lower(word);
  if (head.size() >= 3 && head.compare(head.size() - 3, 3, "off") == 0) {
    if (head.find('4') != std::string::npos || head[0] == 'n')
      if (head != "noff") fail("is ", in_quotes(word), ", expected vertices of three coordinates", kAgain);
    std::string_view more;
    if (words.word_in_line(more) && lower(more) == "binary") fail("is binary, expected text", kAgain);
    word = more.empty() || more[0] == '#' ? (words.next(), begin("the numbers of vertices and faces")) : more;
  }
  const long vertices = words.whole(word), faces = words.whole(in_line("the number of faces"));
  if (vertices < 0 || faces < 0 || static_cast<std::size_t>(vertices) > bytes.size() ||
      static_cast<std::size_t>(faces) > bytes.size())
    fail("announces ", vertices, " vertices and ", faces, " faces in a file of ", bytes.size(), " bytes", kAgain);
  words.next();
  for (long v = 0; v < vertices; ++v) {
    Vector3d& x = mesh.vertices.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const std::string_view coordinate = i == 0 ? begin("a vertex") : in_line("three coordinates");
      x(i) = words.number(coordinate);
      digits.add(i, coordinate, x(i));
    }
    words.next();
  }
  for (long f = 0; f < faces; ++f) {
    const long corners = words.whole(begin("a face"));
    if (corners < 0 || static_cast<std::size_t>(corners) > bytes.size())
      fail("a face has ", corners, " corners", kAgain);
    std::vector<int> face;
    for (long i = 0; i < corners; ++i) {
      const long n = words.whole(in_line("the corners of a face"));
      if (n < 0 || n >= vertices) fail("a face has corner ", n, " (from 0) of ", vertices, " vertices", kAgain);
      face.push_back(static_cast<int>(n));
    }
    if (corners >= 3) add_face(face, mesh, fail);  // points and lines are no surface
    words.next();
  }
  while (words.next_word(word)) {
    if (word[0] != '#') fail("more elements than the head announces", kAgain);
    words.next();
  }
  result.spacing = digits.spacing(mesh);
  return result;
}

// --- Meshes of finite-element codes.

MeshFile fe_mesh(const std::string& bytes, const std::string& file) {
  const FeMesh mesh = parse_fe_mesh(bytes, file);
  MeshFile result;
  result.mesh.vertices = mesh.points;
  result.mesh.triangles = skin_of(mesh);
  return result;
}

std::string end_of(const std::string& file) {
  const std::size_t dot = file.find_last_of("./");
  return dot == std::string::npos || file[dot] == '/' ? "" : lower(file.substr(dot));
}

}  // namespace

bool is_mesh_name(const std::string& file) {
  const std::string end = end_of(file);
  return end == ".stl" || end == ".obj" || end == ".ply" || end == ".off" || is_fe_mesh_name(file);
}

MeshFile parse_mesh(const std::string& bytes, const std::string& file) {
  const std::string end = end_of(file);
  if (is_fe_mesh_name(file)) return fe_mesh(bytes, file);
  if (end == ".off") return off(bytes, file);
  if (end == ".obj") return obj(bytes, file);
  if (end == ".ply") return ply(bytes, file);
  return is_text_stl(bytes) ? text_stl(bytes, file) : binary_stl(bytes, file);
}

}  // namespace footfall

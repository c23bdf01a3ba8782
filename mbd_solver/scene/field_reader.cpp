// From a tree of values to structs: units and suffixes, values of every type with their ranges, and the visitor that
// remembers which keys were known, found and refused.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>

#include "coupler/base/concat.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/budget.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

namespace {
constexpr double kStandardGravity = 9.80665;    // [m/s2]
constexpr double kLargestWhole = 2147483647.0;  // seeds of runs of a campaign go that far

struct UnitEntry {
  const char* name;
  std::vector<UnitSuffix> suffixes;
};

const UnitEntry& entry(Unit unit) {
  static const std::map<Unit, UnitEntry> table = {
      {Unit::kNone, {"", {}}},
      {Unit::kLength, {"m", {{"_mm", 1e-3}, {"_cm", 1e-2}}}},
      {Unit::kArea, {"m2", {{"_mm2", 1e-6}, {"_cm2", 1e-4}}}},
      {Unit::kArea2, {"m4", {{"_mm4", 1e-12}, {"_cm4", 1e-8}}}},
      {Unit::kVolume, {"m3", {{"_cm3", 1e-6}, {"_l", 1e-3}}}},
      {Unit::kAngle, {"rad", {{"_deg", kPi / 180.0}}}},
      {Unit::kTime, {"s", {{"_ms", 1e-3}, {"_us", 1e-6}}}},
      {Unit::kMass, {"kg", {{"_g", 1e-3}, {"_t", 1e3}}}},
      {Unit::kDensity, {"kg/m3", {{"_g_cm3", 1e3}}}},
      {Unit::kInertia, {"kg m2", {}}},
      {Unit::kVelocity, {"m/s", {{"_mm_s", 1e-3}, {"_km_h", 1.0 / 3.6}}}},
      {Unit::kAngularVelocity, {"rad/s", {{"_deg", kPi / 180.0}, {"_rpm", kPi / 30.0}}}},
      {Unit::kAcceleration, {"m/s2", {{"_g", kStandardGravity}}}},
      {Unit::kForce, {"N", {{"_kN", 1e3}}}},
      {Unit::kPressure, {"Pa", {{"_kPa", 1e3}, {"_MPa", 1e6}, {"_GPa", 1e9}}}},
      {Unit::kFrequency, {"Hz", {{"_kHz", 1e3}}}},
      {Unit::kStiffness, {"N/m", {{"_N_mm", 1e3}}}},
      {Unit::kDamping, {"N s/m", {}}},
      {Unit::kTurningStiffness, {"N m/rad", {{"_Nm_deg", 180.0 / kPi}}}},
      {Unit::kTurningDamping, {"N m s/rad", {}}},
      {Unit::kTorque, {"N m", {{"_Nmm", 1e-3}, {"_kNm", 1e3}}}},
  };
  return table.at(unit);
}
}  // namespace

const char* unit_name(Unit unit) { return entry(unit).name; }
const std::vector<UnitSuffix>& unit_suffixes(Unit unit) { return entry(unit).suffixes; }

// Texts of findings about values, and the ranges of numbers.
using namespace code;

std::string is_expected(const ConfigNode& node, const std::string& expected) {
  return with_code(kWrongType, "is " + node.description() + ", expected " + expected);
}

// One value of a file into one member of a struct, with its unit and range. Each read_value returns an empty text, or what is
// wrong and what was expected, with its code; the member then keeps its default.
struct ValueContext {
  const Rule& rule;
  double factor;              // written value * factor = SI value
  const std::string& folder;  // of the scene: tables in files are relative to it
};

// "a number [m]".
static std::string with_unit(const std::string& what, const Rule& rule) {
  const std::string unit = unit_name(rule.unit);
  return unit.empty() ? what : what + " [" + unit + "]";
}

// `value` in SI units, which the message uses as well. Empty: the value is in its range.
static std::string check_range(double value, const Rule& rule) {
  constexpr double kSmallest = 1e-100, kLargest = 1e100;  // the product of two such numbers is still finite
  std::string expected;
  if (!std::isfinite(value)) {
    expected = "a finite number";
  } else if (value != 0.0 && !(std::abs(value) >= kSmallest && std::abs(value) <= kLargest)) {
    expected = concat("0 or a magnitude from ", kSmallest, " to ", kLargest);
  } else if (rule.range == Range::kPositive && !(value > 0.0)) {
    expected = "more than 0";
  } else if (rule.range == Range::kNotNegative && !(value >= 0.0)) {
    expected = "0 or more";
  } else if (rule.range == Range::kUnitInterval && !(value >= 0.0 && value <= 1.0)) {
    expected = "a number from 0 to 1";
  }
  if (expected.empty()) return "";
  const std::string unit = unit_name(rule.unit);
  return with_code(kOutOfRange, "is ", value, unit.empty() ? "" : " " + unit, ", expected ", expected);
}

// The numbers of a list of known length (count 0: any length), range-checked; `expected` replaces "a list of 3 numbers".
static std::string read_numbers(const ConfigNode& node, const ValueContext& c, std::size_t count,
                                std::vector<double>& values, std::string expected = "") {
  if (expected.empty())
    expected = with_unit(count ? concat("a list of ", count, " numbers") : "a list of numbers", c.rule);
  if (node.kind != ConfigNode::Kind::kList || (count && node.list.size() != count)) return is_expected(node, expected);
  std::vector<double> result;
  for (const ConfigNode& item : node.list) {
    if (!item.is_number()) return with_code(kWrongType, "contains " + item.description() + ", expected " + expected);
    result.push_back(item.number * c.factor);
    const std::string problem = check_range(result.back(), c.rule);
    if (!problem.empty()) return concat("number ", result.size(), " ", problem);
  }
  values = std::move(result);
  return "";
}

// Each item of a list by the reader of one item. `target` changes only if all are good.
template <class T>
std::string read_list(const ConfigNode& node, const ValueContext& c, const std::string& expected,
                      std::vector<T>& target) {
  if (node.kind != ConfigNode::Kind::kList) return is_expected(node, expected);
  std::vector<T> result;
  for (const ConfigNode& item : node.list) {
    T value{};
    const std::string problem = read_value(item, c, value);
    result.push_back(value);
    if (!problem.empty()) return concat("entry ", result.size(), " ", problem);
  }
  target = std::move(result);
  return "";
}

// A list of two.
template <class T>
std::string read_pair(const ConfigNode& node, const ValueContext& c, const std::string& expected,
                      std::array<T, 2>& target) {
  std::vector<T> list;
  const std::string problem = read_value(node, c, list);
  if (!problem.empty()) return problem;
  if (list.size() != 2) return is_expected(node, expected);
  target = {list[0], list[1]};
  return "";
}

template <class T>
static std::string read_value(const ConfigNode& node, const ValueContext& c, std::optional<T>& target) {
  T value{};
  const std::string problem = read_value(node, c, value);
  if (problem.empty()) target = value;
  return problem;
}

static std::string read_value(const ConfigNode&, const ValueContext&, Source&) { return ""; }  // handled by the reader

namespace {

using Kind = ConfigNode::Kind;

// Names of arrays stand in braces until their entries are copied: "leg_{leg}", and with the copies that are meant: "leg_{leg!2}".
std::string without_braces(const std::string& text) {
  std::string plain;
  bool within = false, copies = false;
  for (const char c : text) {
    within = c == '{' || (within && c != '}');
    copies = within && (copies || c == '=' || c == '!');
    if (!copies) plain += c == '{' || c == '}' ? '_' : c;
  }
  return plain;
}

}  // namespace

static std::string read_value(const ConfigNode& node, const ValueContext& c, double& target) {
  if (!node.is_number()) return is_expected(node, with_unit("a number", c.rule));
  const double value = node.number * c.factor;
  const std::string problem = check_range(value, c.rule);
  if (problem.empty()) target = value;
  return problem;
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, int& target) {
  if (node.kind != Kind::kInteger || std::abs(node.number) > kLargestWhole) return is_expected(node, "a whole number");
  const std::string problem = check_range(node.number, c.rule);
  if (problem.empty()) target = static_cast<int>(node.number);
  return problem;
}

static std::string read_value(const ConfigNode& node, const ValueContext&, bool& target) {
  if (node.kind != Kind::kFlag) return is_expected(node, "true or false");
  target = node.flag;
  return "";
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, std::string& target) {
  if (c.rule.meaning == Meaning::kWords && node.is_number()) {
    const bool whole = node.kind == Kind::kInteger;  // seeds have many digits
    target = whole ? std::to_string(static_cast<long long>(node.number)) : number_text(node.number);
    return "";
  }
  if (node.kind != Kind::kText) return is_expected(node, "text in quotes");
  if (node.text.empty() && c.rule.required) return with_code(kMissingKey, "is empty, expected a name");
  if (c.rule.meaning == Meaning::kName && !node.text.empty() && !is_plain_name(without_braces(node.text)))
    return with_code(kBadName, "is ", node.description(), ", expected a name of at most ", kLongestName,
                     " letters, digits, _ - and . (not first): it becomes a column and a file");
  target = node.text;
  return "";
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<std::string>& target) {
  if (c.rule.meaning != Meaning::kWords || node.kind == Kind::kList)
    return read_list(node, c, "a list of texts", target);
  std::string word;
  const std::string problem = read_value(node, c, word);
  if (problem.empty()) target = {word};
  return problem;
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, std::array<std::string, 2>& target) {
  return read_pair(node, c, "two names of bodies", target);
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<double>& target) {
  if (!node.is_number()) return read_numbers(node, c, 0, target);
  double value = 0.0;  // one number is a list of one
  const std::string problem = read_value(node, c, value);
  if (problem.empty()) target = {value};
  return problem;
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<int>& target) {
  return read_list(node, c, "a list of whole numbers", target);
}

std::vector<Eigen::Vector2d> read_two_columns(const std::string& file) {
  CsvReader csv(file, "a text file with two columns of numbers", CsvReader::Separators::kAny);
  std::vector<Eigen::Vector2d> rows;
  ReadBudget cells(limit::kTableCells, file);
  for (bool first = true; csv.next(); first = false) {
    const char begin = csv.cells().front().front();
    if (first && (std::isalpha(static_cast<unsigned char>(begin)) || begin == '"')) continue;  // names of the columns
    csv.require_width(2);
    cells.take(2);
    rows.emplace_back(csv.number(0), csv.number(1));
  }
  return rows;
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<Eigen::Vector2d>& target) {
  std::vector<Eigen::Vector2d> result;
  if (node.kind == Kind::kText) {
    try {
      result = read_two_columns((std::filesystem::path(c.folder) / node.text).string());
    } catch (const InputError& e) {
      return e.what();
    }
    for (Eigen::Vector2d& row : result) row[1] *= c.factor;
  } else {
    const std::string expected = "pairs [[x, y], [x, y], ...], or the name of a CSV file with two columns";
    if (node.kind != Kind::kList) return is_expected(node, expected);
    for (const ConfigNode& item : node.list) {
      if (item.kind != Kind::kList || item.list.size() != 2 || !item.list[0].is_number() || !item.list[1].is_number())
        return with_code(kWrongType, "contains " + item.description() + ", expected " + expected);
      result.emplace_back(item.list[0].number, item.list[1].number * c.factor);
    }
  }
  if (result.size() < 2) return with_code(kWrongCount, "has ", result.size(), " rows, expected at least two");
  for (std::size_t i = 1; i < result.size(); ++i) {
    if (!(result[i][0] > result[i - 1][0]))
      return with_code(kNotRising, "does not rise: row ", i + 1, " begins with ", result[i][0], " after ",
                       result[i - 1][0], "; expected a rising first column");
  }
  target = std::move(result);
  return "";
}

static std::string read_value(const ConfigNode& node, const ValueContext& c,
                              std::map<std::string, std::string>& target) {
  if (node.kind != Kind::kTable) return is_expected(node, "a table { name = value, ... }");
  std::map<std::string, std::string> result;
  for (const auto& [key, value] : node.table) {
    if (value.kind == Kind::kText) {
      result[key] = value.text;
    } else if (value.is_number() && c.rule.meaning == Meaning::kWords) {
      read_value(value, c, result[key]);  // the same text as in a list of words
    } else if (value.is_number()) {
      char buffer[40];  // the shortest text that reads back as the same number
      result[key] = std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value.number).ptr);
    } else {
      return "variable \"" + key + "\" " + is_expected(value, "a number or text");
    }
  }
  target = std::move(result);
  return "";
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, NamedTexts& target) {
  target.names->clear();
  if (node.kind == Kind::kList) return read_value(node, c, *target.texts);
  if (node.kind != Kind::kTable) return is_expected(node, "a list of texts, or a table { name = \"...\", ... }");
  target.texts->clear();
  for (const auto& [key, value] : node.table) {
    if (value.kind != Kind::kText && !value.is_number())
      return "\"" + key + "\" " + is_expected(value, "a text or number");
    target.names->push_back(key);
    target.texts->push_back(value.kind == Kind::kText ? value.text : number_text(value.number, 17));
  }
  return "";
}

static std::string read_value(const ConfigNode& node, const ValueContext&, Choice& target) {
  for (std::size_t i = 0; i < target.names.size(); ++i) {
    if (node.kind != Kind::kText || node.text != target.names[i]) continue;
    target.value = static_cast<int>(i);
    return "";
  }
  return with_code(kUnknownChoice, "is " + node.description() + ", which is none of the choices." +
                                       known_names("choices", node.text, target.names));
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, NumberOrWord& target) {
  if (node.kind != Kind::kText) return read_value(node, c, *target.number);
  if (node.text != target.word) return is_expected(node, with_unit("a number", c.rule) + " or \"" + target.word + "\"");
  *target.is_word = true;
  return "";
}

// Vectors, directions, rotations and inertia tensors of a scene file.

namespace {

std::string named_axis(const ConfigNode& node, Eigen::Vector3d& axis) {
  const bool minus = !node.text.empty() && node.text[0] == '-';
  const std::string letter = node.text.substr(minus ? 1 : 0);
  if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z')
    return is_expected(node, "three numbers, or \"x\", \"y\", \"z\", \"-x\" ...");
  axis = (minus ? -1.0 : 1.0) * Eigen::Vector3d::Unit(letter[0] - 'x');
  return "";
}

}  // namespace

static std::string read_value(const ConfigNode& node, const ValueContext& c, Eigen::Vector3d& target) {
  const bool direction = c.rule.meaning == Meaning::kDirection;
  if (direction && node.kind == ConfigNode::Kind::kText) return named_axis(node, target);
  std::vector<double> v;
  const std::string problem = read_numbers(node, c, 3, v);
  if (!problem.empty()) return problem;
  const Eigen::Vector3d vector(v[0], v[1], v[2]);
  if (direction && !(vector.norm() > 0.0))
    return with_code(kOutOfRange, "is zero and has no direction, expected a vector such as [0, 0, 1]");
  target = direction ? vector.normalized() : vector;
  return "";
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, std::vector<Eigen::Vector3d>& target) {
  return read_list(node, c, with_unit("a list of points [x, y, z]", c.rule), target);
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, std::array<Eigen::Vector3d, 2>& target) {
  return read_pair(node, c, "two points [[x, y, z], [x, y, z]]", target);
}

static std::string read_value(const ConfigNode& node, const ValueContext& c, PerAxis& target) {
  if (node.kind == ConfigNode::Kind::kList) return read_value(node, c, *target.values);
  double all = 0.0;
  const std::string problem = read_value(node, c, all);
  if (problem.empty()) target.values->setConstant(all);
  return problem;
}

namespace {

double radians_per_degree() { return unit_suffixes(Unit::kAngle).front().factor; }

// { axis = [x, y, z], angle_deg = phi }, as `rotate` of a mesh in a LIGGGHTS script.
std::string read_axis_and_angle(const ConfigNode& node, Eigen::Quaterniond& target) {
  const ConfigNode* axis_node = node.find("axis");
  const ConfigNode* degrees = node.find("angle_deg");
  const ConfigNode* angle_node = degrees ? degrees : node.find("angle");
  if (!axis_node || !angle_node) return is_expected(node, "{ axis = [x, y, z], angle_deg = phi }");
  Rule direction;
  direction.meaning = Meaning::kDirection;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double angle = 0.0;
  if (const std::string problem = read_value(*axis_node, {direction, 1.0, ""}, axis); !problem.empty())
    return "axis " + problem;
  const double factor = degrees ? radians_per_degree() : 1.0;
  if (const std::string problem = read_value(*angle_node, {Rule(), factor, ""}, angle); !problem.empty())
    return "angle " + problem;
  target = Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
  return "";
}

}  // namespace

static std::string read_value(const ConfigNode& node, const ValueContext&, Eigen::Quaterniond& target) {
  const std::string expected =
      "{ rpy_deg = [roll, pitch, yaw] }, { rpy = [...] } in rad, { quaternion = [w, x, y, z] }, or { axis = [x, y, z], "
      "angle_deg = phi }";
  const bool table = node.kind == ConfigNode::Kind::kTable;
  if (table && node.table.size() == 2) return read_axis_and_angle(node, target);
  if (!table || node.table.size() != 1) return is_expected(node, expected);
  const auto& [key, value] = node.table.front();
  const bool quaternion = key == "quaternion";
  if (!quaternion && key != "rpy" && key != "rpy_deg")
    return with_code(kUnknownKey, "contains the unknown key \"" + key + "\", expected " + expected);
  std::vector<double> v;
  const double factor = key == "rpy_deg" ? radians_per_degree() : 1.0;
  const std::string problem = read_numbers(value, {Rule(), factor, ""}, quaternion ? 4 : 3, v);
  if (!problem.empty()) return key + " " + problem;
  if (!quaternion) {
    target = rotation_from_rpy(v[0], v[1], v[2]);
    return "";
  }
  const Eigen::Quaterniond q(v[0], v[1], v[2], v[3]);
  if (std::abs(q.norm() - 1.0) > 1e-3)
    return with_code(kOutOfRange, "quaternion has the length ", q.norm(), ", expected 1");
  target = q.normalized();
  return "";
}

// Symmetric: [xx, yy, zz] or [xx, yy, zz, xy, yz, zx].
static std::string read_value(const ConfigNode& node, const ValueContext& c, Eigen::Matrix3d& target) {
  Rule rule = c.rule;
  rule.range = Range::kAny;
  std::vector<double> v;
  const bool full = node.kind == ConfigNode::Kind::kList && node.list.size() == 6;
  const std::string expected = with_unit("a list of 3 numbers", rule) + " (Ixx, Iyy, Izz), or 6 (..., Ixy, Iyz, Izx)";
  const std::string problem = read_numbers(node, {rule, c.factor, c.folder}, full ? 6 : 3, v, expected);
  if (!problem.empty()) return problem;
  v.resize(6, 0.0);
  target << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
  return "";
}

// The visitor that fills structs from a tree of values and remembers which keys were known, found and refused.

namespace {

const ConfigNode& empty_table() {
  static const ConfigNode node;
  return node;
}

class FieldReader final : public FieldVisitor {
 public:
  FieldReader(const ConfigNode& root, const std::string& folder, Findings& findings)
      : folder_(folder), findings_(findings) {
    frames_.push_back({&root, "", "", nullptr, {}, {}});
  }
  void finish() { report_unknown_keys(); }

  void field(const std::string& key, const FieldRef& ref, const Rule& rule) override {
    if (Source* const* source = std::get_if<Source*>(&ref)) {
      Frame& frame = frames_.back();
      **source = Source{frame.path, frame.node->line, {}, {}, {}};
      frame.source = *source;
      frame.local.clear();
      return;
    }
    const std::optional<Given> given = take(key, rule);
    if (!given) return;
    const ValueContext context{rule, given->factor, folder_};
    const std::string problem =
        std::visit([&](auto* target) { return read_value(*given->node, context, *target); }, ref);
    if (problem.empty()) {
      warn_of_degrees(key, *given, ref, rule);
      return;
    }
    findings_.coded_error(given->node->line, path_of(given->written), problem);
    const Frame& frame = frames_.back();
    if (frame.source) frame.source->refused.insert(frame.local + key);
  }

  bool begin_section(const std::string& key, Presence presence, bool& present) override {
    const std::optional<Given> given = take(key, {});
    const ConfigNode* node = given ? given->node : &empty_table();
    if (given && presence == Presence::kSwitch && node->kind == ConfigNode::Kind::kFlag) {
      present = true;  // flexible = true / false is short for { enabled = true / false }
      switch_table_ = ConfigNode{};
      switch_table_.table.emplace_back("enabled", *node);
      node = &switch_table_;
    } else if (given && node->kind != ConfigNode::Kind::kTable) {
      const std::string expected = presence == Presence::kSwitch ? "a table, true or false" : "a table";
      findings_.coded_error(node->line, path_of(key), is_expected(*node, expected));
      node = &empty_table();
      present = presence == Presence::kAlways;
      if (!present) return false;
    } else if (presence != Presence::kAlways) {
      present = given.has_value();
      if (!present) return false;
    }
    push(key, *node);
    return true;
  }

  void end_section() override { pop(); }

  int begin_list(const std::string& key, bool named, int) override {
    lists_.push_back({nullptr, key, named});
    const std::optional<Given> given = take(key, {});
    if (!given) return 0;
    const ConfigNode& node = *given->node;
    const bool is_list = node.kind == ConfigNode::Kind::kList &&
                         std::all_of(node.list.begin(), node.list.end(),
                                     [](const ConfigNode& n) { return n.kind == ConfigNode::Kind::kTable; });
    const bool is_named = node.kind == ConfigNode::Kind::kTable &&
                          std::all_of(node.table.begin(), node.table.end(),
                                      [](const auto& n) { return n.second.kind == ConfigNode::Kind::kTable; });
    if (named ? !is_named : !is_list) {
      const std::string path = path_of(key);
      findings_.coded_error(node.line, path,
                            is_expected(node, named ? "tables with names, [" + path + ".NAME]"
                                                    : "a list of tables, [[" + path + "]] or [{...}, {...}]"));
      return 0;
    }
    lists_.back().node = &node;
    return static_cast<int>(named ? node.table.size() : node.list.size());
  }

  void begin_item(int index, std::string* name) override {
    const List& list = lists_.back();
    const std::size_t i = index;
    const ConfigNode& node = list.named ? list.node->table[i].second : list.node->list[i];
    if (name) *name = list.node->table[i].first;
    std::string label = list.named ? list.node->table[i].first : node.entry_name();
    if (label.empty()) label = std::to_string(index);
    push(list.key + "." + label, node);
    frames_.back().local = concat(frames_[frames_.size() - 2].local, list.key, ".", index, ".");
  }

  void end_item() override { pop(); }
  void end_list() override { lists_.pop_back(); }

 private:
  struct Frame {
    const ConfigNode* node;
    std::string path;                // for messages: "bodies.cabin.shape"
    std::string local;               // before a key in source->lines: "shape."
    Source* source;                  // of the entry around
    std::vector<std::string> known;  // keys that are described
    std::vector<std::string> taken;  // keys that the file has, as written
  };
  struct List {
    const ConfigNode* node;
    std::string key;
    bool named;
  };
  struct Given {
    const ConfigNode* node;
    double factor;        // to SI
    std::string written;  // the key with its suffix
  };

  void push(const std::string& key, const ConfigNode& node) {
    const Frame& outer = frames_.back();
    frames_.push_back({&node, path_of(key), outer.local + key + ".", outer.source, {}, {}});
  }

  void pop() {
    report_unknown_keys();
    frames_.pop_back();
  }

  std::string path_of(const std::string& key) const {
    const std::string& path = frames_.back().path;
    return path.empty() ? key : path + "." + key;
  }
  void report(const MessageCode& code, const std::string& key, int line, const std::string& what) {
    findings_.error(code, line, path_of(key), what);
  }

  // The value of `key`, whichever unit suffix it is written with; records it as known, taken and given.
  std::optional<Given> take(const std::string& key, const Rule& rule) {
    Frame& frame = frames_.back();
    frame.known.push_back(key);
    std::vector<Given> found;
    if (const ConfigNode* node = frame.node->find(key)) found.push_back({node, 1.0, key});
    for (const UnitSuffix& unit : unit_suffixes(rule.unit)) {
      const std::string written = key + unit.suffix;
      if (const ConfigNode* node = frame.node->find(written)) found.push_back({node, unit.factor, written});
    }
    if (found.empty()) {
      if (rule.required) {
        const std::string unit = unit_name(rule.unit);
        report(kMissingKey, key, frame.node->line,
               "is missing; it has no default" + (unit.empty() ? "" : " (unit " + unit + ")"));
      }
      return std::nullopt;
    }
    for (const Given& g : found) frame.taken.push_back(g.written);
    if (found.size() > 1)
      report(kUnitSuffix, found[1].written, found[1].node->line,
             "is also given as \"" + found[0].written + "\"; keep one of the two");
    // --set overrides the file.
    const auto set =
        std::find_if(found.begin(), found.end(), [](const Given& g) { return g.node->line == Source::kFromSet; });
    const Given& chosen = set != found.end() ? *set : found.front();
    if (const std::string& spelt = chosen.node->spelt; !spelt.empty() && told_.insert(spelt).second) {
      Source at;
      at.path = frame.path;
      at.line = chosen.node->line;
      findings_.warning(kSecondSpelling, at, spelt, "is read as \"", chosen.written,
                        "\", the spelling of this key; write that");
    }
    if (frame.source) frame.source->lines[frame.local + key] = chosen.node->line;
    if (frame.source && chosen.written != key) frame.source->in_other_units.insert(frame.local + key);
    return chosen;
  }

  // An angle of more than a turn without the suffix of degrees.
  void warn_of_degrees(const std::string& key, const Given& given, const FieldRef& ref, const Rule& rule) {
    double largest = 0.0;  // [rad]
    std::string written = given.written;
    if (rule.unit == Unit::kAngle && given.written == key) {
      if (double* const* one = std::get_if<double*>(&ref)) largest = **one;
      if (std::optional<double>* const* one = std::get_if<std::optional<double>*>(&ref))
        largest = (*one)->value_or(0.0);
    } else if (std::holds_alternative<Eigen::Quaterniond*>(ref)) {
      for (const char* part : {"rpy", "angle"}) {
        const ConfigNode* node = given.node->find(part);
        if (node == nullptr) continue;
        written += std::string(".") + part;
        std::vector<double> angles;
        double angle = 0.0;
        if (node->kind == ConfigNode::Kind::kList) {
          read_numbers(*node, {Rule(), 1.0, ""}, 3, angles);
        } else if (read_value(*node, {Rule(), 1.0, ""}, angle).empty()) {
          angles = {angle};
        }
        for (const double value : angles)
          if (std::abs(value) > std::abs(largest)) largest = value;
      }
    }
    if (!(std::abs(largest) > 2.0 * kPi)) return;
    Source at;
    at.path = frames_.back().path;
    at.line = given.node->line;
    const std::size_t dot = written.rfind('.');
    findings_.warning(kAngleInDegrees, at, written, "is ", largest, " rad, ", number_text(largest / (2.0 * kPi), 3),
                      " turns; if degrees are meant, write ", written.substr(dot == std::string::npos ? 0 : dot + 1),
                      "_deg, which also ends this warning for so many turns");
  }

  void report_unknown_keys() {
    const Frame& frame = frames_.back();
    for (const auto& [key, node] : frame.node->table) {
      if (std::find(frame.taken.begin(), frame.taken.end(), key) != frame.taken.end()) continue;
      if (findings_.is_full()) {  // the search of near names takes its time
        findings_.skip_error();
        continue;
      }
      report(kUnknownKey, key, node.line, "unknown key." + known_names("keys here", key, frame.known));
    }
  }

  std::string folder_;
  Findings& findings_;
  std::vector<Frame> frames_;
  std::vector<List> lists_;
  ConfigNode switch_table_;
  std::set<std::string> told_;  // second spellings that have been reported
};

}  // namespace

void read_fields(const ConfigNode& root, const std::string& folder, const std::function<void(FieldVisitor&)>& describe,
                 Findings& findings) {
  FieldReader reader(root, folder, findings);
  describe(reader);
  reader.finish();
}

void read_fields(const ConfigNode& root, Scene& scene, Findings& findings) {
  read_fields(
      root, scene.folder, [&](FieldVisitor& reader) { visit_fields(reader, scene); }, findings);
}

}  // namespace footfall

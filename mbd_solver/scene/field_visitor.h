#pragma once
// The keys of a scene, described once: visit_fields names every key, its member, unit, range and meaning. The TOML
// reader, the copier of arrays, the JSON writer, the schema and the list of known keys are visitors of that description.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/base/kinds.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Unit of a number in SI; field_reader.cpp lists the suffixes that the reader accepts for each.
enum class Unit {
  kNone,
  kLength,
  kArea,
  kArea2,
  kVolume,
  kAngle,
  kTime,
  kMass,
  kDensity,
  kInertia,
  kVelocity,
  kAngularVelocity,
  kAcceleration,
  kForce,
  kPressure,
  kFrequency,
  kStiffness,
  kDamping,
  kTurningStiffness,
  kTurningDamping,
  kTorque
};

enum class Range { kAny, kPositive, kNotNegative, kUnitInterval };

// What a vector or a string means. The copies of an array turn points, directions (unit vectors) and free vectors; in names
// of entries "{array}" is replaced; paths are joined with the scene's folder and must exist. Words are texts that may be
// written as numbers, and a list of one word as that word.
enum class Meaning { kPlain, kPoint, kDirection, kFree, kName, kPath, kWords };

struct Rule {
  Unit unit = Unit::kNone;
  Range range = Range::kAny;
  Meaning meaning = Meaning::kPlain;
  bool required = false;
};

// The rules that most keys have.
namespace rule {
inline constexpr Rule plain{}, name{Unit::kNone, Range::kAny, Meaning::kName},
    path{Unit::kNone, Range::kAny, Meaning::kPath}, point{Unit::kLength, Range::kAny, Meaning::kPoint},
    direction{Unit::kNone, Range::kAny, Meaning::kDirection};
constexpr Rule positive(Unit unit = Unit::kNone) { return {unit, Range::kPositive}; }
constexpr Rule not_negative(Unit unit = Unit::kNone) { return {unit, Range::kNotNegative}; }
inline constexpr Rule share{Unit::kNone, Range::kUnitInterval};  // from 0 to 1
constexpr Rule required(Rule rule = {}) { return {rule.unit, rule.range, rule.meaning, true}; }
}  // namespace rule

struct Choice {  // an enumeration by the names of its values, in order
  int value;
  std::vector<std::string> names;
};

struct NumberOrWord {  // mass = 900 or mass = "remainder"
  double* number;
  std::string word;
  bool* is_word;
};

struct PerAxis {  // stiffness = 100, alike along x, y and z, or [kx, ky, kz]
  Eigen::Vector3d* values;
};

struct NamedTexts {  // inputs = ["a", "b"], or { first = "a", second = "b" }
  std::vector<std::string>* texts;
  std::vector<std::string>* names;  // empty: a list
};

using FieldRef =
    std::variant<double*, std::optional<double>*, int*, std::optional<int>*, bool*, std::string*,
                 std::vector<std::string>*, std::array<std::string, 2>*, Eigen::Vector3d*,
                 std::optional<Eigen::Vector3d>*, std::vector<Eigen::Vector3d>*, std::array<Eigen::Vector3d, 2>*,
                 std::vector<double>*, std::vector<int>*, std::vector<Eigen::Vector2d>*, Eigen::Quaterniond*,
                 Eigen::Matrix3d*, std::map<std::string, std::string>*, Choice*, NumberOrWord*, PerAxis*, NamedTexts*,
                 Source*>;

enum class Presence { kAlways, kOptional, kSwitch };  // kSwitch: key = true / false, or a table

class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;

  virtual void field(const std::string& key, const FieldRef& ref, const Rule& rule) = 0;
  // The origin and the name of an entry.
  void entry(Source& source, std::string& name) {
    field("", &source, {});
    field("name", &name, rule::required(rule::name));
  }
  // Several keys with the same rule.
  void fields(const Rule& rule, std::initializer_list<std::pair<const char*, FieldRef>> list) {
    for (const auto& [key, ref] : list) field(key, ref, rule);
  }
  // Enters the table `key`. `present`: in, whether the struct has it; out, whether it should. False: not entered, and no
  // end_section follows.
  virtual bool begin_section(const std::string& key, Presence presence, bool& present) = 0;
  virtual void end_section() = 0;
  // A list of tables [[key]], or of named tables [key.NAME]; returns how many items there should be, -1: only the keys of
  // one are listed.
  virtual int begin_list(const std::string& key, bool named, int count) = 0;
  virtual void begin_item(int index, std::string* name) = 0;  // name: of a named table, else null
  virtual void end_item() = 0;
  virtual void end_list() = 0;

  template <class Kind>  // by the names of name_of
  void choice(const std::string& key, Kind& kind, const Rule& rule = {}) {
    choice(key, kind, names_of<Kind>(), rule);
  }
  template <class Kind>  // or none, by the word `none`
  void choice(const std::string& key, std::optional<Kind>& kind, const std::string& none) {
    std::vector<std::string> names = names_of<Kind>();
    names.insert(names.begin(), none);
    Choice c{kind ? 1 + static_cast<int>(*kind) : 0, std::move(names)};
    field(key, &c, {});
    kind = c.value > 0 ? std::optional<Kind>(static_cast<Kind>(c.value - 1)) : std::nullopt;
  }
  template <class E>
  void choice(const std::string& key, E& value, std::vector<std::string> names, const Rule& rule = {}) {
    Choice c{static_cast<int>(value), std::move(names)};
    field(key, &c, rule);
    value = static_cast<E>(c.value);
  }
  // `value` is one of the words.
  void choice(const std::string& key, std::string& value, const std::vector<std::string>& words, const Rule& rule = {});
  template <class T>
  void section(const std::string& key, T& value);  // always present
  template <class T>
  // present only when given
  void section(const std::string& key, std::optional<T>& value, Presence presence = Presence::kOptional);
  template <class T, class Describe>
  void section(const std::string& key, std::optional<T>& value, Presence presence, const Describe& describe);
  template <class T>
  void list(const std::string& key, std::vector<T>& items, bool named = false);
};

void visit_fields(FieldVisitor& v, Scene& scene);
void visit_fields(FieldVisitor& v, BodySpec& body);
void visit_fields(FieldVisitor& v, JointSpec& joint);
void visit_fields(FieldVisitor& v, StrutSpec& strut);
void visit_fields(FieldVisitor& v, CableSpec& cable);
void visit_fields(FieldVisitor& v, SpringSpec& spring);
void visit_fields(FieldVisitor& v, ForceSpec& force);
void visit_fields(FieldVisitor& v, DriveSpec& drive);
void visit_fields(FieldVisitor& v, GearSpec& gear);
void visit_fields(FieldVisitor& v, BoundarySpec& boundary);
void visit_fields(FieldVisitor& v, ContactSpec& contact);
void visit_fields(FieldVisitor& v, BodyVelocitySpec& velocity);

inline void FieldVisitor::choice(const std::string& key, std::string& value, const std::vector<std::string>& words,
                                 const Rule& rule) {
  const auto found = std::find(words.begin(), words.end(), value);
  FOOTFALL_DEMAND(found != words.end());
  Choice c{static_cast<int>(found - words.begin()), words};
  field(key, &c, rule);
  value = words[c.value];
}

template <class T>
void FieldVisitor::section(const std::string& key, T& value) {
  bool present = true;
  if (!begin_section(key, Presence::kAlways, present)) return;
  visit_fields(*this, value);
  end_section();
}

template <class T, class Describe>
void FieldVisitor::section(const std::string& key, std::optional<T>& value, Presence presence,
                           const Describe& describe) {
  bool present = value.has_value();
  const bool entered = begin_section(key, presence, present);
  if (present && !value) value.emplace();
  if (!present) value.reset();
  if (!entered) return;
  T unused;  // a visitor that only lists keys enters sections that are absent
  describe(*this, value ? *value : unused);
  end_section();
}

template <class T>
void FieldVisitor::section(const std::string& key, std::optional<T>& value, Presence presence) {
  section(key, value, presence, [](FieldVisitor& v, T& inner) { visit_fields(v, inner); });
}

template <class T>
void FieldVisitor::list(const std::string& key, std::vector<T>& items, bool named) {
  const int count = begin_list(key, named, static_cast<int>(items.size()));
  std::vector<T> unused(1);  // as above
  const bool only_keys = count < 0;
  if (!only_keys) items.resize(count);
  std::vector<T>& visited = only_keys ? unused : items;
  for (int i = 0; i < static_cast<int>(visited.size()); ++i) {
    T& item = visited[i];
    if constexpr (std::is_same_v<T, ArraySpec> || std::is_same_v<T, MaterialSpec> || std::is_same_v<T, SectionSpec> ||
                  std::is_same_v<T, InitialJointSpec>) {
      begin_item(i, &item.name);
    } else {
      begin_item(i, nullptr);
    }
    visit_fields(*this, item);
    end_item();
  }
  end_list();
}

// A walk through the fields of a Scene that are present, with the path of each key.
class FieldWalk final : public FieldVisitor {
 public:
  // Called for every field, the sources of entries included (key "").
  using Action =
      std::function<void(const std::string& key, const FieldRef& ref, const Rule& rule, const FieldWalk& walk)>;
  explicit FieldWalk(Action action) : action_(std::move(action)) {}

  Source* source() const { return stack_.back().source; }  // of the entry around; null outside
  std::string local(const std::string& key) const { return stack_.back().local + key; }  // within that entry
  std::string full(const std::string& key) const { return stack_.back().full + key; }    // within the scene, by index

  void field(const std::string& key, const FieldRef& ref, const Rule& rule) override {
    if (Source* const* source = std::get_if<Source*>(&ref)) {
      stack_.back().source = *source;
      stack_.back().local.clear();
    }
    action_(key, ref, rule, *this);
  }
  bool begin_section(const std::string& key, Presence, bool& present) override {
    if (present) push(key);
    return present;
  }
  void end_section() override { stack_.pop_back(); }
  int begin_list(const std::string& key, bool, int count) override {
    lists_.push_back(key);
    return count;
  }
  void begin_item(int index, std::string*) override { push(lists_.back() + "." + std::to_string(index)); }
  void end_item() override { stack_.pop_back(); }
  void end_list() override { lists_.pop_back(); }

 private:
  struct KeyPrefix {
    Source* source;
    std::string local;  // "gas."
    std::string full;   // "struts.3.gas."
  };
  void push(const std::string& key) { stack_.push_back({source(), local(key) + ".", full(key) + "."}); }

  Action action_;
  std::vector<KeyPrefix> stack_ = {{nullptr, "", ""}};
  std::vector<std::string> lists_;
};

// The member that a field refers to, if it is of this type; else null.
template <class T>
T* member(const FieldRef& ref) {
  T* const* pointer = std::get_if<T*>(&ref);
  return pointer ? *pointer : nullptr;
}

}  // namespace footfall

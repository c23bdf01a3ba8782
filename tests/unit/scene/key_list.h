#pragma once
// The keys that a scene can have, and those that were given.
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

// Enters all sections, present or not; a list counts as one entry "[]".
class KeyLister final : public FieldVisitor {
 public:
  std::set<std::string> keys;
  void field(const std::string& key, const FieldRef&, const Rule&) override {
    if (!key.empty()) keys.insert(prefix() + key);
  }
  bool begin_section(const std::string& key, Presence, bool&) override {
    keys.insert(prefix() + key);
    stack_.push_back(prefix() + key + ".");
    return true;
  }
  void end_section() override { stack_.pop_back(); }
  int begin_list(const std::string& key, bool, int) override {
    keys.insert(prefix() + key);
    stack_.push_back(prefix() + key + "[].");
    return -1;
  }
  void begin_item(int, std::string*) override {}
  void end_item() override {}
  void end_list() override { stack_.pop_back(); }

 private:
  std::string prefix() const { return stack_.empty() ? "" : stack_.back(); }
  std::vector<std::string> stack_;
};

// "flexible.members.0.first" -> "flexible.members[].first"
inline std::string without_indices(const std::string& key) {
  std::string result;
  for (std::size_t i = 0; i < key.size(); ++i) {
    std::size_t end = i + 1;
    while (end < key.size() && key[i] == '.' && std::isdigit(static_cast<unsigned char>(key[end]))) ++end;
    const bool index = end > i + 1 && (end == key.size() || key[end] == '.');
    if (index) {
      result += "[]";
      i = end - 1;
    } else {
      result += key[i];
    }
  }
  return result;
}

// All keys of the reader, as "bodies[].shape.radius", without unit suffixes.
inline std::set<std::string> known_keys() {
  KeyLister lister;
  Scene scene;
  visit_fields(lister, scene);
  return lister.keys;
}

// The keys that were given for this scene, in the same form.
inline std::set<std::string> given_keys(const Scene& scene) {
  std::set<std::string> keys;
  FieldWalk walk([&](const std::string&, const FieldRef& ref, const Rule&, const FieldWalk& at) {
    if (!member<Source>(ref)) return;
    const std::string prefix = without_indices(at.full(""));
    for (const auto& [key, line] : at.source()->lines) keys.insert(prefix + without_indices(key));
  });
  Scene copy = scene;
  visit_fields(walk, copy);
  return keys;
}

}  // namespace footfall

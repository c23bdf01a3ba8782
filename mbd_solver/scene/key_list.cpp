// The keys that a scene can have, and those that were given.
#include <algorithm>

#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/tracking_visitor.h"

namespace footfall {

namespace {

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
std::string without_indices(const std::string& key) {
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

class GivenKeys final : public TrackingVisitor {
 public:
  std::set<std::string> keys;
  void field(const std::string&, const FieldRef& ref, const Rule&) override {
    if (!track(ref)) return;
    const std::string prefix = without_indices(full(""));
    for (const auto& [key, line] : source()->lines) keys.insert(prefix + without_indices(key));
  }
};

}  // namespace

std::set<std::string> known_keys() {
  KeyLister lister;
  Scene scene;
  visit_fields(lister, scene);
  return lister.keys;
}

std::set<std::string> given_keys(const Scene& scene) {
  GivenKeys given;
  Scene copy = scene;
  visit_fields(given, copy);
  return given.keys;
}

}  // namespace footfall

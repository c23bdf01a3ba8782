#pragma once
// A walk through the fields of a Scene that are present, with the path of each key.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

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
  struct Place {
    Source* source;
    std::string local;  // "gas."
    std::string full;   // "struts.3.gas."
  };
  void push(const std::string& key) { stack_.push_back({source(), local(key) + ".", full(key) + "."}); }

  Action action_;
  std::vector<Place> stack_ = {{nullptr, "", ""}};
  std::vector<std::string> lists_;
};

// The member that a field refers to, if it is of this type; else null.
template <class T>
T* member(const FieldRef& ref) {
  T* const* pointer = std::get_if<T*>(&ref);
  return pointer ? *pointer : nullptr;
}

}  // namespace footfall

#pragma once
// Base of visitors that walk through a Scene: enters what is present and knows the path of each key.

#include <string>
#include <vector>

#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

class TrackingVisitor : public FieldVisitor {
 public:
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

 protected:
  // Call first in field(): true for the source of an entry, which is then current.
  bool track(const FieldRef& ref) {
    Source* const* source = std::get_if<Source*>(&ref);
    if (source) {
      stack_.back().source = *source;
      stack_.back().local.clear();
    }
    return source != nullptr;
  }
  Source* source() const { return stack_.back().source; }  // of the entry around; null outside
  std::string local(const std::string& key) const { return stack_.back().local + key; }  // key within that entry
  std::string full(const std::string& key) const { return stack_.back().full + key; }  // key within the scene, by index

 private:
  struct Place {
    Source* source;
    std::string local;  // "gas."
    std::string full;   // "struts.3.gas."
  };
  void push(const std::string& key) { stack_.push_back({source(), local(key) + ".", full(key) + "."}); }

  std::vector<Place> stack_ = {{nullptr, "", ""}};
  std::vector<std::string> lists_;
};

}  // namespace footfall

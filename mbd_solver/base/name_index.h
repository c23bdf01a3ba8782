#pragma once
// Finds entries of a list by name in constant time. The list may still change: every result is verified, and the list
// is read anew when a name is no longer at its place.

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>

namespace footfall {

class NameIndex {
 public:
  // Place of the first entry with this name; name_of(entry): its name.
  template <class List, class NameOf>
  std::optional<std::size_t> find(const List& list, const std::string& name, NameOf name_of) const {
    for (const bool anew : {false, true}) {
      if (anew) {
        first_.clear();
        for (std::size_t i = 0; i < list.size(); ++i) first_.emplace(name_of(list[i]), i);
      }
      const auto found = first_.find(name);
      if (found != first_.end() && found->second < list.size() && name_of(list[found->second]) == name)
        return found->second;
    }
    return std::nullopt;
  }
  template <class List>
  std::optional<std::size_t> find(const List& list, const std::string& name) const {
    return find(list, name, [](const auto& entry) -> const std::string& { return entry.name; });
  }

 private:
  mutable std::unordered_map<std::string, std::size_t> first_;  // as the list was read
};

}  // namespace footfall

#pragma once
// Kinds and their names. An enumeration of kinds has one function
//
//   constexpr std::string_view name_of(Kind kind)
//
// a switch without default, or name_in with the names in the order of the enumeration; it returns "" for other values. The
// number of kinds, their list and the list of their names follow from it.

#include <string>
#include <string_view>
#include <vector>

namespace footfall {

template <class Kind, class... Names>
constexpr std::string_view name_in(Kind kind, const Names&... names) {
  const std::string_view list[] = {names...};
  const int k = static_cast<int>(kind);
  return k >= 0 && k < static_cast<int>(sizeof...(names)) ? list[k] : std::string_view();
}

template <class Kind>
constexpr int count_of() {
  int count = 0;
  while (!name_of(static_cast<Kind>(count)).empty()) ++count;
  return count;
}

template <class Kind>
std::vector<Kind> every() {
  std::vector<Kind> kinds;
  for (int k = 0; k < count_of<Kind>(); ++k) kinds.push_back(static_cast<Kind>(k));
  return kinds;
}

template <class Kind>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for (const Kind kind : every<Kind>()) names.emplace_back(name_of(kind));
  return names;
}

}  // namespace footfall

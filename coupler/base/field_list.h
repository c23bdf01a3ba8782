#pragma once
// The fields of a struct, listed once. Writer, reader and comparison walk the same list, so that no direction forgets
// one:
//
//   template <>
//   inline constexpr auto kFields<Start> = kFieldsOf<&Start::dt, &Start::n>;
//
// A list with fewer or more entries than its struct has members does not compile.

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace footfall {

template <class Struct, class Type>
struct Field {
  std::string_view name;
  Type Struct::*member;
};
template <class Struct, class Type>
Field(std::string_view, Type Struct::*) -> Field<Struct, Type>;

// The name of a member without the underscore at its end, from what the compiler writes:
// "[... kMember = &footfall::Start::dt; ...]".
template <auto kMember>
constexpr std::string_view name_of_member() {
  const std::string_view text = __PRETTY_FUNCTION__;
  const std::size_t end = text.find_first_of(";]", text.find("kMember = "));
  const std::size_t begin = text.rfind("::", end) + 2;
  return text.substr(begin, end - begin - (text[end - 1] == '_' ? 1 : 0));
}
static_assert(name_of_member<&std::pair<int, int>::second>() == "second");

template <auto... kMembers>
inline constexpr auto kFieldsOf = std::tuple{Field{name_of_member<kMembers>(), kMembers}...};

// The list of a struct, a tuple of fields; nullptr for structs without a list.
template <class Struct>
inline constexpr std::nullptr_t kFields = nullptr;

template <class Struct>
inline constexpr bool kHasFields = !std::is_same_v<decltype(kFields<Struct>), const std::nullptr_t>;

// For code that walks fields: is a type a std::vector?
template <class T>
inline constexpr bool kIsVector = false;
template <class Item>
inline constexpr bool kIsVector<std::vector<Item>> = true;

// Compiles only if the struct has as many members as its list.
template <class Struct>
void require_every_member(const Struct& s) {
  constexpr std::size_t kCount = std::tuple_size_v<std::remove_const_t<decltype(kFields<Struct>)>>;
  static_assert(kCount >= 2 && kCount <= 12, "add a case for this number of members");
  if constexpr (kCount == 2) {
    [[maybe_unused]] const auto& [a, b] = s;
  }
  if constexpr (kCount == 3) {
    [[maybe_unused]] const auto& [a, b, c] = s;
  }
  if constexpr (kCount == 4) {
    [[maybe_unused]] const auto& [a, b, c, d] = s;
  }
  if constexpr (kCount == 5) {
    [[maybe_unused]] const auto& [a, b, c, d, e] = s;
  }
  if constexpr (kCount == 6) {
    [[maybe_unused]] const auto& [a, b, c, d, e, f] = s;
  }
  if constexpr (kCount == 7) {
    [[maybe_unused]] const auto& [a, b, c, d, e, f, g] = s;
  }
  if constexpr (kCount == 8) {
    [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h] = s;
  }
  if constexpr (kCount == 9) {
    [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i] = s;
  }
  if constexpr (kCount == 10) {
    [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j] = s;
  }
  if constexpr (kCount == 11) {
    [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j, k] = s;
  }
  if constexpr (kCount == 12) {
    [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = s;
  }
}

// Calls visit(field) for every field of Struct, in the order of the list. The field of an object s: s.*field.member.
template <class Struct, class Visit>
constexpr void for_each_field(Visit&& visit) {
  (void)&require_every_member<Struct>;
  std::apply([&](const auto&... field) { (visit(field), ...); }, kFields<Struct>);
}

}  // namespace footfall

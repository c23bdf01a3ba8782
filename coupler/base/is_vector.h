// Whether a type is a std::vector, for code that walks the fields of messages.
#pragma once

#include <vector>

namespace footfall {

template <class T>
inline constexpr bool kIsVector = false;
template <class Item>
inline constexpr bool kIsVector<std::vector<Item>> = true;

}  // namespace footfall

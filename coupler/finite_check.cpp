#include "coupler/finite_check.h"

#include <cmath>
#include <type_traits>

#include "coupler/base/is_vector.h"
#include "coupler/message_fields.h"

namespace footfall {
namespace {

// "": a number here; ".x", "[3].x": within a part of this one.
struct Found {
  bool bad = false;
  std::string place;
};

template <class T>
Found search(const T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    return {!std::isfinite(value), ""};
  } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    return {};
  } else if constexpr (std::is_base_of_v<Eigen::PlainObjectBase<T>, T>) {
    if constexpr (std::is_floating_point_v<typename T::Scalar>) return {!value.allFinite(), ""};
    return {};
  } else if constexpr (std::is_same_v<T, ModalBoundary>) {
    return search(taken_apart(value));
  } else if constexpr (kIsVector<T>) {
    for (std::size_t i = 0; i < value.size(); ++i)
      if (Found found = search(value[i]); found.bad) return {true, "[" + std::to_string(i) + "]" + found.place};
    return {};
  } else {
    Found first;
    for_each_field<T>([&](const auto& field) {
      if (first.bad) return;
      if constexpr (!kInHead<std::decay_t<decltype(field)>>)
        if (Found found = search(value.*field.member); found.bad) first = {true, "." + (field.name + found.place)};
    });
    return first;
  }
}

}  // namespace

template <class Message>
std::string first_not_finite(const Message& message) {
  const Found found = search(message);
  return found.bad ? found.place.substr(1) : "";
}

template std::string first_not_finite(const Geometry&);
template std::string first_not_finite(const Start&);
template std::string first_not_finite(const Accept&);
template std::string first_not_finite(const Motion&);
template std::string first_not_finite(const Load&);
template std::string first_not_finite(const BodyMotion&);
template std::string first_not_finite(const BodyLoad&);

}  // namespace footfall

#pragma once
// Walks the field lists of the messages: random content, comparison that names the fields, and one value changed at a
// time.

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "coupler/message_fields.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall::test {

template <class T>
inline constexpr bool kIsList = false;
template <class Item>
inline constexpr bool kIsList<std::vector<Item>> = true;

// Calls visit(path, value...) for every number, text, status and matrix below `name`, of one object or of several of
// like shape side by side; shapes(path, size...) for every list.
template <class Shapes, class Visit, class T, class... Others>
void walk(const std::string& path, const Shapes& shapes, const Visit& visit, T& value, Others&... others) {
  using Plain = std::remove_const_t<T>;
  if constexpr (kIsList<Plain>) {
    if (!shapes(path, value, others...)) return;
    for (std::size_t i = 0; i < value.size(); ++i)
      walk(path + "[" + std::to_string(i) + "]", shapes, visit, value[i], others[i]...);
  } else if constexpr (kHasFields<Plain>) {
    for_each_field<Plain>([&](const auto& field) {
      walk(path + "." + std::string(field.name), shapes, visit, value.*field.member, others.*field.member...);
    });
  } else {
    visit(path, value, others...);
  }
}

// Of five nodes, none of them the last of a triangle or a segment: the next node is one too.
inline ModalBoundary boundary_with_room(RandomNumbers& random, int modes) {
  BoundaryParts parts = parts_of(random.boundary(5, modes));
  parts.triangles.resize(2);
  parts.segments = {{0, 2, 0.1, 0}, {1, 3, 0.2, 1}};
  return boundary_of(std::move(parts));
}

// Every value random, lists of two items, `modes` modes.
template <class Message>
void randomize(Message& message, RandomNumbers& random, int modes) {
  const auto two_items = [&](const std::string&, auto& list) {
    using Item = typename std::decay_t<decltype(list)>::value_type;
    list.clear();
    for (int i = 0; i < 2; ++i) {
      if constexpr (std::is_same_v<Item, CoupledBody>)
        list.push_back({boundary_with_room(random, modes), random.motion(modes)});
      else
        list.emplace_back();
    }
    return true;
  };
  walk(
      "", two_items,
      [&](const std::string&, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, bool>) {
          value = true;
        } else if constexpr (std::is_same_v<Value, Status>) {
          value = Status::kInterrupted;
        } else if constexpr (std::is_integral_v<Value>) {
          value = 1 + random.below(1000);
        } else if constexpr (std::is_floating_point_v<Value>) {
          value = random.number();
        } else if constexpr (std::is_same_v<Value, std::string>) {
          value = "text " + std::to_string(random.below(1000));
        } else if constexpr (std::is_same_v<Value, ModalBoundary>) {
          // is random already
        } else {
          if constexpr (Value::SizeAtCompileTime == Eigen::Dynamic) {
            if constexpr (Value::IsVectorAtCompileTime)
              value.resize(modes);
            else
              value.resize(Value::RowsAtCompileTime, 2);
          }
          random.fill(value);
        }
      },
      message);
}

// Names of the fields in which the two differ.
template <class Message>
std::vector<std::string> differences(const Message& a, const Message& b) {
  std::vector<std::string> names;
  const auto same_size = [&](const std::string& path, const auto& one, const auto& other) {
    if (one.size() != other.size()) names.push_back(path);
    return one.size() == other.size();
  };
  const auto same = [&](const std::string& path, const auto& one, const auto& other) {
    if constexpr (std::is_same_v<std::decay_t<decltype(one)>, ModalBoundary>) {
      for (const std::string& name : differences(parts_of(one), parts_of(other))) names.push_back(path + name);
    } else if (one != other) {
      names.push_back(path);
    }
  };
  walk("", same_size, same, a, b);
  return names;
}

// A change that every value takes without breaking what must fit together.
template <class Value>
void change(Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    value = !value;
  } else if constexpr (std::is_same_v<Value, Status>) {
    value = value == Status::kFailed ? Status::kBadInput : Status::kFailed;
  } else if constexpr (std::is_arithmetic_v<Value>) {
    value += 1;
  } else if constexpr (std::is_same_v<Value, std::string>) {
    value += "!";
  } else if (value.size() > 0) {
    value(value.size() - 1) += 1;
  }
}

// Calls visit(path, object) with every value of `object` changed, one after the other, and put back. Values without
// content (matrices of a rigid body) are passed over.
template <class T, class Visit>
void for_each_changed(T& object, const Visit& visit) {
  const auto enter = [](const std::string&, const auto&) { return true; };
  walk(
      "", enter,
      [&](const std::string& path, auto& value) {
        const auto before = value;
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, ModalBoundary>) {
          BoundaryParts parts = parts_of(before);
          for_each_changed(parts, [&](const std::string& inner, const BoundaryParts& changed) {
            value = boundary_of(changed);
            visit(path + inner, object);
          });
        } else {
          change(value);
          if (value != before) visit(path, object);
        }
        value = before;
      },
      object);
}

}  // namespace footfall::test

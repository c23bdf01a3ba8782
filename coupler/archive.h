#pragma once
// The state of a run as the text of a checkpoint, saved and restored to the last bit. Every class describes its state
// once,
//   void visit(Archive& archive) {
//     archive("window", window_);
//     archive("bodies", bodies_);
//   }
// and the same lines save and restore it; archive.members<&Exchange::window_, &Exchange::bodies_>(*this) says the same.
// Structs with a list of fields (field_list.h) need no visit().
//
// One value per line: the names of the parts that contain it, its own name, then its numbers, floating-point ones in
// hexadecimal. Restoring requires the same names in the same order, and vectors of the length that they have already,
// unless they are empty.

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "coupler/base/field_list.h"

namespace footfall {

class Archive {
 public:
  Archive() = default;                          // saves
  Archive(std::string file, std::string text);  // restores; file: named in messages

  bool restores() const { return restores_; }
  const std::string& text() const { return text_; }
  // To be called after the last value. Throws InputError when the restored text contains more.
  void finish() const;

  // Each throws InputError "file:line: ..." when the text has something else there.
  void operator()(std::string_view name, bool& value);
  void operator()(std::string_view name, int& value);
  void operator()(std::string_view name, long& value);
  void operator()(std::string_view name, double& value);
  void operator()(std::string_view name, std::string& value);
  void operator()(std::string_view name, std::vector<bool>& value);
  template <class Derived>
  void operator()(std::string_view name, Eigen::PlainObjectBase<Derived>& value) {
    Eigen::Index rows = value.rows(), cols = value.cols();
    shape(name, rows, cols, {Derived::RowsAtCompileTime, Derived::ColsAtCompileTime});
    if (restores_) value.resize(rows, cols);
    numbers(value.data(), value.size());
  }
  template <class Item, std::size_t count>
  void operator()(std::string_view name, std::array<Item, count>& value) {
    for (std::size_t i = 0; i < count; ++i) item(name, i, value[i]);
  }
  template <class Item>
  void operator()(std::string_view name, std::vector<Item>& value) {
    long count = static_cast<long>(value.size());
    (*this)(std::string(name) + ".count", count);
    if (restores_) value.resize(static_cast<std::size_t>(checked_count(count, value.size())));
    for (std::size_t i = 0; i < value.size(); ++i) item(name, i, value[i]);
  }
  template <class Item>
  void operator()(std::string_view name, std::optional<Item>& value) {
    bool there = value.has_value();
    (*this)(std::string(name) + ".there", there);
    if (restores_) value = there ? std::optional<Item>(Item()) : std::nullopt;
    if (there) (*this)(name, *value);
  }
  template <class Struct>
  auto operator()(std::string_view name, Struct& value)
      -> std::enable_if_t<std::is_class_v<Struct> && !std::is_base_of_v<Eigen::EigenBase<Struct>, Struct>> {
    const std::size_t outside = path_.size();
    path_.append(name).append("/");
    if constexpr (kHasFields<Struct>) {
      for_each_field<Struct>([&](const auto& field) { (*this)(field.name, value.*field.member); });
    } else {
      value.visit(*this);
    }
    path_.resize(outside);
  }
  template <auto... kMembers, class Struct>
  void members(Struct& value) {
    ((*this)(name_of_member<kMembers>(), value.*kMembers), ...);
  }

 private:
  template <class Item>
  void item(std::string_view name, std::size_t i, Item& value) {
    (*this)(std::string(name) + "." + std::to_string(i), value);
  }
  void begin(std::string_view name);  // begins a line: writes its name, or requires it
  std::string word();                 // restoring: the next word of the line
  void end();                         // ends the line
  // Begins a line. fixed: rows and columns of the type, or Eigen::Dynamic.
  void shape(std::string_view name, Eigen::Index& rows, Eigen::Index& cols, std::array<int, 2> fixed);
  void numbers(double* values, Eigen::Index count);  // and ends the line
  long checked_count(long count, std::size_t present) const;
  [[noreturn]] void fail(const std::string& what) const;

  bool restores_ = false;
  std::string file_, text_;
  std::string path_;      // names of the parts around the next value
  std::size_t next_ = 0;  // in text_
  int line_ = 1;
};

}  // namespace footfall

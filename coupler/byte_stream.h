#pragma once
// Numbers, texts and matrices to bytes and back. Both programs run on the same kind of machine under one MPI: native
// byte order.

#include <Eigen/Dense>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "coupler/base/errors.h"

namespace footfall {

class ByteWriter {
 public:
  // Appends to `out`, which is cleared first but keeps its memory.
  explicit ByteWriter(std::vector<std::uint8_t>& out) : out_(out) { out_.clear(); }

  template <class Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    raw(&value, sizeof value);
  }
  void text(const std::string& value) {
    number<std::uint64_t>(value.size());
    raw(value.data(), value.size());
  }
  // Rows, columns, then the coefficients column by column.
  template <class Derived>
  void matrix(const Eigen::PlainObjectBase<Derived>& value) {
    number<std::int64_t>(value.rows());
    number<std::int64_t>(value.cols());
    raw(value.data(), static_cast<std::size_t>(value.size()) * sizeof(typename Derived::Scalar));
  }

 private:
  void raw(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    out_.insert(out_.end(), bytes, bytes + size);
  }
  std::vector<std::uint8_t>& out_;
};

// Every read checks what is left; ProtocolError when the bytes are not what they should be.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : next_(data), left_(size) {}

  template <class Number>
  Number number() {
    static_assert(std::is_arithmetic_v<Number>);
    Number value{};
    raw(&value, sizeof value);
    return value;
  }
  // A number of items that each take at least `bytes_each` of what is left.
  std::size_t count(std::size_t bytes_each) {
    const auto value = number<std::uint64_t>();
    if (value > left_ / bytes_each) throw ProtocolError("a count is larger than the message");
    return static_cast<std::size_t>(value);
  }
  void text(std::string& value) {
    value.resize(count(1));
    raw(value.data(), value.size());
  }
  template <class Derived>
  void matrix(Eigen::PlainObjectBase<Derived>& value) {
    const auto rows = number<std::int64_t>();
    const auto cols = number<std::int64_t>();
    constexpr int kRows = Derived::RowsAtCompileTime, kCols = Derived::ColsAtCompileTime;
    const std::uint64_t most = left_ / sizeof(typename Derived::Scalar);
    const bool too_large = rows > 0 && static_cast<std::uint64_t>(cols) > most / static_cast<std::uint64_t>(rows);
    const bool too_long = static_cast<std::uint64_t>(rows) > kMostRows || static_cast<std::uint64_t>(cols) > kMostRows;
    if (rows < 0 || cols < 0 || too_large || too_long || (kRows != Eigen::Dynamic && rows != kRows) ||
        (kCols != Eigen::Dynamic && cols != kCols))
      throw ProtocolError("a matrix of " + std::to_string(rows) + " x " + std::to_string(cols) +
                          " does not belong here");
    value.resize(rows, cols);
    raw(value.data(), static_cast<std::size_t>(value.size()) * sizeof(typename Derived::Scalar));
  }
  // Nothing may be left over.
  void finish() const {
    if (left_ != 0) throw ProtocolError(std::to_string(left_) + " bytes are left over");
  }

 private:
  static constexpr std::uint64_t kMostRows = std::uint64_t{1} << 26;  // of a matrix without coefficients
  void raw(void* data, std::size_t size) {
    if (size > left_) throw ProtocolError("the message is cut short");
    if (size > 0) std::memcpy(data, next_, size);
    next_ += size;
    left_ -= size;
  }
  const std::uint8_t* next_;
  std::size_t left_;
};

}  // namespace footfall

#pragma once
// Numbers as text in a page: compressed by zlib, then base64. web/src/decode.js decodes them.

#include <Eigen/Dense>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace footfall {

// Base64 of the bytes compressed by zlib (RFC 1950).
std::string packed_bytes(const std::string& bytes);

// 32-bit numbers, little-endian, as four planes of bytes, lowest first, which compress better.
std::string packed_numbers(const std::vector<float>& numbers);
std::string packed_numbers(const std::vector<std::uint32_t>& numbers);

// Frames of 16-bit numbers of equal length. A frame is stored as the change of every number since the frame before (the
// first: since 0), modulo 2^16, zigzag coded (0, -1, 1, -2 ... are 0, 1, 2, 3 ...), so that small changes take little
// room. All low bytes come first, then all high bytes.
class PackedSeries {
 public:
  explicit PackedSeries(std::size_t length) : last_(length, 0) {}
  // The next frame as text.
  std::string add(const std::vector<std::uint16_t>& numbers);

 private:
  std::vector<std::uint16_t> last_;
};

// Positions in a box as 16-bit numbers 0 ... kSteps, accurate to half a step.
constexpr int kSteps = 65534;
constexpr std::uint16_t kAbsent = 65535;  // instead of x: absent in this frame

struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = Eigen::Vector3d::Constant(-1e300);  // [m]

  bool is_empty() const { return !(low.x() <= high.x()); }
  void include(const Eigen::Vector3d& x);
  Eigen::Vector3d size() const { return high - low; }  // [m]
  std::uint16_t number_of(int axis, double x) const;   // of a position within the box
  double step(int axis) const;                         // between two numbers [m]
};

// {"box": {low, size}, "view": {low, high}}: of all frames, and of the initial view [m].
void add_box(const Box& box, const Box& view, nlohmann::ordered_json& json);

// A number v in [0, largest] as 255 sqrt(v / largest): small ones remain distinct.
std::uint16_t root_number(double v, double largest);

}  // namespace footfall

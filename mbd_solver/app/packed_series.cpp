// Differences, zigzag and planes of bytes before zlib.
#include "mbd_solver/app/packed_series.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "coupler/base/errors.h"
#include "mbd_solver/base/packed_bytes.h"

namespace footfall {
namespace {

template <class Number>
std::string in_planes(const std::vector<Number>& numbers) {
  static_assert(sizeof(Number) == 4);
  const std::size_t n = numbers.size();
  std::string planes(4 * n, '\0');
  for (std::size_t i = 0; i < n; ++i) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &numbers[i], 4);
    for (std::size_t k = 0; k < 4; ++k) planes[k * n + i] = static_cast<char>((bits >> (8 * k)) & 255u);
  }
  return planes;
}

}  // namespace

std::string packed_bytes(const std::string& bytes) { return base64(deflated(bytes)); }

std::string packed_numbers(const std::vector<float>& numbers) { return packed_bytes(in_planes(numbers)); }
std::string packed_numbers(const std::vector<std::uint32_t>& numbers) { return packed_bytes(in_planes(numbers)); }

std::string PackedSeries::add(const std::vector<std::uint16_t>& numbers) {
  const std::size_t n = last_.size();
  FOOTFALL_DEMAND(numbers.size() == n);
  std::string bytes(2 * n, '\0');
  for (std::size_t i = 0; i < n; ++i) {
    const int change = static_cast<std::int16_t>(numbers[i] - last_[i]);
    const unsigned zigzag = change >= 0 ? 2u * static_cast<unsigned>(change) : 2u * static_cast<unsigned>(-change) - 1u;
    bytes[i] = static_cast<char>(zigzag & 255u);
    bytes[n + i] = static_cast<char>(zigzag >> 8);
  }
  last_ = numbers;
  return packed_bytes(bytes);
}

void Box::include(const Eigen::Vector3d& x) {
  low = low.cwiseMin(x);
  high = high.cwiseMax(x);
}

double Box::step(int axis) const { return (high(axis) - low(axis)) / kSteps; }

std::uint16_t Box::number_of(int axis, double x) const {
  const double h = step(axis);
  const double number = h > 0.0 ? std::round((x - low(axis)) / h) : 0.0;
  return static_cast<std::uint16_t>(std::clamp(number, 0.0, static_cast<double>(kSteps)));
}

void add_box(const Box& box, const Box& view, nlohmann::ordered_json& json) {
  const auto three = [](const Eigen::Vector3d& x) { return std::vector<double>{x.x(), x.y(), x.z()}; };
  json["box"] = {{"low", three(box.low)}, {"size", three(box.size())}};
  json["view"] = {{"low", three(view.low)}, {"high", three(view.high)}};
}

std::uint16_t root_number(double v, double largest) {
  if (!(largest > 0.0)) return 0;
  return static_cast<std::uint16_t>(std::lround(255.0 * std::sqrt(std::clamp(v / largest, 0.0, 1.0))));
}

}  // namespace footfall

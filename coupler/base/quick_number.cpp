#include "coupler/base/quick_number.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace footfall {
namespace {

constexpr int kMostDigits = 12;
constexpr double kLeast = 1e-11, kMost = 1e21;
// 10^22 is the largest power of ten that a double holds exactly.
constexpr int kExact = 22;
constexpr double kPower[kExact + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
// One product or quotient of less than 1e12 is off by 6e-5 at most: farther than this from a half, it rounds as the number
// itself does.
constexpr double kTie = 1e-3;
constexpr char kPairs[] =
    "0001020304050607080910111213141516171819202122232425262728293031323334353637383940414243444546474849"
    "5051525354555657585960616263646566676869707172737475767778798081828384858687888990919293949596979899";

// x with 10^x <= a < 10^(x + 1); kLeast <= a < kMost.
int decimal_exponent(double a) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &a, sizeof bits);
  const int two = static_cast<int>(bits >> 52) - 1023;  // 2^two <= a
  const int x = (two * 1233) >> 12;                     // of 2^two: 1233 / 4096 = log10(2) - 5e-6
  return (x + 1 >= 0 ? a >= kPower[x + 1] : a * kPower[-x - 1] >= 1.0) ? x + 1 : x;
}

// All digits of n, `count` of them.
void write_digits(char* out, std::uint64_t n, int count) {
  int i = count;
  for (; i > 1; i -= 2, n /= 100) std::memcpy(out + i - 2, kPairs + 2 * (n % 100), 2);
  if (i == 1) *out = static_cast<char>('0' + n);
}

}  // namespace

char* write_quickly(char* out, double value, int digits) {
  const double a = std::abs(value);
  if (!(a >= kLeast && a < kMost) || digits < 1 || digits > kMostDigits) return nullptr;
  int x = decimal_exponent(a);
  const int shift = digits - 1 - x;
  if (std::abs(shift) > kExact) return nullptr;
  const double scaled = shift >= 0 ? a * kPower[shift] : a / kPower[-shift];
  std::int64_t n = static_cast<std::int64_t>(scaled);
  const double rest = scaled - static_cast<double>(n);
  if (std::abs(rest - 0.5) < kTie) return nullptr;
  if (rest > 0.5) ++n;
  const std::int64_t top = static_cast<std::int64_t>(kPower[digits]);
  if (n < top / 10 || n > top) return nullptr;
  if (n == top) {  // 9.99... has become 10
    n /= 10;
    ++x;
  }
  char digit[kMostDigits];
  write_digits(digit, static_cast<std::uint64_t>(n), digits);
  int count = digits;
  while (count > 1 && digit[count - 1] == '0') --count;

  if (value < 0.0) *out++ = '-';
  const auto copy = [&](int from, int to) {
    for (int i = from; i < to; ++i) *out++ = i < count ? digit[i] : '0';
  };
  const bool scientific = x < -4 || x >= digits;
  const int before_point = scientific ? 1 : x + 1;  // digits; not above 0: 0.00...
  if (before_point > 0) {
    copy(0, before_point);
    if (count > before_point) *out++ = '.';
    copy(before_point, count);
  } else {
    *out++ = '0';
    *out++ = '.';
    for (int i = before_point; i < 0; ++i) *out++ = '0';
    copy(0, count);
  }
  if (!scientific) return out;
  *out++ = 'e';
  *out++ = x < 0 ? '-' : '+';
  std::memcpy(out, kPairs + 2 * std::abs(x), 2);
  return out + 2;
}

}  // namespace footfall

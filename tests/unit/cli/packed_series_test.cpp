// What a page holds is what the run wrote, to half a step. The way back here is that of web/src/decode.js.
#include "mbd_solver/cli/analysis/viewer/packed_series.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <random>

namespace footfall {
namespace {

std::string bytes_of_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t block = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    block = (block << 6) | static_cast<std::uint32_t>(digits.find(c));
    if (++count % 4 != 0) continue;
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>((block >> shift) & 255u);
  }
  if (count % 4 == 2) bytes += static_cast<char>((block >> 4) & 255u);
  if (count % 4 == 3) {
    bytes += static_cast<char>((block >> 10) & 255u);
    bytes += static_cast<char>((block >> 2) & 255u);
  }
  return bytes;
}

std::string unpacked(const std::string& text, std::size_t size) {
  const std::string packed = bytes_of_base64(text);
  std::string bytes(size + 1, '\0');
  uLongf length = static_cast<uLongf>(bytes.size());
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length, reinterpret_cast<const Bytef*>(packed.data()),
                       static_cast<uLong>(packed.size())),
            Z_OK);
  EXPECT_EQ(length, size);
  bytes.resize(size);
  return bytes;
}

std::uint32_t byte(const std::string& bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

void next_frame(const std::string& text, std::vector<std::uint16_t>& last) {
  const std::size_t n = last.size();
  const std::string bytes = unpacked(text, 2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t z = byte(bytes, i) | (byte(bytes, n + i) << 8);
    last[i] = static_cast<std::uint16_t>(last[i] + ((z >> 1) ^ (0u - (z & 1u))));
  }
}

TEST(PackedSeries, EveryFrameComesBackAsItWas) {
  constexpr std::size_t kCount = 1000;
  std::mt19937 random(17);
  std::uniform_int_distribution<int> any(0, 65535);
  PackedSeries series(kCount);
  std::vector<std::uint16_t> frame(kCount), read(kCount, 0);
  for (int k = 0; k < 5; ++k) {
    for (std::uint16_t& value : frame) value = static_cast<std::uint16_t>(any(random));
    // the ends of the range, there and back
    frame[0] = k % 2 == 0 ? 0 : 65535;
    frame[1] = k % 2 == 0 ? 32768 : 0;
    frame[2] = k % 2 == 0 ? 65535 : 32767;
    next_frame(series.add(frame), read);
    EXPECT_EQ(read, frame) << "frame " << k;
  }
}

TEST(PackedSeries, WhatRestsTakesNoRoom) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> any(0, 65534);
  std::vector<std::uint16_t> frame(30000);
  for (std::uint16_t& value : frame) value = static_cast<std::uint16_t>(any(random));
  PackedSeries series(frame.size());
  const std::size_t first = series.add(frame).size();
  EXPECT_GT(first, frame.size() * 2);                // noise does not pack
  EXPECT_LT(series.add(frame).size(), first / 100);  // its standing still does
}

TEST(PackedNumbers, FloatsAndWholeNumbersComeBackBitForBit) {
  const std::vector<float> numbers = {0.0f, -1.5f, 3.14159e-12f, 6.0e23f, -0.0f};
  const std::string bytes = unpacked(packed_numbers(numbers), 4 * numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::uint32_t bits = 0, expected = 0;
    for (std::size_t k = 0; k < 4; ++k) bits |= byte(bytes, k * numbers.size() + i) << (8 * k);
    std::memcpy(&expected, &numbers[i], 4);
    EXPECT_EQ(bits, expected);
  }
  const std::string whole = unpacked(packed_numbers(std::vector<std::uint32_t>{0x01020304u}), 4);
  EXPECT_EQ(whole, std::string("\x04\x03\x02\x01"));
}

TEST(Box, PlacesAreHalfAStepOffAtMost) {
  Box box;
  EXPECT_TRUE(box.is_empty());
  box.include({-1.0, 2.0, 0.0});
  box.include({1.5, 2.0, 0.8});  // without width along y
  EXPECT_FALSE(box.is_empty());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.0, 1.5);
  for (int i = 0; i < 1000; ++i) {
    const double x = place(random), read = box.low.x() + box.step(0) * box.number_of(0, x);
    EXPECT_NEAR(read, x, 0.5 * box.step(0) * (1.0 + 1e-9));
  }
  EXPECT_EQ(box.number_of(0, -1.0), 0);
  EXPECT_EQ(box.number_of(0, 1.5), kSteps);  // and never kAbsent
  EXPECT_EQ(box.number_of(1, 2.0), 0);
}

TEST(RootNumber, TellsSmallOnesApart) {
  EXPECT_EQ(root_number(0.0, 4.0), 0);
  EXPECT_EQ(root_number(4.0, 4.0), 255);
  EXPECT_EQ(root_number(1.0, 4.0), 128);
  EXPECT_GT(root_number(4e-4, 4.0), 1);  // a ten thousandth
  EXPECT_EQ(root_number(1.0, 0.0), 0);
}

}  // namespace
}  // namespace footfall

// A function with a stack of its own.
#include "mbd_solver/base/fiber.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <vector>

namespace footfall {
namespace {

TEST(Fiber, GoesOnWhereItPaused) {
  std::vector<int> seen;
  Fiber* self = nullptr;
  Fiber fiber([&] {
    for (int k = 0; k < 3; ++k) {
      seen.push_back(k);
      self->pause();
    }
  });
  self = &fiber;
  EXPECT_FALSE(fiber.begun());
  for (int k = 0; k < 3; ++k) {
    fiber.resume();
    seen.push_back(10 + k);
  }
  EXPECT_FALSE(fiber.ended());
  fiber.resume();
  EXPECT_TRUE(fiber.ended());
  EXPECT_EQ(seen, (std::vector<int>{0, 10, 1, 11, 2, 12}));
}

// Errors are caught within it, leave it, and unwind its stack.
TEST(Fiber, ThrowsToItsCaller) {
  const auto alive = std::make_shared<int>(0);
  Fiber* self = nullptr;
  Fiber fiber([&] {
    const auto copy = alive;
    try {
      throw std::runtime_error("inside");
    } catch (const std::runtime_error&) {
    }
    self->pause();
    throw std::runtime_error("outside");
  });
  self = &fiber;
  fiber.resume();
  EXPECT_EQ(alive.use_count(), 2);
  EXPECT_THROW(fiber.resume(), std::runtime_error);
  EXPECT_TRUE(fiber.ended());
  EXPECT_EQ(alive.use_count(), 1);
}

// Pages of a stack are used when they are touched: many at once do not need their size.
TEST(Fiber, ManyAreCheap) {
  std::vector<std::unique_ptr<Fiber>> fibers;
  int sum = 0;
  for (int k = 0; k < 2000; ++k) fibers.push_back(std::make_unique<Fiber>([&] { ++sum; }));
  for (const auto& fiber : fibers) fiber->resume();
  EXPECT_EQ(sum, 2000);
}

}  // namespace
}  // namespace footfall

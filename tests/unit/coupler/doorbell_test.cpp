// A nap that a ring ends.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include "coupler/doorbell.h"

namespace footfall {
namespace {

std::string job() { return "footfall_test." + std::to_string(getpid()); }

double seconds_of_wait(const Doorbell& bell, double seconds) {
  const auto start = std::chrono::steady_clock::now();
  bell.wait(seconds);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Doorbell, EndsANapWhenItRings) {
  const Doorbell sleeper(job(), 0), waker(job(), 1);
  ASSERT_TRUE(sleeper.works() && waker.works());
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    waker.ring(0);
  });
  const double waited = seconds_of_wait(sleeper, 30.0);
  other.join();
  EXPECT_GE(waited, 0.02);
  EXPECT_LT(waited, 20.0);
}

TEST(Doorbell, RingBeforeTheNapCountsOnce) {
  const Doorbell sleeper(job(), 0), waker(job(), 1);
  for (int i = 0; i < 100; ++i) waker.ring(0);  // more than a queue holds: nothing blocks
  EXPECT_LT(seconds_of_wait(sleeper, 30.0), 20.0);
  EXPECT_GE(seconds_of_wait(sleeper, 0.05), 0.04) << "all rings are heard at once";
}

TEST(Doorbell, KnowsWhetherSomebodyIsThere) {
  const Doorbell bell(job(), 0);
  EXPECT_FALSE(bell.ring(7));
  {
    const Doorbell other(job(), 7);
    for (int i = 0; i < 100; ++i) EXPECT_TRUE(bell.ring(7)) << "also where the queue is full";
  }
  EXPECT_FALSE(bell.ring(7));
}

TEST(Doorbell, RingingNobodyAndATakenSeatAreHarmless) {
  const Doorbell bell(job(), 0);
  bell.ring(7);
  EXPECT_GE(seconds_of_wait(bell, 0.05), 0.04);
  const Doorbell second(job(), 0);
  EXPECT_FALSE(second.works());
  second.ring(0);
  EXPECT_GE(seconds_of_wait(second, 0.05), 0.04);
}

}  // namespace
}  // namespace footfall

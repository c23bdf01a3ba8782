// Helpers made of cat, sh and sleep: cat answers a frame with itself.

#include "mbd_solver/base/helper_process.h"

#include <gmock/gmock.h>
#include <signal.h>

#include "coupler/base/clock.h"
#include "mbd_solver/base/packed_bytes.h"

namespace footfall {
namespace {

std::string why_not(std::vector<std::string> words, double limit) {
  try {
    HelperProcess helper({Rights::of_user(), std::move(words)}, limit);
    return "answered: " + helper.ask("question");
  } catch (const NoAnswer& error) {
    return error.what();
  }
}

TEST(HelperProcess, AnswersAreWholeWhateverTheirSize) {
  HelperProcess helper({Rights::of_user(), {"cat"}}, 20.0);
  std::string bytes;  // of all values, and less than a pipe holds: cat answers before it has read all
  for (int i = 0; i < 60000; ++i) bytes += static_cast<char>(i * 31 + i / 256);
  for (const std::string& text : {std::string(), std::string("speed"), bytes, std::string("\0\n", 2)})
    EXPECT_EQ(helper.ask(text), text);
}

TEST(HelperProcess, ACrashIsToldWithItsSignalAndItsLastWords) {
  EXPECT_THAT(why_not({"sh", "-c", "echo out of fuel >&2; kill -SEGV $$"}, 20.0),
              testing::AllOf(testing::HasSubstr("signal 11"), testing::HasSubstr("out of fuel")));
}

TEST(HelperProcess, AnEndIsToldWithItsExitCode) {
  EXPECT_THAT(why_not({"sh", "-c", "head -c 8 >/dev/null; exit 7"}, 20.0), testing::HasSubstr("exit code 7"));
  EXPECT_THAT(why_not({"/nowhere/at_all"}, 20.0), testing::HasSubstr("no such program"));
}

TEST(HelperProcess, AHelperThatHangsIsEndedWithItsChildren) {
  EXPECT_THAT(why_not({"sh", "-c", "sleep 1000 & sleep 1000"}, 0.2), testing::HasSubstr("time limit of 0.2 s"));
}

TEST(HelperProcess, OtherOutputIsNoAnswer) {
  EXPECT_THAT(why_not({"sh", "-c", "echo 'this is no frame'; sleep 1000"}, 20.0), testing::HasSubstr("something else"));
}

TEST(HelperProcess, IsKilledWhenItOutlivesItsInput) {
  const double begun = wall_clock();
  { HelperProcess helper({Rights::of_user(), {"sh", "-c", "trap '' TERM; sleep 1000"}}, 20.0); }
  EXPECT_LT(wall_clock() - begun, 100.0);  // not the 1000 s
}

TEST(Base64, IsReadBack) {
  std::string bytes;
  for (int i = 0; i < 260; ++i) {
    EXPECT_EQ(bytes_of_base64(base64(bytes)), bytes);
    bytes += static_cast<char>(255 - i);
  }
  EXPECT_EQ(base64("Man"), "TWFu");  // RFC 4648
  EXPECT_EQ(base64("Ma"), "TWE=");
}

}  // namespace
}  // namespace footfall

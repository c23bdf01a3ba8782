// Lines between two processes, here between the two ends of a socket or a pipe.
#include "mbd_solver/base/line_channel.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <thread>

#include "mbd_solver/base/exact_number.h"

namespace footfall {
namespace {

using Heard = LineChannel::Heard;

struct Ends {
  int first = -1, second = -1;
  Ends() {
    int both[2] = {-1, -1};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, both), 0);
    first = both[0];
    second = both[1];
  }
  ~Ends() {
    ::close(first);
    if (second >= 0) ::close(second);
  }
};

TEST(LineChannel, GivesLinesInTheirOrderHoweverTheyArrive) {
  Ends ends;
  LineChannel one(ends.first, ends.first), other(ends.second, ends.second);
  std::string line;
  EXPECT_EQ(other.receive(line, 0), Heard::kNothing);
  ASSERT_TRUE(one.send("step 1"));
  ASSERT_TRUE(one.send(""));
  ASSERT_EQ(::write(ends.first, "half", 4), 4);
  ASSERT_EQ(other.receive(line, 1000), Heard::kLine);
  EXPECT_EQ(line, "step 1");
  ASSERT_EQ(other.receive(line, 1000), Heard::kLine);
  EXPECT_EQ(line, "");
  EXPECT_EQ(other.receive(line, 0), Heard::kNothing);
  ASSERT_EQ(::write(ends.first, " a line\n", 8), 8);
  ASSERT_EQ(other.receive(line, 1000), Heard::kLine);
  EXPECT_EQ(line, "half a line");
}

// Longer than the buffers of a socket and of the channel.
TEST(LineChannel, CarriesALongLineWhole) {
  Ends ends;
  const std::string sent(1 << 20, 'x');
  std::thread sender([&] { EXPECT_TRUE(LineChannel(ends.first, ends.first).send(sent)); });
  LineChannel other(ends.second, ends.second);
  std::string line;
  Heard heard = Heard::kNothing;
  while (heard == Heard::kNothing) heard = other.receive(line, 1000);
  sender.join();
  EXPECT_EQ(heard, Heard::kLine);
  EXPECT_EQ(line, sent);
}

TEST(LineChannel, NoticesThatTheOtherSideHasGone) {
  Ends ends;
  LineChannel one(ends.first, ends.first);
  ::close(ends.second);
  ends.second = -1;
  std::string line;
  EXPECT_EQ(one.receive(line, 1000), Heard::kGone);
  EXPECT_FALSE(one.send("step 1"));
}

TEST(LineChannel, WritesToPipes) {
  int pipe[2] = {-1, -1};
  ASSERT_EQ(::pipe(pipe), 0);
  LineChannel channel(pipe[0], pipe[1]);
  std::string line;
  ASSERT_TRUE(channel.send("0 done"));
  ASSERT_EQ(channel.receive(line, 1000), Heard::kLine);
  EXPECT_EQ(line, "0 done");
  ::close(pipe[0]);
  ::close(pipe[1]);
}

TEST(ExactNumber, IsReadAsItWasWritten) {
  for (const double value : {0.1, 1.0 / 3.0, -2e-300, 5e-324, 1.7976931348623157e308, 0.0})
    EXPECT_EQ(exact_number(shortest_text(value)), value);
  EXPECT_EQ(shortest_text(0.1), "0.1");
  EXPECT_TRUE(std::isnan(exact_number("thrust")));
}

}  // namespace
}  // namespace footfall

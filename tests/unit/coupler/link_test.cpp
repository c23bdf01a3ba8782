#include "coupler/link.h"

#include <gtest/gtest.h>

#include <thread>

#include "coupler/transport_loopback.h"

namespace footfall {
namespace {

struct Pair {
  explicit Pair(double patience = 10.0)
      : ends(TransportLoopback::make_pair()), dem(*ends.first, patience), mbd(*ends.second, patience) {}
  std::pair<std::unique_ptr<TransportLoopback>, std::unique_ptr<TransportLoopback>> ends;
  Link dem, mbd;
};

template <class Error, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

TEST(Link, MessagesArriveInOrder) {
  Pair pair;
  for (int k = 0; k < 3; ++k) {
    Motion motion;
    motion.window = k;
    pair.mbd.send(motion);
  }
  for (int k = 0; k < 3; ++k) {
    Motion motion;
    pair.dem.receive(motion);
    EXPECT_EQ(motion.window, k);
  }
}

TEST(Link, OrderlyCloseNeedsBothSides) {
  Pair pair;
  std::thread dem([&] { pair.dem.close(); });
  pair.mbd.close();
  dem.join();
  EXPECT_TRUE(pair.dem.closed());
  EXPECT_TRUE(pair.mbd.closed());
  EXPECT_EQ(pair.mbd.partner_status(), Status::kOk);
}

TEST(Link, FailureReachesThePartnerWithItsReason) {
  Pair pair;
  bool heard = false;
  std::thread dem([&] { heard = pair.dem.fail("a grain left the box"); });
  Motion motion;
  const std::string said = message_of<PartnerError>([&] { pair.mbd.receive(motion); });
  dem.join();
  EXPECT_EQ(said, "liggghts_mbd stopped: a grain left the box");
  EXPECT_TRUE(heard);
  EXPECT_EQ(pair.mbd.partner_status(), Status::kFailed);
  EXPECT_TRUE(pair.mbd.closed());
  EXPECT_TRUE(pair.mbd.fail("too late to say anything"));
}

// The exit codes of both programs come from the same status.
TEST(Link, BadInputOfThePartnerIsBadInputHere) {
  Pair pair;
  std::thread dem([&] { pair.dem.fail("the script ended early", Status::kBadInput); });
  Motion motion;
  const std::string said = message_of<ProtocolError>([&] { pair.mbd.receive(motion); });
  dem.join();
  EXPECT_EQ(said, "liggghts_mbd stopped: the script ended early");
  EXPECT_EQ(pair.mbd.partner_status(), Status::kBadInput);
}

TEST(Link, BothSidesMayFailAtOnce) {
  Pair pair;
  std::thread dem([&] { pair.dem.fail("one"); });
  pair.mbd.fail("other");
  dem.join();
  EXPECT_TRUE(pair.dem.closed() && pair.mbd.closed());
}

TEST(Link, FailureOfADeadPartnerIsNotWaitedFor) {
  Pair pair;
  pair.ends.second.reset();
  EXPECT_FALSE(pair.dem.fail("nobody hears this"));
}

TEST(Link, InterruptionIsNotFailure) {
  Pair pair;
  std::thread dem([&] { pair.dem.fail("stopped by hand", Status::kInterrupted); });
  Load load;
  EXPECT_EQ(message_of<PartnerError>([&] { pair.mbd.receive(load); }), "liggghts_mbd was interrupted: stopped by hand");
  dem.join();
  EXPECT_EQ(pair.mbd.partner_status(), Status::kInterrupted);
}

TEST(Link, EndBeforeTheLastWindowIsAnError) {
  Pair pair;
  std::thread dem([&] { pair.dem.close(); });
  Load load;
  EXPECT_EQ(message_of<PartnerError>([&] { pair.mbd.receive(load); }),
            "liggghts_mbd ended the coupling before the last window");
  dem.join();
}

TEST(Link, UnexpectedMessageIsNamed) {
  Pair pair;
  pair.dem.send(Start{});
  Load load;
  EXPECT_EQ(message_of<ProtocolError>([&] { pair.mbd.receive(load); }),
            "liggghts_mbd sent Start where Load was expected");
}

TEST(Link, SilentPartnerIsGivenUp) {
  Pair pair(0.05);
  Load load;
  const std::string said = message_of<PartnerError>([&] { pair.mbd.receive(load); });
  EXPECT_EQ(said.rfind("liggghts_mbd has said nothing for", 0), 0U);
}

TEST(Link, VanishedPartnerIsNoticed) {
  Pair pair;
  pair.dem.send(Load{});
  pair.ends.first.reset();
  Load load;
  pair.mbd.receive(load);  // what was said before still counts
  EXPECT_EQ(message_of<PartnerError>([&] { pair.mbd.receive(load); }), "liggghts_mbd is gone");
}

}  // namespace
}  // namespace footfall

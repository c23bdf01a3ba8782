// The conversation of both programs, and what each of them checks first.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <sstream>
#include <string>
#include <thread>

#include "coupler/base/errors.h"
#include "coupler/couple_mbd_arguments.h"
#include "coupler/link.h"
#include "coupler/messages.h"
#include "coupler/polling_wait.h"
#include "tests/support/refused.h"
#include "tests/support/transport_loopback.h"

namespace footfall {
namespace {

struct Pair {
  explicit Pair(double patience = 10.0)
      : ends(TransportLoopback::make_pair()), dem(*ends.first, patience), mbd(*ends.second, patience) {}
  std::pair<std::unique_ptr<TransportLoopback>, std::unique_ptr<TransportLoopback>> ends;
  Link dem, mbd;
};

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
  const std::string said = test::error_of<PartnerError>([&] { pair.mbd.receive(motion); });
  dem.join();
  EXPECT_TRUE(test::names(said, {"liggghts_mbd", "a grain left the box"}));
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
  const std::string said = test::error_of<ProtocolError>([&] { pair.mbd.receive(motion); });
  dem.join();
  EXPECT_TRUE(test::names(said, {"the script ended early"}));
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
  EXPECT_TRUE(test::names(test::error_of<PartnerError>([&] { pair.mbd.receive(load); }), {"stopped by hand"}));
  dem.join();
  EXPECT_EQ(pair.mbd.partner_status(), Status::kInterrupted);
}

TEST(Link, EndBeforeTheLastWindowIsAnError) {
  Pair pair;
  std::thread dem([&] { pair.dem.close(); });
  Load load;
  EXPECT_THROW(pair.mbd.receive(load), PartnerError);
  dem.join();
}

TEST(Link, UnexpectedMessageIsNamed) {
  Pair pair;
  pair.dem.send(Start{});
  Load load;
  EXPECT_TRUE(test::names(test::error_of<ProtocolError>([&] { pair.mbd.receive(load); }), {"Start", "Load"}));
}

TEST(Link, SilentPartnerIsGivenUp) {
  Pair pair(0.05);
  Load load;
  EXPECT_THROW(pair.mbd.receive(load), PartnerError);
}

TEST(Link, VanishedPartnerIsNoticed) {
  Pair pair;
  pair.dem.send(Load{});
  pair.ends.first.reset();
  Load load;
  pair.mbd.receive(load);  // what was said before still counts
  EXPECT_THROW(pair.mbd.receive(load), PartnerError);
}

// A nap that a ring ends.

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

const Eigen::Vector3d kEarth(0, 0, -9.81), kMoon(0, 0, -1.62), kNone(0, 0, 0);

TEST(Gravity, IsTheSameButForRounding) {
  EXPECT_TRUE(is_same_gravity(kEarth * (1.0 + 1e-9), kEarth));
  EXPECT_TRUE(is_same_gravity(kNone, kNone));
  EXPECT_FALSE(is_same_gravity(kEarth * 1.001, kEarth));
  EXPECT_FALSE(is_same_gravity(-kEarth, kEarth));
}

TEST(Gravity, ThatDiffersIsNamedOnBothSides) {
  EXPECT_TRUE(test::names(gravity_differs(kMoon, kEarth, " at the start"), {"(0, 0, -1.62)", "(0, 0, -9.81)"}));
  EXPECT_TRUE(test::names(gravity_differs(kNone, kEarth, ""), {"(0, 0, -9.81)"}));
}

CoupleMbdArguments parsed_fix(const std::string& after_style) {
  std::istringstream in("m all couple/mbd " + after_style);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return {static_cast<int>(pointers.size()), pointers.data()};
}

TEST(CoupleMbdArguments, TakeWhatTheCommandSays) {
  const CoupleMbdArguments all = parsed_fix("every 5 patience 0.5 mesh pad1 foot_1 mesh pad2 foot_2");
  EXPECT_EQ(all.every, 5);
  EXPECT_EQ(all.patience, 0.5);
  ASSERT_EQ(all.meshes.size(), 2U);
  EXPECT_EQ(all.meshes[0].mesh, "pad1");
  EXPECT_EQ(all.meshes[1].body, "foot_2");
}

TEST(CoupleMbdArguments, LeaveOutWhatIsNotSaid) {
  const CoupleMbdArguments least = parsed_fix("every auto");
  EXPECT_EQ(least.every, 0);
  EXPECT_FALSE(least.patience);
  EXPECT_TRUE(least.gravity_of_scene);
  EXPECT_TRUE(least.end_of_scene);
  EXPECT_EQ(least.max_lost, 0.05);
  EXPECT_TRUE(least.meshes.empty());
}

TEST(CoupleMbdArguments, TakeKeywordsInAnyOrder) {
  const CoupleMbdArguments all =
      parsed_fix("every 5 lost 0.2 mesh upper drum end script mesh lower drum gravity script patience 3");
  EXPECT_FALSE(all.gravity_of_scene);
  EXPECT_FALSE(all.end_of_scene);
  EXPECT_EQ(all.max_lost, 0.2);
  EXPECT_EQ(all.patience, 3.0);
  ASSERT_EQ(all.meshes.size(), 2U);
  EXPECT_EQ(all.meshes[1].mesh, "lower");
  EXPECT_EQ(all.meshes[1].body, "drum");
}

TEST(CoupleMbdArguments, SayHowGrainsTouch) {
  using Surface = CoupleMbdArguments::Surface;
  EXPECT_EQ(parsed_fix("every 5").surface, Surface::kSmooth);
  EXPECT_EQ(parsed_fix("every 5 surface facets").surface, Surface::kFacets);
  EXPECT_EQ(parsed_fix("every 5 surface round").surface, Surface::kRound);
  EXPECT_DOUBLE_EQ(parsed_fix("every 5").edge_angle, M_PI / 6.0);
  EXPECT_DOUBLE_EQ(parsed_fix("every 5 edge 45").edge_angle, M_PI / 4.0);
  EXPECT_FALSE(parsed_fix("every 5").mass_of_pair);
  EXPECT_TRUE(parsed_fix("every 5 damping_mass pair").mass_of_pair);
  EXPECT_EQ(parsed_fix("every 1000000").every, 1000000);
}

// The word that is wrong, or the one after which something is missing, is named.
TEST(CoupleMbdArguments, NameTheWordThatIsWrong) {
  const std::pair<const char*, const char*> wrong[] = {{"", "every"},
                                                       {"every", "every"},
                                                       {"evry 5", "evry"},
                                                       {"5", "5"},
                                                       {"every 5 mash pad1 foot_1", "mash"},
                                                       {"every 5 mesh pad1", "mesh"},
                                                       {"every 5 patience", "patience"},
                                                       {"every 0", "0"},
                                                       {"every -1", "-1"},
                                                       {"every 1000001", "1000001"},
                                                       {"every 5x", "5x"},
                                                       {"every 1.5", "1.5"},
                                                       {"every many", "many"},
                                                       {"every 5 patience 0", "patience"},
                                                       {"every 5 patience -2", "-2"},
                                                       {"every 5 patience 5s", "5s"},
                                                       {"every 5 patience nan", "nan"},
                                                       {"every 5 gravity own", "own"},
                                                       {"every 5 end early", "early"},
                                                       {"every 5 lost 0", "lost"},
                                                       {"every 5 lost 1.5", "1.5"},
                                                       {"every 5 lost 5%", "5%"},
                                                       {"every 5 lost -0.1", "-0.1"},
                                                       {"every 5 surface flat", "flat"},
                                                       {"every 5 edge 0", "edge"},
                                                       {"every 5 edge 91", "91"},
                                                       {"every 5 edge sharp", "sharp"},
                                                       {"every 5 damping_mass wall", "wall"},
                                                       {"every 5 mesh pad1 foot mesh pad1 leg", "pad1"}};
  for (const auto& row : wrong)
    EXPECT_TRUE(test::names(test::error_of([&] { parsed_fix(row.first); }), {"fix m couple/mbd", row.second}))
        << row.first;
}

}  // namespace
}  // namespace footfall

// The grains' side of the conversation.
#include <gtest/gtest.h>

#include <numeric>
#include <thread>

#include "coupler/base/clock.h"
#include "coupler/schemes/registry.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/link/grain_books.h"
#include "liggghts_fix/link/grain_paths.h"
#include "liggghts_fix/link/rank_shares.h"
#include "tests/support/refused.h"
#include "tests/support/transport_loopback.h"
#include "tests/unit/coupler/message_content.h"

namespace footfall {
namespace {

// The order of events on the grains' side, without MPI and LIGGGHTS.

ModalBoundary unit_boundary(const std::string& name) {
  Eigen::Matrix3Xd rho0(3, 3);
  rho0 << 0, 1, 0, 0, 0, 1, 0, 0, 0;
  return ModalBoundary(name, rho0, {{0, 1, 2}});
}

Start script(double dt, int n, std::int64_t step) {
  Start start;
  start.dt = dt;
  start.n = n;
  start.step = step;
  return start;
}

// The multibody side of a test runs on a thread of its own.
struct Pair {
  Pair() : ends(TransportLoopback::make_pair()), dem_link(*ends.first, 10.0), mbd(*ends.second, 10.0), dem(&dem_link) {}
  ~Pair() {
    if (partner.joinable()) partner.join();
  }
  void answer_hello(std::vector<std::string> names) {
    Hello hello;
    mbd.receive(hello);
    Geometry geometry;
    for (const std::string& name : names) geometry.bodies.push_back({unit_boundary(name), BodyMotion()});
    mbd.send(geometry);
  }
  void accept(double t_end) {
    mbd.receive(start);
    Accept answer;
    answer.scheme = "css-trapezoid";
    answer.t_end = t_end;
    mbd.send(answer);
  }
  std::pair<std::unique_ptr<TransportLoopback>, std::unique_ptr<TransportLoopback>> ends;
  Link dem_link, mbd;
  DemLink dem;
  Start start;
  std::thread partner;
};

TEST(DemLink, WithoutAPartnerEveryUseIsRefused) {
  DemLink alone(nullptr);
  EXPECT_THROW(alone.bodies().couple("pad", "si"), InputError);
  EXPECT_NO_THROW(alone.script_ended());  // it is plain LIGGGHTS
}

TEST(DemLink, GuessesTheNameThatWasMeant) {
  Pair pair;
  pair.partner = std::thread([&] { pair.answer_hello({"leg_1_pad", "cabin"}); });
  const std::string said = test::error_of<InputError>([&] { pair.dem.bodies().couple("leg1_pad", "si"); });
  EXPECT_TRUE(test::names(said, {"leg_1_pad"}));
  EXPECT_EQ(test::error_of<InputError>([&] { pair.dem.bodies().couple("xyz", "si"); }).find("Did you mean"),
            std::string::npos);
}

TEST(DemLink, StartNamesTheBodiesInTheScriptsOrder) {
  Pair pair;
  pair.partner = std::thread([&] {
    pair.answer_hello({"a", "b", "c"});
    pair.accept(1.0);
  });
  EXPECT_EQ(pair.dem.bodies().couple("c", "si"), 0);
  EXPECT_EQ(pair.dem.bodies().couple("a", "si"), 1);
  EXPECT_EQ(pair.dem.bodies().couple("c", "si"), 0);
  pair.dem.start(script(1e-4, 5, 100));
  pair.partner.join();
  EXPECT_EQ(pair.start.bodies, (std::vector<std::string>{"c", "a"}));
  EXPECT_EQ(pair.start.dt, 1e-4);
  EXPECT_EQ(pair.start.n, 5);
  EXPECT_EQ(pair.start.step, 100);
  EXPECT_NO_THROW(pair.dem.start(script(1e-4, 5, 200)));
  EXPECT_THROW(pair.dem.start(script(2e-4, 5, 200)), InputError);
  EXPECT_THROW(pair.dem.bodies().couple("b", "si"), InputError);
}

TEST(DemLink, TheForceOfTheSetUpOpensTheFirstSubstep) {
  // Force 8 N at set-up, 2 N after the only substep: the mean under velocity Verlet is 5 N.
  Pair pair;
  Load load;
  pair.partner = std::thread([&] {
    pair.answer_hello({"pad"});
    pair.accept(1e-4);
    Motion motion;
    motion.n = 1;
    motion.last_window = true;
    motion.bodies.resize(1);
    pair.mbd.send(motion);
    pair.mbd.receive(load);
    pair.mbd.close();
  });
  pair.dem.bodies().couple("pad", "si");
  pair.dem.start(script(1e-4, 1, 0));
  const auto push = [&](double f) {
    pair.dem.window().body(0).add_contact({{0, 1, 2}, {1, 0, 0}}, {0, 0, f}, Eigen::Vector3d::Zero(), 0.01 * f, 100.0);
  };
  push(1000.0);  // of nobody's concern: before the set-up
  pair.dem.window().opening_forces().expect_set_up();
  push(8.0);
  pair.dem.window().begin_substep(1);
  pair.dem.window().begin_substep(1);  // a second fix of the same step changes nothing
  EXPECT_TRUE(pair.dem.window().in_last_substep());
  push(2.0);
  ASSERT_TRUE(pair.dem.window().end_substep());
  std::vector<double> sums;
  pair.dem.window().write_shares(38, false, sums);
  EXPECT_FALSE(pair.dem.window().end_requested());
  std::vector<double> both = sums;  // two ranks with the same forces
  both.insert(both.end(), sums.begin(), sums.end());
  pair.dem.window().finish_window(both, 2);
  pair.partner.join();
  EXPECT_TRUE(pair.dem.finished());
  EXPECT_DOUBLE_EQ(load.bodies[0].mean.F_W[2], 10.0);
  EXPECT_DOUBLE_EQ(load.bodies[0].peak.force, 10.0);
  EXPECT_EQ(load.bodies[0].contacts, 2);
  EXPECT_DOUBLE_EQ(load.bodies[0].max_overlap_over_radius, 0.02);  // the set-up belongs to the window before
  EXPECT_DOUBLE_EQ(load.bodies[0].contact_stiffness, 200.0);
  EXPECT_EQ(load.particles, 76);
  EXPECT_EQ(load.lost, 0);
  EXPECT_TRUE(load.warnings.empty());
  EXPECT_NO_THROW(pair.dem.script_ended());
  EXPECT_THROW(pair.dem.window().begin_substep(2), InputError);
}

// Windows of one substep; in each one rank counts so many grains, and so many lost ones.
struct Census {
  double grains, lost;
  GrainChanges changes = {};
  GrainFault fault = {};
};
std::vector<Load> loads_of(const std::vector<Census>& census, double max_lost, std::string* failure = nullptr,
                           bool outflow = false) {
  Pair pair;
  std::vector<Load> loads;
  pair.partner = std::thread([&] {
    pair.answer_hello({"pad"});
    pair.accept(1e-4 * static_cast<double>(census.size()));
    Motion motion;
    motion.n = 1;
    motion.bodies.resize(1);
    try {
      for (; !motion.last_window; ++motion.window) {
        motion.time = 1e-4 * static_cast<double>(motion.window);
        motion.last_window = motion.window + 1 == static_cast<std::int64_t>(census.size());
        pair.mbd.send(motion);
        Load load;
        pair.mbd.receive(load);
        loads.push_back(load);
        if (motion.last_window) break;
      }
      pair.mbd.close();
    } catch (const PartnerError&) {  // too many are lost
    }
  });
  pair.dem.bodies().couple("pad", "si");
  pair.dem.grains().set_max_lost(max_lost);
  if (outflow) pair.dem.grains().expect_outflow();
  const double before_start = wall_clock();
  pair.dem.start(script(1e-4, 1, 0));
  const double after_start = wall_clock();
  double before_end = 0.0;
  pair.dem.window().opening_forces().expect_set_up();
  pair.dem.grains().count_changes();
  try {
    int step = 0;
    for (const Census& now : census) {
      pair.dem.window().begin_substep(++step);
      EXPECT_TRUE(pair.dem.window().end_substep());
      const auto grains = static_cast<std::int64_t>(now.grains), lost = static_cast<std::int64_t>(now.lost);
      pair.dem.grains().exchanged(grains + lost, grains);
      pair.dem.grains().changed(now.changes);
      pair.dem.grains().fault(now.fault);
      std::vector<double> row;
      pair.dem.window().write_shares(grains, false, row);
      before_end = wall_clock();
      pair.dem.window().finish_window(row, 1);
    }
  } catch (const NumericalError& error) {
    EXPECT_NE(failure, nullptr) << error.what();
    if (failure != nullptr) *failure = error.what();
    pair.dem.fail(error.what());
  }
  pair.partner.join();
  if (failure == nullptr) {  // the grains' own time and what they waited are all that went by
    double told = 0.0;
    for (const Load& load : loads) told += load.wall_seconds + load.waited_seconds;
    constexpr double kRounding = 1e-6;  // of readings of a clock that has run for months [s]
    EXPECT_LE(told, wall_clock() - before_start + kRounding);
    EXPECT_GE(told, before_end - after_start - kRounding);
  }
  return loads;
}

TEST(DemLink, LostGrainsAreCountedAndToldOnce) {
  const std::vector<Load> loads = loads_of({{100, 0}, {98, 2}, {98, 0}, {97, 1}}, 0.05);
  ASSERT_EQ(loads.size(), 4U);
  EXPECT_EQ(loads[0].lost, 0);
  EXPECT_EQ(loads[1].lost, 2);
  EXPECT_EQ(loads[3].lost, 3);
  EXPECT_EQ(loads[3].particles, 97);
  EXPECT_TRUE(loads[0].warnings.empty());
  ASSERT_EQ(loads[1].warnings.size(), 1U);
  EXPECT_TRUE(test::names(loads[1].warnings[0], {"0.0002", "100"}));
  EXPECT_TRUE(loads[2].warnings.empty());
  EXPECT_TRUE(loads[3].warnings.empty());
}

TEST(DemLink, TooManyLostGrainsEndTheRun) {
  std::string failure;
  EXPECT_EQ(loads_of({{100, 0}, {95, 5}, {94, 1}, {94, 0}}, 0.05, &failure).size(), 2U);
  EXPECT_TRUE(test::names(failure, {"100"}));
  EXPECT_TRUE(test::names(failure, {"0.05"}));
  loads_of({{0, 7}}, 0.9, &failure);
}

TEST(DemLink, GrainsThatAreMeantToLeaveAreCountedWithoutAWord) {
  const std::vector<Load> loads =
      loads_of({{100, 0}, {40, 60, {0, 0, 0, 1.5}}, {1, 39, {0, 0, 0, 0.25}}}, 0.05, nullptr, true);
  ASSERT_EQ(loads.size(), 3U);
  EXPECT_EQ(loads[2].lost, 99);
  EXPECT_EQ(loads[2].changes.lost_mass, 1.75);
  EXPECT_TRUE(loads[1].warnings.empty() && loads[2].warnings.empty());
}

TEST(DemLink, ChangesOfGrainsAddUpSinceTheStart) {
  const std::vector<Load> loads = loads_of({{9, 0, {8, -2, 0.5, 0}}, {9, 0}, {9, 0, {4, -1, 0, 0}}}, 0.05);
  ASSERT_EQ(loads.size(), 3U);
  EXPECT_EQ(loads[1].changes.inserted, 8.0);
  EXPECT_EQ(loads[2].changes.inserted, 12.0);
  EXPECT_EQ(loads[2].changes.left, -3.0);
  EXPECT_EQ(loads[2].changes.changed, 0.5);
}

TEST(DemLink, AGrainThatABodyCannotStopEndsTheRun) {
  for (const auto& [kind, code] :
       {std::pair{GrainFault::kTooFast, code::kGrainTooFast}, {GrainFault::kPassed, code::kGrainPassed}}) {
    std::string failure;
    loads_of({{9, 0}, {9, 0, {}, {kind, 0.25, 17, 0, 300.0, 0.01}}, {9, 0}}, 0.05, &failure);
    EXPECT_TRUE(test::names(failure, {"t = 0.25 s", "17", "pad", std::string(code.number)}));
  }
}

TEST(DemLink, GravityThatChangesBetweenTwoRunsIsRefused) {
  Pair pair;
  pair.partner = std::thread([&] {
    pair.answer_hello({"pad"});
    pair.accept(1.0);
  });
  pair.dem.bodies().couple("pad", "si");
  Start moon = script(1e-4, 5, 0);
  moon.gravity = {0, 0, -1.63};
  moon.gravity_known = true;
  pair.dem.start(moon);
  EXPECT_NO_THROW(pair.dem.start(moon));
  Start earth = moon;
  earth.gravity = {0, 0, -9.81};
  const std::string said = test::error_of<InputError>([&] { pair.dem.start(earth); });
  EXPECT_TRUE(test::names(said, {"-1.63", "-9.81"}));
}

TEST(DemLink, WhatTheSceneHasForGrainsAndTheScriptDoesNotUseIsTold) {
  Pair pair;
  pair.partner = std::thread([&] {
    pair.answer_hello({"pad", "leg"});
    pair.accept(1.0);
  });
  pair.dem.bodies().touch_surface(pair.dem.bodies().couple("pad", "si"));
  pair.dem.start(script(1e-4, 5, 0));
  pair.partner.join();
  ASSERT_EQ(pair.start.warnings.size(), 1U);
  EXPECT_TRUE(test::names(pair.start.warnings[0], {"leg"}));
}

TEST(DemLink, AScriptThatMayEndEarlyEndsWithoutAFailure) {
  Pair pair;
  pair.partner = std::thread([&] {
    pair.answer_hello({"pad"});
    pair.accept(1.0);
    Motion motion;
    motion.n = 10;
    motion.bodies.resize(1);
    pair.mbd.send(motion);
    Load load;
    EXPECT_THROW(pair.mbd.receive(load), PartnerError);
  });
  pair.dem.bodies().couple("pad", "si");
  Start start = script(1e-4, 10, 0);
  start.may_end_early = true;
  pair.dem.start(start);
  pair.dem.window().opening_forces().expect_set_up();
  pair.dem.window().begin_substep(1);
  EXPECT_FALSE(pair.dem.window().end_substep());
  EXPECT_NO_THROW(pair.dem.uncoupled_by("unfix m"));
  pair.partner.join();
  EXPECT_TRUE(pair.dem.finished());
  EXPECT_EQ(pair.mbd.partner_status(), Status::kOk);
}

TEST(DemLink, ACommandThatTakesTheCouplingAwayTooEarlyIsRefused) {
  Pair pair;
  pair.partner = std::thread([&] {
    pair.answer_hello({"pad", "leg"});
    pair.accept(1.0);
  });
  pair.dem.bodies().couple("pad", "si");
  EXPECT_NO_THROW(pair.dem.uncoupled_by("clear"));  // before the first run: it starts anew
  EXPECT_EQ(pair.dem.bodies().couple("leg", "si"), 0);
  pair.dem.start(script(1e-4, 10, 0));
  const std::string said = test::error_of<InputError>([&] { pair.dem.uncoupled_by("unfix m"); });
}

// A signal may reach one rank alone: all know of it after the same window.
TEST(DemLink, OneRankThatIsAskedToEndAsksAll) {
  for (const int signalled : {0, 1, 2}) {
    Pair pair;
    pair.partner = std::thread([&] {
      pair.answer_hello({"pad"});
      pair.accept(1e-3);
      Motion motion;
      motion.n = 1;
      motion.bodies.resize(1);
      pair.mbd.send(motion);
      Load load;
      pair.mbd.receive(load);
      EXPECT_THROW(pair.mbd.receive(load), Interrupted);
    });
    pair.dem.bodies().couple("pad", "si");
    pair.dem.start(script(1e-4, 1, 0));
    pair.dem.window().begin_substep(1);
    ASSERT_TRUE(pair.dem.window().end_substep());
    std::vector<double> rows, row;
    for (int rank = 0; rank < 3; ++rank) {
      pair.dem.window().write_shares(1, rank == signalled, row);
      rows.insert(rows.end(), row.begin(), row.end());
    }
    pair.dem.window().finish_window(rows, 3);
    EXPECT_TRUE(pair.dem.window().end_requested()) << signalled;
    EXPECT_TRUE(pair.dem.fail("stopped by a signal", Status::kInterrupted));
    pair.partner.join();
  }
}

TEST(DemLink, AScriptThatEndsTooEarlySaysWhenAndHowManyStepsAreNeeded) {
  Pair pair;
  std::string heard;
  pair.partner = std::thread([&] {
    pair.answer_hello({"pad"});
    pair.accept(1e-2);
    Motion motion;
    motion.n = 10;
    motion.bodies.resize(1);
    pair.mbd.send(motion);
    Load load;
    heard =
        test::error_of<ProtocolError>([&] { pair.mbd.receive(load); });  // bad input on one side is bad input on both
  });
  pair.dem.bodies().couple("pad", "si");
  pair.dem.start(script(1e-4, 10, 0));
  pair.dem.window().opening_forces().expect_set_up();
  for (int step = 1; step <= 4; ++step) {
    pair.dem.window().begin_substep(step);
    EXPECT_FALSE(pair.dem.window().end_substep());
  }
  const std::string said = test::error_of<InputError>([&] { pair.dem.script_ended(); });
  pair.partner.join();
  EXPECT_TRUE(test::names(said, {"0.0004", "0.01", "100"}));
  EXPECT_EQ(heard, "liggghts_mbd stopped: " + said);
}

TEST(DemLink, AnInterruptedScriptIsNoFailure) {
  Pair pair;
  pair.partner = std::thread([&] {
    pair.answer_hello({"pad"});
    EXPECT_THROW(pair.accept(1.0), PartnerError);
  });
  pair.dem.bodies().couple("pad", "si");
  EXPECT_TRUE(pair.dem.fail("stopped by hand", Status::kInterrupted));
  EXPECT_NO_THROW(pair.dem.script_ended());  // there is nothing left to say
  pair.partner.join();
  EXPECT_EQ(pair.mbd.partner_status(), Status::kInterrupted);
}

TEST(DemLink, RefusesAMotionOfAnotherShape) {
  for (int wrong = 0; wrong < 4; ++wrong) {
    Pair pair;
    pair.partner = std::thread([&] {
      pair.answer_hello({"pad"});
      pair.accept(1.0);
      Motion motion;
      motion.n = wrong == 0 ? 11 : wrong == 1 ? 0 : 10;
      motion.bodies.resize(wrong == 2 ? 2 : 1);
      if (wrong == 3) motion.bodies[0].resize(2);
      pair.mbd.send(motion);
    });
    pair.dem.bodies().couple("pad", "si");
    pair.dem.start(script(1e-4, 10, 0));
    pair.dem.window().opening_forces().expect_set_up();
    EXPECT_THROW(pair.dem.window().begin_substep(1), ProtocolError) << wrong;
  }
}

using Names = std::vector<std::string>;

BodyLoad empty_load(int modes, std::size_t tangents) {
  BodyLoad load;
  load.mean = MeanLoad(modes);
  load.tangent.resize(tangents);
  return load;
}

BodyLoad random_load(unsigned seed) {
  test::RandomNumbers random(seed);
  BodyLoad load;
  test::randomize(load, random, 2);
  return load;
}

// A plate of two triangles in z = 0, and a beam of radius 0.1 along x at z = 1.
TEST(GrainPaths, MeetWhatTheyPassThrough) {
  Eigen::Matrix3Xd nodes(3, 6);
  nodes << 0, 1, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1;
  const ModalBoundary boundary("both", nodes, {{0, 1, 2}, {0, 2, 3}}, {{4, 5, 0.1, 0}});
  const auto meets = [&](Eigen::Vector3d from, Eigen::Vector3d way) { return path_meets(boundary, nodes, from, way); };
  EXPECT_TRUE(meets({0.3, 0.6, 0.2}, {0.1, 0.0, -0.4}));
  EXPECT_TRUE(meets({0.3, 0.6, -0.2}, {0.0, 0.0, 0.4})) << "from below";
  EXPECT_FALSE(meets({0.3, 0.6, 0.2}, {0.0, 0.0, -0.19})) << "ends above";
  EXPECT_FALSE(meets({0.3, 0.6, 0.2}, {0.0, 0.0, 9.0})) << "moves away";
  EXPECT_FALSE(meets({1.3, 0.6, 0.2}, {0.0, 0.0, -0.4})) << "passes by";
  EXPECT_TRUE(meets({0.5, -1.0, 1.09}, {0.0, 2.0, 0.0})) << "the side of the beam";
  EXPECT_FALSE(meets({0.5, -1.0, 1.11}, {0.0, 2.0, 0.0})) << "above the beam";
  EXPECT_FALSE(meets({1.11, -1.0, 1.0}, {0.0, 2.0, 0.0})) << "beyond its end";
}

TEST(GrainPassages, AreReversalsWithinAStep) {
  const Eigen::Vector3d down(0, 0, -1);
  GrainPassages passages;
  EXPECT_FALSE(passages.passes(1, 7, 0.002 * down, 0.003));
  EXPECT_FALSE(passages.passes(2, 7, 0.001 * down, 0.003)) << "comes nearer";
  EXPECT_FALSE(passages.passes(2, 8, -0.001 * down, 0.003)) << "another grain, on the other side";
  EXPECT_FALSE(passages.passes(3, 7, -0.004 * down, 0.001)) << "another surface is nearer now: its way was 1 mm";
  EXPECT_TRUE(passages.passes(4, 7, 0.001 * down, 0.003));
  EXPECT_FALSE(passages.passes(9, 7, -0.001 * down, 0.003)) << "apart in between";
}

TEST(RankShares, ShareOfTheOnlyRankIsTheLoad) {
  BodyLoad share = random_load(5), load = empty_load(2, share.tangent.size());
  share.max_overlap_over_radius = 0.03;
  share.max_patch_over_facet = 0.3;
  share.grain_energy = share.grain_mass = share.grain_omega2 = share.peak.force = 2.0;
  share.peak.step = share.peak.steps = 4;
  std::vector<double> row;
  append_share(share, row);
  EXPECT_EQ(row.size(), share_size(share));
  EXPECT_EQ(add_share(row.data(), load), row.data() + row.size());
  EXPECT_EQ(test::differences(share, load), Names());
}

// Every number of the row alone: it arrives twice as large from two ranks with the same share, except numbers of which the
// largest counts.
TEST(RankShares, RanksAddUpAndTheLargestOverlapCounts) {
  BodyLoad load = empty_load(2, 2);
  std::vector<double> row(share_size(load));
  std::iota(row.begin(), row.end(), 1.0);
  add_share(row.data(), load);
  const BodyLoad one = load;
  add_share(row.data(), load);
  EXPECT_EQ(load.max_overlap_over_radius, one.max_overlap_over_radius);
  EXPECT_EQ(load.max_patch_over_facet, one.max_patch_over_facet);
  EXPECT_EQ(load.grain_energy, one.grain_energy);
  EXPECT_EQ(load.grain_mass, one.grain_mass);
  EXPECT_EQ(load.grain_omega2, one.grain_omega2);
  EXPECT_EQ(load.peak.force, one.peak.force);
  EXPECT_EQ(load.peak.step, one.peak.step);
  EXPECT_EQ(load.peak.steps, one.peak.steps);
  std::vector<double> once, twice;
  append_share(one, once);
  append_share(load, twice);
  EXPECT_EQ(once, row);
  int doubled = 0;
  for (std::size_t i = 0; i < row.size(); ++i) doubled += twice[i] == 2.0 * row[i] ? 1 : 0;
  EXPECT_EQ(doubled, static_cast<int>(row.size()) - 8);
}

// Forces of two ranks at the ends of six substeps: their sum, 4 8 9.5 10 4 4 N, has its largest mean of a substep, 9.75 N, in
// the fourth; the third has 8.75 N, the others less than 90 %. One rank alone is largest in the fifth.
TEST(DemBody, FindsThePeakOfTheSumOverTheRanks) {
  const double forces[2][6] = {{4, 0, 4.5, 6, 12, 4}, {0, 8, 5, 4, -8, 0}};  // [N]
  const CoupledBody body = {ModalBoundary("pad", Eigen::Matrix3Xd::Zero(3, 3), {{0, 1, 2}}), BodyMotion()};
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  std::vector<double> rows;
  DemBody sum(body, *scheme);
  for (const auto& rank : forces) {
    DemBody dem(body, *scheme);
    dem.begin_window(body.initial, 6, 1e-3);
    if (&rank == &forces[0]) sum.begin_window(body.initial, 6, 1e-3);
    for (const double force : rank) {
      dem.advance();
      dem.clear_contacts();
      dem.add_contact({{0, 1, 2}, {1, 0, 0}}, {0, force, 0}, Eigen::Vector3d::Zero(), 0.01, 100.0);
      dem.end_substep(1e-3);
    }
    dem.append_share(rows);
  }
  sum.clear_load();
  EXPECT_EQ(sum.add_share(sum.add_share(rows.data())), rows.data() + rows.size());
  sum.finish_load();
  EXPECT_DOUBLE_EQ(sum.load().peak.force, 9.75);
  EXPECT_EQ(sum.load().peak.step, 4);
  EXPECT_EQ(sum.load().peak.steps, 1);
}

TEST(RankShares, EveryFieldOfTheLoadHasItsPlaceInTheRow) {
  BodyLoad load = random_load(6);
  std::vector<double> before;
  append_share(load, before);
  test::for_each_changed(load, [&](const std::string& path, const BodyLoad& changed) {
    std::vector<double> row;
    append_share(changed, row);
    EXPECT_NE(row, before) << path << " is not in the row";
  });
}

TEST(RankShares, ClearedLoadIsEmptyAndKeepsItsShape) {
  BodyLoad load = random_load(7);
  const std::size_t size = share_size(load);
  clear(load);
  EXPECT_EQ(share_size(load), size);
  EXPECT_EQ(test::differences(load, empty_load(2, 2)), Names());
}

// Each number of every rank comes to its own sum, and a row begins anew.
TEST(GrainBooks, AddTheChangesOfAllRanks) {
  GrainBooks first, second;
  const GrainChanges one{0.5, -0.25, 2.0, 0.125, 3.0, 5.0, 0.75, 7.0},
      two{1.5, -1.25, 4.0, 0.375, 30.0, 50.0, 1.75, 70.0};
  for (GrainBooks* books : {&first, &second}) {
    books->begin();
    books->count_changes();
  }
  first.changed(one);
  second.changed(two);
  std::vector<double> rows;
  first.append_share(10, rows);
  second.append_share(20, rows);
  first.append_share(11, rows);  // of the next window: nothing has changed
  Load load;
  for (std::size_t k = 0; k < rows.size(); k += GrainBooks::row_size()) first.add_share(rows.data() + k, {}, 1e-5);
  first.finish_window(0.0, load);
  EXPECT_EQ(load.particles, 41);
  EXPECT_EQ(load.changes.inserted, 2.0);
  EXPECT_EQ(load.changes.left, -1.5);
  EXPECT_EQ(load.changes.changed, 6.0);
  EXPECT_EQ(load.changes.lost_mass, 0.5);
  EXPECT_EQ(load.changes.added, 33.0);
  EXPECT_EQ(load.changes.removed, 55.0);
  EXPECT_EQ(load.changes.added_mass, 2.5);
  EXPECT_EQ(load.changes.removed_mass, 77.0);
}

}  // namespace
}  // namespace footfall

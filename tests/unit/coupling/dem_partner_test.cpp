// The mechanism's side of the exchange: what both agree on, what is refused, what a window trades.

#include "mbd_solver/coupling/dem_partner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>

#include "coupler/archive.h"
#include "coupler/transport_loopback.h"
#include "tests/unit/coupling/loopback_grains.h"

namespace footfall {
namespace {

CoupledBody body_named(const std::string& name) {
  return {ModalBoundary(name, Eigen::Matrix3Xd::Identity(3, 3), {{0, 1, 2}}, {}), BodyMotion(0)};
}

// The grains' messages lie ready before the partner is made: no thread.
class DemPartnerTest : public ::testing::Test {
 protected:
  DemPartnerTest() : ends(TransportLoopback::make_pair()), grains(*ends.first, test::kPatience) {
    hello.unit_style = "si";
    start.dt = 1e-4;
    start.n = 5;
    start.bodies = {"pad"};
    terms.scheme = "css-trapezoid";
    terms.t_end = 2.0;
    terms.n_max = 100;
  }
  DemPartner partner() {
    grains.send(hello);
    grains.send(start);
    grains.send(Close{});  // the answer to a refusal; nobody reads it else
    return DemPartner(*ends.second, {body_named("cabin"), body_named("pad"), body_named("foot")}, terms,
                      test::kPatience);
  }
  // The words of the refusal, which the grains' side must hear too.
  std::string refusal() {
    try {
      partner();
    } catch (const ProtocolError& error) {
      std::string heard;
      Geometry geometry;
      try {
        if (start_is_reached) grains.receive(geometry);
        Accept accept;
        grains.receive(accept);
      } catch (const ProtocolError& told) {
        heard = told.what();
      }
      EXPECT_NE(heard.find(error.what()), std::string::npos) << "the grains heard: " << heard;
      return error.what();
    }
    return "no refusal";
  }

  std::pair<std::unique_ptr<TransportLoopback>, std::unique_ptr<TransportLoopback>> ends;
  Link grains;
  Hello hello;
  Start start;
  DemTerms terms;
  bool start_is_reached = true;  // false: refused before any geometry is sent
};

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(DemPartnerTest, SendsEveryBoundaryAndAcceptsWhatTheScriptSays) {
  const DemPartner partner = this->partner();
  EXPECT_EQ(partner.dt(), 1e-4);
  EXPECT_EQ(partner.substeps(), 5);
  Geometry geometry;
  Accept accept;
  grains.receive(geometry);
  grains.receive(accept);
  ASSERT_EQ(geometry.bodies.size(), 3u);
  EXPECT_EQ(geometry.bodies[1].boundary.name(), "pad");
  EXPECT_EQ(accept.scheme, "css-trapezoid");
  EXPECT_EQ(accept.t_end, 2.0);
  EXPECT_EQ(accept.n_max, 5);
}

TEST_F(DemPartnerTest, WindowsThatAreChosenAreLimitedByTheScene) {
  start.n = 0;
  const DemPartner partner = this->partner();
  Geometry geometry;
  Accept accept;
  grains.receive(geometry);
  grains.receive(accept);
  EXPECT_EQ(partner.substeps(), 0);
  EXPECT_EQ(accept.n_max, 100);
}

TEST_F(DemPartnerTest, TheOrderOfBodiesIsThatOfTheScript) {
  start.bodies = {"foot", "cabin"};
  EXPECT_EQ(partner().coupled(), (std::vector<int>{2, 0}));
}

TEST_F(DemPartnerTest, RefusesAnotherProtocol) {
  hello.protocol = kProtocolVersion + 1;
  start_is_reached = false;
  EXPECT_TRUE(says(refusal(), "protocol " + std::to_string(kProtocolVersion + 1)));
}

TEST_F(DemPartnerTest, RefusesOtherUnits) {
  hello.unit_style = "cgs";
  start_is_reached = false;
  EXPECT_TRUE(says(refusal(), "units cgs"));
}

TEST_F(DemPartnerTest, RefusesATimeStepBeyondTheScenesLimit) {
  terms.max_dt = 5e-5;
  const std::string text = refusal();
  EXPECT_TRUE(says(text, "0.0001 s") && says(text, "5e-05 s")) << text;
}

TEST_F(DemPartnerTest, AcceptsATimeStepAtTheScenesLimit) {
  terms.max_dt = 1e-4;
  EXPECT_EQ(partner().dt(), 1e-4);
}

TEST_F(DemPartnerTest, RefusesATimeStepThatTheSceneStatesOtherwise) {
  terms.expected_dt = 2e-4;
  const std::string text = refusal();
  EXPECT_TRUE(says(text, "0.0001 s") && says(text, "0.0002")) << text;
}

TEST_F(DemPartnerTest, RefusesAWindowThatTheSceneStatesOtherwise) {
  terms.expected_n = 10;
  const std::string text = refusal();
  EXPECT_TRUE(says(text, "every 5") && says(text, "10")) << text;
}

TEST_F(DemPartnerTest, RefusesABodyWithoutBoundaryAndNamesThoseWithOne) {
  start.bodies = {"pad", "leg"};
  const std::string text = refusal();
  EXPECT_TRUE(says(text, "\"leg\"") && says(text, "cabin, pad, foot")) << text;
}

TEST_F(DemPartnerTest, RefusesATimeStepThatIsNone) {
  start.dt = 0.0;
  EXPECT_TRUE(says(refusal(), "expected a positive time step"));
}

TEST_F(DemPartnerTest, RefusesTheGravityOfAnotherPlanet) {
  terms.gravity = {0, 0, -1.63};
  start.gravity = {0, 0, -9.81};
  start.gravity_known = true;
  const std::string text = refusal();
  EXPECT_TRUE(says(text, "(0, 0, -9.81) m/s2") && says(text, "(0, 0, -1.63) m/s2")) << text;
}

TEST_F(DemPartnerTest, RefusesGravityThatPointsUp) {
  terms.gravity = {0, 0, -9.81};
  start.gravity = {0, 0, 9.81};
  start.gravity_known = true;
  EXPECT_TRUE(says(refusal(), "(0, 0, 9.81) m/s2"));
}

TEST_F(DemPartnerTest, AcceptsGravityThatAgreesOrIsNotToBeCompared) {
  terms.gravity = {0, 0, -1.63};
  start.gravity = {0, 0, -1.63 * (1.0 + 1e-9)};  // a direction that LIGGGHTS has made a unit vector
  start.gravity_known = true;
  EXPECT_TRUE(partner().warnings().empty());
}

TEST_F(DemPartnerTest, AcceptsTheScriptsOwnGravityWhenItSaysSo) {
  terms.gravity = {0, 0, -1.63};
  start.gravity = {0, 0, -9.81};
  EXPECT_TRUE(partner().warnings().empty());
}

TEST_F(DemPartnerTest, WarnsOfGrainsWithoutWeight) {
  terms.gravity = {0, 0, -1.63};
  start.gravity_known = true;
  start.warnings = {"of the script"};
  const DemPartner partner = this->partner();
  ASSERT_EQ(partner.warnings().size(), 2U);
  EXPECT_EQ(partner.warnings()[0], "of the script");
  EXPECT_TRUE(says(partner.warnings()[1], "no fix gravity")) << partner.warnings()[1];
}

TEST_F(DemPartnerTest, AScriptThatMayEndEarlyEndsWithoutAnError) {
  start.may_end_early = true;
  DemPartner partner = this->partner();  // the Close behind it ends the script
  Motion motion;
  motion.n = 5;
  motion.bodies = {BodyMotion(0)};
  partner.exchange(motion);
  EXPECT_TRUE(partner.script_has_ended());
  EXPECT_NO_THROW(partner.close());
}

TEST_F(DemPartnerTest, AnyOtherScriptMustNotEndEarly) {
  DemPartner partner = this->partner();
  Motion motion;
  motion.n = 5;
  motion.bodies = {BodyMotion(0)};
  EXPECT_THROW(partner.exchange(motion), PartnerError);
}

Start fixed_windows() {
  Start start;
  start.dt = 1e-4;
  start.n = 5;
  start.bodies = {"pad"};
  return start;
}

DemTerms terms(const std::string& scheme, double t_end) {
  DemTerms terms;
  terms.scheme = scheme;
  terms.t_end = t_end;
  return terms;
}

Motion one_window(std::int64_t k, bool last) {
  Motion motion;
  motion.window = k;
  motion.n = 5;
  motion.last_window = last;
  motion.bodies = {BodyMotion(0)};
  motion.bodies[0].r.x() = static_cast<double>(k);
  return motion;
}

TEST(DemPartner, TradesOneMotionForOneLoad) {
  test::LoopbackGrains grains(fixed_windows(), [](const Motion& motion, Load& load) {
    load.bodies[0].mean.F_W = Eigen::Vector3d(1.0 + motion.bodies[0].r.x(), 2.0, 3.0);
  });
  DemPartner partner(grains.transport(), {body_named("pad")}, terms("css", 1e-3), test::kPatience);
  for (int k = 0; k < 3; ++k) {
    const Load& load = partner.exchange(one_window(k, k == 2));
    EXPECT_EQ(load.bodies[0].mean.F_W, Eigen::Vector3d(1.0 + k, 2.0, 3.0));
    EXPECT_EQ(&load, &partner.load());
  }
  partner.close();
  EXPECT_EQ(grains.join(), "");
}

TEST(DemPartner, WorksWhileTheGrainsMove) {
  std::promise<void> worked;
  std::future<void> has_worked = worked.get_future();
  test::LoopbackGrains grains(fixed_windows(), [&](const Motion&, Load& load) {
    const auto in_time = has_worked.wait_for(std::chrono::seconds(10)) == std::future_status::ready;
    load.bodies[0].mean.F_W.x() = in_time ? 1.0 : 0.0;
  });
  DemPartner partner(grains.transport(), {body_named("pad")}, terms("css", 1e-3), test::kPatience);
  const Load& load = partner.exchange(one_window(0, true), [&] { worked.set_value(); });
  EXPECT_EQ(load.bodies[0].mean.F_W.x(), 1.0);
  partner.close();
}

TEST(DemPartner, WhatGoesOnFromACheckpointWasNotAskedToEnd) {
  test::LoopbackGrains grains(fixed_windows(), [](const Motion&, Load& load) {
    load.bodies[0].mean.F_W = Eigen::Vector3d(1.0, 2.0, 3.0);
    load.asked_to_end = true;  // a signal has met a rank in the window after which a checkpoint was due anyway
  });
  DemPartner partner(grains.transport(), {body_named("pad")}, terms("css", 1e-3), test::kPatience);
  partner.exchange(one_window(0, true));
  Archive kept;
  partner.visit(kept);
  EXPECT_TRUE(partner.load().asked_to_end) << "the run that was met still ends";
  Archive read("run.txt", kept.text());
  partner.visit(read);
  EXPECT_FALSE(partner.load().asked_to_end);
  EXPECT_EQ(partner.load().bodies[0].mean.F_W, Eigen::Vector3d(1.0, 2.0, 3.0));
  partner.close();
}

TEST(DemPartner, RefusesTheLoadOfAnotherWindow) {
  test::LoopbackGrains grains(fixed_windows(), [](const Motion&, Load& load) { ++load.window; });
  DemPartner partner(grains.transport(), {body_named("pad")}, terms("css", 1e-3), test::kPatience);
  EXPECT_THROW(partner.exchange(one_window(0, true)), ProtocolError);
  partner.close();
}

TEST(DemPartner, RefusesALoadOfOtherBodies) {
  test::LoopbackGrains grains(fixed_windows(), [](const Motion&, Load& load) { load.bodies.pop_back(); });
  DemPartner partner(grains.transport(), {body_named("pad")}, terms("css", 1e-3), test::kPatience);
  EXPECT_THROW(partner.exchange(one_window(0, true)), ProtocolError);
  partner.close();
}

}  // namespace
}  // namespace footfall

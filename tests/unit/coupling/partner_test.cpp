// The mechanism's side of the conversation, and what it reports of the coupling.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>

#include "coupler/archive.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/schemes/registry.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/coupling/codes.h"
#include "mbd_solver/coupling/contact_mass.h"
#include "mbd_solver/coupling/coupling_watch.h"
#include "mbd_solver/coupling/dem_partner.h"
#include "mbd_solver/dynamics/assembly.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/transport_loopback.h"
#include "tests/unit/coupling/loopback_grains.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

// The mechanism's side of the exchange: what both agree on, what is refused, what a window trades.

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
    load.end_requested = true;  // a signal has met a rank in the window after which a checkpoint was due anyway
  });
  DemPartner partner(grains.transport(), {body_named("pad")}, terms("css", 1e-3), test::kPatience);
  partner.exchange(one_window(0, true));
  Archive kept;
  partner.visit(kept);
  EXPECT_TRUE(partner.load().end_requested) << "the run that was met still ends";
  Archive read("run.txt", kept.text());
  partner.visit(read);
  EXPECT_FALSE(partner.load().end_requested);
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

constexpr double kHeld = std::numeric_limits<double>::infinity();  // mass of a body that is held or led [kg]
constexpr double kH = 1e-3;                                        // [s]

struct Told {
  double force = 0.0, grains_work = 0.0, received = 0.0;  // [N], [J]
  double pending = 0.0;                                   // [J]
  std::int64_t contacts = 1;                              // at the window's end
  double mean_contacts = 1.0;
  bool last = false;
  double gravity = 0.0, kinetic = 0.0;  // [J]
  int n = 10;                           // DEM steps of kH / 10
  ForcePeak peak = {};
};

// Of a script without variables.
CouplingAdvice plain_advice() {
  return {[](int n) { return "`every " + std::to_string(n) + "`"; }, "a smaller timestep in the script",
          [](double f) { return number_text(f, 2) + " times the modulus"; }};
}

// One body.
class Watched {
 public:
  explicit Watched(double mass) : mass_(mass) {}
  void window(const Told& told) {
    Load load;
    load.bodies.resize(1);
    load.bodies[0].mean.F_W.z() = told.force;
    load.bodies[0].mean.work = told.grains_work;
    load.bodies[0].contacts = told.contacts;
    load.bodies[0].mean_contacts = told.mean_contacts;
    load.bodies[0].contact_stiffness = 1e4;
    load.bodies[0].max_overlap_over_radius = overlap;
    load.bodies[0].max_patch_over_facet = patch;
    load.bodies[0].grain_energy = grain_energy;
    load.bodies[0].peak = told.peak;
    load.bodies[0].grain_mass = grain_mass;
    const double H = kH * told.n / 10;
    time_ += H;
    watch.observe({time_, H, told.n, told.last}, load,
                  {{mass_, told.received, told.gravity, told.kinetic, told.pending, 0.0, force_error, speed}});
  }
  // Whether a warning has the code, and the number if one is given.
  bool warns(const MessageCode& code, const std::string& number = "") const {
    std::vector<std::string> all = watch.warnings();
    for (const std::string& text : watch.conclusions()) all.push_back(text);
    return std::any_of(all.begin(), all.end(), [&](const std::string& warning) {
      return warning.find(code.number) != std::string::npos && warning.find(number) != std::string::npos;
    });
  }
  double overlap = 0.0, patch = 0.0, grain_energy = 0.0, force_error = 0.0, grain_mass = 0.0, speed = 0.0;
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  CouplingWatch watch{{"plate"}, CouplingSpec{}, *scheme, plain_advice()};

 private:
  double mass_, time_ = 0.0;
};

// A gain counts that lasts at the ends of two windows.
TEST(CouplingWatch, JudgesByWhatTheContactsMove) {
  // 1 J goes to the grains; the body must not keep 0.1 J of it.
  for (const double excess : {0.09, 0.12}) {
    Watched body(1.0);
    body.window({0.1, -1.0, excess - 1.0});
    EXPECT_TRUE(body.watch.warnings().empty());
    if (excess < 0.1) {
      EXPECT_NO_THROW(body.window({0.1}));
      EXPECT_TRUE(body.warns(code::kCouplingCreates));
    } else {
      EXPECT_THROW(body.window({0.1}), NumericalError);
    }
  }
}

// What the first step of a contact gains and the second gives back.
TEST(CouplingWatch, DoesNotJudgeTheFirstStepOfAContact) {
  Watched body(1.0);
  body.window({0.1, 0.0, 0.5});
  EXPECT_NO_THROW(body.window({0.1, 0.5, 0.0}));
  EXPECT_TRUE(body.watch.warnings().empty());
}

// 1e-9 J, all of it wrong, where grains of 1 mJ lie on the body.
TEST(CouplingWatch, ComparesWithTheEnergyOfTheGrainsThatTouch) {
  Watched body(1.0);
  body.grain_energy = 1e-3;
  for (int k = 0; k < 3; ++k) EXPECT_NO_THROW(body.window({0.0, 0.0, k == 0 ? 1e-9 : 0.0}));
  EXPECT_TRUE(body.watch.warnings().empty());
}

TEST(CouplingWatch, DoesNotCountTheWeightOfABodyThatSwings) {
  // 10 J go to the contacts with 9 J of the weight: 1 J was exchanged, and 0.12 J of it are too much.
  Watched body(1.0);
  Told told{0.1, -10.0, -9.88};
  told.gravity = 9.0;
  body.window(told);
  EXPECT_THROW(body.window({0.1}), NumericalError);
}

TEST(CouplingWatch, CountsTheMotionThatAContactHasBeforeIt) {
  Watched body(1.0);
  Told told{0.1, 0.0, 0.001};
  told.kinetic = 1.0;
  EXPECT_NO_THROW(body.window(told));
}

TEST(CouplingWatch, LeavesRestInPeace) {
  // Round-off of a body that rests on the grains: 1e-20 J of work, as much of it wrong, under 10 N.
  Watched body(1.0);
  for (int k = 0; k < 100; ++k) EXPECT_NO_THROW(body.window({10.0, 0.0, 1e-20}));
  EXPECT_TRUE(body.watch.warnings().empty());
}

TEST(CouplingWatch, LeavesHeldAndLedBodiesAlone) {
  Watched body(kHeld);
  for (int k = 0; k < 40; ++k) body.window({k % 2 == 0 ? 10.0 : 0.0, 0.0, 1.0, 2.0});  // swings, and is led
  EXPECT_EQ(body.watch.omega_h()[0], 0.0);
  EXPECT_TRUE(body.watch.warnings().empty());
  EXPECT_NEAR(body.watch.energy_residual(), -40.0 + 2.0, 1e-12);  // but tells what it saw
}

TEST(CouplingWatch, WarnsOfALoss) {
  Watched body(1.0);
  body.window({0.1, 1.0, 0.8});
  body.window({0.1});
  EXPECT_TRUE(body.warns(code::kCouplingDissipates, " 0.2 J"));
}

TEST(CouplingWatch, JudgesTheLastWindowByWhatTheGrainsGave) {
  // All that the body has received is pending: in the next window the grains would tell.
  const Told thrown{100.0, -0.001, 10.0, 10.001};
  Watched goes_on(1.0);
  EXPECT_NO_THROW(goes_on.window(thrown));
  Watched ends(1.0);
  Told last = thrown;
  last.last = true;
  EXPECT_THROW(ends.window(last), NumericalError);
}

TEST(CouplingWatch, WarnsWhenATouchIsShorterThanAWindow) {
  const Told flight{0.0, 0.0, 0.0, 0.0, 0, 0.0}, end{0.0, 0.0, 0.0, 0.0, 0, 0.0, true};
  Watched within(1.0);  // no contact at either end, some on the way
  within.window(flight);
  within.window({1.0, 0.0, 0.0, 0.0, 0, 0.3});
  within.window(end);
  EXPECT_TRUE(within.warns(code::kContactNotResolved));

  Watched astride(1.0);  // of an end of windows
  astride.window({1.0, 0.0, 0.0, 0.0, 4, 4 * 0.3});
  astride.window({1.0, 0.0, 0.0, 0.0, 0, 4 * 0.4});
  astride.window(end);
  EXPECT_TRUE(astride.warns(code::kContactNotResolved));

  Watched resolved(1.0);
  for (int k = 0; k < 10; ++k) resolved.window({1.0, 0.0, 0.0, 0.0, 4, 4.0});
  resolved.window({1.0, 0.0, 0.0, 0.0, 0, 4 * 0.4});
  resolved.window({0.01, 0.0, 0.0, 0.0, 0, 0.1});  // a grain that flies by
  resolved.window(end);
  EXPECT_FALSE(resolved.warns(code::kContactNotResolved));
}

TEST(CouplingWatch, WarnsOfDeepGrainsAndOfNarrowFacetsOnce) {
  Watched body(1.0);
  body.overlap = 0.04;
  body.patch = 0.9;
  body.window({});
  EXPECT_TRUE(body.watch.warnings().empty());
  body.overlap = 0.06;
  body.patch = 1.1;
  for (int k = 0; k < 2; ++k) body.window({});
  EXPECT_EQ(body.watch.warnings().size(), 1U);
  EXPECT_EQ(body.watch.conclusions().size(), 1U);
  EXPECT_TRUE(body.warns(code::kLargeOverlap, " 6 %"));
  EXPECT_TRUE(body.warns(code::kFacetsTooSmall, " 1.1 "));
}

// A bed by numbers, and a script with and without variables where modulus, time step and interval are set.
TEST(CouplingAdvice, IsWhatTheUserOfTheSceneCanType) {
  const TemporaryFolder folder;
  const auto script = [&](const std::string& name, const std::string& text) {
    Scene scene;
    scene.particles.emplace();
    scene.particles->script = folder.write(name, text);
    scene.particles->variables = {{"n", "4"}};
    return scene;
  };
  const Scene own = script("own.in",
                           "variable E index 35e6\nvariable dt index 1e-4\n"
                           "fix y all property/global youngsModulus peratomtype ${E} 207e9\n"
                           "timestep ${dt}\nfix m all couple/mbd every ${n} mesh a b\n"),
              plain = script("plain.in",
                             "fix y all property/global youngsModulus peratomtype 35e6 207e9\n"
                             "timestep 1e-4\nfix m all couple/mbd every 4 mesh a b\n");
  Scene box;
  box.particles.emplace();
  box.particles->box.emplace();
  box.particles->box->material.young = 1e7;
  const CouplingAdvice of_own = coupling_advice(own, false), of_plain = coupling_advice(plain, false),
                       of_box = coupling_advice(box, false);
  EXPECT_EQ(of_own.interval(2), "`--set particles.variables.n=2`");
  EXPECT_EQ(of_plain.interval(2), "`every 2`");
  EXPECT_EQ(of_box.interval(2), "`--set particles.box.exchange_steps=2`");
  EXPECT_EQ(coupling_advice(own, true).interval(2), "`--set coupling.max_substeps=2`");
  EXPECT_THAT(of_own.stiffer(10.0), ::testing::HasSubstr("`--set particles.variables.E=3.5e+08 "
                                                         "--set particles.variables.dt=3.2e-05`"));
  EXPECT_THAT(of_plain.stiffer(10.0), ::testing::HasSubstr("by 10 and divide the time step by 3.2"));
  EXPECT_THAT(of_box.stiffer(10.0), ::testing::HasSubstr("`--set particles.box.material.young=1e+08`"));
}

// Overlaps of an impact go with E^(-2/5): 0.24 / 0.05 needs 50 times the modulus.
TEST(CouplingWatch, TellsTheDeepestOverlapAtTheEnd) {
  Watched body(1.0);
  for (const double overlap : {0.0, 0.06, 0.24, 0.01}) {
    body.overlap = overlap;
    body.window({});
  }
  EXPECT_TRUE(body.watch.warnings().empty());
  EXPECT_TRUE(body.warns(code::kLargeOverlap, " 24 %"));
  EXPECT_TRUE(body.warns(code::kLargeOverlap, "50 times the modulus"));
}

// The contacts of 1e4 N/m: omega H = 0.1 of 1 kg, 1 of 10 g.
TEST(CouplingWatch, AdvisesTheIntervalThatKeepsTheLimitOfOmegaH) {
  Watched heavy(1.0), light(0.01);
  heavy.window({1.0});
  light.window({1.0});
  EXPECT_FALSE(heavy.warns(code::kIntervalTooLong));
  EXPECT_TRUE(light.warns(code::kIntervalTooLong, "`every 5`"));
}

// Above the limit, and no error of energy or force says that this matters; an error of the force of 2 % does.
TEST(CouplingWatch, JudgesAModerateOmegaHByItsErrors) {
  for (const double error : {0.0, 0.02}) {
    Watched body(0.03);  // omega H = 0.58
    body.force_error = error;
    for (int k = 0; k < 3; ++k) body.window({1.0});
    EXPECT_EQ(body.warns(code::kIntervalTooLong, "`every 8`"), error > 0.0);
  }
}

TEST(CouplingWatch, TellsOfAllBodiesAtOnce) {
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  CouplingWatch watch{{"a", "b", "c"}, CouplingSpec{}, *scheme, plain_advice()};
  Load load;
  load.bodies.resize(3);
  for (BodyLoad& body : load.bodies) body.contact_stiffness = 1e4;
  watch.observe({kH, kH, 10, false}, load, {{0.01}, {0.005}, {1.0}});
  ASSERT_EQ(watch.conclusions().size(), 1U);
  EXPECT_THAT(watch.conclusions()[0], ::testing::HasSubstr("body b has omega H = 1.41"));
  EXPECT_THAT(watch.conclusions()[0], ::testing::HasSubstr("(to a lesser degree also a); use `every 3`"));
}

// A grain of difference is round-off of the exchange; what a heap carries along is reported with its share of the bed.
TEST(CouplingWatch, ReportsTheMassThatABedWhichFollowsHasGained) {
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  CouplingWatch watch{{"blade"}, CouplingSpec{}, *scheme, plain_advice()};
  Load load;
  load.bodies.resize(1);
  load.particles = 349;  // 300 at the start
  load.changes.added = 813, load.changes.added_mass = 8.13;
  load.changes.removed = 812, load.changes.removed_mass = 8.12;
  watch.observe({kH, kH, 10, false}, load, {{0.01}});
  EXPECT_TRUE(watch.conclusions().empty());
  load.changes.removed = 764, load.changes.removed_mass = 7.64;
  watch.observe({2.0 * kH, kH, 10, false}, load, {{0.01}});
  ASSERT_EQ(watch.conclusions().size(), 1U);
  for (const char* part : {"W1641", "0.49 kg (16.3 %) more", "813 grains were added in front, 764 removed behind"})
    EXPECT_THAT(watch.conclusions()[0], ::testing::HasSubstr(part));
}

// A run whose end cuts its last interval to one step: the message is about the intervals that were too long.
TEST(CouplingWatch, SumsUpTheIntervalThatWasTooLong) {
  Watched body(0.01);  // omega H = 1
  body.window({1.0});
  Told last{1.0};
  last.n = 1;
  last.last = true;
  body.window(last);
  EXPECT_TRUE(body.warns(code::kIntervalTooLong, " = 1 at most, above 0.5: a coupling interval of 10 DEM steps"));
  EXPECT_FALSE(body.warns(code::kIntervalTooLong, " 1 DEM step "));
}

// No message advises more than one before it: events want two steps, omega H = 0.58 eight.
TEST(CouplingWatch, AdvisesNeverLongerIntervalsThanBefore) {
  Watched body(0.03);
  body.watch.tell_of_event("touch", {kH, kH, 10, false}, 0.2, true);
  body.force_error = 0.1;
  for (int k = 0; k < 3; ++k) body.window({1.0});
  EXPECT_TRUE(body.warns(code::kIntervalTooLong, "`every 2`"));
}

// An event that changes velocities by 20 % of the largest per window of ten steps, by 5 % in 2.5 steps: foreseen here, it need
// not be in the next run.
TEST(CouplingWatch, AdvisesNoLongerIntervalsThanEventsOfLoadsAllow) {
  for (const bool late : {false, true}) {
    Watched body(1.0);
    body.watch.tell_of_event("touch", {kH, kH, 10, false}, 0.2, late);
    EXPECT_EQ(body.warns(code::kEventLate, "`every 2`"), late);
    body.window({0.1, -1.0, 0.12 - 1.0});
    try {
      body.window({0.1});
      ADD_FAILURE() << "12 % of gain";
    } catch (const NumericalError& error) {
      EXPECT_NE(std::string(error.what()).find("`every 2`"), std::string::npos) << error.what();
    }
  }
}

// Means of ten DEM steps hide a peak of 12 N, of which four steps have at least 90 %. And a path that was missed.
TEST(CouplingWatch, WarnsOfForcesThatWindowsDoNotResolve) {
  const auto last_warns = [](Watched& body, const std::string& text = "") {
    Told end;
    end.last = true;
    body.window(end);
    return body.warns(code::kForceNotResolved, text);
  };
  const auto peak = [](double force, int n) {
    Told told{10.0};
    told.peak = {force, 5, 4};
    told.n = n;
    return told;
  };
  Watched hidden(kHeld), shown(kHeld), single(kHeld), missed(1.0), followed(1.0);
  // A free body, on a predicted path: in the middle of a window a peak counts, not at its end, unless the means show it.
  Watched within(1.0), at_end(1.0), of_means(1.0);
  within.window(peak(12.0, 10));
  EXPECT_TRUE(last_warns(within));
  Told end = peak(12.0, 10);
  end.peak.step = 10;
  for (int k = 0; k < 3; ++k) at_end.window({10.0});
  at_end.window(end);
  for (int k = 0; k < 3; ++k) at_end.window({10.0});
  EXPECT_FALSE(last_warns(at_end));
  EXPECT_DOUBLE_EQ(at_end.watch.peak().force, 12.0);
  for (const double force : {0.0, 9.0, 9.0, 3.0, 0.0})
    of_means.window({force});  // of a parabola, 10 N between two windows
  EXPECT_TRUE(last_warns(of_means));
  hidden.window(peak(12.0, 10));
  hidden.window({10.5});
  EXPECT_DOUBLE_EQ(hidden.watch.peak().force, 12.0);
  EXPECT_DOUBLE_EQ(hidden.watch.peak().time, 0.5 * kH);
  EXPECT_TRUE(last_warns(hidden, "`every 2`")) << "14 % above the largest mean";
  shown.window(peak(12.0, 10));
  shown.window({11.5});
  EXPECT_FALSE(last_warns(shown)) << "4.3 % above it";
  single.window(peak(12.0, 1));
  EXPECT_FALSE(last_warns(single));
  for (Watched* body : {&missed, &followed}) {
    body->force_error = body == &missed ? 1.0 : 0.1;
    for (int k = 0; k < 5; ++k) body->window({10.0});
  }
  EXPECT_TRUE(last_warns(missed));
  EXPECT_FALSE(last_warns(followed));
}

TEST(CouplingWatch, TellsABodyThatStartsInsideTheBedFromAHardImpact) {
  Watched inside(1.0);
  inside.overlap = 0.9;
  inside.window({});
  EXPECT_TRUE(inside.warns(code::kStartsInBed));
  Watched impact(1.0);
  impact.window({});
  impact.overlap = 0.9;
  impact.window({});
  EXPECT_TRUE(impact.warns(code::kLargeOverlap));
  // 18 mm into a grain of 2 cm in the first millisecond, which a body at 20 m/s comes in that time.
  for (const double speed : {20.0, 0.2}) {
    Watched first(1.0);
    first.grain_mass = 0.087;
    first.overlap = 0.9;
    first.speed = speed;
    first.window({});
    EXPECT_EQ(first.warns(code::kLargeOverlap), speed > 1.0);
    EXPECT_EQ(first.warns(code::kStartsInBed), speed < 1.0);
  }
}

using Eigen::Vector3d;

// Solves for accelerations are good to this.
constexpr double kRoundOff = 1e-9;

constexpr double kPlate = 3.0, kInertia = 0.02;  // [kg], [kg m2]
const std::string kFree = R"(end_time = 1.0
gravity = [0, 0, -9.81]
[[bodies]]
name = "plate"
mass = 3.0
inertia = [0.02, 0.02, 0.02]
position = [1, 0, 0]
)";
std::string joined_by(const std::string& type, const std::string& more = "") {
  return kFree + "[[joints]]\nname = \"joint\"\nkind = \"" + type +
         "\"\nbodies = [\"ground\", \"plate\"]\npoint = [0, 0, 0]\n" + more;
}

// Mass along a load on the plate, whose boundary reaches 0.5 m.
double mass(const std::string& scene, const Vector3d& F_W, const Vector3d& T_B = Vector3d::Zero()) {
  const Mechanism mechanism = build_mechanism(SceneText().read(scene));
  const Assembly assembly = assemble(mechanism.model);
  Equations equations(mechanism.model, assembly);
  Eigen::Matrix3Xd nodes(3, 2);
  nodes << 0.0, 0.5, 0.0, 0.0, 0.0, 0.0;
  ContactMass contact(equations, 0, ModalBoundary("plate", nodes, {}));
  Inputs inputs;
  inputs.loads.resize(1);
  inputs.loads[0].F_W = F_W;
  inputs.loads[0].T_B = T_B;
  return contact.along(inputs.loads[0], assembly.state, 1e-3);
}

TEST(ContactMass, OfAFreeBodyIsItsMass) {
  EXPECT_EQ(mass(kFree, Vector3d::Zero()), kPlate);
  EXPECT_NEAR(mass(kFree, Vector3d(0.1, -20.0, 3.0)), kPlate, kRoundOff);
}

TEST(ContactMass, OfAForceBesideTheCentreIsLess) {
  // 1/m = 1/m0 + d^2/J for a force at the distance d.
  EXPECT_NEAR(mass(kFree, Vector3d(0, 0, 5), Vector3d(0, -5 * 0.1, 0)), 1.0 / (1.0 / kPlate + 0.01 / kInertia),
              kRoundOff);
}

TEST(ContactMass, OfForcesThatCancelIsThatAtTheReach) {
  EXPECT_NEAR(mass(kFree, Vector3d(0, 0, 1e-9), Vector3d(0, 7, 0)), 1.0 / (1.0 / kPlate + 0.25 / kInertia), kRoundOff);
}

TEST(ContactMass, WhereAJointTakesTheLoadIsInfinite) {
  EXPECT_TRUE(std::isinf(mass(joined_by("fixed"), Vector3d(1, 2, 3), Vector3d(1, 0, 0))));
  const std::string slides = joined_by("prismatic", "axis = \"x\"\n");
  EXPECT_TRUE(std::isinf(mass(slides, Vector3d(0, 0, 4))));
  EXPECT_NEAR(mass(slides, Vector3d(4, 0, 0)), kPlate, kRoundOff);
  const std::string led = joined_by("prescribed",
                                    "axis = \"z\"\naxis2 = \"x\"\n[joints.motion]\nhold_other_rotations = true\n"
                                    "x = { polynomial = [0] }\ny = { polynomial = [0] }\n"
                                    "z = { amplitude = 0.1, frequency = 5 }\nrotation = { polynomial = [0] }\n");
  EXPECT_TRUE(std::isinf(mass(led, Vector3d(1, 2, 3))));
}

TEST(ContactMass, OnAnArmIsItsInertiaOverTheSquareOfTheArm) {
  // Hinged at the origin, 1 m from the mass centre: m = (J + m0 l^2) / l^2.
  EXPECT_NEAR(mass(joined_by("revolute", "axis = \"y\"\n"), Vector3d(0, 0, 2)), kPlate + kInertia, kRoundOff);
}

}  // namespace
}  // namespace footfall

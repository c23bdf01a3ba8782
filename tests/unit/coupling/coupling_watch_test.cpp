#include "mbd_solver/coupling/coupling_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

constexpr double kHeld = std::numeric_limits<double>::infinity();  // mass of a body that is held or led [kg]
constexpr double kH = 1e-3;                                        // [s]

struct Told {
  double force = 0.0, grains_work = 0.0, received = 0.0;  // [N], [J]
  double pending = 0.0;                                   // [J]
  std::int64_t contacts = 1;                              // at the window's end
  double mean_contacts = 1.0;
  bool last = false;
  double gravity = 0.0, kinetic = 0.0;  // [J]
};

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
    time_ += kH;
    watch.window({time_, kH, 10, told.last}, load, {{mass_, told.received, told.gravity, told.kinetic, told.pending}});
  }
  bool warns(const std::string& text) const {
    for (const std::string& warning : watch.warnings())
      if (warning.find(text) != std::string::npos) return true;
    return false;
  }
  double overlap = 0.0, patch = 0.0;
  CouplingWatch watch{{"plate"}, CouplingSpec{}};

 private:
  double mass_, time_ = 0.0;
};

TEST(CouplingWatch, JudgesByWhatTheContactsMove) {
  // 1 J goes to the grains; the body must not keep 0.1 J of it.
  for (const double excess : {0.09, 0.12}) {
    Watched body(1.0);
    const Told told{0.1, -1.0, excess - 1.0};
    if (excess < 0.1) {
      EXPECT_NO_THROW(body.window(told));
      EXPECT_TRUE(body.warns("has made"));
    } else {
      EXPECT_THROW(body.window(told), NumericalError);
    }
  }
}

TEST(CouplingWatch, DoesNotCountTheWeightOfABodyThatSwings) {
  // 10 J go to the contacts with 9 J of the weight: 1 J was exchanged, and 0.12 J of it are too much.
  Watched body(1.0);
  Told told{0.1, -10.0, -9.88};
  told.gravity = 9.0;
  EXPECT_THROW(body.window(told), NumericalError);
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
  EXPECT_TRUE(body.warns("has lost 0.2 J"));
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
  const std::string what = "began and ended within a window";
  Watched within(1.0);  // no contact at either end, some on the way
  within.window(flight);
  within.window({1.0, 0.0, 0.0, 0.0, 0, 0.3});
  within.window(end);
  EXPECT_TRUE(within.warns(what));

  Watched astride(1.0);  // of an end of windows
  astride.window({1.0, 0.0, 0.0, 0.0, 4, 4 * 0.3});
  astride.window({1.0, 0.0, 0.0, 0.0, 0, 4 * 0.4});
  astride.window(end);
  EXPECT_TRUE(astride.warns(what));

  Watched resolved(1.0);
  for (int k = 0; k < 10; ++k) resolved.window({1.0, 0.0, 0.0, 0.0, 4, 4.0});
  resolved.window({1.0, 0.0, 0.0, 0.0, 0, 4 * 0.4});
  resolved.window({0.01, 0.0, 0.0, 0.0, 0, 0.1});  // a grain that flies by
  resolved.window(end);
  EXPECT_FALSE(resolved.warns(what));
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
  EXPECT_EQ(body.watch.warnings().size(), 2U);
  EXPECT_TRUE(body.warns("pressed in by 6 %"));
  EXPECT_TRUE(body.warns("1.1 times the width"));
}

TEST(CouplingWatch, TellsABodyThatStartsInsideTheBedFromAHardImpact) {
  Watched inside(1.0);
  inside.overlap = 0.9;
  inside.window({});
  EXPECT_TRUE(inside.warns("a body starts inside the bed"));
  Watched impact(1.0);
  impact.window({});
  impact.overlap = 0.9;
  impact.window({});
  EXPECT_TRUE(impact.warns("soft grains soften the impact"));
}

}  // namespace
}  // namespace footfall

// Mechanisms with known answers, by both integrators, with tolerances as a scene has them: the figures of docs/validation.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>

#include "tests/physics/mechanisms.h"
#include "tests/physics/motion_of.h"
#include "tests/validation/famous_mechanisms.h"
#include "tests/validation/random_mechanism.h"

namespace footfall::test {
namespace checked {

struct Outcome {
  double error = 0.0;   // relative [-]
  double energy = 0.0;  // largest error of the energy balance [J]
  long steps = 0;
};
using Errs = std::function<Outcome(const std::string& integrator, double rtol)>;

// The run with rows every `interval`: motion at the end, its size and the largest error of the energy on the way.
struct Watched {
  Motion start, end;
  Size size;  // largest on the way: at its end a mechanism may be back where it began
  Outcome outcome;
};
Watched watch(const Model& model, const std::string& kind, double rtol, double interval, double t_end) {
  Run run(model, kind, as_a_scene(rtol)), observer(model);
  Watched out;
  out.start = motion_of(run);
  Rows rows;
  rows.next = [=](double time) { return interval * std::floor(time / interval + 1.0 + 1e-9); };
  rows.on_row = [&](const State& state, const Eigen::VectorXd&) {
    observer.state = state;
    out.outcome.energy = std::max(out.outcome.energy, std::abs(observer.imbalance()));
    const Size now = size_of(out.start, motion_of(observer));
    out.size = {std::max(out.size.path, now.path), std::max(out.size.speed, now.speed)};
    return true;
  };
  run.integrator->advance(run.state, t_end, run.inputs, rows);
  out.outcome.energy = std::max(out.outcome.energy, std::abs(run.imbalance()));
  out.end = motion_of(run);
  out.outcome.steps = run.integrator->statistics().steps;
  return out;
}

// Against the same mechanism at `reference_rtol` with `reference_kind`, which runs once.
Errs against_own_run(std::function<Model()> make, double interval, double t_end, const std::string& reference_kind,
                     double reference_rtol) {
  auto reference = std::make_shared<Watched>();
  return [=](const std::string& kind, double rtol) {
    const Model model = make();
    if (reference->end.empty()) *reference = watch(model, reference_kind, reference_rtol, interval, t_end);
    Watched found = watch(model, kind, rtol, interval, t_end);
    found.outcome.error = difference(found.end, reference->end, reference->size);
    return found.outcome;
  };
}

// Seven flat bodies of a few grams, ten hinges, one spring, a motor of 0.033 N m; the crank turns two and a half times in
// 0.03 s; nine of 50 conditions are redundant. All seven angles at the end, relative to the largest: digits of the Test Set
// for Initial Value Problem Solvers (Mazzia and Magherini, Bari), problem andrews.
Outcome squeezing(const std::string& kind, double rtol) {
  const Model model = squeezer();
  Run run(model, kind, as_a_scene(rtol));
  run.to(0.03);
  return {squeezer_error(run), std::abs(run.imbalance()), run.integrator->statistics().steps};
}

// Two rods of 5 kg on a shaft and a slider at 1 rad/s, stiff bushings for joints. Velocity of the first rod along y after
// 1 ms: the stored result of EXUDYN (J. Gerstmayr), TestModels/stiffFlyballGovernor.py.
Outcome governor(const std::string& kind, double rtol) {
  const Model model = flyball_governor();
  Run run(model, kind, as_a_scene(rtol));
  run.to(kGovernorEnd);
  return {std::abs(run.body(2).dr.y() / kGovernorSpeed - 1.0), std::abs(run.imbalance()),
          run.integrator->statistics().steps};
}

// A free body with 1, 2 and 3 kg m2 spins at 5 rad/s about the middle axis, off by 0.01 rad/s, and flips over and back in
// 10.05 s. Angular velocity after one exact period (Landau and Lifshitz, Mechanics, 37). Until the flip a small error grows.
Outcome flip(const std::string& kind, double rtol) {
  const FlippingBody nut = flipping_body();
  Run run(nut.model, kind, as_a_scene(rtol));
  const Eigen::Vector3d before = run.body(0).A.transpose() * run.body(0).w;
  run.to(nut.period);
  const Eigen::Vector3d after = run.body(0).A.transpose() * run.body(0).w;
  return {(after - before).norm() / before.norm(), std::abs(run.imbalance()), run.integrator->statistics().steps};
}

// A row of four-bars of rods of 1 m and 1 kg, pushed over at 1 m/s (IFToMM benchmark A02). Where the posts lie flat the
// conditions lose rank. Energy with rows every 10 and 33 ms, relative to the weight of all rods times 1 m.
Errs four_bars(int cells, double t_end) {
  return [=](const std::string& kind, double rtol) {
    Outcome worst;
    for (const double interval : {0.01, 0.033}) {
      const Outcome found = watch(n_four_bar(cells), kind, rtol, interval, t_end).outcome;
      worst.energy = std::max(worst.energy, found.energy);
      worst.steps += found.steps;
    }
    worst.error = worst.energy / (9.81 * (2 * cells + 1));
    return worst;
  };
}

// Seven rods of 1 kg, ten hinges, under gravity; twice the rhombus lies flat. Energy, relative to that at the start.
Outcome linkage(const std::string& kind, double rtol) {
  const Model model = peaucellier(1.0, -2.0);
  Outcome found = watch(model, kind, rtol, 0.01, 3.0).outcome;
  found.error = found.energy / Run(model).start_energy();
  return found;
}

// A beam of 10 m in eight flexible bodies is brought to 6 rad/s within 15 s (Simo and Vu-Quoc, J. Appl. Mech. 53 (1986),
// 855). Place of its tip at 20 s, relative to its length, against an own run at 1e-9.
Outcome spin_up(const std::string& kind, double rtol) {
  const Model model = spin_up_beam(8);
  static const Eigen::Vector2d reference = [&] {
    Run run(model, "one_step", as_a_scene(1e-9));
    run.to(20.0, 40);
    return spin_up_tip(run);
  }();
  Run run(model, kind, as_a_scene(rtol));
  run.to(20.0, 40);
  const Eigen::Vector2d tip = spin_up_tip(run);
  return {(tip - reference).norm() / 10.0, std::abs(run.imbalance()), run.integrator->statistics().steps};
}

// A disc of 8 kg on a light shaft of 0.6 m in two bearings (Jeffcott), plucked while it spins at 0, 100 and 400 rad/s.
// Frequency of the whirl over ten periods against sqrt(48 EI / (L^3 m)): it must not depend on the spin.
Outcome rotor(const std::string& kind, double rtol) {
  Outcome worst;
  const double exact = jeffcott_frequency(), tick = 2.0 * M_PI / exact / 200.0;
  for (const double speed : {0.0, 100.0, 400.0}) {
    const Model model = jeffcott_rotor(speed);
    Run run(model, kind, as_a_scene(rtol));
    int zeros = 0;
    double first = 0.0, last = 0.0, before = 0.0;
    for (int i = 1; zeros < 21 && i < 5000; ++i) {
      const double t = run.state.time;
      run.to(i * tick);
      const double now = disc_height(run);
      if (i > 1 && before * now < 0.0) {
        last = t + tick * before / (before - now);
        if (zeros++ == 0) first = last;
      }
      before = now;
    }
    worst.error = std::max(worst.error, std::abs(M_PI * (zeros - 1) / (last - first) / exact - 1.0));
    worst.energy = std::max(worst.energy, std::abs(run.imbalance()));
    worst.steps += run.integrator->statistics().steps;
  }
  return worst;
}

Errs flat_loop(Family family, unsigned seed) {
  return against_own_run([=] { return build(random_mechanism(family, seed)); }, 0.01, 0.5, "one_step", 1e-8);
}

struct Case {
  const char* name;
  Errs run;
  double error = 100.0;  // largest over tolerance, at 1e-6 [-]
  double energy = 0.1;   // largest [J]
};
void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class CheckedMechanism : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    Of, CheckedMechanism,
    testing::Values(Case{"AndrewsSqueezer", squeezing}, Case{"FlyballGovernor", governor},
                    Case{"DzhanibekovsNut", flip, 1e5},
                    // Five rods along the edges of a cube, six hinges, 10 s (IFToMM benchmark A03).
                    Case{"Bricard", against_own_run(
                                        [] {
                                          return bricard(
                                              0.01, [] { return 0.0; }, [] { return false; });
                                        },
                                        0.05, 10.0, "one_step", 1e-11)},
                    Case{"Bennett", against_own_run([] { return bennett(); }, 0.05, 5.0, "one_step", 1e-11)},
                    Case{"FourBars2", four_bars(2, 10.0)}, Case{"Peaucellier", linkage},
                    Case{"FourBars6", four_bars(6, 3.0)}, Case{"FourBars40", four_bars(40, 3.0)},
                    Case{"SarrusThroughFlat", flat_loop(Family::kOverclosed, 14)},
                    Case{"ParallelogramsThroughFlat", flat_loop(Family::kParallelogram, 21)},
                    Case{"SpinUpOfABeam", spin_up, 100.0, 1.0}, Case{"FlexibleRotor", rotor}),
    [](const auto& one) { return std::string(one.param.name); });

TEST_P(CheckedMechanism, EndsWithinItsBoundsByBothIntegrators) {
  for (const char* integrator : {"one_step", "ida"}) {
    const double rtol = 1e-6;
    const Outcome out = GetParam().run(integrator, rtol);
    std::printf("%-26s %-8s error %8.2g rtol, energy %8.1e J, %ld steps\n", GetParam().name, integrator,
                out.error / rtol, out.energy, out.steps);
    EXPECT_LT(out.error, GetParam().error * rtol) << integrator;
    EXPECT_LT(out.energy, GetParam().energy) << integrator;
  }
}

}  // namespace checked
}  // namespace footfall::test

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "tests/validation/checked_case.h"
#include "tests/validation/famous_mechanisms.h"
#include "tests/physics/mechanisms.h"
#include "tests/physics/motion_of.h"
#include "tests/validation/random_mechanism.h"

namespace footfall::test {
namespace {

const std::vector<double> kTolerances = {1e-4, 1e-6, 1e-8, 1e-10};

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
std::function<Outcome(const std::string&, double)> against_own_run(std::function<Model()> make, double interval,
                                                                   double t_end, const std::string& reference_kind,
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

CheckedCase squeezer_case() {
  CheckedCase out;
  out.name = "Andrews' squeezing mechanism";
  out.what =
      "Seven flat bodies of a few grams, ten hinges, one spring, driven by a motor of 0.033 N m. The crank turns two "
      "and a half times in 0.03 s. Nine of the 50 conditions are redundant.";
  out.compared = "All seven angles at t = 0.03 s, relative to the largest of them (15.8 rad).";
  out.source =
      "Digits of the Test Set for Initial Value Problem Solvers (Mazzia and Magherini, University of Bari), problem "
      "*andrews*; E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, VII.7.";
  out.tolerances = kTolerances;
  out.run = [](const std::string& kind, double rtol) {
    const Model model = squeezer();
    Run run(model, kind, as_a_scene(rtol));
    run.to(0.03);
    return Outcome{squeezer_error(run), std::abs(run.imbalance()), run.integrator->statistics().steps};
  };
  return out;
}

CheckedCase governor_case() {
  CheckedCase out;
  out.name = "Flyball governor";
  out.what =
      "A shaft, a slider and two rods of 5 kg at their ends turn at 1 rad/s. Stiff bushings stand in the place of "
      "joints, springs of 4 kN/m between the slider and the rods.";
  out.compared = "Velocity of the first rod along y after 1 ms, relative to itself.";
  out.source =
      "0.8962488779114738 m/s: the stored result of EXUDYN (J. Gerstmayr), TestModels/stiffFlyballGovernor.py, an "
      "explicit Runge-Kutta method with 20 steps.";
  out.tolerances = kTolerances;
  out.run = [](const std::string& kind, double rtol) {
    const Model model = flyball_governor();
    Run run(model, kind, as_a_scene(rtol));
    run.to(kGovernorEnd);
    return Outcome{std::abs(run.body(2).dr.y() / kGovernorSpeed - 1.0), std::abs(run.imbalance()),
                   run.integrator->statistics().steps};
  };
  return out;
}

CheckedCase flip_case() {
  CheckedCase out;
  out.name = "Dzhanibekov's nut";
  out.what =
      "A free body with moments of inertia of 1, 2 and 3 kg m2 spins at 5 rad/s about the middle axis, off by 0.01 "
      "rad/s. It flips over and back once in 10.05 s.";
  out.compared =
      "Angular velocity in the body after one whole period, relative to itself. The axis is unstable: until it flips a "
      "small error grows, and so does the error below.";
  out.source = "Exact period from the complete elliptic integral (Landau and Lifshitz, Mechanics, 37).";
  out.tolerances = kTolerances;
  out.why =
      "The unstable axis lets small errors grow until the flip: error over tolerance is about 1e4 below 1e-4, and "
      "each further digit of the tolerance is a further digit of the result.";
  out.held_one_step = out.held_ida = 1e5;
  out.run = [](const std::string& kind, double rtol) {
    const FlippingBody nut = flipping_body();
    Run run(nut.model, kind, as_a_scene(rtol));
    const Eigen::Vector3d before = run.body(0).A.transpose() * run.body(0).w;
    run.to(nut.period);
    const Eigen::Vector3d after = run.body(0).A.transpose() * run.body(0).w;
    return Outcome{(after - before).norm() / before.norm(), std::abs(run.imbalance()),
                   run.integrator->statistics().steps};
  };
  return out;
}

CheckedCase bricard_case() {
  CheckedCase out;
  out.name = "Bricard's mechanism";
  out.what =
      "Five rods of 1 m and 1 kg along the edges of a cube, six hinges, 10 s of falling and rising (IFToMM benchmark "
      "A03). It moves only because of its measures: one condition is redundant in every position.";
  out.compared = "All bodies at 10 s, relative to the size of the motion; energy at every 0.05 s.";
  out.source = "Own run of the one-step method at rtol 1e-11. The energy is its own reference.";
  out.tolerances = kTolerances;
  out.run = against_own_run(
      [] {
        return bricard(
            0.01, [] { return 0.0; }, [] { return false; });
      },
      0.05, 10.0, "one_step", 1e-11);
  return out;
}

CheckedCase bennett_case() {
  CheckedCase out;
  out.name = "Bennett's mechanism";
  out.what =
      "Four hinges out of parallel, three rods and the ground, 5 s. Three of the 20 conditions are redundant in "
      "every position, and no 17 of them are enough in all positions.";
  out.compared = "All bodies at 5 s, relative to the size of the motion; energy at every 0.05 s.";
  out.source = "Own run of the one-step method at rtol 1e-11. The energy is its own reference.";
  out.tolerances = kTolerances;
  out.run = against_own_run([] { return bennett(); }, 0.05, 5.0, "one_step", 1e-11);
  return out;
}

CheckedCase four_bar_case(int cells, double t_end) {
  CheckedCase out;
  out.name = "N-four-bar, N = " + std::to_string(cells);
  out.what = "A row of " + std::to_string(cells) +
             " four-bars of rods of 1 m and 1 kg, pushed over at 1 m/s (IFToMM benchmark A02), " +
             std::to_string(static_cast<int>(t_end)) +
             " s. When the posts lie flat it could change its branch, and its conditions lose rank.";
  out.compared = "Energy with rows every 10 ms and every 33 ms, relative to the weight of all rods times 1 m.";
  out.source = "The energy; the benchmark asks for less than 0.1 J at N = 2 over 10 s.";
  out.tolerances = {1e-4, 1e-6, 1e-7, 1e-8};
  if (cells > 2) out.tolerances = {1e-4, 1e-6, 1e-8};
  if (cells > 6) out.tolerances = {1e-6, 1e-7};
  out.in_short = false;
  const double scale = 9.81 * (2 * cells + 1);
  out.run = [=](const std::string& kind, double rtol) {
    Outcome worst;
    for (const double interval : {0.01, 0.033}) {
      const Outcome found = watch(n_four_bar(cells), kind, rtol, interval, t_end).outcome;
      worst.energy = std::max(worst.energy, found.energy);
      worst.steps += found.steps;
    }
    worst.error = worst.energy / scale;
    return worst;
  };
  return out;
}

CheckedCase peaucellier_case() {
  CheckedCase out;
  out.name = "Peaucellier's linkage";
  out.what =
      "Seven rods of 1 kg, ten hinges, let go under gravity at 2 rad/s, 3 s. Twice the rhombus lies flat and two of "
      "its "
      "corners pass through each other: there it could change its branch.";
  out.compared = "Energy with rows every 10 ms, relative to that at the start (26 J).";
  out.source = "The energy.";
  out.tolerances = {1e-4, 1e-6, 1e-8, 1e-10};
  out.in_short = false;
  out.run = [](const std::string& kind, double rtol) {
    const Model model = peaucellier(1.0, -2.0);
    Outcome found = watch(model, kind, rtol, 0.01, 3.0).outcome;
    found.error = found.energy / Run(model).start_energy();
    return found;
  };
  return out;
}

CheckedCase singular_case(Family family, unsigned seed, const std::string& name, const std::string& what) {
  CheckedCase out;
  out.name = name;
  out.what = what;
  out.compared = "All bodies after 0.5 s, relative to the size of the motion; energy at every 0.01 s.";
  out.source = "Own run of the one-step method at rtol 1e-8.";
  out.tolerances = {1e-4, 1e-5, 1e-6, 1e-7};
  out.in_short = false;
  out.run = against_own_run([=] { return build(random_mechanism(family, seed)); }, 0.01, 0.5, "one_step", 1e-8);
  return out;
}

CheckedCase spin_up_case() {
  CheckedCase out;
  out.name = "Spin-up of a beam";
  out.what =
      "A beam of 10 m, EA = 28 MN, EI = 14 kN m2, 1.2 kg/m, is brought to 6 rad/s within 15 s, cut into eight "
      "flexible bodies: a linear floating frame has no centrifugal stiffening, eight of them have it between each "
      "other.";
  out.compared = "Place of the tip in the axes of the hub at 20 s, relative to the length of the beam.";
  out.source =
      "Own run of the one-step method at rtol 1e-9. Under the table the extension beside the exact one of a continuous "
      "beam, rho A w^2 L^3 / (3 EA); manoeuvre of J. C. Simo and L. Vu-Quoc, J. Appl. Mech. 53 (1986), 855.";
  out.tolerances = {1e-4, 1e-6};
  out.energy = 1.0;  // of 7.2 kJ
  out.in_short = false;
  out.run = [](const std::string& kind, double rtol) {
    const Model model = spin_up_beam(8);
    static const Eigen::Vector2d reference = [&] {
      Run run(model, "one_step", as_a_scene(1e-9));
      run.to(20.0, 40);
      return spin_up_tip(run);
    }();
    Run run(model, kind, as_a_scene(rtol));
    run.to(20.0, 40);
    const Eigen::Vector2d tip = spin_up_tip(run);
    char told[80];
    std::snprintf(told, sizeof told, "extension %.4e m, exact %.4e m (%+.2f %%).", tip.x(), kSpinUpExtension,
                  100.0 * (tip.x() / kSpinUpExtension - 1.0));
    return Outcome{(tip - reference).norm() / 10.0, std::abs(run.imbalance()), run.integrator->statistics().steps,
                   told};
  };
  return out;
}

CheckedCase rotor_case() {
  CheckedCase out;
  out.name = "Flexible rotor";
  out.what =
      "A disc of 8 kg in the middle of a light shaft of 0.6 m in two bearings (Jeffcott), plucked sideways while it "
      "spins at 0, 100 and 400 rad/s, below and above its critical speed of 212.5 rad/s.";
  out.compared = "Frequency of the whirl over ten periods, the worst of the three; it must not depend on the spin.";
  out.source =
      "Exact: sqrt(48 EI / (L^3 m)), m with 17/35 of the shaft. Tilting whirl, forward and backward, is held against "
      "the finite-element model by the unit test FlexibleRotor.";
  out.tolerances = kTolerances;
  out.run = [](const std::string& kind, double rtol) {
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
  };
  return out;
}

}  // namespace

std::vector<CheckedCase> checked_cases() {
  std::vector<CheckedCase> out = {squeezer_case(),    governor_case(),       flip_case(),
                                  bricard_case(),     bennett_case(),        four_bar_case(2, 10.0),
                                  peaucellier_case(), four_bar_case(6, 3.0), four_bar_case(40, 3.0)};
  out.push_back(
      singular_case(Family::kOverclosed, 14, "Sarrus' mechanism through its flat position",
                    "Six hinges, three and three parallel, lift a plate without turning it. It falls through the "
                    "position in which all plates lie flat."));
  out.push_back(singular_case(Family::kParallelogram, 21, "Three parallelograms through their flat position",
                              "A row as the N-four-bar, of random measures, with a strut, as its posts lie down."));
  out.back().why = "At tighter tolerances the steps of IDA shrink into the position (docs/theory.md, 2.4).";
  out.push_back(spin_up_case());
  out.push_back(rotor_case());
  return out;
}

}  // namespace footfall::test

// Ensembles of random mechanisms.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

#include "tests/physics/motion_of.h"
#include "tests/validation/random_mechanism.h"
#include "tests/validation/random_numbers.h"

namespace footfall {
namespace random_mechanisms {

// Three hundred random mechanisms, 25 of each family: what must hold for all of them. Every failure prints family and
// seed; random_mechanism(family, seed) makes the mechanism again.

using test::Family;
using test::Motion;
using test::Plan;

constexpr unsigned kSeeds = 25;  // per family
// Error over tolerance. Smooth forces; forces with kinks, which the error estimate sees less well.
constexpr double kSmooth = 100.0, kRough = 1000.0;

class RandomMechanisms : public ::testing::TestWithParam<Family> {
 protected:
  template <class Claim>
  void for_all(Claim claim) {
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
      const Plan plan = test::random_mechanism(GetParam(), seed);
      SCOPED_TRACE(plan.what);
      ASSERT_NO_THROW(claim(plan)) << plan.what;
    }
  }
};
INSTANTIATE_TEST_SUITE_P(All, RandomMechanisms, ::testing::ValuesIn(test::kFamilies),
                         [](const auto& family) { return std::string(test::name_of(family.param)); });

double tolerance(const Plan& plan, double rtol) { return (plan.rough ? kRough : kSmooth) * rtol; }

Motion end_of(const Plan& plan, const std::string& kind, const IntegratorOptions& options) {
  const Model model = test::build(plan);
  test::Run run(model, kind, options);
  run.to(plan.regular_until);
  return test::motion_of(run);
}

// The end at a tolerance far below those that are judged, and the size of the motion.
struct Reference {
  explicit Reference(const Plan& plan) : model(test::build(plan)), run(model, "one_step", test::as_a_scene(1e-10)) {
    const Motion start = test::motion_of(run);
    run.to(plan.regular_until);
    end = test::motion_of(run);
    size = test::size_of(start, end);
  }
  double error(const Motion& motion) const { return test::difference(motion, end, size); }

  Model model;
  test::Run run;
  Motion end;
  test::Size size;
};

TEST_P(RandomMechanisms, ErrorStaysNearTheToleranceAndFallsWithIt) {
  for_all([](const Plan& plan) {
    const Reference reference(plan);
    double wide = 0.0;
    for (const double rtol : {1e-4, 1e-6, 1e-8}) {
      const double error = reference.error(end_of(plan, "one_step", test::as_a_scene(rtol)));
      EXPECT_LT(error, tolerance(plan, rtol)) << "rtol " << rtol;
      if (rtol == 1e-4) wide = error;
      if (rtol == 1e-8 && !plan.rough) {
        EXPECT_LT(error, std::max(0.01 * wide, 10.0 * rtol));  // a lucky end at 1e-4 proves nothing
      }
    }
  });
}

TEST_P(RandomMechanisms, FixedStepsShowTheSecondOrder) {
  // Where steps resolve the motion (error below 1e-3) and the error is above what Newton leaves (1e-8).
  for_all([](const Plan& plan) {
    if (plan.rough) return;
    const Reference reference(plan);
    const auto error = [&](int order, int steps) {
      IntegratorOptions options = test::as_a_scene(1e-9);
      options.order = order;
      options.error_control = false;
      options.max_step = plan.regular_until / steps;
      return reference.error(end_of(plan, "one_step", options));
    };
    const double coarse = error(2, 200), fine = error(2, 400);
    if (coarse > 1e-3 || coarse < 1e-8) return;
    EXPECT_GT(std::log2(coarse / fine), 1.75);
    // The fifth order is nearer by far. Its own order is not asked for: most errors are at Newton's, and steep dampers
    // show an order of 2.7 to 3.3 at these steps.
    EXPECT_LT(error(5, 200), std::max(0.02 * fine, 1e-7));
  });
}

TEST_P(RandomMechanisms, ShorterStepsDoNoHarm) {
  // More steps must not add up to more error than one run at the tolerance has.
  for_all([](const Plan& plan) {
    const Reference reference(plan);
    const double rtol = 1e-6;
    const double free = reference.error(end_of(plan, "one_step", test::as_a_scene(rtol)));
    for (const int steps : {100, 400}) {
      IntegratorOptions options = test::as_a_scene(rtol);
      options.max_step = plan.regular_until / steps;
      const double error = reference.error(end_of(plan, "one_step", options));
      EXPECT_LT(error, plan.rough ? kRough * rtol : std::max(free, rtol)) << steps << " steps";
    }
  });
}

TEST_P(RandomMechanisms, ErrorOfIdaFallsWithTheStep) {
  // The mean over all mechanisms, to which each adds at least a thousandth of the tolerance. Where the limit is longer than
  // most steps it changes no more than their luck: no end is off by three times what it was.
  const double rtol = 1e-6;
  std::vector<double> logarithms(3, 0.0);
  for_all([&](const Plan& plan) {
    const Reference reference(plan);
    const double free = reference.error(end_of(plan, "ida", test::as_a_scene(rtol)));
    const std::vector<int> counts = {100, 400, 1600};
    for (std::size_t k = 0; k < counts.size(); ++k) {
      IntegratorOptions options = test::as_a_scene(rtol);
      options.max_step = plan.regular_until / counts[k];
      const double error = reference.error(end_of(plan, "ida", options));
      EXPECT_LT(error, 3.0 * std::max(free, rtol)) << counts[k] << " steps";
      logarithms[k] += std::log(std::max(error, 1e-3 * rtol));
    }
  });
  EXPECT_LT(logarithms[1], logarithms[0]);
  EXPECT_LT(logarithms[2], logarithms[1]);
}

// Mean of log10(error); each mechanism adds at least a thousandth of the tolerance.
struct MeanError {
  double sum = 0.0, number = 0.0;
  void add(double error, double rtol) {
    sum += std::log10(std::max(error, 1e-3 * rtol));
    number += 1.0;
  }
  double value() const { return sum / number; }
};

TEST_P(RandomMechanisms, ErrorOfBothIntegratorsFallsWithTheTolerance) {
  // The mean of a family, by a factor of four at least with each digit; at 1e-10 a step of IDA errs by a larger share of
  // the tolerance.
  const std::vector<double> tolerances = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10};
  std::vector<MeanError> one_step(tolerances.size()), ida(tolerances.size());
  for_all([&](const Plan& plan) {
    const Reference reference(plan);
    for (std::size_t k = 0; k < tolerances.size(); ++k) {
      const double rtol = tolerances[k];
      const double error = reference.error(end_of(plan, "ida", test::as_a_scene(rtol)));
      if (rtol >= 1e-8) {
        EXPECT_LT(error, kRough * rtol) << "ida, rtol " << rtol;
        one_step[k].add(reference.error(end_of(plan, "one_step", test::as_a_scene(rtol))), rtol);
      } else {
        // Both end at one place: none has an error that its tolerance does not lower.
        EXPECT_LT(error, 2e-7) << "ida, rtol " << rtol;
      }
      ida[k].add(error, rtol);
    }
  });
  const double digit = std::log10(4.0);
  for (std::size_t k = 1; k < tolerances.size(); ++k) {
    EXPECT_LT(ida[k].value(), ida[k - 1].value() - digit * (tolerances[k] < 1e-8 ? 1.3 : 1.0))
        << "ida, rtol " << tolerances[k];
    if (tolerances[k] >= 1e-8) {
      EXPECT_LT(one_step[k].value(), one_step[k - 1].value() - digit) << "one_step, rtol " << tolerances[k];
    }
  }
}

TEST(HalfTheTolerance, HasASmallerError) {
  // The mean over eight mechanisms of each family, with each halving from 1e-4 to 1e-8.
  constexpr int kHalvings = 13;
  for (const char* kind : {"one_step", "ida"}) {
    std::vector<MeanError> errors(kHalvings + 1);
    for (const Family family : test::kFamilies)
      for (unsigned seed = 1; seed <= 8; ++seed) {
        const Plan plan = test::random_mechanism(family, seed);
        const Reference reference(plan);
        double rtol = 1e-4;
        for (MeanError& error : errors) {
          error.add(reference.error(end_of(plan, kind, test::as_a_scene(rtol))), rtol);
          rtol /= 2.0;
        }
      }
    for (int k = 1; k <= kHalvings; ++k)
      EXPECT_LT(errors[static_cast<std::size_t>(k)].value(), errors[static_cast<std::size_t>(k - 1)].value())
          << kind << ", halving " << k;
  }
}

TEST_P(RandomMechanisms, BothIntegratorsAgree) {
  for_all([](const Plan& plan) {
    const Reference reference(plan);
    const double rtol = 1e-7;
    EXPECT_LT(reference.error(end_of(plan, "ida", test::as_a_scene(rtol))), kRough * rtol);
  });
}

// Momenta, and moment of momentum about the mass centre.
struct Momenta {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = linear;
};
Momenta momentum(const Plan& plan, const Motion& motion) {
  Momenta out;
  double mass = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double m = plan.bodies[i].mass;
    mass += m;
    centre += m * motion[i].r;
    out.linear += m * motion[i].dr;
    out.angular += m * motion[i].r.cross(motion[i].dr) +
                   motion[i].A * plan.bodies[i].inertia * motion[i].A.transpose() * motion[i].w;
  }
  out.angular -= (centre / mass).cross(out.linear);
  return out;
}

TEST_P(RandomMechanisms, KeepTheirEnergyAndTheirMomentum) {
  // Forces between bodies change neither momentum, gravity the linear one by m g t.
  for_all([](const Plan& plan) {
    const bool free = GetParam() == Family::kFreeTree || GetParam() == Family::kFreeLoop;
    for (const char* kind : {"one_step", "ida"}) {
      const double rtol = 1e-7;
      const Model model = test::build(plan);
      test::Run run(model, kind, test::as_a_scene(rtol));
      const Motion start = test::motion_of(run);
      run.to(plan.regular_until);
      const Motion end = test::motion_of(run);
      double mass = 0.0;
      for (const test::PlannedBody& body : plan.bodies) mass += body.mass;
      const double speed = test::size_of(start, end).speed, share = tolerance(plan, rtol);
      EXPECT_LT(std::abs(run.imbalance()), share * mass * speed * speed) << kind;
      if (!free) continue;
      const Momenta before = momentum(plan, start), after = momentum(plan, end);
      EXPECT_LT((after.linear - before.linear - mass * plan.regular_until * plan.gravity).norm(), share * mass * speed)
          << kind;
      EXPECT_LT((after.angular - before.angular).norm(), share * mass * speed) << kind;  // bodies of about 1 m
    }
  });
}

TEST_P(RandomMechanisms, DoNotMindWhereTheyStandAndHowTheyAreTurned) {
  for_all([](const Plan& plan) {
    const Reference reference(plan);
    test::Numbers numbers(7);
    const Eigen::Matrix3d R = numbers.axes();
    const Eigen::Vector3d d(3.0, -2.0, 5.0);
    const double rtol = 1e-7;
    Motion motion = end_of(test::moved(plan, R, d), "one_step", test::as_a_scene(rtol));
    for (test::BodyMotionAt& at : motion)
      at = {R.transpose() * (at.r - d), R.transpose() * at.dr, R.transpose() * at.w, R.transpose() * at.A};
    EXPECT_LT(reference.error(motion), tolerance(plan, rtol));
  });
}

TEST_P(RandomMechanisms, DoNotMindNamesAndOrder) {
  for_all([](const Plan& plan) {
    const Reference reference(plan);
    std::vector<int> order(plan.bodies.size());
    std::iota(order.rbegin(), order.rend(), 0);
    const double rtol = 1e-7;
    const Motion there = end_of(test::reordered(plan, order), "one_step", test::as_a_scene(rtol));
    Motion motion;
    for (const int i : order) motion.push_back(there[static_cast<std::size_t>(i)]);
    EXPECT_LT(reference.error(motion), tolerance(plan, rtol));
  });
}

TEST_P(RandomMechanisms, RowsOfOutputDoNotChangeTheMotion) {
  // The same steps with and without rows, to the bit where no condition is redundant; and each row is where a run is
  // that ends there.
  for_all([](const Plan& plan) {
    const double rtol = 1e-5, T = plan.regular_until;
    const Model model = test::build(plan);
    test::Run plain(model, "one_step", test::as_a_scene(rtol)), with_rows(model, "one_step", test::as_a_scene(rtol)),
        short_run(model, "one_step", test::as_a_scene(1e-9));
    const Motion start = test::motion_of(plain);
    plain.to(T);
    State row;
    Rows rows;
    rows.next = [&](double time) { return T / 50.0 * std::floor(time / T * 50.0 * (1.0 + 1e-12) + 1.0); };
    rows.on_row = [&](const State& state, const Eigen::VectorXd&) {
      if (state.time < 0.37 * T) row = state;
      return true;
    };
    with_rows.integrator->advance(with_rows.state, T, with_rows.inputs, rows);
    EXPECT_EQ(plain.integrator->statistics().steps, with_rows.integrator->statistics().steps);
    const Motion end = test::motion_of(plain);
    const test::Size size = test::size_of(start, end);
    // Projection of a row turns the combinations of redundant conditions that later steps start from.
    const double far = test::difference(test::motion_of(with_rows), end, size);
    EXPECT_LE(far, plain.assembly.redundant.empty() ? 0.0 : rtol);
    short_run.to(row.time);
    with_rows.state = row;
    EXPECT_LT(test::difference(test::motion_of(with_rows), test::motion_of(short_run), size), tolerance(plan, rtol));
  });
}

TEST_P(RandomMechanisms, DoNotMindHowTheirJointsAreWritten) {
  for_all([](const Plan& plan) {
    const Reference reference(plan);
    const double rtol = 1e-7;
    EXPECT_LT(reference.error(end_of(test::with_split_hinges(plan), "one_step", test::as_a_scene(rtol))),
              tolerance(plan, rtol))
        << "hinges as cylinders on planes";
    if (GetParam() != Family::kFourBar) return;
    Plan loose = plan;  // three conditions too many before, none now
    loose.joints[2].kind = test::JointKind::kSpherical;
    loose.joints[3].kind = test::JointKind::kCylindrical;
    EXPECT_LT(reference.error(end_of(loose, "one_step", test::as_a_scene(rtol))), tolerance(plan, rtol)) << "R-R-S-C";
  });
}

TEST_P(RandomMechanisms, AreTheSameWithTwoBodiesWeldedOrMerged) {
  for_all([](const Plan& plan) {
    const Eigen::Vector3d offset(0.2, -0.1, 0.3);
    const double mass = 0.7, rtol = 1e-7;
    const Plan merged = test::with_merged_passenger(plan, 0, mass, offset);
    const Motion welded = end_of(test::with_passenger(plan, 0, mass, offset), "one_step", test::as_a_scene(rtol));
    const Reference reference(merged);
    // From the mass centre of host and passenger to that of the host.
    const double share = mass / (plan.bodies[0].mass + mass);
    const Eigen::Matrix3d A = rotation_matrix(plan.bodies[0].state.L);
    Motion motion(welded.begin(), welded.end() - 1);
    const Eigen::Vector3d arm = motion[0].A * (A.transpose() * (share * offset));
    motion[0].r += arm;
    motion[0].dr += motion[0].w.cross(arm);
    EXPECT_LT(reference.error(motion), tolerance(plan, rtol));
  });
}

}  // namespace random_mechanisms
}  // namespace footfall

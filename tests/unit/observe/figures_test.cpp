// Peaks of a run for its summary, from samples made by hand.

#include "mbd_solver/observe/figures.h"

#include <gtest/gtest.h>

#include "tests/unit/observe/small_machine.h"

namespace footfall {
namespace {

using test::Bench;
using test::kSmallMachine;

TEST(FigureTaker, ObservesTheHeaviestBody) {
  Bench bench(kSmallMachine);
  EXPECT_EQ(FigureTaker(bench.subject()).body_name(), "cabin");
}

TEST(FigureTaker, KeepsTheDeepestDescentNotTheLast) {
  Bench bench(kSmallMachine);
  FigureTaker taker(bench.subject());
  const double start = bench.state.q(2);
  for (const double way : {0.0, 0.25, 0.5, 0.125}) {
    bench.state.q(2) = start - way;
    taker.take(bench.take());
  }
  EXPECT_DOUBLE_EQ(taker.figures().max_descent, 0.5);
}

// Against gravity, wherever that points.
TEST(FigureTaker, MeasuresDescentAgainstGravity) {
  Bench bench(kSmallMachine, {"gravity=[-1.62,0,0]"});
  FigureTaker taker(bench.subject());
  taker.take(bench.take());
  bench.state.q(0) -= 0.5;
  bench.state.q(2) -= 3.0;
  taker.take(bench.take());
  EXPECT_DOUBLE_EQ(taker.figures().max_descent, 0.5);
}

// Of the beam's surface, 0.02 m from its line, and the same that the contact force counts with.
TEST(FigureTaker, PenetrationIsThatOfTheContactOnThePlane) {
  for (const char* normal : {"[0,0,1]", "[0,-0.6,0.8]"}) {
    Bench bench(kSmallMachine, {"initial.clearance=0", std::string("ground.plane.normal=") + normal});
    FigureTaker taker(bench.subject());
    taker.take(bench.take());
    EXPECT_NEAR(taker.figures().max_penetration, 0.0, 1e-15);  // round-off of lengths below 1 m
    const int leg = bench.equations.layout().body_q[1];
    bench.state.q(leg + 2) -= 0.03;
    const Sample& sample = bench.take();
    taker.take(sample);
    const int force = bench.mechanism.planes[0];
    const auto& plane = static_cast<const RigidPlane&>(bench.mechanism.model.force(force));
    const double overlap = plane.largest_overlap(element_input(bench.subject(), sample, force));
    EXPECT_NEAR(taker.figures().max_penetration, overlap, 1e-15);
    EXPECT_NEAR(overlap, 0.03 * bench.scene.ground.plane->normal.z(), 1e-15);
  }
}

TEST(FigureTaker, ReferenceEnergyIsThatOfTheStartOrTheLargestKinetic) {
  Bench bench(kSmallMachine);
  FigureTaker taker(bench.subject());
  const double start = bench.take().energy.stored[Stored::kKinetic];
  taker.take(bench.take());
  EXPECT_DOUBLE_EQ(taker.figures().reference_energy, start);
  bench.state.v *= 0.5;
  taker.take(bench.take());
  EXPECT_DOUBLE_EQ(taker.figures().reference_energy, start);
  bench.state.v *= 4.0;
  taker.take(bench.take());
  EXPECT_NEAR(taker.figures().reference_energy, 4.0 * start, 1e-12 * start);
}

// Energy that appears from nowhere is told; energy that was dissipated, or came from grains or motions, is not. Both
// bodies have one velocity at the start: seen from there they have no kinetic energy, and a quarter of E when they have
// half of it.
TEST(FigureTaker, WarnsOfEnergyThatDoesNotClose) {
  Bench bench(kSmallMachine);
  FigureTaker taker(bench.subject());
  taker.take(bench.take());
  const double E = taker.figures().reference_energy;
  bench.state.v *= 0.5;
  bench.state.dissipated[Dissipation::kStop] = E;  // of which a quarter is left
  bench.state.supplied[Supply::kMotion] = 0.25 * E;
  taker.take(bench.take());
  EXPECT_LT(taker.figures().energy_balance_relative(), 1e-12);
  EXPECT_EQ(taker.balance_warning(), "");
  bench.state.dissipated[Dissipation::kStop] = 0.98 * E;
  taker.take(bench.take());
  // What flowed: to K' 0.25 E, to stops E and 0.02 E back, from the motion 0.25 E; half of the sum.
  EXPECT_NEAR(taker.figures().energy_flow, 0.76 * E, 1e-12 * E);
  EXPECT_NEAR(taker.figures().energy_balance_relative(), 0.02 / 0.76, 1e-12);
  EXPECT_NE(taker.balance_warning().find("does not close"), std::string::npos);
}

TEST(FigureTaker, KeepsTheLargestForceOnABodyAndTellsThePresentOneOnAll) {
  Bench bench(kSmallMachine);
  FigureTaker taker(bench.subject());
  bench.inputs.loads.resize(bench.scene.bodies.size());
  for (const double force : {40.0, 30.0}) {
    bench.inputs.loads[0].F_W = Eigen::Vector3d(0, 0, force);
    taker.take(bench.take());
  }
  EXPECT_DOUBLE_EQ(taker.figures().max_contact_force, 40.0);
  EXPECT_DOUBLE_EQ(taker.figures().contact_force, 30.0);
}

}  // namespace
}  // namespace footfall

// How a body carries a beam, and what contacts on the beam do to the body: partners in virtual work.
#include "liggghts_fix/beam_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/liggghts_fix/random_beams.h"

namespace footfall {
namespace {

using test::closest;
using test::random_chain;
using test::RandomBeams;

// Sum of force times velocity at the contact points = generalized force times generalized velocity, for any
// motion and modes, and for bodies whose nodal rotations are not known.
TEST(BeamMotion, ForcesAtContactPointsDoTheWorkThatTheBodyReceives) {
  for (const bool with_rotations : {true, false}) {
    RandomBeams random(with_rotations ? 2 : 3);
    const int nodes = 6, modes = 4;
    std::vector<BeamSegment> segments;
    for (int i = 1; i < nodes; ++i) segments.push_back({i - 1, i, 0.07, 0});
    const ModalBoundary boundary(
        "tine", Eigen::Matrix3Xd::Random(3, nodes), {}, segments, Eigen::MatrixXd::Random(3 * nodes, modes),
        with_rotations ? Eigen::MatrixXd(Eigen::MatrixXd::Random(3 * nodes, modes)) : Eigen::MatrixXd());
    BodyMotion motion(modes);
    motion.r = random.vector(1.0);
    motion.L = Eigen::Vector4d::Random().normalized();
    motion.a = Eigen::VectorXd::Random(modes);
    motion.dr = random.vector(1.0);
    motion.w = random.vector(1.0);
    motion.da = Eigen::VectorXd::Random(modes);
    BeamChain chain(boundary, 0);
    chain.follow(motion);

    BeamMotion beam(boundary, chain);
    beam.begin_step(motion);
    double expected = 0.0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // about Bo
    for (int i = 0; i < 30; ++i) {
      const BeamTouch touch = closest(chain, random.vector(2.0), 0.1);
      const Eigen::Vector3d f = random.vector(10.0);
      beam.add_force(touch, f, touch.arm().cross(f));
      expected += f.dot(beam.velocity(touch));
      moment += (touch.contact_point() - motion.r).cross(f);
    }
    GeneralizedForce Q(modes);
    beam.project(motion, Q);
    // terms of order 10, thirty of them
    EXPECT_NEAR(power(Q, motion), expected, 1e-12 * std::abs(expected) + 1e-11);
    EXPECT_TRUE(Q.T_W.isApprox(moment, 1e-13));
  }
}

// Nodes of a chain go with the body's boundary, no further than largest_travel() says; for a mere shift it
// says exactly how far.
TEST(BeamMotion, NodesFollowTheBodyAndTravelNoFurtherThanTheirBound) {
  RandomBeams random(5);
  const int nodes = 7, modes = 3;
  std::vector<BeamSegment> segments;
  for (int i = 2; i < nodes; ++i) segments.push_back({i - 1, i, 0.07, 4});  // node 0 is not of the chain
  const ModalBoundary boundary("tine", Eigen::Matrix3Xd::Random(3, nodes), {}, segments,
                               Eigen::MatrixXd::Random(3 * nodes, modes));
  BeamChain chain(boundary, 4);
  const auto motion_near = [&](const BodyMotion& other, double size) {
    BodyMotion motion = other;
    motion.r += random.vector(size);
    motion.L = turned(other.L, random.vector(size));
    for (int m = 0; m < modes; ++m) motion.a[m] += random.between(-size, size);
    return motion;
  };
  for (int k = 0; k < 200; ++k) {
    const BodyMotion from = motion_near(BodyMotion(modes), 1.0), to = motion_near(from, k % 2 == 0 ? 1.0 : 0.01);
    chain.follow(from);
    const Eigen::Matrix3Xd before = chain.x();
    chain.follow(to);
    for (int node = 0; node < chain.node_count(); ++node)
      EXPECT_NEAR((chain.x().col(node) - boundary.position(to, chain.boundary_point(node))).norm(), 0.0, 1e-14);
    const double travel = (chain.x() - before).colwise().norm().maxCoeff();
    EXPECT_LE(travel, chain.largest_travel(from, to));
    BodyMotion shifted = from;
    shifted.r += Eigen::Vector3d(0.3, 0.0, 0.4);
    EXPECT_DOUBLE_EQ(chain.largest_travel(from, shifted), 0.5);
  }
}

// The velocity of the contact point is the rate at which the material point there moves: against a small
// rotation of a rigid body.
TEST(BeamMotion, VelocityOfTheContactPointIsThatOfTheMaterial) {
  RandomBeams random(4);
  const ModalBoundary boundary = random_chain(random, 3);
  BodyMotion motion;
  motion.r = random.vector(1.0);
  motion.L = Eigen::Vector4d::Random().normalized();
  motion.dr = random.vector(1.0);
  motion.w = random.vector(3.0);
  BeamChain chain(boundary, 0);
  chain.follow(motion);
  const BeamTouch touch = closest(chain, motion.r + random.vector(0.5), 0.1);
  BeamMotion beam(boundary, chain);
  beam.begin_step(motion);
  const Eigen::Vector3d c_B = motion.rotation().transpose() * (touch.contact_point() - motion.r);
  const double h = 1e-5;  // central difference: error of order |w|^3 h^2 / 6 = 3e-9 here
  BodyMotion later = motion, earlier = motion;
  later.r += h * motion.dr;
  later.L = turned(motion.L, h * motion.w);
  earlier.r -= h * motion.dr;
  earlier.L = turned(motion.L, -h * motion.w);
  const Eigen::Vector3d difference =
      ((later.r + later.rotation() * c_B) - (earlier.r + earlier.rotation() * c_B)) / (2.0 * h);
  EXPECT_NEAR((beam.velocity(touch) - difference).norm(), 0.0, 1e-8);
}

}  // namespace
}  // namespace footfall

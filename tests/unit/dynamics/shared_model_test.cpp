// A model is constant: any number of Equations share one, in turn and on several threads, and each gives the bits that it gives
// alone.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/model/control/signal_blocks.h"
#include "tests/unit/dynamics/random_model.h"

namespace footfall {
namespace {

// Every joint and element, two bodies on one map of several tiles, and signals that read positions.
Model shared_model(test::Random& random) {
  Model model = test::everything(random);
  auto grid = std::make_shared<HeightGrid>();
  grid->columns = grid->rows = 401;
  grid->step = {0.05, 0.05};
  grid->first = {-10.0, -10.0};
  for (int j = 0; j < grid->rows; ++j)
    for (int i = 0; i < grid->columns; ++i) grid->heights.push_back(9.0 + 0.02 * std::sin(0.3 * i + 0.2 * j));
  TerrainParts parts;
  parts.map = grid;
  const auto terrain = std::make_shared<const Terrain>(std::move(parts));
  ContactLaw law;
  law.stiffness = 70.0;
  law.stick_time = 0.3;
  for (const int body : {0, 1}) {
    std::vector<ContactPoint> points;
    for (int k = 0; k < 5; ++k) points.push_back({test::random_marker(random, model, body), 0.02 * k});
    model.add_force(std::make_unique<TerrainContact>("map/" + std::to_string(body), points, law, terrain));
  }
  std::vector<SignalNode> nodes(2);
  for (int k = 0; k < 2; ++k) {
    nodes[k].name = std::string(1, static_cast<char>('a' + k));
    nodes[k].block = std::make_unique<LinearFilter>(LinearFilter::low_pass_2(3.0, 0.4, 0.0));
    nodes[k].inputs = {k == 0 ? "0.1 * x ^ 2" : "signal.a - sin(x)"};
    nodes[k].place = k;
  }
  std::vector<std::unique_ptr<Sensor>> sensors;
  sensors.push_back(std::make_unique<BodySensor>(1, [](const BodyKinematics& b) { return b.r.x() + b.dr.z(); }));
  model.set_signals(std::make_shared<const ContinuousSignals>(
      SignalChain(std::move(nodes)), std::vector<SignalSource>{{SignalSource::Kind::kSensor, 0}}, std::move(sensors)));
  return model;
}

// A state with its rates.
struct At {
  double t = 0.0;
  Eigen::VectorXd y, ydot;
};

struct Results {
  Eigen::VectorXd F, K;  // residual, entries of the Jacobian
  double stored = 0.0, dissipated = 0.0;
  bool operator==(const Results& other) const {
    return F == other.F && K == other.K && stored == other.stored && dissipated == other.dissipated;
  }
};

class SharedModel : public ::testing::Test {
 protected:
  SharedModel() {
    const Layout layout(model);
    for (int k = 0; k < 2; ++k) {
      At at;
      at.t = 0.2 + 0.3 * k;
      at.y.resize(layout.size());
      at.y << given.state.q, given.state.v, random.vector_x(layout.z_size, 0.05), random.vector_x(layout.row_count);
      at.y.head(layout.q_size) += random.vector_x(layout.q_size, 0.002);
      at.y.segment(layout.v0(), layout.v_size) += random.vector_x(layout.v_size, 0.3);
      at.ydot = random.vector_x(layout.size(), 3.0);
      places.push_back(at);
      Equations alone(model, given);
      expected.push_back(results(alone, k));
    }
  }
  Eigen::VectorXd residual(Equations& equations, int place) const {
    const At& at = places[place];
    Eigen::VectorXd F(at.y.size());
    equations.residual(at.t, at.y, at.ydot, inputs, F);
    return F;
  }
  Eigen::VectorXd jacobian(Equations& equations, int place) const {
    const At& at = places[place];
    const Eigen::SparseMatrix<double>& K = equations.jacobian().evaluate(at.t, at.y, at.ydot, 20.0, inputs);
    return Eigen::Map<const Eigen::VectorXd>(K.valuePtr(), K.nonZeros());
  }
  Results results(Equations& equations, int place) const {
    Results out{residual(equations, place), jacobian(equations, place)};
    EnergySample energy;
    equations.energy(places[place].t, places[place].y, inputs, energy);
    out.stored = energy.stored.total();
    out.dissipated = energy.power.total();
    return out;
  }

  test::Random random{4};
  const Model model = shared_model(random);
  const Assembly given = test::as_given(model);
  const Inputs inputs = test::random_inputs(random, model);
  std::vector<At> places;
  std::vector<Results> expected;  // of Equations that have seen no other state
};

TEST_F(SharedModel, GivesInTurnTheBitsOfEachAlone) {
  EXPECT_FALSE(expected[0] == expected[1]);
  Equations one(model, given), two(model, given);
  for (int round = 0; round < 4; ++round) {
    const int here = round % 2, there = 1 - here;
    EXPECT_EQ(residual(one, here), expected[here].F);
    EXPECT_EQ(residual(two, there), expected[there].F);
    EXPECT_EQ(jacobian(one, here), expected[here].K);
    EXPECT_EQ(jacobian(two, there), expected[there].K);
    EXPECT_TRUE(results(one, there) == expected[there]);
    EXPECT_TRUE(results(two, here) == expected[here]);
  }
}

TEST_F(SharedModel, GivesOnTwoThreadsTheBitsOfEachAlone) {
  constexpr int kRounds = 60;
  int wrong[2] = {0, 0};
  const auto work = [&](int side) {
    Equations mine(model, given);
    for (int round = 0; round < kRounds; ++round) {
      const int place = (round + side) % 2;
      if (!(results(mine, place) == expected[place])) ++wrong[side];
    }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  EXPECT_EQ(wrong[0], 0);
  EXPECT_EQ(wrong[1], 0);
}

// Two plates leave prints for each other in one Equations; the ground of another one is untouched until it recalls that memory.
TEST(SharedSoil, HasTheMemoryOfTheStateThatIsRecalled) {
  Model model({0.0, 0.0, -1.62});
  SinkageParameters sand;
  sand.density = 1500.0;
  sand.stiffness = 1e6;
  sand.exponent = 1.0;
  sand.friction = 0.5;
  sand.shear_length = 0.02;
  const std::shared_ptr<const SoilLaw> law = make_pressure_sinkage(sand, "");
  const auto ground = std::make_shared<const SoilGround>(0.5);
  std::vector<Handle<SoilContact>> plates;
  const Eigen::Vector3d at_B(0.05, 0.0, 0.0);  // of a plate: within its reach of the ground it looks below
  for (int k = 0; k < 2; ++k) {
    BodyState state;
    state.r = {0.3 * k, 0.0, 0.01};
    const std::string name = "plate_" + std::to_string(k);
    model.add_body(Body(name, 3.0, Eigen::Matrix3d::Identity()), state);
    SoilFacet facet;
    facet.marker = body_marker(k, model.body(k), at_B);
    facet.normal = {0.0, 0.0, -1.0};
    facet.area = 0.04;
    facet.start = state.r + at_B;
    plates.push_back(model.add_force(std::make_unique<SoilContact>(name, std::vector<SoilFacet>{facet}, false,
                                                                   SoilContact::Surface{}, law, ground, k == 0)));
  }
  const Assembly given = test::as_given(model);
  Equations one(model, given), two(model, given);
  const Inputs inputs;
  // The force along z on each plate at these places [N].
  const auto forces = [&](Equations& equations, State& state) -> Eigen::Vector2d {
    equations.load(state);
    Eigen::Vector2d out;
    for (int k = 0; k < 2; ++k) out[k] = plates[k].of(model).wrench(equations.element_input(k, state, inputs))[2];
    return out;
  };
  const auto carry = [&](Equations& equations, State& state, double x_0, double z_0, double x_1, double z_1) {
    state.q.segment<3>(0) << x_0, 0.0, z_0;
    state.q.segment<3>(7) << x_1, 0.0, z_1;
    equations.remember(inputs, state);
  };
  State pressed = given.state, fresh = given.state;
  carry(one, pressed, 0.0, -0.03, 0.3, 0.01);
  carry(one, pressed, 0.0, 0.01, 0.3, 0.01);    // it leaves its print
  carry(one, pressed, -2.0, 0.01, 0.0, 0.01);   // over which the other plate comes
  carry(one, pressed, -2.0, -0.01, 0.0, 0.01);  // and makes another one
  State there = pressed;
  there.q[9] = -0.02;  // the other plate, within the print
  fresh.q = there.q;
  const double untouched = forces(two, fresh)[1];
  EXPECT_GT(untouched, 100.0);
  EXPECT_EQ(forces(one, there)[1], 0.0);
  EXPECT_EQ(forces(two, fresh)[1], untouched);
  two.recall(there);
  EXPECT_EQ(forces(two, there), forces(one, there));
  two.recall(fresh);
  EXPECT_EQ(forces(two, fresh)[1], untouched);
  EXPECT_EQ(forces(one, there)[1], 0.0);
}

}  // namespace
}  // namespace footfall

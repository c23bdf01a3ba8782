// A soil without grains: what can be computed by hand, its memory, its energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/elements/soil_contact.h"
#include "tests/support/refused.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

constexpr double kExact = 1e-12;  // of a number that is computed by hand

RftParameters sand() {
  RftParameters p;
  p.density = 1600.0;
  p.inertia = 0.0;
  p.friction = 0.5;
  p.resistance = 8e5;
  p.surface_friction = 10.0;
  p.rebound = 1e-4;
  p.damping = 0.0;
  return p;
}

SinkageParameters loam() {
  SinkageParameters p;
  p.density = 1500.0;
  p.inertia = 0.0;
  p.cohesion = 1700.0;
  p.stiffness = 1.5e6;
  p.exponent = 0.7;
  p.friction = 0.55;
  p.shear_length = 0.02;
  p.rebound = 1e-4;
  p.damping = 0.0;
  return p;
}

// A facet on the way through the ground, which remembers at the end of every piece of it.
struct Way {
  explicit Way(std::unique_ptr<SoilLaw> of) : law(std::move(of)) {}
  // Straight to the place x, y, depth in `steps` pieces, at 1 m/s.
  SoilStress to(const Eigen::Vector3d& place, int steps = 1) {
    const Eigen::Vector3d from = at.place, way = place - from;
    at.velocity = way.normalized();
    for (int i = 1; i <= steps; ++i) {
      at.place = from + way * i / steps;
      law->remember(at, memory);
    }
    return now();
  }
  SoilStress now() const { return law->stress(at, memory, true, SoilLaw::With::kTraction); }

  std::unique_ptr<SoilLaw> law;
  SoilPoint at{{0.0, 0.0, -0.01}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
  SoilMemory memory;
};

// The share of its strength that elastic ground bears at this part of the rebound.
double borne(double x) { return x * x * (3.0 - 2.0 * x); }

// alpha of a level plate from the printed table: all of x_k are 1 straight down, so f_k is the sum of its column.
constexpr double kDown = 0.87504;
// Drawn along: x_2 = 1 alone, f_k = c_1 + c_3 + c_6 + c_12.
constexpr double kDragged = -0.04193, kLifted = 0.11029;
// An upright plate drawn along its normal: x_3 = 1 alone, f_k = c_1 + c_4 + c_7 + c_13; f_1 + f_2 along, f_3 down.
constexpr double kPushed = -0.19185, kHeaved = -0.07462;

TEST(SoilLaw, RftOfThePrintedTable) {
  const Eigen::Vector3d down = Eigen::Vector3d::UnitZ(), along = Eigen::Vector3d::UnitX();
  EXPECT_NEAR(rft_alpha(down, down).z(), -kDown, 5e-6);  // five printed digits
  EXPECT_NEAR(rft_alpha(down, along).x(), kDragged, 5e-6);
  EXPECT_NEAR(rft_alpha(down, along).z(), -kLifted, 5e-6);
  EXPECT_GT(rft_alpha(down, -down).z(), 0.0) << "a plate that is pulled out is held back";
  // Symmetry, of which the published fit keeps what its five digits can: an upright plate has no force sideways.
  EXPECT_NEAR(rft_alpha(along, down).x(), 0.0, 5e-3);
  EXPECT_NEAR(rft_alpha(along, along).y(), 0.0, kExact);
  EXPECT_NEAR(rft_alpha(along, along).x(), kPushed, 5e-6);
  EXPECT_NEAR(rft_alpha(along, along).z(), kHeaved, 5e-6);
  EXPECT_NEAR(rft_resistance(1500.0, 0.4, 9.81), 1500.0 * 9.81 * (894 * 0.064 - 386 * 0.16 + 89 * 0.4), 1e-6);
}

TEST(SoilLaw, PlatePressedFlat) {
  // p = xi z 0.875, and k z^n; with inertia lambda rho v^2 more.
  for (const double z : {0.005, 0.02, 0.1}) {
    Way rft(make_rft(sand(), "")), sinkage(make_pressure_sinkage(loam(), ""));
    EXPECT_NEAR(rft.to({0, 0, z}, 7).traction.z(), -8e5 * z * kDown, 1e-5 * 8e5 * z) << z;  // digits of kDown
    EXPECT_NEAR(sinkage.to({0, 0, z}, 7).traction.z(), -1.5e6 * std::pow(z, 0.7), kExact * 1.5e6) << z;
    EXPECT_EQ(sinkage.now().traction.x(), 0.0);
    RftParameters fast = sand();
    fast.inertia = 1.1;
    Way quick(make_rft(fast, ""));
    quick.to({0, 0, z});
    quick.at.velocity = {0.0, 0.0, 3.0};
    EXPECT_NEAR(quick.now().inertia.z(), -1.1 * 1600.0 * 9.0, kExact * 2e4);
  }
  // c v z_s tanh(z / z_s), and c v z where z_s is large.
  for (const double z_s : {0.02, 1e6}) {
    RftParameters coarse = sand();
    coarse.speed_resistance = 3e6;
    coarse.speed_depth = z_s;
    Way jammed(make_rft(coarse, ""));
    jammed.to({0, 0, 0.03});
    jammed.at.velocity = {0.0, 0.0, 2.0};
    EXPECT_NEAR(jammed.now().inertia.z(), -3e6 * 2.0 * z_s * std::tanh(0.03 / z_s), 1e-3 * 1.8e5) << z_s;
    jammed.at.velocity = {0.0, 0.0, 1e-6};
    EXPECT_NEAR(jammed.now().inertia.z(), 0.0, 3e6 * 0.03 * 1e-9);
    jammed.at.velocity = {0.0, 0.0, -1.0};
    EXPECT_EQ(jammed.now().inertia.z(), 0.0) << "it does not pull a level facet";
  }
  // Cohesion of the resistive law is the bearing capacity of Prandtl and Reissner: N_c = 30.14 at 30 degrees.
  RftParameters sticky = sand();
  sticky.friction = std::tan(kPi / 6.0);
  sticky.cohesion = 1000.0;
  Way held(make_rft(sticky, ""));
  EXPECT_NEAR(held.to({0, 0, 0.02}).traction.z() + 8e5 * 0.02 * kDown, -30.14e3, 5.0);
}

TEST(SoilLaw, PlateDrawnAtConstantDepth) {
  const double z = 0.03;
  Way rft(make_rft(sand(), ""));
  rft.to({0, 0, z});
  const SoilStress drawn = rft.to({0.05, 0, z}, 20);  // 500 elastic lengths: the direction has turned
  EXPECT_NEAR(drawn.traction.x(), 8e5 * z * kDragged, 1e-5 * 8e5 * z);
  EXPECT_NEAR(drawn.traction.z(), -8e5 * z * kLifted, 1e-5 * 8e5 * z);
  // A smooth plate has mu_s of that.
  RftParameters smooth = sand();
  smooth.surface_friction = 0.1;
  Way slides(make_rft(smooth, ""));
  slides.to({0, 0, z});
  const Eigen::Vector3d t = slides.to({0.05, 0, z}, 20).traction;
  EXPECT_NEAR(t.x() / t.z(), 0.1, 1e-9);
  // Cohesion bears with the square of the cosine between the normal and the way: all of it straight down, nothing along.
  RftParameters sticky = sand();
  sticky.friction = std::tan(kPi / 6.0);  // N_c = 30.14
  sticky.cohesion = 1000.0;
  Way held(make_rft(sticky, ""));
  held.to({0, 0, z});
  EXPECT_NEAR(held.to({0.05, 0, z}, 20).traction.z(), -8e5 * z * kLifted, 1e-5 * 8e5 * z);
  const double bare = -8e5 * (z + 0.05) * rft_alpha({0, 0, 1}, {std::sqrt(0.5), 0, std::sqrt(0.5)}).z();
  EXPECT_NEAR(held.to({0.1, 0, z + 0.05}, 500).traction.z(), -bare - 0.5 * 30.14e3, 20.0);
  // Janosi and Hanamoto, in one step as in many.
  for (const int steps : {1, 9}) {
    Way sinkage(make_pressure_sinkage(loam(), ""));
    sinkage.to({0, 0, z});
    for (const double j : {0.005, 0.02, 0.2}) {
      const double p = 1.5e6 * std::pow(z, 0.7), tau = (1700.0 + 0.55 * p) * (1.0 - std::exp(-j / 0.02));
      const SoilStress at = sinkage.to({0, -j, z}, steps);
      EXPECT_NEAR(at.traction.y(), tau, 1e-9 * tau) << j << " " << steps;
      EXPECT_NEAR(at.traction.z(), -p, kExact * p);
    }
  }
}

// A facet drawn at any speed is held by c + p tan(phi) at most, also where the ground is elastic and its sway is damped.
TEST(SoilLaw, ShearNeverExceedsItsLimit) {
  SinkageParameters p = loam();
  p.damping = 3.0;
  p.rebound = 1e-3;
  for (const auto& [speed, surface] : {std::pair{0.01, 0.9}, {0.2, 0.9}, {1.0, 0.9}, {0.2, 0.3}}) {
    p.surface_friction = surface;
    Way way(make_pressure_sinkage(p, ""));
    way.to({0, 0, 0.03}, 5);
    way.to({0.0, 0, 0.0294});
    way.to({0.5, 0, 0.0294}, 50);
    way.at.velocity = {speed, 0.0, 0.0};
    const SoilStress drawn = way.now();
    const double limit = -std::min(0.55, surface) * drawn.traction.z() + 1700.0 * borne(0.4);
    EXPECT_LE(drawn.traction.head<2>().norm(), limit * (1.0 + 1e-9)) << speed << ", " << surface;
    EXPECT_GE(drawn.traction.head<2>().norm(), 0.99 * limit) << speed << ", " << surface;
  }
}

// Slid lightly, pressed, moved back: what it gained lightly it must not give back under the load.
TEST(SoilLaw, APumpOfPressesAndSlidesGivesNoEnergy) {
  SinkageParameters p = loam();
  p.rebound = 5e-3;
  p.cohesion = 0.0;
  Way way(make_pressure_sinkage(p, ""));
  way.to({0, 0, 0.05}, 50);
  const double light = 0.05 - 0.00475, loaded = 0.05 - 0.0005;
  way.to({0, 0, light}, 50);
  double work = 0.0;  // of the ground on the facet in a cycle, per area [J/m2]
  for (int cycle = 0; cycle < 3; ++cycle) {
    work = 0.0;
    const double x = way.at.place.x() + 0.1;
    for (const Eigen::Vector3d& corner :
         {Eigen::Vector3d(x, 0, light), Eigen::Vector3d(x, 0, loaded), Eigen::Vector3d(x - 0.012, 0, loaded),
          Eigen::Vector3d(x - 0.012, 0, light)}) {
      constexpr int kSteps = 200;
      const Eigen::Vector3d from = way.at.place, piece = (corner - from) / kSteps;
      for (int i = 0; i < kSteps; ++i) {
        const Eigen::Vector3d before = way.now().traction;
        way.to(from + piece * (i + 1));
        work += 0.5 * (before + way.now().traction).dot(piece);
      }
    }
  }
  EXPECT_LT(work, 0.0);
}

TEST(SoilLaw, PlateLiftedAndSetDownAgainStandsInItsPrint) {
  for (const bool is_rft : {true, false}) {
    Way way(is_rft ? make_rft(sand(), "") : make_pressure_sinkage(loam(), ""));
    const double z = 0.03, e = 1e-4;
    const double p = -way.to({0, 0, z}, 5).traction.z();
    // Elastic within e below the print, on the way up as down: the same force at the same place.
    const auto virgin = [&](double depth) { return is_rft ? 8e5 * depth * kDown : 1.5e6 * std::pow(depth, 0.7); };
    EXPECT_NEAR(-way.to({0, 0, z - 0.25 * e}).traction.z(), borne(0.75) * virgin(z - 0.25 * e), 2e-5 * p);
    EXPECT_NEAR(-way.to({0, 0, z - 0.999 * e}).traction.z(), 0.0, 2e-4 * p);
    way.to({0, 0, -0.1});  // lifted; it never pulls
    way.to({0, 0, z - 1.2 * e}, 3);
    EXPECT_EQ(way.at.place.z() > way.memory.print, false) << "it does not touch its print yet";
    EXPECT_NEAR(-way.to({0, 0, z - 0.5 * e}).traction.z(), borne(0.5) * virgin(z - 0.5 * e), 2e-5 * p);
    EXPECT_NEAR(-way.to({0, 0, z}).traction.z(), p, 1e-9 * p);
    EXPECT_NEAR(-way.to({0, 0, z + 0.01}).traction.z(), virgin(z + 0.01), 2e-5 * p);
  }
}

TEST(SoilLaw, ElasticGroundIsDampedAndNeverStrongerThanItIs) {
  for (const bool is_rft : {true, false}) {
    RftParameters a = sand();
    SinkageParameters b = loam();
    a.damping = b.damping = 0.5;
    Way way(is_rft ? make_rft(a, "") : make_pressure_sinkage(b, ""));
    const double p = -way.to({0, 0, 0.03}, 5).traction.z();
    way.to({0, 0, 0.03 - 0.6e-4});
    const double rest = borne(0.4);  // 0.352
    const auto closing = [&](double v) { return 0.5 * v * (is_rft ? 1.0 + 1.0 / (v + 0.01) : 1.0); };
    const auto at_speed = [&](double v) {
      way.at.velocity = {0.0, 0.0, v};
      return -way.now().traction.z() / p;
    };
    EXPECT_NEAR(at_speed(-2.0), rest * std::exp(-closing(2.0) * (1.0 - rest)),
                2e-3);  // the depth is 0.06 mm less: 2e-3
    EXPECT_NEAR(at_speed(1.0), rest * (1.0 + closing(1.0)) / (1.0 + closing(1.0) * rest), 2e-3);
    EXPECT_NEAR(at_speed(1e6), 1.0, 3e-3);
    // Sideways it is damped at the rate of its strength, and not where it yields.
    way.at.velocity = {1.0, 0.0, 0.0};
    EXPECT_NEAR(way.now().traction.x() / p, -0.5 * rest * (1.0 - rest), 2e-3);
    way.at.place.z() = 0.03 + 1e-5;
    EXPECT_NEAR(way.now().traction.x(), 0.0, 1e-12 * p);
  }
}

// A plate of 400 N that is drawn at constant speed and free to sink: of the ground's rates only the way drawn counts. Elastic ground
// that gives back what it took throws it up for ever, at 10 to 30 mm/s most.
TEST(SoilLaw, APlateThatIsDrawnDoesNotHop) {
  const double mass = 40.0, area = 0.06, g = 9.81, step = 2e-5;
  for (const double speed : {0.005, 0.02, 0.04, 0.1}) {
    for (const double rebound : {1e-3, 3e-3}) {
      RftParameters p = sand();
      p.resistance = 1.6e6;
      p.rebound = rebound;
      p.damping = 3.0;
      Way way(make_rft(p, ""));
      way.at.place.setZero();
      double least = mass * g, most = mass * g, sunk = 0.0, v = 0.0;
      const double drawn = 0.06;
      const int steps = static_cast<int>(drawn / speed / step);
      for (int i = 0; i < steps; ++i) {
        way.at.velocity = {speed, 0.0, v};
        const double push = -area * (way.at.place.z() > way.memory.print ? way.now().traction.z() : 0.0);
        v += step * (g - push / mass);
        way.at.place += step * Eigen::Vector3d(speed, 0.0, v);
        if (i % 10 == 0) way.law->remember(way.at, way.memory);
        if (i < steps / 2) continue;
        least = std::min(least, push);
        most = std::max(most, push);
        sunk = way.at.place.z();
      }
      EXPECT_GT(least, 0.95 * mass * g) << speed << " " << rebound;
      EXPECT_LT(most, 1.05 * mass * g) << speed << " " << rebound;
      EXPECT_NEAR(sunk, 0.020, 0.002) << speed << " " << rebound;
    }
  }
}

TEST(SoilLaw, FacetWithoutSidesPassesFromOneToTheOther) {
  // A slanting plate that is drawn along itself, a little downwards or upwards: the stress has no jump where the sides change.
  Way way(make_rft(sand(), ""));
  way.to({0, 0, 0.03});
  way.to({0.05, 0, 0.03}, 20);
  const double p = -way.now().traction.z();
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (int i = 0; i <= 400; ++i) {
    const double tilt = 0.2 * (i - 200) / 200.0;
    way.at.normal = {std::sin(tilt), 0.0, std::cos(tilt)};
    const Eigen::Vector3d now = way.now().traction;
    if (i > 0) {
      EXPECT_LT((now - last).norm(), 0.05 * p) << tilt;
    }
    last = now;
  }
}

TEST(SoilLaw, SlopesAreThoseOfTheStress) {
  // Central differences of steps of 1e-6 of the rebound, 1 m/s and 1: their error is 1e-6 of the slopes.
  test::Random random(7);
  for (const bool is_rft : {true, false}) {
    RftParameters a = sand();
    SinkageParameters b = loam();
    a.rebound = b.rebound = 2e-3;
    a.damping = b.damping = 0.7;
    a.inertia = b.inertia = 1.2;
    a.cohesion = 800.0;
    a.surface_friction = 0.3;
    a.speed_resistance = b.speed_resistance = 2e5;
    a.speed_depth = b.speed_depth = 0.04;
    const std::unique_ptr<SoilLaw> law = is_rft ? make_rft(a, "") : make_pressure_sinkage(b, "");
    for (int k = 0; k < 60; ++k) {
      SoilMemory memory;
      memory.print = 0.03;
      memory.touches = k % 4 != 0;
      memory.shear = Eigen::Vector2d(random.vector().head<2>()) * (is_rft ? 5e-4 : 0.2);
      SoilPoint at;
      at.place = Eigen::Vector3d(0.0, 0.0, 0.0315) + 1e-3 * random.vector();
      at.normal = (random.vector() + Eigen::Vector3d(0.0, 0.0, 1.5)).normalized();
      at.velocity = random.vector();
      const bool two_sided = k % 2 == 0;
      const SoilStress exact = law->stress(at, memory, two_sided, SoilLaw::With::kSlope);
      const double size = (exact.traction + exact.inertia).norm();
      for (int i = 0; i < 9; ++i) {
        const double h = i < 3 ? 2e-9 : 1e-6;
        const auto moved = [&](double by) {
          SoilPoint near = at;
          (i < 3 ? near.place[i] : i < 6 ? near.normal[i - 3] : near.velocity[i - 6]) += by;
          const SoilStress stress = law->stress(near, memory, two_sided, SoilLaw::With::kTraction);
          return Eigen::Vector3d(stress.traction + stress.inertia);
        };
        const Eigen::Vector3d slope = (moved(h) - moved(-h)) / (2.0 * h);
        EXPECT_LT((slope - exact.slope.col(i)).norm(), 1e-4 * (slope.norm() + size)) << is_rft << " " << k << " " << i;
      }
    }
  }
}

// A square plate of four facets, 0.2 m wide, on the ground at z = 0.
struct Plate {
  explicit Plate(std::shared_ptr<const SoilLaw> law, double mass = 10.0, double height = 0.0, double slope = 0.0,
                 const Eigen::Vector3d& gravity = {0.0, 0.0, -1.62})
      : model(gravity) {
    BodyState start;
    const Eigen::Vector3d up(std::sin(slope), 0.0, std::cos(slope));
    start.L = quaternion_about(Eigen::Vector3d::UnitY(), slope);
    start.r = height * up;
    model.add_body(Body("plate", mass, 0.05 * mass * Eigen::Matrix3d::Identity()), start);
    std::vector<SoilFacet> facets(4);
    for (int k = 0; k < 4; ++k) {
      SoilFacet& facet = facets[static_cast<std::size_t>(k)];
      facet.marker.body = 0;
      facet.marker.s0 = {k % 2 == 0 ? 0.05 : -0.05, k < 2 ? 0.05 : -0.05, 0.0};
      facet.normal = -Eigen::Vector3d::UnitZ();
      facet.area = 0.01;
      facet.start = model.initial_position(facet.marker);
    }
    auto contact = std::make_unique<SoilContact>("soil", facets, false, SoilContact::Surface{{0, 0, 0}, up, nullptr},
                                                 std::move(law), std::make_shared<const SoilGround>(0.2), true);
    soil = contact.get();
    own.emplace(*soil);
    model.add_force(std::move(contact));
  }
  // The force along z of the plate at this place, which it is carried to straight.
  double carried_to(const Eigen::Vector3d& place) {
    const Layout layout(model);
    Kinematics kinematics(model);
    State state = test::as_given(model).state;
    state.q.head<3>() = place;
    state.v.head<3>() = 1e-3 * (place - last);
    kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
    last = place;
    const ElementInput in = own->with({kinematics.pair(0, kGround), state.z, Eigen::VectorXd()});
    const double force = soil->wrench(in)[2];
    soil->remember(in);
    return force;
  }
  Model model;
  const SoilContact* soil = nullptr;
  std::optional<test::OwnScratch> own;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
};

TEST(SoilContact, GroundKeepsPrintsWhereTheyAre) {
  Plate plate(make_rft(sand(), ""));
  EXPECT_TRUE(Equations(plate.model, test::as_given(plate.model)).has_memory());
  const double p = 0.04 * 8e5 * 0.02 * kDown;  // [N]
  plate.carried_to({0.0, 0.0, 0.01});
  EXPECT_NEAR(plate.carried_to({0.0, 0.0, -0.02}), p, 1e-4 * p);
  plate.carried_to({0.0, 0.0, 0.01});
  plate.carried_to({0.5, 0.0, 0.01});  // next to it the ground is untouched
  EXPECT_NEAR(plate.carried_to({0.5, 0.0, -0.01}), 0.5 * p, 1e-4 * p);
  plate.carried_to({0.5, 0.0, 0.01});
  plate.carried_to({0.0, 0.0, 0.01});  // back over the first print: nothing before its bottom
  EXPECT_EQ(plate.carried_to({0.0, 0.0, -0.01}), 0.0);
  EXPECT_NEAR(plate.carried_to({0.0, 0.0, -0.02}), p, 1e-4 * p);
  // High above the ground it leaves its print behind, too.
  plate.carried_to({0.0, 0.0, 1.0});
  plate.carried_to({0.8, 0.0, 1.0});
  EXPECT_NEAR(plate.carried_to({0.8, 0.0, -0.01}), 0.5 * p, 1e-4 * p);
  // What it remembers is a list of numbers.
  std::vector<double> memory, again;
  plate.soil->save_memory(**plate.own, memory);
  const double* from = memory.data();
  plate.soil->recall(from, **plate.own);
  EXPECT_EQ(from, memory.data() + memory.size());
  plate.soil->save_memory(**plate.own, again);
  EXPECT_EQ(memory, again);
  from = nullptr;
  plate.soil->recall(from, **plate.own);
  EXPECT_NEAR(plate.carried_to({0.0, 0.0, -0.01}), 0.5 * p, 1e-4 * p) << "the ground of the start";
}

TEST(SoilContact, PlateThatLeavesItsPrintInTheAirPushesTheGroundAside) {
  // Lifted by 5 mm out of a print of 50 mm and moved sideways without contact: the ground next to the print is not met at a depth of
  // 45 mm all at once. Set down there, the plate stays where it is.
  Plate plate(make_rft(sand(), ""));
  const double p = 0.04 * 8e5 * kDown;  // [N/m]
  plate.carried_to({0.0, 0.0, 0.01});
  plate.carried_to({0.0, 0.0, -0.05});
  plate.carried_to({0.0, 0.0, -0.045});
  for (int i = 1; i <= 30; ++i) EXPECT_EQ(plate.carried_to({0.01 * i, 0.0, -0.045}), 0.0) << i;
  EXPECT_NEAR(plate.carried_to({0.3, 0.0, -0.05}), 0.05 * p, 1e-3 * p * 0.05);
}

// A face 0.05 m high and 0.2 m wide, in `rows` of elements, that is pushed along its normal with its lower edge at this depth.
double push_of_a_face(const RftParameters& law, int rows, double depth) {
  Model model(Eigen::Vector3d(0.0, 0.0, -9.81));
  BodyState start;
  start.r = {0.0, 0.0, 1e-9 - depth};
  model.add_body(Body("face", 1.0, Eigen::Matrix3d::Identity()), start);
  const double height = 0.05 / rows;
  std::vector<SoilFacet> facets;
  for (int i = 0; i <= rows; ++i) {
    SoilFacet facet;
    facet.marker.body = 0;
    facet.marker.s0 = {0.0, 0.0, i * height};
    facet.normal = Eigen::Vector3d::UnitX();
    facet.area = 0.2 * height * (i == 0 || i == rows ? 0.5 : 1.0);
    for (const double to : {-height, height})
      if (const double z = i * height + to; z > -1e-9 && z < 0.05 + 1e-9) facet.corners.push_back({0.0, 0.0, to});
    facets.push_back(facet);
  }
  for (SoilFacet& facet : facets) facet.start = Eigen::Vector3d(0.0, 0.0, 1.0);  // not in its print
  const SoilContact soil("soil", facets, false, SoilContact::Surface{}, make_rft(law, ""),
                         std::make_shared<const SoilGround>(0.2), true);
  const test::OwnScratch own(soil);
  const Layout layout(model);
  Kinematics kinematics(model);
  State state = test::as_given(model).state;
  state.v[0] = 1.0;
  double push = 0.0;
  for (const double x : {0.0, 0.01, 0.02}) {  // the first puts it into the ground, the second turns its way
    state.q[0] = x;
    kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
    const ElementInput in = own.with({kinematics.pair(0, kGround), state.z, Eigen::VectorXd()});
    push = -soil.wrench(in)[0];
    soil.remember(in);
  }
  return push;
}

// What the ground does to a face is what it does to the part that is in it, whatever the mesh.
TEST(SoilContact, AFaceCountsByWhatOfItIsInTheGround) {
  const RftParameters bare = sand();
  RftParameters sticky = bare;
  sticky.cohesion = 520.0;
  const double phi = std::atan(0.5),
               n_c = (std::exp(kPi * 0.5) * std::pow(std::tan(0.25 * kPi + 0.5 * phi), 2) - 1.0) / 0.5;
  for (const double depth : {0.00166, 0.02, 0.049}) {
    const double weight = 0.2 * 8e5 * -kPushed * depth * depth / 2.0, cohesion = 0.2 * 520.0 * n_c * depth;
    for (const int rows : {1, 2, 5, 10, 50, 500}) {
      const double height = 0.05 / rows, pushed = push_of_a_face(bare, rows, depth);
      EXPECT_NEAR(pushed, weight, 0.2 * 8e5 * -kPushed * height * height / 8.0 + 1e-3 * weight) << depth << " " << rows;
      const double more = push_of_a_face(sticky, rows, depth) - pushed;
      EXPECT_LT(more, 1.001 * cohesion) << depth << " " << rows;
      EXPECT_GT(more, std::max(0.499, 0.999 - 0.5 * height / depth) * cohesion) << depth << " " << rows;
    }
  }
}

class OnTheSoil : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, OnTheSoil, ::testing::Values("one_step", "ida"));

TEST_P(OnTheSoil, DroppedPlateStopsWhereItsEnergyIsSpent) {
  // m v^2/2 + m g z = A xi 0.875 z^2 / 2, less the start of the way, where the ground is elastic: of the order of e / z.
  RftParameters damped = sand();
  damped.damping = 20.0;  // its last swings on the elastic ground end soon
  Plate plate(make_rft(damped, ""), 10.0, 1e-6);
  const double v = 1.0, k = 0.04 * 8e5 * kDown, m = 10.0, g = 1.62;
  test::Run run(plate.model, GetParam(), test::tight(1e-8));
  run.state.v[2] = -v;
  run.to(0.6, 60);
  const double depth = (m * g + std::sqrt(m * m * g * g + k * m * v * v)) / k;
  double x = 0.5;  // of the rebound: the elastic ground bears the weight there
  for (int i = 0; i < 60; ++i) x = std::sqrt(m * g / (k * depth * (3.0 - 2.0 * x)));
  const double back = 1e-4 * (1.0 - x);
  EXPECT_NEAR(-run.body(0).r.z(), depth - back, 1e-3 * depth);
  EXPECT_LT(run.body(0).dr.norm(), 1e-3);
  // All is in the ledger: what the soil took is what was lost.
  const double lost = 0.5 * m * v * v + m * g * depth;
  EXPECT_NEAR(run.state.dissipated[Dissipation::kSoil], lost, 2e-3 * lost);
  EXPECT_LT(std::abs(run.imbalance() - 0.5 * m * v * v), 1e-4 * lost);
}

TEST_P(OnTheSoil, InertiaOfTheSoilHasItsOwnName) {
  RftParameters heavy = sand();
  heavy.inertia = 1.0;
  heavy.resistance = 1.0;  // nearly nothing else
  Plate plate(make_rft(heavy, ""), 10.0, 1e-6, 0.0, Eigen::Vector3d::Zero());
  test::Run run(plate.model, GetParam(), test::tight(1e-8));
  run.state.v[2] = -2.0;
  run.to(0.05, 5);
  // m v' = -A rho v^2: v = v_0 / (1 + A rho v_0 t / m). At first it acts over a tenth of the rebound.
  const double v = 2.0 / (1.0 + 0.04 * 1600.0 * 2.0 * 0.05 / 10.0);
  EXPECT_NEAR(-run.body(0).dr.z(), v, 1e-3 * v);
  EXPECT_NEAR(run.state.dissipated[Dissipation::kSoilInertia], 5.0 * (4.0 - v * v), 0.05);
}

TEST_P(OnTheSoil, PlateOnASlopeStands) {
  // 10 degrees ask for 0.176 of its weight: it slides until its print is deep enough, and stops. The ground bears it within the
  // elastic displacement e = 0.1 mm, in which it swings sideways, undamped: never farther than e to either side, and without drift.
  // Shear after Janosi and Hanamoto wears off by swings above a twentieth of K, so that law may creep, by less than K.
  for (const bool is_rft : {true, false}) {
    RftParameters a = sand();
    SinkageParameters b = loam();
    a.damping = b.damping = 20.0;
    b.shear_length = 5e-4;  // it sways in this by what bears the slope, 5e-5 m
    Plate plate(is_rft ? make_rft(a, "") : make_pressure_sinkage(b, ""), 10.0, 1e-6, 10.0 * kPi / 180.0);
    test::Run run(plate.model, GetParam());
    run.to(1.5, 10);
    const Eigen::Vector3d place = run.body(0).r;
    for (int i = 1; i <= 10; ++i) {
      run.to(1.5 + 0.3 * i, 6);
      EXPECT_LT((run.body(0).r - place).norm(), is_rft ? 2.0 * a.rebound : b.shear_length)
          << is_rft << " " << run.state.time;
    }
    EXPECT_LT(run.body(0).r.norm(), 5e-3) << is_rft;
  }
}

TEST_P(OnTheSoil, FirstContactOfAFastPadIsInTheLedger) {
  // A pad of a lander, at 4 m/s and a slant onto cohesive ground: everything happens within the rebound, in 0.3 ms. The work on the soil
  // has the accuracy of the motion, 1e-5 of the energy in each of the about twenty steps that see it begin.
  for (const bool is_rft : {true, false}) {
    RftParameters a = sand();
    SinkageParameters b = loam();
    a.rebound = b.rebound = 1e-3;
    a.damping = b.damping = 3.0;
    a.inertia = b.inertia = 1.0;
    a.cohesion = 520.0;
    a.friction = 0.9;
    Plate plate(is_rft ? make_rft(a, "") : make_pressure_sinkage(b, ""), 300.0, 3e-3);
    test::Run run(plate.model, GetParam());
    run.state.v[0] = 1.0;
    run.state.v[2] = -4.0;
    const double energy = 0.5 * 300.0 * 17.0;
    run.to(0.1, 100);
    EXPECT_GT(run.state.dissipated[Dissipation::kSoil], 0.5 * energy) << is_rft;
    EXPECT_LT(std::abs(run.imbalance() - energy), 1e-4 * energy) << is_rft;
  }
}

TEST(SoilLaw, RefusesImpossibleNumbers) {
  RftParameters none = sand();
  none.resistance = 0.0;
  EXPECT_THROW(make_rft(none, ""), InputError);
  none = sand();
  none.rebound = 0.0;
  EXPECT_THROW(make_rft(none, ""), InputError);
  SinkageParameters soft = loam();
  soft.shear_length = 0.0;
  EXPECT_THROW(make_pressure_sinkage(soft, ""), InputError);
}

}  // namespace
}  // namespace footfall

// The rigid lander of scene.toml in Simbody 3.7 (Debian libsimbody-dev), integrated by CPodes (BDF) or Runge-Kutta-Merson.
//   lander INTEGRATOR ACCURACY END ROWS [sampled]      INTEGRATOR: cpodes or merson; END [s]; ROWS: file of rows every 1 ms
// Prints steps, evaluations and the processor time of the integration [s], without what is made before it.

#include <Simbody.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

using namespace SimTK;

namespace {

const Real kRadius = 0.08, kStiffness = 5e7, kDamping = 0.5, kFriction = 0.3, kSlip = 0.01;
const Real kArea = 0.25 * Pi * 0.045 * 0.045, kPressure = 1e6, kVolume = 8e-4, kExponent = 1.1;
const Real kFullYield = 8278.72, kViscous = 3651.19, kSpeed = 0.02;

// Voltage of the dampers: constant, or a sine that is sampled at multiples of 1 ms and held between.
Real voltage = 0.2;
Real sampled_voltage(Real time) { return 0.2 + 0.1 * std::sin(300 * time); }

struct Leg {
  MobilizedBody::Universal outer;
  MobilizedBody::Slider rod;
  MobilizedBody::Ball pad;
};

// Gas and MR damper along the slider; q grows as the strut does.
class Strut : public Force::Custom::Implementation {
 public:
  explicit Strut(const MobilizedBody::Slider& rod) : rod_(rod) {}
  void calcForce(const State& s, Vector_<SpatialVec>&, Vector_<Vec3>&, Vector& mobility) const override {
    const Real stroke = -rod_.getLength(s), rate = -rod_.getRate(s);
    const Real force = kArea * kPressure * std::pow(kVolume / (kVolume - kArea * stroke), kExponent) +
                       voltage * kFullYield * std::tanh(rate / kSpeed) + kViscous * rate;
    rod_.applyOneMobilityForce(s, 0, force, mobility);
  }
  Real calcPotentialEnergy(const State&) const override { return 0; }

 private:
  const MobilizedBody::Slider& rod_;
};

// A ball on the plane z = 0: Hertz, Hunt-Crossley, smooth friction.
class PadContact : public Force::Custom::Implementation {
 public:
  explicit PadContact(const MobilizedBody& pad) : pad_(pad) {}
  void calcForce(const State& s, Vector_<SpatialVec>& bodies, Vector_<Vec3>&, Vector&) const override {
    const Real overlap = kRadius - pad_.getBodyOriginLocation(s)[2];
    if (overlap <= 0) return;
    const Vec3 n(0, 0, 1);
    const Vec3 velocity = pad_.getBodyOriginVelocity(s) - kRadius * cross(pad_.getBodyAngularVelocity(s), n);
    const Real closing = -velocity[2], u = kDamping * closing;
    const Real normal = kStiffness * overlap * std::sqrt(overlap) * (u >= 0 ? 1 + u : std::exp(u));
    const Vec3 slip = velocity + closing * n;
    const Vec3 force = normal * (n - kFriction / std::sqrt(slip.normSqr() + kSlip * kSlip) * slip);
    bodies[pad_.getMobilizedBodyIndex()] += SpatialVec(cross(-kRadius * n, force), force);
  }
  Real calcPotentialEnergy(const State&) const override { return 0; }

 private:
  const MobilizedBody& pad_;
};

Rotation axes(const Vec3& x, const Vec3& y) { return Rotation(UnitVec3(x), XAxis, y, YAxis); }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5 && argc != 6) {
    std::fprintf(stderr, "lander INTEGRATOR ACCURACY END ROWS [sampled]\n");
    return 2;
  }
  const std::string kind = argv[1];
  const bool sampled = argc == 6;
  if (sampled) voltage = sampled_voltage(0);
  const Real accuracy = std::atof(argv[2]), end = std::atof(argv[3]);

  MultibodySystem system;
  SimbodyMatterSubsystem matter(system);
  GeneralForceSubsystem forces(system);
  Force::UniformGravity gravity(forces, matter, Vec3(0, 0, -1.63));

  // Body frames have the axes of the ground in the drawing; their origins are the centres of mass.
  const Vec3 cabin_at(0, 0, 1.5);
  MobilizedBody::Free cabin(matter.Ground(), Body::Rigid(MassProperties(1000, Vec3(0), Inertia(450, 450, 540))));
  std::vector<std::unique_ptr<Leg>> legs;
  for (int k = 0; k < 4; ++k) {
    const Rotation turn(Pi / 4 + k * Pi / 2, ZAxis);
    const auto at = [&](Real x, Real y, Real z) { return turn * Vec3(x, y, z); };
    const Vec3 hip = at(1.0, 0, 1.35), ankle = at(1.75, 0, 0.08), tip = at(1.40680, 0, 0.66115);
    const Vec3 outer_at = at(1.2034, 0, 1.005575), rod_at = at(1.489415, 0, 0.52126);
    const Rotation at_hip = axes(at(0, 1, 0), at(1.27, 0, 0.75)), along = axes(at(0.75, 0, -1.27), at(0, 1, 0));
    legs.push_back(std::make_unique<Leg>());
    Leg& leg = *legs.back();
    leg.outer = MobilizedBody::Universal(cabin, Transform(at_hip, hip - cabin_at),
                                         Body::Rigid(MassProperties(12, Vec3(0), Inertia(0.5, 0.5, 0.5))),
                                         Transform(at_hip, hip - outer_at));
    leg.rod = MobilizedBody::Slider(leg.outer, Transform(along, hip - outer_at),
                                    Body::Rigid(MassProperties(8, Vec3(0), Inertia(0.4, 0.4, 0.4))),
                                    Transform(along, hip - rod_at));
    const Real pad_inertia = 0.4 * 8 * kRadius * kRadius;
    leg.pad = MobilizedBody::Ball(leg.rod, Transform(ankle - rod_at),
                                  Body::Rigid(MassProperties(8, Vec3(0), Inertia(pad_inertia))), Transform());
    Force::Custom(forces, new Strut(leg.rod));
    Force::Custom(forces, new PadContact(leg.pad));
    for (const Real side : {1.0, -1.0}) {
      const Vec3 root = at(0.85, 0.55 * side, 0.55);
      Force::TwoPointLinearSpring(forces, cabin, root - cabin_at, leg.outer, tip - outer_at, 1e6, (tip - root).norm());
      Force::TwoPointLinearDamper(forces, cabin, root - cabin_at, leg.outer, tip - outer_at, 8e3);
    }
  }
  State state = system.realizeTopology();
  cabin.setQToFitTransform(state, Transform(cabin_at + Vec3(0, 0, 0.005)));
  cabin.setUToFitLinearVelocity(state, Vec3(0.5, 0.2, -3.0));

  std::unique_ptr<Integrator> integrator;
  if (kind == "cpodes") {
    integrator = std::make_unique<CPodesIntegrator>(system, CPodes::BDF, CPodes::Newton);
  } else {
    integrator = std::make_unique<RungeKuttaMersonIntegrator>(system);
  }
  integrator->setAccuracy(accuracy);
  std::FILE* rows = std::fopen(argv[4], "w");
  if (!rows) return 2;
  std::fprintf(rows, "time,cabin.x,cabin.z,stroke.1,stroke.2,stroke.3,stroke.4\n");
  const std::clock_t begun = std::clock();
  integrator->initialize(state);
  const int count = static_cast<int>(end / 1e-3 + 0.5);
  for (int i = 0; i <= count; ++i) {
    while (integrator->getTime() < i * 1e-3 - 1e-12) integrator->stepTo(i * 1e-3);
    const State& now = integrator->getState();
    system.realize(now, Stage::Velocity);
    std::fprintf(rows, "%.9g,%.12g,%.12g", i * 1e-3, cabin.getBodyOriginLocation(now)[0],
                 cabin.getBodyOriginLocation(now)[2]);
    for (const auto& leg : legs) std::fprintf(rows, ",%.12g", -leg->rod.getLength(now));
    std::fprintf(rows, "\n");
    if (!sampled || i == 0 || i == count) continue;
    voltage = sampled_voltage(i * 1e-3);
    integrator->updAdvancedState().invalidateAllCacheAtOrAbove(Stage::Dynamics);
    integrator->reinitialize(Stage::Dynamics, false);
  }
  std::fclose(rows);
  std::printf("steps %d evaluations %d processor_s %.6f\n", integrator->getNumStepsTaken(),
              integrator->getNumRealizations(), static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
  return 0;
}

#include "tests/validation/random_forces.h"

#include <cmath>

#include "mbd_solver/model/elements/bushing.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/laws/friction.h"
#include "mbd_solver/model/laws/honeycomb.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/laws/table_law.h"

namespace footfall::test {
namespace {

using Laws = std::vector<std::unique_ptr<StrutLaw>>;

constexpr double kForce = 10.0;  // about the weight of a body [N]

// A law of kind 0 to 5 for a strut of this length; those from kFirstRough on have kinks.
constexpr int kLawKinds = 6, kFirstRough = 3;
std::unique_ptr<StrutLaw> law(int kind, double length, double share) {
  switch (kind) {
    case 0: {
      LinearSpringDamperParameters spring;
      spring.stiffness = 60.0 * share;
      spring.damping = 1.0 * share;
      spring.free_stroke = 0.1 * length;
      return std::make_unique<LinearSpringDamper>(spring);
    }
    case 1: {
      GasSpringParameters gas;
      gas.piston_diameter = 0.01;
      gas.initial_pressure = kForce * share / (0.25 * M_PI * 1e-4);
      gas.initial_volume = 0.25 * M_PI * 1e-4 * 1.5 * length;  // the stroke is below the length
      return std::make_unique<GasSpring>(gas);
    }
    case 2: {
      MrDamperParameters damper;
      damper.yield_force = kForce * share;
      damper.viscous_coefficient = 2.0;
      damper.regularisation_speed = 0.2;
      damper.coil_lag = 0.05;
      damper.initial_voltage = 0.5;
      return std::make_unique<MrDamper>(damper);
    }
    case 3: {
      EndStopParameters stop;
      stop.smallest_stroke = -0.1 * share;
      stop.largest_stroke = 0.1 * share;
      stop.stiffness = 2000.0;
      stop.dissipation = 0.2;
      stop.toe = 0.01;
      return std::make_unique<EndStop>(stop);
    }
    case 4: {
      HoneycombCartridge cartridge;
      cartridge.stages = {{0.5 * kForce, 0.05}, {kForce, 0.05}};
      cartridge.elastic_stiffness = 2000.0;
      cartridge.bottom_out_stiffness = 500.0;
      cartridge.transition_length = 0.02;
      cartridge.toe = 0.005;
      return std::make_unique<Honeycomb>(HoneycombParameters{cartridge, cartridge});
    }
    default: {
      TableLawParameters table;
      table.stroke = {-0.2, 0.0, 0.2};
      table.rate = {-1.0, 0.0, 1.0};
      table.force.resize(3, 3);
      table.force << -12.0, -6.0, -2.0, -4.0, 0.0, 4.0, 2.0, 6.0, 12.0;
      return std::make_unique<TableLaw>(table);
    }
  }
}

void add_strut(Plan& plan, Numbers& numbers, PlannedForce force) {
  const int first = numbers.one_in(4) ? numbers.whole(kFirstRough, kLawKinds - 1) : numbers.whole(0, kFirstRough - 1);
  const int second = numbers.one_in(2) ? 0 : -1;  // a spring next to it
  const double share = numbers.between(0.4, 1.2);
  plan.rough = plan.rough || first >= kFirstRough;
  force.make = [=](const std::string& name, const Marker& m1, const Marker& m2, double length) {
    Laws laws;
    laws.push_back(law(first, length, share));
    if (second >= 0) laws.push_back(law(second, length, share));
    return std::make_unique<Strut>(name, m1, m2, std::move(laws), length);
  };
  plan.forces.push_back(force);
}

void add_bushing(Plan& plan, Numbers& numbers, PlannedForce force) {
  Bushing::Parameters bushing;
  bushing.stiffness = Eigen::Vector3d::Constant(30.0) + numbers.vector(20.0);
  bushing.damping = Eigen::Vector3d::Constant(1.0) + numbers.vector(0.8);
  bushing.rotational_damping = Eigen::Vector3d::Constant(0.3) + numbers.vector(0.2);
  force.point_2 = force.point_1;
  force.make = [=](const std::string& name, const Marker& m1, const Marker& m2, double) {
    return std::make_unique<Bushing>(name, m1, m2, bushing);
  };
  plan.forces.push_back(force);
}

// About the axis of a hinge or cylinder, where there is one.
void add_torsion(Plan& plan, Numbers& numbers, PlannedForce force) {
  for (const PlannedJoint& joint : plan.joints) {
    if (joint.kind != JointKind::kRevolute && joint.kind != JointKind::kCylindrical) continue;
    force.body_1 = joint.body_1;
    force.body_2 = joint.body_2;
    force.point_1 = force.point_2 = joint.point_1;
    force.axes = joint.axes;
    LinearSpringDamperParameters spring;
    spring.stiffness = numbers.between(2.0, 10.0);
    spring.damping = numbers.between(0.0, 0.3);
    spring.free_stroke = numbers.between(-0.5, 0.5);
    force.make = [=](const std::string& name, const Marker& m1, const Marker& m2, double) {
      return torsional_spring(name, m1, m2, spring);
    };
    plan.forces.push_back(force);
    return;
  }
}

// A law on a coordinate of a joint; of its angle where it has both.
bool add_on_coordinate(Plan& plan, const PlannedJoint& joint, const std::string& name,
                       const std::function<std::unique_ptr<StrutLaw>()>& law) {
  const bool slides = joint.kind == JointKind::kPrismatic;
  if (!slides && joint.kind != JointKind::kRevolute && joint.kind != JointKind::kCylindrical) return false;
  const Coordinate coordinate = slides ? Coordinate::kDisplacement : Coordinate::kAngle;
  PlannedForce force;
  force.name = name;
  force.body_1 = joint.body_1;
  force.body_2 = joint.body_2;
  force.point_1 = force.point_2 = joint.point_1;
  force.axes = joint.axes;
  force.make = [=](const std::string& own_name, const Marker& m1, const Marker& m2, double) {
    Laws laws;
    laws.push_back(law());
    return std::make_unique<JointForce>(own_name, m1, m2, coordinate, std::move(laws));
  };
  plan.forces.push_back(force);
  return true;
}

MotorParameters random_motor(Numbers& numbers, int kind) {
  MotorParameters motor;
  motor.kind = kind == 0 ? MotorKind::kTorque : kind == 1 ? MotorKind::kSpeed : MotorKind::kPosition;
  motor.gear_ratio = numbers.between(1.0, 20.0);
  const double share = 1.0 / motor.gear_ratio;  // of the motor's torque in the joint's
  motor.command = kind == 0
                      ? sum({polynomial({2.0 * share * numbers.between(-1.0, 1.0)}), sine(2.0 * share, 2.0)})
                      : sum({polynomial({numbers.between(-0.5, 0.5), numbers.between(-1.0, 1.0)}), sine(0.3, 1.5)});
  if (kind == 0) return motor;
  motor.kp = share * numbers.between(1.0, 5.0);
  motor.ki = numbers.one_in(2) ? share * numbers.between(2.0, 10.0) : 0.0;
  if (kind == 2) motor.kd = share * numbers.between(0.1, 0.5);
  return motor;
}

}  // namespace

void add_random_drives(Plan& plan, Numbers& numbers) {
  int kind = numbers.whole(0, 2);
  for (const PlannedJoint& joint : plan.joints) {
    const MotorParameters motor = random_motor(numbers, kind);
    const double rotor = numbers.one_in(2) ? numbers.between(0.01, 0.3) : 0.0;
    if (!add_on_coordinate(plan, joint, "motor_" + joint.name, [=] { return std::make_unique<Motor>(motor); }))
      continue;
    kind = (kind + 1) % 3;
    if (rotor > 0.0)
      plan.rotors.push_back(
          {joint.name, joint.kind == JointKind::kPrismatic ? Coordinate::kDisplacement : Coordinate::kAngle, rotor});
  }
}

void add_random_limits(Plan& plan, Numbers& numbers) {
  plan.rough = true;
  int kind = numbers.whole(0, 3);
  for (const PlannedJoint& joint : plan.joints) {
    const double share = numbers.between(0.3, 1.0);
    MotorParameters motor = random_motor(numbers, numbers.whole(0, 2));
    motor.largest_torque = 2.0 * share / motor.gear_ratio;
    motor.no_load_speed = 5.0 * motor.gear_ratio;
    motor.efficiency = 0.8;
    const auto law = [=]() -> std::unique_ptr<StrutLaw> {
      switch (kind) {
        case 0: return std::make_unique<Motor>(motor);
        case 1: {
          JointFrictionParameters friction;
          friction.coulomb = share;
          friction.breakaway = 1.3 * share;
          friction.stribeck_speed = 0.1;
          friction.viscous = 0.05;
          friction.stick_displacement = 0.01;
          return std::make_unique<JointFriction>(friction);
        }
        case 2: {
          BrakeParameters brake;
          brake.command = sum({polynomial({0.4}), sine(0.8, 3.0)});
          brake.largest_force = 2.0 * share;
          brake.lag = 0.02;
          brake.stick_displacement = 0.01;
          return std::make_unique<Brake>(brake);
        }
        default: {
          EndStopParameters stop;
          stop.smallest_stroke = -0.2 * share;
          stop.largest_stroke = 0.1;
          stop.stiffness = 200.0;
          stop.dissipation = 0.3;
          stop.toe = 0.01;
          return std::make_unique<EndStop>(stop);
        }
      }
    };
    if (add_on_coordinate(plan, joint, "law_" + joint.name, law)) kind = (kind + 1) % 4;
  }
}

void add_random_forces(Plan& plan, Numbers& numbers, bool free) {
  const int bodies = static_cast<int>(plan.bodies.size()), count = numbers.whole(0, 3);
  for (int i = 0; i < count; ++i) {
    PlannedForce force;
    force.name = "force_" + std::to_string(i);
    force.body_2 = numbers.whole(0, bodies - 1);
    do force.body_1 = numbers.whole(free ? 0 : kGround, bodies - 1);
    while (force.body_1 == force.body_2);
    const Eigen::Vector3d centre = plan.bodies[static_cast<std::size_t>(force.body_2)].state.r;
    force.point_2 = centre + numbers.vector(0.2);
    force.point_1 =
        force.body_1 == kGround
            ? Eigen::Vector3d(centre + numbers.arrow(1.2, 2.0))
            : Eigen::Vector3d(plan.bodies[static_cast<std::size_t>(force.body_1)].state.r + numbers.vector(0.2));
    force.axes = numbers.axes();
    const int kind = numbers.whole(0, 3);
    if (kind == 0) {
      add_torsion(plan, numbers, force);
    } else if (kind == 1 || (force.point_2 - force.point_1).norm() < 0.3) {
      add_bushing(plan, numbers, force);  // two ends of a strut must not meet
    } else {
      add_strut(plan, numbers, force);
    }
  }
}

}  // namespace footfall::test

#pragma once
// Further mechanisms with published or exact answers, as in mechanisms.h.

#include <string>
#include <vector>

#include "mbd_solver/model/state.h"
#include "tests/unit/dynamics/run.h"

namespace footfall::test {

// Andrews' squeezing mechanism (Test Set for IVP Solvers; Hairer and Wanner, Solving ODEs II, VII.7): seven plane bodies,
// ten hinges, one spring, one motor. One degree of freedom, 50 conditions, nine too many.
Model squeezer();  // its motor, 0.033 N m, is a drive on the crank's hinge
// Largest error of the seven angles at t = 0.03 s, relative to the largest of them.
double squeezer_error(Run& run);

// Flyball governor on stiff bushings (EXUDYN, TestModels/stiffFlyballGovernor.py).
Model flyball_governor();
constexpr double kGovernorEnd = 1e-3;                  // [s]
constexpr double kGovernorSpeed = 0.8962488779114738;  // of the first rod along y [m/s]

// A free body with three different moments of inertia that spins nearly about the middle one.
struct FlippingBody {
  Model model;
  double period = 0.0;  // after which the angular velocity in the body is what it was [s]
};
FlippingBody flipping_body();

// A beam of 10 m that is brought to 6 rad/s within 15 s (Simo and Vu-Quoc 1986; Kane, Ryan and Banerjee 1987), cut into
// `parts` flexible bodies.
Model spin_up_beam(int parts);
Eigen::Vector2d spin_up_tip(Run& run);  // extension and lag of the tip in the axes of the hub [m]
constexpr double kSpinUpExtension = 1.2 * 36.0 * 1000.0 / (3.0 * 2.8e7);  // rho A w^2 L^3 / (3 E A) [m]

// A light shaft in two bearings with a disc in the middle (Jeffcott), spinning at `speed` [rad/s], plucked sideways.
Model jeffcott_rotor(double speed);
double jeffcott_frequency();   // sqrt(48 EI / (L^3 m)) [rad/s]
double disc_height(Run& run);  // of the disc's centre above the line of the bearings [m]

}  // namespace footfall::test

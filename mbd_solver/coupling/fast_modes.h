#pragma once
// The path that elastic modes take in the grains when a window is not short beside their period.

#include <Eigen/Core>

#include "coupler/body_motion.h"

namespace footfall {

// A mode of angular frequency Omega swings Omega H = theta within a window: a straight path at its present rate da
// leaves its true mean place by more than its amplitude, and the contacts' answer to that pumps energy, per window
//   |lambda|^2 = 1 + kappa (1 - cos theta - theta/2 sin theta),  kappa = contact stiffness over the mode's own.
// A path whose MEAN is that of the free swing about a_s, where the present loads hold the mode,
//   a_s     = a + dda / Omega^2
//   da_path = 2/H [(a_s - a)(1 - sin theta / theta) + da (1 - cos theta) / (Omega theta)]
// does no work to first order in kappa at any theta. It replaces da with weight theta^4 / (1 + theta^4), and takes dda
// away with it, so that slow modes keep the path of their scheme. The least damping (0.001) then outweighs what is
// left. theory 7.5.
//
// motion: the state at the window's start, its da and dda replaced; before: the same before any other change;
// stiffness: Omega^2 of each mode [1/s2]; H [s].
void slow_down_fast_modes(const BodyMotion& before, const Eigen::VectorXd& stiffness, double H, BodyMotion& motion);

}  // namespace footfall

#pragma once
// The scheme `tangent` on the multibody side: a path for the grains that does not overshoot on stiff contacts, and a
// load that reacts within the window. theory: coupling.

#include "coupler/messages.h"
#include "mbd_solver/coupling/predicted_window.h"
#include "mbd_solver/model/body.h"
#include "mbd_solver/model/external_load.h"

namespace footfall {

// Mean velocity [dr; w] over a window of H [s] of one body on contacts of the slopes that it had in the last window, by
// one L-stable second-order step of M d'' = M a - K d - C (d' - v), d(0) = 0, d'(0) = v; a: the acceleration that it
// has (so every other force stays what it is; bodies behind joints lend it no inertia). For omega H << 1 it is v + a
// H/2; for omega H >> 1 it leads to where the contacts balance, while v alone would drive the boundary through them.
Vector6d mean_velocity(const Body& body, const BodyMotion& motion, const ContactTangent& slope, double H);

// [F; T] = mean load - K (x - x_mean) - (C + D) (v - v_mean), means of the predicted path. K and C are the mean slopes
// of the window. Their change within it feeds or drains energy where omega H is large, so that D = H/2 w^6 / (1 + w^6)
// K, w = omega H / 2, damps what the window does not resolve: a damping ratio of w/2 for w >> 1, and of w^7/2 (no loss
// of order) for w << 1.
TangentLoad tangent_load(const ContactTangent& slope, const PredictedWindow& predicted, double omega_h, double H);

// Impulse [N s] that the body has felt in a window of H [s] beyond what the grains gave, because it moved otherwise
// than predicted: it is reaction to grains that stood where they were; grains that gave way never gave it. From the
// states at both ends of the window.
Eigen::Vector3d surplus_impulse(const TangentLoad& load, const BodyMotion& start, const BodyMotion& end, double H);

// Work [J] that the contacts would still do on the boundary from its predicted end to the computed motion: the grains
// do it only when the next window closes the gap, while the body has received it already. By the mean load and its
// slope:
double pending_work(const MeanLoad& mean, const ContactTangent& slope, const PredictedWindow& predicted,
                    const BodyMotion& computed);
// ... or by the mean loads of this window and of the one before, followed to the window's end. ratio: length of this
// window over that one.
double pending_work(const MeanLoad& mean, const MeanLoad& before, double ratio, const PredictedWindow& predicted,
                    const BodyMotion& computed);

}  // namespace footfall

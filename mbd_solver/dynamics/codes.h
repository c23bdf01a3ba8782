#pragma once
// Codes of the messages of dynamics/: E0340 to E0359, W1340 to W0359.

#include "coupler/base/errors.h"

namespace footfall::code {

// A joint is open in the initial position. Correct the positions of its bodies, its point or its axes.
inline constexpr MessageCode kJointGap{"E0340", "joint-gap"};
// Joints contradict each other. Move one of them, or free one of its directions.
inline constexpr MessageCode kJointsContradict{"E0341", "joints-contradict"};
// Masses connected by joints differ by more than 1e15. Make the light body heavier, or remove it.
inline constexpr MessageCode kMassRatio{"E0342", "mass-ratio"};
// A position, velocity or rate is no longer finite. Reduce rtol or max_step; check stiffnesses and masses.
inline constexpr MessageCode kNotFinite{"E0343", "not-finite"};
// The equations of motion are singular. Check that every body has a mass and that joints do not contradict each other.
inline constexpr MessageCode kSingular{"E0344", "singular"};
// A joint has opened during the run. Check masses, jammed positions and contradicting motions; then reduce rtol or max_step.
inline constexpr MessageCode kJointOpened{"E0345", "joint-opened"};
// Conditions of a joint follow from other joints: reactions are the smallest ones. No action is required.
inline constexpr MessageCode kRedundantConditions{"W1340", "redundant-conditions"};
// Joints were closed by moving bodies. Correct the reference configuration if the distance is not negligible.
inline constexpr MessageCode kJointsClosed{"W1341", "joints-closed"};
// Initial velocities were changed to fit the joints. Give velocities that fit.
inline constexpr MessageCode kVelocitiesChanged{"W1342", "velocities-changed"};
// A gear starts more than half a turn from zero. Count its angle from the nearest turn in laws and histories.
inline constexpr MessageCode kGearTurn{"W1343", "gear-turn"};

}  // namespace footfall::code

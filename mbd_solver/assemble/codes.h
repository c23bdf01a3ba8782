#pragma once
// Codes of the messages about building a mechanism from a scene: E0260 to E0279, E0350 to E0352, W1260 to W1279.

#include "coupler/base/errors.h"

namespace footfall::code {

// The model of another code weighs another mass than the scene states. Check that it is in m, kg and N.
inline constexpr MessageCode kModelMass{"E0260", "model-mass"};
// A plate has more finite elements than can be reduced in minutes. Use a coarser mesh.
inline constexpr MessageCode kTooManyElements{"E0261", "too-many-elements"};
// A body is on both sides of a wall at the start, so the wall cannot hold it. Move the body, or exclude it.
inline constexpr MessageCode kAcrossWall{"E0262", "across-wall"};
// A controller has another number of outputs than the scene names. Name as many.
inline constexpr MessageCode kOutputCount{"E0264", "output-count"};
// A continuous signal reads a value that exists at samples only. Give the signal a period.
inline constexpr MessageCode kNotContinuous{"E0265", "not-continuous"};
// The file of grains does not exist or cannot be read. Make the bed again.
inline constexpr MessageCode kNoGrainFile{"E0266", "no-grain-file"};
// The file of grains has a damaged line or no grains. Make the bed again.
inline constexpr MessageCode kGrainFile{"E0267", "grain-file"};
// initial.clearance needs the height of the ground under a boundary. Give grains, a surface height or a boundary above it.
inline constexpr MessageCode kNoGroundHeight{"E0268", "no-ground-height"};
// The model of another code has another mass centre or inertia than the scene states. Correct the scene, or the units of nodes.
inline constexpr MessageCode kModelInertia{"E0269", "model-inertia"};
// The folder of initial.from has no run that has ended, or its bodies differ. Run that scene, or correct the folder.
inline constexpr MessageCode kEndState{"E0263", "end-state"};
// Code of the user (an FMU) failed, crashed, did not answer in time, or its output is not finite. Correct the code or its inputs.
inline constexpr MessageCode kForeignFailed{"E0350", "foreign-failed"};
// Code of the user cannot save its state. Run without checkpoints, or let the code save its state.
inline constexpr MessageCode kForeignStateless{"E0351", "foreign-stateless"};
// The state of code of the user in a checkpoint is damaged. Resume from another checkpoint.
inline constexpr MessageCode kForeignState{"E0352", "foreign-state"};
// A tabulated controller differs from the exact one by this much. Use a finer grid if it matters.
inline constexpr MessageCode kTableDifference{"W1260", "table-difference"};
// A signal varies in time faster than its corners can be found, and steps may pass over parts of it. Shorten the run.
inline constexpr MessageCode kVariesTooFast{"W1261", "varies-too-fast"};
// The contact of two bodies, or of a body and a plane, throws them apart at the start. Move one of them.
inline constexpr MessageCode kThrownAtStart{"W1265", "thrown-at-start"};
// A flexible body bends by more than a tenth of its size under its own weight, where linear modes fail. Check its material.
inline constexpr MessageCode kBendsUnderWeight{"W1266", "bends-under-weight"};
// initial.from does not carry this over. No action is required if this is intended.
inline constexpr MessageCode kNotCarried{"W1267", "not-carried"};
// A pulley with grip holds a cable that would leave it. Remove grip, or place the pulley so that the cable stays on it.
inline constexpr MessageCode kGripWithoutWrap{"W1269", "grip-without-wrap"};

}  // namespace footfall::code

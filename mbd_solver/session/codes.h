#pragma once
// Codes of the messages of mbd_solver/session and python: E0660 to E0699, W1660 to W0699, E0720 to E0739.

#include "coupler/base/errors.h"

namespace footfall::code {

// ---- run ----

// The scene has changed since the run began. Resume with the original scene, or start a new run.
inline constexpr MessageCode kSceneChanged{"E0660", "scene-changed"};
// A file of a checkpoint cannot be read. Resume from another checkpoint, or start a new run.
inline constexpr MessageCode kCheckpointFile{"E0661", "checkpoint-file"};
// Another version of footfall wrote the checkpoint. Resume with that version, or start a new run.
inline constexpr MessageCode kCheckpointVersion{"E1662", "checkpoint-version"};
// The state of the mechanism is no longer finite. Reduce rtol or max_step; check stiffnesses and masses.
inline constexpr MessageCode kStateNotFinite{"E0663", "state-not-finite"};
// Events follow each other without end at one instant. Give each a condition that is false in the state it leads to.
inline constexpr MessageCode kEventLoop{"E0664", "event-loop"};
// The mechanism does not come to rest at the start. Support every body against gravity, or remove initial.settle.
inline constexpr MessageCode kNotSettled{"E0665", "not-settled"};
// Two surfaces without contact overlap. Add [[contacts]] between them, or ignore = true.
inline constexpr MessageCode kCollision{"E0666", "collision"};
// The scene needs LIGGGHTS, or must run without it. Use `footfall run`, which starts the right programs.
inline constexpr MessageCode kWrongPrograms{"E1667", "wrong-programs"};
// mbd_solver runs on more than one rank. Write `: -np 1 mbd_solver ...`.
inline constexpr MessageCode kSeveralRanks{"E1668", "several-ranks"};
// The run has no valid checkpoint. Start it again; set output.checkpoint_interval for more frequent checkpoints.
inline constexpr MessageCode kNoValidCheckpoint{"E0669", "no-valid-checkpoint"};
// Events of two states follow each other faster than the motion changes. Give their conditions a hysteresis or a period.
inline constexpr MessageCode kEventChatter{"E0670", "event-chatter"};

// The pads of [landing] span no area between which the lander could stand. Name at least three bodies or points.
inline constexpr MessageCode kLandingPads{"E0671", "landing-pads"};

// A requirement reads a name that no run of the scene has. Use a key of summary.json, or a recorded column with .max ... .final.
inline constexpr MessageCode kRequirementName{"E0672", "requirement-name"};

// The program that leads the run cannot be reached. Start it first, or unset FOOTFALL_LEADER.
inline constexpr MessageCode kLeaderGone{"E0673", "leader-gone"};

// Steps that end at corners of functions of time, or at samples, hardly advance the run. Remove points of the table, or lengthen the period.
inline constexpr MessageCode kWindowsTooShort{"E0674", "windows-too-short"};

// Two surfaces overlap at the start; collisions between them are not detected. Move them apart if this is not intended.
inline constexpr MessageCode kOverlapAtStart{"W1660", "overlap-at-start"};
// A body reaches through the floor or a side of [particles.box] at the start. Raise or move it, or enlarge the bed.
inline constexpr MessageCode kThroughBox{"W1670", "through-box"};
// The surface file of a boundary lies away from its body. Give its place, scale and orientation in D.
inline constexpr MessageCode kSurfaceAway{"W1671", "surface-away"};
// The mechanism was settled into static equilibrium before the run. Check the distance that is reported.
inline constexpr MessageCode kSettled{"W1661", "settled"};
// The energy of the mechanism is not balanced to 1 %. Reduce solver.rtol and solver.atol, or solver.max_step.
inline constexpr MessageCode kEnergyBalance{"W0662", "energy-balance"};
// A body without a boundary went through the ground, which holds it coarsely or not at all. Give it a boundary.
inline constexpr MessageCode kThroughGround{"W0676", "through-ground"};
// A body met the soil faster, or went deeper, than the numbers of the soil were fitted for. Fit them again for this range.
inline constexpr MessageCode kBeyondSoil{"W0675", "beyond-soil"};
// A flexible body spins or bends beyond the range of linear modes. Divide it into several bodies.
inline constexpr MessageCode kBeyondLinearRange{"W1663", "beyond-linear-range"};
// The stress of a flexible body exceeds the yield stress of its material; plasticity is not modelled. Strengthen it.
inline constexpr MessageCode kYields{"W1664", "yields"};
// A joint turned too fast in an integration step for its turns to be counted. Reduce solver.max_step.
inline constexpr MessageCode kTurnsNotCounted{"W1665", "turns-not-counted"};

// Joints change the damping ratio of a flexible body's lowest mode. Give the damping that the message computes, if that is meant.
inline constexpr MessageCode kAttachedDamping{"W1666", "attached-damping"};

// A requirement states another unit than the number that it reads has; nothing is converted. Convert the value, or state its unit.
inline constexpr MessageCode kRequirementUnit{"W1669", "requirement-unit"};

// A signal of another program (FMU, Python file) answers motion like a stiff spring: its period is too long. Shorten it, or use a spring of the scene.
inline constexpr MessageCode kSignalOmegaH{"W0668", "signal-omega-h"};

// A signal of kind "host" has no program that sets it in a run from the command line. Lead the scene from a program, or change its kind.
inline constexpr MessageCode kUnsetSignal{"W0667", "unset-signal"};

// ---- files of a run ----

// history.csv is damaged: units, names or rows do not agree. Repeat the run, or restore the file.
inline constexpr MessageCode kHistoryDamaged{"E0680", "history-damaged"};
// A column of history.csv does not exist. Choose one of those listed.
inline constexpr MessageCode kNoSuchColumn{"E0681", "no-such-column"};
// A history file has changed since the checkpoint was written. Resume from another checkpoint, or start a new run.
inline constexpr MessageCode kHistoryChanged{"E0682", "history-changed"};
// A value is no longer finite; the file ends before it. Reduce time steps and tolerances; check stiffnesses and masses.
inline constexpr MessageCode kOutputNotFinite{"E0683", "output-not-finite"};
// A summary, run.json or start.json is incomplete. It was cut off or edited: repeat the run.
inline constexpr MessageCode kSummaryDamaged{"E0684", "summary-damaged"};
// A picture file (.pvd, .vtu) cannot be read or is incomplete. Repeat the run with output.vtk = true.
inline constexpr MessageCode kPictureDamaged{"E0685", "picture-damaged"};
// An expression reads a name that does not exist. Use a column of history.csv, signal.NAME, state.NAME or time.
inline constexpr MessageCode kNoSuchQuantity{"E0686", "no-such-quantity"};

// The rows of a history are uneven in time, too few or too rare for a spectrum or a filter. Run again with another output.interval.
inline constexpr MessageCode kRowsForSpectrum{"E0687", "rows-for-spectrum"};

// ---- a mechanism inside another program ----

// The scene touches grains, which this object does not move. Control the coupled pair, or give the scene another ground.
inline constexpr MessageCode kEmbeddedGrains{"E0720", "embedded-grains"};
// A step ends before the present time, or its end is not a number. Give a later time.
inline constexpr MessageCode kStepBackwards{"E0721", "step-backwards"};
// The simulation has ended or failed. Restore an earlier state, or make a new simulation.
inline constexpr MessageCode kCannotGoOn{"E0722", "cannot-go-on"};
// A name is no signal of kind "host" of this scene. Use one of those listed.
inline constexpr MessageCode kNoHostSignal{"E0723", "no-host-signal"};
// A value is not a finite number. Correct it.
inline constexpr MessageCode kGivenNotFinite{"E0724", "given-not-finite"};
// A simulation that does not record the peaks of its steps has no summary. Make it with the option to record.
inline constexpr MessageCode kNotRecorded{"E0725", "not-recorded"};
// A saved state belongs to another scene, or to other settings. Restore it into a simulation of its own scene.
inline constexpr MessageCode kStateOfAnother{"E0726", "state-of-another"};
// An argument of a call in Python has a wrong type, or is outside of its range. The message says what is expected.
inline constexpr MessageCode kWrongArgument{"E0728", "wrong-argument"};
// A call while another thread steps, saves or restores the same simulation. Wait for its end, or make a simulation for each thread.
inline constexpr MessageCode kInUse{"E0729", "in-use"};

}  // namespace footfall::code

#pragma once
// Codes of the messages of liggghts_fix/: errors E0450 to E0499, warnings W1450 to W0499.

#include "coupler/base/errors.h"

namespace footfall::code {

// --- The program.

// LIGGGHTS stopped with an error of its own, which the message quotes or the log holds. Correct the script.
inline constexpr MessageCode kLiggghtsError{"E0450", "liggghts-error"};
// A signal stopped LIGGGHTS. Run again, or resume from the last checkpoint.
inline constexpr MessageCode kLiggghtsInterrupted{"E0451", "liggghts-interrupted"};
// The script of a scene runs another program. Run it beforehand, or allow it with --trust-script.
inline constexpr MessageCode kScriptRunsProgram{"E0452", "script-runs-program"};

// --- The conversation with mbd_solver.

// A script with couple/mbd runs without mbd_solver. Start both programs under one mpirun.
inline constexpr MessageCode kNoPartner{"E0453", "no-partner"};
// The script does not use `units si`. Write it in metres, kilograms and seconds.
inline constexpr MessageCode kUnitsNotSi{"E0454", "units-not-si"};
// The script couples a body that the scene does not offer to grains. Use one of the bodies listed.
inline constexpr MessageCode kBodyNotInScene{"E0455", "body-not-in-scene"};
// The script couples a further body after the first run. Couple it before the first run.
inline constexpr MessageCode kBodyCoupledLate{"E0456", "body-coupled-late"};
// The time step has changed since the first coupled step. Use one fixed `timestep`.
inline constexpr MessageCode kTimeStepChanged{"E0457", "time-step-changed"};
// The gravity of the script changed between two runs. Keep it constant.
inline constexpr MessageCode kGravityChanged{"E0458", "gravity-changed"};
// The script continues after the end of the scene. Remove that `run`, or `unfix` the coupling before it.
inline constexpr MessageCode kSceneHasEnded{"E0459", "scene-has-ended"};
// mbd_solver sent a motion for another window, or of another shape, than expected. Build both programs anew.
inline constexpr MessageCode kMotionUnexpected{"E0460", "motion-unexpected"};
// The motion of a body is infinite or not a number. Look at the mechanism's equations and time step.
inline constexpr MessageCode kMotionNotFinite{"E0461", "motion-not-finite"};
// The grains' load on a body is infinite or not a number. Reduce the DEM time step.
inline constexpr MessageCode kLoadNotFinite{"E0462", "load-not-finite"};
// LIGGGHTS has lost more grains than allowed. Enlarge the region of create_box, or raise `lost`.
inline constexpr MessageCode kTooManyGrainsLost{"E0463", "too-many-grains-lost"};
// The script removes the coupling before the end of the scene. Allow it with `end script`.
inline constexpr MessageCode kCouplingRemoved{"E0464", "coupling-removed"};
// The script ended without running couple/mbd. Add the fix and a `run`, or run the scene without grains.
inline constexpr MessageCode kScriptWithoutCoupling{"E0465", "script-without-coupling"};
// The script ended before the scene. Run more steps, or allow it with `end script`.
inline constexpr MessageCode kScriptEndedEarly{"E0466", "script-ended-early"};
// A resumed run has not read the grains of its checkpoint. Read them by `read_restart` in the script.
inline constexpr MessageCode kCheckpointGrainsNotRead{"E0467", "checkpoint-grains-not-read"};
// The DEM side's file of the checkpoint cannot be read. Resume from another checkpoint.
inline constexpr MessageCode kCheckpointNotReadable{"E0468", "checkpoint-not-readable"};
// The DEM side's files of a checkpoint cannot be written. Free space on the disk.
inline constexpr MessageCode kCheckpointNotWritten{"E0469", "checkpoint-not-written"};

// --- fix couple/mbd and its meshes.

// The script has a second fix couple/mbd. Name all meshes in one fix.
inline constexpr MessageCode kSecondCoupling{"E0470", "second-coupling"};
// fix couple/mbd is defined after a coupled run. Define it once, before the first run.
inline constexpr MessageCode kCouplingAfterRun{"E0471", "coupling-after-run"};
// The script uses another run_style than verlet. Use run_style verlet.
inline constexpr MessageCode kRunStyleUnsupported{"E0472", "run-style-unsupported"};
// modify_timing verbose would wait for mbd_solver. Use modify_timing on.
inline constexpr MessageCode kModifyTimingVerbose{"E0473", "modify-timing-verbose"};
// A coupled mesh was removed by `unfix`. Unfix couple/mbd first.
inline constexpr MessageCode kCoupledMeshRemoved{"E0474", "coupled-mesh-removed"};
// fix couple/mbd couples no body. Name meshes, or add beams by fix wall/gran/beam.
inline constexpr MessageCode kNoBodyCoupled{"E0475", "no-body-coupled"};
// The arguments of fix couple/mbd/geometry are wrong. Follow the syntax in the message.
inline constexpr MessageCode kGeometrySyntax{"E0476", "geometry-syntax"};
// A body has no triangles. Give it a surface in the scene.
inline constexpr MessageCode kBodyWithoutTriangles{"E0477", "body-without-triangles"};
// No fix mesh/surface of this id is defined above fix couple/mbd. Correct the id or the order.
inline constexpr MessageCode kMeshNotFound{"E0478", "mesh-not-found"};
// Something else moves a coupled mesh. Remove the other fix or servo.
inline constexpr MessageCode kMeshMovedTwice{"E0479", "mesh-moved-twice"};
// The surface velocity of a coupled mesh is a variable. Give it numbers.
inline constexpr MessageCode kMeshVelocityVaries{"E0480", "mesh-velocity-varies"};
// A mesh is not the surface of its body in the scene. Move or scale it, or use fix couple/mbd/geometry.
inline constexpr MessageCode kMeshDiffersFromBody{"E0481", "mesh-differs-from-body"};
// Two meshes hold the same triangle of a body. Keep it in one of them.
inline constexpr MessageCode kTriangleInTwoMeshes{"E0482", "triangle-in-two-meshes"};
// No fix wall/gran names a coupled mesh, so that grains would pass through. Add it to one.
inline constexpr MessageCode kMeshWithoutWall{"E0483", "mesh-without-wall"};
// A coupled mesh leaves the simulation box. Enlarge the region of create_box, or move the body.
inline constexpr MessageCode kMeshLeavesBox{"E0484", "mesh-leaves-box"};
// The round surface deviates too far from its facets. Use smaller facets, a larger skin or sharp edges.
inline constexpr MessageCode kSurfaceTooRound{"E0485", "surface-too-round"};
// A grain has an impossible radius, mass, position or velocity. Correct the command that creates it.
inline constexpr MessageCode kGrainInvalid{"E0486", "grain-invalid"};
// A body has passed through the floor below it. Make the bed deeper, or end the scene earlier.
inline constexpr MessageCode kBodyThroughFloor{"E0487", "body-through-floor"};
// The balances of an audit cannot be written. Free space on the disk.
inline constexpr MessageCode kAuditNotWritten{"E0488", "audit-not-written"};

// A grain meets a body so fast that it may pass through within a time step. Use a smaller time step.
inline constexpr MessageCode kGrainTooFast{"E0489", "grain-too-fast"};
// A grain has passed through the surface of a body. Use stiffer grains, smaller loads or a smaller time step.
inline constexpr MessageCode kGrainPassed{"E0498", "grain-passed"};

// --- fix wall/gran/beam.

// The arguments of fix wall/gran/beam are wrong. Follow the syntax in the message.
inline constexpr MessageCode kBeamSyntax{"E0490", "beam-syntax"};
// The type of fix wall/gran/beam has no material. Use one of the box's types.
inline constexpr MessageCode kBeamMaterialUnknown{"E0491", "beam-material-unknown"};
// A body has no beams for grains. Define some in the scene, or name another body.
inline constexpr MessageCode kBodyWithoutBeams{"E0492", "body-without-beams"};
// A body has no beam of this number. Use one of the numbers listed.
inline constexpr MessageCode kBeamUnknown{"E0493", "beam-unknown"};
// A beam is named twice. Name it once.
inline constexpr MessageCode kBeamNamedTwice{"E0494", "beam-named-twice"};
// fix wall/gran/beam does not support a keyword or a fix. Remove it, or follow the message.
inline constexpr MessageCode kBeamUnsupported{"E0495", "beam-unsupported"};
// A segment of a beam is longer than a subdomain. Use shorter segments or fewer ranks.
inline constexpr MessageCode kBeamSegmentTooLong{"E0496", "beam-segment-too-long"};
// The script has beams but no fix couple/mbd. Add it.
inline constexpr MessageCode kBeamWithoutCoupling{"E0497", "beam-without-coupling"};

// --- Sources and sinks of grains.

// The arguments of fix insert/exact, remove/region or bed/follow are wrong. Follow the syntax in the message.
inline constexpr MessageCode kSourceSyntax{"E0499", "source-syntax"};

// --- Warnings.

// New grains find no space in the region of their source. Enlarge it, or let them leave it faster.
inline constexpr MessageCode kNoSpaceForGrains{"W1461", "no-space-for-grains"};

// Grains have left the box, and LIGGGHTS has lost them. Enlarge the region of create_box if it matters.
inline constexpr MessageCode kGrainsLost{"W1450", "grains-lost"};
// The scene offers a surface or beam to grains, but the script does not couple it. Couple it, or ignore the warning.
inline constexpr MessageCode kBoundaryNotCoupled{"W1451", "boundary-not-coupled"};
// The script's gravity varies and is compared with the scene's at the start only. No action is required if this is intended.
inline constexpr MessageCode kGravityVaries{"W1452", "gravity-varies"};
// fix multisphere is defined before a wall, which its clumps miss in the first half step. Define it after all walls.
inline constexpr MessageCode kClumpsBeforeWall{"W1453", "clumps-before-wall"};
// Spheres belong to no clump and are not integrated. Use a bed of clumps, or integrate the spheres.
inline constexpr MessageCode kSpheresAtRest{"W1454", "spheres-at-rest"};
// washino liquid bridges act on walls only at a distance. Use easo/capillary/viscous.
inline constexpr MessageCode kLiquidOnlyApart{"W1455", "liquid-only-apart"};
// easo liquid bridges take a wrong velocity of the wall. Set fluidViscosity to 0 and use meshes or beams.
inline constexpr MessageCode kLiquidWallVelocity{"W1456", "liquid-wall-velocity"};
// No grain has the radius that the run gives. Make bed and variable agree.
inline constexpr MessageCode kRadiusDiffers{"W1457", "radius-differs"};
// The script moves a mesh, and bodies pass through it unnoticed. No action is required if this is intended.
inline constexpr MessageCode kMeshMovedByScript{"W1458", "mesh-moved-by-script"};
// A body has passed through a wall, which stops grains only. Add a contact in the scene if it should stop.
inline constexpr MessageCode kBodyThroughWall{"W1459", "body-through-wall"};

// A body has passed through a side wall of the bed. Make the bed larger, or end the scene earlier.
inline constexpr MessageCode kBodyLeavesBed{"W1460", "body-leaves-bed"};

}  // namespace footfall::code

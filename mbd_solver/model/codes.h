#pragma once
// Codes of the messages of model/, fe/ and build/: E0300 to E0339, W0300 to W0339.
// Single parameters outside their range: mbd_solver/base/codes.h, E0434.

#include "coupler/base/errors.h"

namespace footfall::code {

// --- Bodies, joints and elements.

// Mass or inertia of a body is impossible for a solid. Correct mass and inertia, or give dimensions and density.
inline constexpr MessageCode kMassProperties{"E0300", "mass-properties"};
// Mode shapes move the centre of mass, or the nodes do not balance about it. Use mean axes (footfall converts files).
inline constexpr MessageCode kModesMoveCentre{"E0301", "modes-move-centre"};
// The ends of a strut or distance joint coincide in the reference configuration. Separate them.
inline constexpr MessageCode kNoLength{"E0302", "no-length"};
// A joint connects a body with itself. Name two bodies, or a body and the ground.
inline constexpr MessageCode kOneBodyOnly{"E0303", "one-body-only"};
// Two bodies, joints or elements of a model share a name. Rename one.
inline constexpr MessageCode kTwiceInModel{"E0330", "twice-in-model"};
// A model refers to a body that it does not have. Correct the name or index.
inline constexpr MessageCode kNotInModel{"E0331", "not-in-model"};
// The initial state of a body is not finite. Correct its position and velocity.
inline constexpr MessageCode kInitialState{"E0332", "initial-state"};
// A prescribed motion has no component. Give at least one.
inline constexpr MessageCode kNothingPrescribed{"E0304", "nothing-prescribed"};
// Parameters of a law, controller or element contradict each other, or one is missing. Follow the message.
inline constexpr MessageCode kParametersDisagree{"E0305", "parameters-disagree"};
// The points of a curve or table do not rise strictly. Sort them and remove duplicates.
inline constexpr MessageCode kCurveNotRising{"E0306", "curve-not-rising"};
// A table has too few points, too few rows or a value that is not finite. Complete it.
inline constexpr MessageCode kTableShape{"E0307", "table-shape"};
// A table of forces delivers energy. Correct the entry, so that forces oppose motion.
inline constexpr MessageCode kTableNotPassive{"E0308", "table-not-passive"};
// A surface or contact has no contact points. Give at least one.
inline constexpr MessageCode kNoContactPoints{"E0309", "no-contact-points"};
// The ends of a strut meet during a run. Add an end stop, or move its ends apart.
inline constexpr MessageCode kStrutEndsMeet{"E0310", "strut-ends-meet"};
// The stroke uses up the gas volume of a strut. Add or stiffen an end stop, or enlarge the volume.
inline constexpr MessageCode kGasUsedUp{"E0311", "gas-used-up"};
// A cable runs over too many bodies between two ends. Let it turn one of its pulleys.
inline constexpr MessageCode kCableBodies{"E0334", "cable-bodies"};
// Two guides of a cable meet: one is inside of the other. Stop the mechanism before, or correct radii and sense of the axes.
inline constexpr MessageCode kCableInside{"E0335", "cable-inside"};
// A drum has wound in the whole cable. Stop its drive earlier, or give the cable a longer path.
inline constexpr MessageCode kCableTakenUp{"E0336", "cable-taken-up"};
// The bodies of a bushing are nearly half a turn apart. Use a torsion spring about a joint axis.
inline constexpr MessageCode kHalfTurn{"E0312", "half-turn"};

// --- Signals and controllers.

// An expression has a syntax error or an unknown name. Correct it.
inline constexpr MessageCode kExpressionSyntax{"E0313", "expression-syntax"};
// An expression has no finite value. Guard divisions, roots and logarithms.
inline constexpr MessageCode kNoValue{"E0314", "no-value"};
// Signals depend on each other in a loop. Put a lowpass filter into the loop.
inline constexpr MessageCode kSignalLoop{"E0315", "signal-loop"};
// A .fll file cannot be read or has a syntax error. Correct the line that is named.
inline constexpr MessageCode kFllSyntax{"E0316", "fll-syntax"};
// A .fll file has other variables or ranges than required. Correct the variable that is named.
inline constexpr MessageCode kFllVariables{"E0317", "fll-variables"};
// No rule of a fuzzy system fires for some inputs. Add a rule, or widen the terms.
inline constexpr MessageCode kNoRuleFires{"E0318", "no-rule-fires"};
// The grid of a fuzzy table is too coarse or too large. Change the number of points.
inline constexpr MessageCode kFuzzyGrid{"E0319", "fuzzy-grid"};

// --- Finite elements and meshes.

// A triangle mesh has a defect: degenerate or double triangles, open edges, an inward surface. Repair the mesh.
inline constexpr MessageCode kMeshDefect{"E0320", "mesh-defect"};
// A finite-element model is incomplete, disconnected or not free. Correct the model.
inline constexpr MessageCode kFeModel{"E0321", "fe-model"};
// A node does not exist or is too far from where a joint attaches. Name another node or refine the mesh.
inline constexpr MessageCode kNoSuchNode{"E0322", "no-such-node"};
// A joint requires the rotation of a node that has none. Attach it to a node of a beam or shell, or use a spherical joint.
inline constexpr MessageCode kNodeWithoutRotation{"E0323", "node-without-rotation"};
// A stiffness matrix is not positive definite. Check units, supports and connections of the model.
inline constexpr MessageCode kStiffness{"E0324", "stiffness-not-positive"};
// Fewer motions than modes carry mass. Request fewer modes, or give every node a mass.
inline constexpr MessageCode kTooManyModes{"E0325", "too-many-modes"};
// The mode solver did not converge. Request fewer modes, or check the model for very different stiffnesses.
inline constexpr MessageCode kModesNotConverged{"E0326", "modes-not-converged"};
// Mode shapes are not independent, or one is a rigid motion. Remove it from the file.
inline constexpr MessageCode kShapesDependent{"E0327", "shapes-dependent"};
// A model file of another code cannot be read or is malformed. Correct the line that is named.
inline constexpr MessageCode kModelFile{"E0328", "model-file"};
// A model file cannot be written. Check the folder and the free space.
inline constexpr MessageCode kModelFileNotWritten{"E0333", "model-file-not-written"};
// The supports leave a body free to move. Add supports.
inline constexpr MessageCode kSupports{"E0329", "supports"};

// Natural frequencies are unusually low or high. Check the units of the model.
inline constexpr MessageCode kUnusualFrequencies{"W1320", "unusual-frequencies"};
// Static deflections of a reduced body are underestimated. Add modes, or list the interface nodes.
inline constexpr MessageCode kStaticError{"W1321", "static-error"};

}  // namespace footfall::code

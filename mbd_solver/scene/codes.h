#pragma once
// Codes of the messages about scene files and LIGGGHTS scripts (E0100 to E0249, W0100 to W0249). The comment above a code
// says what the message means and what to do; docs/reference/messages.md is made of these lines.

#include "coupler/base/errors.h"

namespace footfall::code {

// ---- the file ----

// The scene file or folder does not exist, or the folder has no scene.toml. Check the path.
inline constexpr MessageCode kNoScene{"E0100", "no-scene"};
// The file exists but cannot be read. Check its permissions.
inline constexpr MessageCode kFileNotReadable{"E0101", "file-not-readable"};
// The file is not valid TOML. Correct the line that is named.
inline constexpr MessageCode kNotToml{"E0102", "not-toml"};
// The scene has a key that footfall does not know. Correct its spelling, or remove it.
inline constexpr MessageCode kUnknownKey{"E0103", "unknown-key"};
// The value is of another type than expected. Write it as the message says.
inline constexpr MessageCode kWrongType{"E0104", "wrong-type"};
// The number is outside its valid range. Check the value and its unit.
inline constexpr MessageCode kOutOfRange{"E0105", "out-of-range"};
// A key without default is missing. Add it.
inline constexpr MessageCode kMissingKey{"E0106", "missing-key"};
// A quantity is given twice with different unit suffixes. Keep one of the keys.
inline constexpr MessageCode kUnitSuffix{"E0107", "unit-suffix"};
// A file that the scene names does not exist. Paths are relative to the folder of the scene.
inline constexpr MessageCode kNoFile{"E0108", "no-file"};
// A dotted key has more than 100 parts. Use the names of the reference.
inline constexpr MessageCode kKeyTooDeep{"E0109", "key-too-deep"};
// A setting of --set is not of the form key=value. Write for example solver.integrator=ida.
inline constexpr MessageCode kMalformedSetting{"E0110", "malformed-setting"};
// A setting of --set names an entry that the list does not have. Use the name of an entry, or its index from 0.
inline constexpr MessageCode kUnknownEntry{"E0111", "unknown-entry"};
// The key `base` does not lead to another scene. Give the path of a scene that is not based on this one.
inline constexpr MessageCode kBadBase{"E0112", "bad-base"};
// The key `without` names what the base does not have. Use keys of the base.
inline constexpr MessageCode kBadWithout{"E0113", "bad-without"};
// The file is an experiment (sweep, rig), not a scene. Run it with the command that its first lines name.
inline constexpr MessageCode kNotAScene{"E0114", "not-a-scene"};
// The word is none of the choices of this key. Use one of the words that the message lists.
inline constexpr MessageCode kUnknownChoice{"E0115", "unknown-choice"};
// The name cannot become a column or a file. Use letters, digits, _ - and . (not first), at most 100.
inline constexpr MessageCode kBadName{"E0116", "bad-name"};
// A list has another number of entries than expected. Give as many as the message says.
inline constexpr MessageCode kWrongCount{"E0117", "wrong-count"};
// The first column of a table, or a list of stations, does not rise strictly. Sort it and remove repeated values.
inline constexpr MessageCode kNotRising{"E0118", "not-rising"};
// Two ends of a range are in the wrong order. Give a smaller minimum or a larger maximum.
inline constexpr MessageCode kRangeReversed{"E0119", "range-reversed"};

// A file has more errors than are listed. Correct the first ones, and check again.
inline constexpr MessageCode kMoreErrors{"E0137", "more-errors"};
// A file has more warnings than are listed. Mend the first ones, and check again.
inline constexpr MessageCode kMoreWarnings{"W1172", "more-warnings"};

// ---- names ----

// Two entries of one kind have the same name. Rename one of them.
inline constexpr MessageCode kDuplicateName{"E0120", "duplicate-name"};
// The name has a meaning of its own. Choose another one.
inline constexpr MessageCode kReservedName{"E0121", "reserved-name"};
// A name in braces belongs to no array. Define it in [arrays], or correct the name.
inline constexpr MessageCode kUnknownArray{"E0122", "unknown-array"};
// An entry names a body that the scene does not define. Correct the name, or add the body.
inline constexpr MessageCode kUnknownBody{"E0123", "unknown-body"};
// An entry names a joint that the scene does not define. Correct the name, or add the joint.
inline constexpr MessageCode kUnknownJoint{"E0124", "unknown-joint"};
// A body names a material that the scene does not define. Correct the name, or add the material.
inline constexpr MessageCode kUnknownMaterial{"E0125", "unknown-material"};
// An entry or expression names a signal that the scene does not define. Correct the name, or add the signal.
inline constexpr MessageCode kUnknownSignal{"E0126", "unknown-signal"};
// An entry or expression names a state that the scene does not define. Correct the name, or add it to [[states]].
inline constexpr MessageCode kUnknownState{"E0127", "unknown-state"};
// A member of a frame names a section that the body does not define. Correct the name, or add the section.
inline constexpr MessageCode kUnknownSection{"E0128", "unknown-section"};
// A damper names an output that no controller has. Use CONTROLLER.OUTPUT, for example lander.U1.
inline constexpr MessageCode kUnknownOutput{"E0129", "unknown-output"};
// A contact names a body without boundary. Add an entry of [[boundaries]] for it.
inline constexpr MessageCode kUnknownBoundary{"E0130", "unknown-boundary"};
// No soil of this name is shipped. Use one of the names that the message lists.
inline constexpr MessageCode kUnknownSoil{"E0131", "unknown-soil"};
// No clump of this name exists. Use one of the names that the message lists.
inline constexpr MessageCode kUnknownClump{"E0132", "unknown-clump"};
// The joint has no such coordinate. Use a coordinate that the message lists, or another type of joint.
inline constexpr MessageCode kUnknownCoordinate{"E0133", "unknown-coordinate"};
// The joint has several coordinates and none is chosen. Name one of them.
inline constexpr MessageCode kAmbiguousCoordinate{"E0134", "ambiguous-coordinate"};
// The script neither declares nor reads a variable of this name. Correct the name.
inline constexpr MessageCode kUnknownVariable{"E0135", "unknown-variable"};
// The script has no mesh of this id. Correct the id, or add a fix mesh/surface before this line.
inline constexpr MessageCode kUnknownMesh{"E0136", "unknown-mesh"};

// ---- keys that do not fit together ----

// Two keys give the same quantity, or exclude each other. Keep one of them.
inline constexpr MessageCode kConflictingKeys{"E0140", "conflicting-keys"};
// The key has no effect on this kind of entry. Remove it.
inline constexpr MessageCode kKeyWithoutEffect{"E0141", "key-without-effect"};
// The key needs a second key, which is not given. Add the second key, or remove the first.
inline constexpr MessageCode kNeedsOtherKey{"E0142", "needs-other-key"};
// The entry does nothing as it is. Add at least one of the keys that the message lists.
inline constexpr MessageCode kEmptyEntry{"E0143", "empty-entry"};
// The same thing is listed or defined twice. Keep one.
inline constexpr MessageCode kListedTwice{"E0144", "listed-twice"};
// An array makes more than 1000 copies. Reduce its count.
inline constexpr MessageCode kTooManyCopies{"E0145", "too-many-copies"};
// A count or size is beyond reason, mostly by a wrong unit. Check the unit, or choose a smaller number.
inline constexpr MessageCode kTooLarge{"E0146", "too-large"};
// The relative tolerance is so large that results would be meaningless. Use for example 1e-6.
inline constexpr MessageCode kTolerance{"E0147", "tolerance"};
// The file that ground.soil names describes no soil. Name a file that `footfall ground fit` has written.
inline constexpr MessageCode kSoilFile{"E0148", "soil-file"};

// ---- bodies ----

// The scene has no body. Add a [[bodies]] entry.
inline constexpr MessageCode kNoBodies{"E0150", "no-bodies"};
// No rigid body can have this inertia. Check numbers, units and order; it refers to the mass centre.
inline constexpr MessageCode kInertia{"E0151", "inertia"};
// total_mass and the masses of the bodies do not agree. Correct one of them.
inline constexpr MessageCode kTotalMass{"E0152", "total-mass"};
// The dimensions give no solid of this kind. Correct them as the message says.
inline constexpr MessageCode kShape{"E0153", "shape"};
// The body has no elastic model, or more than one. Give a shape that bends, or one of file, mesh, nodes and matrices.
inline constexpr MessageCode kElasticModel{"E0154", "elastic-model"};
// A member of a frame joins nodes that do not exist. Nodes are numbered from 0.
inline constexpr MessageCode kFrameMember{"E0155", "frame-member"};
// The body cannot be divided into segments as it is. Only a tube or rod with modes of its own shape can.
inline constexpr MessageCode kSegments{"E0156", "segments"};

// ---- joints, motions and the initial state ----

// The two points of a joint are apart in the reference configuration. Correct the points, or raise initial.largest_gap.
inline constexpr MessageCode kJointOpen{"E0160", "joint-open"};
// Points, axes or length of a joint do not fit its type. Correct them as the message says.
inline constexpr MessageCode kJointGeometry{"E0161", "joint-geometry"};
// A prescribed joint prescribes nothing, or a motion is given to a joint of another type. Correct the key motion.
inline constexpr MessageCode kMotion{"E0162", "motion"};
// Two joints prescribe the same motion of the same two bodies. Remove one of them.
inline constexpr MessageCode kMotionTwice{"E0163", "motion-twice"};
// A prescribed motion does not start where its bodies are drawn, or turns 90 degrees from there. Draw the bodies as they start.
inline constexpr MessageCode kMotionStart{"E0164", "motion-start"};
// The initial coordinate is not possible for this joint. Correct it as the message says.
inline constexpr MessageCode kInitialJoint{"E0165", "initial-joint"};
// initial.settle excludes grains and initial velocities. Remove one of the two.
inline constexpr MessageCode kSettle{"E0166", "settle"};
// A factor of a gear is 0. Remove the joint from the gear, or give its radius or number of teeth.
inline constexpr MessageCode kGearFactor{"E0167", "gear-factor"};
// The curve of a cam does not close, or spans more than one turn. Correct its ends.
inline constexpr MessageCode kCamCurve{"E0168", "cam-curve"};

// ---- struts, springs, forces, controllers and signals ----

// The gas of a strut would be compressed to nothing. Add a stop before that stroke.
inline constexpr MessageCode kGasVolume{"E0170", "gas-volume"};
// The stages or stiffnesses of a honeycomb are in the wrong order. List the softest stage first.
inline constexpr MessageCode kHoneycomb{"E1171", "honeycomb"};
// A table over the voltage does not run from 0 to 1, or its values fall. Correct the table.
inline constexpr MessageCode kVoltageTable{"E0172", "voltage-table"};
// An element on a flexible body has no point of action. Add the key point.
inline constexpr MessageCode kPointOfAction{"E0173", "point-of-action"};
// The path of a cable is not one: a guide is missing, inside of the next or out of the plane of a pulley. Correct the guide.
inline constexpr MessageCode kCablePath{"E0175", "cable-path"};
// The expression cannot be read. Correct it at the place that is named.
inline constexpr MessageCode kExpression{"E0174", "expression"};

// ---- boundaries, contacts and the ground ----

// No surface or beam can be made for this boundary. Give a file, or a shape that has one.
inline constexpr MessageCode kNoSurface{"E0180", "no-surface"};
// The section of the chosen ground is missing, or nothing can touch it. Complete the scene, or set ground.kind = "none".
inline constexpr MessageCode kGroundIncomplete{"E0181", "ground-incomplete"};
// Contact of two flexible bodies is not supported. Make one of them rigid.
inline constexpr MessageCode kFlexibleContact{"E0182", "flexible-contact"};

// The file of heights is damaged, has holes, or is too large. Follow the message; GDAL fills, cuts and converts maps.
inline constexpr MessageCode kTerrainMap{"E0183", "terrain-map"};
// Parts of the terrain contradict each other or the ground. Follow the message.
inline constexpr MessageCode kTerrain{"E0184", "terrain"};

// ---- a bed by numbers ----

// A size distribution is none: counts differ, sizes do not increase, or shares do not make a whole. Follow the message.
inline constexpr MessageCode kSizeDistribution{"E0185", "size-distribution"};
// A zone of other grains is no block in the bed, or too small for its grains. Correct its place or size.
inline constexpr MessageCode kGrainZone{"E0186", "grain-zone"};

// The bed is too small for its grains, or has too many of them. Change size or radius.
inline constexpr MessageCode kBoxSize{"E0190", "box-size"};
// The pit is not a part of the bed. Correct its ends and depth.
inline constexpr MessageCode kBoxPit{"E0191", "box-pit"};
// LIGGGHTS does not accept this value or name. Use one of its range.
inline constexpr MessageCode kLiggghtsRange{"E0192", "liggghts-range"};
// Gravity is tilted by more than 30 degrees, or zero, and the bed would not settle on its floor. Correct gravity.
inline constexpr MessageCode kBoxGravity{"E0193", "box-gravity"};
// The time step is too large for these grains: results would be wrong. Leave it out, or state particles.max_time_step.
inline constexpr MessageCode kBoxTimeStep{"E0194", "box-time-step"};

// A source or sink of grains is no block within the bed and the space above it, or too small. Correct its corners.
inline constexpr MessageCode kGrainRegion{"E0195", "grain-region"};

// The run of initial.from has kept no grains of its end. Run it with output.keep_grains = true.
inline constexpr MessageCode kNoEndGrains{"E0196", "no-end-grains"};

// The terrain is steeper than its grains can stand. Make it less steep, or the grains rougher.
inline constexpr MessageCode kTerrainSteep{"E0197", "terrain-steep"};

// A key of [accepted] is no code of a warning, or has no reason. Write W and four digits, and why the warning does not matter.
inline constexpr MessageCode kNoWarningCode{"E0198", "no-warning-code"};

// ---- the LIGGGHTS script ----

// The script has no fix couple/mbd. Add one, or choose another ground.
inline constexpr MessageCode kScriptNotCoupled{"E0200", "script-not-coupled"};
// The script's time step exceeds particles.max_time_step: results would be wrong. Make it smaller.
inline constexpr MessageCode kScriptTimeStep{"E0201", "script-time-step"};
// The script includes itself. Remove the include.
inline constexpr MessageCode kScriptCircle{"E0202", "script-circle"};
// The script couples a body or mesh that does not exist. Correct the name.
inline constexpr MessageCode kScriptName{"E0203", "script-name"};
// No run follows the coupling. Add a last line "run 1000000000".
inline constexpr MessageCode kScriptNoRun{"E0204", "script-no-run"};
// The script resets the step counter while it is coupled. Move reset_timestep before fix couple/mbd.
inline constexpr MessageCode kScriptResetsSteps{"E0205", "script-resets-steps"};
// The script reads a bed that does not exist. Add [particles.bed], or name a restart file.
inline constexpr MessageCode kScriptBed{"E0206", "script-bed"};
// Scene and script have different gravity. Make them agree, or add "gravity script" to fix couple/mbd.
inline constexpr MessageCode kScriptGravity{"E0207", "script-gravity"};
// The value of a variable leads back to the variable itself. Give it a value.
inline constexpr MessageCode kVariableCircle{"E0208", "variable-circle"};
// The script has other units than SI. Write `units si`.
inline constexpr MessageCode kScriptNotSi{"E0215", "script-not-si"};
// The name or the value of a script variable has characters that may not stand there. Give a number, a name or a path.
inline constexpr MessageCode kUnsafeValue{"E0214", "unsafe-value"};
// The script's mesh cannot be used as a surface. Correct its line, or name the file in the scene.
inline constexpr MessageCode kScriptMesh{"E0209", "script-mesh"};
// The mesh is far outside of the simulation box, mostly drawn in millimetres. Add "scale 0.001" to its fix.
inline constexpr MessageCode kMeshOutsideBox{"E0210", "mesh-outside-box"};

// ---- mesh files and the installation ----

// The file is no mesh of a known format, or its reader refuses it. Convert it.
inline constexpr MessageCode kMeshFormat{"E0220", "mesh-format"};
// The mesh file is damaged. Export it again.
inline constexpr MessageCode kMeshDamaged{"E0221", "mesh-damaged"};
// The mesh has more triangles or bytes than a run can carry. Use a coarser mesh.
inline constexpr MessageCode kMeshTooLarge{"E0222", "mesh-too-large"};
// The mesh has no triangles or no extent. Export a surface.
inline constexpr MessageCode kMeshEmpty{"E0223", "mesh-empty"};
// The mesh is so far from the origin of its file that the digits of its coordinates do not give its shape. Export it nearer.
inline constexpr MessageCode kMeshDigits{"E0224", "mesh-digits"};
// A file that is shipped with footfall is missing. Install footfall again, or build it from a complete checkout.
inline constexpr MessageCode kShippedFile{"E0230", "shipped-file"};

// ---- warnings ----

// The script does not use the variable, so its value has no effect. Remove it unless another script needs it.
inline constexpr MessageCode kUnusedVariable{"W1135", "unused-variable"};
// The scene has grains, a script or a box, and no ground, so the mechanism runs alone. Write ground.kind = "particles", or "none" if this is intended.
inline constexpr MessageCode kGrainsNotUsed{"W1186", "grains-not-used"};
// The key has no effect on this kind of controller. Remove it.
inline constexpr MessageCode kUnusedKey{"W1141", "unused-key"};
// A material is lighter than foam, mostly by a wrong unit. Use the suffix _g_cm3 for grams per cubic centimetre.
inline constexpr MessageCode kLightMaterial{"W1150", "light-material"};
// A Python file has no function of the name that a signal calls. Correct the name, or define the function.
inline constexpr MessageCode kNoFunction{"W1282", "no-function"};
// Nothing holds or touches the body. Add a joint, or remove the body.
inline constexpr MessageCode kLooseBody{"W1151", "loose-body"};
// Gravity pulls the bodies off the ground. Change its sign.
inline constexpr MessageCode kGravityUpwards{"W1152", "gravity-upwards"};
// No solid of this size has this mass or density. Check the units of mass and size.
inline constexpr MessageCode kImplausibleMass{"W1153", "implausible-mass"};
// The mass of the body would be far outside of the body. Check the unit of the inertia, kg m2.
inline constexpr MessageCode kImplausibleInertia{"W1154", "implausible-inertia"};
// Gravity exceeds any planet or centrifuge. Write m/s2.
inline constexpr MessageCode kImplausibleGravity{"W1155", "implausible-gravity"};
// A body is inside a second body to which nothing connects it. Move it, or connect the two.
inline constexpr MessageCode kBodyInside{"W1156", "body-inside"};
// The spline through a table leaves the range of its values. Give more points where the motion begins and ends.
inline constexpr MessageCode kSplineOvershoot{"W1160", "spline-overshoot"};
// The motion continues beyond the end of its table at the last speed. Give more points, the last ones equal to rest.
inline constexpr MessageCode kMotionContinues{"W1161", "motion-continues"};
// ---- programs of the user ----

// A file is no FMU, or its modelDescription.xml is missing or damaged. Export the FMU again.
inline constexpr MessageCode kFmuFile{"E0270", "fmu-file"};
// An FMU is of a version of FMI that is not read. Export it for FMI 3.0 or 2.0.
inline constexpr MessageCode kFmuVersion{"E0271", "fmu-version"};
// An FMU has no library for this machine. Export or compile it for this platform.
inline constexpr MessageCode kFmuPlatform{"E0272", "fmu-platform"};
// An FMU needs the program that exported it, or is not for co-simulation. Export it for co-simulation, without a tool.
inline constexpr MessageCode kFmuTool{"E0273", "fmu-tool"};
// An FMU has no variable of this name. Use one of those listed.
inline constexpr MessageCode kFmuVariable{"E0274", "fmu-variable"};
// A variable of an FMU is used as what it is not: inputs are set, outputs read, parameters given at the start.
inline constexpr MessageCode kFmuCausality{"E0275", "fmu-causality"};
// A variable of an FMU is an array, or an element that it does not have. Name one of its elements.
inline constexpr MessageCode kFmuArray{"E0276", "fmu-array"};
// A variable of an FMU is no number. Use another one.
inline constexpr MessageCode kFmuType{"E0277", "fmu-type"};
// The program that runs FMUs is not built. Start the run by ./footfall, or build the target footfall_fmu_host.
inline constexpr MessageCode kFmuHost{"E0278", "fmu-host"};
// A scene runs a program of the user. Read it, and trust it with --trust-script.
inline constexpr MessageCode kForeignCode{"E0279", "foreign-code"};
// Checkpoints are asked for, but a Python file has no functions save() and restore(). Add them, or say stateless = true.
inline constexpr MessageCode kScriptState{"E0727", "script-state"};
// Checkpoints are asked for, but an FMU cannot tell its state. Remove checkpoint_interval, or export the FMU with that ability.
inline constexpr MessageCode kFmuState{"E0280", "fmu-state"};
// An FMU cannot tell its state: the run has no checkpoints and cannot be resumed.
inline constexpr MessageCode kNoCheckpoints{"W1280", "no-checkpoints"};
// The program that runs FMUs is not built: variables of the FMU are not checked. Build the target footfall_fmu_host.
inline constexpr MessageCode kFmuUnchecked{"W0281", "fmu-unchecked"};

// A joint starts beyond its stop, which throws it back at once. Start it within, or move the stop.
inline constexpr MessageCode kStartBeyondStop{"W1165", "start-beyond-stop"};
// The clearance is measured before [initial.joints] moves the bodies. Check the gap to the ground.
inline constexpr MessageCode kClearance{"W1166", "clearance"};
// An angle in rad exceeds a turn, mostly meant in degrees. Use the suffix _deg.
inline constexpr MessageCode kAngleInDegrees{"W1167", "angle-in-degrees"};
// The speed exceeds the speed of sound in the body, where contact laws do not hold. Check its unit.
inline constexpr MessageCode kImplausibleSpeed{"W1168", "implausible-speed"};
// A number is far outside of what is built, mostly by a wrong unit, or in percent or degrees. Check its unit.
inline constexpr MessageCode kImplausibleNumber{"W0157", "implausible-number"};
// Springs yield by more than the size of the mechanism under the weight that they carry. Check the unit of their stiffness.
inline constexpr MessageCode kSoftSpring{"W1170", "soft-spring"};
// A key is written in a second spelling, which is read as well. Write the spelling that the message names.
inline constexpr MessageCode kSecondSpelling{"W0171", "second-spelling"};
// The script has no fix gravity, so its grains have no weight. Add the line that the message gives.
inline constexpr MessageCode kNoGrainGravity{"W1207", "no-grain-gravity"};
// Gravity is tilted against the bed by more than the slope at which its grains stand, and the bed flows. Tilt gravity less, or turn the bed.
inline constexpr MessageCode kBedFlows{"W1213", "bed-flows"};
// Grains touch the polygon of a round face, which is smaller than the circle. Give a smaller element_size.
inline constexpr MessageCode kPolygonArea{"W1214", "polygon-area"};
// The mesh is far larger than the simulation box, mostly drawn in millimetres. Add "scale 0.001" to its fix.
inline constexpr MessageCode kMeshLargerThanBox{"W1210", "mesh-larger-than-box"};
// The mesh is far from the origin of its file, and its coordinates have few digits. Export it nearer, or as text.
inline constexpr MessageCode kMeshFewDigits{"W1220", "mesh-few-digits"};
// The mesh was decimated as required: the distance from the surface in the file. Give more triangles if it is too large.
inline constexpr MessageCode kMeshDecimated{"W1221", "mesh-decimated"};
// The bed is made under other conditions than the run has. Make them agree unless this is intended.
inline constexpr MessageCode kBedDiffers{"W0211", "bed-differs"};

// A material is softer than LIGGGHTS expects: overlaps are large. Watch max_overlap_over_radius, or use a stiffer one.
inline constexpr MessageCode kSoftMaterial{"W0212", "soft-material"};

}  // namespace footfall::code

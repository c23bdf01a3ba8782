#pragma once
// Codes of the messages of mbd_solver/import: E0700 to E0719, W1700 to W0719.

#include "coupler/base/errors.h"

namespace footfall::code {

// The file is no robot that can be read: neither URDF, SDF nor MJCF. Name a file of one of these formats.
inline constexpr MessageCode kRobotFormat{"E0700", "robot-format"};
// The file is no well-formed XML. Correct it at the line of the message.
inline constexpr MessageCode kRobotXml{"E0701", "robot-xml"};
// The file has macros of xacro that are not expanded. Expand it first: xacro FILE > robot.urdf
inline constexpr MessageCode kRobotXacro{"E0702", "robot-xacro"};
// A name is missing, given twice, or names nothing. Correct it.
inline constexpr MessageCode kRobotName{"E0703", "robot-name"};
// A number is missing, is no number, or lies outside of its range. Correct it.
inline constexpr MessageCode kRobotNumber{"E0704", "robot-number"};
// Links and joints form no mechanism: a circle, a link with two parents, or several roots. Correct parents and children.
inline constexpr MessageCode kRobotTree{"E0705", "robot-tree"};
// A moving link has no mass or inertia that a body can have. Give it an inertia.
inline constexpr MessageCode kRobotMass{"E0706", "robot-mass"};
// The library that reads this format refuses the file. Its message follows.
inline constexpr MessageCode kRobotRefused{"E0707", "robot-refused"};
// --strict was given, and a part cannot be represented in a scene. Remove it from the file, or import without --strict.
inline constexpr MessageCode kRobotStrict{"E0708", "robot-strict"};
// The folder for the scene cannot be used, or exists. Choose another one with --out.
inline constexpr MessageCode kRobotFolder{"E0709", "robot-folder"};
// The ground is neither a plane nor one of the soils. The message lists them.
inline constexpr MessageCode kRobotGround{"E0710", "robot-ground"};
// An element or attribute is none of its format, or is missing. Correct it.
inline constexpr MessageCode kRobotElement{"E0711", "robot-element"};
// Nothing in the file moves: all is static or without mass. Import the robot itself, not its surroundings.
inline constexpr MessageCode kRobotStill{"E0712", "robot-still"};
// The file is SDF, and footfall was built without the library sdformat. Install libsdformat-dev and build again, or convert to URDF.
inline constexpr MessageCode kRobotWithoutSdf{"E0713", "robot-without-sdf"};
// A part of the file is not in the scene, or only approximately. The message names the part and its place.
inline constexpr MessageCode kRobotNotTaken{"W1700", "robot-not-taken"};

}  // namespace footfall::code

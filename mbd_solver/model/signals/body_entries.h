#pragma once
// The numbers of one body's motion that have a name: columns of a history, and what signals measure.

#include "mbd_solver/model/body_kinematics.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

// One column of each thing of a kind; `value` reads it from what the thing is at an instant.
template <class Thing>
struct Entry {
  const char* pattern;
  const char* unit;
  double (*value)(const Thing&);
};

inline constexpr Entry<BodyKinematics> kBodyEntries[] = {
    {"<body>.x", "m", [](const BodyKinematics& b) { return b.r.x(); }},
    {"<body>.y", "m", [](const BodyKinematics& b) { return b.r.y(); }},
    {"<body>.z", "m", [](const BodyKinematics& b) { return b.r.z(); }},
    {"<body>.vx", "m/s", [](const BodyKinematics& b) { return b.dr.x(); }},
    {"<body>.vy", "m/s", [](const BodyKinematics& b) { return b.dr.y(); }},
    {"<body>.vz", "m/s", [](const BodyKinematics& b) { return b.dr.z(); }},
    {"<body>.ax", "m/s2", [](const BodyKinematics& b) { return b.ddr.x(); }},
    {"<body>.ay", "m/s2", [](const BodyKinematics& b) { return b.ddr.y(); }},
    {"<body>.az", "m/s2", [](const BodyKinematics& b) { return b.ddr.z(); }},
    {"<body>.roll", "rad", [](const BodyKinematics& b) { return rpy_from_rotation(b.A)(0); }},
    {"<body>.pitch", "rad", [](const BodyKinematics& b) { return rpy_from_rotation(b.A)(1); }},
    {"<body>.yaw", "rad", [](const BodyKinematics& b) { return rpy_from_rotation(b.A)(2); }}};

inline constexpr Entry<BodyKinematics> kAttitudeEntries[] = {
    {"<body>.wx", "rad/s", [](const BodyKinematics& b) { return b.w.x(); }},
    {"<body>.wy", "rad/s", [](const BodyKinematics& b) { return b.w.y(); }},
    {"<body>.wz", "rad/s", [](const BodyKinematics& b) { return b.w.z(); }},
    {"<body>.qw", "-", [](const BodyKinematics& b) { return b.L(0) / b.L.norm(); }},
    {"<body>.qx", "-", [](const BodyKinematics& b) { return b.L(1) / b.L.norm(); }},
    {"<body>.qy", "-", [](const BodyKinematics& b) { return b.L(2) / b.L.norm(); }},
    {"<body>.qz", "-", [](const BodyKinematics& b) { return b.L(3) / b.L.norm(); }}};

}  // namespace footfall

#pragma once
// A small scene for every kind of joint, strut law, spring, force, drive and controller. A new kind needs its line here:
// the tests of every_kind_test.cpp walk the kinds and fail for a kind that has none.

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace footfall::test {

using KeysOfKind = std::map<std::string, std::string>;  // name of the kind -> its keys

inline const KeysOfKind kJointKeys = {
    {"fixed", "point = [0.5, 0.1, 0]"},
    {"spherical", "point = [0.5, 0.1, 0]"},
    {"universal", "point = [0.5, 0.1, 0]\naxis = [0, 1, 0]\naxis2 = [1, 0, 1]"},
    {"revolute", "point = [0.5, 0.1, 0]\naxis = [1, 2, 3]"},
    {"prismatic", "point = [0.5, 0.1, 0]\naxis = [1, 2, 3]"},
    {"cylindrical", "point = [0.5, 0.1, 0]\naxis = [1, 2, 3]"},
    {"distance", "point_a = [0.5, 0.1, 0]\npoint_b = [0.6, 0.3, 0.2]"},
    {"point_on_plane", "point_a = [0.5, 0.1, 0]\npoint_b = [0.5, 0.3, 0]\naxis = \"z\""},
    {"planar", "point = [0.5, 0.1, 0]\naxis = [1, 2, 3]"},
    {"constant_velocity", "point = [0.5, 0.1, 0]\naxis = [1, 2, 3]"},
    {"rolling", "point_a = [0.5, 0, 0]\npoint_b = [1, 0.2, 0.3]\nradius = 0.3\naxis = \"z\"\naxis2 = [1, 2, 0]"},
    {"prescribed",
     "point = [0.5, 0.1, 0]\naxis = \"y\"\n[joints.motion]\nx = { amplitude = 0.1, frequency = 2 }\n"
     "z = { table = [[0, 0], [0.5, 0.1], [1, 0.1]] }\n"
     "rotation = { polynomial = [0, 1, -0.5] }\nhold_other_rotations = true\n"},
};

// Soft and round, so that differences of their forces are exact to the tolerance of the test.
inline const KeysOfKind kLawKeys = {
    {"gas",
     "gas = { piston_diameter = 0.03, pressure = 1e5, volume = 1e-3 }\nstops = { min = -0.5, max = 1, stiffness = 1e3, "
     "toe = 0.1 }"},
    {"mr", "mr = { yield_force = 20, viscous = 3, regularisation_speed = 0.5, coil_lag = 0.02, voltage = 0.7 }"},
    {"honeycomb",
     "honeycomb = { stages = [{ force = 10, length = 0.2 }, { force = 20, length = 0.2 }], elastic_stiffness = 1e3, "
     "bottom_out_stiffness = 5e2, transition_length = 0.1, toe = 0.05 }"},
    {"stops", "stops = { min = -0.02, max = 0.02, stiffness = 1e3, dissipation = 0.5, toe = 0.1 }"},
    {"spring", "spring = { stiffness = 100, damping = 5, preload = 3 }"},
    {"table", "table = { file = \"" FOOTFALL_SOURCE_DIR "/inputs/reference/rope.csv\" }"},
};

inline const KeysOfKind kSpringKeys = {
    {"torsion", "axis = [1, 2, 3]\nstiffness = 10\ndamping = 1\nrest_angle = 0.2"},
    {"centring", "stiffness = 10\ndamping = 1"},
    {"bushing",
     "point = [0.5, 0.1, 0]\naxis = [1, 2, 3]\naxis2 = [1, 0, 0]\nstiffness = [100, 50, 20]\ndamping = 5\n"
     "turning_stiffness = [10, 5, 2]\nturning_damping = [1, 0.5, 0]"},
};

// By the frame of the direction.
inline const KeysOfKind kForceKeys = {
    {"body",
     "force = { polynomial = [3, 5], amplitude = 4, frequency = 3, phase = 0.3 }\ntorque = { polynomial = [1] }"},
    {"inertial", "force = { polynomial = [5] }\ntorque = { table = [[0, 0], [0.05, 1], [0.2, -1]] }"},
};

// On the angle of a joint that turns about an oblique axis.
inline const KeysOfKind kDriveKeys = {
    {"torque", "command = { polynomial = [0.5, 10] }\nmax_torque = 5\nmax_speed = 300\nefficiency = 0.8"},
    {"speed", "command = { polynomial = [1] }\nkp = 0.05\nki = 0.3\nmax_torque = 50\nmax_speed = 300"},
    {"position",
     "command = { amplitude = 0.3, frequency = 1 }\nkp = 2\nkd = 0.05\nki = 1\nmax_torque = 50\nefficiency = 0.9"},
    {"brake", "command = { polynomial = [0.2, 5] }\nmax_torque = 0.05\nlag = 0.02"},
};

inline const KeysOfKind kControllerKeys = {
    {"constant", "outputs = [\"U1\", \"U2\", \"U3\"]\nvoltages = [0.2, 0.4, 0.6]"},
    {"fuzzy", "outputs = [\"U1\", \"U2\", \"U3\"]\nfile = \"" FOOTFALL_SOURCE_DIR "/inputs/reference/reference.fll\""},
    {"skyhook", "outputs = [\"U1\", \"U2\", \"U3\"]"},
    {"pid", "outputs = [\"U1\", \"U2\", \"U3\"]\nkd = 0.001"},
};

// Each drives a force, continuously where it can.
inline const KeysOfKind kSignalKeys = {
    {"expression", "input = \"-20 * hinge.angle - 3 * hinge.angle_rate + 5 * b.z * a.roll\""},
    {"pid", "input = \"1 - b.x\"\nkp = 20\nki = 10\nkd = 2\nderivative_frequency = 3\nmax = 100"},
    {"lowpass", "input = \"10 * b.vx\"\nfrequency = 2"},
    {"lowpass2", "input = \"10 * hinge.angle\"\nfrequency = 2\ndamping = 0.4\ninitial = 0.3"},
    {"notch", "input = \"10 * a.wy + 3 * time\"\nfrequency = 2"},
    {"rate_limit", "input = \"10 * b.vx\"\nmax_rate = 5\nperiod = 0.01"},
    {"saturation", "input = \"30 * b.vx\"\nmin = -20\nmax = 50"},
    {"table", "input = \"b.x\"\npoints = [[-10, 5], [0, 1], [30, 9]]"},
    {"table2", "input = \"b.x\"\ninput2 = \"b.vx\"\nx = [-9, 9]\nx2 = [-9, 9]\nvalues = [1, 5, -4, 8]"},
    {"fuzzy", "file = \"" FOOTFALL_SOURCE_DIR "/inputs/reference/reference.fll\"\noutput = \"U1\"\n"
              "inputs = [\"2 + 0.1 * b.x\", \"0\", \"b.vx\", \"0\"]"},
    {"fmu", "file = \"" FOOTFALL_SOURCE_DIR "/inputs/reference/engine.fmu\"\noutputs = [\"thrust\"]\n"
            "inputs = { throttle = \"b.x\" }\nperiod = 0.01"},
    {"python", "file = \"" FOOTFALL_SOURCE_DIR "/inputs/reference/autopilot.py\"\nfunction = \"throttle\"\n"
               "inputs = [\"b.x\", \"b.vx\"]\nperiod = 0.01"},
    {"host", "initial = 4"},
};

// Joints of a third body on both, and gears of two and of three coordinates.
const std::string kGears = R"([[bodies]]
name = "c"
mass = 1.5
inertia = [0.07, 0.06, 0.08]
position = [0.3, 0.8, 0.2]
[[joints]]
name = "hinge"
kind = "revolute"
bodies = ["a", "b"]
point = [0.5, 0.1, 0]
axis = [1, 2, 3]
[[joints]]
name = "screw"
kind = "cylindrical"
bodies = ["a", "c"]
point = [0.2, 0.5, 0]
axis = [0, 1, 1]
[[gears]]
name = "thread"
joints = ["screw", "screw", "hinge"]
coordinates = ["displacement", "angle", "auto"]
factors = [2, -0.1, 0.3]
[[gears]]
name = "cam"
joints = ["screw", "hinge"]
coordinates = ["displacement", "angle"]
factors = [1, -0.4]
curve = [[-3.0, 0.2], [-1.2, -0.1], [0.3, 0.4], [1.9, 0.1], [3.2831853, 0.2]]
closed = true
)";

// Two bodies that move and turn against each other.
const std::string kTwoBodies = R"(end_time = 1.0
[[bodies]]
name = "a"
mass = 2.0
inertia = [0.1, 0.2, 0.25]
position = [0, 0, 0]
[[bodies]]
name = "b"
mass = 1.0
inertia = [0.05, 0.06, 0.08]
position = [1, 0.2, 0.3]
[initial]
roll_deg = 20
pitch_deg = -30
angular_velocity = [0.3, -0.5, 0.4]
[[initial.bodies]]
body = "b"
velocity = [0.5, -0.3, 0.8]
angular_velocity = [1, -2, 1.5]
)";

inline std::string keys_of_kind(const KeysOfKind& keys, const std::string& kind) {
  const auto found = keys.find(kind);
  if (found != keys.end()) return found->second;
  ADD_FAILURE() << "no scene for \"" << kind << "\": give it one in tests/unit/assemble/kind_scenes.h";
  return "";
}

inline std::string joint_scene(const std::string& type) {
  return kTwoBodies + "[[joints]]\nname = \"joint\"\nbodies = [\"a\", \"b\"]\nkind = \"" + type + "\"\n" +
         keys_of_kind(kJointKeys, type) + "\n";
}
inline std::string law_scene(const std::string& law) {
  return kTwoBodies +
         "[[struts]]\nname = \"strut\"\nbodies = [\"a\", \"b\"]\npoints = [[0, 0.1, 0], [1, 0.1, 0.3]]\nlength = "
         "1.08\n" +
         keys_of_kind(kLawKeys, law) + "\n";
}
inline std::string spring_scene(const std::string& kind) {
  return kTwoBodies + "[[springs]]\nname = \"spring\"\nbodies = [\"a\", \"b\"]\nkind = \"" + kind + "\"\n" +
         keys_of_kind(kSpringKeys, kind) + "\n";
}
inline std::string force_scene(const std::string& frame) {
  return kTwoBodies + "[[forces]]\nname = \"push\"\nbody = \"b\"\npoint = [1.1, 0.3, 0.2]\ndirection = [1, -2, 2]\n" +
         "frame = \"" + frame + "\"\n" + keys_of_kind(kForceKeys, frame) + "\n";
}
inline std::string drive_scene(const std::string& kind) {
  return kTwoBodies +
         "[[joints]]\nname = \"hinge\"\nkind = \"revolute\"\nbodies = [\"a\", \"b\"]\npoint = [0.5, 0.1, 0]\naxis = "
         "[1, 2, "
         "3]\n"
         "[joints.angle]\nstops = { min = -0.05, max = 0.05, stiffness = 100, dissipation = 0.5, toe = 0.1 }\n"
         "friction = { coulomb = 0.05, breakaway = 0.08, stribeck_speed = 0.5, viscous = 0.1, stick_displacement = 0.1 "
         "}\n"
         "spring = { stiffness = 5, damping = 0.1, rest = 0.1 }\n"
         "[[drives]]\nname = \"motor\"\njoint = \"hinge\"\ngear_ratio = 3\nrotor_inertia = 0.01\nkind = \"" +
         kind + "\"\n" + keys_of_kind(kDriveKeys, kind) + "\n";
}
// Laws, a drive and a gear on the three coordinates of a planar joint.
inline std::string planar_scene() {
  const std::string law =
      "stops = { min = -0.05, max = 0.05, stiffness = 100, dissipation = 0.5, toe = 0.1 }\n"
      "friction = { coulomb = 0.05, breakaway = 0.08, stribeck_speed = 0.5, viscous = 0.1, stick_displacement = 0.1 }\n"
      "spring = { stiffness = 5, damping = 0.1, rest = 0.1 }\n";
  return kTwoBodies +
         "[[joints]]\nname = \"table\"\nkind = \"planar\"\nbodies = [\"a\", \"b\"]\npoint = [0.5, 0.1, 0]\n"
         "axis = [1, 2, 3]\naxis2 = [1, -1, 0.2]\n[joints.angle]\n" +
         law + "[joints.displacement_x]\n" + law + "[joints.displacement_y]\n" + law +
         "[[drives]]\nname = \"motor\"\njoint = \"table\"\ncoordinate = \"displacement_y\"\ngear_ratio = 3\n"
         "rotor_inertia = 0.01\nkind = \"position\"\n" +
         keys_of_kind(kDriveKeys, "position") +
         "\n[[gears]]\nname = \"rack\"\njoints = [\"table\", \"table\"]\n"
         "coordinates = [\"displacement_x\", \"angle\"]\nfactors = [1, -0.3]\n";
}
inline std::string gear_scene() { return kTwoBodies + kGears; }
inline std::string controller_scene(const std::string& kind) {
  return kTwoBodies + "[[controllers]]\nname = \"c\"\nbody = \"a\"\nkind = \"" + kind + "\"\n" +
         keys_of_kind(kControllerKeys, kind) + "\n";
}
inline std::string signal_scene(const std::string& kind) {
  return kTwoBodies +
         "[[joints]]\nname = \"hinge\"\nkind = \"revolute\"\nbodies = [\"a\", \"b\"]\npoint = [0.5, 0.1, 0]\naxis = "
         "[1, 2, 3]\n"
         "[[forces]]\nname = \"push\"\nbody = \"b\"\ndirection = [1, 2, 0]\nforce = { polynomial = [1], signal = \"s\" "
         "}\n"
         "[[signals]]\nname = \"s\"\nkind = \"" +
         kind + "\"\n" + keys_of_kind(kSignalKeys, kind) + "\n";
}

}  // namespace footfall::test

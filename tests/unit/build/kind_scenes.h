#pragma once
// A small scene for every kind of joint, strut law, spring and controller. A new kind needs its line here: the tests of
// every_kind_test.cpp walk the kinds and fail for one that has none.

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
    {"bushing", "point = [0.5, 0.1, 0]\nstiffness = 100\ndamping = 5\nturning_stiffness = 10\nturning_damping = 1"},
};

inline const KeysOfKind kControllerKeys = {
    {"constant", "outputs = [\"U1\", \"U2\", \"U3\"]\nvoltages = [0.2, 0.4, 0.6]"},
    {"fuzzy", "outputs = [\"U1\", \"U2\", \"U3\"]\nfile = \"" FOOTFALL_SOURCE_DIR "/inputs/reference/reference.fll\""},
    {"skyhook", "outputs = [\"U1\", \"U2\", \"U3\"]"},
    {"pid", "outputs = [\"U1\", \"U2\", \"U3\"]\nkd = 0.001"},
};

// Two bodies that move and turn against each other.
inline const std::string kTwoBodies = R"(end_time = 1.0
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
  ADD_FAILURE() << "no scene for \"" << kind << "\": give it one in tests/unit/build/kind_scenes.h";
  return "";
}

inline std::string joint_scene(const std::string& type) {
  return kTwoBodies + "[[joints]]\nname = \"joint\"\nbodies = [\"a\", \"b\"]\ntype = \"" + type + "\"\n" +
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
inline std::string controller_scene(const std::string& kind) {
  return kTwoBodies + "[[controllers]]\nname = \"c\"\nbody = \"a\"\nkind = \"" + kind + "\"\n" +
         keys_of_kind(kControllerKeys, kind) + "\n";
}

}  // namespace footfall::test

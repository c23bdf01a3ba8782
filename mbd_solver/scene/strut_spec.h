#pragma once
// Force elements of a scene: struts (force along the line of two points, a sum of laws) and springs (turning, or
// centring).
// Stroke x = length in the design position (or `length`) - present length: compression positive.
// Defaults are those of the laws.

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "coupler/base/kinds.h"
#include "mbd_solver/model/laws/end_stop.h"
#include "mbd_solver/model/laws/gas_spring.h"
#include "mbd_solver/model/laws/honeycomb.h"
#include "mbd_solver/model/laws/linear_spring_damper.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "mbd_solver/scene/source.h"

namespace footfall {

// F = A_p P0 (V0 / (V0 - A_p x))^exponent [Lin25 13]
struct GasSpec {
  double piston_diameter = 0.0;                      // d_p, A_p = pi d_p^2 / 4 [m] > 0
  double pressure = 0.0;                             // P0 at x = 0 [Pa] > 0
  double volume = 0.0;                               // V0 at x = 0 [m3] > 0
  double exponent = GasSpringParameters{}.exponent;  // [-] > 0
};

// F_y = 3 pi L1 tau_y(U) (D1 + d1) / 2, c = (12 eta L1 / d^2 + 32 eta (L2/D2^2 + L3/D3^2 + L4/D4^2)) pi D3^2 / 4 [Lin25
// 14, 15]
struct MrGeometrySpec {
  double D1 = 0.0, d1 = 0.0, D2 = 0.0, D3 = 0.0;  // bypass, core, first connecting and main cylinder: diameters [m]
  std::optional<double> D4;                       // second connecting cylinder; not given: D2 [m]
  std::optional<double> d;                        // gap; not given: (D1 - d1) / 2 [m]
  double L1 = 0.0, L2 = 0.0, L3 = 0.0, L4 = 0.0;  // wound core, first connecting, main, second connecting: lengths [m]
  double viscosity = 0.0;                         // eta [Pa s]
  std::vector<Eigen::Vector2d> yield_stress;      // (U [-], tau_y [Pa]); U rising from 0 to 1, tau_y never falling
};

// F = U F_y tanh(v / v_s) + c v
struct MrSpec {
  double yield_force = 0.0;  // F_y at U = 1 [N]; from geometry when that is given
  double viscous = 0.0;      // c [N s/m]; likewise
  std::vector<Eigen::Vector2d>
      yield_table;  // (U [-], F_y [N]) instead of yield_force; U rising from 0 to 1, F_y never falling
  double regularisation_speed = MrDamperParameters{}.regularisation_speed;  // v_s [m/s] > 0
  double coil_lag = MrDamperParameters{}.coil_lag;                          // time constant of coil and driver [s] >= 0
  // effective U at the start, with a coil lag [-] in [0, 1]
  double initial_voltage = MrDamperParameters{}.initial_voltage;
  double voltage = 0.0;    // constant U where no controller is named [-] in [0, 1]
  std::string controller;  // "lander.U1": output of a controller; empty: constant
  std::string signal;      // name of a signal that is the voltage, cut to [0, 1]; instead of a controller
  std::optional<MrGeometrySpec> geometry;
};

struct CrushStageSpec {
  double force = 0.0;   // plateau [N] > 0, rising from stage to stage
  double length = 0.0;  // crush length [m] > 0
};

struct HoneycombSpec {
  std::vector<CrushStageSpec> stages;                                 // at least one, softest first
  bool compression = true;                                            // has a cartridge that crushes when pushed
  bool tension = true;                                                // has one that crushes when pulled
  double elastic_stiffness = HoneycombCartridge{}.elastic_stiffness;  // loading and unloading [N/m] > 0
  // past the last stage [N/m], in (0, elastic_stiffness)
  double bottom_out_stiffness = HoneycombCartridge{}.bottom_out_stiffness;
  // over which the plateau passes from stage to stage [m] > 0
  double transition_length = HoneycombCartridge{}.transition_length;
  double toe = HoneycombCartridge{}.toe;  // smoothing of first contact [m] > 0
};

struct StopsSpec {
  std::optional<double> min;                         // smallest stroke, extended end [m]
  std::optional<double> max;                         // largest stroke, compressed end [m]; at least one is needed
  double stiffness = EndStopParameters{}.stiffness;  // [N/m] > 0
  // at approach speed v the force is 1 + dissipation v times the elastic one [s/m] >= 0
  double dissipation = EndStopParameters{}.dissipation;
  double toe = EndStopParameters{}.toe;  // smoothing of first contact [m] > 0
};

// F = preload + stiffness (free_length - present length) + damping v
struct LinearSpringSpec {
  double stiffness = LinearSpringDamperParameters{}.stiffness;  // [N/m] >= 0
  double damping = LinearSpringDamperParameters{}.damping;      // [N s/m] >= 0
  double preload = LinearSpringDamperParameters{}.preload;      // [N]
  std::optional<double> free_length;  // [m]; not given: the strut's undeformed length (F = preload at x = 0)
};

// Passive strut from measurements: force over stroke and rate.
struct TableSpec {
  std::string file;  // CSV: first line a label, then rates [m/s]; further lines a stroke [m], then forces [N]
};

// A law is a member with its section's name and a line in each_law.
struct StrutSpec {
  Source source;
  std::string name;
  std::array<std::string, 2> bodies;  // "ground" is allowed for one
  std::array<Eigen::Vector3d, 2> points{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  // in D [m]
  std::optional<double> length;  // undeformed length [m]; not given: distance of the points in D
  std::optional<GasSpec> gas;
  std::optional<MrSpec> mr;
  std::optional<HoneycombSpec> honeycomb;
  std::optional<StopsSpec> stops;
  std::optional<LinearSpringSpec> spring;
  std::optional<TableSpec> table;
};

// Calls visit("gas", strut.gas), visit("mr", strut.mr), ...: the one list of laws, in the order in which a strut adds
// them up. The binding names every member of the struct, so that a law forgotten here does not compile.
template <class Strut, class Visit>
void each_law(Strut& strut, Visit&& visit) {
  auto& [source, name, bodies, points, length, gas, mr, honeycomb, stops, spring, table] = strut;
  visit("gas", gas);
  visit("mr", mr);
  visit("honeycomb", honeycomb);
  visit("stops", stops);
  visit("spring", spring);
  visit("table", table);
}

enum class SpringKind {
  kTorsion,   // about `axis`, any turns: stiffness [N m/rad] (angle - rest_angle), damping [N m s/rad]
  kCentring,  // turns b back to its design attitude relative to a, up to 175 degrees: same units
  // at `point`: stiffness [N/m], damping [N s/m]; turning: turning_stiffness, turning_damping; each one number, or one
  // for x, y and z of its axes: z = axis, x = axis2
  kBushing
};
constexpr std::string_view name_of(SpringKind kind) {
  switch (kind) {
    case SpringKind::kTorsion: return "torsion";
    case SpringKind::kCentring: return "centring";
    case SpringKind::kBushing: return "bushing";
  }
  return {};
}

struct SpringSpec {
  Source source;
  std::string name;
  SpringKind kind = SpringKind::kTorsion;
  std::array<std::string, 2> bodies;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();              // where it acts, in D [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();              // torsion, bushing; unit vector, fixed in a
  Eigen::Vector3d axis2 = Eigen::Vector3d::UnitX();             // bushing: made perpendicular to axis
  Eigen::Vector3d stiffness = Eigen::Vector3d::Zero();          // see kind; >= 0
  Eigen::Vector3d damping = Eigen::Vector3d::Zero();            // see kind; >= 0
  double rest_angle = 0.0;                                      // torsion [rad]
  Eigen::Vector3d turning_stiffness = Eigen::Vector3d::Zero();  // bushing [N m/rad] >= 0
  Eigen::Vector3d turning_damping = Eigen::Vector3d::Zero();    // bushing [N m s/rad] >= 0
};

}  // namespace footfall

#pragma once
// Force elements of a scene: struts (force along the line of two points, a sum of laws) and springs (torsion, centring,
// bushing). Stroke x = undeformed length - present length: compression positive. The parameters are those of the laws
// themselves, with their defaults.

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/model/elements/bushing.h"
#include "mbd_solver/model/laws/gas_spring.h"
#include "mbd_solver/model/laws/honeycomb.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/scene/source.h"

namespace footfall {

// The law with its voltage U. A scene states the forces itself: the law's own values are not defaults here.
struct MrSpec : MrDamperParameters {
  MrSpec() { yield_force = viscous_coefficient = 0.0; }
  double voltage = 0.0;                // constant U where no controller is named [-] in [0, 1]
  std::string controller;              // "lander.U1": output of a controller that is U; empty: constant
  std::string signal;                  // name of a signal that is U, limited to [0, 1]; instead of a controller
  std::optional<MrGeometry> geometry;  // gives yield_table and viscous_coefficient
};

// One cartridge for each direction, alike.
struct HoneycombSpec : HoneycombCartridge {
  HoneycombSpec() { stages.clear(); }
  bool compression = true;  // has a cartridge that crushes when pushed
  bool tension = true;      // has one that crushes when pulled
};

struct LinearSpringSpec : LinearSpringDamperParameters {
  std::optional<double> free_length;  // [m]; not given: the undeformed length (F = preload at x = 0)
};

// Passive strut from measurements: force over stroke and rate.
struct TableSpec {
  std::string file;  // CSV (table_law.h)
};

// A law is a member with its section's name and a line in each_law.
struct StrutSpec {
  Source source;
  std::string name;
  std::array<std::string, 2> bodies;  // "ground" is allowed for one
  std::array<Eigen::Vector3d, 2> points{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  // in D [m]
  std::optional<double> length;  // undeformed length [m]; not given: distance of the points in D
  std::optional<GasSpringParameters> gas;
  std::optional<MrSpec> mr;
  std::optional<HoneycombSpec> honeycomb;
  std::optional<EndStopParameters> stops;
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
  kTorsion,   // about `axis`, any number of turns: stiffness [N m/rad] (angle - rest_angle), damping [N m s/rad]
  kCentring,  // turns b back to its attitude relative to a in D, up to 175 degrees: same units
  kBushing  // at `point`: stiffness [N/m], damping [N s/m], rotational_stiffness, rotational_damping; each of them one
            // number, or one for x, y and z of its axes: z = axis, x = axis2
};
constexpr std::string_view name_of(SpringKind kind) { return name_in(kind, "torsion", "centring", "bushing"); }

// The inherited stiffnesses and dampings have the units of the kind.
struct SpringSpec : Bushing::Parameters {
  Source source;
  std::string name;
  SpringKind kind = SpringKind::kTorsion;
  std::array<std::string, 2> bodies;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();   // of action, in D [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   // torsion, bushing; unit vector, fixed in a [-]
  Eigen::Vector3d axis2 = Eigen::Vector3d::UnitX();  // bushing: made perpendicular to axis [-]
  double rest_angle = 0.0;                           // torsion [rad]
};

}  // namespace footfall

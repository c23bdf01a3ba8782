#pragma once
// Force elements of a scene: forces as functions of time, struts (a sum of laws along a line), springs, drives. Parameters and
// their defaults belong to the laws themselves.

#include <Eigen/Dense>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/model/elements/bushing.h"
#include "mbd_solver/model/elements/rigid_plane.h"
#include "mbd_solver/model/laws/honeycomb.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/scene/box_spec.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/joint_spec.h"
#include "mbd_solver/scene/terrain_spec.h"

namespace footfall {

enum class ForceFrame {
  kBody,     // the direction is given in D and turns with the body
  kInertial  // the direction is fixed in W; the point moves with the body
};
constexpr std::string_view name_of(ForceFrame kind) { return name_in(kind, "body", "inertial"); }

struct ForceSpec {
  Source source;
  std::string name;
  std::string body;
  std::optional<Eigen::Vector3d> point;                  // in D [m]; not given: the mass centre of a rigid body
  ForceFrame frame = ForceFrame::kBody;                  // of the direction
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit vector
  std::optional<TimeFunctionSpec> force;                 // along the direction [N]
  std::optional<TimeFunctionSpec> torque;                // about the direction [N m]
};

// Force elements of a scene: struts (force along the line of two points, a sum of laws) and springs (torsion, centring,
// bushing). Stroke x = undeformed length - present length: compression positive. The parameters belong to the laws
// themselves, with their defaults.
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
  bool tension = true;      // has a cartridge that crushes when pulled
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

// Where a cable is guided or fastened.
struct CableGuideSpec {
  std::string body;                                 // "ground" is allowed
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // its place, or the centre of the pulley, in D [m]
  double radius = 0.0;                              // of pulley or drum [m]; 0: a point
  std::optional<Eigen::Vector3d> axis;  // of a round: the cable runs round it by the right hand; unit vector in D [-]
  bool grip = false;                    // the cable turns this pulley; the ends always do
  int turns = 0;                        // whole turns more than seen
};

// A massless cable (cable.h).
struct CableSpec {
  Source source;
  std::string name;
  std::vector<CableGuideSpec> path;
  std::optional<double> stiffness;  // [N/m], or
  std::optional<double> EA;         // [N]
  double damping = 0.0;             // [N s/m]
  // In the reference configuration, one of these; none: straight without force.
  std::optional<double> length;   // unstretched, between the ends [m]
  std::optional<double> slack;    // [m]
  std::optional<double> tension;  // [N]

  bool is_round(std::size_t guide) const { return path[guide].radius > 0.0; }
  // Where one cable ends and the next begins: its ends, and the pulleys that it turns.
  std::vector<std::size_t> ends() const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < path.size(); ++i)
      if (i == 0 || i + 1 == path.size() || path[i].grip) out.push_back(i);
    return out;
  }
};

// Neighbours along all cables.
struct CablePair {
  std::array<std::string, 2> bodies;
};
inline std::vector<CablePair> cable_pairs(const std::vector<CableSpec>& cables) {
  std::vector<CablePair> out;
  for (const CableSpec& cable : cables)
    for (std::size_t i = 1; i < cable.path.size(); ++i) out.push_back({{cable.path[i - 1].body, cable.path[i].body}});
  return out;
}

// Boundaries of the mechanism, contacts, and the ground.
// The faces of the generated surface of a disc.
enum class SurfaceFaces { kAuto, kMiddle, kBoth };
constexpr std::string_view name_of(SurfaceFaces kind) { return name_in(kind, "auto", "middle", "both"); }

// Triangles: generated from the body's shape, or read from a file.
struct SurfaceSpec {
  double element_size = 0.0;  // edge length of generated triangles [m]; 0: a tenth of the shape's size
  std::string file;           // STL, OBJ or PLY; empty: from the shape (or the mesh of the flexible body)
  std::string from_script;    // id of a mesh of particles.script, instead of file, scale, position and orientation
  double scale = 1.0;         // metres per unit of the file [-]; scale, then orientation, then position apply
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               // of the file's origin in D [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  // of the file's axes in D
  bool closed = false;                                              // require a watertight surface
  int triangles = 0;  // at most so many of a mesh from a file (fe/decimation.h); 0: as in the file
  // Of a disc. middle: its mid-surface, without thickness. both: closed, with a rim of its thickness.
  // auto: the mid-surface of a flexible one, which is its finite-element mesh; both faces of a rigid one.
  SurfaceFaces faces = SurfaceFaces::kAuto;
};

// A chain of round segments along the body's axis (tube, rod), or along the given points.
struct BeamsSpec {
  double radius = 0.0;                  // [m]; 0: half the diameter of the shape
  int segments = 1;                     // along a shape's axis
  std::vector<Eigen::Vector3d> points;  // chain in D [m]; empty: the shape's axis
};

// One per body at most: surface, beams, or both.
struct BoundarySpec {
  Source source;
  std::string body;
  std::optional<SurfaceSpec> surface;
  std::optional<BeamsSpec> beams;
};

enum class GroundKind { kNone, kPlane, kParticles, kSoil };
constexpr std::string_view name_of(GroundKind kind) { return name_in(kind, "none", "plane", "particles", "soil"); }

// Law of a contact point (theory 6.4): f_n = k delta^1.5 g(d delta'), friction mu f_n while it slides, a spring while it
// sticks. With friction_speed: mu f_n v_t / sqrt(v_t^2 + friction_speed^2), without springs.
// k = stiffness, or by Hertz from young: 4/3 young / (1 - poisson^2) sqrt(contact_radius). d = damping, or from
// restitution.
struct ContactLawSpec {
  std::optional<double> young;                          // [Pa]
  double poisson = 0.3;                                 // [-]
  double contact_radius = 0.02;                         // of each node [m]
  std::optional<double> stiffness;                      // k of each node, instead of young [N/m^1.5]
  std::optional<double> restitution;                    // [-] in (0, 1], at impact_speed
  std::optional<double> impact_speed;                   // [m/s] > 0; not given: the initial velocity
  std::optional<double> damping;                        // d, instead of restitution [s/m]
  double friction = RigidPlane::Parameters{}.friction;  // [-] >= 0
  std::optional<double> friction_speed;                 // not given: true stick; else it creeps [m/s] > 0
};

struct PlaneSpec : ContactLawSpec {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // in W [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // out of the ground, unit vector in W
  std::vector<std::string> bodies;                    // whose boundaries touch it; empty: all
};

inline constexpr const char* kPlaneWord = "plane";  // in ContactSpec::between

// Contact of two bodies with boundaries, of one and a plane, or of all and the script's walls.
struct ContactSpec : ContactLawSpec {
  Source source;
  std::vector<std::string> between;                   // two bodies, or a body and "plane"; empty with walls
  bool walls = false;                                 // planes and static meshes of the LIGGGHTS script
  std::vector<std::string> bodies;                    // with walls: which boundaries; empty: all
  bool ignore = false;                                // the two pass through each other without a warning
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // of the plane, in W [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // of the plane, to the side of the body, unit vector in W [-]
  bool with_plane() const { return between.size() == 2 && between[1] == kPlaneWord; }
};

enum class SoilLawKind { kRft, kPressureSinkage };
constexpr std::string_view name_of(SoilLawKind kind) { return name_in(kind, "rft", "pressure_sinkage"); }

// A soil without grains (theory 6.7). Numbers that are not given come from ground.soil.
struct SoilSpec {
  SoilLawKind kind = SoilLawKind::kRft;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // of the undisturbed ground, in W [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // out of the ground, unit vector in W
  std::vector<std::string> bodies;                    // whose boundaries touch it; empty: all
  double density = 1500.0;                            // of the bulk [kg/m3] > 0
  double inertia = 1.0;                               // of the part that grows with the square of the speed >= 0
  double speed_resistance = 0.0;                      // of the part that grows with speed and depth [Pa s/m2] >= 0
  std::optional<double> speed_depth;  // beyond which that part grows no more; not given: everywhere [m] > 0
  std::optional<double> fitted_speed, fitted_depth;  // up to which the numbers hold [m/s], [m] > 0; not given: unknown
  double cohesion = 0.0;                             // [Pa] >= 0
  double friction = 0.6;                             // tangent of the internal angle > 0
  std::optional<double> surface_friction;            // of boundaries on the soil; not given: as rough as the soil
  double rebound = 1e-3;                             // way of unloading [m] > 0
  double damping = 3.0;                              // of the elastic ground [s/m] >= 0
  std::optional<double> resistance;                  // rft: not given: from density, friction and gravity [Pa/m] > 0
  std::optional<double> gravity;             // rft: at which resistance was measured; not given: the scene's [m/s2] > 0
  double cohesive_modulus = 0.0;             // pressure_sinkage: k_c [Pa/m^(n-1)] >= 0
  std::optional<double> frictional_modulus;  // pressure_sinkage: k_phi [Pa/m^n] >= 0
  double exponent = 1.0;                     // pressure_sinkage: n > 0
  std::optional<double> width;               // pressure_sinkage: b; not given: the smaller side of the boundary [m] > 0
  std::optional<double> shear_length;        // pressure_sinkage: K [m] > 0
};

struct GroundSpec {
  Source source;
  GroundKind kind = GroundKind::kNone;
  std::optional<PlaneSpec> plane;      // needed by kind = "plane"; ignored (but checked) otherwise
  std::string soil;                    // numbers of `law` from inputs/grounds/NAME.toml, or from a file
  std::optional<SoilSpec> law;         // needed by kind = "soil", here or from `soil`
  std::optional<TerrainSpec> terrain;  // the surface of each kind; a level or tilted one becomes point and normal below

  // The surface is more than a plane.
  bool is_uneven() const { return terrain && !terrain->is_plane(); }
  // A plane or a soil: the surface at the start; of an uneven one the plane z of terrain.position.
  bool is_flat() const { return kind == GroundKind::kPlane || kind == GroundKind::kSoil; }
  const Eigen::Vector3d& point() const { return kind == GroundKind::kSoil ? law->point : plane->point; }
  const Eigen::Vector3d& normal() const { return kind == GroundKind::kSoil ? law->normal : plane->normal; }
  const std::vector<std::string>& bodies() const { return kind == GroundKind::kSoil ? law->bodies : plane->bodies; }
};

// The bed: made once by a script of its own, cached as a restart file.
struct BedSpec {
  std::string script;                            // LIGGGHTS script that writes the restart file ${bed}
  std::map<std::string, std::string> variables;  // -var name value for that script
};

struct ParticlesSpec {
  Source source;
  std::string script;  // LIGGGHTS script of the coupled run; gets -var out DIR, -var bed FILE, and:
  std::map<std::string, std::string> variables;  // -var name value
  int ranks = 2;                                 // LIGGGHTS processes
  std::string soil;                              // numbers of the box from inputs/soils/NAME.toml
  std::optional<BedSpec> bed;                    // none: the script makes or reads its own particles
  std::optional<BoxSpec> box;                    // instead of both scripts, which are then taken from inputs/box
  std::string
      grains;  // text dump (x y z radius) of the grains at the start, set by `footfall run`: clearance counts from
               // the highest grain under the boundaries
  std::optional<double> surface_height;  // instead of grains: height of the bed's surface [m]
  bool outflow = false;                  // grains are meant to leave the box, however many
  double max_time_step =
      1e-4;  // of DEM [s]; larger steps give wrong results on this soil long before they are unstable
};

}  // namespace footfall

#pragma once
// The mechanism of a scene, ready for a run: the model, the parts that may touch the ground, and the controllers of struts.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupler/messages.h"
#include "coupler/modal_boundary.h"
#include "mbd_solver/base/name_index.h"
#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/model/control/controllers.h"
#include "mbd_solver/model/control/fuzzy.h"
#include "mbd_solver/model/control/signal_blocks.h"
#include "mbd_solver/model/elements/rigid_plane.h"
#include "mbd_solver/model/elements/surface_contact.h"
#include "mbd_solver/model/elements/terrain_contact.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/terrain.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

class AppliedForce;
class JointForce;

// The ground under one boundary at the start, for the time of its flight: no grain within `stray` of its outline is higher.
struct LandingSite {
  double height = 0.0;                          // along up [m]
  double stray = 0.0;                           // how far its points may leave the outline [m]
  Eigen::Vector3d r = Eigen::Vector3d::Zero();  // Bo [m] and attitude of its body at the start
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();
};

// The frame D of the reference configuration in the inertial frame W at the start: p_W = p_WD + R_WD p_D.
struct Placement {
  Eigen::Matrix3d R_WD = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_WD = Eigen::Vector3d::Zero();  // [m]
  bool ground_known = false;                       // the scene gives the height of the ground
  double ground_height = 0.0;                      // of plane or highest grain under the boundaries, along up [m]
  double bed_height = 0.0;                         // of grains likewise, along the coordinate axis nearest to up [m]
  int lowest = -1;                                 // boundary with the smallest gap to the ground; -1: unknown
  std::vector<LandingSite> sites;                  // per boundary, where each grain is known; else empty

  Eigen::Vector3d point(const Eigen::Vector3d& p_D) const { return p_WD + R_WD * p_D; }
};

// The coordinate axis, with its sign, that is nearest to `up`: out of a bed of grains, which lies level in its box.
inline Eigen::Vector3d axis_towards(const Eigen::Vector3d& up) {
  Eigen::Index k = 0;
  up.cwiseAbs().maxCoeff(&k);
  return (up(k) < 0.0 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(k);
}

// The boundary of one body. Without points and rims: ground.plane.bodies excludes it.
struct BodyBoundary {
  int body = 0;                      // index in the scene and the model
  ModalBoundary boundary;            // nodes in B of the undeformed body: for grains and pictures
  std::vector<ContactPoint> points;  // on the body: the nodes, each with the radius of the beams that end there
  std::vector<ContactRim> rims;  // of a rigid rod, tube, disc or cylinder, which touches a plane exactly, not by its
                                 // nodes (a sphere: its centre is the point)
};

// Fills points and rims, with which the body touches a plane. spec: its entry; null: the entry in the scene.
void add_plane_places(const Scene& scene, const Body& body, BodyBoundary& entry, const BoundarySpec* spec = nullptr);
// The sphere or capsule of a rigid boundary; null where its nodes are the surface.
const ShapeSpec* round_shape(const Scene& scene, const BodyBoundary& entry);
// The points with which a body touches meshes and other bodies: one for a sphere, two for a capsule, else the nodes.
std::vector<ContactPoint> contact_places(const Scene& scene, const Body& body, const BodyBoundary& entry);

// Lowest point of a boundary along the unit vector n_B (in body axes), from Bo [m], with the modal coordinates a; infinity
// without points and rims.
double lowest_place(const BodyBoundary& entry, const Eigen::Vector3d& n_B, const Eigen::VectorXd& a);

struct CableEntry {
  std::string name;  // with ".1", ".2", ... of the parts between pulleys that a cable turns
  Handle<Cable> force;
};

// A pulley that a cable turns, and so divides the cable: it never leaves the pulley.
struct GripEntry {
  std::string name;             // for messages
  Handle<Cable> before, after;  // the two parts
  double wrap = 0.0;  // in the reference configuration; it grows by the first angle of `after` and falls by the
                      // last one of `before` [rad]
};
inline constexpr double kLeastWrap = 1e-6;  // below minus this a cable would leave the pulley [rad]

struct StrutEntry {
  std::string name;
  Handle<Strut> force;
};

// A coordinate of a joint of the scene: body b relative to body a, zero in the reference configuration.
struct CoordinateEntry {
  std::string name;  // of the joint
  int joint = 0;     // index in the model
  Coordinate coordinate = Coordinate::kAngle;
};

struct DriveEntry {
  std::string name;
  Handle<JointForce> force;
  Coordinate coordinate = Coordinate::kAngle;
};

struct GearEntry {
  std::string name;
  int joint = 0;                               // index in the model of the first of its joints
  Coordinate coordinate = Coordinate::kAngle;  // of that
};

struct ControllerEntry {
  std::string name;
  std::unique_ptr<Controller> controller;
  int body = 0;  // whose motion is measured
  // Its outputs are 0 until `touchdown_delay` after the upward acceleration has first exceeded `touchdown_acceleration`.
  double touchdown_acceleration = 0.0;                        // [m/s2]
  double touchdown_delay = 0.0;                               // [s]
  double wakes_at = std::numeric_limits<double>::infinity();  // [s]; minus infinity: from the start
  int first_input = 0;                                        // place of its first output among the inputs
  std::vector<int> struts;  // for each output the strut it drives (index into Mechanism::struts), -1 for none
  std::vector<std::string> outputs;
};

// A contact of a body with the ground, a plane or the script's walls, or with another body.
struct ContactEntry {
  Handle<ContactElement> force;
  // For walls: their surface, empty until they are known; and the points of the body. Else null and none.
  std::shared_ptr<SurfaceSeen> walls;
  std::vector<ContactPoint> places;
};

// A body without boundary that the ground holds where it goes `below` its surface (build_hulls.cpp).
struct HullEntry {
  int body = 0;
  double below = 0.0;  // [m]
};
inline constexpr double kHullDepth = 0.05;  // of the size of a body: less deep is no touch

// Of a body that has a shape, but no boundary, on a plane or soil.
struct UnheldShape {
  double size = 0.0;                     // largest distance of a point from the mass centre [m]
  std::vector<Eigen::Vector3d> outline;  // in the axes of the body, from its mass centre [m]
};

// A signal or a state of the scene, and the place of its value among the inputs of a run.
struct PlaceEntry {
  std::string name;
  int place = 0;
};

struct Mechanism {
  Mechanism(Placement placed, const Eigen::Vector3d& gravity) : placement(std::move(placed)), model(gravity) {}

  Placement placement;
  Model model;
  std::vector<BodyBoundary> boundaries;
  std::vector<StrutEntry> struts;
  std::vector<CableEntry> cables;
  std::vector<GripEntry> grips;
  std::vector<Handle<AppliedForce>> forces;  // one per force of the scene
  std::vector<ContactEntry> contacts;        // all, by kind; a body may have several of one kind
  std::vector<HullEntry> hulls;
  std::shared_ptr<const Terrain> terrain;  // null: the ground is a plane, grains, or none
  std::vector<ControllerEntry> controllers;
  std::vector<CoordinateEntry> coordinates;
  std::vector<DriveEntry> drives;
  Eigen::VectorXd inputs;  // at the start: outputs of controllers, signals and states, constants of struts [-]
  std::vector<std::string> warnings;
  std::vector<GearEntry> gears;
  std::vector<PlaceEntry> signals;
  std::vector<PlaceEntry> states;  // 1 in this state of the scene, else 0
  NameIndex signal_index, state_index, coordinate_index, strut_index;
  int state_since = -1;             // place of the time at which the present state began [s]; -1: no states
  std::vector<SignalNode> sampled;  // signals with a period, for the run

  bool has(ContactKind kind) const;  // a contact of this kind
};

// Throws InputError if the scene cannot be built (a basis that does not exist, a gas compressed to nothing, ...).
Mechanism build_mechanism(const Scene& scene);

// ---- the steps of build_mechanism ----

// Adds an input with this value at the start; returns its place.
int add_input(Mechanism& mechanism, double value);

// A flexible body before placement: reduced model with origin p_DBo, axes of D.
struct FlexibleBody {
  std::shared_ptr<const ModalBody> modal;
  Eigen::Vector3d p_DBo = Eigen::Vector3d::Zero();
};
// One entry per body of the scene; `modal` is null for rigid bodies. Warnings are appended.
std::vector<FlexibleBody> build_flexible_bodies(const Scene& scene, std::vector<std::string>& warnings);

// Adds a contact to the model and the list, behind the contacts of its kind.
void add_contact(std::unique_ptr<ContactElement> element, Mechanism& mechanism,
                 std::shared_ptr<SurfaceSeen> walls = nullptr, std::vector<ContactPoint> places = {});

// The walls of the script, at the beginning of a coupled run and whenever some are removed. Throws InputError if a body is
// on both sides of a wall that should hold it.
void set_walls(const std::vector<StaticWall>& walls, Mechanism& mechanism);

// The boundary of each entry of scene.boundaries, in the order of the scene.
std::vector<BodyBoundary> build_boundaries(const Scene& scene, const std::vector<FlexibleBody>& flexible,
                                           std::vector<std::string>& warnings);

// The boundary of one entry, with its places on plane and uneven ground.
BodyBoundary build_boundary(const Scene& scene, const BoundarySpec& spec, const FlexibleBody& flexible,
                            std::vector<std::string>& warnings);

// The surface of uneven ground; null: it is a plane, or the scene has none.
std::shared_ptr<Terrain> build_terrain(const Scene& scene);
// The field of a terrain that shapes a bed of [particles.box], without rocks; null: the bed has none.
std::shared_ptr<Terrain> build_bed_surface(const Scene& scene);
// The distance along -z that a rigid body at r can fall before its boundary touches the ground, or rocks [m].
double fall_to(Terrain& terrain, const BodyBoundary& entry, const Eigen::Vector3d& r, const Eigen::Matrix3d& R_WB);
double fall_to_rocks(const std::vector<Terrain::Sphere>& rocks, const BodyBoundary& entry, const Eigen::Vector3d& r,
                     const Eigen::Matrix3d& R_WB);

// R_WD and p_WD from [initial]: attitude about the total mass centre, then clearance above the ground.
Placement place(const Scene& scene, const std::vector<BodyBoundary>& boundaries,
                const std::vector<FlexibleBody>& flexible, Terrain* terrain = nullptr);

void add_bodies(const Scene& scene, const std::vector<FlexibleBody>& flexible, Mechanism& mechanism);
void add_joints(const Scene& scene, Mechanism& mechanism);
void add_drives(const Scene& scene, Mechanism& mechanism);  // after add_joints
void add_gears(const Scene& scene, Mechanism& mechanism);   // after add_joints
void add_struts(const Scene& scene, Mechanism& mechanism);  // after add_controllers
void add_cables(const Scene& scene, Mechanism& mechanism);
void add_springs(const Scene& scene, Mechanism& mechanism);
void add_forces(const Scene& scene, Mechanism& mechanism);
void add_plane(const Scene& scene, Mechanism& mechanism);
// One boundary on the rigid plane, uneven rigid ground (terrain) or the rocks in a soil, as the scene has it; nothing on a soil
// without rocks. below: how much lower than the scene's the plane lies [m]; a hull then has no springs of stick.
void add_plane_contact(const Scene& scene, const BodyBoundary& entry, const std::string& prefix, double below,
                       std::shared_ptr<const Terrain> terrain, Mechanism& mechanism);
// A boundary on a soil that lies lower by `below` [m], on this terrain; null: a plane.
struct SoilSurface {
  const BodyBoundary* entry = nullptr;
  double below = 0.0;
  std::shared_ptr<const Terrain> terrain;
};
void add_soil_contacts(const Scene& scene, Mechanism& mechanism);
void add_soil_contacts(const Scene& scene, const std::vector<SoilSurface>& surfaces, const std::string& prefix,
                       Mechanism& mechanism);
std::optional<UnheldShape> unheld_shape(const Scene& scene, const BodySpec& spec);  // none: it is held, or has no shape
void add_hulls(const Scene& scene, const std::vector<FlexibleBody>& flexible, Mechanism& mechanism);
void add_contacts(const Scene& scene, Mechanism& mechanism);
void add_controllers(const Scene& scene, Mechanism& mechanism);
void add_signal_places(const Scene& scene, Mechanism& mechanism);  // before the forces that they command
void add_signals(const Scene& scene, Mechanism& mechanism);        // after the parts that they measure

// The mass, or moment of inertia, that a joint coordinate moves: an estimate from above, for the damping of stick in joints. In
// the reference configuration, all other joints locked: the smaller of both sides of the joint [kg or kg m2], including the
// contributions of gears and rotors on the coordinate. In a loop all bodies. > 0.
double moved_mass(const Scene& scene, const Mechanism& mechanism, int joint, Coordinate coordinate);

// Contacts that throw bodies higher than they are large, because they overlap at the start.
void warn_of_overlaps(const Scene& scene, Mechanism& mechanism);

// Where the value of a name is found among the inputs of a run, or the time; nothing for other names.
std::optional<SignalSource> signal_source(const Mechanism& mechanism, const std::string& name);
// The sensor of a position or velocity of bodies, joints or struts, or of a cable; null for other names.
std::unique_ptr<Sensor> sensor_of(const Mechanism& mechanism, const std::string& name);
// Signals that are evaluated together, in order. Throws InputError with the place of the signals in the scene.
SignalChain chain_of_signals(const Scene& scene, std::vector<SignalNode> nodes);
// One node per event of the scene, in its order: its input is the condition.
std::vector<SignalNode> conditions_of(const Scene& scene);
// The place of a signal of this name; -1 for an empty name.
int signal_place(const Mechanism& mechanism, const std::string& name);
// "FILE:LINE: signals.NAME: " of the first signal or event that reads the name.
std::string where_read(const Scene& scene, const std::string& name);

// Origin and axes of a body in D: the mass centre and R_DB of a rigid body, p_DBo and I of a flexible one.
Eigen::Vector3d origin_D(const BodySpec& body, const FlexibleBody& flexible);
Eigen::Matrix3d axes_D(const BodySpec& body, const FlexibleBody& flexible);

// A fuzzy system as a signal.
class FuzzyBlock final : public SignalBlock {
 public:
  FuzzyBlock(const FllText& rules, std::size_t inputs, const std::string& output)
      : function_(rules, inputs, output), inputs_(static_cast<int>(inputs)) {}
  int input_count() const override { return inputs_; }
  double value(const BlockValues& u, const BlockValues&) const override { return function_.value(u); }
  std::unique_ptr<SignalBlock> copy() const override { return std::make_unique<FuzzyBlock>(*this); }

 private:
  FuzzyFunction function_;
  int inputs_;
};

}  // namespace footfall

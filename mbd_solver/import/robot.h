#pragma once
// A robot in one form for all file formats: the readers fill it, tidy_robot() completes it, and write_robot_scene()
// writes it. D is the reference configuration, in which the scene describes the mechanism; L the frame of a link; G
// the frame of a geometry. In D the robot has each joint at RobotCoordinate::zero.

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/fe/triangle_mesh.h"

namespace footfall {

// A place in the files of the robot.
struct Origin {
  std::string file;  // as the user named it, or included by that
  int line = 0;
  std::string place() const { return file + ":" + std::to_string(line); }
};

// A part of the file that is not in the scene, or differs from the file.
struct NotTaken {
  Origin origin;
  std::string what;    // "transmission \"t1\""
  std::string why;     // the replacement in the scene, or the remedy
  bool looks = false;  // of pictures alone: does not change the motion
};

// A rotation and a displacement: x_A = R_AB x_B + p_AB.
struct RigidFrame {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();      // [m]
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // [-]
  RigidFrame operator*(const RigidFrame& other) const { return {p + R * other.p, R * other.R}; }
  Eigen::Vector3d operator*(const Eigen::Vector3d& x) const { return p + R * x; }
  RigidFrame inverse() const { return {-(R.transpose() * p), R.transpose()}; }
};

enum class GeometryKind { kBox, kSphere, kCylinder, kCapsule, kMesh };

struct RobotGeometry {
  Origin origin;
  std::string name;
  GeometryKind kind = GeometryKind::kBox;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();   // box: edges; mesh of an ellipsoid: axes; along the axes of G [m]
  double radius = 0.0;                              // sphere, cylinder, capsule [m]
  double length = 0.0;                              // cylinder, capsule: along z of G, without round ends [m]
  std::string file;                                 // mesh: where it is on this machine
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();  // mesh: m per unit of the file [m]
  TriangleMesh mesh;                                // mesh: in G; empty: the mesh of the file
  RigidFrame X_LG;
};

// A shape without volume, as files have for links that touch nothing.
bool is_empty(const RobotGeometry& geometry);

struct RobotLink {
  Origin origin;
  std::string name, label;                            // label: as the file names it, after tidy_robot()
  double mass = 0.0;                                  // [kg]; 0: not given
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   // mass centre in L [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the mass centre, in axes of L [kg m2]
  RigidFrame X_DL;                                    // in the reference configuration D
  // At the start, of the origin of L; both or none. In axes of D [m/s, rad/s].
  std::optional<Eigen::Vector3d> velocity, angular_velocity;
  std::vector<RobotGeometry> collisions, visuals;
  std::optional<double> friction;  // of its surface [-]
  std::string remark;              // for the scene: the links merged into it
};

enum class RobotJointKind { kFixed, kRevolute, kPrismatic, kCylindrical, kPlanar, kSpherical, kUniversal };

// One coordinate of a joint: an angle [rad] or a displacement [m].
struct RobotCoordinate {
  std::string name;                    // "angle", "displacement", "displacement_x", "displacement_y"
  double zero = 0.0;                   // the file's coordinate in the reference configuration
  std::optional<double> lower, upper;  // the file's coordinates
  double damping = 0.0;                // [N m s/rad]
  double friction = 0.0;               // [N m]
  double stiffness = 0.0;              // [N m/rad]
  double rest = 0.0;                   // of this spring: the file's coordinate
  double armature = 0.0;               // [kg m2]
  double effort = 0.0;                 // largest torque of a motor [N m]; 0: not given
  bool without_effort = false;         // the file gives 0: no motor can move it
  double speed = 0.0;                  // its largest speed [rad/s]; 0: not given
  std::optional<double> start;         // the file's coordinate at the start
};

struct RobotJoint {
  Origin origin;
  std::string name, label;
  RobotJointKind kind = RobotJointKind::kFixed;
  int parent = -1, child = -1;                       // links; -1: the ground
  Eigen::Vector3d point = Eigen::Vector3d::Zero();   // in D [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   // in D; planar: normal of the plane
  Eigen::Vector3d axis2 = Eigen::Vector3d::UnitX();  // universal: fixed in the child; planar: x
  std::vector<RobotCoordinate> coordinates;          // of revolute, prismatic, cylindrical, planar
  bool loop = false;                                 // closes a loop of the tree
  std::string remark;
};

struct RobotGear {
  Origin origin;
  std::string name, label;
  std::vector<int> joints;
  std::vector<std::string> coordinates;
  std::vector<double> factors;
  std::vector<Eigen::Vector2d> curve;  // of the last coordinate
};

enum class RobotDriveKind { kTorque, kSpeed, kPosition };

struct RobotDrive {
  Origin origin;
  std::string name, label;
  RobotDriveKind kind = RobotDriveKind::kTorque;
  int joint = -1;
  std::string coordinate;
  double command = 0.0;  // of a position: the file's coordinate
  double kp = 0.0, kd = 0.0;
  std::optional<double> max_torque;
  double max_speed = 0.0;  // 0: no limit
  double rotor_inertia = 0.0;
  std::string remark;
};

// Heights of the ground on a level grid: row k at the k-th place along y.
struct RobotMap {
  Origin origin;
  std::string label;
  Eigen::VectorXd x, y;     // places [m]
  Eigen::MatrixXd heights;  // [m]
};

struct Robot {
  std::string name, format, file;
  std::string drawn;                                           // at which coordinates; empty: zero
  Eigen::Vector3d gravity = Eigen::Vector3d(0.0, 0.0, -9.81);  // [m/s2]
  std::vector<RobotLink> links;
  std::vector<RobotJoint> joints;
  std::vector<RobotGear> gears;
  std::vector<RobotDrive> drives;
  std::vector<std::pair<int, int>> apart;  // links that do not touch each other
  bool touches_itself = false;             // all other pairs of links do
  bool plane = false;                      // the file has a floor at z = plane_height
  double plane_height = 0.0;               // [m]
  std::optional<double> plane_friction;
  std::optional<RobotMap> map;  // the file has a height field: it is the ground
  std::vector<NotTaken> not_taken;

  // Adds the geometry to the surfaces of the link, or lists one without volume.
  void add_geometry(RobotLink& link, RobotGeometry geometry, bool collides);
  void leave_out(const Origin& origin, const std::string& what, const std::string& why, bool looks = false) {
    not_taken.push_back({origin, what, why, looks});
  }
};

struct ImportOptions {
  std::string ground;                 // "", "plane", "grains", or a soil
  bool merge_fixed = false;           // links with fixed joints become one body
  bool fix_base = false;              // the root is fixed to the ground
  bool hold = false;                  // joints without a motor are held where they start, by gains of this program
  bool host = false;                  // a program that controls the run sets the commands of motors
  bool bare = false;                  // without surfaces
  std::vector<std::string> packages;  // folders in which package:// and model:// are looked for
};

// The remark on an effort of 0, which many programs write if no effort is known.
inline constexpr const char* kWithoutEffort =
    "effort is 0, a motor without torque or force: --hold gives this joint no motor, and it moves freely; write its "
    "largest torque or force there";

// --- Readers: one per format; one file includes each library. All throw InputError with file and line.

Robot read_urdf(const std::string& file, const ImportOptions& options);
Robot read_sdf(const std::string& file, const ImportOptions& options);  // with FOOTFALL_SDFORMAT only
Robot read_mjcf(const std::string& file, const ImportOptions& options);
// By the root element of the file.
Robot read_robot(const std::string& file, const ImportOptions& options);

// --- Common parts of all formats.

// Links without mass join their neighbours, inertias become possible for real bodies, options are carried out; each
// change is in not_taken.
void tidy_robot(Robot& robot, const ImportOptions& options);

// Adds mass, centre and inertia of a homogeneous solid to the link, density [kg/m3]. Throws InputError if a mesh
// encloses no volume.
void add_solid(RobotLink& link, const RobotGeometry& solid, double density);

// The links that the joints of a robot move, computed once.
class MovedInertias {
 public:
  explicit MovedInertias(const Robot& robot);
  // Inertia of everything beyond the joint about its axis (or the mass, of a displacement) [kg m2, kg].
  double beyond(const RobotJoint& joint, bool slides) const;

 private:
  struct Sum {
    double mass = 0.0;                                  // [kg]
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();   // about the origin of D [kg m]
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the origin of D [kg m2]
    void operator+=(const Sum& other) {
      mass += other.mass;
      moment += other.moment;
      inertia += other.inertia;
    }
  };
  std::vector<Sum> beyond_;  // of each link with all that it carries
};

// The triangles of a geometry in G, without defects that a surface must not have. Throws InputError.
TriangleMesh geometry_mesh(const RobotGeometry& geometry);

// "package://NAME/PATH", "model://NAME/PATH", "file://PATH" or a path relative to the robot's file; empty where there is no such
// file.
std::string find_mesh(const std::string& uri, const std::string& robot_file, const ImportOptions& options);

// Folder of the model that an <include> of SDF names, or its file; empty where there is none.
std::string find_model(const std::string& uri, const std::string& robot_file, const ImportOptions& options);

// Files of the scene: name relative to its folder, and content.
struct SceneFile {
  std::string name, content;
};
// A bed of about 6000 grains.
struct RobotBed {
  Eigen::Vector2d size = Eigen::Vector2d::Zero(), centre = Eigen::Vector2d::Zero();  // along x and y [m]
  double depth = 0.0;                                                                // [m]
  double radius() const;                                                             // of its grains [m]
};
// `bed`: of --ground; otherwise one below the whole robot.
std::vector<SceneFile> write_robot_scene(Robot& robot, const ImportOptions& options,
                                         const std::optional<RobotBed>& bed = std::nullopt);

// Parts that are not converted, in the order of the file; parts of one kind and with one reason are one line.
// `looks`: including parts for pictures alone; `names_only`: files without their folders, and all lines of a group.
std::vector<std::string> not_taken_lines(const Robot& robot, bool looks, bool names_only);

}  // namespace footfall

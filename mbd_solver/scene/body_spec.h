#pragma once
// Bodies and materials of a scene. After reading, mass, inertia, position and orientation of every body are known, given as
// numbers or calculated from shape and material.

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/fe/material.h"
#include "mbd_solver/fe/matrix_model.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {

struct MaterialSpec : Material {
  Source source;
  std::string name;
  double yield_stress = 0.0;  // [Pa]; 0: unknown, no warning when it is exceeded
};

enum class ShapeKind { kBox, kTube, kRod, kDisc, kDish, kSphere, kCylinder, kCapsule, kMesh, kPoints };
constexpr std::string_view name_of(ShapeKind kind) {
  return name_in(kind, "box", "tube", "rod", "disc", "dish", "sphere", "cylinder", "capsule", "mesh", "points");
}

// Geometry in D. It gives mass properties, a boundary surface, and the elastic model (tube, rod: beam; disc, dish: plate).
struct ShapeSpec {
  ShapeKind kind = ShapeKind::kBox;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    // box, disc, sphere, cylinder; dish: its lowest point [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     // disc, dish: normal; the dish opens along it; cylinder [-]
  Eigen::Vector3d from = Eigen::Vector3d::Zero();      // tube, rod: first end; capsule: centre of its round end [m]
  Eigen::Vector3d to = Eigen::Vector3d::Zero();        // the second end [m]
  Eigen::Vector3d size = Eigen::Vector3d::Zero();      // box: edges along the body's axes [m]
  double diameter = 0.0;                               // tube, rod, capsule: outer [m]
  double wall = 0.0;                                   // tube [m]
  double radius = 0.0;                                 // disc, dish (of the rim), sphere, cylinder [m]
  double length = 0.0;                                 // cylinder: along its axis [m]
  double thickness = 0.0;                              // disc, dish [m]
  double depth = 0.0;                                  // dish: height of the rim above the lowest point [m]
  std::vector<Eigen::Vector3d> points;                 // points: equal point masses [m]
  std::string file;                                    // mesh: closed, STL, OBJ or PLY; placed by x -> R scale x + p
  double scale = 1.0;                                  // mesh: metres per unit of the file [-]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // mesh: p, of the file's origin in D [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  // mesh: R, of the file's axes in D
};

// Cross section of the members of a frame: tube (diameter, wall), or four numbers.
struct SectionSpec {
  std::string name;
  double diameter = 0.0;   // outer [m]; 0: the numbers below are given
  double wall = 0.0;       // [m]; 0 with a diameter: solid
  double area = 0.0;       // [m2]
  double bending_y = 0.0;  // second moment of area about the member's y axis [m4]
  double bending_z = 0.0;  // [m4]
  double torsion = 0.0;    // torsion constant [m4]
};

struct MemberSpec {
  int first = 0;  // index into FlexibleSpec::nodes, from 0
  int second = 0;
  std::string section;
  int elements = 1;  // beam elements of the member
};

constexpr std::string_view name_of(BasisKind kind) { return name_in(kind, "craig_bampton", "free_free"); }

struct FlexibleSpec {
  bool enabled = true;  // false: rigid
  BasisKind basis = BasisKind::kCraigBampton;
  std::optional<int> modes;  // in addition to the static shapes; 0: rigid; not given: all below max_frequency, or 10
  std::optional<double> max_frequency;    // modes above it are omitted [Hz]
  double damping = kDefaultDampingRatio;  // modal damping ratio [-]
  int elements = 8;                       // tube, rod: beam elements along the axis
  int segments = 1;                       // tube, rod: number of bodies in a row, each with modes of its own
  double mesh_size = 0.0;                 // disc, dish: edge length of triangles [m]; 0: radius / 4
  std::string mesh;                       // triangle mesh of a plate, instead of the shape (STL, OBJ, PLY)
  double mesh_scale = 1.0;                // metres per unit of the mesh file [-]
  double thickness = 0.0;                 // of a plate on a mesh [m]; 0: the shape's thickness
  std::string file;  // reduced model of another code (modal_body_file.h), instead of shape and mesh
  // Full or reduced model of another code (matrix_model.h): K, M, their nodes in D, and the order of their rows
  std::string stiffness_matrix, mass_matrix, node_file, dof_file;
  std::string stress_file;                // .frd with stresses of modes
  UnitSystem units = UnitSystem::kMetre;  // of those files
  std::vector<InterfaceSpec> interfaces;  // sets of nodes at which joints act
  std::vector<Eigen::Vector3d> nodes;     // 3D frame of beams: nodes in D [m]
  std::vector<MemberSpec> members;        // 3D frame: members between nodes
  std::vector<SectionSpec> sections;
};

// A model in matrices.
inline MatrixFiles matrix_files(const FlexibleSpec& spec) {
  return {spec.stiffness_matrix, spec.mass_matrix, spec.node_file, spec.dof_file,
          spec.stress_file,      spec.units,       spec.interfaces};
}

struct BodySpec {
  Source source;
  std::string name;
  std::optional<ShapeSpec> shape;
  std::string material;            // name; needed by a shape without mass, and by flexible beams and plates
  bool mass_is_remainder = false;  // mass = "remainder": total_mass minus all others
  // Resolved for every body by scene_reader:
  double mass = 0.0;                                   // [kg] > 0
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   // about the mass centre, in body axes [kg m2]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // mass centre in D [m]
  // R_DB: body axes in D (identity unless given; arrays turn it)
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  std::optional<FlexibleSpec> flexible;  // none, or enabled = false: rigid
};

}  // namespace footfall

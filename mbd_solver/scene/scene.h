#pragma once
// A scene as plain numbers: the contents of the TOML file with defaults, in SI units. scene_reader fills it, scene_check
// checks it, mbd_solver/assemble makes a Model of it. All points and directions are in the frame D of the reference
// configuration, in which the scene describes the mechanism; [initial] places D in the inertial frame W.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/name_index.h"
#include "mbd_solver/scene/body_spec.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/force_spec.h"
#include "mbd_solver/scene/joint_spec.h"
#include "mbd_solver/scene/run_spec.h"

namespace footfall {

// An entry with "{name}" in a text is copied `count` times; copy k (from 1) is turned by start + (k - 1) step.
struct ArraySpec {
  Source source;
  std::string name;
  int count = 1;
  double start = 0.0;                               // [rad]
  double step = 0.0;                                // [rad]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // through the origin of D [-]
};

struct Scene {
  Source source;                      // top-level keys
  std::string file;                   // the scene file as it was opened
  std::string folder;                 // its folder: paths of the file are relative to it, and are stored joined with it
  std::vector<std::string> settings;  // --set key=value, as given
  std::vector<std::string> warnings;  // findings that do not stop a run, with place and code
  std::map<std::string, std::string> accepted;  // "W0655" -> the reason for which its warnings are not printed

  std::string title;
  double end_time = 1.0;                                       // [s]
  Eigen::Vector3d gravity = Eigen::Vector3d(0.0, 0.0, -9.81);  // [m/s2], in W
  std::optional<double> total_mass;                            // [kg]; needed by one body with mass = "remainder"
  bool flexible = true;                                        // false: every body is rigid

  std::vector<ArraySpec> arrays;  // already applied
  std::vector<MaterialSpec> materials;
  std::vector<BodySpec> bodies;
  std::vector<JointSpec> joints;
  std::vector<StrutSpec> struts;
  std::vector<CableSpec> cables;
  std::vector<SpringSpec> springs;
  std::vector<ForceSpec> forces;
  std::vector<DriveSpec> drives;
  std::vector<GearSpec> gears;
  std::vector<BoundarySpec> boundaries;
  std::vector<ContactSpec> contacts;
  GroundSpec ground;
  std::optional<ParticlesSpec> particles;  // required by ground.kind = "particles"
  std::vector<ControllerSpec> controllers;
  std::vector<SignalSpec> signals;
  std::vector<StateSpec> states;
  std::vector<EventSpec> events;
  InitialSpec initial;
  SolverSpec solver;
  CouplingSpec coupling;
  OutputSpec output;
  std::vector<RequirementSpec> requirements;
  std::optional<LandingSpec> landing;  // none: columns and figures of landings are not computed

  // By name; null where there is none.
  const BodySpec* body(const std::string& name) const;
  const JointSpec* joint(const std::string& name) const;
  const MaterialSpec* material_or_null(const std::string& name) const;
  const BoundarySpec* boundary_of(const std::string& body) const;
  // Look-ups of a checked scene; an unknown name is an internal error. "ground" has the index -1.
  int body_index(const std::string& name) const;
  const MaterialSpec& material(const std::string& name) const;
  // The coordinate that a drive moves.
  Coordinate coordinate_of(const DriveSpec& drive) const;
  // The coordinate of the gear's joint of this index.
  Coordinate coordinate_of(const GearSpec& gear, std::size_t index) const;
  int joint_index(const std::string& name) const;
  Coordinate only_coordinate(const std::string& joint) const;  // of a joint that has one
  // Why a warning, a text that ends with its code, is not printed; null: it is.
  const std::string* accepted_reason(const std::string& warning) const;
  bool accepts(const std::string& warning) const { return accepted_reason(warning) != nullptr; }
  bool touches_particles() const { return ground.kind == GroundKind::kParticles; }

  struct Indices {
    NameIndex bodies, joints, materials, boundaries, signals, states;
  };
  Indices indices;
};

}  // namespace footfall

#pragma once
// A scene as plain numbers: what the TOML file says, complete with defaults, SI units, and nothing else. Filled by
// scene_reader, judged by scene_check, turned into a Model by the run part. All points and directions are in the
// drawing frame D: the mechanism in its design position; [initial] places D in the inertial frame W.

#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/scene/body_spec.h"
#include "mbd_solver/scene/contact_spec.h"
#include "mbd_solver/scene/drive_spec.h"
#include "mbd_solver/scene/force_spec.h"
#include "mbd_solver/scene/gear_spec.h"
#include "mbd_solver/scene/joint_spec.h"
#include "mbd_solver/scene/run_spec.h"
#include "mbd_solver/scene/signal_spec.h"
#include "mbd_solver/scene/source.h"
#include "mbd_solver/scene/strut_spec.h"

namespace footfall {

// "{name}" in any string of an entry: the entry is copied `count` times, copy k (from 1) turned by start + (k - 1)
// step.
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
  std::string folder;                 // its folder: every path in the scene is relative to it and stored joined with it
  std::vector<std::string> settings;  // --set key=value, as given
  std::vector<std::string> warnings;  // findings that do not stop a run, formatted

  std::string title;
  double end_time = 1.0;                                       // [s]
  Eigen::Vector3d gravity = Eigen::Vector3d(0.0, 0.0, -9.81);  // [m/s2], in W
  std::optional<double> total_mass;                            // [kg]; needed by one body with mass = "remainder"
  bool flexible = true;                                        // false: every body is rigid

  std::vector<ArraySpec> arrays;  // already applied: kept for the record
  std::vector<MaterialSpec> materials;
  std::vector<BodySpec> bodies;
  std::vector<JointSpec> joints;
  std::vector<StrutSpec> struts;
  std::vector<SpringSpec> springs;
  std::vector<ForceSpec> forces;
  std::vector<DriveSpec> drives;
  std::vector<GearSpec> gears;
  std::vector<BoundarySpec> boundaries;
  std::vector<ContactSpec> contacts;
  GroundSpec ground;
  std::optional<ParticlesSpec> particles;  // needed by ground.kind = "particles"
  std::vector<ControllerSpec> controllers;
  std::vector<SignalSpec> signals;
  std::vector<StateSpec> states;
  std::vector<EventSpec> events;
  InitialSpec initial;
  SolverSpec solver;
  CouplingSpec coupling;
  OutputSpec output;

  // Index of the body of this name; -1 for "ground". The scene is checked, so every name is known (FOOTFALL_DEMAND).
  int body_index(const std::string& name) const;
  const MaterialSpec& material(const std::string& name) const;
  // The coordinate that a drive moves, of a checked scene.
  CoordinateChoice coordinate_of(const DriveSpec& drive) const;
  // The coordinate that the gear's joint of this index takes part with, of a checked scene.
  CoordinateChoice coordinate_of(const GearSpec& gear, std::size_t index) const;
  int joint_index(const std::string& name) const;                    // FOOTFALL_DEMAND likewise
  CoordinateChoice only_coordinate(const std::string& joint) const;  // of a joint that has one
  bool touches_particles() const { return ground.kind == GroundKind::kParticles; }
};

}  // namespace footfall

#pragma once
// A stock LIGGGHTS mesh that moves with a body of the scene and tells it of its contacts.

#include <memory>
#include <string>
#include <vector>

#include "coupler/couple_mbd_arguments.h"
#include "liggghts_fix/dem_link.h"
#include "liggghts_fix/fix_wall_gran_smooth.h"
#include "liggghts_fix/mesh_module_mbd.h"
#include "pointers.h"

namespace LAMMPS_NS {

class CoupledMesh : protected Pointers {
 public:
  // `asker` begins the messages. Throws InputError when there is no such mesh, something else moves it, or its
  // triangles are not those of the body. Collective, as every fix command.
  CoupledMesh(LAMMPS* lmp, const std::string& asker, const footfall::MeshOfBody& pair, footfall::DemLink& link);

  // The mesh learns that it moves and whom its contacts concern; and forgets it again.
  void attach();
  void detach();

  const std::string& id() const { return mesh_id_; }
  int body() const { return body_; }  // index in the link
  bool is_there() const;              // false when the script has removed the mesh
  const std::vector<footfall::CornerNodes>& corners() const { return module_->corners(); }
  // After the coupling has started. `style`: of the fix, for LIGGGHTS' own messages. torque_before: one for all
  // meshes, which share walls. Throws InputError when something else has come to move the mesh since, when no wall
  // makes contacts with it, or when it stands outside of the box.
  void begin_run(const char* style, const GrainTorque& torque_before, const footfall::CoupleMbdArguments& arguments);

  // Throws NumericalError when a node leaves the box: LIGGGHTS loses such triangles.
  void check_inside_box() const;
  // To where the body's path is now.
  void move();

 private:
  std::string outside_box() const;  // of the nodes of the mesh at the body's pose; empty when all are inside
  void set_velocities();            // as they stand on the body's path
  void translate(const Eigen::Vector3d& velocity);
  void add_belt();
  double nearest_image(double place, double before, int direction) const;
  void turn_properties(const footfall::BoundaryStep& step);

  std::vector<FixWallGran*> walls() const;  // that name the mesh
  void bend_round_surface();
  // Where it is wanted and the mesh is curved, or can come to be.
  void let_grains_touch_once(const footfall::CoupleMbdArguments& arguments, const std::vector<FixWallGran*>& walls);

  footfall::DemLink& link_;
  std::string mesh_id_;
  std::string where_;  // begins the messages
  FixMeshSurface* fix_ = nullptr;
  int body_ = 0;
  std::unique_ptr<MeshModuleMbd> module_;
  std::shared_ptr<SmoothMesh> smooth_;  // null: grains touch facets
  Eigen::Matrix3Xd x_W_, v_W_;          // nodes of the body's boundary [m], [m/s]
  // Of a conveyor (surface_vel, surface_ang_vel), by element id: velocities of the corners relative to the body, in B
  // [m/s]; empty without.
  std::vector<Eigen::Matrix3d> belt_B_;
  bool made_velocities_ = false;  // the mesh had no velocities before we came
  std::vector<int> nodes_;        // of the boundary that the mesh has; others may be of beams, which may leave the box
  double reach_ = 0.0;            // no node is farther from Bo, undeformed [m]
  bool moved_ = false;            // by this run
};

}  // namespace LAMMPS_NS

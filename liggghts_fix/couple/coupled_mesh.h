#pragma once
// A stock LIGGGHTS mesh that moves with a body of the scene and reports its contacts to it.

#include <memory>
#include <string>
#include <vector>

#include "coupler/couple_mbd_arguments.h"
#include "liggghts_fix/contact/fix_wall_gran_smooth.h"
#include "liggghts_fix/couple/contact_module.h"
#include "liggghts_fix/link/dem_link.h"
#include "pointers.h"

namespace LAMMPS_NS {

class CoupledMesh : protected Pointers {
 public:
  // where: beginning of messages. Throws InputError when there is no such mesh, something else moves it, or its triangles
  // differ from the body's. Collective, as every fix command.
  CoupledMesh(LAMMPS* lmp, const std::string& where, const footfall::MeshOfBody& pair, footfall::DemLink& link);

  // Marks the mesh as moving and adds our contact module; detach() undoes both.
  void attach();
  void detach();

  const std::string& id() const { return mesh_id_; }
  int body() const { return body_; }  // index in the link
  bool is_there() const;              // false when the script has removed the mesh
  const std::vector<footfall::CornerNodes>& corners() const { return module_->corners(); }
  // After the coupling has started. style: of the fix, for LIGGGHTS' own messages. torque_before: one for all meshes,
  // which share walls. Throws InputError when something else has begun to move the mesh, when no wall makes contacts with
  // it, or when it is outside of the box.
  void begin_run(const char* style, const GrainTorque& torque_before, const footfall::CoupleMbdArguments& arguments);

  // Throws NumericalError when a node leaves the box. If a body is off the bed, its mesh remains behind instead:
  // no grain can touch it there.
  void check_inside_box();
  // To the present pose of the body's path.
  void move();

 private:
  std::string outside_box() const;  // about the nodes of the mesh at the body's pose; empty when all are inside
  void set_velocities();            // of the body's path
  void translate(const Eigen::Vector3d& velocity);
  void hold_in_box();  // centres of triangles
  void add_belt();
  double nearest_image(double place, double before, int direction) const;
  void turn_properties(const footfall::BoundaryStep& step);

  std::vector<FixWallGran*> walls() const;  // that name the mesh
  void bend_round_surface();
  // Where this is chosen and the mesh is curved or may become so.
  void let_grains_touch_once(const footfall::CoupleMbdArguments& arguments, const std::vector<FixWallGran*>& walls);

  footfall::DemLink& link_;
  std::string mesh_id_;
  std::string where_;  // beginning of messages
  FixMeshSurface* fix_ = nullptr;
  int body_ = 0;
  std::unique_ptr<ContactModule> module_;
  std::shared_ptr<SmoothMesh> smooth_;  // null: grains touch facets
  Eigen::Matrix3Xd x_W_, v_W_;          // nodes of the body's boundary [m], [m/s]
  // For a conveyor (surface_vel, surface_ang_vel), by element id: velocities of the corners relative to the body, in B
  // [m/s]; otherwise empty.
  std::vector<Eigen::Matrix3d> belt_B_;
  bool made_velocities_ = false;  // the mesh had no velocities before attach()
  std::vector<int> nodes_;        // nodes of the boundary in the mesh; nodes of beams alone may leave the box
  double reach_ = 0.0;            // largest distance of a node from Bo, undeformed [m]
  bool moved_ = false;            // in this run
  bool stays_behind_ = false;
};

// The part of a body's surface in one mesh.
struct PartOfSurface {
  std::string mesh;
  const std::vector<footfall::CornerNodes>& corners;
};
// Throws InputError unless the parts together are the surface of the body, with each triangle once.
void require_whole_surface(const footfall::ModalBoundary& boundary, const std::vector<PartOfSurface>& parts);

}  // namespace LAMMPS_NS

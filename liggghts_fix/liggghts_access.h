#pragma once
// The one place that reaches private and protected members of LIGGGHTS 3.8.0 (liggghts_access_members.h says how).
// Everything else uses its public interface. CMake refuses other versions.

#include <string>
#include <vector>

namespace LAMMPS_NS {
class Fix;
class FixGravity;
class FixMeshSurface;
class FixWallGran;
class LAMMPS;
class MeshModule;
class TriMesh;
}  // namespace LAMMPS_NS

namespace LIGGGHTS::Walls {
class IGranularWall;
}  // namespace LIGGGHTS::Walls

namespace footfall {

class DemLink;

// Teaches this LIGGGHTS a fix style; the command `clear` makes it anew and it learns it again.
using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
void register_fix_style(LAMMPS_NS::LAMMPS* lmp, const std::string& style, FixCreator creator);
// The creator of every fix mesh/surface of LIGGGHTS is called through one of ours. Where a run is resumed, a mesh comes
// from the restart file, and yet LIGGGHTS looks for a file named like the source of its triangles: ours names one that is
// always there.
void let_meshes_resume(LAMMPS_NS::LAMMPS* lmp);

// Appends a module to a stock mesh fix, which then hears of every contact; detach before it dies.
void attach_mesh_module(LAMMPS_NS::FixMeshSurface* fix, const std::string& name, LAMMPS_NS::MeshModule* module);
void detach_mesh_module(LAMMPS_NS::FixMeshSurface* fix, const std::string& name);

// The contact model of a wall, which the wall owns.
LIGGGHTS::Walls::IGranularWall*& wall_model(LAMMPS_NS::FixWallGran* wall);

// What LIGGGHTS knows of a mesh's place: [element][corner][xyz] and [element][xyz], owned elements first, then ghosts.
double*** mesh_nodes(LAMMPS_NS::TriMesh* mesh);
double** mesh_centers(LAMMPS_NS::TriMesh* mesh);
// After nodes of a deforming mesh were written: centres, bounding radii, areas, edges and normals of owned and ghost
// elements.
void recalculate_mesh(LAMMPS_NS::TriMesh* mesh);

// Of a fix gravity after its init(): no part of it is a variable.
bool gravity_is_constant(LAMMPS_NS::FixGravity* fix);
// `surface_vel` or `surface_ang_vel` of a mesh by a variable: LIGGGHTS then writes the velocities anew in every step.
bool surface_velocity_varies(LAMMPS_NS::FixMeshSurface* fix);
// Brings the owned elements into this order: place i gets the element that stands at order[i]. The mesh is then as after
// an exchange between ranks, before its ghosts are made.
void reorder_mesh(LAMMPS_NS::TriMesh* mesh, const std::vector<int>& order);

// Our module on a mesh that a body moves.
inline constexpr const char* kMeshModule = "footfall_mbd";

// Hears of the forces on the grains while LIGGGHTS adds them up, source by source.
class ForceWatch {
 public:
  virtual ~ForceWatch() = default;
  virtual void pairs_done(bool set_up) = 0;        // those of grains on each other stand; set_up: of a run, else a step
  virtual void fix_done(LAMMPS_NS::Fix& fix) = 0;  // this one has added its own
  virtual void forces_done(bool set_up) = 0;       // all have
  virtual void step_done() = 0;                    // the velocities at the end of the step are known
};
// Null: nobody hears any more.
void watch_forces(LAMMPS_NS::LAMMPS* lmp, ForceWatch* watch);

// Boundaries that a step moves only when the forces of its grains on each other stand, which do not depend on them.
class LateBoundaries {
 public:
  virtual ~LateBoundaries() = default;
  virtual void move_boundaries() = 0;  // to where they are at the end of the step
};
// What fixes do before the forces (Modify::pre_force: the grains' lists at meshes) waits for the boundaries too. Null:
// it does not.
void move_behind_pairs(LAMMPS_NS::LAMMPS* lmp, LateBoundaries* boundaries);

// LIGGGHTS creates fixes by (lmp, narg, arg) alone: this is how they find the coupling that the launcher made for their
// LIGGGHTS.
void attach_dem_link(LAMMPS_NS::LAMMPS* lmp, DemLink& link);
DemLink& dem_link_of(LAMMPS_NS::LAMMPS* lmp);

}  // namespace footfall

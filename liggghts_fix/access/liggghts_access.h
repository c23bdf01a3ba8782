#pragma once
// Access to private and protected members of LIGGGHTS 3.8.0, in this file alone (and in members that `replaced/`
// defines). All other code uses its public interface. CMake refuses other versions of LIGGGHTS.

#include <string>
#include <vector>

namespace LAMMPS_NS {
class Fix;
class FixGravity;
class FixMeshSurface;
class FixWallGran;
class LAMMPS;
class MeshModule;
class Modify;
class TriMesh;
}  // namespace LAMMPS_NS

namespace LIGGGHTS::Walls {
class IGranularWall;
}  // namespace LIGGGHTS::Walls

namespace footfall {

class DemLink;

// --- Settings that an instance of LIGGGHTS gets from the launcher.

// Registers a fix style. The command `clear` creates LIGGGHTS' parts anew: restore_fix_styles registers all styles again.
using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
void register_fix_style(LAMMPS_NS::LAMMPS* lmp, const std::string& style, FixCreator creator);
void restore_fix_styles(LAMMPS_NS::LAMMPS* lmp);
// Registers our creators in front of the creators of every fix mesh/surface. In a resumed run a mesh comes from the restart
// file, but LIGGGHTS requires a file named like the source of its triangles: our creators name a file that always exists.
void make_meshes_resumable(LAMMPS_NS::LAMMPS* lmp);

// LIGGGHTS creates fixes by (lmp, narg, arg) alone. They find the coupling of their LIGGGHTS here.
void attach_dem_link(LAMMPS_NS::LAMMPS* lmp, DemLink& link);
DemLink& dem_link_of(LAMMPS_NS::LAMMPS* lmp);
DemLink* find_dem_link(LAMMPS_NS::LAMMPS* lmp);  // null without one

// Ignores data of the fix with this id in the restart file.
void forget_restart_data(LAMMPS_NS::Modify& modify, const char* id);

// --- Meshes.

// Adds a module to a stock mesh fix, which then reports every contact to it; detach it before it is destroyed.
void attach_mesh_module(LAMMPS_NS::FixMeshSurface* fix, const std::string& name, LAMMPS_NS::MeshModule* module);
void detach_mesh_module(LAMMPS_NS::FixMeshSurface* fix, const std::string& name);
// Name of our module on a mesh that a body moves.
inline constexpr const char* kMeshModule = "footfall_mbd";

// Nodes [element][corner][xyz] and centres [element][xyz] of a mesh, owned elements first, then ghosts.
double*** mesh_nodes(LAMMPS_NS::TriMesh* mesh);
double** mesh_centers(LAMMPS_NS::TriMesh* mesh);
// After nodes of a deforming mesh were written: computes centres, bounding radii, areas, edges and normals of owned and
// ghost elements.
void recalculate_mesh(LAMMPS_NS::TriMesh* mesh);
// Reorders the owned elements: place i gets the element at order[i]. The mesh is then as after an exchange between ranks,
// before its ghosts are created.
void reorder_mesh(LAMMPS_NS::TriMesh* mesh, const std::vector<int>& order);
// `surface_vel` or `surface_ang_vel` of a mesh is a variable: LIGGGHTS then writes the velocities in every step.
bool surface_velocity_varies(LAMMPS_NS::FixMeshSurface* fix);

// --- Walls and gravity.

// The contact model of a wall, which the wall owns.
LIGGGHTS::Walls::IGranularWall*& wall_model(LAMMPS_NS::FixWallGran* wall);
// For a fix gravity after its init(): no part of it is a variable.
bool gravity_is_constant(LAMMPS_NS::FixGravity* fix);

}  // namespace footfall

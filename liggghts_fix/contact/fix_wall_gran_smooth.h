#pragma once
// LIGGGHTS' fix wall/gran, with the same arguments and equal to the bit, except that a grain can touch a smooth surface of
// a mesh once. LIGGGHTS lets it touch every facet that it overlaps; where the surface is curved and its facets are narrower
// than the contact patch, their forces add up.

#include <map>
#include <memory>
#include <vector>

#include "fix_wall_gran.h"
#include "liggghts_fix/link/round_surface.h"
#include "liggghts_fix/link/surface_pieces.h"

namespace LAMMPS_NS {

class FixContactHistoryMesh;
class FixMeshSurface;
class TriMesh;

// The smooth pieces of a mesh; with `round` grains touch the round surface of which the mesh is a tessellation.
struct SmoothMesh {
  footfall::SurfacePieces pieces;
  std::unique_ptr<footfall::RoundSurface> round;  // null: the facets
};

// Replaces the style wall/gran. Meshes without touch_once are left to LIGGGHTS.
//
// A piece has one contact with a grain, at the facet nearest to the grain's centre among its neighbours
// (surface_pieces.h), with force and moment by LIGGGHTS' contact model. When another facet of the piece becomes the
// nearest, it inherits the contact's history.
class FixWallGranSmooth final : public FixWallGran {
 public:
  FixWallGranSmooth(LAMMPS* lmp_, int count, char** words) : FixWallGran(lmp_, count, words) {}

  // From now on grains touch each piece of the mesh once; null: each facet, as in LIGGGHTS.
  void touch_once(FixMeshSurface* mesh, std::shared_ptr<const SmoothMesh> smooth);
  // The mesh's number in this wall's list; within a step.
  int number_of(const FixMeshSurface* mesh) const;

 protected:
  void post_force_mesh(int vflag) override;

 private:
  struct Touch {
    footfall::FacetTouch nearest;
    int grain, element;  // local numbers of LIGGGHTS
    int before;          // previous touch of the grain, or -1
    double delta[3];     // from the grain's centre to the nearest point [m]
  };

  void touch_pieces(FixMeshSurface& mesh_fix, int mesh_number, const SmoothMesh& smooth);
  void find_touches(FixMeshSurface& mesh_fix, const SmoothMesh& smooth);
  bool reaches(const SmoothMesh& smooth, TriMesh& mesh, double* const* corners, const double* normal,
               Touch& touch) const;
  bool counts(const Touch& touch, const footfall::SurfacePieces& pieces) const;
  double* history_of(FixContactHistoryMesh& history, const Touch& touch, const footfall::SurfacePieces& pieces);
  // Does the grain touch this facet in this step?
  bool touches(int grain, int facet, const footfall::SurfacePieces& pieces) const;

  std::map<const FixMeshSurface*, std::shared_ptr<const SmoothMesh>> smooth_;
  std::vector<FixMeshSurface*> meshes_;  // of this wall
  std::vector<Touch> touches_;           // of the current mesh, in the order of its elements
  std::vector<int> last_;                // by grain: its last touch, or -1
};

}  // namespace LAMMPS_NS

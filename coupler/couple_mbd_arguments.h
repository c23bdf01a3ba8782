#pragma once
// The words of  fix ID all couple/mbd every N|auto [KEYWORD VALUE]... [mesh MESH-ID BODY]..., taken apart without
// LIGGGHTS headers.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace footfall {

// `mesh MESH-ID BODY`: the mesh moves with the body.
struct MeshOfBody {
  std::string mesh;
  std::string body;
};

struct CoupleMbdArguments {
  // Throws InputError for a missing, wrong or further word, and for a mesh that is named twice.
  CoupleMbdArguments(int narg, const char* const* arg);

  std::string fix;                 // "fix ID couple/mbd: ", where messages begin
  int every = 0;                   // substeps per window; 0: `auto`, the multibody side chooses
  std::optional<double> patience;  // how long the partner may be silent [s]; nothing: as the launcher has it
  bool gravity_of_scene = true;    // `gravity scene|script`: is the script's fix gravity held against the scene's?
  bool end_of_scene = true;        // `end scene|script`: is it an error when the script ends before the scene does?
  double max_lost = 0.05;          // `lost SHARE`: of all grains; when LIGGGHTS loses more, the run stops [-]
  // `surface smooth|facets|round`: grains touch each smooth piece of a mesh once; each facet, as in stock LIGGGHTS; or,
  // once, the round surface through the nodes of the mesh.
  enum class Surface { kSmooth, kFacets, kRound };
  Surface surface = Surface::kSmooth;
  double edge_angle = 30.0 * M_PI / 180.0;  // `edge DEGREES`: facets that turn by less make up a smooth piece [rad]
  // `damping_mass grain|pair`: does damping take the wall for infinitely heavy, as in stock LIGGGHTS?
  bool mass_of_pair = false;
  std::vector<MeshOfBody> meshes;  // several may belong to one body
};

}  // namespace footfall

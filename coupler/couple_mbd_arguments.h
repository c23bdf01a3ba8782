#pragma once
// The arguments of  fix ID all couple/mbd every N|auto [KEYWORD VALUE]... [mesh MESH-ID BODY]...  The fix reads them,
// and the check of a scene reads them in its script.

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
  // Throws InputError for a missing, wrong or surplus word, and for a mesh that is named twice.
  CoupleMbdArguments(int narg, const char* const* arg);

  std::string fix;                 // "fix ID couple/mbd: ", the beginning of messages
  int every = 0;                   // DEM steps per window; 0: `auto`, the multibody side chooses
  std::optional<double> patience;  // how long the partner may be silent [s]; none: as set by the launcher
  bool gravity_of_scene = true;    // `gravity scene|script`: is the script's fix gravity compared with the scene's?
  bool end_of_scene = true;        // `end scene|script`: is it an error when the script ends before the scene does?
  double max_lost = 0.05;          // `lost SHARE`: the run stops when LIGGGHTS has lost more of all grains [-]
  bool outflow = false;            // `outflow yes|no`: grains may leave the box, however many
  // `surface smooth|facets|round`: a grain touches each smooth piece of a mesh once; each facet, as in stock LIGGGHTS; or
  // once the round surface through the nodes of the mesh.
  enum class Surface { kSmooth, kFacets, kRound };
  Surface surface = Surface::kSmooth;
  double edge_angle = 30.0 * M_PI / 180.0;  // `edge DEGREES`: facets at smaller angles form a smooth piece [rad]
  // `damping_mass grain|pair`: false: damping takes walls as infinitely heavy, as stock LIGGGHTS does.
  bool mass_of_pair = false;
  std::vector<MeshOfBody> meshes;  // several may belong to one body
};

}  // namespace footfall

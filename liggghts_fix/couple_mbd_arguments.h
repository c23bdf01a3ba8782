#pragma once
// The words of  fix ID all couple/mbd every N|auto [patience SECONDS] [mesh MESH-ID BODY ...], taken apart without
// LIGGGHTS headers.

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
  // Throws InputError for a missing, wrong or further word, and for a body that gets two meshes.
  CoupleMbdArguments(int narg, const char* const* arg);

  std::string fix;                 // "fix ID couple/mbd: ", where messages begin
  int every = 0;                   // substeps per window; 0: `auto`, the multibody side chooses
  std::optional<double> patience;  // how long the partner may be silent [s]; nothing: as the launcher has it
  std::vector<MeshOfBody> meshes;
};

}  // namespace footfall

#include "liggghts_fix/couple_mbd_arguments.h"

#include "coupler/base/errors.h"
#include "liggghts_fix/words.h"

namespace footfall {
namespace {

constexpr const char* kUsage =
    "expected: fix ID all couple/mbd every N|auto [patience SECONDS] [mesh MESH-ID BODY ...]";
constexpr int kMostSubsteps = 1000000;  // of a window

}  // namespace

CoupleMbdArguments::CoupleMbdArguments(int narg, const char* const* arg) {
  const std::vector<std::string> words(arg, arg + narg);
  FOOTFALL_DEMAND(words.size() >= 3);
  fix = "fix " + words[0] + " " + words[2] + ": ";
  if (words.size() < 5 || words[3] != "every") throw InputError(fix + kUsage);
  if (words[4] != "auto") {
    const std::optional<int> n = whole_number(words[4], 1, kMostSubsteps);
    if (!n)
      throw InputError(fix + "`every` needs a number of steps from 1 to " + std::to_string(kMostSubsteps) +
                       " or `auto`, not \"" + words[4] + "\"");
    every = *n;
  }
  std::size_t next = 5;
  if (next + 1 < words.size() && words[next] == "patience") {
    patience = positive_number(words[next + 1]);
    if (!patience)
      throw InputError(fix + "`patience` needs a positive number of seconds, not \"" + words[next + 1] + "\"");
    next += 2;
  }
  for (; next + 2 < words.size() && words[next] == "mesh"; next += 3) {
    const MeshOfBody pair{words[next + 1], words[next + 2]};
    for (const MeshOfBody& other : meshes)
      if (other.body == pair.body)
        throw InputError(fix + "mesh " + pair.mesh + ": body \"" + pair.body + "\" has a mesh already");
    meshes.push_back(pair);
  }
  if (next != words.size()) throw InputError(fix + "at \"" + words[next] + "\" " + kUsage);
}

}  // namespace footfall

#include "mbd_solver/build/grain_dump.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"

namespace footfall {

std::vector<GrainPlace> read_grains(const std::string& path) {
  std::ifstream file(path);
  if (!file)
    throw InputError("particles.grains: cannot read " + path +
                     "; it is written with the bed (dump custom x y z radius)");
  std::vector<GrainPlace> grains;
  std::string line;
  bool atoms = false;
  int number = 0;
  while (std::getline(file, line)) {
    ++number;
    if (line.rfind("ITEM:", 0) == 0) {
      atoms = line.rfind("ITEM: ATOMS", 0) == 0;
      if (atoms) grains.clear();  // the last frame counts
      continue;
    }
    if (!atoms) continue;
    std::istringstream values(line);
    GrainPlace grain;
    if (!(values >> grain.centre.x() >> grain.centre.y() >> grain.centre.z() >> grain.radius))
      throw InputError(path + ":" + std::to_string(number) + ": \"" + line + "\": expected x y z radius");
    if (!grain.centre.allFinite() || !(grain.radius > 0.0) || !std::isfinite(grain.radius))
      throw InputError(path + ":" + std::to_string(number) + ": \"" + line +
                       "\": expected finite x y z and a positive radius");
    grains.push_back(grain);
  }
  if (grains.empty()) throw InputError(path + ": holds no grains; expected a dump of x y z radius");
  return grains;
}

}  // namespace footfall

// Reads the last frame of a text dump of LIGGGHTS.
#include "mbd_solver/build/grain_dump.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <set>
#include <sstream>

#include "coupler/base/input_file.h"
#include "mbd_solver/build/codes.h"

namespace footfall {

using namespace code;

namespace {

InputError wrong_line(const std::string& path, int number, const std::string& line, const char* expected) {
  return InputError(kGrainFile, path + ":" + std::to_string(number) + ": is \"" + line + "\", expected " + expected +
                                    "; make the bed again");
}

}  // namespace

std::vector<GrainPlace> read_grains(const std::string& path) {
  require_regular_file(path);
  std::ifstream file(path);
  if (!file)
    throw InputError(kNoGrainFile, "particles.grains: " + path +
                                       " cannot be read; it is written with the bed (dump custom x y z radius)");
  std::vector<GrainPlace> grains;
  std::string line;
  bool atoms = false, clumps = false, speeds = false;
  int number = 0;
  while (std::getline(file, line)) {
    ++number;
    if (line.rfind("ITEM:", 0) == 0) {
      atoms = line.rfind("ITEM: ATOMS", 0) == 0;
      if (atoms) grains.clear();  // the last frame counts
      if (atoms) clumps = line.find(" radius mol") != std::string::npos;
      if (atoms) speeds = line.find(clumps ? " mol vx vy vz" : " radius vx vy vz") != std::string::npos;
      continue;
    }
    if (!atoms) continue;
    std::istringstream values(line);
    values.imbue(std::locale::classic());
    GrainPlace grain;
    values >> grain.centre.x() >> grain.centre.y() >> grain.centre.z() >> grain.radius;
    if (clumps) values >> grain.clump;
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    if (speeds) values >> velocity.x() >> velocity.y() >> velocity.z();
    if (speeds) grain.speed = velocity.norm();
    if (!values) throw wrong_line(path, number, line, clumps ? "x y z radius mol" : "x y z radius");
    grain.clump = std::max(0, grain.clump);  // LIGGGHTS: -1 in none
    if (!grain.centre.allFinite() || !(grain.radius > 0.0) || !std::isfinite(grain.radius))
      throw wrong_line(path, number, line, "finite x y z and a positive radius");
    grains.push_back(grain);
  }
  if (grains.empty()) throw InputError(kGrainFile, path + ": contains no grains, expected a dump of x y z radius");
  return grains;
}

std::size_t count_grains(const std::vector<GrainPlace>& spheres) {
  std::set<int> clumps;
  std::size_t count = 0;
  for (const GrainPlace& sphere : spheres) count += sphere.clump == 0 || clumps.insert(sphere.clump).second ? 1 : 0;
  return count;
}

}  // namespace footfall

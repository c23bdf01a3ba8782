// Reads the last frame of a text dump of LIGGGHTS.
#include "mbd_solver/assemble/grain_dump.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "coupler/base/input_file.h"
#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/base/text_reader.h"

namespace footfall {

using namespace code;

namespace {

constexpr double kMostClumps = std::numeric_limits<int>::max();

}  // namespace

std::vector<GrainPlace> read_grains(const std::string& path) {
  require_regular_file(path);
  TextReader text = TextReader::if_there(path);
  if (!text.opened())
    throw InputError(kNoGrainFile, "particles.grains: ", path,
                     " cannot be read; it is written with the bed (dump custom x y z radius)");
  std::vector<GrainPlace> grains;
  bool atoms = false, clumps = false, speeds = false;
  double value[8] = {};
  while (text.next()) {
    const std::string& line = text.line();
    if (line.rfind("ITEM:", 0) == 0) {
      atoms = line.rfind("ITEM: ATOMS", 0) == 0;
      if (atoms) grains.clear();  // the last frame counts
      if (atoms) clumps = line.find(" radius mol") != std::string::npos;
      if (atoms) speeds = line.find(clumps ? " mol vx vy vz" : " radius vx vy vz") != std::string::npos;
      continue;
    }
    if (!atoms) continue;
    const auto demand = [&](bool met, const char* expected) {
      if (!met) text.fail(kGrainFile, "is \"", line, "\", expected ", expected, "; make the bed again");
    };
    const std::vector<std::string_view>& words = text.fields(Separators::kBlanks);
    const std::size_t count = 4 + (clumps ? 1 : 0) + (speeds ? 3 : 0);
    for (std::size_t i = 0; i < count; ++i)
      demand(i < words.size() && read_number(words[i], value[i]), clumps ? "x y z radius mol" : "x y z radius");
    GrainPlace grain{{value[0], value[1], value[2]}, value[3]};
    demand(grain.centre.allFinite() && grain.radius > 0.0 && std::isfinite(grain.radius),
           "finite x y z and a positive radius");
    if (clumps) {
      demand(std::abs(value[4]) <= kMostClumps, "the number of a clump behind x y z radius");
      grain.clump = std::max(0, static_cast<int>(value[4]));  // LIGGGHTS: -1 in none
    }
    if (speeds) grain.speed = Eigen::Map<const Eigen::Vector3d>(value + count - 3).norm();
    grains.push_back(grain);
  }
  if (grains.empty()) throw InputError(kGrainFile, path, ": contains no grains, expected a dump of x y z radius");
  return grains;
}

std::size_t count_grains(const std::vector<GrainPlace>& spheres) {
  std::set<int> clumps;
  std::size_t count = 0;
  for (const GrainPlace& sphere : spheres) count += sphere.clump == 0 || clumps.insert(sphere.clump).second ? 1 : 0;
  return count;
}

}  // namespace footfall

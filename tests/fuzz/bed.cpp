// A kept bed: LIGGGHTS' restart file, judged from outside, and the dump of its grains.
#include "mbd_solver/build/grain_dump.h"
#include "mbd_solver/cli/launch/bed_seal.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("bed.restart.grains", data, size, [&](const std::string& path) {
    damage_of_restart(path);
    damage_of_dump(path);
    read_grains(path);
  });
}

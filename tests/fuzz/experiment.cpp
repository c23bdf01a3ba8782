#include "mbd_solver/cli/experiments/experiment.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("experiment.toml", data, size, [&](const std::string& path) { read_experiment(path); });
}

#include "mbd_solver/cli/calibrate/calibration.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("calibration.toml", data, size, [&](const std::string& path) { read_calibration(path); });
}

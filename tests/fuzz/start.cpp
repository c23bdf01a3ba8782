#include "mbd_solver/output/run_start.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("start.json", data, size, [&](const std::string& path) {
    read_run_start(std::filesystem::path(path).parent_path().string());
  });
}

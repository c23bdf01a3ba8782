#include "mbd_solver/output/history.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("history.csv", data, size, [&](const std::string& path) { read_history(path); });
}

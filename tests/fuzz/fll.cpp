#include "mbd_solver/model/controllers/fuzzy.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("controller.fll", data, size, [&](const std::string& path) { const FuzzySystem system(path); });
}

#include "mbd_solver/output/summary.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("summary.json", data, size, [&](const std::string& path) {
    const auto summary = read_summary(path);
    with_summary_of(path, [&] { return summary.value("status", ""); });
  });
}

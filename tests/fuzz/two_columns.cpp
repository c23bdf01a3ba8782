#include "mbd_solver/scene/field_reader.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("table.csv", data, size, [&](const std::string& path) { read_two_columns(path); });
}

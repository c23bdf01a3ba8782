#include "mbd_solver/scene/mesh_reader.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("mesh.obj", data, size, [&](const std::string& path) { read_mesh(path, 1.0); });
}

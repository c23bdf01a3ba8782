// The same bytes as stiffness, mass and, from the first line "nodes" on, as the list of nodes.
#include "mbd_solver/fe/modal_body_file.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("matrix.mtx", data, size, [&](const std::string& path) {
    const std::string text(reinterpret_cast<const char*>(data), size), nodes = path + ".nodes";
    const std::size_t at = text.find("\nnodes");
    std::ofstream(nodes, std::ios::binary) << (at == std::string::npos ? "0 0 0\n" : text.substr(at + 6));
    read_matrix_market(path, path, nodes);
  });
}

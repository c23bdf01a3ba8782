#include "mbd_solver/fe/modal_body_file.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::feed("body.modal", data, size,
                    [&](const std::string& path) { read_modal_body(path, BasisOptions(), "body"); });
}

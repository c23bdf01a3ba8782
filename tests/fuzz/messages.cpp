// The same bytes as every kind of message.
#include "coupler/messages.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

namespace {

template <class Message>
void unpack_one(const std::uint8_t* data, std::size_t size) {
  const Bytes bytes(data, data + size);
  Message message;
  try {
    unpack(bytes, message);
  } catch (const ProtocolError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  unpack_one<Hello>(data, size);
  unpack_one<Geometry>(data, size);
  unpack_one<Start>(data, size);
  unpack_one<Accept>(data, size);
  unpack_one<Motion>(data, size);
  unpack_one<Load>(data, size);
  unpack_one<Close>(data, size);
  return 0;
}

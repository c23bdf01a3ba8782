// The memory of a checkpoint, run.txt: whatever stands in the file, what restores it complains or has it all.
#include <optional>

#include "coupler/archive.h"
#include "coupler/message_fields.h"
#include "tests/fuzz/feed.h"

using namespace footfall;

namespace {

struct Memory {
  long window = 0;
  double time = 0.0;
  bool chosen = false;
  std::string scheme;
  std::vector<bool> flags;
  std::optional<double> peak;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(3);
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  std::array<double, 2> energy{};
  Load load;

  void visit(Archive& archive) {
    archive("window", window);
    archive("time", time);
    archive("chosen", chosen);
    archive("scheme", scheme);
    archive("flags", flags);
    archive("peak", peak);
    archive("q", q);
    archive("A", A);
    archive("energy", energy);
    archive("load", load);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    Archive archive("run.txt", std::string(reinterpret_cast<const char*>(data), size));
    Memory memory;
    memory.visit(archive);
    archive.finish();
  } catch (const InputError&) {
  }
  return 0;
}

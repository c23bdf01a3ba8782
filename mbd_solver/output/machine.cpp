#include "mbd_solver/output/machine.h"

#include <sys/utsname.h>

#include <fstream>
#include <thread>

#include "coupler/base/text.h"

namespace footfall {

std::string compiler_version() {
#if defined(__clang__)
  return std::string("Clang ") + __clang_version__;
#elif defined(__GNUC__)
  return std::string("GCC ") + __VERSION__;
#else
  return "unknown";
#endif
}

nlohmann::ordered_json machine() {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::ifstream processors("/proc/cpuinfo");
  for (std::string line; std::getline(processors, line) && !json.contains("processor");)
    if (const std::size_t colon = line.find(':'); colon != std::string::npos && line.rfind("model name", 0) == 0)
      json["processor"] = trimmed(line.substr(colon + 1));
  if (const unsigned cores = std::thread::hardware_concurrency(); cores > 0) json["cores"] = cores;
  utsname system{};
  if (uname(&system) == 0) json["system"] = std::string(system.sysname) + " " + system.release + " " + system.machine;
  return json;
}

}  // namespace footfall

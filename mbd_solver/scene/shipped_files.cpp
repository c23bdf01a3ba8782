// Looks next to the program first, then in the checkout.
#include "mbd_solver/scene/shipped_files.h"

#include <algorithm>
#include <filesystem>

#include "mbd_solver/scene/codes.h"

namespace footfall {

namespace fs = std::filesystem;

std::string shipped_file(const std::string& path) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path installed = (program / "../share/footfall" / path).lexically_normal();
  if (fs::exists(installed, error)) return installed.string();
  const fs::path source = fs::path(FOOTFALL_CHECKOUT) / path;
  if (fs::exists(source, error)) return source.string();
  throw InputError(code::kShippedFile, path, ": this part of footfall is neither ", installed.string(), " nor ",
                   source.string(), "; install footfall again, or build it from a complete checkout");
}

std::vector<std::string> shipped_tables(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(shipped_file(folder)))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace footfall

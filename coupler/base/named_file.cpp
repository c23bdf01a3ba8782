#include "coupler/base/named_file.h"

#include <filesystem>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"

namespace footfall {

std::string meant_path(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  fs::path meant;
  for (const fs::path& part : fs::path(path)) {
    if (fs::exists(meant / part, ignored)) {
      meant /= part;
      continue;
    }
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(meant.empty() ? "." : meant, ignored))
      names.push_back(entry.path().filename().string());
    const std::string guess = nearest_name(part.string(), names);
    if (guess.empty()) return "";
    meant /= guess;
  }
  return ". Did you mean \"" + meant.string() + "\"?";
}

void demand_file(const std::string& path, const std::string& expected) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw InputError(path + ": is a folder; expected " + expected);
  if (!std::filesystem::exists(path, ignored))
    throw InputError(path + ": no such file; expected " + expected + meant_path(path));
}

}  // namespace footfall

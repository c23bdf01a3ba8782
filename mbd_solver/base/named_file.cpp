// Walks the path part by part and replaces a part that does not exist by the nearest name in that folder.

#include "mbd_solver/base/named_file.h"

#include <filesystem>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/codes.h"

namespace footfall {

std::string suggested_path(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  fs::path suggestion;
  for (const fs::path& part : fs::path(path)) {
    if (fs::exists(suggestion / part, ignored)) {
      suggestion /= part;
      continue;
    }
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(suggestion.empty() ? "." : suggestion, ignored))
      names.push_back(entry.path().filename().string());
    const std::string nearest = nearest_name(part.string(), names);
    if (nearest.empty()) return "";
    suggestion /= nearest;
  }
  return ". Did you mean \"" + suggestion.string() + "\"?";
}

void require_file(const std::string& path, const std::string& expected) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(code::kPathIsFolder, path + ": is a folder; expected " + expected);
  if (!std::filesystem::exists(path, ignored))
    throw InputError(code::kNoSuchFile, path + ": no such file; expected " + expected + suggested_path(path));
}

}  // namespace footfall

#include "coupler/base/whole_file.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"

namespace footfall {

std::optional<std::string> read_whole_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_whole_file(const std::string& path, const std::string& text, const std::string& advice) {
  const std::string draft = path + ".part";
  std::error_code error;
  {
    std::ofstream file(draft);
    file << text;
    file.close();
    if (!file) {
      std::filesystem::remove(draft, error);
      throw InputError(path + ": cannot be written; " + advice);
    }
  }
  std::filesystem::rename(draft, path, error);
  if (error) throw InputError(path + ": cannot be written: " + error.message());
}

}  // namespace footfall

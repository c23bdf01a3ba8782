#include "coupler/base/whole_file.h"

#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"

namespace footfall {

void write_whole_file(const std::string& path, const std::string& text) {
  const std::string draft = path + ".part";
  std::error_code error;
  {
    std::ofstream file(draft);
    file << text;
    file.close();
    if (!file) {
      std::filesystem::remove(draft, error);
      throw InputError(path + ": cannot be written; choose another folder with --out");
    }
  }
  std::filesystem::rename(draft, path, error);
  if (error) throw InputError(path + ": cannot be written: " + error.message());
}

}  // namespace footfall

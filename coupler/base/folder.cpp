#include "coupler/base/folder.h"

#include <filesystem>

#include "coupler/base/errors.h"

namespace footfall {

void make_folder(const std::string& folder, const std::string& advice) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder + ": cannot be made: " + error.message() + "; " + advice);
}

}  // namespace footfall

// By stat(), before the file is opened: opening a pipe waits.

#include "coupler/base/input_file.h"

#include <sys/stat.h>

#include "coupler/base/codes.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"

namespace footfall {

void require_regular_file(const std::string& path, std::uint64_t largest) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || S_ISDIR(status.st_mode)) return;
  if (!S_ISREG(status.st_mode))
    throw InputError(code::kNotRegularFile, path + ": is a pipe, device or socket, expected a regular file; write " +
                                                "its content to a file and name that");
  if (static_cast<std::uint64_t>(status.st_size) <= largest) return;
  constexpr double kMegabyte = 1048576.0;
  throw InputError(code::kFileTooLarge,
                   path + ": has " + number_text(static_cast<double>(status.st_size) / kMegabyte, 4) +
                       " MB, expected at most " + number_text(static_cast<double>(largest) / kMegabyte, 4) +
                       " MB; name the right file");
}

}  // namespace footfall

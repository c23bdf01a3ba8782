#pragma once
// A file of a run that is under way cannot be written: full disk, folder gone, a limit. The message names the file. Exit
// code 1.

#include <stdexcept>

namespace footfall {

class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace footfall

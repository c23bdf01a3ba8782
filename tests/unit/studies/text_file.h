#pragma once
// A file with a given text, gone with its object: what readers of sweeps and calibrations are given.

#include <string>

#include "mbd_solver/studies/sweep_file.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall::test {

struct TextFile : TemporaryFolder {
  explicit TextFile(const std::string& text) : path(write("file.toml", text)) {}
  const std::string path;
};

inline SweepSpec sweep_of(const std::string& text) { return read_sweep_file(TextFile(text).path); }

// What read_sweep_file says of a file with this text; empty when nothing is wrong.
inline std::string sweep_complaint(const std::string& text) {
  return refusal([&] { sweep_of(text); });
}

}  // namespace footfall::test

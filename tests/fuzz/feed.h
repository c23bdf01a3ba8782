#pragma once
// What every target does with its bytes: they go into a file of this process, and the reader may refuse them in its own
// words. Any other exception, or a crash, is a finding.

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "coupler/base/errors.h"

namespace footfall::fuzz {

// `read` gets the path of a file NAME that holds the bytes.
template <class Read>
int feed(const std::string& name, const std::uint8_t* data, std::size_t size, const Read& read) {
  static const std::string folder = [] {
    std::string pattern = (std::filesystem::temp_directory_path() / "footfall_fuzz_XXXXXX").string();
    if (!mkdtemp(pattern.data())) std::abort();
    static const std::string made = pattern;
    std::atexit([] { std::filesystem::remove_all(made); });
    return pattern;
  }();
  const std::string path = folder + "/" + name;
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    read(path);
  } catch (const InputError&) {
  } catch (const ProtocolError&) {
  } catch (const NumericalError&) {
  }
  return 0;
}

}  // namespace footfall::fuzz

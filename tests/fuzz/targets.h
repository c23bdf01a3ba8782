#pragma once
// Every reader of files and messages, as a function of bytes. The reader may refuse them by an error of coupler/base/errors.h; any other
// exception, and a crash, is a finding.

#include <string>
#include <vector>

namespace footfall::fuzz {

struct Target {
  const char* name;  // its folder in the corpora
  void (*read)(const std::string& bytes);
};

const std::vector<Target>& targets();

}  // namespace footfall::fuzz

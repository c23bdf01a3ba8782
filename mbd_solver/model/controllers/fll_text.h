#pragma once
// The lines of a .fll file (FuzzyLite Language) with their numbers, so that every complaint can name its
// line; FuzzyLite's own do not.

#include <filesystem>
#include <string>
#include <vector>

namespace footfall {

struct FllLine {
  int number;         // in the file, from 1
  std::string key;    // left of the colon
  std::string value;  // right of it, without comment
};

struct FllBlock {
  FllLine head;  // InputVariable: name, OutputVariable: name, RuleBlock: name or Engine: name
  std::vector<FllLine> lines;
};

// Throws InputError "file:line: ..." for a file that cannot be read, a line without colon, a line outside a
// block, a key the block does not know, or a variable or term given twice.
std::vector<FllBlock> read_fll_text(const std::filesystem::path& file);

}  // namespace footfall

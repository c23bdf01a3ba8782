#include "mbd_solver/model/controllers/fll_text.h"

#include <algorithm>
#include <fstream>
#include <map>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

const std::map<std::string, std::vector<std::string>> kKeys = {
    {"Engine", {"description"}},
    {"InputVariable", {"description", "enabled", "range", "lock-range", "term"}},
    {"OutputVariable",
     {"description", "enabled", "range", "lock-range", "aggregation", "defuzzifier", "default", "lock-previous",
      "term"}},
    {"RuleBlock", {"description", "enabled", "conjunction", "disjunction", "implication", "activation", "rule"}},
};

std::string first_word(const std::string& text) { return text.substr(0, text.find_first_of(" \t")); }

}  // namespace

std::vector<FllBlock> read_fll_text(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw InputError(file.string() + ": cannot be read. Expected a fuzzy controller (.fll); check the path.");
  std::vector<FllBlock> blocks;
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    const std::string where = file.string() + ":" + std::to_string(number) + ": ";
    const std::string line = trimmed(text.substr(0, text.find('#')));
    if (line.empty()) continue;
    const auto colon = line.find(':');
    if (colon == std::string::npos)
      throw InputError(where + "\"" + line + "\" has no colon; expected \"key: value\", for example \"range: 0 5\".");
    const FllLine entry{number, trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1))};
    if (kKeys.count(entry.key) > 0) {
      for (const FllBlock& other : blocks)
        if (entry.key.find("Variable") != std::string::npos && other.head.value == entry.value &&
            other.head.key != "Engine" && other.head.key != "RuleBlock")
          throw InputError(where + "variable \"" + entry.value + "\" is already defined in line " +
                           std::to_string(other.head.number) + ".");
      blocks.push_back({entry, {}});
      continue;
    }
    if (blocks.empty())
      throw InputError(where + "\"" + entry.key + "\" stands before any block; expected \"Engine: name\" first.");
    FllBlock& block = blocks.back();
    const std::vector<std::string>& known = kKeys.at(block.head.key);
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      throw InputError(where + "unknown key \"" + entry.key + "\" in " + block.head.key + " \"" + block.head.value +
                       "\". Known keys: " + joined(known) + ".");
    if (entry.key == "term")
      for (const FllLine& other : block.lines)
        if (other.key == "term" && first_word(other.value) == first_word(entry.value))
          throw InputError(where + "term \"" + first_word(entry.value) + "\" of \"" + block.head.value +
                           "\" is already defined in line " + std::to_string(other.number) + ".");
    block.lines.push_back(entry);
  }
  return blocks;
}

}  // namespace footfall

#include "liggghts_fix/beam_arguments.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "coupler/errors.h"

namespace footfall {
namespace {

const std::vector<std::string> kModelKeywords = {"model", "tangential", "cohesion", "rolling_friction",
                                                 "surface"};
const std::vector<std::string> kForeignKeywords = {"primitive", "mesh", "n_meshes", "meshes", "shear"};
const std::string kUsage =
    ". Expected: fix ID group wall/gran/beam model ... type T body NAME [chain C] [keywords of wall/gran]";

bool is_one_of(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

BeamArguments::BeamArguments(int narg, const char* const* arg) {
  const std::vector<std::string> words(arg, arg + narg);
  FOOTFALL_DEMAND(words.size() >= 3);
  fix = "fix " + words[0] + " " + words[2];

  std::size_t next = 3;
  while (next + 1 < words.size() && is_one_of(kModelKeywords, words[next])) next += 2;
  stock.assign(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(next));

  std::vector<std::string> others;
  std::string chain_word;
  while (next < words.size()) {
    const std::string& word = words[next++];
    std::string* const value = word == "type"    ? &type
                               : word == "body"  ? &body
                               : word == "chain" ? &chain_word
                                                 : nullptr;
    if (value == nullptr) {
      if (is_one_of(kForeignKeywords, word))
        throw InputError(fix + ": keyword \"" + word +
                         "\" belongs to fix wall/gran; the beam is that of the body" + kUsage);
      others.push_back(word);
      continue;
    }
    if (next == words.size()) throw InputError(fix + ": nothing follows keyword \"" + word + "\"" + kUsage);
    if (!value->empty())
      throw InputError(fix + ": keyword \"" + word + "\" stands twice; one beam per fix" + kUsage);
    *value = words[next++];
  }
  if (type.empty()) throw InputError(fix + ": the material is missing, keyword \"type\"" + kUsage);
  if (body.empty()) throw InputError(fix + ": the body is missing, keyword \"body\"" + kUsage);
  if (!chain_word.empty()) {
    char* end = nullptr;
    const long number = std::strtol(chain_word.c_str(), &end, 10);
    if (*end != '\0' || number < 0 || number > 1000000)
      throw InputError(fix + ": \"chain " + chain_word + "\" is not the number of a beam, 0, 1, 2 ...");
    chain = static_cast<int>(number);
  }
  for (const char* word : {"primitive", "type", type.c_str(), "zcylinder", "0", "0", "0"})
    stock.emplace_back(word);
  stock.insert(stock.end(), others.begin(), others.end());
}

int chosen_chain(const BeamArguments& arguments, const ModalBoundary& boundary) {
  std::set<int> chains;
  for (const BeamSegment& segment : boundary.segments()) chains.insert(segment.chain);
  if (chains.empty())
    throw InputError(
        arguments.fix + ": body \"" + boundary.name() +
        "\" has no beams that grains may touch. Give it some in the scene, or name another body");
  if (chains.size() == 1 && arguments.chain < 0) return *chains.begin();
  if (chains.count(arguments.chain) == 1) return arguments.chain;
  std::string known;
  for (const int chain : chains) known += (known.empty() ? "" : ", ") + std::to_string(chain);
  throw InputError(arguments.fix + ": body \"" + boundary.name() + "\" has " + std::to_string(chains.size()) +
                   (chains.size() == 1 ? " beam, number " : " beams, numbers ") + known +
                   "; say which one with \"chain C\", one fix for each");
}

}  // namespace footfall

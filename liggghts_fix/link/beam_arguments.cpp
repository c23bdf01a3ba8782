// Separates the words for beams from those for stock fix wall/gran.

#include "liggghts_fix/link/beam_arguments.h"

#include <algorithm>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "liggghts_fix/link/codes.h"

namespace footfall {
namespace {

const std::vector<std::string> kModelKeywords = {"model", "tangential", "cohesion", "rolling_friction", "surface"};
const std::vector<std::string> kWallGranKeywords = {"primitive", "mesh", "n_meshes", "meshes", "shear"};
const std::string kBeamUsage =
    ". Expected: fix ID group wall/gran/beam model ... type T body NAME [chain C] [body ...] [curvature yes] [keywords "
    "of wall/gran]";

constexpr int kHighestChain = 1000000;

bool is_one_of(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// The C of `chain C`.
int chain_number(const std::string& fix, const std::string& word) {
  const std::optional<int> number = whole_number(word, 0, kHighestChain);
  if (!number)
    throw InputError(code::kBeamSyntax, fix, ": \"chain ", word, "\" is not the number of a beam, 0, 1, 2 ...");
  return *number;
}

}  // namespace

BeamArguments::BeamArguments(int narg, const char* const* arg) {
  const std::vector<std::string> words(arg, arg + narg);
  FOOTFALL_DEMAND(words.size() >= 3);
  fix = "fix " + words[0] + " " + words[2];

  std::size_t next = 3;
  while (next + 1 < words.size() && is_one_of(kModelKeywords, words[next])) next += 2;
  stock.assign(words.begin(), words.begin() + next);

  std::vector<std::string> others;
  while (next < words.size()) {
    const std::string& word = words[next++];
    if (is_one_of(kWallGranKeywords, word))
      throw InputError(code::kBeamSyntax, fix, ": keyword \"", word,
                       "\" belongs to fix wall/gran; beams have the shapes of their bodies", kBeamUsage);
    if (word != "type" && word != "body" && word != "chain" && word != "curvature") {
      others.push_back(word);
      continue;
    }
    if (next == words.size())
      throw InputError(code::kBeamSyntax, fix, ": nothing follows keyword \"", word, "\"", kBeamUsage);
    const std::string& value = words[next++];
    if (word == "body") {
      beams.push_back({value});
    } else if (word == "type") {
      if (!type.empty())
        throw InputError(code::kBeamSyntax, fix,
                         ": keyword \"type\" appears twice; beams of another material need a fix of their own",
                         kBeamUsage);
      type = value;
    } else if (word == "curvature") {
      if (value != "yes" && value != "no")
        throw InputError(code::kBeamSyntax, fix, ": expected yes or no after curvature", kBeamUsage);
      curvature = value == "yes";
    } else {
      if (beams.empty() || beams.back().chain >= 0)
        throw InputError(code::kBeamSyntax, fix, ": \"chain ", value, "\" does not follow a body", kBeamUsage);
      beams.back().chain = chain_number(fix, value);
    }
  }
  if (type.empty()) throw InputError(code::kBeamSyntax, fix, ": the material is missing, keyword \"type\"", kBeamUsage);
  if (beams.empty()) throw InputError(code::kBeamSyntax, fix, ": the body is missing, keyword \"body\"", kBeamUsage);
  for (std::size_t i = 0; i < beams.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (beams[i].body == beams[j].body &&
          (beams[i].chain == beams[j].chain || beams[i].chain < 0 || beams[j].chain < 0))
        throw InputError(code::kBeamNamedTwice, fix, ": a beam of body \"", beams[i].body,
                         "\" is named twice; its contacts would count twice", kBeamUsage);
  for (const char* word : {"primitive", "type", type.c_str(), "zcylinder", "0", "0", "0"}) stock.emplace_back(word);
  stock.insert(stock.end(), others.begin(), others.end());
}

std::vector<int> chosen_chains(const std::string& fix, const BeamChoice& choice, const ModalBoundary& boundary) {
  std::set<int> chains;
  for (const BeamSegment& segment : boundary.segments()) chains.insert(segment.chain);
  if (chains.empty())
    throw InputError(code::kBodyWithoutBeams, fix, ": body \"", boundary.name(),
                     "\" has no beams for grains. Define some in the scene, or name another body");
  if (choice.chain < 0) return {chains.begin(), chains.end()};
  if (chains.count(choice.chain) == 1) return {choice.chain};
  std::string known;
  for (const int chain : chains) known += (known.empty() ? "" : ", ") + std::to_string(chain);
  throw InputError(code::kBeamUnknown, fix, ": body \"", boundary.name(), "\" has no beam ", choice.chain, ". It has ",
                   chains.size(), chains.size() == 1 ? " beam, number " : " beams, numbers ", known);
}

}  // namespace footfall

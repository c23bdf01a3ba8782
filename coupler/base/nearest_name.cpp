#include "coupler/base/nearest_name.h"

#include <algorithm>

namespace footfall {
namespace {

// Edits (insert, delete, replace, swap of neighbours) that turn a into b.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    // A word that only lacks or adds an ending ("leg" for "leg_1") is as near as one edit.
    const bool prefix =
        word.size() > 2 && (candidate.rfind(word, 0) == 0 || (candidate.size() > 2 && word.rfind(candidate, 0) == 0));
    const std::size_t distance = prefix ? 1 : edit_distance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string known_names(const std::string& what, const std::string& word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kShown = 24;
  std::string text;
  if (candidates.empty()) {
    text = " There are no known " + what + ".";
  } else {
    text = " Known " + what + ": ";
    for (std::size_t i = 0; i < std::min(kShown, candidates.size()); ++i) text += (i ? ", " : "") + candidates[i];
    text += candidates.size() > kShown ? ", ..." : ".";
  }
  const std::string guess = nearest_name(word, candidates);
  if (!guess.empty()) text += " Did you mean \"" + guess + "\"?";
  return text;
}

}  // namespace footfall

// Numbers go through std::to_chars; unknown names are compared by the Damerau-Levenshtein distance.

#include "coupler/base/text.h"
#include "coupler/base/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace footfall {
namespace {

// Edits (insert, delete, replace, swap of neighbours) that turn a into b. Row i of the table of distances, and the two before.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

void append_number(std::string& text, double value, int digits) {
  std::array<char, 64> written;
  const std::to_chars_result result =
      std::to_chars(written.data(), written.data() + written.size(), value, std::chars_format::general, digits);
  text.append(written.data(), result.ptr);
}

std::string number_text(double value, int digits) {
  std::string text;
  append_number(text, value, digits);
  return text;
}

std::string fixed_text(double value, int decimals) {
  std::array<char, 400> written;  // the largest double has 309 digits before the point
  const std::to_chars_result result =
      std::to_chars(written.data(), written.data() + written.size(), value, std::chars_format::fixed, decimals);
  return {written.data(), result.ptr};
}

std::string share_text(double share) {
  return (std::abs(share) < 0.995 ? number_text(100.0 * share, 2) : fixed_text(100.0 * share, 0)) + " %";
}

std::string joined(const std::vector<std::string>& texts, const std::string& between) {
  std::string all;
  for (const std::string& text : texts) all += (&text == &texts.front() ? "" : between) + text;
  return all;
}

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells;
  for (std::size_t from = 0; from < line.size();) {
    const std::size_t end = std::min(line.find(separator, from), line.size());
    cells.push_back(line.substr(from, end - from));
    from = end + 1;
  }
  return cells;
}

std::string visible(const std::string& text) {
  constexpr std::size_t kMost = 200;
  std::string shown;
  for (const char c : text) {
    if (shown.size() > kMost) return shown + "...";
    char escape[8];
    std::snprintf(escape, sizeof escape,
                  c == '\n'   ? "\\n"
                  : c == '\t' ? "\\t"
                              : "\\x%02x",
                  static_cast<unsigned char>(c));
    (c >= 0 && c < ' ') || c == 127 ? shown += escape : shown += c;
  }
  return shown;
}

bool is_plain_name(const std::string& text) {
  if (text.empty() || text.front() == '.' || text.size() > kLongestName) return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  });
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::optional<int> whole_number(const std::string& word, int least, int most) {
  char* rest = nullptr;
  const long number = std::strtol(word.c_str(), &rest, 10);
  if (word.empty() || *rest != '\0' || number < least || number > most) return std::nullopt;
  return static_cast<int>(number);
}

std::optional<double> positive_number(const std::string& word) {
  char* rest = nullptr;
  const double number = read_number(word.c_str(), &rest);
  if (word.empty() || *rest != '\0' || !(number > 0.0)) return std::nullopt;
  return number;
}

std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    // A word that only lacks or adds an ending ("leg" for "leg_1") is as near as one edit.
    const bool prefix =
        word.size() > 2 && (candidate.rfind(word, 0) == 0 || (candidate.size() > 2 && word.rfind(candidate, 0) == 0));
    const std::size_t longer = std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size());
    if (!prefix && longer >= best_distance) continue;  // each further letter is an edit
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
